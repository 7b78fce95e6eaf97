//! The picture: each heard quantity with its value, source and the time it was heard.
//!
//! In: lines with time, port and direction. Out: values with their age. The server and the page
//! fold the same lines with this code, and their digests agree.
//!
//! **Invariant:** a value changes only by a sentence that its port may say, whose checksum the
//! port's policy accepts and whose fields are without fault (SEN-2, FE11).

use crate::geo::Position;
use crate::limits::{Freshness, Quantity, freshness};
use crate::nmea::{self, Checksum, Htc, Htd, Pney1, Pney2, Sentence, Xte};
use crate::station::{ChecksumPolicy, Direction, PortIndex, PortSetup, Profile};
use crate::time::Stamp;
use crate::units::{Course, Heading, RateOfTurn, RudderAngle, Speed};
use alloc::format;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Where a value comes from.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Source {
    /// Port it was heard on.
    pub port: PortIndex,
    /// Talker.
    pub talker: String,
    /// Formatter.
    pub formatter: String,
}

/// A heard value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Heard<T> {
    /// The last valid value.
    pub value: T,
    /// When it was heard.
    pub at: Stamp,
    /// When the source last said that it has no valid value, or said it wrongly.
    pub refused: Option<Stamp>,
    /// Who said it.
    pub source: Source,
}

impl<T> Heard<T> {
    /// How the value may be used at `now`.
    #[must_use]
    pub fn freshness(&self, quantity: Quantity, now: Stamp) -> Freshness {
        if self.refused.is_some_and(|refused| refused >= self.at) {
            return Freshness::Lost;
        }
        freshness(quantity, self.at, now)
    }

    /// The value, unless it is lost.
    #[must_use]
    pub fn usable(&self, quantity: Quantity, now: Stamp) -> Option<&T> {
        match self.freshness(quantity, now) {
            Freshness::Valid | Freshness::Late | Freshness::Low => Some(&self.value),
            Freshness::Lost | Freshness::Never => None,
        }
    }
}

/// A position with its quality.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fix {
    /// Place.
    pub position: Position,
    /// Differential, precise or real-time kinematic (AP-7).
    pub corrected: bool,
}

/// Course and speed over ground.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ground {
    /// Course, absent where the ship lies still.
    pub course: Option<Course>,
    /// Speed.
    pub speed: Speed,
}

/// What the last HTC meant (SEN-5).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Commanded {
    /// Its fields.
    pub htc: Htc,
    /// Why it is not obeyed, in an officer's words; absent where it may be.
    pub refusal: Option<String>,
}

/// What a port has said so far.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PortCount {
    /// Sentences accepted.
    pub heard: u64,
    /// Sentences sent.
    pub sent: u64,
    /// Sentences refused by the checksum policy.
    pub bad_checksum: u64,
    /// Lines that are no sentence.
    pub garbage: u64,
    /// A right checksum was heard (policy `learned`).
    pub learned: bool,
    /// When the last accepted sentence was heard.
    pub last: Option<Stamp>,
}

/// What a station has heard and sent, folded from its lines.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// The station's ports.
    pub ports: Vec<PortSetup>,
    /// What each has said.
    pub counts: Vec<PortCount>,
    /// Headings, one a source.
    pub headings: Vec<Heard<Heading>>,
    /// Rates of turn, one a source.
    pub rates: Vec<Heard<RateOfTurn>>,
    /// Positions, one a source.
    pub fixes: Vec<Heard<Fix>>,
    /// Courses and speeds over ground, one a source.
    pub grounds: Vec<Heard<Ground>>,
    /// Speeds through the water, one a source.
    pub water_speeds: Vec<Heard<Speed>>,
    /// Rudder response.
    pub rudder: Option<Heard<RudderAngle>>,
    /// Rudder order.
    pub order: Option<Heard<RudderAngle>>,
    /// Last HTC without a checksum or count fault; `at` only where it may be obeyed.
    pub htc: Option<Heard<Commanded>>,
    /// Cross-track distance for display.
    pub xte: Option<Heard<Xte>>,
    /// Cross-track distance for control.
    pub pney1: Option<Heard<Pney1>>,
    /// Radius centre and waypoint.
    pub pney2: Option<Heard<Pney2>>,
    /// What the autopilot reports.
    pub htd: Option<Heard<Htd>>,
}

/// At most so many sources a quantity; a further one is not taken.
const MAX_SOURCES: usize = 8;

impl Picture {
    /// An empty picture of a station with these ports.
    #[must_use]
    pub fn new(ports: Vec<PortSetup>) -> Self {
        let counts = vec![PortCount::default(); ports.len()];
        Self {
            ports,
            counts,
            ..Self::default()
        }
    }

    /// A picture without ports, which hears nothing.
    #[must_use]
    pub const fn empty() -> Self {
        Self {
            ports: Vec::new(),
            counts: Vec::new(),
            headings: Vec::new(),
            rates: Vec::new(),
            fixes: Vec::new(),
            grounds: Vec::new(),
            water_speeds: Vec::new(),
            rudder: None,
            order: None,
            htc: None,
            xte: None,
            pney1: None,
            pney2: None,
            htd: None,
        }
    }

    /// Folds one line. The result depends on the arguments and the earlier lines alone.
    pub fn fold(&mut self, at: Stamp, port: PortIndex, dir: Direction, text: &[u8]) {
        let sentence = nmea::decode(text);
        self.fold_sentence(at, port, dir, &sentence);
    }

    /// Folds one decoded line. True where the port's policy accepts it.
    pub fn fold_sentence(
        &mut self,
        at: Stamp,
        port: PortIndex,
        dir: Direction,
        sentence: &Sentence<'_>,
    ) -> bool {
        let (Some(setup), Some(count)) = (self.ports.get(port), self.counts.get_mut(port)) else {
            return false;
        };
        let profile = setup.profile;
        if dir == Direction::Out {
            count.sent += 1;
        } else {
            if sentence.formatter.is_empty() {
                count.garbage += 1;
                return false;
            }
            if !accepted(setup.checksum, sentence.checksum, &mut count.learned) {
                count.bad_checksum += 1;
                return false;
            }
            count.heard += 1;
            count.last = Some(at);
        }
        let source = || Source {
            port,
            talker: sentence.talker.into(),
            formatter: sentence.formatter.into(),
        };
        let clean = sentence.faults().is_empty();
        match (dir, sentence.formatter) {
            (Direction::In, "HDT") if gives_heading(profile) => {
                let value = nmea::Hdt::from_sentence(sentence).and_then(|s| s.heading);
                hear(
                    &mut self.headings,
                    at,
                    source(),
                    value.filter(|_| clean).map(Heading::from_deg),
                );
            }
            (Direction::In, "THS") if gives_heading(profile) => {
                let view = nmea::Ths::from_sentence(sentence);
                let value = view
                    .filter(|s| clean && s.mode == Some(nmea::ThsMode::Autonomous))
                    .and_then(|s| s.heading);
                hear(
                    &mut self.headings,
                    at,
                    source(),
                    value.map(Heading::from_deg),
                );
            }
            (Direction::In, "ROT") if gives_heading(profile) || profile == Profile::Rot => {
                let value = nmea::Rot::from_sentence(sentence)
                    .filter(|s| clean && s.status == Some(nmea::DataStatus::Valid))
                    .and_then(|s| s.rate);
                hear(
                    &mut self.rates,
                    at,
                    source(),
                    value.map(RateOfTurn::from_deg_per_min),
                );
            }
            (Direction::In, "GLL") if matches!(profile, Profile::Gps | Profile::Ecdis) => {
                let value = nmea::Gll::from_sentence(sentence).filter(|s| {
                    clean
                        && s.status == Some(nmea::DataStatus::Valid)
                        && s.mode.is_none_or(nmea::ModeIndicator::valid)
                });
                let fix = value.and_then(|s| {
                    let corrected = s.mode.is_some_and(|mode| {
                        mode.valid() && mode != nmea::ModeIndicator::Autonomous
                    });
                    s.position.map(|position| Fix {
                        position,
                        corrected,
                    })
                });
                hear(&mut self.fixes, at, source(), fix);
            }
            (Direction::In, "VTG") if matches!(profile, Profile::Gps | Profile::Ecdis) => {
                let value = nmea::Vtg::from_sentence(sentence)
                    .filter(|s| clean && s.mode.is_none_or(nmea::ModeIndicator::valid));
                let ground = value.and_then(|s| {
                    let course = s.course_true.map(Course::from_deg);
                    s.speed_knots.map(|speed| Ground {
                        course,
                        speed: Speed::from_knots(speed),
                    })
                });
                hear(&mut self.grounds, at, source(), ground);
            }
            (Direction::In, "VHW") if matches!(profile, Profile::Log | Profile::Ecdis) => {
                let value = nmea::Vhw::from_sentence(sentence).and_then(|s| s.speed_knots);
                let speed = value.filter(|_| clean).map(Speed::from_knots);
                hear(&mut self.water_speeds, at, source(), speed);
            }
            (Direction::In, "RSA") if matches!(profile, Profile::Gear | Profile::Ecdis) => {
                let value = nmea::Rsa::from_sentence(sentence)
                    .filter(|s| clean && s.starboard_status == Some(nmea::DataStatus::Valid))
                    .and_then(|s| s.starboard);
                hear_one(
                    &mut self.rudder,
                    at,
                    source(),
                    value.map(RudderAngle::from_deg),
                );
            }
            (_, "ROR") if profile == Profile::Ecdis => {
                let value = nmea::Ror::from_sentence(sentence)
                    .filter(|s| clean && s.starboard_status == Some(nmea::DataStatus::Valid))
                    .and_then(|s| s.starboard);
                hear_one(
                    &mut self.order,
                    at,
                    source(),
                    value.map(RudderAngle::from_deg),
                );
            }
            (_, "HTD") if profile == Profile::Ecdis => {
                let view = Htd::from_sentence(sentence).filter(|_| clean);
                hear_one(&mut self.htd, at, source(), view);
            }
            (Direction::In, "HTC") if profile == Profile::Ecdis => {
                self.hear_htc(at, source(), sentence)
            }
            (Direction::In, "XTE") if profile == Profile::Ecdis => {
                let view = Xte::from_sentence(sentence)
                    .filter(|s| clean && measured(s.status, s.cycle_lock, s.mode));
                hear_one(&mut self.xte, at, source(), view);
            }
            (Direction::In, "PNEY,001") if profile == Profile::Ecdis => {
                let view = Pney1::from_sentence(sentence)
                    .filter(|s| clean && measured(s.status, s.cycle_lock, s.mode));
                hear_one(&mut self.pney1, at, source(), view);
            }
            (Direction::In, "PNEY,002") if profile == Profile::Ecdis => {
                let view = Pney2::from_sentence(sentence).filter(|_| clean);
                hear_one(&mut self.pney2, at, source(), view);
            }
            _ => {}
        }
        true
    }

    /// SEN-5: only a strict HTC renews the command; a refused one is kept with its reason.
    fn hear_htc(&mut self, at: Stamp, source: Source, sentence: &Sentence<'_>) {
        let Some(htc) = Htc::from_sentence(sentence) else {
            return;
        };
        let refusal = nmea::steering(sentence, true)
            .err()
            .map(|refusal| refusal.text);
        match (&mut self.htc, refusal) {
            (Some(heard), Some(refusal)) => {
                heard.refused = Some(at);
                heard.value.refusal = Some(refusal);
            }
            (slot, refusal) => {
                let refused = refusal.is_some().then_some(at);
                let value = Commanded { htc, refusal };
                *slot = Some(Heard {
                    value,
                    at,
                    refused,
                    source,
                });
            }
        }
    }

    /// The heading in use: the first usable one in the order of the ports' profiles.
    #[must_use]
    pub fn heading(&self, now: Stamp) -> Option<&Heard<Heading>> {
        self.best(&self.headings, Quantity::Heading, now)
    }

    /// The rate of turn in use.
    #[must_use]
    pub fn rate(&self, now: Stamp) -> Option<&Heard<RateOfTurn>> {
        self.best(&self.rates, Quantity::RateOfTurn, now)
    }

    /// The position in use.
    #[must_use]
    pub fn fix(&self, now: Stamp) -> Option<&Heard<Fix>> {
        self.best(&self.fixes, Quantity::Position, now)
    }

    /// Course and speed over ground in use.
    #[must_use]
    pub fn ground(&self, now: Stamp) -> Option<&Heard<Ground>> {
        self.best(&self.grounds, Quantity::Ground, now)
    }

    /// The speed through the water in use.
    #[must_use]
    pub fn water_speed(&self, now: Stamp) -> Option<&Heard<Speed>> {
        self.best(&self.water_speeds, Quantity::WaterSpeed, now)
    }

    /// Name of a source as `port/talker/formatter`.
    #[must_use]
    pub fn source_name(&self, source: &Source) -> String {
        let port = self
            .ports
            .get(source.port)
            .map_or("?", |port| port.name.as_str());
        format!("{port}/{}/{}", source.talker, source.formatter)
    }

    /// A digest of the stored picture (no ages), hexadecimal: equal pictures, equal digests.
    #[must_use]
    pub fn digest(&self) -> String {
        let text = serde_json::to_vec(self).unwrap_or_default();
        let mut hash = 0xcbf2_9ce4_8422_2325_u64; // FNV-1a
        for byte in text {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
        format!("{hash:016x}")
    }

    /// The usable source of highest rank; where none is usable, the one heard last.
    fn best<'a, T>(
        &self,
        list: &'a [Heard<T>],
        quantity: Quantity,
        now: Stamp,
    ) -> Option<&'a Heard<T>> {
        let rank = |heard: &Heard<T>| {
            self.ports
                .get(heard.source.port)
                .map_or(99, |p| rank(p.profile))
        };
        list.iter()
            .filter(|heard| heard.usable(quantity, now).is_some())
            .min_by_key(|heard| rank(heard))
            .or_else(|| list.iter().max_by_key(|heard| heard.at))
    }
}

/// Order of preference among sources (AP-9).
const fn rank(profile: Profile) -> u8 {
    match profile {
        Profile::Gyro1 => 0,
        Profile::Gyro2 => 1,
        Profile::Thd => 2,
        Profile::Rot => 3,
        Profile::Gps | Profile::Log | Profile::Gear => 4,
        Profile::Magn => 5,
        Profile::Ecdis => 6,
        Profile::Hmi | Profile::Monitor => 9,
    }
}

const fn gives_heading(profile: Profile) -> bool {
    matches!(
        profile,
        Profile::Gyro1 | Profile::Gyro2 | Profile::Thd | Profile::Ecdis
    )
}

/// SEN-2: whether the port's policy accepts the sentence.
fn accepted(policy: ChecksumPolicy, checksum: Checksum, learned: &mut bool) -> bool {
    match checksum {
        Checksum::Right { .. } => {
            *learned = true;
            true
        }
        Checksum::Wrong { .. } => false,
        Checksum::Missing { .. } => match policy {
            ChecksumPolicy::Required => false,
            ChecksumPolicy::Learned => !*learned,
            ChecksumPolicy::Optional => true,
        },
    }
}

/// AP-9, FA5: both status letters and the mode indicator must be valid.
fn measured(
    status: Option<nmea::DataStatus>,
    cycle_lock: Option<nmea::DataStatus>,
    mode: Option<nmea::ModeIndicator>,
) -> bool {
    status == Some(nmea::DataStatus::Valid)
        && cycle_lock != Some(nmea::DataStatus::Invalid)
        && mode.is_none_or(nmea::ModeIndicator::valid)
}

fn hear<T>(list: &mut Vec<Heard<T>>, at: Stamp, source: Source, value: Option<T>) {
    let index = list.iter().position(|heard| heard.source == source);
    match (index.and_then(|index| list.get_mut(index)), value) {
        (Some(heard), Some(value)) => {
            *heard = Heard {
                value,
                at,
                refused: None,
                source,
            }
        }
        (Some(heard), None) => heard.refused = Some(at),
        (None, Some(value)) => {
            if list.len() < MAX_SOURCES {
                list.push(Heard {
                    value,
                    at,
                    refused: None,
                    source,
                });
            }
        }
        (None, None) => {}
    }
}

fn hear_one<T>(slot: &mut Option<Heard<T>>, at: Stamp, source: Source, value: Option<T>) {
    match (slot.as_mut(), value) {
        (_, Some(value)) => {
            *slot = Some(Heard {
                value,
                at,
                refused: None,
                source,
            })
        }
        (Some(heard), None) => heard.refused = Some(at),
        (None, None) => {}
    }
}
