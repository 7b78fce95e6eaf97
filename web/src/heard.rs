//! The page's own fold of the lines: picture, log, track made good, and the comparison with the server's digest.
//!
//! **Invariant:** each line is folded once, in the order of its number; a hole makes the picture unknown until a new hello.

use crate::trail::Trail;
use std::collections::{BTreeMap, VecDeque};
use wheelover_core::geo::Plane;
use wheelover_core::nmea;
use wheelover_core::picture::{self, Picture};
use wheelover_core::route::foreign::{Before, Told};
use wheelover_core::station::{Direction, PortIndex, Profile};
use wheelover_core::time::Stamp;
use wheelover_core::view::{Hello, Line, Lines, Snapshot};

/// Whether the page's picture is the server's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Agreement {
    /// Not compared yet.
    #[default]
    Unknown,
    /// Equal at the last line compared.
    Agree,
    /// Different at the last line compared.
    Disagree,
}

/// The latest line of one sentence on one port in one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Latest {
    /// The line.
    pub line: Line,
    /// Milliseconds since the one before it; 0 for the first.
    pub period: u64,
}

/// Port, direction (heard first) and address without its talker.
pub type Lane = (PortIndex, bool, String);

/// How many lines before the hello a new page asks for: the way made good and the dialogue's start.
const BACKLOG: u64 = 3_000;
/// How many lines the log keeps.
const LOG: usize = 300;
/// A place that is only heard, of a time before the hello, is drawn when it has lasted for so long, milliseconds.
const LASTS: u64 = 10_000;

/// What the page has made of the lines.
#[derive(Debug, Default)]
pub struct Fold {
    /// The picture.
    pub picture: Picture,
    /// The latest lines, oldest first.
    pub log: VecDeque<Line>,
    /// The latest line of each sentence.
    pub latest: BTreeMap<Lane, Latest>,
    /// The track made good.
    pub trail: Trail,
    /// Own facts say where the ship is believed to be.
    believes: bool,
    /// Seconds of the day that a position receiver said, and when it said so.
    pub utc: Option<(f64, Stamp)>,
    /// Whether the server agrees.
    pub agreement: Agreement,
    /// Number of the last line folded into the picture.
    pub folded: u64,
    /// Number of the last line seen, folded or only logged.
    pub seen: u64,
    /// Server time of the last line.
    pub line_at: Stamp,
    awaited: VecDeque<(u64, String)>,
    /// What must be remembered of a foreign chart system.
    before: Before,
}

impl Fold {
    /// Takes the server's picture. Gives back the number of the first line still wanted.
    pub fn greet(&mut self, hello: &Hello) -> u64 {
        if hello.line < self.seen || self.picture.ports != hello.picture.ports {
            *self = Self::default();
        }
        self.picture = hello.picture.clone();
        self.believes = hello.station == "autopilot";
        self.folded = hello.line;
        self.line_at = Stamp(hello.at);
        self.agreement = Agreement::Unknown;
        self.awaited.clear();
        if self.seen == 0 {
            hello.line.saturating_sub(BACKLOG) + 1
        } else {
            self.seen + 1
        }
    }

    /// Folds what is new. False where lines are missing, so that the picture is not to be believed.
    pub fn lines(&mut self, lines: &Lines) -> bool {
        for line in &lines.lines {
            let Line {
                seq: sequence,
                at,
                port,
                dir,
                text,
            } = line;
            if *sequence <= self.seen {
                continue;
            }
            if *sequence > self.folded + 1 {
                return false;
            }
            self.seen = *sequence;
            let bytes = latin1(text);
            let sentence = picture::decode(&bytes);
            let profile = self.picture.ports.get(*port).map(|port| port.profile);
            if *dir == Direction::In && profile == Some(Profile::Ecdis) {
                self.before.hear(Stamp(*at), *port, &sentence);
            }
            if *sequence == self.folded + 1 {
                self.picture
                    .fold_sentence(Stamp(*at), *port, *dir, &sentence);
                self.folded = *sequence;
                self.line_at = Stamp(*at);
                self.compare();
            }
            if *dir == Direction::In
                && let Some(gll) = nmea::Gll::from_sentence(&sentence)
            {
                self.utc = gll
                    .time
                    .map(|time| (time.seconds(), Stamp(*at)))
                    .or(self.utc);
                // Before the hello's picture: only the way that was made good.
                if *sequence < self.folded
                    && gll.status == Some(nmea::DataStatus::Valid)
                    && let Some(position) = gll.position
                {
                    self.trail.walk(Stamp(*at), position, LASTS);
                }
            }
            let lane = (*port, *dir == Direction::Out, lane_name(&sentence));
            self.keep(lane, line);
        }
        if let Some(fix) = self.picture.fix(self.line_at).filter(|_| !self.believes) {
            self.trail.walk(fix.at, fix.value.position, LASTS);
        }
        true
    }

    /// The path as a foreign chart system's sentences tell it (AP-23).
    #[must_use]
    pub fn told(&self, now: Stamp, plane: &Plane) -> Told {
        Told::of(&self.picture, &self.before, now, plane)
    }

    /// Takes the believed place. Remembers the server's digest, or compares at once where the fold stands there.
    pub fn snapshot(&mut self, snapshot: &Snapshot) {
        if let Some(place) = snapshot.own.as_ref().and_then(|own| own.position) {
            self.trail.walk(Stamp(snapshot.at), place, 0);
        }
        if snapshot.line >= self.folded {
            self.awaited
                .push_back((snapshot.line, snapshot.digest.clone()));
            while self.awaited.len() > 20 {
                self.awaited.pop_front();
            }
            self.compare();
        }
    }

    fn compare(&mut self) {
        while let Some((line, digest)) = self.awaited.front() {
            if *line > self.folded {
                return;
            }
            if *line == self.folded {
                let agree = *digest == self.picture.digest();
                self.agreement = if agree {
                    Agreement::Agree
                } else {
                    Agreement::Disagree
                };
            }
            self.awaited.pop_front();
        }
    }

    fn keep(&mut self, lane: Lane, line: &Line) {
        let period = self
            .latest
            .get(&lane)
            .map_or(0, |latest| line.at.saturating_sub(latest.line.at));
        if self.latest.len() < 200 || self.latest.contains_key(&lane) {
            self.latest.insert(
                lane,
                Latest {
                    line: line.clone(),
                    period,
                },
            );
        }
        self.log.push_back(line.clone());
        while self.log.len() > LOG {
            self.log.pop_front();
        }
    }
}

/// The bytes of a line that travelled as Latin-1.
#[must_use]
pub fn latin1(text: &str) -> Vec<u8> {
    text.chars()
        .map(|letter| u8::try_from(u32::from(letter)).unwrap_or(b'?'))
        .collect()
}

/// The address without its talker, or what stands for it.
fn lane_name(sentence: &nmea::Sentence<'_>) -> String {
    match (sentence.talker(), sentence.formatter) {
        (_, "") => "?".to_owned(),
        // A maker's sentences are told apart by their first field.
        ("P", maker) if !maker.contains(',') => {
            format!(
                "{maker},{}",
                String::from_utf8_lossy(sentence.fields.get(1))
            )
        }
        (_, formatter) => formatter.to_owned(),
    }
}
