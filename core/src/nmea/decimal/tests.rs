//! Exact decimals: reading, writing, and every odd text between.

use super::*;
use crate::nmea::tests::given::for_all;
use alloc::string::ToString;
use alloc::vec::Vec;
use core::cell::Cell;
use proptest::collection::vec;
use proptest::prelude::{Just, Strategy, any};
use proptest::sample::select;
use proptest::{prop_assert_eq, prop_oneof};

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

/// A field of up to 20 characters with what stands before it: digits mostly, perhaps a point or a sign.
fn field() -> impl Strategy<Value = (Vec<u8>, usize)> {
    const ODD: &[u8] = b":/-+A,\xff\x00\xb0\x8a";
    let digit = b'0'..=b'9';
    let byte = prop_oneof![39 => digit.clone(), 1 => select(ODD)];
    let odd = prop_oneof![
        1 => Just(None),
        1 => select(ODD).prop_map(|sign| Some((0, sign))),
        2 => (0..20_usize).prop_map(|place| Some((place, b'.'))),
    ];
    let before = vec(digit, 0..24);
    (vec(byte, 1..=20), odd, before).prop_map(|(mut field, odd, mut head)| {
        let length = field.len();
        if let Some((place, byte)) = odd {
            field[place % length] = byte;
        }
        head.extend(field);
        (head, length)
    })
}

#[test]
fn eight_at_a_time_reads_what_one_at_a_time_reads() {
    let read = Cell::new(0);
    for_all(30_000, &field(), |(head, length)| {
        let expect = Decimal::parse(&head[head.len() - length..]);
        read.set(read.get() + usize::from(expect.is_some()));
        prop_assert_eq!(Decimal::parse_last(&head, length), expect);
        Ok(())
    });
    assert!(read.get() > 10_000, "{}", read.get());
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
    let numbers = (any::<u64>(), 0..64_u32, 0..12_u8, 0..9_u8);
    for_all(20_000, &numbers, |(mantissa, shift, scale, whole)| {
        let number = Decimal::new(false, mantissa >> shift, scale, whole);
        let (mut quick, mut plain) = (Vec::new(), Vec::new());
        number.write(&mut quick, true);
        number.write_long(&mut plain);
        prop_assert_eq!(quick, plain);
        Ok(())
    });
}
