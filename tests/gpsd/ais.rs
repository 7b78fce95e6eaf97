//! AIS messages of ITU-R M.1371 in our VDM sentences, of one and of two parts: gpsd reads the bits that were put in.

use crate::random::Random;
use crate::{Case, rounds};
use wheelover_core::nmea::*;

const AIS: &str = "AIS";

/// Bits of a message, the first one first.
#[derive(Default)]
struct Bits(Vec<bool>);

impl Bits {
    /// A number of `width` bits, two's complement where it is negative.
    fn number(mut self, value: i64, width: u32) -> Self {
        self.0
            .extend((0..width).rev().map(|bit| value >> bit & 1 == 1));
        self
    }
    /// A text in six-bit characters, filled up with `@`.
    fn text(mut self, text: &str, width: usize) -> Self {
        for at in 0..width {
            let letter = text.as_bytes().get(at).copied().unwrap_or(b'@');
            self = self.number(i64::from(letter & 0x3F), 6);
        }
        self
    }
    /// The armoured characters and the bits of the last one that do not count.
    fn armoured(&self) -> (String, u32) {
        let six = |bits: &[bool]| {
            (0..6).fold(0, |sum, at| {
                sum << 1 | u8::from(bits.get(at) == Some(&true))
            })
        };
        let armour = |value: u8| char::from(if value < 40 { value + 48 } else { value + 56 });
        let text = self.0.chunks(6).map(|bits| armour(six(bits))).collect();
        (text, (6 - self.0.len() as u32 % 6) % 6)
    }
}

/// The message in as many sentences as it needs.
fn sentences(bits: &Bits, random: &mut Random) -> Vec<String> {
    let (payload, fill_bits) = bits.armoured();
    let parts: Vec<&[u8]> = payload.as_bytes().chunks(56).collect();
    let channel = random.pick(&[AisChannel::A, AisChannel::B]);
    let sequence = random.from(0, 9) as u32;
    let part = |(at, part): (usize, &&[u8])| {
        let vdm = Vdm {
            total: Some(parts.len() as u32),
            number: Some(at as u32 + 1),
            sequence: (parts.len() > 1).then_some(sequence),
            channel: Some(channel),
            payload: Some(part.iter().map(|&b| char::from(b)).collect()),
            fill_bits: Some(if at + 1 == parts.len() { fill_bits } else { 0 }),
        };
        let line = vdm.line("AI");
        let sentence = decode(line.as_bytes());
        assert!(sentence.is_clean(), "{line}: {:?}", sentence.faults());
        assert_eq!(Vdm::from_sentence(&sentence), Some(vdm));
        line
    };
    parts.iter().enumerate().map(part).collect()
}

fn case(bits: &Bits, random: &mut Random) -> Case {
    Case::new(sentences(bits, random))
}

/// Latitude and longitude in ten-thousandths of a minute.
fn place(random: &mut Random) -> (i64, i64) {
    let minutes = 600_000;
    (
        random.from(-89 * minutes, 89 * minutes),
        random.from(-179 * minutes, 179 * minutes),
    )
}

#[test]
fn position_report_of_class_a() {
    rounds("VDM type 1", |random| {
        let mmsi = random.from(200_000_000, 775_999_999);
        let (status, heading) = (random.from(0, 8), random.from(0, 359));
        let (speed, course) = (random.from(0, 1_000), random.from(0, 3_599));
        let ((lat, lon), second) = (place(random), random.from(0, 59));
        let bits = Bits::default()
            .number(1, 6)
            .number(0, 2)
            .number(mmsi, 30)
            .number(status, 4)
            .number(0, 8)
            .number(speed, 10)
            .number(1, 1)
            .number(lon, 28)
            .number(lat, 27)
            .number(course, 12)
            .number(heading, 9)
            .number(second, 6)
            .number(0, 25);
        case(&bits, random)
            .exact(AIS, "/type", 1)
            .exact(AIS, "/mmsi", mmsi)
            .exact(AIS, "/status", status)
            .number(AIS, "/speed", speed as f64 / 10.0, 1)
            .exact(AIS, "/accuracy", true)
            .number(AIS, "/lat", lat as f64 / 600_000.0, 6)
            .number(AIS, "/lon", lon as f64 / 600_000.0, 6)
            .number(AIS, "/course", course as f64 / 10.0, 1)
            .exact(AIS, "/heading", heading)
            .exact(AIS, "/second", second)
    });
}

#[test]
fn position_report_of_class_b() {
    rounds("VDM type 18", |random| {
        let mmsi = random.from(200_000_000, 775_999_999);
        let (speed, course) = (random.from(0, 1_000), random.from(0, 3_599));
        let ((lat, lon), heading) = (place(random), random.from(0, 359));
        let bits = Bits::default()
            .number(18, 6)
            .number(0, 2)
            .number(mmsi, 30)
            .number(0, 8)
            .number(speed, 10)
            .number(0, 1)
            .number(lon, 28)
            .number(lat, 27)
            .number(course, 12)
            .number(heading, 9)
            .number(30, 6)
            .number(0, 29);
        case(&bits, random)
            .exact(AIS, "/type", 18)
            .exact(AIS, "/mmsi", mmsi)
            .number(AIS, "/speed", speed as f64 / 10.0, 1)
            .number(AIS, "/lat", lat as f64 / 600_000.0, 6)
            .number(AIS, "/lon", lon as f64 / 600_000.0, 6)
            .number(AIS, "/course", course as f64 / 10.0, 1)
            .exact(AIS, "/heading", heading)
    });
}

#[test]
fn static_data_in_two_parts() {
    rounds("VDM type 5", |random| {
        let mmsi = random.from(200_000_000, 775_999_999);
        let imo = random.from(1_000_000, 9_999_999);
        let names = ["WHEELOVER", "KONTIKI II", "7 SEAS / 3", "A"];
        let (name, sign) = (random.pick(&names), random.pick(&["OH1234", "LXYZ", "D5A"]));
        let (bow, stern) = (random.from(0, 511), random.from(0, 511));
        let (port, starboard) = (random.from(0, 63), random.from(0, 63));
        let (draught, kind) = (random.from(0, 255), random.from(20, 99));
        let bits = Bits::default()
            .number(5, 6)
            .number(0, 2)
            .number(mmsi, 30)
            .number(0, 2)
            .number(imo, 30)
            .text(sign, 7)
            .text(name, 20)
            .number(kind, 8)
            .number(bow, 9)
            .number(stern, 9)
            .number(port, 6)
            .number(starboard, 6)
            .number(1, 4)
            .number(11, 4)
            .number(22, 5)
            .number(7, 5)
            .number(45, 6)
            .number(draught, 8)
            .text("HAMBURG", 20)
            .number(0, 2);
        let case = case(&bits, random);
        assert_eq!(case.lines.len(), 2);
        case.exact(AIS, "/type", 5)
            .exact(AIS, "/mmsi", mmsi)
            .exact(AIS, "/imo", imo)
            .exact(AIS, "/callsign", sign)
            .exact(AIS, "/shipname", name)
            .exact(AIS, "/shiptype", kind)
            .exact(AIS, "/to_bow", bow)
            .exact(AIS, "/to_stern", stern)
            .exact(AIS, "/to_port", port)
            .exact(AIS, "/to_starboard", starboard)
            .exact(AIS, "/eta", "11-22T07:45Z")
            .number(AIS, "/draught", draught as f64 / 10.0, 1)
            .exact(AIS, "/destination", "HAMBURG")
    });
}
