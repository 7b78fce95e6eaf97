//! A clean dialogue gives no breach; each kind of breach is found, named by its rule.

use super::checker::{by_the_clock, says};
use super::*;
use crate::chart_system::tests::Bench;
use crate::command::ChartRequest;
use crate::nmea;
use crate::station::Role;
use crate::talk::Saying;
use alloc::format;
use alloc::string::String;
use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;

type Dialogue = Vec<(f64, String)>;

fn dialogue() -> Dialogue {
    Bench::new().dialogue(ChartRequest::Track)
}

fn checked(lines: &Dialogue) -> (Checker, Vec<Breach>) {
    let mut checker = Checker::new();
    let mut breaches = vec![];
    for (number, (at, line)) in lines.iter().enumerate() {
        checker.take(number as u64 + 1, Some(*at), line.as_bytes(), &mut breaches);
    }
    checker.finish(&mut breaches);
    (checker, breaches)
}

/// The line with its body changed and its checksum made right again.
fn changed(line: &str, change: impl Fn(&mut Vec<String>)) -> String {
    let body = line.trim_start_matches('$').split('*').next().unwrap();
    let mut fields: Vec<String> = body.split(',').map(ToString::to_string).collect();
    change(&mut fields);
    nmea::with_checksum(&fields.join(","))
}

/// Changes each line of a formatter in which the situation is `situation` (0: any); checks which rule is reported.
fn check(
    clean: &Dialogue,
    situation: u8,
    formatter: &str,
    rule: &str,
    words: &str,
    change: impl Fn(&mut Vec<String>),
) {
    let (checker, _) = checked(clean);
    let within = |at: f64| {
        situation == 0
            || checker.spans().iter().any(|span| {
                span.situation == situation && span.from.unwrap() <= at && at <= span.to.unwrap()
            })
    };
    let lines = clean
        .iter()
        .map(|(at, line)| {
            let hit = line
                .get(3..)
                .is_some_and(|rest| rest.starts_with(formatter))
                || line
                    .get(1..)
                    .is_some_and(|rest| rest.starts_with(formatter));
            let line = if hit && within(*at) {
                changed(line, &change)
            } else {
                line.clone()
            };
            (*at, line)
        })
        .collect();
    let (_, breaches) = checked(&lines);
    assert!(
        breaches
            .iter()
            .any(|breach| breach.rule == rule && breach.text.contains(words)),
        "{rule} {words:?} not in {breaches:#?}"
    );
}

#[test]
fn a_clean_dialogue_has_no_breach_and_all_six_situations() {
    let (checker, breaches) = checked(&dialogue());
    assert!(breaches.is_empty(), "{breaches:#?}");
    let situations: Vec<u8> = checker.spans().iter().map(|span| span.situation).collect();
    assert_eq!(situations, [1, 2, 3, 4, 5, 3, 4, 5, 6]);
    assert!(checker.lines() > 8_000);
}

#[test]
fn a_clean_dialogue_in_tn_has_no_breach_and_no_situation() {
    let (checker, breaches) = checked(&Bench::new().dialogue(ChartRequest::Heading));
    assert!(breaches.is_empty(), "{breaches:#?}");
    let situations: Vec<u8> = checker.spans().iter().map(|span| span.situation).collect();
    assert_eq!(situations, [1, 6]);
}

#[test]
fn without_times_only_cadence_is_left_out() {
    let mut checker = Checker::new();
    let mut breaches = vec![];
    for (number, (_, line)) in dialogue().iter().enumerate() {
        checker.take(number as u64, None, line.as_bytes(), &mut breaches);
    }
    checker.finish(&mut breaches);
    assert!(breaches.is_empty(), "{breaches:#?}");
    assert_eq!(checker.spans().len(), 9);
}

#[test]
fn frames_and_fields_are_checked() {
    let clean = dialogue();
    check(&clean, 2, "HTC", "SEN-5", "fields", |fields| {
        fields.remove(6);
        fields.remove(6);
    });
    check(&clean, 2, "GLL", "SEN-6", "minutes", |fields| {
        fields[3] = "12365.635".into()
    });
    check(&clean, 2, "XTE", "SEN-4", "field 4", |fields| {
        fields[4].clear()
    });
    let mut lines = dialogue();
    let last = lines[20].1.len() - 1;
    lines[20].1.replace_range(last.., "x");
    let (_, breaches) = checked(&lines);
    assert!(
        breaches
            .iter()
            .any(|breach| breach.rule == "SEN-2" && breach.line == 21),
        "{breaches:?}"
    );
}

#[test]
fn cadence_is_checked() {
    let clean = dialogue();
    let silent = |from: f64, to: f64, formatter: &str| -> Dialogue {
        let mut lines = clean.clone();
        lines.retain(|(at, line)| !(line.contains(formatter) && (from..to).contains(at)));
        lines
    };
    let said = [Role::ChartSystem, Role::Autopilot].map(says);
    let all: Vec<_> = said
        .into_iter()
        .flatten()
        .filter(|row| by_the_clock(row))
        .collect();
    assert_eq!(all.len(), 10, "{all:?}");
    for row in all {
        let formatter = row.formatter();
        let (_, breaches) = checked(&silent(30.0, 33.0, &format!("{formatter},")));
        // Without the command the rules on what it commands speak too.
        if row.saying == Saying::Htc {
            assert!(breaches.iter().any(|b| b.text.starts_with("HTC: nothing")));
            continue;
        }
        let found: Vec<_> = breaches
            .iter()
            .filter(|breach| breach.rule == "CON-1")
            .collect();
        assert!(
            found.len() == 1 && found[0].text.starts_with(formatter),
            "{breaches:#?}"
        );
    }
    let (_, breaches) = checked(&silent(0.0, 1e9, "PNEY,002"));
    assert!(
        breaches.iter().any(|b| b.text == "PNEY,002 is missing"),
        "{breaches:#?}"
    );
    let slow: Dialogue = dialogue()
        .into_iter()
        .map(|(at, line)| (at * 1.4, line))
        .collect();
    let (_, breaches) = checked(&slow);
    assert!(
        breaches
            .iter()
            .any(|b| b.text == "HTC: period 1.40 s, not 0.8 to 1.2 s"),
        "{breaches:#?}"
    );
    let fast: Dialogue = dialogue()
        .into_iter()
        .map(|(at, line)| (at * 0.5, line))
        .collect();
    assert!(
        checked(&fast)
            .1
            .iter()
            .any(|b| b.text.contains("period 0.50 s"))
    );
}

#[test]
fn the_situation_table_is_checked() {
    let clean = dialogue();
    check(
        &clean,
        3,
        "PNEY,002",
        "TCS-1",
        "a radius without its centre",
        |f| {
            f[2..6].iter_mut().for_each(String::clear);
        },
    );
    check(
        &clean,
        4,
        "HTC",
        "TCS-1",
        "a centre without its radius",
        |f| f[8].clear(),
    );
    check(&clean, 2, "PNEY,001", "TCS-1", "differ on a leg", |f| {
        f[4] = "0.0200".into()
    });
    check(&clean, 4, "XTE", "TCS-1", "off the arc", |f| {
        f[3] = "0.0900".into()
    });
    check(&clean, 3, "PNEY,002", "TCS-1", "waypoint", |f| {
        f[6] = "002".into()
    });
    check(&clean, 2, "HTC", "TCS-1", "turn mode must be R", |f| {
        f[5] = "N".into()
    });
    check(&clean, 1, "HTC", "TCS-1", "turn mode must be N", |f| {
        f[5] = "R".into()
    });
    check(&clean, 2, "HTC", "TCS-1", "no track", |f| f[12].clear());
    check(&clean, 6, "PNEY,002", "TCS-2", "not null together", |f| {
        f[6] = "003".into()
    });
    check(&clean, 2, "XTE", "TCS-3", "status A", |f| f[6] = "N".into());
    check(&clean, 2, "HTC", "TCS-9", "manual", |f| f[4] = "M".into());
    check(&clean, 2, "HTC", "HTC-1", "override", |f| f[1] = "A".into());
    check(&clean, 2, "HTC", "CON-1", "status report", |f| {
        f[14] = "R".into()
    });
}

#[test]
fn on_a_leg_both_distances_are_on_one_side() {
    let mut lines = Bench::right(0.5).dialogue(ChartRequest::Track);
    for (at, line) in &mut lines {
        if line.starts_with("$PNEY,001") && *at < 60.0 {
            *line = changed(line, |f| f[5] = "R".into());
        }
    }
    let (_, breaches) = checked(&lines);
    assert!(
        breaches.iter().any(|b| b.text.contains("different sides")),
        "{breaches:#?}"
    );
}

#[test]
fn the_distances_may_not_part_before_the_arc() {
    let clean = dialogue();
    check(&clean, 3, "PNEY,001", "TCS-1", "differ on a leg", |f| {
        f[4] = "0.0900".into()
    });
}

#[test]
fn the_autopilots_answer_is_checked() {
    let clean = dialogue();
    check(&clean, 4, "HTD", "TCS-4", "echo", |f| f[8] = "0.420".into());
    check(&clean, 4, "HTD", "AP-2", "turn mode must be R", |f| {
        f[5] = "N".into()
    });
    check(&clean, 5, "HTD", "AP-2", "track", |f| {
        f[12] = "245.0".into()
    });
    check(&clean, 2, "HTD", "CON-1", "heading reference", |f| {
        f[13] = "M".into()
    });
    check(&clean, 2, "HTD", "AP-2", "without heading to steer", |f| {
        f[10].clear()
    });
    check(&clean, 2, "HTD", "AP-5", "at the limit", |f| {
        f[2] = "35.0".into()
    });
    check(&clean, 6, "HTD", "TCS-10", "stays in AutoNAV", |f| {
        f[4] = "T".into()
    });
    check(&clean, 1, "HTD", "AP-1", "must be null", |f| {
        f[4] = "M".into()
    });
    let no_order = "without a valid starboard order";
    for situation in [2, 3, 4, 5] {
        check(&clean, situation, "ROR", "AP-4", no_order, |f| f[1].clear());
        check(&clean, situation, "ROR", "AP-4", no_order, |f| {
            f[2] = "V".into()
        });
    }
    let clean_tn = Bench::new().dialogue(ChartRequest::Heading);
    check(&clean_tn, 0, "ROR", "AP-4", no_order, |f| f[1].clear());
    let mut lines = dialogue();
    lines.retain(|(at, line)| !(line.starts_with("$EI") || line.starts_with("$P")) || *at < 60.0);
    let (_, breaches) = checked(&lines);
    assert!(
        breaches.iter().any(|breach| breach.rule == "TCS-8"),
        "{breaches:#?}"
    );
}

#[test]
fn in_tn_the_heading_is_the_track_in_turns() {
    let mut lines = Bench::new().dialogue(ChartRequest::Heading);
    for (_, line) in &mut lines {
        if line.contains("HTC,V,,,H,T") {
            *line = changed(line, |f| f[10] = "100.0".into());
        }
    }
    let (_, breaches) = checked(&lines);
    assert!(
        breaches
            .iter()
            .any(|b| b.rule == "TCS-12" && b.text.contains("is not the track")),
        "{breaches:#?}"
    );
}

#[test]
fn hostile_lines_do_not_stop_it() {
    let mut checker = Checker::new();
    let mut breaches = vec![];
    for (number, line) in [
        &b"\xff\xfe$EIHTC"[..],
        b"",
        b"$",
        b"$EIHTC,*00",
        b"$PNEY,002,,,,,*",
    ]
    .iter()
    .enumerate()
    {
        checker.take(number as u64, Some(f64::NAN), line, &mut breaches);
        checker.take(number as u64, Some(1e300), line, &mut breaches);
    }
    checker.finish(&mut breaches);
}
