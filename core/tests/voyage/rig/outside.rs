//! Ports to the outside: that they come and go, and what is heard on them.

use super::Rig;
use wheelover_core::nmea::with_checksum;
use wheelover_core::station::{ChecksumPolicy, PortSetup, Profile, Role};
use wheelover_core::voyage::{Event, Voyage};

/// A port of a station to the outside.
pub(crate) fn outside(station: Role, name: &str, profile: Profile) -> (Role, PortSetup) {
    let setup = PortSetup {
        name: name.into(),
        profile,
        checksum: ChecksumPolicy::Required,
        talkers: Vec::new(),
        baud: 4_800,
        output: false,
    };
    (station, setup)
}

impl Rig {
    /// A port to the outside came or went, by its number.
    pub(crate) fn plug(&mut self, port: usize, up: bool) {
        self.event(Event::PortUp { port, up });
    }

    /// The voyage as it is seen.
    pub(crate) fn voyage(&self) -> &Voyage {
        &self.voyage
    }

    /// Bytes come on a port to the outside.
    pub(crate) fn bytes(&mut self, port: usize, bytes: &[u8]) {
        let bytes = bytes.to_vec();
        self.event(Event::Bytes { port, bytes });
    }

    /// A sentence comes on a port to the outside; the checksum is added.
    pub(crate) fn sentence(&mut self, port: usize, body: &str) {
        self.bytes(port, format!("{}\r\n", with_checksum(body)).as_bytes());
    }
}
