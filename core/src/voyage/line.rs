//! One numbered line of the station that is shown.

use crate::station::{Direction, PortIndex};
use alloc::string::String;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A line heard or sent. As JSON it is the list `[seq, at, port, dir, text]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its number, from 1.
    pub seq: u64,
    /// When, in milliseconds of the voyage's clock.
    pub at: u64,
    /// Port of the station.
    pub port: PortIndex,
    /// Heard or sent.
    pub dir: Direction,
    /// Its bytes as Latin-1, so that a damaged line is the same everywhere.
    pub text: String,
}

impl Serialize for Line {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        (self.seq, self.at, self.port, self.dir, &self.text).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Line {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (seq, at, port, dir, text) = Deserialize::deserialize(deserializer)?;
        Ok(Self {
            seq,
            at,
            port,
            dir,
            text,
        })
    }
}
