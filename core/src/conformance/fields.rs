//! The rules on the fields of one burst by themselves: which are null, which go together.

use super::report::{Burst, Report};
use crate::nmea::{CommandStatus, DataStatus, Htc, OverrideStatus, TurnMode};
use crate::units::wrap_180;
use alloc::format;

/// Headings may differ by this much, degrees.
const SAME_DEG: f64 = 0.06;

/// TCS-3, FA5: status and mode indicator say the same.
pub(super) fn status(burst: &Burst, report: &mut Report<'_>) {
    if let Some(xte) = &burst.xte
        && xte.status == Some(DataStatus::Valid)
        && xte.mode.is_some_and(|mode| !mode.valid())
    {
        report.breach("TCS-3", "XTE: status A with a mode that is not valid");
    }
    if let (Some(xte), Some(gll)) = (&burst.xte, &burst.gll)
        && xte.status == Some(DataStatus::Valid)
        && gll.status == Some(DataStatus::Invalid)
    {
        report.breach("TCS-3", "XTE: status A while GLL has no valid position");
    }
}

/// Override and sentence status.
pub(super) fn header(htc: &Htc, report: &mut Report<'_>) {
    if htc.override_status == Some(OverrideStatus::InUse) {
        report.breach("HTC-1", "override is in use: track control is stopped");
    }
    if htc.status == Some(CommandStatus::Report) {
        report.breach("CON-1", "HTC is a status report (R), no command");
    }
}

fn null(value: Option<f64>, rule: &str, text: &str, report: &mut Report<'_>) {
    if value.is_some() {
        report.breach(rule, text);
    }
}

pub(super) fn stand_alone(htc: &Htc, burst: &Burst, report: &mut Report<'_>) {
    if htc.turn_mode != Some(TurnMode::NotControlled) {
        report.breach("TCS-1", "turn mode must be N with mode S");
    }
    null(htc.radius, "TCS-1", "a radius with mode S", report);
    null(
        htc.rate_of_turn,
        "TCS-1",
        "a rate of turn with mode S",
        report,
    );
    null(
        htc.heading_to_steer,
        "TCS-1",
        "a heading to steer with mode S",
        report,
    );
    null(htc.track, "TCS-1", "a track with mode S", report);
    if let (Some(xte), Some(pney1), Some(pney2)) = (&burst.xte, &burst.pney1, &burst.pney2) {
        let nulls = [
            xte.cross_track.is_none(),
            pney1.cross_track.is_none(),
            pney2.waypoint.is_none(),
        ];
        if nulls.contains(&true) && nulls.contains(&false) {
            report.breach("TCS-2", "XTE, PNEY,001 and PNEY,002 are not null together");
        }
    }
}

/// TCS-12.
pub(super) fn heading_control(htc: &Htc, report: &mut Report<'_>) {
    null(htc.radius, "TCS-12", "a radius with mode H", report);
    if htc.heading_to_steer.is_none() {
        report.breach("TCS-12", "no heading to steer with mode H");
    }
    if htc.track.is_none() {
        report.breach("TCS-12", "no track with mode H");
    }
    match htc.turn_mode {
        Some(TurnMode::Rate) => {
            if htc.rate_of_turn.is_none() {
                report.breach("TCS-12", "turn mode T without a rate of turn");
            }
            if let (Some(hts), Some(track)) = (htc.heading_to_steer, htc.track)
                && libm::fabs(wrap_180(hts - track)) > SAME_DEG
            {
                let text =
                    format!("heading to steer {hts:.1} is not the track {track:.1} in a turn");
                report.breach("TCS-12", text);
            }
        }
        Some(TurnMode::NotControlled) => {}
        _ => report.breach("TCS-12", "turn mode must be T or N with mode H"),
    }
}

pub(super) fn track_control(htc: &Htc, report: &mut Report<'_>) {
    if htc.turn_mode != Some(TurnMode::Radius) {
        report.breach("TCS-1", "turn mode must be R with mode T");
    }
    null(
        htc.rate_of_turn,
        "TCS-1",
        "a rate of turn with mode T",
        report,
    );
    null(
        htc.heading_to_steer,
        "TCS-1",
        "a heading to steer with mode T",
        report,
    );
    if htc.track.is_none() {
        report.breach("TCS-1", "no track with mode T");
    }
}

/// A radius and its centre come and go together.
pub(super) fn centre(htc: &Htc, burst: &Burst, report: &mut Report<'_>) {
    let Some(pney2) = &burst.pney2 else { return };
    match (htc.radius, pney2.centre) {
        (Some(_), None) => report.breach("TCS-1", "a radius without its centre"),
        (None, Some(_)) => report.breach("TCS-1", "a centre without its radius"),
        _ => {}
    }
}
