//! The autopilot's side: HTD, RSA and ROR against what was commanded.

use super::chart::{ChartRules, LastCommand};
use super::report::Report;
use crate::nmea::{
    DataStatus, Htd, LimitStatus, OverrideStatus, Ror, Sentence, SteeringMode, TurnMode,
};
use crate::units::wrap_180;
use alloc::format;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// The autopilot answers a change within this time, seconds (CON-1).
const ANSWER_S: f64 = 2.0;
/// HTC may be missing for so long before HTD must have left AutoNAV: 5 s, one report, its gap (TCS-8).
const FAIL_S: f64 = 7.0;
/// A radius and an angle as they come back.
const SAME_NM: f64 = 0.006;
const SAME_DEG: f64 = 0.06;

/// The rules on the autopilot.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct AutopilotRules {
    mode: Option<SteeringMode>,
    /// When the mode was first reported.
    since: f64,
    last: Option<f64>,
    htd: Htd,
    /// Line and time of the last HTD.
    line: u64,
    at: Option<f64>,
    /// Breaches that last are reported once.
    told: [bool; 8],
}

/// Breaches that last.
#[derive(Clone, Copy)]
enum Lasting {
    Radius,
    Track,
    TurnMode,
    Stopped,
    Silent,
    Reference,
    Override,
    Order,
}

impl AutopilotRules {
    fn lasting(
        &mut self,
        which: Lasting,
        breach: bool,
        rule: &str,
        text: impl FnOnce() -> String,
        report: &mut Report<'_>,
    ) {
        let told = &mut self.told[which as usize];
        if breach && !*told {
            report.breach(rule, text());
        }
        *told = breach;
    }

    fn engaged(&self) -> bool {
        matches!(
            self.mode,
            Some(SteeringMode::TrackControl | SteeringMode::HeadingControl)
        )
    }

    pub(super) fn heard(&mut self, clock: f64, sentence: &Sentence<'_>, report: &mut Report<'_>) {
        if let Some(htd) = Htd::from_sentence(sentence) {
            if htd.steering_mode != self.mode {
                self.mode = htd.steering_mode;
                self.since = clock;
            }
            self.last = Some(clock);
            (self.line, self.at) = (report.line, report.at);
            by_mode(&htd, report);
            self.htd = htd;
        } else if let Some(ror) = Ror::from_sentence(sentence) {
            let order = ror.starboard.is_some() || ror.starboard_status == Some(DataStatus::Valid);
            if self.mode == Some(SteeringMode::Manual)
                && order
                && self.htd.override_status == Some(OverrideStatus::NotInUse)
            {
                report.breach("AP-1", "ROR carries an order in stand-by");
            }
            let valid = ror.starboard.is_some() && ror.starboard_status == Some(DataStatus::Valid);
            self.lasting(
                Lasting::Order,
                self.engaged() && !valid,
                "AP-4",
                || "ROR without a valid starboard order in AutoNAV".into(),
                report,
            );
        }
    }

    /// What was commanded against what was last reported; once a burst is complete, so that an answer is never
    /// taken for a mistake because it was quicker than the rest of the burst.
    pub(super) fn judge(&mut self, clock: f64, chart: &ChartRules, report: &mut Report<'_>) {
        let Some(commanded) = chart.commanded() else {
            return;
        };
        if self.last.is_none_or(|last| clock - last > 1.5) {
            return;
        }
        let report = &mut Report {
            at: self.at,
            line: self.line,
            situation: report.situation,
            breaches: report.breaches,
        };
        let htd = self.htd.clone();
        let htc = &commanded.htc;
        let reference = matches!((htc.reference, htd.reference), (Some(a), Some(b)) if a != b);
        self.lasting(
            Lasting::Reference,
            reference,
            "CON-1",
            || "HTC and HTD differ in their heading reference".into(),
            report,
        );
        self.left(clock, commanded, report);
        let following = self.mode == Some(SteeringMode::TrackControl)
            && htc.steering_mode == Some(SteeringMode::TrackControl);
        let settled = |since: f64| clock - since.max(self.since) > ANSWER_S;
        let radius = following
            && settled(commanded.radius_since)
            && htc.radius.is_some_and(|radius| {
                htd.radius
                    .is_none_or(|echo| libm::fabs(radius - echo) > SAME_NM)
            });
        let turn_mode = if htc.radius.is_some() {
            TurnMode::Radius
        } else {
            TurnMode::NotControlled
        };
        let turn_wrong =
            following && settled(commanded.radius_since) && htd.turn_mode != Some(turn_mode);
        let track = following
            && settled(commanded.track_since)
            && htc.track.is_some_and(|track| {
                htd.track
                    .is_none_or(|echo| libm::fabs(wrap_180(track - echo)) > SAME_DEG)
            });
        self.lasting(
            Lasting::Radius,
            radius,
            "TCS-4",
            || "HTD does not echo the commanded radius within 2 s".into(),
            report,
        );
        let wanted = turn_mode.letter();
        self.lasting(
            Lasting::TurnMode,
            turn_wrong,
            "AP-2",
            || format!("HTD turn mode must be {wanted} here"),
            report,
        );
        self.lasting(
            Lasting::Track,
            track,
            "AP-2",
            || "HTD does not carry the commanded track within 2 s".into(),
            report,
        );
    }

    /// HTC-1, TCS-9, TCS-10: what ends AutoNAV.
    fn left(&mut self, clock: f64, commanded: &LastCommand, report: &mut Report<'_>) {
        let late = clock - commanded.mode_since > ANSWER_S;
        let (rule, cause) = match commanded.htc.steering_mode {
            Some(SteeringMode::StandAlone) => ("TCS-10", "S"),
            Some(SteeringMode::Manual) => ("TCS-9", "M"),
            Some(SteeringMode::RudderControl) => ("TCS-9", "R"),
            _ => ("", ""),
        };
        let stays = late && self.engaged() && !rule.is_empty();
        self.lasting(
            Lasting::Stopped,
            stays,
            rule,
            || format!("HTD stays in AutoNAV after HTC mode {cause}"),
            report,
        );
        let overridden = commanded.htc.override_status == Some(OverrideStatus::InUse) && late;
        let ignores = overridden && self.mode != Some(SteeringMode::Manual);
        self.lasting(
            Lasting::Override,
            ignores,
            "HTC-1",
            || "HTD is not M while override is in use".into(),
            report,
        );
    }

    /// TCS-8: HTC has not come for too long.
    pub(super) fn silence(&mut self, now: f64, htc: Option<f64>, report: &mut Report<'_>) {
        let silent = htc.is_some_and(|at| now - at > FAIL_S)
            && self.engaged()
            && self.last.is_some_and(|last| now - last < 1.5);
        self.lasting(
            Lasting::Silent,
            silent,
            "TCS-8",
            || "HTD stays in AutoNAV without HTC".into(),
            report,
        );
    }
}

/// The fields of HTD by mode (AP-1 to AP-5).
fn by_mode(htd: &Htd, report: &mut Report<'_>) {
    let mut null = |value: Option<f64>, rule: &str, field: &str, mode: &str| {
        if value.is_some() {
            report.breach(rule, format!("HTD {field} must be null in mode {mode}"));
        }
    };
    match htd.steering_mode {
        Some(SteeringMode::Manual) => {
            for (value, field) in [
                (htd.rudder_angle, "rudder angle"),
                (htd.radius, "radius"),
                (htd.rate_of_turn, "rate of turn"),
                (htd.heading_to_steer, "heading to steer"),
                (htd.track, "track"),
            ] {
                null(value, "AP-1", field, "M");
            }
        }
        Some(SteeringMode::StandAlone) => {
            null(htd.heading_to_steer, "AP-1", "heading to steer", "S");
            null(htd.track, "AP-1", "track", "S");
        }
        Some(SteeringMode::HeadingControl) => null(htd.radius, "AP-3", "radius", "H"),
        _ => {}
    }
    let mut needed = |value: Option<f64>, rule: &str, field: &str| {
        if value.is_none() {
            report.breach(rule, format!("HTD without {field} in AutoNAV"));
        }
    };
    match htd.steering_mode {
        Some(SteeringMode::TrackControl) => {
            needed(htd.heading_to_steer, "AP-2", "heading to steer");
            needed(htd.track, "AP-2", "track");
        }
        Some(SteeringMode::HeadingControl) => {
            needed(htd.heading_to_steer, "AP-3", "heading to steer")
        }
        _ => {}
    }
    if htd.steering_mode == Some(SteeringMode::HeadingControl)
        && !matches!(
            htd.turn_mode,
            Some(TurnMode::Rate | TurnMode::NotControlled)
        )
    {
        report.breach("AP-3", "HTD turn mode must be T or N in mode H");
    }
    let at_limit = matches!((htd.rudder_angle, htd.rudder_limit), (Some(order), Some(limit)) if libm::fabs(order) >= limit);
    if at_limit && htd.rudder_status == Some(LimitStatus::Within) {
        report.breach("AP-5", "HTD rudder status must be V at the limit");
    }
}
