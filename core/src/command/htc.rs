//! SEN-5: the only way an HTC becomes a command. Decoding is lenient, obeying is strict.

use super::refusal::Refusal;
use crate::nmea::{
    CommandStatus, FaultKind, Htc, OverrideStatus, Reference, Sentence, SteeringMode, TurnMode,
};
use crate::units::{Course, Distance, Heading, Radius, RateOfTurn};
use alloc::format;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// What an HTC asks for, once it may be obeyed: everything that its mode needs is there (table A.20).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Remote {
    /// The override is in use: the modes are ignored (HTC-1).
    Override,
    /// The chart system does not control: mode M, S or R.
    Stop(SteeringMode),
    /// Mode H, "Tn": a heading.
    Heading {
        /// Heading to steer, field 10.
        hts: Heading,
        /// Commanded track, field 12; the heading where it is null.
        track: Course,
        /// Commanded rate of turn, field 9, with turn mode T only (AP-3, TCS-7).
        rate: Option<RateOfTurn>,
    },
    /// Mode T, "Ti": a track.
    Track {
        /// Commanded track, field 12.
        track: Course,
        /// Commanded radius, field 8, from wheel-over to the end of the turn.
        radius: Option<Radius>,
        /// Off-track limit, field 11.
        off_track_limit: Option<Distance>,
    },
}

fn refuse<T>(field: impl Into<Option<u8>>, text: impl Into<String>) -> Result<T, Refusal> {
    Err(Refusal {
        field: field.into(),
        text: text.into(),
    })
}

/// Fields that steering does not use; their faults are shown and do not refuse (SEN-5).
const UNUSED: [u8; 5] = [2, 3, 6, 7, 11];

/// The command of an HTC, or why it is not obeyed.
///
/// ```
/// use wheelover_core::command::{Remote, htc};
/// use wheelover_core::nmea::{decode, with_checksum};
/// let line = with_checksum("EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C");
/// let command = htc(&decode(line.as_bytes()), false).expect("a command");
/// assert!(matches!(command, Remote::Track { radius: Some(_), .. }));
/// let short = with_checksum("EIHTC,V,,,T,R,,,0.35,,,280.0,T,C");
/// assert!(htc(&decode(short.as_bytes()), false).is_err());
/// ```
///
/// `accept_null_status`: whether this port takes a null field 14 for a command. Mode R is left to the caller (HTC-4).
///
/// # Errors
/// Another formatter, a checksum that is missing or wrong, another number of fields than SEN-5 allows, a fault in a
/// used field, a status other than C, another heading reference, a mode without what it needs.
pub fn htc(sentence: &Sentence<'_>, accept_null_status: bool) -> Result<Remote, Refusal> {
    let Some(htc) = Htc::from_sentence(sentence) else {
        return refuse(None, "not an HTC");
    };
    if !sentence.checksum.is_right() {
        return refuse(None, "checksum missing or wrong");
    }
    if sentence.text.first() != Some(&b'$') {
        return refuse(None, "does not begin with $");
    }
    let count = sentence.fields.len();
    match count {
        14.. => {}
        13 if accept_null_status => {}
        13 => return refuse(None, "13 fields, the status is missing"),
        _ => return refuse(None, format!("{count} fields, there should be 14")),
    }
    for fault in sentence.faults() {
        match fault.field {
            // With extra fields, 1 to 14 must be free of faults.
            Some(field) if field > 14 => {}
            Some(field) if UNUSED.contains(&field) && count <= 14 => {}
            Some(field) => return refuse(field, fault.text()),
            None if matches!(fault.kind, FaultKind::FieldCount { .. }) => {}
            None => return refuse(None, fault.text()),
        }
    }
    match htc.status {
        Some(CommandStatus::Command) => {}
        Some(CommandStatus::Report) => return refuse(14, "a status report, not a command"),
        None if accept_null_status => {}
        None => return refuse(14, "the status is null, not a command"),
    }
    let Some(override_status) = htc.override_status else {
        return refuse(1, "no override status");
    };
    // F1 note 1: with the override in use both modes are ignored.
    if override_status == OverrideStatus::InUse {
        return Ok(Remote::Override);
    }
    if htc.reference == Some(Reference::Magnetic) {
        return refuse(13, "its reference is magnetic, the autopilot's is true");
    }
    let Some(mode) = htc.steering_mode else {
        return refuse(4, "no steering mode");
    };
    let Some(turn_mode) = htc.turn_mode else {
        return refuse(5, "no turn mode");
    };
    match mode {
        SteeringMode::HeadingControl => heading_control(&htc, turn_mode),
        SteeringMode::TrackControl => track_control(&htc),
        SteeringMode::Manual | SteeringMode::StandAlone | SteeringMode::RudderControl => {
            Ok(Remote::Stop(mode))
        }
    }
}

fn heading_control(htc: &Htc, turn_mode: TurnMode) -> Result<Remote, Refusal> {
    let Some(hts) = htc.heading_to_steer.map(Heading::from_deg) else {
        return refuse(10, "no heading to steer");
    };
    let rate = match (turn_mode, htc.rate_of_turn) {
        (TurnMode::Rate, None) => return refuse(9, "turn mode T, but no rate of turn"),
        (TurnMode::Rate, Some(rate)) => Some(RateOfTurn::from_deg_per_min(rate)),
        (TurnMode::Radius | TurnMode::NotControlled, _) => None,
    };
    Ok(Remote::Heading {
        hts,
        track: htc.track.map_or(hts.as_course(), Course::from_deg),
        rate,
    })
}

fn track_control(htc: &Htc) -> Result<Remote, Refusal> {
    let Some(track) = htc.track.map(Course::from_deg) else {
        return refuse(12, "no track");
    };
    Ok(Remote::Track {
        track,
        radius: htc.radius.map(Radius::from_nm),
        off_track_limit: htc.off_track_limit.map(Distance::from_nm),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nmea::{decode, with_checksum};

    fn check(body: &str, expect: Result<Remote, Option<u8>>) {
        let line = with_checksum(body);
        let outcome = htc(&decode(line.as_bytes()), true).map_err(|refusal| refusal.field);
        assert_eq!(outcome, expect, "{body}");
    }

    fn turning() -> Result<Remote, Option<u8>> {
        Ok(Remote::Track {
            track: Course::from_deg(280.0),
            radius: Some(Radius::from_nm(0.35)),
            off_track_limit: None,
        })
    }

    #[test]
    fn field_count_decides_first() {
        check(
            "EIHTC,V,,,S,N,,,,,,,,T,C",
            Ok(Remote::Stop(SteeringMode::StandAlone)),
        );
        check("EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C", turning());
        check("EIHTC,V,,,T,R,,,0.35,,,,280.0,T", turning());
        check("EIHTC,V,,,T,R,,,0.35,,,,280.0,T,", turning());
        check("EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C,", turning());
        check("EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C,x", turning());
    }

    #[test]
    fn short_forms_of_the_document_never_steer() {
        check("EIHTC,V,,,S,N,,,,,,T,C", Err(None));
        check("EIHTC,V,,,T,R,,,,,245.0,T,C", Err(None));
        check("EIHTC,V,,,T,R,,,0.35,,,280.0,T,C", Err(Some(12)));
        check("EIHTC,V,,,H,T,,,028,345.4,,355.0,T,C", Err(Some(12)));
    }

    #[test]
    fn a_fault_refuses_unless_the_field_is_unused() {
        check("EIHTC,V,999,R,T,R,x,-5,0.35,,,y,280.0,T,C", turning());
        check("EIHTC,V,999,R,T,R,,,0.35,,,,280.0,T,C,x", Err(Some(2)));
        check("EIHTC,V,,,T,R,,,-0.35,,,,280.0,T,C", Err(Some(8)));
        check("EIHTC,V,,,T,R,,,0.35,,,,361.0,T,C", Err(Some(12)));
        check("EIHTC,V,,,Q,R,,,0.35,,,,280.0,T,C", Err(Some(4)));
        check("EIHTC,V,,,T,R,,,0.35,,,,280.0,G,C", Err(Some(13)));
        check("EIHTC,V,,,T,R,,,0.35,,,,280.0,T,R", Err(Some(14)));
        check("EIHTC,V,,,T,R,,,0.35,,,,280.0,T,X", Err(Some(14)));
        check("EIHTC,,,,T,R,,,0.35,,,,280.0,T,C", Err(Some(1)));
    }

    #[test]
    fn checksum_and_null_status() {
        let line = with_checksum("EIHTC,V,,,T,R,,,0.35,,,,280.0,T,");
        assert_eq!(
            htc(&decode(line.as_bytes()), false).map_err(|refusal| refusal.field),
            Err(Some(14))
        );
        let line = b"$EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C";
        assert!(htc(&decode(line), true).is_err());
        let line = b"$EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C*00";
        assert!(htc(&decode(line), true).is_err());
    }

    // HTC 13; a mode without what it needs
    #[test]
    fn what_a_mode_needs_must_be_there() {
        let tn = |rate: Option<f64>| {
            Ok(Remote::Heading {
                hts: Heading::from_deg(345.4),
                track: Course::from_deg(355.0),
                rate: rate.map(RateOfTurn::from_deg_per_min),
            })
        };
        check("EIHTC,V,,,H,T,,,,28.0,345.4,,355.0,T,C", tn(Some(28.0)));
        check("EIHTC,V,,,H,N,,,,28.0,345.4,,355.0,T,C", tn(None));
        check("EIHTC,V,,,H,T,,,,,345.4,,355.0,T,C", Err(Some(9)));
        check("EIHTC,V,,,H,N,,,,,,,355.0,T,C", Err(Some(10)));
        check("EIHTC,V,,,T,R,,,0.35,,,,,T,C", Err(Some(12)));
        check("EIHTC,V,,,T,R,,,0.35,,,,280.0,M,C", Err(Some(13)));
        check("EIHTC,V,,,T,R,,,0.35,,,,280.0,,C", turning());
        check("EIHTC,A,,,,,,,,,,,,M,C", Ok(Remote::Override));
    }
}
