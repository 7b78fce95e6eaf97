//! The few sentences that the world's sensors say.

use crate::geo::Position;
use crate::nmea::{
    DataStatus, Gll, Hdt, ModeIndicator, Mwv, Rot, UtcTime, Vhw, Vtg, WindReference, WindUnit,
};
use crate::time::Stamp;
use crate::units::{METRES_PER_SECOND_PER_KNOT, wrap_360};
use alloc::string::String;

const VALID: Option<DataStatus> = Some(DataStatus::Valid);
const DIFFERENTIAL: Option<ModeIndicator> = Some(ModeIndicator::Differential);

/// Gyro: HDT.
pub(super) fn heading(degrees: f64, talker: &str) -> String {
    let hdt = Hdt {
        heading: Some(degrees),
    };
    hdt.line(talker)
}

/// Gyro: ROT.
pub(super) fn rate(degrees_per_minute: f64, talker: &str) -> String {
    let rot = Rot {
        rate: Some(degrees_per_minute),
        status: VALID,
    };
    rot.line(talker)
}

/// Position receiver: GLL with differential correction.
pub(super) fn position(at: Position, now: Stamp, talker: &str) -> String {
    let gll = Gll {
        position: Some(at),
        time: Some(UtcTime::from_seconds(now.seconds())),
        status: VALID,
        mode: DIFFERENTIAL,
    };
    gll.line(talker)
}

/// Position receiver: VTG; speed in m/s.
pub(super) fn velocity(course: f64, speed: f64, talker: &str) -> String {
    let vtg = Vtg {
        course_true: Some(course),
        speed_knots: Some(speed / METRES_PER_SECOND_PER_KNOT),
        speed_kmh: Some(speed * 3.6),
        mode: DIFFERENTIAL,
        ..Vtg::default()
    };
    vtg.line(talker)
}

/// Speed log: VHW; speed in m/s.
pub(super) fn log(speed: f64, talker: &str) -> String {
    let vhw = Vhw {
        speed_knots: Some(speed / METRES_PER_SECOND_PER_KNOT),
        speed_kmh: Some(speed * 3.6),
        ..Vhw::default()
    };
    vhw.line(talker)
}

/// Wind sensor: MWV; angle from the bow in degrees, speed in m/s.
pub(super) fn wind(angle: f64, apparent: bool, speed: f64, talker: &str) -> String {
    let reference = if apparent {
        WindReference::Relative
    } else {
        WindReference::True
    };
    let mwv = Mwv {
        angle: Some(wrap_360(angle)),
        reference: Some(reference),
        speed: Some(speed),
        unit: Some(WindUnit::Metres),
        status: VALID,
    };
    mwv.line(talker)
}
