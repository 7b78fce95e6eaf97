//! Exact decimals: reading, writing, and every odd text between.

use super::*;
use alloc::string::ToString;

#[test]
fn a_number_prints_back_as_it_was_written() {
    for text in [
        "028",
        "0.350",
        "-0.0",
        "+12.5",
        "12.",
        ".5",
        "0",
        "-027.5",
        "291.300000000000011",
    ] {
        assert_eq!(
            Decimal::parse(text.as_bytes())
                .map(|d| d.to_string())
                .as_deref(),
            Some(text)
        );
    }
    for text in [
        "",
        "-",
        ".",
        "1e308",
        "NaN",
        "1.2.3",
        " 1",
        "1 ",
        "0x10",
        "12345678901234567890",
    ] {
        assert_eq!(Decimal::parse(text.as_bytes()), None, "{text}");
    }
}

#[test]
fn eight_and_sixteen_at_a_time_read_what_one_at_a_time_reads() {
    let alphabet = b"0123456789.:/-+A,\xff\x00\xb0";
    let mut state = 0x5EED_u64;
    for round in 0..200_000u32 {
        let mut body = [b'7'; 40];
        let length = 1 + round as usize % 18;
        for (i, byte) in body.iter_mut().enumerate().take(length + 3) {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            // Digits mostly.
            let most = if state & 0xf00 == 0 {
                alphabet.len()
            } else {
                10 + usize::from(i == 4)
            };
            *byte = alphabet[(state >> 16) as usize % most];
        }
        let expect = Decimal::parse(&body[..length]);
        assert_eq!(
            Decimal::parse_in(&body, 0, length),
            expect,
            "{:?}",
            &body[..length]
        );
        assert_eq!(Decimal::parse_in(&body[..length], 0, length), expect);
    }
}

#[test]
fn ranges_are_exact() {
    let check = |text: &str, low, high, expect| {
        assert_eq!(
            Decimal::parse(text.as_bytes()).map(|d| d.within(low, high)),
            Some(expect),
            "{text}"
        );
    };
    check("360.0", 0, 360, true);
    check("360.0000000001", 0, 360, false);
    check("-0.0", 0, 360, true);
    check("-0.1", 0, 360, false);
    check("-180", -180, 180, true);
    check("-180.01", -180, 180, false);
    check("0.9", 1, 9, false);
    check("9999999999999999999", 0, 360, false);
}

#[test]
fn floats_round_to_the_declared_decimals() {
    let check = |value, whole, decimals, expect: &str| {
        assert_eq!(
            Decimal::from_f64(value, whole, decimals)
                .map(|d| d.to_string())
                .as_deref(),
            Some(expect)
        );
    };
    check(27.46, 3, 1, "027.5");
    check(0.35, 1, 3, "0.350");
    check(-0.04, 1, 1, "0.0");
    check(-4.06, 1, 1, "-4.1");
    assert_eq!(Decimal::from_f64(f64::NAN, 1, 1), None);
    assert_eq!(Decimal::from_f64(f64::INFINITY, 1, 1), None);
}
