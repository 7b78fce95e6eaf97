//! Messages of several sentences: joined, out of order, never completed, too many.

use super::*;
use crate::nmea::with_checksum;

fn feed(assembler: &mut Assembler, at: u64, body: &str) -> Option<Message> {
    assembler.push(Stamp(at), &decode(with_checksum(body).as_bytes()))
}

#[test]
fn two_lines_of_an_alert_are_one() {
    let mut assembler = Assembler::new();
    assert_eq!(
        feed(
            &mut assembler,
            0,
            "AGALF,2,1,5,,B,A,V,,10012,,1,0,TRACK FAIL"
        ),
        None
    );
    let whole = feed(
        &mut assembler,
        100,
        "AGALF,2,2,5,,,,,,10012,,1,0,Switch to AUTO",
    );
    let Some(Message::Alert { alert, description }) = whole else {
        panic!("an alert")
    };
    assert_eq!(alert.text.as_deref(), Some("TRACK FAIL"));
    assert_eq!(description.as_deref(), Some("Switch to AUTO"));
}

#[test]
fn parts_out_of_order_late_or_strange_give_nothing() {
    let mut assembler = Assembler::new();
    let mut check = |steps: &[(u64, &str)], expect: bool| {
        let mut last = None;
        for (at, body) in steps {
            last = feed(&mut assembler, *at, body);
        }
        assert_eq!(last.is_some(), expect, "{steps:?}");
    };
    check(
        &[(0, "!AIVDM,2,1,3,A,55,0"), (1, "!AIVDM,2,2,3,A,66,2")],
        true,
    );
    check(
        &[(0, "!AIVDM,2,2,3,A,66,2"), (1, "!AIVDM,2,1,3,A,55,0")],
        false,
    );
    check(
        &[(0, "!AIVDM,2,1,4,A,55,0"), (1, "!AIVDM,2,2,4,B,66,2")],
        false,
    );
    check(
        &[(0, "!AIVDM,2,1,4,A,55,0"), (20_000, "!AIVDM,2,2,4,A,66,2")],
        false,
    );
    check(&[(0, "!AIVDM,0,0,4,A,55,0")], false);
    check(
        &[(0, "!AIVDM,3,1,4,A,55,0"), (1, "!AIVDM,3,3,4,A,66,2")],
        false,
    );
    check(
        &[(0, "!AIVDM,2,1,4,A,5~5,0"), (1, "!AIVDM,2,2,4,A,66,2")],
        false,
    );
}

#[test]
fn groups_that_never_end_stay_bounded() {
    let mut assembler = Assembler::new();
    for i in 0..10_000u32 {
        let name = alloc::format!("II{}RTE,99,1,c,ROUTE{i},{}", "", "WAYPOINT,".repeat(5));
        feed(&mut assembler, u64::from(i), &name);
    }
    assert!(assembler.held() <= MOST_BYTES && assembler.open.len() <= MOST_MESSAGES);
}
