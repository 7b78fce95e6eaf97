//! What the chart system says each second (interface section 4).

use super::control::Commanding;
use super::state::ChartSystem;
use crate::nmea::{
    CommandStatus, DataStatus, Gll, Htc, ModeIndicator, OverrideStatus, Pney1, Pney2, Reference,
    SteeringMode, TurnMode, Vhw, Vtg, Xte,
};
use crate::route::{Phase, Turn};
use crate::station::{Profile, Role};
use crate::talk::{self, Saying};
use crate::time::Stamp;
use crate::units::{Course, Distance};
use alloc::string::String;

/// Kilometres an hour in a knot.
const KMH_PER_KNOT: f64 = 1.852;
/// Look-ahead of the course to steer in "Tn", seconds, and the largest cut, degrees.
const LOOK_AHEAD_S: f64 = 60.0;
const LARGEST_CUT_DEG: f64 = 30.0;

impl ChartSystem {
    /// What is said at `now` on a port, in the order of the table; absent what is not a chart system's to say.
    pub(super) fn sentences(&self, now: Stamp, profile: Profile) -> impl Iterator<Item = String> {
        talk::told(Role::ChartSystem, profile)
            .iter()
            .filter_map(move |row| {
                let talker = row.talker?;
                Some(match row.saying {
                    Saying::Htc => self.htc(now).line(talker),
                    Saying::Xte => self.xte(now).line(talker),
                    Saying::Pney1 => self.pney1(now).line(talker),
                    Saying::Pney2 => self.pney2().line(talker),
                    Saying::Gll => self.gll(now).line(talker),
                    Saying::Vtg => self.vtg(now).line(talker),
                    Saying::Vhw => self.vhw(now).line(talker),
                    _ => return None,
                })
            })
    }

    fn phase(&self) -> Option<Phase> {
        self.progress.map(|progress| progress.phase())
    }

    /// The turn that is sailed or comes next.
    fn turn(&self) -> Option<&Turn> {
        self.progress?.turn(self.route.as_ref()?)
    }

    /// The turn that the autopilot is to sail now in "Ti" (situations 3 and 4).
    fn commanded_turn(&self) -> Option<&Turn> {
        let tracked = matches!(self.control, Commanding::Track { .. });
        (tracked && self.phase()?.turning()).then(|| self.turn())?
    }

    fn htc(&self, now: Stamp) -> Htc {
        let base = Htc {
            override_status: Some(OverrideStatus::NotInUse),
            reference: Some(Reference::True),
            status: Some(CommandStatus::Command),
            ..Htc::default()
        };
        match self.control {
            Commanding::Off => Htc {
                steering_mode: Some(SteeringMode::StandAlone),
                turn_mode: Some(TurnMode::NotControlled),
                ..base
            },
            Commanding::Track { .. } => {
                let turn = self.commanded_turn();
                let track = turn.map_or_else(|| self.leg_course(), |turn| Some(turn.course_out()));
                Htc {
                    steering_mode: Some(SteeringMode::TrackControl),
                    turn_mode: Some(TurnMode::Radius), // R all the time in "Ti"
                    radius: turn.map(|turn| turn.radius().nm()),
                    track: track.map(Course::deg),
                    ..base
                }
            }
            Commanding::Heading { leg } => self.heading_control(now, leg, base),
        }
    }

    /// TCS-12: H with N on a leg, H with T, rate of turn and HTS = track in a turn.
    fn heading_control(&self, now: Stamp, virtual_leg: Option<Course>, base: Htc) -> Htc {
        let base = Htc {
            steering_mode: Some(SteeringMode::HeadingControl),
            ..base
        };
        if let Some((turn, ground)) = self.turn_in_tn(now).zip(self.ground_at(now)) {
            let track = Some(turn.course_out().deg());
            return Htc {
                turn_mode: Some(TurnMode::Rate),
                rate_of_turn: Some((ground.speed / turn.radius()).deg_per_min()),
                heading_to_steer: track,
                track,
                ..base
            };
        }
        let track = virtual_leg.or_else(|| self.leg_course());
        Htc {
            turn_mode: Some(TurnMode::NotControlled),
            heading_to_steer: track.map(|track| match virtual_leg {
                Some(_) => track.deg(),
                None => self.heading_on_leg(now, track).deg(),
            }),
            track: track.map(Course::deg),
            ..base
        }
    }

    /// The turn that has begun in "Tn": its line lies a little nearer to the arc than the one of "Ti"; the time
    /// is the one that keeps the simulated ship nearest to her arcs (`core/tests/dialogue.rs`).
    fn turn_in_tn(&self, now: Stamp) -> Option<&Turn> {
        let (route, turn) = (self.route.as_ref()?, self.turn()?);
        match self.phase()? {
            Phase::Arc(_) => Some(turn),
            Phase::Forwarding(leg) => {
                let speed = self.ground_at(now)?.speed.mps();
                let remaining = route.leg(leg).remaining(self.here(now)?.position);
                let line = turn.before(Distance::from_m(self.config.forwarding_tn_s * speed));
                (remaining <= line).then_some(turn)
            }
            Phase::Leg(_) | Phase::Past => None,
        }
    }

    /// Course of the leg that is sailed.
    fn leg_course(&self) -> Option<Course> {
        let leg = self.progress?.leg()?;
        Some(self.route.as_ref()?.leg(leg).course())
    }

    /// `track - atan(y / look-ahead) + crab`: brings the ship to the leg and keeps her there in a current.
    fn heading_on_leg(&self, now: Stamp, track: Course) -> Course {
        let off = self.shown.control.unwrap_or_default().m();
        let speed = self.ground_at(now).map_or(0.0, |ground| ground.speed.mps());
        let ahead = (LOOK_AHEAD_S * speed).max(100.0);
        let cut = libm::atan(off / ahead) * 180.0 / core::f64::consts::PI;
        let water = self.water_at(now).unwrap_or_default();
        let crab = self.current.crab_deg(track, water);
        Course::from_deg(track.deg() - cut.clamp(-LARGEST_CUT_DEG, LARGEST_CUT_DEG) + crab)
    }

    /// TCS-3: an invalid position changes status and mode, the last distances stay. TCS-14: what is reckoned is valid and
    /// estimated.
    fn integrity(&self, now: Stamp) -> (DataStatus, ModeIndicator) {
        let mode = self
            .here(now)
            .map_or(ModeIndicator::NotValid, |here| here.mode);
        let status = if mode.valid() || mode == ModeIndicator::Estimated && self.reckoning.is_some()
        {
            DataStatus::Valid
        } else {
            DataStatus::Invalid
        };
        (status, mode)
    }

    fn xte(&self, now: Stamp) -> Xte {
        let (status, mode) = self.integrity(now);
        Xte {
            status: Some(status),
            cycle_lock: Some(DataStatus::Valid),
            cross_track: self.shown.display.map(Distance::nm),
            mode: Some(mode),
        }
    }

    fn pney1(&self, now: Stamp) -> Pney1 {
        let (status, mode) = self.integrity(now);
        Pney1 {
            status: Some(status),
            cycle_lock: Some(DataStatus::Valid),
            cross_track: self.shown.control.map(Distance::nm),
            mode: Some(mode),
        }
    }

    fn pney2(&self) -> Pney2 {
        let waypoint = || {
            let leg = self.progress?.leg()?;
            Some(self.route.as_ref()?.waypoints().get(leg + 1)?.id.clone())
        };
        Pney2 {
            centre: self.commanded_turn().map(Turn::centre),
            waypoint: waypoint(),
        }
    }

    fn gll(&self, now: Stamp) -> Gll {
        let Some(here) = self.here(now) else {
            return Gll {
                status: Some(DataStatus::Invalid),
                mode: Some(ModeIndicator::NotValid),
                ..Gll::default()
            };
        };
        Gll {
            position: Some(here.position),
            time: here.utc,
            status: Some(DataStatus::Valid),
            mode: Some(here.mode),
        }
    }

    fn vtg(&self, now: Stamp) -> Vtg {
        // TCS-3: without a position VTG is not valid either.
        let ground = self.ground_at(now).filter(|_| self.here(now).is_some());
        let Some(ground) = ground else {
            return Vtg {
                mode: Some(ModeIndicator::NotValid),
                ..Vtg::default()
            };
        };
        Vtg {
            course_true: Some(ground.course.deg()),
            speed_knots: Some(ground.speed.knots()),
            speed_kmh: Some(ground.speed.knots() * KMH_PER_KNOT),
            mode: Some(ground.mode),
            ..Vtg::default()
        }
    }

    fn vhw(&self, now: Stamp) -> Vhw {
        let water = self.water_at(now);
        Vhw {
            heading_true: self.heading_at(now).map(|heading| heading.deg()),
            speed_knots: water.map(|speed| speed.knots()),
            speed_kmh: water.map(|speed| speed.knots() * KMH_PER_KNOT),
            ..Vhw::default()
        }
    }
}
