//! What modes and their transitions know of the ship, of what is heard and of what is set, at one time.

use super::gear::{Angles, Gear, Mount, Steered};
use super::sight::Sight;
use super::steering::{Measured, Steering, SteeringSettings};
use crate::geo::Point;
use crate::motor::MotorFault;
use crate::path::{Part, Path};
use crate::post::{Post, Seen};
use crate::settings::Settings;
use crate::time::Stamp;
use crate::units::{Heading, RudderAngle, Speed};

/// What a mode knows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Facts<'a> {
    /// The time.
    pub(super) now: Stamp,
    /// Actual heading; the last usable one where it is lost.
    pub(super) heading: Heading,
    /// Rudder order in force.
    pub(super) order: RudderAngle,
    /// Where the ship is, by dead reckoning as long as that is worth something.
    pub(super) place: Option<Point>,
    /// What was steered last.
    pub(super) steered: Option<&'a Steered>,
    /// What is set.
    pub(super) settings: &'a Settings,
}

impl Facts<'_> {
    /// Whether the ship is on that part of a path.
    pub(super) fn is_on(&self, path: &Path, part: Part) -> bool {
        self.place
            .is_some_and(|place| path.progress(place).part == part)
    }
}

/// All that the modes are chosen, kept and ended by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outlook<'a> {
    /// What a mode knows.
    pub(super) facts: Facts<'a>,
    /// What is heard.
    pub(super) seen: Seen<'a>,
    /// What is believed of it.
    pub(super) sight: &'a Sight,
    /// The ship's constants.
    pub(super) ship: &'a SteeringSettings,
    /// The steering gear.
    pub(super) gear: &'a Gear,
    /// The dead band of a small craft's law, degrees; absent where another one steers.
    pub(super) dead_band: Option<f64>,
    /// What keeps a motor from turning the rudder.
    pub(super) motor: Option<MotorFault>,
}

impl<'a> Outlook<'a> {
    /// As the parts have it at `now`.
    pub(super) fn at(
        now: Stamp,
        post: &'a Post,
        sight: &'a Sight,
        steering: &'a Steering,
        (gear, motor): (&'a Gear, Option<MotorFault>),
        settings: &'a Settings,
    ) -> Self {
        let seen = post.seen(now);
        let heard = || sight.heard(seen.picture, now, settings);
        let heading = sight.heading().or_else(heard);
        Self {
            facts: Facts {
                now,
                heading: heading.unwrap_or(Heading::from_deg(0.0)),
                order: gear.order(),
                place: sight.long_place(now),
                steered: gear.steered(),
                settings,
            },
            seen,
            sight,
            ship: steering.ship(),
            gear,
            dead_band: steering.dead_band(),
            motor,
        }
    }

    /// What the laws are told; absent without a heading, or where a rate of turn is enough, without that as well (AP-21).
    pub(super) fn measured(&self, rate_is_enough: bool) -> Option<Measured> {
        let facts = &self.facts;
        let rudder = self.gear.acting(self.rudders());
        let measured = (self.sight).measured(self.seen, facts.settings, rudder);
        let by_rate = || self.sight.measured_by_rate(facts.settings, rudder);
        measured.or_else(|| by_rate().filter(|_| rate_is_enough))
    }

    /// Rudder angles as fed back, of the gear as it is mounted (EMC-7).
    pub(super) fn rudders(&self) -> Angles {
        Mount::of(self.facts.settings).rudders(self.seen.rudders())
    }

    /// Measured speed, else the set cruise speed (FA10).
    pub(super) fn speed(&self) -> Speed {
        self.sight.speed(self.facts.settings)
    }
}
