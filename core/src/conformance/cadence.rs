//! Cadence: each sentence with the period of the table of talk, 0.8 to 1.2 of it, no gap over 1.5 of it, none missing (CON-1).

use super::report::Report;
use crate::talk::Row;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Longest gap, in periods.
const GAP: f64 = 1.5;
/// Mean intervals that are allowed, in periods, over so many of them.
const MEAN: (f64, f64) = (0.8, 1.2);
const INTERVALS: usize = 4;
/// Two of one sentence within this part of its period are one too many.
const TWICE: f64 = 0.4;

/// Period of a sentence that comes by the clock, seconds.
fn period_s(row: &Row) -> Option<f64> {
    Some(row.period_ms()? as f64 / 1000.0)
}

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

    /// Reports what has not come in time or comes too often, each once: of all that may come, some is needed.
    pub(super) fn judge(
        &mut self,
        now: f64,
        all: &[Row],
        needed: impl Fn(&Row) -> bool,
        report: &mut Report<'_>,
    ) {
        let Some(began) = self.began else { return };
        for row in all.iter().filter(|row| needed(row)) {
            let Some(period) = period_s(row) else {
                continue;
            };
            let formatter = row.formatter();
            let known = self.knows(formatter);
            let reported = self.never.iter().any(|never| never == formatter);
            if !known && !reported && now - began > GAP * period {
                self.never.push(formatter.into());
                report.breach("CON-1", format!("{formatter} is missing"));
            }
        }
        for beat in &mut self.beats {
            let row = all.iter().find(|row| row.formatter() == beat.formatter);
            let Some((row, period)) = row.and_then(|row| Some((row, period_s(row)?))) else {
                continue;
            };
            let needed = needed(row);
            let (gap, twice) = (GAP * period, TWICE * period);
            let since = now - beat.last;
            if needed && !beat.missing && since > gap {
                beat.missing = true;
                let text = format!(
                    "{}: nothing for {since:.1} s, at most {gap} s",
                    beat.formatter
                );
                report.breach("CON-1", text);
            }
            if !core::mem::take(&mut beat.fresh) {
                continue;
            }
            // A late sentence that has just come shows its gap in the interval.
            let interval = beat.intervals.last().copied().unwrap_or(period);
            if needed && interval > gap {
                let text = format!(
                    "{}: a gap of {interval:.1} s, at most {gap} s",
                    beat.formatter
                );
                report.breach("CON-1", text);
                beat.intervals.clear();
            } else if interval < twice {
                let text = format!("{} again after {interval:.2} s", beat.formatter);
                report.breach("CON-1", text);
                beat.intervals.clear();
            }
            if beat.intervals.len() < INTERVALS {
                continue;
            }
            let mean = beat.intervals.iter().sum::<f64>() / INTERVALS as f64;
            let (least, most) = (MEAN.0 * period, MEAN.1 * period);
            let astray = !(least..=most).contains(&mean);
            if astray && !beat.astray {
                let text = format!(
                    "{}: period {mean:.2} s, not {least} to {most} s",
                    beat.formatter
                );
                report.breach("CON-1", text);
            }
            beat.astray = astray;
        }
    }
}
