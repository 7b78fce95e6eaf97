//! The only way an HSC becomes a command: a heading to steer in Tn (AP-13).

use super::{Refusal, Remote, Said};
use crate::nmea::{CommandStatus, Hsc, Sentence};
use crate::units::{Heading, wrap_180};
use alloc::format;

/// A true and a magnetic heading that are said together are the same one within so many degrees, by the variation.
const SAME_DEG: f64 = 3.0;

/// The command of an HSC, or why it is not obeyed. `north` brings a direction to the north of the compass in use, degrees;
/// absent where it takes a variation that is not known. `accept_null_status`: as of HTC.
///
/// # Errors
/// Another formatter, a checksum that is missing or wrong, a fault in a field, a status report, no heading of that north.
pub fn hsc(
    sentence: &Sentence<'_>,
    accept_null_status: bool,
    north: impl Fn(Said) -> Option<f64>,
) -> Result<Remote, Refusal> {
    let Some(hsc) = Hsc::from_sentence(sentence) else {
        return Err(Refusal::because("not an HSC"));
    };
    if !sentence.checksum.is_right() || sentence.text.first() != Some(&b'$') {
        return Err(Refusal::because("checksum missing or wrong"));
    }
    if let Some(fault) = sentence.faults().first() {
        return Err(Refusal {
            field: fault.field,
            text: fault.text(),
        });
    }
    let refuse = |field: u8, text: &str| {
        Err(Refusal {
            field: Some(field),
            text: text.into(),
        })
    };
    match hsc.status {
        Some(CommandStatus::Report) => return refuse(5, "a status report, not a command"),
        None if sentence.fields.len() > 4 && !accept_null_status => {
            return refuse(5, "the status is null, not a command");
        }
        Some(CommandStatus::Command) | None => {}
    }
    let of = |degrees: Option<f64>, magnetic: bool| {
        let degrees = degrees?;
        north(Said { degrees, magnetic })
    };
    let said = [of(hsc.heading_true, false), of(hsc.heading_magnetic, true)];
    if let [Some(by_true), Some(by_magnetic)] = said {
        let apart = libm::fabs(wrap_180(by_true - by_magnetic));
        if apart > SAME_DEG {
            return refuse(
                3,
                &format!("the magnetic heading is {apart:.0}° off the true one"),
            );
        }
    }
    let [by_true, by_magnetic] = said;
    let Some(degrees) = by_true.or(by_magnetic) else {
        let said = hsc.heading_true.is_some() || hsc.heading_magnetic.is_some();
        let text = match said {
            true => "of another north than the compass, and no variation is known",
            false => "no heading to steer",
        };
        return refuse(1, text);
    };
    let hts = Heading::from_deg(degrees);
    Ok(Remote::Heading {
        hts,
        track: hts.as_course(),
        rate: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nmea::{decode, with_checksum};

    /// A compass of true north, variation 7.5 degrees west.
    fn of(body: &str, accept_null: bool) -> Result<f64, Option<u8>> {
        let line = with_checksum(body);
        let north = |said: Said| Some(said.degrees - if said.magnetic { 7.5 } else { 0.0 });
        match hsc(&decode(line.as_bytes()), accept_null, north) {
            Ok(Remote::Heading {
                hts, rate: None, ..
            }) => Ok(hts.deg()),
            Ok(other) => panic!("{other:?}"),
            Err(refusal) => Err(refusal.field),
        }
    }

    // AP-13
    #[test]
    fn a_heading_is_commanded_true_or_magnetic_with_a_status_or_of_an_edition_without() {
        assert_eq!(of("EIHSC,120.0,T,,M,C", false), Ok(120.0));
        assert_eq!(of("EIHSC,120.0,T,127.5,M", false), Ok(120.0));
        assert_eq!(of("EIHSC,,T,127.5,M,C", false), Ok(120.0));
        assert_eq!(of("EIHSC,120.0,T,,M,", true), Ok(120.0));
        assert_eq!(of("EIHSC,120.0,T,,M,", false), Err(Some(5)));
        assert_eq!(of("EIHSC,120.0,T,,M,R", true), Err(Some(5)));
        assert_eq!(of("EIHSC,120.0,T,150.0,M,C", true), Err(Some(3)));
        assert_eq!(of("EIHSC,,T,,M,C", true), Err(Some(1)));
        assert_eq!(of("EIHSC,361.0,T,,M,C", true), Err(Some(1)));
        let line = with_checksum("EIHSC,120.0,T,,M,C");
        let unknown = hsc(&decode(line.as_bytes()), true, |_| None).unwrap_err();
        assert!(unknown.text.contains("no variation is known"), "{unknown}");
        assert!(hsc(&decode(b"$EIHSC,120.0,T,,M,C"), true, |_| None).is_err());
    }
}
