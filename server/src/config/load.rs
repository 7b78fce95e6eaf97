//! FB12: a line that would be loaded by more than it may carry is refused, with the sum.

use super::types::{Place, Port};
use wheelover_core::settings::Settings;
use wheelover_core::talk;

/// The complaint where a port's line is too slow for what is to be sent on it.
pub(super) fn complaint(port: &Port, settings: &Settings) -> Option<String> {
    let Place::Serial(_, baud) = port.place else {
        return None;
    };
    if !port.setup.output {
        return None;
    }
    let load = talk::load(port.station, port.setup.profile, settings.step_hz, baud);
    let text = format!(
        "port \"{}\" would carry {load}: use a faster line or send less",
        port.setup.name
    );
    load.is_too_much().then_some(text)
}
