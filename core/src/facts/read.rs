//! What a sentence without faults says about a fact: a value, or that its source has none (AP-9, FA5).

use super::fix::{Bearing, Fix, Ground};
use crate::nmea::{self, DataStatus, ModeIndicator, Sentence, WindReference};
use crate::units::{Course, RateOfTurn, RudderAngle, SignedAngle, Speed};

/// What a source has said.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Reading<T> {
    /// This.
    Value(T),
    /// By its status or mode indicator it has no valid value.
    NotValid,
    /// The field is empty, or the sentence is faulty (SEN-4).
    Null,
}

impl<T> Reading<T> {
    /// A value where its source calls it valid.
    fn of(valid: bool, value: Option<T>) -> Self {
        match value {
            _ if !valid => Self::NotValid,
            Some(value) => Self::Value(value),
            None => Self::Null,
        }
    }
}

/// Reads the typed view of a sentence; each row of the table goes with its own sentence.
macro_rules! readers {
    ($($(#[$doc:meta])* $name:ident($view:ident: $sentence:ty) -> $type:ty { $valid:expr, $value:expr })*) => {$(
        $(#[$doc])*
        pub(crate) fn $name(sentence: &Sentence<'_>) -> Reading<$type> {
            let Some($view) = <$sentence>::from_sentence(sentence) else {
                return Reading::Null;
            };
            Reading::of($valid, $value)
        }
    )*};
}

readers! {
    hdt(s: nmea::Hdt) -> Bearing { true, s.heading.map(Bearing::of_true) }
    /// Mode A only (AP-9).
    ths(s: nmea::Ths) -> Bearing {
        s.mode == Some(nmea::ThsMode::Autonomous), s.heading.map(Bearing::of_true)
    }
    /// True by its own variation (N table A.12).
    hdg(s: nmea::Hdg) -> Bearing {
        true, s.heading.map(|heading| Bearing::of_magnetic(heading, s.deviation, s.variation))
    }
    hdm(s: nmea::Hdm) -> Bearing { true, s.heading.map(|heading| Bearing::of_magnetic(heading, None, None)) }
    hdg_variation(s: nmea::Hdg) -> f64 { true, s.variation }
    rmc_variation(s: nmea::Rmc) -> f64 { is_valid(s.status) && allows(s.mode), s.variation }
    rot(s: nmea::Rot) -> RateOfTurn { is_valid(s.status), s.rate.map(RateOfTurn::from_deg_per_min) }
    gll(s: nmea::Gll) -> Fix {
        is_valid(s.status) && allows(s.mode),
        s.position.map(|position| Fix { position, mode: mode(s.mode), utc: s.time.map(nmea::UtcTime::seconds) })
    }
    /// Quality 1 to 5 (AP-9).
    gga(s: nmea::Gga) -> Fix {
        s.quality.is_some_and(nmea::FixQuality::valid),
        s.position.map(|position| Fix {
            position, mode: s.quality.map_or(ModeIndicator::NotValid, of_quality), utc: s.time.map(nmea::UtcTime::seconds),
        })
    }
    rmc_fix(s: nmea::Rmc) -> Fix {
        is_valid(s.status) && allows(s.mode),
        s.position.map(|position| Fix { position, mode: mode(s.mode), utc: s.time.map(nmea::UtcTime::seconds) })
    }
    /// Valid where one of its systems is; the best of them tells how it was found.
    gns(s: nmea::Gns) -> Fix {
        best_mode(&s).is_some(),
        s.position.map(|position| Fix {
            position, mode: best_mode(&s).unwrap_or(ModeIndicator::NotValid), utc: s.time.map(nmea::UtcTime::seconds),
        })
    }
    rmc_ground(s: nmea::Rmc) -> Ground {
        is_valid(s.status) && allows(s.mode),
        s.speed.map(|speed| Ground {
            course: s.course.map(Course::from_deg), speed: Speed::from_knots(speed), mode: mode(s.mode),
        })
    }
    vtg(s: nmea::Vtg) -> Ground {
        allows(s.mode),
        s.speed_knots.map(|speed| Ground {
            course: s.course_true.map(Course::from_deg), speed: Speed::from_knots(speed), mode: mode(s.mode),
        })
    }
    vhw(s: nmea::Vhw) -> Speed { true, s.speed_knots.map(Speed::from_knots) }
    /// The laws know speed ahead only: astern counts as none.
    vbw(s: nmea::Vbw) -> Speed {
        is_valid(s.water_status), s.water_ahead.map(|ahead| Speed::from_knots(ahead.max(0.0)))
    }
    mwv_apparent(s: nmea::Mwv) -> SignedAngle {
        !is_of(&s, WindReference::Relative) || is_valid(s.status), mwv_angle(&s, WindReference::Relative)
    }
    mwv_true(s: nmea::Mwv) -> SignedAngle {
        !is_of(&s, WindReference::True) || is_valid(s.status), mwv_angle(&s, WindReference::True)
    }
    vwr(s: nmea::Vwr) -> SignedAngle { true, s.angle.map(SignedAngle::from_deg) }
    vwt(s: nmea::Vwt) -> SignedAngle { true, s.angle.map(SignedAngle::from_deg) }
    /// A single or linked rudder stands on the starboard side (AP-4).
    rsa(s: nmea::Rsa) -> RudderAngle { is_valid(s.starboard_status), s.starboard.map(RudderAngle::from_deg) }
    rsa_port(s: nmea::Rsa) -> RudderAngle { is_valid(s.port_status), s.port.map(RudderAngle::from_deg) }
    ror(s: nmea::Ror) -> RudderAngle { is_valid(s.starboard_status), s.starboard.map(RudderAngle::from_deg) }
    ror_port(s: nmea::Ror) -> RudderAngle { is_valid(s.port_status), s.port.map(RudderAngle::from_deg) }
    xte(s: nmea::Xte) -> nmea::Xte { measured(s.status, s.cycle_lock, s.mode), Some(s) }
    pney1(s: nmea::Pney1) -> nmea::Pney1 { measured(s.status, s.cycle_lock, s.mode), Some(s) }
    pney2(s: nmea::Pney2) -> nmea::Pney2 { true, Some(s) }
    htd(s: nmea::Htd) -> nmea::Htd { true, Some(s) }
}

fn is_valid(status: Option<DataStatus>) -> bool {
    status == Some(DataStatus::Valid)
}

/// Whether a sentence is of that wind; what it says of the other one is nothing of this.
fn is_of(mwv: &nmea::Mwv, wind: WindReference) -> bool {
    mwv.reference == Some(wind)
}

/// The angle where the sentence is of that wind.
fn mwv_angle(mwv: &nmea::Mwv, wind: WindReference) -> Option<SignedAngle> {
    let angle = mwv.angle.filter(|_| is_of(mwv, wind));
    angle.map(SignedAngle::from_deg)
}

/// An edition without the field says nothing against the value.
fn allows(mode: Option<ModeIndicator>) -> bool {
    mode.is_none_or(ModeIndicator::valid)
}

/// The best valid mode of a receiver's systems.
fn best_mode(gns: &nmea::Gns) -> Option<ModeIndicator> {
    let letters = gns.modes.as_deref().unwrap_or_default().bytes();
    let order = |mode: &ModeIndicator| *mode == ModeIndicator::Autonomous;
    letters
        .filter_map(ModeIndicator::from_letter)
        .filter(|mode| mode.valid())
        .min_by_key(order)
}

/// The mode indicator that says the same as a quality.
const fn of_quality(quality: nmea::FixQuality) -> ModeIndicator {
    match quality {
        nmea::FixQuality::Standard => ModeIndicator::Autonomous,
        nmea::FixQuality::Differential => ModeIndicator::Differential,
        nmea::FixQuality::Precise => ModeIndicator::Precise,
        nmea::FixQuality::RealTimeKinematic => ModeIndicator::RealTimeKinematic,
        nmea::FixQuality::FloatRtk => ModeIndicator::FloatRtk,
        _ => ModeIndicator::NotValid,
    }
}

fn mode(mode: Option<ModeIndicator>) -> ModeIndicator {
    mode.unwrap_or(ModeIndicator::Autonomous)
}

/// FA5: both status letters and the mode indicator must be valid.
fn measured(
    status: Option<DataStatus>,
    lock: Option<DataStatus>,
    mode: Option<ModeIndicator>,
) -> bool {
    is_valid(status) && lock != Some(DataStatus::Invalid) && allows(mode)
}
