//! The dialogue with the other system, checked as it runs (CON-2): beside the control path, nothing steers by it.
//!
//! In: the lines that pages are told. Out: `/api/dialogue`, and a line in the log for each rule that is broken, at most
//! once a minute.

use std::collections::BTreeMap;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use wheelover_core::conformance::{Breach, Found, Live};
use wheelover_core::station::{PortSetup, Profile};
use wheelover_core::view::Line;

/// A rule that is broken again and again is not said more often.
const AGAIN: Duration = Duration::from_secs(60);

/// The checker of the dialogue.
#[derive(Debug)]
pub(crate) struct Dialogue {
    /// The port with the other system; none where there is none.
    port: Option<usize>,
    running: Mutex<Running>,
}

#[derive(Debug, Default)]
struct Running {
    live: Live,
    said: BTreeMap<String, Instant>,
}

impl Dialogue {
    /// The dialogue on the first of a station's ports that leads to a chart system, or to an autopilot.
    pub(crate) fn on(ports: &[PortSetup]) -> Self {
        let leads = |port: &PortSetup| port.profile == Profile::Ecdis;
        Self {
            port: ports.iter().position(leads),
            running: Mutex::default(),
        }
    }

    /// Takes lines of all ports.
    pub(crate) fn hear(&self, lines: &[Line]) {
        let mut running = self.running();
        for line in lines.iter().filter(|line| Some(line.port) == self.port) {
            let text: Vec<u8> = line.text.chars().map(|c| c as u8).collect();
            let at = line.at as f64 / 1_000.0;
            let found = running.live.take(line.seq, Some(at), &text);
            for breach in found {
                running.say(&breach);
            }
        }
    }

    /// What was found since the start.
    pub(crate) fn found(&self) -> Found {
        self.running().live.found()
    }

    fn running(&self) -> MutexGuard<'_, Running> {
        self.running.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Running {
    fn say(&mut self, breach: &Breach) {
        let now = Instant::now();
        let said = self.said.get(&breach.rule);
        if said.is_some_and(|at| now.duration_since(*at) < AGAIN) {
            return;
        }
        self.said.insert(breach.rule.clone(), now);
        tracing::info!(
            "dialogue, line {}: {}: {}",
            breach.line,
            breach.rule,
            breach.text
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wheelover_core::nmea::with_checksum;
    use wheelover_core::station::{ChecksumPolicy, Direction};

    fn port(name: &str, profile: Profile) -> PortSetup {
        PortSetup {
            name: name.to_owned(),
            profile,
            checksum: ChecksumPolicy::Required,
            talkers: Vec::new(),
            baud: 0,
            output: false,
        }
    }

    // CON-2
    #[test]
    fn only_the_port_of_the_other_system_is_checked() {
        let ports = [port("gyro1", Profile::Gyro1), port("ecdis", Profile::Ecdis)];
        let dialogue = Dialogue::on(&ports);
        let line = |seq: u64, port: usize| Line {
            seq,
            at: seq * 1_000,
            port,
            dir: Direction::In,
            text: with_checksum("EIHTC,V,,,T,N,,,,,,,245.0,T,C"),
        };
        dialogue.hear(&[line(1, 0), line(2, 0)]);
        assert_eq!(dialogue.found().lines, 0);
        dialogue.hear(&[line(3, 1), line(4, 1), line(5, 1)]);
        let found = dialogue.found();
        assert_eq!(found.lines, 3);
        assert!(found.rules.contains_key("TCS-1"), "{found:?}");
    }
}
