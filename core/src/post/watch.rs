//! The watch over the ports to real equipment: which are gone, and on which nothing valid comes (AP-11, FB8, FB10).
//!
//! In: a port came or went, bytes without a sentence, sentences with what became of them. Out: what is wrong, port by port,
//! in an officer's words. A port that is cabled inside is never said to have come, and is not watched; nor is one of which
//! nothing is believed.

use crate::facts::ports::{believed, speaks_always};
use crate::picture::{Picture, PortCount};
use crate::station::PortIndex;
use crate::time::Stamp;
use alloc::format;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Without a valid sentence for so long, milliseconds: at the next second's step of either station it is said within 5 s
/// (FB10).
const QUIET_MS: u64 = 4_000;
/// Bytes without a sentence that come for a shorter time are a disturbance of a moment, milliseconds.
const MOMENT_MS: u64 = 2_000;

/// A device that comes and goes again within so long has not come, milliseconds.
const BACK_MS: u64 = 1_000;

/// What was wrong since the last good sentence, in words, in the order of [`Watched::bad`].
const WORDS: [&str; 4] = [
    "wrong or missing checksums",
    "noise",
    "unknown sentences",
    "sentences that are not used from here",
];

/// All ports of a station.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct PortWatch(Vec<Watched>);

/// One port.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct Watched {
    /// It is there; absent while nobody has said so, as of a port that is cabled inside.
    up: Option<bool>,
    /// It was gone before it came, and has said nothing valid since.
    returns: bool,
    /// When it came, or said something good.
    good: Stamp,
    /// Bytes without a valid sentence: the first and the last of them since the last one.
    noise: Option<(Stamp, Stamp)>,
    /// Valid sentences that the dictionary does not know.
    unknown: u64,
    /// What was bad when it was last good.
    before: [u64; 4],
}

impl Watched {
    /// What is bad so far: checksums, garbage, unknown, not used from here.
    fn bad(&self, count: &PortCount) -> [u64; 4] {
        let unused = count.unused.saturating_sub(self.unknown);
        [count.bad_checksum, count.garbage, self.unknown, unused]
    }

    /// Its device is gone, or has only just come back.
    fn gone(&self, now: Stamp) -> bool {
        match self.up {
            Some(up) => !up || self.returns && now.since(self.good) < BACK_MS,
            None => false,
        }
    }

    fn is_good(&mut self, now: Stamp, count: &PortCount) {
        self.good = now;
        self.noise = None;
        self.before = self.bad(count);
    }

    /// Why it says nothing valid, where it does not.
    fn quiet(&self, now: Stamp, always: bool, count: &PortCount) -> Option<String> {
        let lasts = |(first, last): (Stamp, Stamp)| {
            now.since(first) >= QUIET_MS
                && last.since(first) >= MOMENT_MS
                && now.since(last) <= QUIET_MS
        };
        let silent = always && now.since(self.good) >= QUIET_MS;
        if self.up != Some(true) || !silent && !self.noise.is_some_and(lasts) {
            return None;
        }
        let bad = self.bad(count).into_iter().zip(self.before);
        let causes = bad.zip(WORDS).filter(|((now, before), _)| now > before);
        let causes: Vec<&str> = causes.map(|(_, words)| words).collect();
        Some(match (causes.as_slice(), self.noise) {
            ([], None) => "nothing is heard".into(),
            ([], Some(_)) => WORDS[1].into(),
            (causes, _) => causes.join(", "),
        })
    }
}

impl PortWatch {
    /// A watch over so many ports, of which nothing is known.
    pub(super) fn new(ports: usize) -> Self {
        Self(vec![Watched::default(); ports])
    }

    /// A port came or went.
    pub(super) fn set(&mut self, now: Stamp, port: PortIndex, up: bool, picture: &Picture) {
        if let (Some(watched), Some(count)) = (self.0.get_mut(port), picture.counts.get(port)) {
            watched.returns = up && watched.up == Some(false);
            watched.up = Some(up);
            watched.is_good(now, count);
        }
    }

    /// The station stood still: the time of every port begins anew (FA16).
    pub(super) fn stalled(&mut self, now: Stamp) {
        for watched in &mut self.0 {
            watched.good = now;
            watched.noise = None;
        }
    }

    /// Bytes came that ended no valid sentence.
    pub(super) fn noise(&mut self, now: Stamp, port: PortIndex) {
        if let Some(watched) = self.0.get_mut(port) {
            let before = watched
                .noise
                .filter(|(_, last)| now.since(*last) <= QUIET_MS);
            watched.noise = Some((before.map_or(now, |(first, _)| first), now));
        }
    }

    /// A valid sentence came; `used`: it is believed from here, `known`: the dictionary has it.
    pub(super) fn valid(
        &mut self,
        now: Stamp,
        port: PortIndex,
        (used, known): (bool, bool),
        picture: &Picture,
    ) {
        let (Some(watched), Some(setup)) = (self.0.get_mut(port), picture.ports.get(port)) else {
            return;
        };
        (watched.noise, watched.returns) = (None, false);
        watched.unknown += u64::from(!known && !used);
        if used || !speaks_always(setup.profile) {
            watched.is_good(now, &picture.counts[port]);
        }
    }

    /// Valid sentences of a port that the dictionary does not know.
    pub(super) fn unknown(&self, port: PortIndex) -> u64 {
        self.0.get(port).map_or(0, |watched| watched.unknown)
    }

    /// Why a port says nothing valid, where it does not.
    pub(super) fn quiet(&self, now: Stamp, port: PortIndex, picture: &Picture) -> Option<String> {
        let (watched, setup) = (self.0.get(port)?, picture.ports.get(port)?);
        if believed(picture.station, setup.profile).is_empty() {
            return None;
        }
        watched.quiet(now, speaks_always(setup.profile), picture.counts.get(port)?)
    }

    /// What is said of all ports on which nothing valid comes; absent where there is none (FB10).
    pub(super) fn no_sentence(&self, now: Stamp, picture: &Picture) -> Option<String> {
        let mut said = Vec::new();
        for (port, setup) in picture.ports.iter().enumerate() {
            if let Some(why) = self.quiet(now, port, picture) {
                said.push(format!("{}: {why}", setup.name));
            }
        }
        let said = said.join("; ");
        (!said.is_empty()).then(|| format!("{said}. Check line, baud rate and device"))
    }

    /// What is said of all ports whose device is gone; absent where there is none (FB8, FD9).
    pub(super) fn gone(&self, now: Stamp, picture: &Picture) -> Option<String> {
        let ports = picture.ports.iter().zip(&self.0);
        let gone = ports.filter(|(setup, watched)| {
            watched.gone(now) && !believed(picture.station, setup.profile).is_empty()
        });
        let names: Vec<&str> = gone.map(|(setup, _)| setup.name.as_str()).collect();
        let names = names.join(", ");
        (!names.is_empty()).then(|| format!("{names}: gone. Check plug and device"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nmea::{self, with_checksum};
    use crate::station::{ChecksumPolicy, Direction, PortSetup, Profile, Role};
    use alloc::string::ToString;

    /// A watched port of a profile, and one beside it.
    fn port(profile: Profile) -> (PortWatch, Picture) {
        let setup = |name: &str, profile| PortSetup {
            name: name.into(),
            profile,
            checksum: ChecksumPolicy::Required,
            talkers: Vec::new(),
            baud: 4_800,
            output: false,
        };
        let ports = vec![setup("one", profile), setup("two", Profile::Gyro2)];
        let picture = Picture::new(Role::Autopilot, ports);
        (PortWatch::new(2), picture)
    }

    /// Hears a line a second from `from` to `to` (seconds); what is said at each of these.
    fn hear(
        watch: &mut PortWatch,
        picture: &mut Picture,
        (from, to): (u64, u64),
        line: &str,
    ) -> Vec<String> {
        let mut said = Vec::new();
        for second in from..to {
            let now = Stamp(second * 1_000);
            if !line.is_empty() {
                let sentence = nmea::decode(line.as_bytes());
                let before = picture.counts[0].heard;
                let used = picture.fold_sentence(now, 0, Direction::In, &sentence);
                if picture.counts[0].heard > before {
                    watch.valid(now, 0, (used, sentence.known.is_some()), picture);
                } else {
                    watch.noise(now, 0);
                }
            }
            said.push(watch.quiet(now, 0, picture).unwrap_or_default());
        }
        said
    }

    // FB10: each cause by its name, from the fourth second on, and over with the first good sentence.
    #[test]
    fn each_cause_is_named_within_its_time_and_ends_with_a_good_sentence() {
        let good = with_checksum("HEHDT,100.0,T");
        let check = |profile, line: &str, expect: &str| {
            let (mut watch, mut picture) = port(profile);
            watch.set(Stamp(1_000), 0, true, &picture);
            let good = if profile == Profile::Hmi {
                with_checksum("PEMC,00")
            } else {
                good.clone()
            };
            let before = hear(&mut watch, &mut picture, (1, 21), &good);
            assert!(before.iter().all(String::is_empty), "{before:?}");
            let said = hear(&mut watch, &mut picture, (21, 40), line);
            let first = said.iter().position(|said| !said.is_empty());
            if expect.is_empty() {
                assert_eq!(first, None, "{profile:?} {line}: {said:?}");
            } else {
                // The last good one was at 20 s; bytes came from 21 s on.
                assert!(matches!(first, Some(3 | 4)), "{profile:?} {line}: {said:?}");
                assert_eq!(said.last().map(String::as_str), Some(expect), "{line}");
            }
            let after = hear(&mut watch, &mut picture, (40, 42), &good);
            assert_eq!(after, [""; 2], "{line}");
        };
        check(Profile::Gyro1, "", "nothing is heard");
        check(Profile::Gyro1, "$HEHDT,100.0,T*00", WORDS[0]);
        check(Profile::Gyro1, "x\u{fffd}fw}", WORDS[1]);
        check(Profile::Gyro1, &with_checksum("HEZZX,1"), WORDS[2]);
        check(Profile::Gyro1, &with_checksum("GPGGA,1"), WORDS[3]);
        // What speaks when it has something to say may be silent, and say what nobody uses; not noise.
        check(Profile::Hmi, "", "");
        check(Profile::Hmi, &with_checksum("GPGGA,1"), "");
        check(Profile::Hmi, "x\u{fffd}fw}", WORDS[1]);
        // Nothing is believed of it.
        check(Profile::Monitor, "x\u{fffd}fw}", "");
    }

    #[test]
    fn a_disturbance_of_a_moment_is_not_said_and_a_stall_begins_anew() {
        let (mut watch, picture) = port(Profile::Hmi);
        watch.set(Stamp(0), 0, true, &picture);
        watch.noise(Stamp(1_000), 0);
        watch.noise(Stamp(1_500), 0);
        for now in [4_000, 5_000, 6_000, 9_000] {
            assert_eq!(watch.quiet(Stamp(now), 0, &picture), None);
        }
        let (mut silent, picture_of) = port(Profile::Gyro1);
        silent.set(Stamp(0), 0, true, &picture_of);
        silent.stalled(Stamp(9_000));
        assert_eq!(silent.quiet(Stamp(12_900), 0, &picture_of), None);
        assert!(silent.quiet(Stamp(13_000), 0, &picture_of).is_some());
        // Noise without the end of a line is counted nowhere yet, and said all the same.
        for second in 1..6 {
            silent.noise(Stamp(20_000 + second * 1_000), 0);
        }
        let said = silent.quiet(Stamp(25_500), 0, &picture_of);
        assert_eq!(said.as_deref(), Some("noise"));
    }

    // FB8: a port of which nobody has said that it is there is cabled inside, or not tried yet.
    #[test]
    fn one_alert_names_every_port_and_none_that_is_cabled_inside() {
        let (mut watch, picture) = port(Profile::Gyro1);
        assert_eq!(watch.gone(Stamp(0), &picture), None);
        assert_eq!(watch.no_sentence(Stamp(99_000), &picture), None);
        watch.set(Stamp(0), 0, false, &picture);
        let one = "one: gone. Check plug and device".to_string();
        assert_eq!(watch.gone(Stamp(0), &picture), Some(one));
        watch.set(Stamp(0), 1, false, &picture);
        let both = "one, two: gone. Check plug and device".to_string();
        assert_eq!(watch.gone(Stamp(0), &picture), Some(both));
        assert_eq!(
            watch.no_sentence(Stamp(9_000), &picture),
            None,
            "it is gone, not silent"
        );
        for port in 0..2 {
            watch.set(Stamp(10_000), port, true, &picture);
        }
        // It may go again at once; a sentence, or a second, says that it is there.
        watch.valid(Stamp(10_100), 0, (true, true), &picture);
        let two = "two: gone. Check plug and device".to_string();
        assert_eq!(watch.gone(Stamp(10_900), &picture), Some(two));
        assert_eq!(watch.gone(Stamp(11_000), &picture), None);
        let said = watch.no_sentence(Stamp(14_100), &picture).unwrap();
        let expect =
            "one: nothing is heard; two: nothing is heard. Check line, baud rate and device";
        assert_eq!(said, expect);
    }
}
