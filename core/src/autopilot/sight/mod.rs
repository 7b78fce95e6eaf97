//! What the sensors say, judged: heading, rate of turn, position, speeds (AP-9, FA7 to FA10).

mod belief;
mod compass;
mod guard;
mod position;
mod rate;
mod source;
mod speed;

use super::modes::{Cause, Event, Need};
use super::steering::Measured;
use super::{Autopilot, Mode};
use crate::alerts::Alert;
use crate::geo::{Plane, Point, Position};
use crate::limits::{Quantity, limits};
use crate::picture::{Fix, Heard, Source};
use crate::station::Profile;
use crate::time::Stamp;
use crate::units::Speed;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
pub use belief::Refused;
pub(super) use compass::Compasses;
use compass::{Doubt, Reading, Turning};
pub(super) use position::PositionGuard;
use position::Said;
pub(super) use rate::RateGuard;
pub(super) use source::Preferred;
use speed::Measure;
pub(super) use speed::SpeedGuard;

/// A rudder response that is off its order by more is no measure of the rudder that acts: the gear does not follow, or its
/// feedback lies, and `watch_rudder` says so (FA11).
const NOT_FOLLOWED_DEG: f64 = 10.0;
/// Below this speed a course over ground says nothing of the heading, knots.
const STEERING_KNOTS: f64 = 3.0;

impl Autopilot {
    /// A heard value that is fresh and was heard since the last stall.
    pub(super) fn fresh<T: Clone>(
        &self,
        heard: Option<&Heard<T>>,
        quantity: Quantity,
    ) -> Option<T> {
        self.post.fresh(heard, quantity, self.now)
    }

    /// Heading and rate of turn of this step (AP-9, FA7, FA8).
    pub(super) fn look(&mut self, now: Stamp) {
        let picture = &self.post.picture;
        let rate = self.fresh(picture.rate(now), Quantity::RateOfTurn);
        let ground = self.fresh(picture.ground(now), Quantity::Ground);
        let believed = !self.rate_guard.doubted();
        let turning = Turning {
            rate: rate.filter(|_| believed).unwrap_or(self.rate),
            measured: rate.is_some() && believed,
            course: ground
                .filter(|ground| ground.speed.knots() > STEERING_KNOTS)
                .and_then(|ground| ground.course),
            dt: self.step_ms() as f64 / 1000.0,
        };
        let readings: Vec<_> = picture
            .headings
            .iter()
            .filter_map(|heard| {
                Some(Reading {
                    source: &heard.source,
                    rank: picture.rank(&heard.source),
                    said: self.fresh(Some(heard), Quantity::Heading)?,
                    age: now.since(heard.at) as f64 / 1000.0,
                })
            })
            .collect();
        let heard = !readings.is_empty();
        let (before, source) = (self.heading, self.compasses.in_use().cloned());
        let free = !self.mode.row().gives_orders();
        let jump = self.settings.heading_jump;
        self.heading = self.compasses.look(now, &readings, turning, jump, free);
        let changed = source.is_some() && self.compasses.in_use() != source.as_ref();
        let change = before.zip(self.heading).filter(|_| !changed);
        self.rate = self
            .rate_guard
            .judge(now, rate, change, self.rate, turning.dt);
        self.say_what_the_rate_does(now);
        if let (true, Some(before), Some(after)) = (changed, before, self.heading) {
            // AP-9: another compass is no turn of the ship.
            self.steering.another_compass(after - before);
            self.gear.join();
        }
        self.say_what_compasses_do(now);
        if self.heading.is_none() && !self.recovers(now) && self.mode.row().needs(Need::Heading) {
            let why = if heard {
                "the heading jumped"
            } else {
                "no heading for 2 s"
            };
            self.alerts.raise(now, Alert::HeadingLost, "");
            self.apply(now, &Event::HeadingLost, &format!("{why}: rudder held"));
        }
        if self.heading.is_some() && !matches!(self.mode, Mode::RudderHold(_)) {
            self.alerts.rectify(now, Alert::HeadingLost);
        }
        let unknown = !self.steering.settings().known;
        self.alerts.set(now, Alert::ShipUnknown, unknown, "");
        self.read_position(now);
    }

    fn say_what_compasses_do(&mut self, now: Stamp) {
        let name = |source: &Source| self.post.picture.source_name(source);
        let list = |doubt: Doubt| {
            let doubted = self.compasses.doubted().filter(|(_, why)| *why == doubt);
            doubted
                .map(|(source, _)| name(source))
                .collect::<Vec<_>>()
                .join(", ")
        };
        let mut jumped = list(Doubt::Jumped);
        let (stuck, drifts) = (list(Doubt::Stuck), list(Doubt::Drifts));
        if jumped.is_empty() {
            jumped = drifts;
        }
        let fallen = self.compasses.fallen_from().map(name);
        let left = fallen.map(|left| {
            let used = self.compasses.in_use().map(name).unwrap_or_default();
            format!("Heading from {used} instead of {left}")
        });
        let text = |what: String| {
            let text = || format!("The heading of {what} is not used: check the compass");
            (!what.is_empty()).then(text)
        };
        self.alerts.tell(now, Alert::HeadingJump, text(jumped));
        self.alerts.tell(now, Alert::HeadingStuck, text(stuck));
        self.alerts.tell(now, Alert::HeadingSource, left);
    }

    /// FA16: after a stall the order is frozen, and a heading is lost only when none comes again.
    fn recovers(&self, now: Stamp) -> bool {
        let (_, lost) = limits(Quantity::Heading);
        self.post
            .stalled_at()
            .is_some_and(|after| now.since(after) <= lost)
    }

    pub(super) fn read_position(&mut self, now: Stamp) {
        if let Some(ground) = self.fresh(self.post.picture.ground(now), Quantity::Ground) {
            self.position_guard.ground(ground.course, ground.speed);
        }
        let picture = &self.post.picture;
        let usable = picture
            .fixes
            .iter()
            .filter(|heard| heard.usable(Quantity::Position, now).is_some());
        let said: Vec<_> = usable
            .filter_map(|heard| {
                Some(Said {
                    source: &heard.source,
                    rank: picture.rank(&heard.source),
                    position: self.at_conning_position(heard)?,
                    at: heard.at,
                })
            })
            .collect();
        let (step, free) = (self.settings.position_jump, !self.mode.row().gives_orders());
        let judged = self.position_guard.judge(now, &said, step, free);
        if let (Some(by), Some(offset)) = (judged.moved, &mut self.remote.offset) {
            // The chart system's places have not moved with the plane.
            offset.north += by.north;
            offset.east += by.east;
        }
        let doubted: Vec<_> = self
            .position_guard
            .doubted()
            .map(|source| picture.source_name(source))
            .collect();
        let text = || {
            let doubted = doubted.join(", ");
            format!("The position of {doubted} is not used: check the receiver")
        };
        let jumped = (!doubted.is_empty()).then(text);
        self.alerts.tell(now, Alert::PositionJump, jumped);
        let used = self.fix_in_use().map(|heard| heard.value.corrected());
        let plain = self.mode.is_autonav() && used == Some(false);
        self.alerts.set(now, Alert::NoDifferential, plain, "");
        if judged.jumped && matches!(self.mode, Mode::AutonavTi(_)) {
            self.track_fail(now, Cause::PositionJump, "the position jumped");
        }
        self.recentre();
        self.watch_sources(now);
        self.look_at_speeds(now);
    }

    /// FA10: the speed that is believed, and what is said where it is none or too low.
    fn look_at_speeds(&mut self, now: Stamp) {
        let picture = &self.post.picture;
        let water = self.fresh(picture.water_speed(now), Quantity::WaterSpeed);
        let ground = self.fresh(picture.ground(now), Quantity::Ground);
        let minimum = Speed::from_knots(self.settings.minimum_speed);
        let free = !self.mode.row().gives_orders();
        let ground = ground.map(|ground| ground.speed);
        self.speed_guard.look(now, water, ground, minimum, free);
        let lost = self.speed_guard.measured().is_none() && !free;
        self.alerts.set(now, Alert::SpeedLost, lost, "");
        let low = (self.speed_guard.measured()).filter(|_| self.speed_guard.low() && !free);
        let low = low.map(|speed| {
            format!(
                "{:.1} kn, the minimum is {:.1}: the ship hardly answers her rudder, the gains are the cruise speed's",
                speed.knots(),
                minimum.knots()
            )
        });
        self.alerts.tell(now, Alert::LowSpeed, low);
    }

    /// AP-9: a rate of turn that is calculated, though a sensor says one, is said.
    fn say_what_the_rate_does(&mut self, now: Stamp) {
        let picture = &self.post.picture;
        let text = || {
            let rate = picture.rate(now);
            let name = rate.map(|rate| picture.source_name(&rate.source));
            format!(
                "Rate of turn of {} is not used: the heading goes another way. It is calculated",
                name.unwrap_or_default()
            )
        };
        let doubted = self.rate_guard.doubted().then(text);
        self.alerts.tell(now, Alert::RateOfTurn, doubted);
    }

    /// AP-9: a change of source that nobody ordered is said, until the better one is back.
    fn watch_sources(&mut self, now: Stamp) {
        let picture = &self.post.picture;
        let of =
            |heard: Option<&Source>| heard.map(|source| (source.clone(), picture.rank(source)));
        let position = self
            .fix_in_use()
            .filter(|h| h.usable(Quantity::Position, now).is_some());
        let ground = picture
            .ground(now)
            .filter(|h| h.usable(Quantity::Ground, now).is_some());
        let water = picture
            .water_speed(now)
            .filter(|h| h.usable(Quantity::WaterSpeed, now).is_some());
        let now_used = [
            of(position.map(|heard| &heard.source)),
            of(ground.map(|heard| &heard.source)),
            of(water.map(|heard| &heard.source)),
        ];
        let free = !self.mode.row().gives_orders();
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
        let doubted = match self.speed_guard.doubted() {
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
        self.alerts.tell(now, Alert::PositionSource, position);
        self.alerts.tell(now, Alert::SpeedSource, speed);
    }

    /// AP-16: where the conning position is by an antenna of ours, which takes a heading; the chart system's positions are
    /// of it already.
    fn at_conning_position(&self, heard: &Heard<Fix>) -> Option<Position> {
        let settings = &self.settings;
        let forward = settings.conning_forward_m - settings.antenna_forward_m;
        let starboard = settings.conning_starboard_m - settings.antenna_starboard_m;
        let ours = self.post.ports()[heard.source.port].profile != Profile::Ecdis;
        if !ours || (forward, starboard) == (0.0, 0.0) {
            return Some(heard.value.position);
        }
        let bow = self.heading?.deg();
        let there = Point::default()
            .towards(bow, forward)
            .towards(bow + 90.0, starboard);
        Some(Plane::at(heard.value.position).position(there))
    }

    /// What the receiver in use said last.
    pub(super) fn fix_in_use(&self) -> Option<&Heard<Fix>> {
        let used = self.position_guard.in_use()?;
        let fixes = &self.post.picture.fixes;
        fixes.iter().find(|heard| heard.source == *used)
    }

    pub(super) fn measured(&self, now: Stamp) -> Option<Measured> {
        let ground = self.fresh(self.post.picture.ground(now), Quantity::Ground);
        Some(Measured {
            heading: self.heading?,
            rate: self.rate,
            rudder: self
                .fresh(self.post.picture.rudder.as_ref(), Quantity::Rudder)
                .filter(|response| {
                    libm::fabs(response.deg() - self.gear.order().deg()) <= NOT_FOLLOWED_DEG
                }),
            water_speed: Some(self.speed()),
            ground: ground.and_then(|ground| ground.course.map(|course| (course, ground.speed))),
            position: self.position_guard.fix(now),
        })
    }
}
