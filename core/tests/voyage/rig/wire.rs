//! The tap on the cables: the filter that a test sets, and what passed it.

use wheelover_core::nmea::{self, Htd};
use wheelover_core::station::{Profile, Role};
use wheelover_core::time::Stamp;
use wheelover_core::voyage::Parcel;

/// What becomes of a line to the autopilot: its text without CR LF, or nothing.
pub(crate) type Filter = Box<dyn FnMut(Stamp, Profile, &str) -> Option<String> + Send>;

/// What the tap on the cables holds.
pub(crate) struct Wire {
    pub(crate) filter: Filter,
    /// Last line of each formatter that the chart system said, as it was sent.
    pub(crate) said: Vec<(String, String)>,
    /// HTD lines of the autopilot with their time.
    pub(crate) htd: Vec<(Stamp, Htd)>,
    /// What the autopilot said to the chart system: the last line of each formatter, and how many.
    pub(crate) told: Vec<(String, String, usize)>,
}

impl Default for Wire {
    fn default() -> Self {
        Self {
            filter: Box::new(|_, _, line| Some(line.to_string())),
            said: Vec::new(),
            htd: Vec::new(),
            told: Vec::new(),
        }
    }
}

impl Wire {
    pub(crate) fn pass(&mut self, parcel: Parcel<'_>) -> Option<Vec<u8>> {
        let text = String::from_utf8_lossy(parcel.bytes);
        if parcel.to != Role::Autopilot {
            for line in text.lines().filter(|_| parcel.profile == Profile::Ecdis) {
                let sentence = nmea::decode(line.as_bytes());
                let found = self
                    .told
                    .iter()
                    .position(|(name, ..)| name == sentence.formatter);
                let count = found.map_or(0, |index| self.told.swap_remove(index).2);
                self.told
                    .push((sentence.formatter.into(), line.into(), count + 1));
                let htd = Htd::from_sentence(&sentence);
                self.htd.extend(htd.map(|htd| (parcel.at, htd)));
            }
            return Some(parcel.bytes.to_vec());
        }
        let mut heard = String::new();
        for line in text.lines() {
            if parcel.profile == Profile::Ecdis {
                let formatter = nmea::decode(line.as_bytes()).formatter.to_string();
                self.said.retain(|(name, _)| *name != formatter);
                self.said.push((formatter, line.to_string()));
            }
            if let Some(line) = (self.filter)(parcel.at, parcel.profile, line) {
                heard += &format!("{line}\r\n");
            }
        }
        Some(heard.into_bytes())
    }
}
