//! What the chart system has heard, each value with its time and its age limit (AP-9).

use crate::geo::{Plane, Point, Position};
use crate::limits::{Quantity, limits};
use crate::nmea::{
    DataStatus, Gll, Hdt, Htd, ModeIndicator, Sentence, SteeringMode, Ths, ThsMode, UtcTime, Vhw,
    Vtg,
};
use crate::station::Profile;
use crate::time::Stamp;
use crate::units::{Course, Heading, Speed};
use serde::{Deserialize, Serialize};

/// A fix that differs from dead reckoning by more than this is not used at once, metres (FA9).
const JUMP_M: f64 = 50.0;
/// So many fixes in a row off dead reckoning are a new position.
const JUMPS: u8 = 3;

/// A position as it was received.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Fix {
    position: Position,
    /// Seconds after midnight, UTC.
    utc: Option<f64>,
    mode: ModeIndicator,
}

/// A position for the moment of sending.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Here {
    pub(super) position: Position,
    pub(super) utc: Option<UtcTime>,
    pub(super) mode: ModeIndicator,
}

/// Course and speed over ground.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Ground {
    pub(super) course: Course,
    pub(super) speed: Speed,
    pub(super) mode: ModeIndicator,
}

/// A value and when it was heard; absent once its source says that it is not valid.
type Timed<T> = Option<(T, Stamp)>;

/// Everything heard.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Heard {
    fix: Timed<Fix>,
    off: u8,
    jumped: bool,
    ground: Timed<Ground>,
    heading: Timed<Heading>,
    /// The heading that the autopilot forwards, where no compass is connected.
    forwarded: Timed<Heading>,
    water: Timed<Speed>,
    steering: Timed<Option<SteeringMode>>,
}

fn fresh<T: Copy>(value: Timed<T>, quantity: Quantity, now: Stamp) -> Option<T> {
    value
        .filter(|(_, at)| now.since(*at) <= limits(quantity).1)
        .map(|(value, _)| value)
}

impl Heard {
    /// Takes an accepted sentence of a port of that profile.
    pub(super) fn take(&mut self, now: Stamp, profile: Profile, sentence: &Sentence<'_>) {
        match profile {
            Profile::Gps => {
                self.position(now, sentence);
                self.ground(now, sentence);
            }
            Profile::Gyro1 | Profile::Gyro2 | Profile::Thd => {
                if let Some(heading) = heading(sentence) {
                    self.heading = heading.map(|heading| (heading, now));
                }
            }
            Profile::Log => {
                if let Some(vhw) = Vhw::from_sentence(sentence) {
                    self.water = vhw.speed_knots.map(|knots| (Speed::from_knots(knots), now));
                }
            }
            Profile::Ecdis => {
                if let Some(htd) = Htd::from_sentence(sentence) {
                    self.steering = Some((htd.steering_mode, now));
                }
                if let Some(heading) = heading(sentence) {
                    self.forwarded = heading.map(|heading| (heading, now));
                }
            }
            _ => {}
        }
    }

    fn position(&mut self, now: Stamp, sentence: &Sentence<'_>) {
        let Some(gll) = Gll::from_sentence(sentence) else {
            return;
        };
        let mode = gll.mode.unwrap_or(ModeIndicator::Autonomous);
        if gll.status == Some(DataStatus::Invalid) || !mode.valid() {
            self.fix = None; // TCS-3: not valid is known at once
            return;
        }
        let (Some(position), Some(DataStatus::Valid)) = (gll.position, gll.status) else {
            return;
        };
        if let Some((expected, age)) = self.reckoned(now)
            && age <= limits(Quantity::Position).1
            && distance(expected, position) > JUMP_M
        {
            self.off += 1;
            if self.off < JUMPS {
                return; // FA9: not used
            }
            self.jumped = true;
        }
        self.off = 0;
        let utc = gll.time.map(UtcTime::seconds);
        self.fix = Some((
            Fix {
                position,
                utc,
                mode,
            },
            now,
        ));
    }

    fn ground(&mut self, now: Stamp, sentence: &Sentence<'_>) {
        let Some(vtg) = Vtg::from_sentence(sentence) else {
            return;
        };
        let mode = vtg.mode.unwrap_or(ModeIndicator::Autonomous);
        self.ground = match (vtg.course_true, vtg.speed_knots) {
            (course, Some(knots)) if mode.valid() && (course.is_some() || knots < 0.5) => {
                let course = Course::from_deg(course.unwrap_or(0.0));
                Some((
                    Ground {
                        course,
                        speed: Speed::from_knots(knots),
                        mode,
                    },
                    now,
                ))
            }
            _ => None,
        };
    }

    /// The antenna's place by dead reckoning from the last fix, and the age of that fix.
    fn reckoned(&self, now: Stamp) -> Option<(Position, u64)> {
        let (fix, at) = self.fix?;
        let age = now.since(at);
        let Some(ground) = self.ground_at(now) else {
            return Some((fix.position, age));
        };
        let run = ground.speed.mps() * age as f64 / 1000.0;
        let plane = Plane::at(fix.position);
        Some((
            plane.position(Point::default().towards(ground.course.deg(), run)),
            age,
        ))
    }

    /// The conning position at the moment of sending; none once the last fix is older than 5 s.
    pub(super) fn here(&self, now: Stamp, offset_m: [f64; 2]) -> Option<Here> {
        let (antenna, age) = self.reckoned(now)?;
        // Without course and speed over ground a fix can only be held, and not for long.
        let limit = if self.ground_at(now).is_some() {
            limits(Quantity::Position).1
        } else {
            2_000
        };
        if age > limit {
            return None;
        }
        let (fix, _) = self.fix?;
        let position = match self.heading_at(now) {
            Some(heading) if offset_m != [0.0, 0.0] => {
                let there = Point::default()
                    .towards(heading.deg(), offset_m[0])
                    .towards(heading.deg() + 90.0, offset_m[1]);
                Plane::at(antenna).position(there)
            }
            _ => antenna,
        };
        let utc = fix
            .utc
            .map(|utc| UtcTime::from_seconds(utc + age as f64 / 1000.0));
        Some(Here {
            position,
            utc,
            mode: fix.mode,
        })
    }

    /// Course and speed over ground, at most 5 s old.
    pub(super) fn ground_at(&self, now: Stamp) -> Option<Ground> {
        fresh(self.ground, Quantity::Ground, now)
    }

    /// Heading of the compass, else the one that the autopilot forwards; at most 2 s old.
    pub(super) fn heading_at(&self, now: Stamp) -> Option<Heading> {
        fresh(self.heading, Quantity::Heading, now)
            .or_else(|| fresh(self.forwarded, Quantity::Heading, now))
    }

    /// Speed through the water, at most 5 s old.
    pub(super) fn water_at(&self, now: Stamp) -> Option<Speed> {
        fresh(self.water, Quantity::WaterSpeed, now)
    }

    /// The autopilot's steering mode by HTD; the outer none where no HTD was heard for 5 s.
    pub(super) fn steering_at(&self, now: Stamp) -> Option<Option<SteeringMode>> {
        fresh(self.steering, Quantity::Report, now)
    }

    /// Whether the position has jumped since the last call (FA9).
    pub(super) fn take_jump(&mut self) -> bool {
        core::mem::take(&mut self.jumped)
    }

    /// The ship may be anywhere: waits for a new position.
    pub(super) fn forget_position(&mut self) {
        self.fix = None;
        self.off = 0;
        self.jumped = false;
    }

    /// Nothing heard before counts as fresh (FA16).
    pub(super) fn forget_all(&mut self) {
        self.forget_position();
        self.ground = None;
        self.heading = None;
        self.forwarded = None;
        self.water = None;
        self.steering = None;
    }
}

/// The outer none: not a heading sentence; the inner none: not valid.
fn heading(sentence: &Sentence<'_>) -> Option<Option<Heading>> {
    let degrees = if let Some(hdt) = Hdt::from_sentence(sentence) {
        hdt.heading
    } else {
        let ths = Ths::from_sentence(sentence)?;
        ths.heading
            .filter(|_| ths.mode == Some(ThsMode::Autonomous))
    };
    Some(degrees.map(Heading::from_deg))
}

fn distance(a: Position, b: Position) -> f64 {
    Plane::at(a).point(b).distance(Point::default())
}
