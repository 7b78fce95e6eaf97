//! Positions without differential correction: a caution, or no position for track control, as it is set (AP-7, TCS-8).

use crate::rig::{Rig, edited, route};
use wheelover_core::alerts::Alert;
use wheelover_core::settings::{Differential, Value};
use wheelover_core::station::Profile;
use wheelover_core::view::{ChartRequest, ModeName, ModeRequest, Order};

/// The receiver has lost its corrections: GLL with mode A.
fn plain(rig: &mut Rig) {
    rig.filter(|_, from, line| {
        let plain = from == Profile::Gps && line.contains("GLL,");
        Some(if plain {
            edited(line, &[(7, "A")])
        } else {
            line.to_string()
        })
    });
}

fn set(rig: &mut Rig, value: &str) {
    let (key, value) = ("differential".into(), Value::Choice(value.into()));
    rig.command(Order::Setting { key, value }).unwrap();
}

#[test]
fn by_default_it_engages_and_goes_on_with_a_caution() {
    let mut rig = Rig::new(route(&[(245.0, 2.5), (305.0, 2.5)], 0.5), 3);
    plain(&mut rig);
    rig.engage();
    rig.run(60.0);
    assert_eq!(rig.mode(), ModeName::AutonavTi);
    assert!(rig.raised(Alert::NoDifferential) && !rig.raised(Alert::TrackFail));
}

#[test]
fn where_it_is_required_the_selection_waits_for_it_and_lapses() {
    let mut rig = Rig::new(route(&[(245.0, 2.5), (305.0, 2.5)], 0.5), 3);
    set(&mut rig, "required");
    plain(&mut rig);
    rig.run(5.0);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.ask(ChartRequest::Track).unwrap();
    rig.run(5.0);
    let answer = rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    assert_eq!(answer, "no differential correction");
    rig.run(21.0);
    assert_eq!(rig.mode(), ModeName::Auto);
    let why = rig.autopilot().why();
    assert!(why.contains("no differential correction"), "{why}");
    // Corrected again, it engages.
    rig.filter(|_, _, line| Some(line.to_string()));
    rig.run(3.0);
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    rig.until("Ti", 10.0, |rig| rig.mode() == ModeName::AutonavTi);
    rig.check_orders();
}

// Treated as the position itself would be: a caution after 3 s, TRACK FAIL after 5 s.
#[test]
fn where_it_is_required_its_loss_is_the_loss_of_the_position() {
    let mut rig = Rig::tracking_as(|config| {
        config.settings.differential = Differential::Required;
    });
    rig.run(20.0);
    plain(&mut rig);
    let late = rig.until("caution", 4.5, |rig| rig.raised(Alert::TrackDataLate));
    let text = rig.text(Alert::TrackDataLate);
    assert!(text.contains("differential correction"), "{text}");
    assert_eq!(rig.mode(), ModeName::AutonavTi);
    let failed = rig.until("fail", 3.0, |rig| rig.raised(Alert::TrackFail));
    let between = failed.since(late);
    assert!((1_900..=2_200).contains(&between), "{between} ms");
    assert_eq!(rig.mode(), ModeName::Auto);
    let text = rig.text(Alert::TrackFail);
    assert!(text.contains("differential correction"), "{text}");
    assert!((rig.set_heading() - rig.heading().deg()).abs() < 1.0);
    rig.check_orders();
}

// What is required later counts at once.
#[test]
fn required_while_it_is_missing_ends_track_control() {
    let mut rig = Rig::tracking();
    plain(&mut rig);
    rig.run(30.0);
    assert_eq!(rig.mode(), ModeName::AutonavTi);
    set(&mut rig, "required");
    rig.until("fail", 0.3, |rig| rig.raised(Alert::TrackFail));
    assert_eq!(rig.mode(), ModeName::Auto);
    rig.check_orders();
}
