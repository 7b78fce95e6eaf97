//! Course and speed over ground that are used: measured, else calculated from the positions of the receiver in use (AP-9).

use super::position::PositionGuard;
use crate::facts::Quantity;
use crate::geo::Point;
use crate::picture::Source;
use crate::post::Seen;
use crate::units::{Course, Speed};

/// The formatter in the name of a source whose speed is calculated, as the documents mark it.
const CALCULATED: &str = "C";
/// Its place in the order of preference: behind all that measure.
const RANK: u8 = 50;
/// Below this speed a calculated course says nothing, knots.
const STILL_KN: f64 = 0.5;

/// How the ship goes over ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) struct OverGround {
    /// Course, absent where the ship lies still.
    pub(in super::super) course: Option<Course>,
    /// Speed.
    pub(in super::super) speed: Speed,
    /// From positions, since nothing measures it: marked C.
    pub(in super::super) calculated: bool,
}

impl OverGround {
    /// What is measured, else what positions make of it; a measured one always goes before.
    pub(super) fn of(seen: Seen<'_>, positions: &PositionGuard) -> Option<Self> {
        if let Some(ground) = seen.ground() {
            return Some(Self {
                course: ground.course,
                speed: ground.speed,
                calculated: false,
            });
        }
        let (velocity, at) = positions.made_good(seen.now)?;
        // FA16: what was heard before a stall does not count.
        if seen.stalled_at().is_some_and(|after| at <= after) {
            return None;
        }
        let speed = Speed::from_mps(libm::hypot(velocity.north, velocity.east));
        let course = Course::from_rad(libm::atan2(velocity.east, velocity.north));
        Some(Self {
            course: (speed.knots() >= STILL_KN).then_some(course),
            speed,
            calculated: true,
        })
    }

    /// Metres a second north and east; a ship without a course lies still.
    pub(super) fn velocity(&self) -> Point {
        let course = self.course.map_or(0.0, Course::deg);
        Point::default().towards(course, self.speed.mps())
    }
}

/// Who says how the ship goes over ground, with its place in the order of preference; absent where nobody does.
pub(super) fn source(seen: Seen<'_>, positions: &PositionGuard) -> Option<(Source, u8)> {
    let heard = seen.picture.ground(seen.now);
    let heard = heard.filter(|heard| heard.usable(Quantity::Ground, seen.now).is_some());
    if let Some(heard) = heard {
        return Some((heard.source.clone(), seen.picture.rank(&heard.source)));
    }
    OverGround::of(seen, positions)?;
    let receiver = positions.in_use()?.clone();
    let formatter = CALCULATED.into();
    Some((
        Source {
            formatter,
            ..receiver
        },
        RANK,
    ))
}
