//! What the sensors say, judged: heading, rate of turn, position, speeds (AP-9, FA7 to FA10).
//!
//! In: the picture and what is set. Out: heading, rate, place and speed that are believed, and what happened to them. Each
//! source is guarded by itself before one is chosen.

mod belief;
mod compass;
mod correction;
mod guard;
mod headings;
mod monitor;
mod mounted;
mod north;
mod over_ground;
mod position;
mod rate;
mod sighted;
mod source;
mod speed;
mod way;
mod wind;

use super::notices::Notice;
use super::steering::Measured;
use crate::alerts::Alert;
use crate::geo::{Plane, Point, Position};
use crate::limits::Quantity;
use crate::picture::{Fix, Heard, Picture, Source};
use crate::post::Seen;
use crate::settings::{Settings, SpeedSource};
use crate::station::Profile;
use crate::time::Stamp;
use crate::units::{Heading, RudderAngle, Speed};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use correction::Correction;
use headings::Headings;
use mounted::Heels;
use north::North;
use over_ground::OverGround;
use position::{PositionGuard, Said};
use serde::{Deserialize, Serialize};
pub(super) use sighted::Sighted;
use source::Preferred;
pub use source::Refused;
use speed::{Measure, SpeedGuard};
use wind::Winds;

/// What is believed of the ship, and how each of its sources is judged.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Sight {
    headings: Headings,
    /// Whether position, ground and water come from the preferred source.
    preferred: [Preferred; 3],
    positions: PositionGuard,
    correction: Correction,
    speeds: SpeedGuard,
    winds: Winds,
    heels: Heels,
}

impl Sight {
    /// The heading before anything is judged: the best that is heard.
    pub(super) fn heard(
        &self,
        picture: &Picture,
        now: Stamp,
        settings: &Settings,
    ) -> Option<Heading> {
        self.headings.heard(picture, now, settings)
    }

    /// Judges what is heard, once a step. `free`: nothing is steered, so the best source is taken at once.
    pub(super) fn look(&mut self, seen: Seen<'_>, settings: &Settings, free: bool) -> Vec<Sighted> {
        let mut sighted = Vec::with_capacity(12);
        self.headings.look(seen, settings, free, &mut sighted);
        self.look_at_positions(seen, settings, free, &mut sighted);
        self.watch_sources(seen, free, &mut sighted);
        self.look_at_speeds(seen, settings, free, &mut sighted);
        self.winds.look(seen, self.headings.heading, settings);
        sighted
    }

    /// The believed place (AP-9, AP-16, FA9).
    fn look_at_positions(
        &mut self,
        seen: Seen<'_>,
        settings: &Settings,
        free: bool,
        sighted: &mut Vec<Sighted>,
    ) {
        let (now, picture) = (seen.now, seen.picture);
        let over_ground = self.over_ground(seen).map(|ground| ground.velocity());
        self.positions.goes(over_ground, self.headings.rate);
        let usable = picture
            .fixes
            .iter()
            .filter(|heard| heard.usable(Quantity::Position, now).is_some());
        let said: Vec<_> = usable
            .filter_map(|heard| {
                Some(Said {
                    source: &heard.source,
                    rank: picture.rank(&heard.source),
                    position: self.at_conning_position(seen, settings, heard)?,
                    at: heard.at,
                })
            })
            .collect();
        let step = settings.position_jump;
        let judged = self.positions.judge(now, &said, step, free);
        sighted.extend(judged.moved.map(Sighted::PlaneMoved));
        let doubted: Vec<_> = self
            .positions
            .doubted()
            .map(|source| picture.source_name(source))
            .collect();
        let text = || {
            let doubted = doubted.join(", ");
            format!("The position of {doubted} is not used: check the receiver")
        };
        let jumped = (!doubted.is_empty()).then(text);
        let said = Notice::of(Alert::PositionJump, jumped);
        sighted.push(Sighted::Notice(said));
        let used = self.fix_in_use(seen);
        self.correction
            .look(used.map(|heard| (heard.value.corrected(), heard.at)));
        sighted.push(Sighted::Uncorrected(!self.correction.is_there()));
        if judged.jumped {
            sighted.push(Sighted::PositionJumped);
        }
    }

    /// FA10: the speed that is believed, and what is said where it is none or too low.
    fn look_at_speeds(
        &mut self,
        seen: Seen<'_>,
        settings: &Settings,
        free: bool,
        sighted: &mut Vec<Sighted>,
    ) {
        // AP-7: what is entered by hand is used, and nothing that is measured is missed.
        let automatic = settings.speed_source == SpeedSource::Automatic;
        let free = free || !automatic;
        let water = seen.water_speed().filter(|_| automatic);
        let ground = self.over_ground(seen).filter(|_| automatic);
        let ground = ground.map(|ground| ground.speed);
        let minimum = Speed::from_knots(settings.minimum_speed);
        self.speeds.look(seen.now, water, ground, minimum, free);
        let lost = self.speeds.measured().is_none() && !free;
        let low = (self.speeds.measured()).filter(|_| self.speeds.low() && !free);
        let low = low.map(|speed| {
            format!(
                "{:.1} kn, the minimum is {:.1}: the ship hardly answers her rudder, the gains are the cruise speed's",
                speed.knots(),
                minimum.knots()
            )
        });
        let said = [
            Notice::when(lost, Alert::SpeedLost),
            Notice::of(Alert::LowSpeed, low),
        ];
        sighted.extend(said.map(Sighted::Notice));
    }

    /// AP-9: a change of source that nobody ordered is said, until the better one is back.
    fn watch_sources(&mut self, seen: Seen<'_>, free: bool, sighted: &mut Vec<Sighted>) {
        let (now, picture) = (seen.now, seen.picture);
        let of =
            |heard: Option<&Source>| heard.map(|source| (source.clone(), picture.rank(source)));
        let position = self
            .fix_in_use(seen)
            .filter(|h| h.usable(Quantity::Position, now).is_some());
        let water = picture
            .water_speed(now)
            .filter(|h| h.usable(Quantity::WaterSpeed, now).is_some());
        let now_used = [
            of(position.map(|heard| &heard.source)),
            over_ground::source(seen, &self.positions),
            of(water.map(|heard| &heard.source)),
        ];
        for (index, used) in now_used.into_iter().enumerate() {
            self.preferred[index].watch(now, used, free);
        }
        let say = |index: usize, what: &str| {
            let (left, used) = self.preferred[index].fallen()?;
            let used = used.map_or("nothing".into(), |used| picture.source_name(used));
            Some(format!(
                "{what} from {used} instead of {}",
                picture.source_name(left)
            ))
        };
        let position = say(0, "Position");
        let doubted = match self.speeds.doubted() {
            Some(Measure::Water) => {
                Some("The log is not used: its speed is far off the speed over ground")
            }
            Some(Measure::Ground) => {
                Some("The speed over ground is not used: it is far off the log's")
            }
            None => None,
        };
        let speed = [
            say(1, "Speed over ground"),
            say(2, "Water speed"),
            doubted.map(String::from),
        ];
        let speed: Vec<String> = speed.into_iter().flatten().collect();
        let speed = (!speed.is_empty()).then(|| speed.join("; "));
        let said = [
            Notice::of(Alert::PositionSource, position),
            Notice::of(Alert::SpeedSource, speed),
        ];
        sighted.extend(said.map(Sighted::Notice));
    }

    /// AP-16: where the conning position is by an antenna of ours, which takes a heading; the chart system's positions are
    /// of it already.
    fn at_conning_position(
        &self,
        seen: Seen<'_>,
        settings: &Settings,
        heard: &Heard<Fix>,
    ) -> Option<Position> {
        let forward = settings.conning_forward_m - settings.antenna_forward_m;
        let starboard = settings.conning_starboard_m - settings.antenna_starboard_m;
        let ours = seen.picture.ports[heard.source.port].profile != Profile::Ecdis;
        if !ours || (forward, starboard) == (0.0, 0.0) {
            return Some(heard.value.position);
        }
        let bow = self.headings.heading?.deg();
        let there = Point::default()
            .towards(bow, forward)
            .towards(bow + 90.0, starboard);
        Some(Plane::at(heard.value.position).position(there))
    }

    /// What the receiver in use said last.
    fn fix_in_use<'a>(&self, seen: Seen<'a>) -> Option<&'a Heard<Fix>> {
        let used = self.positions.in_use()?;
        let fixes = &seen.picture.fixes;
        fixes.iter().find(|heard| heard.source == *used)
    }

    /// Heading that is believed: of the compass in use, or its prediction while that stands in; absent where none is.
    pub(super) const fn heading(&self) -> Option<Heading> {
        self.headings.heading
    }

    /// Whether a rate of turn is measured and believed.
    pub(super) const fn has_rate(&self) -> bool {
        self.headings.measured_rate.is_some()
    }

    /// Where the ship is: carried on from the last good fix, for at most 5 s.
    pub(super) fn place(&self, now: Stamp) -> Option<Point> {
        self.positions.dead_reckoning(now)
    }

    /// The same for as long as a lost turn needs it (TCS-8).
    pub(super) fn long_place(&self, now: Stamp) -> Option<Point> {
        self.positions.long_dead_reckoning(now)
    }

    /// The plane in which places are given.
    pub(super) fn plane(&self) -> Option<&Plane> {
        self.positions.plane()
    }

    /// Lays the plane anew where the ship is, once she is `metres` from where it touches; the plane before.
    pub(super) fn recentre(&mut self, metres: f64) -> Option<Plane> {
        self.positions.recentre(metres)
    }

    /// How she goes over ground: measured, else calculated from positions (AP-9).
    pub(super) fn over_ground(&self, seen: Seen<'_>) -> Option<OverGround> {
        OverGround::of(seen, &self.positions)
    }

    /// The source of that; a calculated one has C for its formatter.
    pub(super) fn over_ground_from(&self, seen: Seen<'_>) -> Option<Source> {
        over_ground::source(seen, &self.positions).map(|(source, _)| source)
    }

    /// Speed for the gains: entered by hand where that is chosen (AP-7), else measured, else the set cruise speed (FA10).
    pub(super) fn speed(&self, settings: &Settings) -> Speed {
        if settings.speed_source == SpeedSource::Manual {
            return Speed::from_knots(settings.manual_speed);
        }
        let cruise = Speed::from_knots(settings.cruise_speed);
        self.speeds.for_gains().unwrap_or(cruise)
    }

    /// The measured speed that is believed, however low.
    pub(super) const fn measured_speed(&self) -> Option<Speed> {
        self.speeds.measured()
    }

    /// Where the wind comes from, low-passed, in the north of the headings: the apparent one, else the true one; absent
    /// where it is not heard.
    pub(super) const fn wind(&self, apparent: bool) -> Option<Heading> {
        self.winds.direction(apparent)
    }

    /// Whether headings are of magnetic north: no variation is known (AP-10).
    pub(super) fn is_magnetic(&self) -> bool {
        self.headings.north == North::Magnetic
    }

    /// The variation that is heard, else the one that is set; degrees, east positive (AP-9).
    pub(super) fn variation(&self, seen: Seen<'_>, settings: &Settings) -> Option<f64> {
        headings::variation(seen.picture, seen.now, settings)
    }

    /// What the laws are told; absent without a heading. `rudder` is the one that acts.
    pub(super) fn measured(
        &self,
        seen: Seen<'_>,
        settings: &Settings,
        rudder: Option<RudderAngle>,
    ) -> Option<Measured> {
        // A course over ground is of true north: beside a magnetic heading it would tell of a drift that is none.
        let ground = self.over_ground(seen).filter(|_| !self.is_magnetic());
        Some(Measured {
            heading: self.headings.heading?,
            ground: ground.and_then(|ground| ground.course.map(|course| (course, ground.speed))),
            position: self.positions.fix(seen.now),
            ..self.motion(settings, rudder)
        })
    }

    /// What the laws are told where the rate of turn is all that is measured: turns of the heading count, not where it points (AP-21).
    pub(super) fn measured_by_rate(
        &self,
        settings: &Settings,
        rudder: Option<RudderAngle>,
    ) -> Option<Measured> {
        self.has_rate().then(|| self.motion(settings, rudder))
    }

    fn motion(&self, settings: &Settings, rudder: Option<RudderAngle>) -> Measured {
        Measured {
            heading: self.headings.carried(),
            rate: self.headings.rate,
            rudder,
            water_speed: Some(self.speed(settings)),
            ground: None,
            position: None,
        }
    }
}
