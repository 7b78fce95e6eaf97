//! Which port may say what, and which source is preferred: one table for the stations (FE11, AP-9).

use crate::station::{Profile, Role};

/// What a station believes on a port of a profile, by formatter; a maker's sentences by their address.
#[must_use]
pub const fn believed(station: Role, profile: Profile) -> &'static [&'static str] {
    match (station, profile) {
        (Role::World, Profile::Gear) => &["ROR"],
        (Role::World, _) => &[],
        // The cable between chart system and autopilot, from either end. A chart system that echoes our heading or our
        // rudder is no compass and no feedback.
        (Role::Autopilot, Profile::Ecdis) => &[
            "HTC", "XTE", "PNEY", "HSC", "APB", "BWC", "BWR", "GLL", "GGA", "VTG", "VHW", "VBW",
            "RMC", "ZDA", "ACK", "ACN", "HBT",
        ],
        (Role::ChartSystem, Profile::Ecdis) => &[
            "HTD", "RSA", "ROR", "HDT", "HMR", "ALR", "ALA", "ALF", "ALC", "HBT",
        ],
        // A route that is offered; it is loaded by an officer's order only.
        (Role::ChartSystem, Profile::Plotter) => &["RTE", "WPL"],
        (_, Profile::Gyro1 | Profile::Gyro2 | Profile::Thd) => &["HDT", "THS", "ROT"],
        (_, Profile::Magn) => &["HDG", "HDM"],
        (_, Profile::Gps | Profile::Gps2) => &["GGA", "GLL", "RMC", "VTG", "ZDA", "GNS"],
        (_, Profile::Log) => &["VHW", "VBW"],
        (_, Profile::Rot) => &["ROT"],
        (Role::Autopilot, Profile::Gear) => &["RSA"],
        (Role::Autopilot, Profile::Stand) => &["HTD"],
        (Role::Autopilot, Profile::Plotter) => &[
            "APB", "RMB", "XTE", "BWC", "BWR", "BOD", "RMC", "GLL", "VTG", "WPL", "RTE", "HSC",
            "MWV", // EMC-5: of a plotter only where it is set to be the compass
            "HDM", "XDR", "HRM",
        ],
        (_, Profile::Wind) => &["MWV", "MWD", "VWR", "VWT"],
        (_, Profile::Imu) => &["HDM", "HDG", "HDT", "ROT", "XDR", "HRM"],
        (Role::Autopilot, Profile::Hmi) => &["PEMC"],
        (_, Profile::Bams) => &["ACN", "HBT"],
        (_, Profile::Gear | Profile::Stand | Profile::Hmi | Profile::Monitor) => &[],
    }
}

/// Whether a station believes a sentence on a port of a profile.
#[must_use]
pub fn believes(station: Role, profile: Profile, formatter: &str) -> bool {
    // A page knows only some of a maker's sentences by their sub-address; the address says enough.
    let address = formatter.split(',').next().unwrap_or(formatter);
    believed(station, profile).contains(&address)
}

/// Whether a port of that profile speaks all the time, so that its silence is a fault (FB10); the others say something when
/// there is something to say.
pub(crate) const fn speaks_always(profile: Profile) -> bool {
    !matches!(
        profile,
        Profile::Plotter | Profile::Hmi | Profile::Bams | Profile::Monitor
    )
}

/// Whether what a port may say stands in the picture. A plotter's XTE belongs to its APB: it is no measure of the leg that
/// a chart system commands, and never takes its place. HTD of a stand is not what the autopilot reports.
pub(crate) fn is_pictured(profile: Profile, formatter: &str) -> bool {
    !matches!(
        (profile, formatter),
        (Profile::Plotter, "XTE") | (Profile::Stand, "HTD")
    )
}

/// Order of preference among sources, the best first (AP-9).
pub(crate) const fn rank(profile: Profile) -> u8 {
    match profile {
        Profile::Gyro1 => 0,
        Profile::Gyro2 => 1,
        Profile::Thd => 2,
        Profile::Rot => 3,
        Profile::Gps | Profile::Log | Profile::Gear | Profile::Wind => 4,
        Profile::Gps2 | Profile::Imu => 5,
        Profile::Magn => 6,
        Profile::Ecdis => 7,
        Profile::Plotter => 8,
        Profile::Stand | Profile::Hmi | Profile::Bams | Profile::Monitor => 9,
    }
}
