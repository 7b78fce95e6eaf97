//! A setting changed while the autopilot runs: what is then in force, or why it may not be.

use crate::command::Refusal;
use crate::settings::{Settings, SpeedSource, Value};

/// What a change is judged by.
#[derive(Clone, Copy, Debug)]
pub(super) struct While {
    /// Orders are given.
    pub(super) steering: bool,
    /// The chart system commands, or AutoNAV is selected.
    pub(super) autonav: bool,
}

/// The settings with one changed; the rudders themselves change in STANDBY only (AP-4), and AutoNAV is steered by a measured
/// speed only (AP-7).
pub(super) fn changed(
    settings: &Settings,
    key: &str,
    value: &Value,
    now: While,
) -> Result<Settings, Refusal> {
    let mut changed = settings.clone();
    changed.set(key, value).map_err(Refusal::because)?;
    if changed.rudders != settings.rudders && now.steering {
        let text = "rudders are changed in STANDBY only";
        return Err(Refusal::because(text));
    }
    let source = changed.speed_source;
    if source == SpeedSource::Manual && source != settings.speed_source && now.autonav {
        let text = "no speed is entered by hand in AutoNAV: select another mode first";
        return Err(Refusal::because(text));
    }
    Ok(changed)
}
