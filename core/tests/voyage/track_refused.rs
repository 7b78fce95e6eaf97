//! What ends TRACK, and what of a plotter is refused: the ship never moves by it (AP-14, FA4 to FA6, FB13).

use crate::rig::Rig;
use crate::track::plotter::{Plotter, Spoil, whole};
use crate::track::{in_auto, in_track, plan};
use wheelover_core::alerts::Alert;
use wheelover_core::nmea::with_checksum;
use wheelover_core::station::Profile;
use wheelover_core::view::{ModeName, ModeRequest, Order};

/// The sentence with other fields, counted from 1; others as they are.
fn with(body: &str, formatter: &str, changes: &[(usize, &str)]) -> Option<String> {
    if !body.starts_with(&format!("GP{formatter}")) {
        return Some(body.into());
    }
    let mut fields: Vec<&str> = body.split(',').collect();
    for (index, text) in changes {
        fields[*index] = text;
    }
    Some(fields.join(","))
}

fn without(body: &str, formatter: &str) -> Option<String> {
    (!body.contains(formatter)).then(|| body.into())
}

/// TRACK has ended in AUTO on the heading as it was, and the alarm begins with `said`.
fn has_failed(rig: &Rig, said: &str) {
    assert_eq!(rig.mode(), ModeName::Auto, "{said}");
    let text = rig.text(Alert::TrackFail);
    assert!(text.starts_with(said), "“{text}” should say “{said}”");
    let turned = (rig.set_heading() - rig.heading().deg() + 540.0).rem_euclid(360.0) - 180.0;
    assert!(
        turned.abs() < 1.0,
        "{said}: set {} of {}",
        rig.set_heading(),
        rig.heading().deg()
    );
    rig.check_orders();
}

// AP-14, TCS-8: silence is a caution at 3 s and TRACK FAIL at 5 s.
#[test]
fn a_silent_plotter_is_late_then_track_fails_on_the_present_heading() {
    let mut plotter = Plotter::new(&plan());
    let mut rig = in_track(&mut plotter, 0.0);
    rig.follow(&mut plotter, 60, &whole);
    let last = rig.now - 1_000;
    rig.until("late", 4.0, |rig| rig.raised(Alert::TrackDataLate));
    assert!(
        (2_900..=3_200).contains(&rig.now.since(last)),
        "{}",
        rig.now.since(last)
    );
    assert_eq!(rig.text(Alert::TrackDataLate), "APB late");
    rig.until("TRACK FAIL", 4.0, |rig| rig.raised(Alert::TrackFail));
    assert!(
        (4_900..=5_300).contains(&rig.now.since(last)),
        "{}",
        rig.now.since(last)
    );
    has_failed(&rig, "APB missing: AUTO steers, SWITCH TO AUTO");
    assert!(!rig.raised(Alert::TrackDataLate));
    // Nothing comes back by itself.
    rig.follow(&mut plotter, 20, &whole);
    assert_eq!(rig.mode(), ModeName::Auto);
    rig.command(Order::Mode(ModeRequest::Track)).unwrap();
    assert!(!rig.raised(Alert::TrackFail));
}

// AP-14, FA5: what calls itself not valid ends TRACK at once.
#[test]
fn a_plotter_without_a_position_ends_track_at_once() {
    for (changes, said) in [
        (&[(1, "V")][..], "APB: its status says not valid"),
        (&[(2, "V")], "APB: its status says not valid"),
        (
            &[(1, "V"), (3, ""), (4, ""), (8, "")],
            "APB: its status says not valid",
        ),
        (&[(15, "N")], "APB: its mode indicator says not valid"),
        (&[(15, "E")], "APB: its mode indicator says estimated"),
        (&[(15, "M")], "APB: its mode indicator says manual"),
        (&[(15, "S")], "APB: its mode indicator says simulator"),
    ] {
        let mut plotter = Plotter::new(&plan());
        let mut rig = in_track(&mut plotter, 0.0);
        rig.follow(&mut plotter, 30, &whole);
        rig.follow(&mut plotter, 1, &|body| with(body, "APB", changes));
        has_failed(&rig, said);
        let refused = rig.command(Order::Mode(ModeRequest::Track)).unwrap_err();
        let why = said.trim_start_matches("APB: ");
        assert!(refused.contains(why), "{refused}");
    }
    for mode in ["A", "D", "P", "F", "R"] {
        let mut plotter = Plotter::new(&plan());
        let mut rig = in_track(&mut plotter, 0.0);
        rig.follow(&mut plotter, 10, &|body| with(body, "APB", &[(15, mode)]));
        assert_eq!(rig.mode(), ModeName::Track, "{mode}");
        assert!(!rig.raised(Alert::TrackDataRefused), "{mode}");
    }
}

/// What is done to what the plotter says, and what is then said of it.
type Case = (&'static str, fn(&str) -> Option<String>, &'static str);

const REFUSED: &[Case] = &[
    (
        "field 3 spoilt",
        |b| with(b, "APB", &[(3, "1.2.3")]),
        "APB refused: field 3: not a number",
    ),
    (
        "no distance",
        |b| with(b, "APB", &[(3, ""), (4, "")]),
        "APB refused: field 3: no cross-track distance",
    ),
    (
        "no side",
        |b| with(b, "APB", &[(4, "")]),
        "APB refused: field ",
    ),
    (
        "no unit",
        |b| with(b, "APB", &[(5, "")]),
        "APB refused: field 5: ",
    ),
    (
        "another unit",
        |b| with(b, "APB", &[(5, "M")]),
        "APB refused: field 5: ",
    ),
    (
        "no course",
        |b| with(b, "APB", &[(8, "")]),
        "APB refused: field 8: no course of the leg",
    ),
    (
        "no course, though a heading to steer",
        |b| with(b, "APB", &[(8, ""), (13, "90.0"), (14, "T")]),
        "APB refused: field 8: no course of the leg",
    ),
    (
        "no north",
        |b| with(b, "APB", &[(9, "")]),
        "APB refused: field 9: neither true nor magnetic",
    ),
    (
        "course out of range",
        |b| with(b, "APB", &[(8, "361.0")]),
        "APB refused: field 8: ",
    ),
    (
        "magnetic",
        |b| with(b, "APB", &[(9, "M")]),
        "APB refused: field 9: magnetic, and no variation is known",
    ),
    (
        "heading to steer magnetic",
        |b| with(b, "APB", &[(13, "90.0"), (14, "M")]),
        "APB refused: field 14: magnetic",
    ),
    (
        "heading to steer of no north",
        |b| with(b, "APB", &[(13, "90.0")]),
        "APB refused: field 14: neither true",
    ),
    (
        "heading to steer astern",
        |b| with(b, "APB", &[(13, "200.0"), (14, "T")]),
        "APB refused: field 13: ",
    ),
    (
        "the leg turns",
        |b| with(b, "APB", &[(8, "110.0")]),
        "APB refused: field 8: the leg's course jumps from 090.0 to 110.0",
    ),
    (
        "a waypoint astern",
        |b| with(b, "APB", &[(11, "270.0")]),
        "APB refused: field 11: ",
    ),
    (
        "distance and XTE jump",
        |b| {
            let far = with(b, "APB", &[(3, "0.400"), (4, "L")])?;
            let far = with(&far, "RMB", &[(2, "0.40"), (3, "L")])?;
            with(&far, "XTE", &[(3, "0.400"), (4, "L")])
        },
        "APB refused: field 3: the cross-track distance jumps by 7",
    ),
    (
        "XTE on the other side",
        |b| with(b, "XTE", &[(3, "0.100"), (4, "L")]),
        "APB refused: XTE has the ship 185 m right of the track, APB ",
    ),
    (
        "RMB elsewhere",
        |b| with(b, "RMB", &[(2, "0.20"), (3, "R")]),
        "APB refused: RMB has the ship 370 m left of the track, APB ",
    ),
    (
        "RMB to another waypoint",
        |b| with(b, "RMB", &[(5, "WP9")]),
        "APB refused: RMB goes to WP9, APB to WP1",
    ),
    (
        "RMB not valid",
        |b| with(b, "RMB", &[(1, "V")]),
        "APB refused: RMB says not valid, APB valid",
    ),
    (
        "XTE not valid",
        |b| with(b, "XTE", &[(6, "N")]),
        "APB refused: XTE says not valid, APB valid",
    ),
    (
        "BWC bears elsewhere",
        |b| with(b, "BWC", &[(6, "60.0")]),
        "APB refused: BWC bears 060.0 to the waypoint, APB 0",
    ),
    (
        "BWC beside the leg",
        |b| {
            let b = with(b, "BWC", &[(6, "60.0")])?;
            with(&b, "APB", &[(11, "")]).and_then(|b| with(&b, "APB", &[(12, "")]))
        },
        "APB refused: BWC bears 060.0 to the waypoint, leg and cross-track distance make it 0",
    ),
    (
        "BWC magnetic to another waypoint",
        |b| with(b, "BWC", &[(12, "WP9")]),
        "APB refused: BWC goes to WP9, APB to WP1",
    ),
    (
        "fifteen fields and one more",
        |b| with(b, "APB", &[(15, "A,1")]),
        "APB refused: ",
    ),
];

// AP-14, FA4: what is refused is said at once or within two sentences, moves nothing, and is TRACK FAIL when it lasts.
#[test]
fn what_contradicts_or_is_spoilt_is_refused_and_named() {
    for (case, spoil, said) in REFUSED {
        let mut plotter = Plotter::new(&plan());
        let mut rig = in_track(&mut plotter, 0.0);
        rig.follow(&mut plotter, 60, &whole);
        let before = rig.last_htd().heading_to_steer.unwrap();
        let spoil: Spoil<'_> = spoil;
        rig.follow(&mut plotter, 3, spoil);
        assert_eq!(rig.mode(), ModeName::Track, "{case}");
        let text = rig.text(Alert::TrackDataRefused);
        assert!(
            text.starts_with(said),
            "{case}: “{text}” should say “{said}”"
        );
        let moved = (rig.last_htd().heading_to_steer.unwrap() - before).abs();
        assert!(moved < 1.0, "{case}: steered {moved} degrees elsewhere");
        rig.follow(&mut plotter, 5, spoil);
        has_failed(&rig, said);
        rig.follow(&mut plotter, 6, &whole);
        rig.command(Order::Mode(ModeRequest::Track)).unwrap();
    }
}

// SEN-2: without a right checksum nothing is followed.
#[test]
fn a_broken_checksum_is_named() {
    let mut plotter = Plotter::new(&plan());
    let mut rig = in_track(&mut plotter, 0.0);
    for _ in 0..6 {
        for body in plotter.says(&rig) {
            let line = with_checksum(&body);
            rig.say_raw(Profile::Plotter, &line.replace('*', "0*"));
        }
        rig.run(1.0);
    }
    has_failed(&rig, "APB refused: checksum missing or wrong");
}

// A single contradiction or glitch is neither followed nor the end.
#[test]
fn one_odd_sentence_moves_nothing_and_ends_nothing() {
    let cases: &[fn(&str) -> Option<String>] = &[
        |b| with(b, "APB", &[(10, "WP7")]),
        |b| with(b, "APB", &[(10, "WP7"), (8, "200.0"), (11, "200.0")]),
        |b| with(b, "RMB", &[(5, "WP9")]),
        |b| with(b, "APB", &[(3, "0.900")]),
        |b| without(b, "APB"),
        |b| with(b, "APB", &[(1, "X")]),
    ];
    for (number, spoil) in cases.iter().enumerate() {
        let mut plotter = Plotter::new(&plan());
        let mut rig = in_track(&mut plotter, 0.0);
        rig.follow(&mut plotter, 60, &whole);
        let before = rig.last_htd().clone();
        rig.follow(&mut plotter, 1, spoil);
        let moved = rig.last_htd().heading_to_steer.unwrap() - before.heading_to_steer.unwrap();
        assert!(moved.abs() < 1.0, "{number}: {moved}");
        rig.follow(&mut plotter, 10, &whole);
        assert_eq!(rig.mode(), ModeName::Track, "{number}");
        assert_eq!(rig.last_htd().track, before.track, "{number}");
        assert!(!rig.raised(Alert::TrackDataRefused), "{number}");
    }
}

// AP-14: without a new waypoint the next leg is refused; with one that is said twice it is taken.
#[test]
fn the_next_leg_is_taken_only_with_a_new_waypoint() {
    let mut plotter = Plotter::new(&plan());
    let mut rig = in_track(&mut plotter, 0.0);
    rig.follow(&mut plotter, 30, &whole);
    plotter.leg = 1;
    plotter.goes_on = false;
    let old_name = |body: &str| {
        let body = body.replace("WP2", "WP1");
        Some(body)
    };
    rig.follow(&mut plotter, 2, &old_name);
    let text = rig.text(Alert::TrackDataRefused);
    assert!(
        text.contains("jumps from 090.0 to 130.0 without a new waypoint"),
        "{text}"
    );
    assert_eq!(rig.last_htd().track, Some(90.0));
    rig.follow(&mut plotter, 3, &whole);
    assert_eq!(rig.mode(), ModeName::Track);
    assert!(
        !rig.raised(Alert::TrackDataRefused),
        "{}",
        rig.text(Alert::TrackDataRefused)
    );
    assert!((rig.last_htd().track.unwrap() - 130.0).abs() < 0.06);
    rig.check_orders();
}

// FB13: two plotters; the first is followed, the other is named and never followed.
#[test]
fn of_two_plotters_the_first_is_followed_and_the_conflict_said() {
    let mut plotter = Plotter::new(&plan());
    let mut rig = in_track(&mut plotter, 0.0);
    for _ in 0..20 {
        rig.follow(&mut plotter, 1, &whole);
        rig.say(
            Profile::Plotter,
            "IIAPB,A,A,0.100,R,N,V,V,200.0,T,XX,200.0,T,200.0,T,A",
        );
    }
    assert_eq!(rig.mode(), ModeName::Track);
    let text = rig.text(Alert::ApbConflict);
    let expect =
        "APB SOURCE CONFLICT: plotter/GP/APB is followed, plotter/II/APB says another and is not";
    assert_eq!(text, expect);
    assert!((rig.last_htd().track.unwrap() - 90.0).abs() < 0.1);
    // The other goes on alone: TRACK ends, and takes it only by the operator.
    for _ in 0..8 {
        rig.say(
            Profile::Plotter,
            "IIAPB,A,A,0.000,R,N,V,V,90.0,T,XX,90.0,T,90.0,T,A",
        );
        rig.run(1.0);
    }
    assert_eq!(rig.mode(), ModeName::Auto);
    rig.command(Order::Mode(ModeRequest::Track)).unwrap();
}

// FE11: an APB on a port that may not say it is no plotter; the chart system's is one.
#[test]
fn apb_is_believed_of_plotter_and_chart_system_only() {
    let say = |from: Profile| {
        let mut rig = Rig::heading_east(&[("plotter", Profile::Plotter)], 0.0);
        rig.command(Order::Mode(ModeRequest::Auto))
            .unwrap_or_default();
        rig.run(2.0);
        rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
        for _ in 0..4 {
            rig.say(from, "GPAPB,A,A,0.000,R,N,V,V,90.0,T,XX,90.0,T,90.0,T,A");
            rig.run(1.0);
        }
        rig.command(Order::Mode(ModeRequest::Track))
    };
    assert!(say(Profile::Plotter).is_ok());
    assert!(say(Profile::Ecdis).is_ok());
    for other in [Profile::Gps, Profile::Gyro1, Profile::Log, Profile::Gear] {
        assert_eq!(say(other).unwrap_err(), "no valid APB", "{other:?}");
    }
}

// A plotter's XTE is not the chart system's: track control is neither kept up nor ended by it.
#[test]
fn a_plotters_xte_never_stands_in_for_the_chart_systems() {
    let mut rig = in_auto(&mut Plotter::new(&plan()), 0.0);
    rig.run(2.0);
    let before = rig.autopilot().picture().xte.clone();
    rig.say(Profile::Plotter, "GPXTE,A,A,0.777,R,N,A");
    let after = rig.autopilot().picture().xte.clone();
    assert_eq!(after.map(|xte| xte.value), before.map(|xte| xte.value));
}
