//! Commands that must not move the rudder: every printed HTC of the source documents, damaged and foreign ones (SEN-2, SEN-5).

use crate::rig::{Rig, edited};
use wheelover_core::nmea::with_checksum;
use wheelover_core::station::Profile;
use wheelover_core::view::{ModeName, ModeRequest, Order};

/// As printed; 12 and 13 fields where the documents lost commas.
pub(crate) const PRINTED: [&str; 7] = [
    "EIHTC,V,,,S,N,,,,,,T,C",
    "EIHTC,V,,,H,N,,,028,345.4,,355.0,T,C",
    "EIHTC,V,,,H,T,,,028,345.4,,355.0,T,C",
    "EIHTC,V,,,T,R,,,,,245.0,T,C",
    "EIHTC,V,,,T,R,,,0.35,,,280.0,T,C",
    "EIHTC,V,,,T,R,,,,,280.0,T,C",
    "EIHTC,V,,,S,N,,,,,,,,T,C,",
];

/// The autopilot in AUTO with AutoNAV asked for, the chart system's own HTC taken away.
fn waiting() -> Rig {
    let mut rig = Rig::tracking();
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.filter(|_, _, line| (!line.contains("EIHTC,V,,,T,R,,,,,,,245.0")).then(|| line.into()));
    rig.run(60.0);
    rig
}

fn refused(lines: &[String]) {
    let mut rig = waiting();
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    let set = rig.set_heading();
    for round in 0..15 {
        for line in lines {
            rig.say(Profile::Ecdis, &line[1..].replace("\r\n", ""));
        }
        rig.run(1.0);
        assert_eq!(rig.mode(), ModeName::Auto, "round {round}: {lines:?}");
    }
    assert_eq!(rig.set_heading(), set);
    let largest = rig.orders.iter().rev().take(150);
    let largest = largest.fold(0.0_f64, |most, (_, order)| most.max(order.unwrap().abs()));
    assert!(largest < 5.0, "order {largest}");
    rig.check_orders();
}

// SEN-5
#[test]
fn no_printed_example_with_missing_commas_is_obeyed() {
    for body in PRINTED {
        let count = body.split(',').count() - 1;
        if count == 14 {
            continue; // stand-alone with its commas: valid, and it commands nothing
        }
        refused(&[format!("${body}")]);
    }
}

// SEN-5
#[test]
fn no_damaged_field_is_obeyed() {
    let good = with_checksum("EIHTC,V,,,T,R,,,,,,,200.0,T,C");
    for (field, text) in [
        (1, "X"),
        (4, "Q"),
        (4, ""),
        (5, "Z"),
        (8, "abc"),
        (9, "1e308"),
        (10, "NaN"),
        (12, "400.0"),
        (12, "-5.0"),
        (12, ""),
        (13, "M"),
        (14, "R"),
    ] {
        let line = edited(&good, &[(field, text)]);
        refused(&[line.split('*').next().unwrap().to_string()]);
    }
}

// SEN-5: more than 14 fields with a fault among them; too few.
#[test]
fn no_wrong_count_is_obeyed() {
    for body in [
        "EIHTC,V,,,T,R,,,,,,,400.0,T,C,7",
        "EIHTC,V,,,T,R,,,,,,,200.0",
        "EIHTC,V,,,T,R",
        "EIHTC",
    ] {
        refused(&[format!("${body}")]);
    }
}
