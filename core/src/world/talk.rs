//! The few sentences that the world says and hears.

use crate::geo::Position;
use crate::nmea::{
    self, DataStatus, Framer, Gll, Hdt, ModeIndicator, Ror, Rot, Rsa, UtcTime, Vhw, Vtg,
};
use crate::time::Stamp;
use crate::units::{METRES_PER_SECOND_PER_KNOT, RudderAngle};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

const VALID: Option<DataStatus> = Some(DataStatus::Valid);
const DIFFERENTIAL: Option<ModeIndicator> = Some(ModeIndicator::Differential);

/// Gyro: HDT.
pub(super) fn heading(out: &mut Vec<u8>, degrees: f64) {
    let hdt = Hdt {
        heading: Some(degrees),
    };
    say(out, &hdt.line("HE"));
}

/// Gyro: ROT.
pub(super) fn rate(out: &mut Vec<u8>, degrees_per_minute: f64) {
    let rot = Rot {
        rate: Some(degrees_per_minute),
        status: VALID,
    };
    say(out, &rot.line("HE"));
}

/// Steering gear: RSA with a single rudder.
pub(super) fn rudder(out: &mut Vec<u8>, degrees: f64) {
    let rsa = Rsa {
        starboard: Some(degrees),
        starboard_status: VALID,
        port: None,
        port_status: Some(DataStatus::Invalid),
    };
    say(out, &rsa.line("II"));
}

/// Position receiver: GLL with differential correction.
pub(super) fn position(out: &mut Vec<u8>, at: Position, now: Stamp) {
    let gll = Gll {
        position: Some(at),
        time: Some(UtcTime::from_seconds(now.seconds())),
        status: VALID,
        mode: DIFFERENTIAL,
    };
    say(out, &gll.line("GP"));
}

/// Position receiver: VTG; speed in m/s.
pub(super) fn velocity(out: &mut Vec<u8>, course: f64, speed: f64) {
    let vtg = Vtg {
        course_true: Some(course),
        speed_knots: Some(speed / METRES_PER_SECOND_PER_KNOT),
        speed_kmh: Some(speed * 3.6),
        mode: DIFFERENTIAL,
        ..Vtg::default()
    };
    say(out, &vtg.line("GP"));
}

/// Speed log: VHW; speed in m/s.
pub(super) fn log(out: &mut Vec<u8>, speed: f64) {
    let vhw = Vhw {
        speed_knots: Some(speed / METRES_PER_SECOND_PER_KNOT),
        speed_kmh: Some(speed * 3.6),
        ..Vhw::default()
    };
    say(out, &vhw.line("VD"));
}

fn say(out: &mut Vec<u8>, line: &str) {
    out.extend_from_slice(line.as_bytes());
    out.extend_from_slice(b"\r\n");
}

/// Collects lines from bytes and hears the rudder orders among them.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Ear(Framer);

impl Ear {
    /// Calls `order` with each ROR: the angle, or nothing where its status is not A.
    pub(super) fn hear(&mut self, bytes: &[u8], order: &mut dyn FnMut(Option<RudderAngle>)) {
        self.0.push(bytes, &mut |frame| {
            let sentence = nmea::decode(frame.text);
            if !sentence.checksum.is_right() {
                return;
            }
            if let Some(ror) = Ror::from_sentence(&sentence) {
                let angle = ror.starboard.map(RudderAngle::from_deg);
                order(angle.filter(|_| ror.starboard_status == VALID));
            }
        });
    }
}
