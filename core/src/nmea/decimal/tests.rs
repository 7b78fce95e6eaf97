//! Exact decimals: reading, writing, and every odd text between.

use super::*;
use alloc::string::ToString;
use alloc::vec::Vec;

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
fn eight_at_a_time_reads_what_one_at_a_time_reads() {
    let alphabet = b"0123456789.:/-+A,\xff\x00\xb0\x8a";
    let mut state = 0x5EED_u64;
    let mut below = |limit: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 16) as usize % limit
    };
    let mut read = 0;
    for round in 0..300_000 {
        let length = 1 + round % 20;
        let head_length = length + below(24);
        let mut head = [b'7'; 44];
        // Digits mostly.
        for byte in &mut head {
            let most = if below(40) == 0 { alphabet.len() } else { 10 };
            *byte = alphabet[below(most)];
        }
        let start = head_length - length;
        match below(4) {
            0 => {}
            1 => head[start] = alphabet[10 + below(5)],
            _ => head[start + below(length)] = b'.',
        }
        let head = &head[..head_length];
        let expect = Decimal::parse(&head[start..]);
        read += usize::from(expect.is_some());
        assert_eq!(
            Decimal::parse_last(head, length),
            expect,
            "{head:?} {length}"
        );
    }
    assert!(read > 100_000, "{read}");
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

#[test]
fn both_ways_of_writing_give_the_same_digits() {
    let mut state = 0x2545_F491_4F6C_DD1D_u64;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    };
    for _ in 0..200_000 {
        let mantissa = random() >> (random() % 64);
        let number = Decimal::new(false, mantissa, (random() % 12) as u8, (random() % 9) as u8);
        let (mut quick, mut plain) = (Vec::new(), Vec::new());
        number.write(&mut quick, true);
        number.write_long(&mut plain);
        assert_eq!(quick, plain, "{mantissa} {number:?}");
    }
}
