//! Alerts of another system: what ALR, ALA, ALF and ALC make of them, and how they are acknowledged.

use super::*;
use crate::nmea::{decode, with_checksum};
use alloc::string::ToString;

/// Hears a line; what is asked then, and what stands: number, state, revision, title, text.
fn check(
    alerts: &mut HeardAlerts,
    body: &str,
    asked: &[&str],
    stands: &[(u32, State, u32, &str, &str)],
) {
    let line = with_checksum(body);
    let questions = alerts.hear(Stamp(0), &decode(line.as_bytes()));
    let questions: Vec<String> = questions.iter().map(|acn| acn.line("EI")).collect();
    let asked: Vec<String> = asked.iter().map(|body| with_checksum(body)).collect();
    assert_eq!(questions, asked, "{body}");
    let are: Vec<_> = alerts
        .standing()
        .iter()
        .map(|one| {
            (
                one.number,
                one.state,
                one.revision,
                one.title.as_str(),
                one.text.as_str(),
            )
        })
        .collect();
    assert_eq!(are, stands, "{body}");
}

use State::{Acknowledged, RectifiedUnacknowledged, Silenced, Unacknowledged};

// AP-11, TCS-13: condition and acknowledgement are the whole state.
#[test]
fn what_alr_and_ala_tell_stands_until_it_is_over_and_taken() {
    let mut alerts = HeardAlerts::default();
    let told = |state| {
        [(
            12,
            state,
            0,
            "ALERT 12",
            "Alert 12 there: see its list of alerts",
        )]
    };
    check(&mut alerts, "AGALR,,012,V,A,", &[], &[]);
    check(&mut alerts, "AGALR,,012,A,V,", &[], &told(Unacknowledged));
    assert_eq!(
        alerts.acknowledgement(12, "EI"),
        Some(with_checksum("EIACK,012"))
    );
    check(&mut alerts, "AGALR,,012,A,A,", &[], &told(Acknowledged));
    assert_eq!(alerts.acknowledgement(12, "EI"), None);
    assert_eq!(alerts.acknowledgement(13, "EI"), None);
    check(
        &mut alerts,
        "AGALA,,OT,JP,01,012,N,V,",
        &[],
        &told(RectifiedUnacknowledged),
    );
    check(
        &mut alerts,
        "AGALA,,OT,JP,01,012,,V,",
        &[],
        &told(RectifiedUnacknowledged),
    );
    check(&mut alerts, "AGALA,,OT,JP,01,012,N,A,", &[], &[]);
    check(
        &mut alerts,
        "AGALA,,OT,JP,01,012,H,V,hot",
        &[],
        &[(12, Unacknowledged, 0, "ALERT 12", "hot")],
    );
}

// F2: two sentences are one alert; a list asks for what is not known so.
#[test]
fn what_alf_and_alc_tell_is_joined_and_compared() {
    let mut alerts = HeardAlerts::default();
    let one = |state, revision, text| (10_101, state, revision, "FAIL", text);
    let first = "AGALF,2,1,3,,B,A,V,,10101,1,1,0,FAIL";
    check(&mut alerts, first, &[], &[one(Unacknowledged, 1, "")]);
    // Of another alert, or of another message.
    check(
        &mut alerts,
        "AGALF,2,2,4,,,,,,10101,1,1,0,no",
        &[],
        &[one(Unacknowledged, 1, "")],
    );
    check(&mut alerts, first, &[], &[one(Unacknowledged, 1, "")]);
    check(
        &mut alerts,
        "AGALF,2,2,3,,,,,,10102,1,1,0,no",
        &[],
        &[one(Unacknowledged, 1, "")],
    );
    check(&mut alerts, first, &[], &[one(Unacknowledged, 1, "")]);
    let whole = [one(Unacknowledged, 1, "HTC missing")];
    check(
        &mut alerts,
        "AGALF,2,2,3,,,,,,10101,1,1,0,HTC missing",
        &[],
        &whole,
    );
    let acn = "EIACN,,,10101,1,A,C";
    assert_eq!(
        alerts.acknowledgement(10_101, "EI"),
        Some(with_checksum(acn))
    );
    check(&mut alerts, "AGALC,01,01,00,1,,10101,1,1", &[], &whole);
    check(
        &mut alerts,
        "AGALC,01,01,01,1,,10101,1,2",
        &["EIACN,,,10101,1,Q,C"],
        &whole,
    );
    let silenced = [one(Silenced, 2, "HTC missing")];
    check(
        &mut alerts,
        "AGALF,1,1,4,,B,A,S,,10101,1,2,0,FAIL",
        &[],
        &silenced,
    );
    // A list that lacks a page ends nothing; a whole one does.
    check(&mut alerts, "AGALC,03,01,02,0", &[], &silenced);
    check(&mut alerts, "AGALC,03,03,02,0", &[], &silenced);
    check(
        &mut alerts,
        "AGALC,02,01,03,1,FEC,10102,,1",
        &["EIACN,,FEC,10102,,Q,C"],
        &silenced,
    );
    check(&mut alerts, "AGALC,02,02,03,0", &[], &[]);
}

#[test]
fn what_is_for_nobody_here_is_not_acknowledged() {
    for (body, may) in [
        ("AGALF,1,1,0,,A,A,V,,10101,1,1,0,T", true),
        ("AGALF,1,1,0,,C,A,V,,10101,1,1,0,T", false),
        ("AGALF,1,1,0,,B,C,V,,10101,1,1,0,T", false),
        ("AGALF,1,1,0,,B,W,U,,10101,1,1,0,T", true),
        ("AGALF,1,1,0,,B,E,S,,10101,1,1,0,T", true),
        ("AGALF,1,1,0,,B,A,A,,10101,1,1,0,T", false),
        ("AGALF,1,1,0,,B,A,N,,10101,1,1,0,T", false),
    ] {
        let mut alerts = HeardAlerts::default();
        alerts.hear(Stamp(0), &decode(with_checksum(body).as_bytes()));
        assert_eq!(
            alerts.acknowledgement(10_101, "EI").is_some(),
            may,
            "{body}"
        );
    }
    let mut alerts = HeardAlerts::default();
    for number in 0..500 {
        let body = "AGALR,,".to_string() + &number.to_string() + ",A,V,";
        alerts.hear(Stamp(0), &decode(with_checksum(&body).as_bytes()));
    }
    assert_eq!(alerts.standing().len(), MOST);
}
