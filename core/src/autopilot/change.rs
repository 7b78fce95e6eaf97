//! A setting changed while the autopilot runs: what is then in force, or why it may not be.

use crate::command::Refusal;
use crate::settings::{Settings, Value};

/// The settings with one changed; the rudders themselves change in STANDBY only (AP-4). `steering`: orders are given.
pub(super) fn changed(
    settings: &Settings,
    key: &str,
    value: &Value,
    steering: bool,
) -> Result<Settings, Refusal> {
    let mut changed = settings.clone();
    changed.set(key, value).map_err(Refusal::because)?;
    if changed.rudders != settings.rudders && steering {
        let text = "rudders are changed in STANDBY only";
        return Err(Refusal::because(text));
    }
    Ok(changed)
}
