//! The only way an APB becomes something that TRACK follows (AP-14, EMC-3). Decoding is lenient, obeying is strict.

use super::refusal::Refusal;
use crate::nmea::{Apb, Arrival, DataStatus, DistanceUnit, Reference, Sentence};
use crate::units::Distance;
use alloc::format;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// Metres of a kilometre.
const METRES: f64 = 1_000.0;

/// A direction with the north that it is of, as a sentence says it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Said {
    /// Degrees.
    pub degrees: f64,
    /// It is of magnetic north.
    pub magnetic: bool,
}

/// What an APB says, once TRACK may follow it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Leg {
    /// Cross-track distance, the ship right of the track positive; fields 3 to 5.
    pub cross_track: Distance,
    /// How far apart two distances are that it can tell from each other, by its decimals and its unit.
    pub resolution: Distance,
    /// Course of the leg, fields 8 and 9.
    pub course: Said,
    /// Destination, field 10; empty where it is null.
    pub waypoint: String,
    /// Bearing of the destination, fields 11 and 12.
    pub bearing: Option<Said>,
    /// Heading to steer, fields 13 and 14; without one the leg's course is steered, corrected by the cross-track distance.
    pub heading_to_steer: Option<Said>,
    /// The arrival circle is entered or the perpendicular passed, fields 6 and 7.
    pub arrived: bool,
}

/// What an APB says of itself and of the leg.
#[derive(Clone, Debug, PartialEq)]
pub enum Plotted {
    /// By its status or mode indicator the plotter has no valid position; why, in an officer's words.
    NotValid(String),
    /// A leg to be followed.
    Leg(Leg),
}

/// The leg of an APB, or why it is not followed.
///
/// ```
/// use wheelover_core::command::{Plotted, apb};
/// use wheelover_core::nmea::decode;
/// let Ok(Plotted::Leg(leg)) = apb(&decode(b"$GPAPB,A,A,0.10,R,N,V,V,011,M,DEST,011,M,011,M*3C")) else { panic!() };
/// assert_eq!((leg.cross_track.nm(), leg.course.magnetic), (-0.10, true), "the ship is left of the track: steer right");
/// ```
///
/// # Errors
/// Another formatter, a checksum that is missing or wrong, another number of fields, a fault in any of them; no
/// cross-track distance, no course of the leg, a direction without its north.
pub fn apb(sentence: &Sentence<'_>) -> Result<Plotted, Refusal> {
    let Some(apb) = Apb::from_sentence(sentence) else {
        return Err(Refusal::because("not an APB"));
    };
    if !sentence.checksum.is_right() {
        return Err(Refusal::because("checksum missing or wrong"));
    }
    if sentence.text.first() != Some(&b'$') {
        return Err(Refusal::because("does not begin with $"));
    }
    let faults = sentence.faults();
    let of_the_whole = faults.iter().find(|fault| fault.field.is_none());
    if let Some(why) = not_valid(&apb).filter(|_| of_the_whole.is_none()) {
        return Ok(Plotted::NotValid(why));
    }
    if let Some(fault) = of_the_whole.or(faults.first()) {
        return Err(Refusal {
            field: fault.field,
            text: fault.text(),
        });
    }
    if let Some(null) = [apb.status, apb.cycle_lock]
        .iter()
        .position(Option::is_none)
    {
        return refuse(null as u8 + 1, "no status");
    }
    let Some(cross_track) = apb.cross_track else {
        return refuse(3, "no cross-track distance");
    };
    let unit = match apb.cross_track_unit {
        Some(DistanceUnit::NauticalMiles) => Distance::from_nm(1.0).m(),
        Some(DistanceUnit::Kilometres) => METRES,
        None => return refuse(5, "the cross-track distance has no unit"),
    };
    let Some(course) = said(8, apb.bearing_origin, apb.bearing_origin_reference)? else {
        return refuse(8, "no course of the leg");
    };
    let arrived = [apb.arrival, apb.passed].contains(&Some(Arrival::Entered));
    Ok(Plotted::Leg(Leg {
        cross_track: Distance::from_m(cross_track * unit),
        resolution: Distance::from_m(resolution(sentence) * unit),
        course,
        waypoint: apb.waypoint.unwrap_or_default(),
        bearing: said(11, apb.bearing_present, apb.bearing_present_reference)?,
        heading_to_steer: said(13, apb.heading_to_steer, apb.heading_to_steer_reference)?,
        arrived,
    }))
}

fn refuse<T>(field: u8, text: impl Into<String>) -> Result<T, Refusal> {
    Err(Refusal {
        field: Some(field),
        text: text.into(),
    })
}

/// Why its data are not valid: both status letters, and the mode indicator where there is one (AP-9).
fn not_valid(apb: &Apb) -> Option<String> {
    let status = [apb.status, apb.cycle_lock];
    if status.contains(&Some(DataStatus::Invalid)) {
        return Some("its status says not valid".into());
    }
    let mode = apb.mode.filter(|mode| !mode.valid())?;
    Some(format!("its mode indicator says {}", mode.meaning()))
}

/// A direction of the field `number` with its north in the next one.
fn said(
    number: u8,
    degrees: Option<f64>,
    reference: Option<Reference>,
) -> Result<Option<Said>, Refusal> {
    let Some(degrees) = degrees else {
        return Ok(None);
    };
    let Some(reference) = reference else {
        return refuse(number + 1, "neither true nor magnetic");
    };
    Ok(Some(Said {
        degrees,
        magnetic: reference == Reference::Magnetic,
    }))
}

/// The last decimal that field 3 says, in its unit.
fn resolution(sentence: &Sentence<'_>) -> f64 {
    let text = sentence.fields.get(3);
    let decimals =
        (text.iter().position(|byte| *byte == b'.')).map_or(0, |dot| text.len() - dot - 1);
    (0..decimals).fold(1.0, |unit, _| unit / 10.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nmea::{decode, with_checksum};

    fn leg(line: &str) -> Leg {
        match apb(&decode(line.as_bytes())) {
            Ok(Plotted::Leg(leg)) => leg,
            other => panic!("{line}: {other:?}"),
        }
    }

    // EMC-3: OpenPlotter's examples
    #[test]
    fn the_examples_of_the_document_are_legs() {
        let check = |line: &str, metres: f64, directions: [f64; 3]| {
            let leg = leg(line);
            assert!(
                (leg.cross_track.m() - metres).abs() < 1e-9,
                "{line}: {leg:?}"
            );
            let said = [Some(leg.course), leg.bearing, leg.heading_to_steer];
            let expect = directions.map(|degrees| {
                let magnetic = true;
                Some(Said { degrees, magnetic })
            });
            assert_eq!(
                (said, leg.waypoint.as_str(), leg.arrived),
                (expect, "DEST", false),
                "{line}"
            );
        };
        check(
            "$GPAPB,A,A,0.10,R,N,V,V,011,M,DEST,011,M,011,M*3C",
            -185.2,
            [11.0; 3],
        );
        check(
            "$GPAPB,A,A,0.10,R,N,V,V,012,M,DEST,11.50,M,9.03,M*00",
            -185.2,
            [12.0, 11.5, 9.03],
        );
        check(
            "$GPAPB,A,A,0.1,R,K,V,V,0.12,M,DEST,11.50,M,9.03,M*1B",
            -100.0,
            [0.12, 11.5, 9.03],
        );
        let resolution = |line: &str| leg(line).resolution.m();
        assert!(
            (resolution("$GPAPB,A,A,0.1,R,K,V,V,0.12,M,DEST,11.50,M,9.03,M*1B") - 100.0).abs()
                < 1e-9
        );
        assert!(
            (resolution("$GPAPB,A,A,0.10,R,N,V,V,011,M,DEST,011,M,011,M*3C") - 18.52).abs() < 1e-9
        );
    }

    #[test]
    fn arrival_and_validity_are_read_from_either_of_their_fields() {
        let of = |status: &str, arrival: &str, mode: &str| {
            let line = with_checksum(&format!(
                "GPAPB,{status},0.1,L,N,{arrival},90.0,T,WP1,,,,{mode}"
            ));
            apb(&decode(line.as_bytes()))
        };
        let arrived = |arrival: &str| match of("A,A", arrival, "") {
            Ok(Plotted::Leg(leg)) => leg.arrived,
            other => panic!("{other:?}"),
        };
        assert_eq!(
            ["V,V", "A,V", "V,A", "A,A", ","].map(arrived),
            [false, true, true, true, false]
        );
        for (status, mode) in [
            ("V,A", ",A"),
            ("A,V", ",A"),
            ("A,A", ",N"),
            ("A,A", ",E"),
            ("A,A", ",S"),
            ("A,A", ",M"),
        ] {
            assert!(
                matches!(of(status, "V,V", mode), Ok(Plotted::NotValid(_))),
                "{status} {mode}"
            );
        }
        for mode in ["", ",A", ",D", ",P", ",F", ",R"] {
            assert!(
                matches!(of("A,A", "V,V", mode), Ok(Plotted::Leg(_))),
                "{mode}"
            );
        }
    }

    // SEN-5: what is not whole is refused
    #[test]
    fn an_apb_that_is_not_whole_is_refused_with_its_field() {
        let check = |body: &str, field: Option<u8>| {
            let line = with_checksum(body);
            let refused = apb(&decode(line.as_bytes())).map_err(|refusal| refusal.field);
            assert_eq!(refused, Err(field), "{body}");
        };
        check("GPAPB,,A,0.1,L,N,V,V,90.0,T,W,,,,", Some(1));
        check("GPAPB,A,,0.1,L,N,V,V,90.0,T,W,,,,", Some(2));
        check("GPAPB,X,A,0.1,L,N,V,V,90.0,T,W,,,,", Some(1));
        check("GPAPB,A,A,,,N,V,V,90.0,T,W,,,,", Some(3));
        check("GPAPB,A,A,0.1,L,,V,V,90.0,T,W,,,,", Some(5));
        check("GPAPB,A,A,0.1,L,N,V,V,,T,W,,,,", Some(8));
        check("GPAPB,A,A,0.1,L,N,V,V,90.0,,W,,,,", Some(9));
        check("GPAPB,A,A,0.1,L,N,V,V,90.0,T,W,90.0,,,", Some(12));
        check("GPAPB,A,A,0.1,L,N,V,V,90.0,T,W,,,90.0,", Some(14));
        check("GPAPB,A,A,0.1,L,N,V,V,361.0,T,W,,,,", Some(8));
        check("GPAPB,A,A,0.1,L,N,V,V,90.0,T,W,,", None);
        check("GPXTE,A,A,0.1,L,N", None);
        let missing = b"$GPAPB,A,A,0.1,L,N,V,V,90.0,T,W,,,,";
        assert!(apb(&decode(missing)).is_err());
    }
}
