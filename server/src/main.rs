//! The `wheelover` program: the library with the page embedded.

mod bundle;

use std::process::ExitCode;

fn main() -> ExitCode {
    wheelover::program::run(bundle::PAGE)
}
