//! A test a row of the situation table: exact fields of what the chart system sends and the autopilot answers.

use crate::rig::Rig;
use wheelover_core::geo::{Position, rhumb};
use wheelover_core::nmea::{self, Htc, Pney1, Pney2, SteeringMode, TurnMode, Xte};
use wheelover_core::view::{ChartRequest, ModeName};

struct Row {
    htc: Htc,
    xte: Xte,
    pney1: Pney1,
    pney2: Pney2,
}

fn row(rig: &Rig) -> Row {
    let lines = ["HTC", "XTE", "PNEY,001", "PNEY,002"].map(|formatter| rig.line(formatter));
    let [htc, xte, pney1, pney2] = lines.each_ref().map(|line| nmea::decode(line.as_bytes()));
    for formatter in ["HTC", "XTE", "PNEY,001", "PNEY,002", "GLL", "VTG", "VHW"] {
        let line = rig.line(formatter);
        let sentence = nmea::decode(line.as_bytes());
        assert!(
            sentence.faults().is_empty(),
            "{line}: {:?}",
            sentence.faults()
        );
        assert!(line.len() <= 80, "{line}");
    }
    Row {
        htc: Htc::from_sentence(&htc).unwrap(),
        xte: Xte::from_sentence(&xte).unwrap(),
        pney1: Pney1::from_sentence(&pney1).unwrap(),
        pney2: Pney2::from_sentence(&pney2).unwrap(),
    }
}

/// The rig some seconds after the chart system came into the situation, so that HTD has answered.
fn at_situation(number: u8) -> Rig {
    let mut rig = Rig::tracking();
    rig.until("the situation", 1_200.0, |rig| {
        rig.chart().situation() == number
    });
    rig.run(2.5);
    assert_eq!(rig.chart().situation(), number);
    rig
}

fn fields(line: &str) -> Vec<&str> {
    line.split('*').next().unwrap().split(',').collect()
}

fn id(row: &Row) -> &str {
    row.pney2.waypoint.as_deref().unwrap_or("")
}

fn near(value: Option<f64>, expect: f64, tolerance: f64) {
    let value = value.expect("a value");
    assert!((value - expect).abs() <= tolerance, "{value} for {expect}");
}

fn same_place(a: Position, b: Position) {
    let metres = rhumb::between(a, b).1.m();
    assert!(metres < 5.0, "{metres} m apart");
}

#[test]
fn situation_1_not_active() {
    let mut rig = Rig::new(crate::rig::route(&[(245.0, 2.5), (305.0, 2.5)], 0.5), 1);
    rig.run(8.0);
    assert_eq!(rig.chart().situation(), 1);
    let row = row(&rig);
    assert_eq!(
        fields(&rig.line("HTC")),
        [
            "$EIHTC", "V", "", "", "S", "N", "", "", "", "", "", "", "", "T", "C"
        ]
    );
    assert_eq!(row.xte.cross_track, row.pney1.cross_track);
    assert!(row.xte.cross_track.is_some());
    assert_eq!((row.pney2.centre, id(&row)), (None, "WP1"));
    assert_eq!(rig.last_htd().steering_mode, Some(SteeringMode::Manual));
}

#[test]
fn situation_1_without_a_route() {
    let route = crate::rig::route(&[(245.0, 2.5), (305.0, 2.5)], 0.5);
    let mut rig = Rig::without_route(route, 1);
    rig.run(8.0);
    // TCS-2: magnitude and direction are null; PNEY,002 is all null.
    assert_eq!(&fields(&rig.line("XTE"))[3..5], ["", ""]);
    assert_eq!(&fields(&rig.line("PNEY,001"))[4..6], ["", ""]);
    assert_eq!(row(&rig).pney2, Pney2::default());
}

#[test]
fn situation_2_active_on_a_leg() {
    let rig = at_situation(2);
    let row = row(&rig);
    assert_eq!(
        fields(&rig.line("HTC")),
        [
            "$EIHTC", "V", "", "", "T", "R", "", "", "", "", "", "", "245.0", "T", "C"
        ]
    );
    assert_eq!(row.xte.cross_track, row.pney1.cross_track);
    assert_eq!((row.pney2.centre, id(&row)), (None, "WP1"));
    let htd = rig.last_htd();
    assert_eq!(htd.steering_mode, Some(SteeringMode::TrackControl));
    assert_eq!(htd.turn_mode, Some(TurnMode::NotControlled));
    // AP-2: before the first turn AUTO's radius; the rate is null on legs.
    assert_eq!((htd.radius, htd.rate_of_turn), (Some(0.5), None));
    near(htd.track, 245.0, 0.05);
}

#[test]
fn situation_3_on_the_forwarding_distance() {
    let rig = at_situation(3);
    let row = row(&rig);
    assert_eq!(row.htc.steering_mode, Some(SteeringMode::TrackControl));
    assert_eq!(row.htc.turn_mode, Some(TurnMode::Radius));
    near(row.htc.radius, 0.5, 1e-9);
    near(row.htc.track, 305.0, 0.05);
    assert_eq!(row.htc.heading_to_steer, None);
    // Both distances still refer to the current leg.
    assert_eq!(row.xte.cross_track, row.pney1.cross_track);
    assert_eq!(id(&row), "WP1");
    same_place(row.pney2.centre.unwrap(), rig.route.turns()[0].centre());
    let htd = rig.last_htd();
    assert_eq!(htd.steering_mode, Some(SteeringMode::TrackControl));
    assert_eq!(htd.turn_mode, Some(TurnMode::Radius));
    near(htd.radius, 0.5, 1e-9);
    near(htd.track, 305.0, 0.05);
    assert!(htd.rate_of_turn.is_some());
}

#[test]
fn situation_4_on_the_radius() {
    let mut rig = at_situation(4);
    rig.run(20.0);
    let row = row(&rig);
    near(row.htc.radius, 0.5, 1e-9);
    near(row.htc.track, 305.0, 0.05);
    assert_eq!(id(&row), "WP1");
    same_place(row.pney2.centre.unwrap(), rig.route.turns()[0].centre());
    // XTE is the distance to the arc, PNEY,001 the one to the next leg.
    let position = rig.world().truth().position;
    let arc = rig.route.turns()[0].cross_track(position).nm();
    let leg = rig.route.leg(1).cross_track(position).nm();
    near(row.xte.cross_track, arc, 0.006);
    near(row.pney1.cross_track, leg, 0.006);
    assert!((arc - leg).abs() > 0.03, "the two must differ here");
    let htd = rig.last_htd();
    assert_eq!(htd.turn_mode, Some(TurnMode::Radius));
    near(htd.radius, 0.5, 1e-9);
    assert!(htd.rate_of_turn.unwrap() > 10.0);
}

#[test]
fn situation_5_turn_finished() {
    let rig = at_situation(5);
    let row = row(&rig);
    assert_eq!(row.htc.turn_mode, Some(TurnMode::Radius));
    assert_eq!(row.htc.radius, None);
    near(row.htc.track, 305.0, 0.05);
    assert_eq!(row.xte.cross_track, row.pney1.cross_track);
    assert_eq!((row.pney2.centre, id(&row)), (None, "WP2"));
    let htd = rig.last_htd();
    assert_eq!(htd.steering_mode, Some(SteeringMode::TrackControl));
    assert_eq!(htd.turn_mode, Some(TurnMode::NotControlled));
    // AP-2: the last accepted radius stays.
    assert_eq!((htd.radius, htd.rate_of_turn), (Some(0.5), None));
    rig.check_orders();
}

#[test]
fn situation_6_end_of_route() {
    let rig = at_situation(6);
    let row = row(&rig);
    assert_eq!(
        fields(&rig.line("HTC")),
        [
            "$EIHTC", "V", "", "", "S", "N", "", "", "", "", "", "", "", "T", "C"
        ]
    );
    assert_eq!((row.xte.cross_track, row.pney1.cross_track), (None, None));
    assert_eq!(row.pney2, Pney2::default());
    assert_eq!(rig.mode(), ModeName::Auto);
    let htd = rig.last_htd();
    assert_eq!(htd.steering_mode, Some(SteeringMode::StandAlone));
    assert_eq!(htd.turn_mode, Some(TurnMode::NotControlled));
    assert_eq!(
        (htd.heading_to_steer, htd.off_track_limit, htd.track),
        (None, None, None)
    );
    rig.check_orders();
}

// TCS-12, AP-3
#[test]
fn in_tn_the_heading_to_steer_is_the_track_during_turns() {
    let mut rig = Rig::tracking();
    rig.ask(ChartRequest::Heading).unwrap();
    rig.until("Tn", 5.0, |rig| rig.mode() == ModeName::AutonavTn);
    rig.run(3.0);
    let leg = row(&rig).htc;
    assert_eq!(leg.steering_mode, Some(SteeringMode::HeadingControl));
    assert_eq!(leg.turn_mode, Some(TurnMode::NotControlled));
    let htd = rig.last_htd().clone();
    assert_eq!(htd.steering_mode, Some(SteeringMode::HeadingControl));
    assert_eq!((htd.radius, htd.rate_of_turn), (None, None));
    assert_eq!(htd.heading_to_steer, leg.heading_to_steer);
    rig.until("a turn in Tn", 900.0, |rig| {
        row(rig).htc.turn_mode == Some(TurnMode::Rate)
    });
    rig.run(3.0);
    let turn = row(&rig).htc;
    assert_eq!(turn.heading_to_steer, turn.track);
    assert_eq!(rig.last_htd().turn_mode, Some(TurnMode::Rate));
    // HTD answers the command of a second before.
    near(rig.last_htd().rate_of_turn, turn.rate_of_turn.unwrap(), 1.0);
    rig.check_orders();
}
