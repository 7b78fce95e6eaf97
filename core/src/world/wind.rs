//! The wind as a sensor on the moving ship measures it: the wind over ground, apparent or over the water.

use super::hull::{Drive, Hull};
use super::sentences;
use crate::units::{Course, Speed};
use alloc::string::String;

/// MWV; absent without wind.
pub(super) fn line(
    (from, speed): (Course, Speed),
    hull: &Hull,
    drive: &Drive,
    apparent: bool,
    talker: &str,
) -> Option<String> {
    let speed = speed.mps();
    if speed <= 0.0 {
        return None;
    }
    let (north, east) = if apparent {
        hull.ground_velocity(drive)
    } else {
        (drive.current_north, drive.current_east)
    };
    // Towards where it comes from: against the wind, and with what moves.
    let north = speed * libm::cos(from.rad()) + north;
    let east = speed * libm::sin(from.rad()) + east;
    let angle = (libm::atan2(east, north) - hull.heading).to_degrees();
    let speed = libm::hypot(north, east);
    Some(sentences::wind(angle, apparent, speed, talker))
}
