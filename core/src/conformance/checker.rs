//! The checker of one dialogue: line by line, burst by burst (CON-1).

use super::autopilot::AutopilotRules;
use super::cadence::Cadence;
use super::chart::ChartRules;
use super::report::{Breach, Burst, Report, Span};
use crate::nmea::{self, FaultKind, Gll, Htc, Pney1, Pney2, Sentence, Xte};
use crate::station::{Profile, Role};
use crate::talk::{self, Row, Saying};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// What a station says by the clock on the line between chart system and autopilot.
pub(super) fn says(station: Role) -> &'static [Row] {
    talk::told(station, Profile::Ecdis)
}

/// Whether a station says a sentence there, by the clock and as itself; a heading that is passed on is not judged.
fn speaks(station: Role, formatter: &str) -> bool {
    says(station)
        .iter()
        .any(|row| row.formatter() == formatter && by_the_clock(row))
}

pub(super) fn by_the_clock(row: &Row) -> bool {
    // An autopilot that is no heading monitor for others says no HMR (N table A.6).
    row.period_ms().is_some() && row.talker.is_some() && row.saying != Saying::Hmr
}

/// Lines farther apart belong to different bursts, seconds.
const BURST_GAP_S: f64 = 0.25;

/// The checker of one dialogue.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Checker {
    chart: ChartRules,
    autopilot: AutopilotRules,
    chart_cadence: Cadence,
    autopilot_cadence: Cadence,
    burst: Burst,
    chart_talker: String,
    autopilot_talker: String,
    bursts: u64,
    line: u64,
    lines: u64,
    sentences: u64,
    breaches: u64,
    last: Option<f64>,
    spans: Vec<Span>,
}

impl Checker {
    /// A checker that has heard nothing.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes the next line; `at` in seconds, `number` as it is reported. Breaches go to `out`.
    pub fn take(&mut self, number: u64, at: Option<f64>, text: &[u8], out: &mut Vec<Breach>) {
        let before = out.len();
        self.lines += 1;
        self.line = number;
        if let (Some(now), Some(last)) = (at, self.last)
            && now < last - 1.0
        {
            // Another recording begins.
            self.close(out);
            self.chart_cadence = Cadence::default();
            self.autopilot_cadence = Cadence::default();
        }
        self.last = at.or(self.last);
        let sentence = nmea::decode(text);
        if !sentence.formatter.is_empty() {
            self.sentence(at, &sentence, out);
        }
        self.breaches += (out.len() - before) as u64;
    }

    /// The end of the dialogue: judges the last burst.
    pub fn finish(&mut self, out: &mut Vec<Breach>) {
        let before = out.len();
        self.close(out);
        if let Some(now) = self.last {
            self.silences(now, out);
        }
        self.breaches += (out.len() - before) as u64;
    }

    /// The situation in force; none in heading control and before the first HTC.
    #[must_use]
    pub const fn situation(&self) -> Option<u8> {
        self.chart.situation()
    }

    /// Each situation with its times, in order.
    #[must_use]
    pub fn spans(&self) -> &[Span] {
        &self.spans
    }

    /// Forgets all but the last situations, beside a dialogue that has no end.
    pub(super) fn forget(&mut self, kept: usize) {
        let gone = self.spans.len().saturating_sub(kept);
        self.spans.drain(..gone);
    }

    /// Number of lines taken.
    #[must_use]
    pub const fn lines(&self) -> u64 {
        self.lines
    }

    /// Number of sentences that belong to the dialogue.
    #[must_use]
    pub const fn sentences(&self) -> u64 {
        self.sentences
    }

    /// Number of breaches reported.
    #[must_use]
    pub const fn breaches(&self) -> u64 {
        self.breaches
    }

    fn sentence(&mut self, at: Option<f64>, sentence: &Sentence<'_>, out: &mut Vec<Breach>) {
        match sentence.formatter {
            "HTC" => self.chart_talker = sentence.talker().into(),
            "HTD" => self.autopilot_talker = sentence.talker().into(),
            _ => {}
        }
        let of_chart = speaks(Role::ChartSystem, sentence.formatter)
            && (sentence.talker() == self.chart_talker || sentence.talker() == "P");
        let of_autopilot = speaks(Role::Autopilot, sentence.formatter)
            && sentence.talker() == self.autopilot_talker;
        self.sentences += u64::from(of_chart || of_autopilot);
        if of_chart && self.ends_burst(at, sentence.formatter) {
            self.close(out);
        }
        let usable = self.frame(at, sentence, out);
        if let Some(now) = at {
            if usable && of_chart {
                self.chart_cadence.heard(now, sentence.formatter);
            }
            if usable && of_autopilot {
                self.autopilot_cadence.heard(now, sentence.formatter);
            }
            self.silences(now, out);
        }
        if of_chart {
            self.collect(at, sentence, usable);
        } else if of_autopilot && usable {
            let clock = self.clock(at);
            let mut report = self.report(at, out);
            self.autopilot.heard(clock, sentence, &mut report);
        }
    }

    /// Where breaches of this line are noted.
    fn report<'a>(&self, at: Option<f64>, breaches: &'a mut Vec<Breach>) -> Report<'a> {
        Report {
            at,
            line: self.line,
            situation: self.situation(),
            breaches,
        }
    }

    /// SEN-1, SEN-2, SEN-4, SEN-5, SEN-6. False where the sentence may not be used.
    fn frame(&self, at: Option<f64>, sentence: &Sentence<'_>, out: &mut Vec<Breach>) -> bool {
        let faults = sentence.faults();
        let mut report = self.report(at, out);
        for fault in &faults {
            let rule = match fault.kind {
                FaultKind::TooLong(_) => "SEN-1",
                FaultKind::BadChecksum { .. } | FaultKind::MissingChecksum(_) => "SEN-2",
                FaultKind::MissingPart => "SEN-4",
                FaultKind::FieldCount { .. } | FaultKind::ExtraField { .. } => "SEN-5",
                _ => "SEN-6",
            };
            report.breach(rule, format!("{}: {fault}", sentence.formatter));
        }
        let whole = |kind: &FaultKind| {
            matches!(
                kind,
                FaultKind::FieldCount { .. } | FaultKind::ExtraField { .. }
            )
        };
        sentence.checksum.is_right() && !faults.iter().any(|fault| whole(&fault.kind))
    }

    /// A new burst begins after a pause, or where a sentence comes again.
    fn ends_burst(&self, at: Option<f64>, formatter: &str) -> bool {
        let paused =
            matches!((at, self.burst.last), (Some(now), Some(last)) if now - last > BURST_GAP_S);
        paused || self.burst.heard.iter().any(|heard| heard == formatter)
    }

    fn collect(&mut self, at: Option<f64>, sentence: &Sentence<'_>, usable: bool) {
        let burst = &mut self.burst;
        if burst.heard.is_empty() {
            burst.line = self.line;
            burst.at = at;
        }
        burst.last = at;
        burst.heard.push(sentence.formatter.into());
        if !usable {
            return;
        }
        match sentence.formatter {
            "HTC" => {
                burst.line = self.line;
                burst.htc = Htc::from_sentence(sentence);
            }
            "XTE" => burst.xte = Xte::from_sentence(sentence),
            "PNEY,001" => burst.pney1 = Pney1::from_sentence(sentence),
            "PNEY,002" => burst.pney2 = Pney2::from_sentence(sentence),
            "GLL" => burst.gll = Gll::from_sentence(sentence),
            _ => {}
        }
    }

    /// Judges the burst that is complete.
    fn close(&mut self, out: &mut Vec<Breach>) {
        if self.burst.heard.is_empty() {
            return;
        }
        let burst = core::mem::take(&mut self.burst);
        self.bursts += 1;
        let clock = burst.at.unwrap_or(self.bursts as f64);
        self.chart.name(clock, &burst);
        let situation = self.chart.situation();
        match (self.spans.last_mut(), situation) {
            (Some(span), Some(now)) if span.situation == now => span.to = burst.at,
            (_, Some(situation)) => {
                self.spans.push(Span {
                    situation,
                    from: burst.at,
                    to: burst.at,
                });
            }
            (_, None) => {}
        }
        let mut report = Report {
            at: burst.at,
            line: burst.line,
            situation,
            breaches: out,
        };
        self.chart.judge(&burst, &mut report);
        self.autopilot.judge(clock, &self.chart, &mut report);
    }

    /// The checker's clock: the line's time, or a second for each burst.
    fn clock(&self, at: Option<f64>) -> f64 {
        at.unwrap_or(self.bursts as f64)
    }

    fn silences(&mut self, now: f64, out: &mut Vec<Breach>) {
        let situation = self.situation();
        let mut report = Report {
            at: Some(now),
            line: self.line,
            situation,
            breaches: out,
        };
        // In heading control only HTC is needed, and where the others were never sent (N 1.1, 1.2).
        let all = self.chart.tracking() || self.chart_cadence.knows("XTE");
        let all = all && !self.chart.heading_control();
        let needed = |row: &Row| all || row.saying == Saying::Htc;
        let (chart, autopilot) = (says(Role::ChartSystem), says(Role::Autopilot));
        self.chart_cadence.judge(now, chart, needed, &mut report);
        self.autopilot_cadence
            .judge(now, autopilot, by_the_clock, &mut report);
        self.autopilot
            .silence(now, self.chart_cadence.last("HTC"), &mut report);
    }
}
