//! FB12: a line that would be loaded by more than 80 % is refused, with the sum.

use super::types::{Place, Port};
use wheelover_core::settings::Settings;
use wheelover_core::station::Profile;
use wheelover_core::voyage::Role;

/// Part of the line rate that may be used.
const HIGHEST: f64 = 0.8;

/// A sentence, its longest form with CR LF in bytes, and how often it is sent.
type Sent = (&'static str, f64, f64);

/// What a station says on a port of a profile.
fn talk(station: Role, profile: Profile, step_hz: f64) -> Vec<Sent> {
    match (station, profile) {
        (Role::Autopilot, Profile::Ecdis) => vec![
            ("HTD", 82.0, 1.0),
            ("RSA", 27.0, 1.0),
            ("ROR", 29.0, 1.0),
            ("HDT", 21.0, 1.0),
        ],
        (Role::Autopilot, Profile::Gear) => vec![("ROR", 29.0, step_hz)],
        (Role::ChartSystem, Profile::Ecdis) => vec![
            ("HTC", 72.0, 1.0),
            ("XTE", 34.0, 1.0),
            ("PNEY,001", 37.0, 1.0),
            ("PNEY,002", 56.0, 1.0),
            ("GLL", 52.0, 1.0),
            ("VTG", 46.0, 1.0),
            ("VHW", 44.0, 1.0),
        ],
        (Role::World, Profile::Gyro1 | Profile::Gyro2 | Profile::Thd) => {
            vec![("HDT", 19.0, 10.0), ("ROT", 19.0, 10.0)]
        }
        (Role::World, Profile::Gps) => vec![("GLL", 52.0, 1.0), ("VTG", 46.0, 1.0)],
        (Role::World, Profile::Log) => vec![("VHW", 44.0, 1.0)],
        (Role::World, Profile::Gear) => vec![("RSA", 27.0, 10.0)],
        _ => Vec::new(),
    }
}

/// The complaint where a port's line is too slow for what is to be sent on it.
pub(super) fn complaint(port: &Port, settings: &Settings) -> Option<String> {
    let Place::Serial(_, baud) = port.place else {
        return None;
    };
    if !port.setup.output {
        return None;
    }
    let sent = talk(port.station, port.setup.profile, settings.step_hz);
    let sum: f64 = sent.iter().map(|(_, length, rate)| length * rate).sum();
    let line = f64::from(baud) / 10.0;
    if sum <= HIGHEST * line {
        return None;
    }
    let terms: Vec<String> = sent
        .iter()
        .map(|(name, length, rate)| format!("{name} {length} x {rate}"))
        .collect();
    Some(format!(
        "port \"{}\" would carry {} = {sum} bytes a second, {:.0} % of the {line} that {baud} baud carry; \
         at most 80 % are allowed: use a faster line or send less",
        port.setup.name,
        terms.join(" + "),
        100.0 * sum / line,
    ))
}
