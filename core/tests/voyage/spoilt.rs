//! A sentence that comes spoilt is not called missing: what is wrong with it is said (FA4, FA5, TCS-8).

use crate::rig::{Rig, edited};
use wheelover_core::alerts::Alert;
use wheelover_core::station::Profile;
use wheelover_core::view::ModeName;

/// What is done to a sentence, and what the alarm then says.
type Case = (&'static str, fn(&str) -> Option<String>, &'static str);

const CASES: [Case; 9] = [
    ("XTE", |_| None, "XTE missing"),
    ("PNEY,001", |_| None, "PNEY,001 missing"),
    (
        "XTE",
        |line| Some(edited(line, &[(3, "1.2.3")])),
        "XTE refused: field 3: not a number",
    ),
    (
        "XTE",
        |line| Some(edited(line, &[(1, "V")])),
        "XTE refused: its status or mode says not valid",
    ),
    (
        "PNEY,001",
        |line| Some(edited(line, &[(7, "N")])),
        "PNEY,001 refused: its status or mode says not valid",
    ),
    (
        "PNEY,001",
        |line| Some(edited(line, &[(4, "-3")])),
        "PNEY,001 refused: field 4: ",
    ),
    (
        "PNEY,002",
        |line| Some(line.replace('*', ",9*")),
        "PNEY,002 refused: checksum missing or wrong",
    ),
    (
        "XTE",
        |line| Some(edited(line, &[(3, ""), (4, "")])),
        "XTE has no distance",
    ),
    (
        "PNEY,001",
        |line| Some(edited(line, &[(4, ""), (5, "")])),
        "PNEY,001 has no distance",
    ),
];

// FA4, FA5
#[test]
fn track_fail_says_what_is_wrong_with_the_sentence() {
    for (formatter, spoil, said) in CASES {
        let mut rig = Rig::tracking();
        rig.filter(move |_, from, line| {
            if from == Profile::Ecdis && line.contains(formatter) {
                spoil(line)
            } else {
                Some(line.into())
            }
        });
        rig.run(7.0);
        assert_eq!(rig.mode(), ModeName::Auto, "{said}");
        let text = rig.text(Alert::TrackFail);
        assert!(text.starts_with(said), "{text} should say {said}");
    }
}

// What is over is not said any more.
#[test]
fn a_refusal_that_is_over_leaves_the_reason_line() {
    let mut rig = Rig::tracking();
    let until = rig.now + 1_000;
    rig.filter(move |now, from, line| {
        let spoilt = from == Profile::Ecdis && now <= until && line.contains("HTC,");
        Some(if spoilt {
            edited(line, &[(12, "400")])
        } else {
            line.into()
        })
    });
    rig.run(1.0);
    let why = rig.autopilot().why().to_string();
    assert!(why.starts_with("HTC refused: field 12"), "{why}");
    rig.run(2.0);
    assert_eq!(
        rig.autopilot().why(),
        "track controlled by the chart system"
    );
}
