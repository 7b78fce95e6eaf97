//! Guards against a heading or a position that cannot be true (FA8, FA9).
//!
//! In: readings with their time. Out: the reading, or the prediction for as long as it may stand in.

use crate::geo::{Plane, Point, Position};
use crate::time::Stamp;
use crate::units::{Course, Heading, RateOfTurn, SignedAngle, Speed};
use serde::{Deserialize, Serialize};

/// A rejected heading is bridged by the rate of turn for so long (FA8).
const HEADING_BRIDGE_MS: u64 = 1_000;
/// A source that jumped is believed again after so long without a jump.
const HEADING_TRUST_MS: u64 = 10_000;
/// A position is bridged by dead reckoning for so long (AP-9).
const POSITION_BRIDGE_MS: u64 = 5_000;
/// So many rejected positions in a row mean a jump (FA9).
const POSITION_REJECTS: u8 = 3;
/// One rejected position this far off means a jump (FA9), metres.
const POSITION_JUMP_M: f64 = 185.2;

/// Verdict on a heading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum HeadingVerdict {
    /// Use it.
    Good(Heading),
    /// It jumped: the prediction stands in.
    Bridged(Heading),
    /// It jumped and did not come back: the source is invalid.
    Invalid,
}

/// Guards the heading in use.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct HeadingGuard {
    last: Option<(Heading, Stamp)>,
    rejecting: Option<Stamp>,
    /// The jumped source's own last reading and since when it has been steady.
    suspect: Option<(Heading, Stamp)>,
    invalid: bool,
}

impl HeadingGuard {
    /// Judges a reading; `step` is the largest change that is believed beyond the turn made, degrees.
    pub(crate) fn judge(
        &mut self,
        now: Stamp,
        read: Heading,
        rate: RateOfTurn,
        step: f64,
    ) -> HeadingVerdict {
        let Some((last, at)) = self.last else {
            self.last = Some((read, now));
            return HeadingVerdict::Good(read);
        };
        let dt = now.since(at) as f64 / 1000.0;
        let predicted = last + SignedAngle::from_deg(rate.deg_per_s() * dt);
        if self.invalid {
            return self.regain(now, read, step);
        }
        if (read - predicted).abs().deg() <= step + 0.5 * dt {
            self.last = Some((read, now));
            self.rejecting = None;
            return HeadingVerdict::Good(read);
        }
        let since = *self.rejecting.get_or_insert(now);
        if now.since(since) >= HEADING_BRIDGE_MS {
            self.invalid = true;
            self.suspect = Some((read, now));
            return HeadingVerdict::Invalid;
        }
        self.last = Some((predicted, now));
        HeadingVerdict::Bridged(predicted)
    }

    fn regain(&mut self, now: Stamp, read: Heading, step: f64) -> HeadingVerdict {
        match self.suspect {
            Some((before, since)) if (read - before).abs().deg() <= step => {
                if now.since(since) >= HEADING_TRUST_MS {
                    *self = Self {
                        last: Some((read, now)),
                        ..Self::default()
                    };
                    return HeadingVerdict::Good(read);
                }
                self.suspect = Some((read, since));
            }
            _ => self.suspect = Some((read, now)),
        }
        HeadingVerdict::Invalid
    }
}

/// Verdict on a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FixVerdict {
    /// Taken.
    Taken,
    /// Off the dead reckoning and not used.
    Rejected,
    /// Jumped: track control must end. The dead reckoning starts again at the new place.
    Jumped,
}

/// Keeps the dead reckoning and guards it against jumps.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct PositionGuard {
    plane: Option<Plane>,
    fix: Option<(Point, Stamp)>,
    rejects: u8,
    velocity: (f64, f64),
}

impl PositionGuard {
    /// The plane in which points are given.
    #[must_use]
    pub(crate) fn plane(&self) -> Option<&Plane> {
        self.plane.as_ref()
    }

    /// Lays a new plane at the ship once she is `metres` from where it touches.
    /// Gives the old plane, for points that must be carried over.
    pub(crate) fn recentre(&mut self, metres: f64) -> Option<Plane> {
        let (old, (fix, at)) = (self.plane?, self.fix?);
        if fix.distance(Point::default()) < metres {
            return None;
        }
        let position = old.position(fix);
        self.plane = Some(Plane::at(position));
        self.fix = Some((Point::default(), at));
        Some(old)
    }

    /// The last fix that was taken, unless it is too old.
    #[must_use]
    pub(crate) fn fix(&self, now: Stamp) -> Option<Point> {
        let (fix, at) = self.fix?;
        (now.since(at) <= POSITION_BRIDGE_MS).then_some(fix)
    }

    /// Takes course and speed over ground.
    pub(crate) fn ground(&mut self, course: Option<Course>, speed: Speed) {
        let angle = course.map_or(0.0, Course::rad);
        self.velocity = (
            speed.mps() * libm::cos(angle),
            speed.mps() * libm::sin(angle),
        );
    }

    /// Judges a new fix; `step` is the largest distance off the dead reckoning that is used, metres.
    pub(crate) fn judge(&mut self, at: Stamp, position: Position, step: f64) -> FixVerdict {
        let Some(plane) = self.plane else {
            self.start(at, position);
            return FixVerdict::Taken;
        };
        let point = plane.point(position);
        let Some(expected) = self.dead_reckoning(at) else {
            self.start(at, position);
            return FixVerdict::Taken;
        };
        let off = expected.distance(point);
        if off <= step {
            self.rejects = 0;
            self.fix = Some((point, at));
            return FixVerdict::Taken;
        }
        self.rejects += 1;
        if off > POSITION_JUMP_M || self.rejects >= POSITION_REJECTS {
            self.start(at, position);
            return FixVerdict::Jumped;
        }
        FixVerdict::Rejected
    }

    /// Where the ship is at `now`: the last fix carried on by the ground velocity, for at most 5 s.
    #[must_use]
    pub(crate) fn dead_reckoning(&self, now: Stamp) -> Option<Point> {
        let (fix, at) = self.fix?;
        let age = now.since(at);
        if age > POSITION_BRIDGE_MS {
            return None;
        }
        Some(self.carried(fix, age))
    }

    /// As `dead_reckoning`, for as long as a lost turn needs it (TCS-8).
    #[must_use]
    pub(crate) fn long_dead_reckoning(&self, now: Stamp) -> Option<Point> {
        let (fix, at) = self.fix?;
        Some(self.carried(fix, now.since(at)))
    }

    fn carried(&self, fix: Point, age: u64) -> Point {
        let seconds = age as f64 / 1000.0;
        Point {
            north: fix.north + self.velocity.0 * seconds,
            east: fix.east + self.velocity.1 * seconds,
        }
    }

    fn start(&mut self, at: Stamp, position: Position) {
        let plane = *self.plane.get_or_insert_with(|| Plane::at(position));
        self.fix = Some((plane.point(position), at));
        self.rejects = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // FA8
    #[test]
    fn a_jump_of_the_gyro_is_bridged_for_a_second_then_invalid_then_regained() {
        let mut guard = HeadingGuard::default();
        let still = RateOfTurn::from_deg_per_min(0.0);
        let mut seen = alloc::vec::Vec::new();
        for step in 0..130_u64 {
            let read = Heading::from_deg(if step < 5 { 100.0 } else { 120.0 });
            seen.push(guard.judge(Stamp(step * 100), read, still, 8.0));
        }
        assert_eq!(seen[5], HeadingVerdict::Bridged(Heading::from_deg(100.0)));
        assert_eq!(seen[14], HeadingVerdict::Bridged(Heading::from_deg(100.0)));
        assert_eq!(seen[15], HeadingVerdict::Invalid);
        assert_eq!(seen[114], HeadingVerdict::Invalid);
        assert_eq!(seen[115], HeadingVerdict::Good(Heading::from_deg(120.0)));
    }

    // FA9
    #[test]
    fn three_positions_off_in_a_row_or_one_far_off_are_a_jump() {
        let home = Position {
            lat: 54.0,
            lon: 6.0,
        };
        let plane = Plane::at(home);
        let at = |north: f64| plane.position(Point { north, east: 0.0 });
        let mut guard = PositionGuard::default();
        assert_eq!(guard.judge(Stamp(0), home, 40.0), FixVerdict::Taken);
        assert_eq!(
            guard.judge(Stamp(1000), at(60.0), 40.0),
            FixVerdict::Rejected
        );
        assert_eq!(
            guard.judge(Stamp(2000), at(60.0), 40.0),
            FixVerdict::Rejected
        );
        assert_eq!(guard.judge(Stamp(3000), at(60.0), 40.0), FixVerdict::Jumped);
        assert_eq!(
            guard.judge(Stamp(4000), at(300.0), 40.0),
            FixVerdict::Jumped
        );
    }
}
