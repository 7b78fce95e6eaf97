//! The few sentences that the world says and hears.

use crate::geo::Position;
use crate::time::Stamp;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Gyro: HDT.
pub(super) fn heading(out: &mut Vec<u8>, degrees: f64) {
    let rounded = libm::round(degrees * 100.0) / 100.0;
    let shown = if rounded >= 360.0 { 0.0 } else { rounded };
    sentence(out, &format!("HEHDT,{shown:06.2},T"));
}

/// Gyro: ROT.
pub(super) fn rate(out: &mut Vec<u8>, degrees_per_minute: f64) {
    sentence(out, &format!("HEROT,{degrees_per_minute:.2},A"));
}

/// Steering gear: RSA with a single rudder.
pub(super) fn rudder(out: &mut Vec<u8>, degrees: f64) {
    sentence(out, &format!("IIRSA,{degrees:.2},A,,V"));
}

/// Position receiver: GLL with differential correction.
pub(super) fn position(out: &mut Vec<u8>, at: Position, now: Stamp) {
    let (lat, lon) = (angle(at.lat, 2), angle(at.lon, 3));
    let north = if at.lat < 0.0 { 'S' } else { 'N' };
    let east = if at.lon < 0.0 { 'W' } else { 'E' };
    let seconds = now.0 / 1000 % 86_400;
    let (h, m, s) = (seconds / 3600, seconds / 60 % 60, seconds % 60);
    let cent = now.0 % 1000 / 10;
    sentence(
        out,
        &format!("GPGLL,{lat},{north},{lon},{east},{h:02}{m:02}{s:02}.{cent:02},A,D"),
    );
}

/// Position receiver: VTG; speed in m/s.
pub(super) fn velocity(out: &mut Vec<u8>, course: f64, speed: f64) {
    let knots = speed * 3600.0 / 1852.0;
    let kmh = speed * 3.6;
    sentence(
        out,
        &format!("GPVTG,{course:05.1},T,,M,{knots:.2},N,{kmh:.2},K,D"),
    );
}

/// Speed log: VHW; speed in m/s.
pub(super) fn log(out: &mut Vec<u8>, speed: f64) {
    let knots = speed * 3600.0 / 1852.0;
    let kmh = speed * 3.6;
    sentence(out, &format!("VDVHW,,T,,M,{knots:.2},N,{kmh:.2},K"));
}

/// Degrees and minutes with five decimals.
fn angle(degrees: f64, digits: usize) -> String {
    let units = libm::round(libm::fabs(degrees) * 60.0e5) as u64;
    let (whole, rest) = (units / 6_000_000, units % 6_000_000);
    format!(
        "{whole:0digits$}{:02}.{:05}",
        rest / 100_000,
        rest % 100_000
    )
}

fn checksum(text: &[u8]) -> u8 {
    text.iter().fold(0, |sum, byte| sum ^ byte)
}

fn sentence(out: &mut Vec<u8>, text: &str) {
    let line = format!("${text}*{:02X}\r\n", checksum(text.as_bytes()));
    out.extend_from_slice(line.as_bytes());
}

/// Collects lines from bytes and hears the rudder orders among them.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Ear(Vec<u8>);

impl Ear {
    /// Calls `order` with each ROR: degrees, or nothing where its status is V.
    pub(super) fn hear(&mut self, bytes: &[u8], order: &mut dyn FnMut(Option<f64>)) {
        for &byte in bytes {
            match byte {
                b'\r' | b'\n' => {
                    if let Some(heard) = rudder_order(&self.0) {
                        order(heard);
                    }
                    self.0.clear();
                }
                b'$' => {
                    self.0.clear();
                    self.0.push(byte);
                }
                _ if self.0.len() < 120 && !self.0.is_empty() => self.0.push(byte),
                _ => self.0.clear(),
            }
        }
    }
}

/// `$--ROR,starboard,A,port,A,source*hh` with a right checksum.
fn rudder_order(line: &[u8]) -> Option<Option<f64>> {
    let text = core::str::from_utf8(line).ok()?.strip_prefix('$')?;
    let (body, sum) = text.rsplit_once('*')?;
    if u8::from_str_radix(sum, 16) != Ok(checksum(body.as_bytes())) {
        return None;
    }
    let mut fields = body.split(',');
    if fields.next()?.get(2..)? != "ROR" {
        return None;
    }
    let value = fields
        .next()?
        .parse::<f64>()
        .ok()
        .filter(|v| libm::fabs(*v) <= 90.0);
    Some(if fields.next()? == "A" { value } else { None })
}
