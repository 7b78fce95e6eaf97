//! From a sentence of the hand unit to what it asks for, whole or not at all (EMC-2, EMC-4, EMC-7).

use super::answer::Answer;
use super::kept::{Changes, Kept};
use crate::command::{Refusal, Side};
use crate::nmea::{
    CalibrationPart, CourseChange, Deadband, InformationRequest, InstallationSide, Pemc01, Pemc02,
    Pemc04, Pemc06, Pemc08, Pemc09, Pemc11, RudderChange, SaveRequest, Sentence,
};
use crate::settings::{DeadBand, HeadingLaw, TillerSide, Value};
use alloc::format;

/// Degrees of a tack (EMC-4).
pub(in super::super) const TACK_DEG: f64 = 100.0;
/// The highest that the rudder limit of AUTO may be, degrees.
const LIMIT_DEG: f64 = 35.0;

/// What a hand unit asks for.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) enum Asked {
    /// 00: STANDBY where orders are given, else AUTO.
    Toggle,
    /// 01: the rudder by so many degrees, starboard positive.
    Rudder(f64),
    /// 02: the course by so many degrees, starboard positive.
    Course(f64),
    /// 02: a tack to that side.
    Tack(Side),
    /// 04 or 06: other settings, and the answer that says them.
    Set(Changes, Answer),
    /// 08.
    Tell(Answer),
    /// 09: the IMU is calibrated from now on, or no longer: gyroscope, accelerometer.
    CalibrateImu(bool, bool),
    /// 10: the feedback of the rudder, likewise.
    CalibrateFeedback,
    /// 11: keeps these.
    Keep(Kept),
    /// 11: the defaults of installation and gains.
    Restore,
    /// A report, as later firmware sends it; nothing is asked.
    Nothing,
}

/// What a sentence asks for.
///
/// # Errors
/// It is faulty, says nothing where something is needed, or asks for what is not done here.
pub(in super::super) fn asked(sentence: &Sentence<'_>) -> Result<Asked, Refusal> {
    if let Some(fault) = sentence.faults().first() {
        return Err(Refusal {
            field: fault.field,
            text: format!("{}", fault.kind),
        });
    }
    Ok(match sentence.formatter {
        "PEMC,00" => Asked::Toggle,
        "PEMC,01" => Asked::Rudder(rudder(sentence).ok_or_else(empty)?),
        "PEMC,02" => course(sentence).ok_or_else(empty)?,
        "PEMC,04" => {
            let set = Pemc04::from_sentence(sentence).ok_or_else(empty)?;
            Asked::Set(installation(&set), Answer::Installation)
        }
        "PEMC,06" => {
            let set = Pemc06::from_sentence(sentence).ok_or_else(empty)?;
            Asked::Set(gains(&set), Answer::Gains)
        }
        "PEMC,08" => {
            let asked = Pemc08::from_sentence(sentence).and_then(|asked| asked.request);
            Asked::Tell(match asked.ok_or_else(empty)? {
                InformationRequest::Installation => Answer::Installation,
                InformationRequest::Gains => Answer::Gains,
                InformationRequest::Information => Answer::Information,
            })
        }
        "PEMC,09" => match Pemc09::from_sentence(sentence).and_then(|imu| imu.part) {
            None | Some(CalibrationPart::All) => Asked::CalibrateImu(true, true),
            Some(CalibrationPart::Gyro) => Asked::CalibrateImu(true, false),
            Some(CalibrationPart::Accelerometer) => Asked::CalibrateImu(false, true),
            Some(CalibrationPart::Magnetometer) => {
                let text = "the compass is swung at the IMU itself; here its alignment is set";
                return Err(Refusal::because(text));
            }
        },
        "PEMC,10" => Asked::CalibrateFeedback,
        "PEMC,11" => {
            let what = Pemc11::from_sentence(sentence).and_then(|save| save.what);
            match what.ok_or_else(empty)? {
                SaveRequest::Installation => Asked::Keep(Kept::Installation),
                SaveRequest::Gains => Asked::Keep(Kept::Gains),
                SaveRequest::Offsets => Asked::Keep(Kept::Offsets),
                SaveRequest::Restore => Asked::Restore,
            }
        }
        "PEMC,99" => return Err(Refusal::because("service commands are not served")),
        _ => Asked::Nothing,
    })
}

fn empty() -> Refusal {
    Refusal {
        field: Some(2),
        text: "it is empty".into(),
    }
}

fn rudder(sentence: &Sentence<'_>) -> Option<f64> {
    Some(match Pemc01::from_sentence(sentence)?.rate? {
        RudderChange::Increment => 1.0,
        RudderChange::IncrementTen => 10.0,
        RudderChange::Reduce => -1.0,
        RudderChange::ReduceTen => -10.0,
    })
}

fn course(sentence: &Sentence<'_>) -> Option<Asked> {
    Some(match Pemc02::from_sentence(sentence)?.rate? {
        CourseChange::Increment => Asked::Course(1.0),
        CourseChange::IncrementTen => Asked::Course(10.0),
        CourseChange::Reduce => Asked::Course(-1.0),
        CourseChange::ReduceTen => Asked::Course(-10.0),
        CourseChange::TackPort => Asked::Tack(Side::Port),
        CourseChange::TackStarboard => Asked::Tack(Side::Starboard),
    })
}

/// An empty field leaves its value (EMC-4). The largest rudder angle is the gear's, and AUTO's as far as that may go.
fn installation(set: &Pemc04) -> Changes {
    let side = set.side.map(|side| match side {
        InstallationSide::Starboard => TillerSide::Starboard,
        InstallationSide::Port => TillerSide::Port,
    });
    let limit = set.max_rudder.map(|most| most.min(LIMIT_DEG));
    given([
        ("tiller_centre", set.tiller.map(Value::Number)),
        ("rudder_max", set.max_rudder.map(Value::Number)),
        ("rudder_limit", limit.map(Value::Number)),
        ("cruise_speed", set.cruise_speed.map(Value::Number)),
        ("tiller_side", side.map(TillerSide::value)),
        ("rudder_damping", set.damping.map(Value::Number)),
        ("variation", set.variation.map(Value::Number)),
        ("heading_alignment", set.alignment.map(Value::Number)),
        ("off_heading_limit", set.off_course.map(Value::Number)),
    ])
}

/// Whoever gives gains wants them to steer.
fn gains(set: &Pemc06) -> Changes {
    let band = set.deadband.map(|band| match band {
        Deadband::Least => DeadBand::Minimum,
        Deadband::Greatest => DeadBand::Maximum,
        Deadband::Automatic => DeadBand::Automatic,
    });
    given([
        ("heading_law", Some(HeadingLaw::Pid.value())),
        ("pid_kp", set.kp.map(Value::Number)),
        ("pid_ki", set.ki.map(Value::Number)),
        ("pid_kd", set.kd.map(Value::Number)),
        (
            "sample_time",
            set.sample_time.map(|ms| Value::Number(f64::from(ms))),
        ),
        ("dead_band", band.map(DeadBand::value)),
    ])
}

fn given<const N: usize>(all: [(&'static str, Option<Value>); N]) -> Changes {
    let all = all.into_iter();
    all.filter_map(|(name, value)| Some((name, value?)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nmea::{decode, with_checksum};
    use alloc::vec::Vec;

    fn of(body: &str) -> Result<Asked, Refusal> {
        asked(&decode(with_checksum(body).as_bytes()))
    }

    // EMC-4: an empty field leaves its value, in either length of 06.
    #[test]
    fn an_empty_field_changes_nothing() {
        let set = |body: &str| match of(body) {
            Ok(Asked::Set(changes, _)) => changes,
            other => panic!("{body}: {other:?}"),
        };
        let changes = set("PEMC,04,,40,,,,,,");
        let names: Vec<_> = changes.iter().map(|(name, _)| *name).collect();
        assert_eq!(names, ["rudder_max", "rudder_limit"]);
        assert_eq!(changes[1].1, Value::Number(35.0));
        let names = |body: &str| set(body).iter().map(|(name, _)| *name).collect::<Vec<_>>();
        assert_eq!(names("PEMC,06,,,0.7,,"), ["heading_law", "pid_kd"]);
        assert_eq!(set("PEMC,06,3,0.11,0.7,1000,m").len(), 6);
        assert_eq!(set("PEMC,04,2,40,4,S,3,4.1,33.9,9").len(), 9);
    }

    // EMC-2: a faulty sentence is refused whole, with its field.
    #[test]
    fn what_is_faulty_is_refused_by_its_field() {
        for (body, field) in [
            ("PEMC,01,x", 2),
            ("PEMC,01,", 2),
            ("PEMC,02,q", 2),
            ("PEMC,08,Z", 2),
            ("PEMC,11,", 2),
            ("PEMC,04,2,40,4,Q,3,4.1,33.9,9", 5),
            ("PEMC,06,3,0.11,0.7,1000,x", 6),
        ] {
            assert_eq!(of(body).unwrap_err().field, Some(field), "{body}");
        }
        assert!(of("PEMC,99,R").is_err() && of("PEMC,09,M").is_err());
    }

    // EMC-4: later firmware's reports are understood, and ask for nothing.
    #[test]
    fn reports_ask_for_nothing() {
        for body in [
            "PEMC,12,O,1,0,1,0",
            "PEMC,13,5,610",
            "PEMC,07,C,12,35.60,,2,-0.50",
        ] {
            assert_eq!(of(body), Ok(Asked::Nothing), "{body}");
        }
    }
}
