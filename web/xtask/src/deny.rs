//! What the dependencies may be: `cargo deny` against `deny.toml` (FE16; there is no bill of materials yet).

use crate::tools::cargo_deny;
use std::process::Command;
use xtask::shell::{Failure, Outcome, root, run};

/// Set to `required`, this variable makes advisories that cannot be looked up a failure.
const ADVISORIES: &str = "WHEELOVER_ADVISORIES";

/// Checks licences and sources, and advisories where their database can be fetched; gives back what could not be checked.
///
/// # Errors
/// A dependency is not allowed, something is known against one, or `cargo deny` cannot be had.
pub(crate) fn dependencies() -> Result<Option<String>, Failure> {
    let program = cargo_deny()?;
    let deny = |arguments: &[&str]| -> Outcome {
        run(Command::new(&program)
            .arg("--workspace")
            .args(arguments)
            .current_dir(root()))
    };
    deny(&["check", "licenses", "sources"])?;
    let Err(failure) = deny(&["fetch", "db"]) else {
        deny(&["check", "--disable-fetch", "advisories"])?;
        return Ok(None);
    };
    if std::env::var(ADVISORIES).is_ok_and(|value| value == "required") {
        return Err(failure);
    }
    let not_run = format!(
        "NOT RUN: advisories and yanked versions of the dependencies; their database cannot be fetched \
         ({ADVISORIES}=required makes that a failure)"
    );
    eprintln!("{not_run}");
    Ok(Some(not_run))
}
