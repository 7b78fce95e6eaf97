//! The picture: each heard quantity with its value, source and the time it was heard.
//!
//! In: lines with time, port and direction. Out: values with their age. The server and the page
//! fold the same lines with this code, and their digests agree.
//!
//! **Invariant:** a value changes only by a sentence that its port may say, whose checksum the
//! port's policy accepts and whose fields are without fault (SEN-2, FE11).

mod fold;

use crate::geo::Position;
use crate::limits::{Freshness, Quantity, freshness};
use crate::nmea::{Htc, Htd, Pney1, Pney2, Xte};
use crate::station::{PortIndex, PortSetup, Profile};
use crate::time::Stamp;
use crate::units::{Course, Heading, RateOfTurn, RudderAngle, Speed};
use alloc::format;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;
use postcard::ser_flavors::Flavor;
use postcard::serialize_with_flavor;
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
        let hash = serialize_with_flavor(self, Digest::default()).unwrap_or_default();
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

/// FNV-1a over the picture's bytes as they are made.
struct Digest(u64);

impl Default for Digest {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Flavor for Digest {
    type Output = u64;

    fn try_push(&mut self, byte: u8) -> postcard::Result<()> {
        self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        Ok(())
    }

    fn finalize(self) -> postcard::Result<u64> {
        Ok(self.0)
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
