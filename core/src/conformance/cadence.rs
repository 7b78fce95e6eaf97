//! Cadence: a period of 0.8 to 1.2 s, no gap over 1.5 s, no sentence missing (CON-1).

use super::report::Report;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Longest gap, seconds.
const GAP_S: f64 = 1.5;
/// Periods that are allowed, seconds, over so many intervals.
const PERIOD_S: (f64, f64) = (0.8, 1.2);
const INTERVALS: usize = 4;
/// Two of one sentence within this time are one too many, seconds.
const TWICE_S: f64 = 0.4;

/// How one sentence comes.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Beat {
    formatter: String,
    last: f64,
    intervals: Vec<f64>,
    /// The gap was reported.
    missing: bool,
    /// The period was reported.
    astray: bool,
    /// The last interval waits to be judged.
    fresh: bool,
}

/// How the sentences of one direction come.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Cadence {
    began: Option<f64>,
    beats: Vec<Beat>,
    never: Vec<String>,
}

impl Cadence {
    pub(super) fn heard(&mut self, now: f64, formatter: &str) {
        self.began.get_or_insert(now);
        let Some(beat) = self
            .beats
            .iter_mut()
            .find(|beat| beat.formatter == formatter)
        else {
            self.never.retain(|never| never != formatter);
            self.beats.push(Beat {
                formatter: formatter.into(),
                last: now,
                intervals: Vec::new(),
                missing: false,
                astray: false,
                fresh: false,
            });
            return;
        };
        if beat.missing {
            beat.intervals.clear();
        } else {
            beat.intervals.push(now - beat.last);
            beat.fresh = true;
        }
        if beat.intervals.len() > INTERVALS {
            beat.intervals.remove(0);
        }
        beat.last = now;
        beat.missing = false;
    }

    pub(super) fn knows(&self, formatter: &str) -> bool {
        self.beats.iter().any(|beat| beat.formatter == formatter)
    }

    pub(super) fn last(&self, formatter: &str) -> Option<f64> {
        self.beats
            .iter()
            .find(|beat| beat.formatter == formatter)
            .map(|beat| beat.last)
    }

    /// Reports what has not come in time or comes too often, each once.
    pub(super) fn judge(&mut self, now: f64, needed: &[&str], report: &mut Report<'_>) {
        let Some(began) = self.began else { return };
        for formatter in needed {
            let known = self.knows(formatter);
            let reported = self.never.iter().any(|never| never == formatter);
            if !known && !reported && now - began > GAP_S {
                self.never.push((*formatter).into());
                report.breach("CON-1", format!("{formatter} is missing"));
            }
        }
        for beat in &mut self.beats {
            let needed = needed.contains(&beat.formatter.as_str());
            let since = now - beat.last;
            if needed && !beat.missing && since > GAP_S {
                beat.missing = true;
                let text = format!(
                    "{}: nothing for {since:.1} s, at most {GAP_S} s",
                    beat.formatter
                );
                report.breach("CON-1", text);
            }
            if !core::mem::take(&mut beat.fresh) {
                continue;
            }
            // A late sentence that has just come shows its gap in the interval.
            let interval = beat.intervals.last().copied().unwrap_or(1.0);
            if needed && interval > GAP_S {
                let text = format!(
                    "{}: a gap of {interval:.1} s, at most {GAP_S} s",
                    beat.formatter
                );
                report.breach("CON-1", text);
                beat.intervals.clear();
            } else if interval < TWICE_S {
                let text = format!("{} again after {interval:.2} s", beat.formatter);
                report.breach("CON-1", text);
                beat.intervals.clear();
            }
            if beat.intervals.len() < INTERVALS {
                continue;
            }
            let mean = beat.intervals.iter().sum::<f64>() / INTERVALS as f64;
            let astray = !(PERIOD_S.0..=PERIOD_S.1).contains(&mean);
            if astray && !beat.astray {
                let text = format!(
                    "{}: period {mean:.2} s, not {} to {} s",
                    beat.formatter, PERIOD_S.0, PERIOD_S.1
                );
                report.breach("CON-1", text);
            }
            beat.astray = astray;
        }
    }
}
