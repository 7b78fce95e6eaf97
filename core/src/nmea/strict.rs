//! SEN-5: the only way an HTC becomes a command. Decoding is lenient, obeying is strict.

use super::fault::FaultKind;
use super::tables::Htc;
use super::{CommandStatus, OverrideStatus, Reference, Sentence, SteeringMode, TurnMode};
use alloc::format;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// An HTC that may be obeyed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct HtcCommand {
    /// The override is in use: track control is stopped (HTC-1), the modes are to be ignored.
    pub override_in_use: bool,
    /// Selected steering mode.
    pub mode: SteeringMode,
    /// Turn mode.
    pub turn_mode: TurnMode,
    /// Commanded radius of turn, nautical miles.
    pub radius: Option<f64>,
    /// Commanded rate of turn, degrees a minute.
    pub rate_of_turn: Option<f64>,
    /// Commanded heading to steer, degrees.
    pub heading_to_steer: Option<f64>,
    /// Commanded off-track limit, nautical miles.
    pub off_track_limit: Option<f64>,
    /// Commanded track, degrees.
    pub track: Option<f64>,
    /// Heading reference; none counts as the autopilot's own.
    pub reference: Option<Reference>,
}

/// Why an HTC is not obeyed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct HtcRefusal {
    /// The field; none where it is the whole line.
    pub field: Option<u8>,
    /// The reason, in an officer's words.
    pub text: String,
}

impl core::fmt::Display for HtcRefusal {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self.field {
            Some(field) => write!(f, "HTC field {field}: {}", self.text),
            None => write!(f, "HTC: {}", self.text),
        }
    }
}

fn refuse<T>(field: impl Into<Option<u8>>, text: impl Into<String>) -> Result<T, HtcRefusal> {
    Err(HtcRefusal {
        field: field.into(),
        text: text.into(),
    })
}

/// Fields that steering does not use; their faults are shown and do not refuse (SEN-5).
const UNUSED: [u8; 5] = [2, 3, 6, 7, 11];

/// The command of an HTC, or why it is not obeyed.
///
/// ```
/// use wheelover_core::nmea::{decode, steering, with_checksum};
/// let line = with_checksum("EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C");
/// let command = steering(&decode(line.as_bytes()), false).expect("a command");
/// assert_eq!((command.radius, command.track), (Some(0.35), Some(280.0)));
/// let short = with_checksum("EIHTC,V,,,T,R,,,0.35,,,280.0,T,C");
/// assert!(steering(&decode(short.as_bytes()), false).is_err());
/// ```
///
/// `accept_null_status`: whether this port takes a null field 14 for a command. Mode R is left to the caller (HTC-4).
///
/// # Errors
/// Another formatter, a checksum that is missing or wrong, another number of fields than SEN-5 allows, a fault in a
/// used field, a status other than C.
pub fn steering(
    sentence: &Sentence<'_>,
    accept_null_status: bool,
) -> Result<HtcCommand, HtcRefusal> {
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
    let override_in_use = match htc.override_status {
        Some(status) => status == OverrideStatus::InUse,
        None => return refuse(1, "no override status"),
    };
    // F1 note 1: with the override in use both modes are ignored.
    let mode = match htc.steering_mode {
        Some(mode) => mode,
        None if override_in_use => SteeringMode::Manual,
        None => return refuse(4, "no steering mode"),
    };
    let turn_mode = match htc.turn_mode {
        Some(mode) => mode,
        None if override_in_use => TurnMode::NotControlled,
        None => return refuse(5, "no turn mode"),
    };
    Ok(HtcCommand {
        override_in_use,
        mode,
        turn_mode,
        radius: htc.radius,
        rate_of_turn: htc.rate_of_turn,
        heading_to_steer: htc.heading_to_steer,
        off_track_limit: htc.off_track_limit,
        track: htc.track,
        reference: htc.reference,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nmea::{decode, with_checksum};

    fn check(body: &str, expect: Result<(SteeringMode, Option<f64>, Option<f64>), Option<u8>>) {
        let line = with_checksum(body);
        let outcome = steering(&decode(line.as_bytes()), true)
            .map(|c| (c.mode, c.radius, c.track))
            .map_err(|r| r.field);
        assert_eq!(outcome, expect, "{body}");
    }

    #[test]
    fn field_count_decides_first() {
        use SteeringMode::{StandAlone, TrackControl};
        check("EIHTC,V,,,S,N,,,,,,,,T,C", Ok((StandAlone, None, None)));
        check(
            "EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C",
            Ok((TrackControl, Some(0.35), Some(280.0))),
        );
        check(
            "EIHTC,V,,,T,R,,,0.35,,,,280.0,T",
            Ok((TrackControl, Some(0.35), Some(280.0))),
        );
        check(
            "EIHTC,V,,,T,R,,,0.35,,,,280.0,T,",
            Ok((TrackControl, Some(0.35), Some(280.0))),
        );
        check(
            "EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C,",
            Ok((TrackControl, Some(0.35), Some(280.0))),
        );
        check(
            "EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C,x",
            Ok((TrackControl, Some(0.35), Some(280.0))),
        );
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
        use SteeringMode::TrackControl;
        check(
            "EIHTC,V,999,R,T,R,x,-5,0.35,,,y,280.0,T,C",
            Ok((TrackControl, Some(0.35), Some(280.0))),
        );
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
            steering(&decode(line.as_bytes()), false).map_err(|r| r.field),
            Err(Some(14))
        );
        let line = b"$EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C";
        assert!(steering(&decode(line), true).is_err());
        let line = b"$EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C*00";
        assert!(steering(&decode(line), true).is_err());
    }
}
