//! The picture: each heard quantity with its value, source and the time it was heard.
//!
//! In: lines with time, port and direction. Out: values with their age. The server and the page
//! fold the same lines with this code, and their digests agree.
//!
//! **Invariant:** a value changes only by a sentence that its port may say, whose checksum the
//! port's policy accepts and whose fields are without fault (SEN-2, FE11).

mod fold;

use crate::facts::facts;
pub use crate::facts::fix::{Bearing, Fix, Ground};
use crate::facts::known::OfPicture;
use crate::facts::ports::rank;
use crate::limits::{Freshness, Quantity, freshness};
use crate::nmea::{Htc, Htd, Pney1, Pney2, Sentence, Xte, decode_knowing};
use crate::station::{PortIndex, PortSetup, Role};
use crate::time::Stamp;
use crate::units::{RateOfTurn, RudderAngle, SignedAngle, Speed};
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
    /// When a report was withdrawn or a command refused: it is not used any more.
    pub refused: Option<Stamp>,
    /// When the source last said that it has no valid value: counts as not received, so the last one lives out its age (AP-9).
    pub not_valid: Option<Stamp>,
    /// Who said it.
    pub source: Source,
}

impl<T> Heard<T> {
    /// A value just heard.
    pub(crate) const fn new(value: T, at: Stamp, source: Source) -> Self {
        Self {
            value,
            at,
            refused: None,
            not_valid: None,
            source,
        }
    }

    /// How the value may be used at `now`.
    #[must_use]
    pub fn freshness(&self, quantity: Quantity, now: Stamp) -> Freshness {
        if self.refused.is_some_and(|refused| refused >= self.at) {
            return Freshness::Lost;
        }
        match freshness(quantity, self.at, now) {
            // Still used, and shown with its age.
            Freshness::Valid if self.not_valid.is_some() => Freshness::Late,
            by_age => by_age,
        }
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
    /// Accepted sentences that the port may not say: kept, and not used from here (FE11).
    pub unused: u64,
    /// A right checksum was heard (policy `learned`).
    pub learned: bool,
    /// When the last accepted sentence was heard.
    pub last: Option<Stamp>,
}

/// Makes the picture from the table of facts.
macro_rules! picture {
    ($($(#[$doc:meta])* $field:ident: $kind:ident $type:ty { $($name:ident: $read:path),* } $(own { $($own:ident: $own_read:path),* })?;)*) => {
        /// What a station has heard and sent, folded from its lines.
        #[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
        pub struct Picture {
            /// Whose picture it is; decides what is believed.
            pub station: Role,
            /// The station's ports.
            pub ports: Vec<PortSetup>,
            /// What each has said.
            pub counts: Vec<PortCount>,
            $($(#[$doc])* pub $field: store!($kind $type),)*
        }

        impl Picture {
            /// A picture without ports, which hears nothing.
            #[must_use]
            pub const fn empty() -> Self {
                Self {
                    station: Role::Autopilot,
                    ports: Vec::new(),
                    counts: Vec::new(),
                    $($field: nothing!($kind),)*
                }
            }
        }
    };
}

macro_rules! store {
    (many $type:ty) => { Vec<Heard<$type>> };
    ($one:ident $type:ty) => { Option<Heard<$type>> };
}

macro_rules! nothing {
    (many) => {
        Vec::new()
    };
    ($one:ident) => {
        None
    };
}

facts!(picture);

/// Decodes one line for [`Picture::fold_sentence`]: sentences that no picture is made of are left unknown, and a program
/// that decodes in this way only does not carry their tables.
#[must_use]
pub fn decode(line: &[u8]) -> Sentence<'_> {
    decode_knowing::<OfPicture>(line)
}

impl Picture {
    /// An empty picture of a station with these ports.
    #[must_use]
    pub fn new(station: Role, ports: Vec<PortSetup>) -> Self {
        let counts = vec![PortCount::default(); ports.len()];
        Self {
            station,
            ports,
            counts,
            ..Self::default()
        }
    }

    /// The heading in use: the first usable one in the order of the ports' profiles.
    #[must_use]
    pub fn heading(&self, now: Stamp) -> Option<&Heard<Bearing>> {
        self.best(&self.headings, Quantity::Heading, now)
    }

    /// The variation where the ship is, degrees, east positive.
    #[must_use]
    pub fn variation(&self, now: Stamp) -> Option<f64> {
        let heard = self.variation.as_ref()?;
        heard.usable(Quantity::Variation, now).copied()
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

    /// The angle of the wind in use: of the apparent one, else of the true one.
    #[must_use]
    pub fn wind(&self, apparent: bool, now: Stamp) -> Option<&Heard<SignedAngle>> {
        let winds = if apparent {
            &self.apparent_winds
        } else {
            &self.true_winds
        };
        self.best(winds, Quantity::Wind, now)
    }

    /// Place of a source in the order of preference, the best first (AP-9).
    pub(crate) fn rank(&self, source: &Source) -> u8 {
        let port = self.ports.get(source.port);
        port.map_or(99, |port| rank(port.profile))
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
        let rank = |heard: &Heard<T>| self.rank(&heard.source);
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
