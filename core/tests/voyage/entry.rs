//! Entering AutoNAV: both sides within 20 s, three commands in a row, and what is refused (AP-6, AP-7, FA12 to FA14).

use crate::rig::{Rig, edited, route};
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use wheelover_core::alerts::Alert;
use wheelover_core::nmea::SteeringMode;
use wheelover_core::settings::Value;
use wheelover_core::station::Profile;
use wheelover_core::view::{ChartRequest, ModeName, ModeRequest, Order};

fn in_auto() -> Rig {
    let mut rig = Rig::new(route(&[(245.0, 2.5), (305.0, 2.5)], 0.5), 5);
    rig.run(5.0);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.run(5.0);
    rig
}

// AP-6: the operator first.
#[test]
fn the_operator_may_ask_before_the_chart_system() {
    let mut rig = in_auto();
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    rig.run(10.0);
    assert_eq!(rig.mode(), ModeName::Auto);
    assert!(rig.autopilot().pending().is_some());
    rig.ask(ChartRequest::Track).unwrap();
    rig.until("track control", 5.0, |rig| {
        rig.mode() == ModeName::AutonavTi
    });
    rig.check_orders();
}

// AP-6: the chart system first.
#[test]
fn the_chart_system_may_ask_before_the_operator() {
    let mut rig = in_auto();
    rig.ask(ChartRequest::Track).unwrap();
    rig.run(10.0);
    assert_eq!(rig.mode(), ModeName::Auto);
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    rig.until("track control", 1.0, |rig| {
        rig.mode() == ModeName::AutonavTi
    });
}

// AP-6, FA14
#[test]
fn a_selection_without_confirmation_lapses_after_twenty_seconds() {
    let mut rig = in_auto();
    let asked = rig.now;
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    rig.until("the lapse", 21.0, |rig| rig.autopilot().pending().is_none());
    let waited = rig.now.since(asked);
    assert!((19_900..=20_100).contains(&waited), "{waited}");
    rig.ask(ChartRequest::Track).unwrap();
    rig.run(10.0);
    assert_eq!(rig.mode(), ModeName::Auto);
}

// FA14: three in a row, none fewer.
#[test]
fn the_first_engagement_needs_three_commands_in_a_row() {
    let mut rig = in_auto();
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    let passed = Arc::new(AtomicU32::new(0));
    let count = passed.clone();
    rig.filter(move |_, _, line| {
        if line.contains("HTC,V,,,T") {
            count.fetch_add(1, Ordering::Relaxed);
        }
        Some(line.to_string())
    });
    rig.ask(ChartRequest::Track).unwrap();
    rig.until("track control", 6.0, |rig| {
        rig.mode() == ModeName::AutonavTi
    });
    assert_eq!(passed.load(Ordering::Relaxed), 3);
}

// FA14: every third is refused, so there are never three in a row.
#[test]
fn a_refused_command_breaks_the_row() {
    let mut rig = in_auto();
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    let mut count = 0;
    rig.filter(move |_, _, line| {
        if !line.contains("HTC,V,,,T") {
            return Some(line.to_string());
        }
        count += 1;
        Some(if count % 3 == 0 {
            edited(line, &[(12, "361.0")])
        } else {
            line.to_string()
        })
    });
    rig.ask(ChartRequest::Track).unwrap();
    rig.run(18.0);
    assert_eq!(rig.mode(), ModeName::Auto);
}

// AP-6
#[test]
fn autonav_is_entered_from_auto_only_and_never_in_a_turn() {
    let mut rig = Rig::new(route(&[(245.0, 2.5), (305.0, 2.5)], 0.5), 5);
    rig.run(3.0);
    let refusal = rig.command(Order::Mode(ModeRequest::Autonav)).unwrap_err();
    assert_eq!(refusal, "AutoNAV is selected from AUTO only");

    let mut rig = Rig::tracking();
    rig.until("the arc", 900.0, |rig| rig.chart().situation() == 4);
    rig.run(5.0);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    let refusal = rig.command(Order::Mode(ModeRequest::Autonav)).unwrap_err();
    assert!(refusal.contains("not in the middle of a turn"), "{refusal}");
    // TCS-13: the chart system has stopped, and does not begin there either.
    rig.run(2.0);
    assert_eq!(rig.chart().control_name(), "off");
    let refusal = rig.ask(ChartRequest::Track).unwrap_err();
    assert!(refusal.contains("not in the middle of a turn"), "{refusal}");
    rig.check_orders();
}

// TCS-13
#[test]
fn the_chart_system_stops_when_the_operator_takes_the_ship() {
    for request in [ModeRequest::Standby, ModeRequest::Auto] {
        let mut rig = Rig::tracking();
        rig.run(20.0);
        rig.command(Order::Mode(request)).unwrap();
        rig.run(5.0);
        assert_eq!(rig.chart().control_name(), "off");
        let mut alerts = rig.chart().alerts().iter();
        assert!(alerts.any(|standing| standing.alert == Alert::AutopilotLeft));
        assert!(
            rig.line("HTC").contains("HTC,V,,,S,"),
            "{}",
            rig.line("HTC")
        );
        rig.check_orders();
    }
}

// FA12, HTC-1
#[test]
fn override_ends_in_standby_at_once_and_does_not_resume() {
    let mut rig = Rig::tracking();
    rig.run(20.0);
    rig.filter(|_, _, line| {
        Some(if line.contains("HTC,") {
            edited(line, &[(1, "A")])
        } else {
            line.to_string()
        })
    });
    rig.until("STANDBY", 1.1, |rig| rig.mode() == ModeName::Standby);
    assert_eq!(rig.autopilot().rudder_order(), None);
    assert!(rig.raised(Alert::Override));
    rig.run(1.1);
    let htd = rig.last_htd();
    assert_eq!(htd.steering_mode, Some(SteeringMode::Manual));
    assert_eq!((htd.rudder_angle, htd.heading_to_steer), (None, None));
    let refusal = rig.command(Order::Mode(ModeRequest::Auto)).unwrap_err();
    assert_eq!(refusal, "override is in use");
    rig.filter(|_, _, line| Some(line.to_string()));
    rig.run(15.0);
    assert_eq!(rig.mode(), ModeName::Standby);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.run(5.0);
    rig.check_orders();
}

/// Track control must not begin with this status in field 14, and must fail when it comes.
fn never_acted_on(status: &'static str, accept_null: bool) {
    let key = "accept_null_status".to_string();
    let value = Value::Switch(accept_null);
    let setting = Order::Setting { key, value };
    let with_status = move |line: &str| {
        Some(if line.contains("HTC,") {
            edited(line, &[(14, status)])
        } else {
            line.to_string()
        })
    };
    let mut rig = in_auto();
    rig.command(setting.clone()).unwrap();
    rig.filter(move |_, _, line| with_status(line));
    rig.ask(ChartRequest::Track).unwrap();
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    rig.run(12.0);
    assert_eq!(rig.mode(), ModeName::Auto, "{status:?}");

    let mut rig = Rig::tracking();
    rig.command(setting).unwrap();
    rig.run(10.0);
    rig.filter(move |_, _, line| with_status(line));
    rig.until("TRACK FAIL", 6.3, |rig| rig.raised(Alert::TrackFail));
    assert_eq!(rig.mode(), ModeName::Auto, "{status:?}");
    rig.check_orders();
}

// FA13, HTC 14
#[test]
fn a_status_report_is_no_command() {
    never_acted_on("R", true);
    never_acted_on("X", true);
    never_acted_on("c", true);
}

// FA13
#[test]
fn a_null_status_is_a_command_only_where_it_is_accepted() {
    never_acted_on("", false);
    let mut rig = in_auto();
    rig.filter(|_, _, line| {
        Some(if line.contains("HTC,") {
            edited(line, &[(14, "")])
        } else {
            line.to_string()
        })
    });
    rig.ask(ChartRequest::Track).unwrap();
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    rig.until("track control", 6.0, |rig| {
        rig.mode() == ModeName::AutonavTi
    });
}

// TCS-7 and AP-7 are about what is there; a ship without position is refused track control.
#[test]
fn without_position_track_control_is_refused_with_the_reason() {
    let mut rig = in_auto();
    rig.ask(ChartRequest::Track).unwrap();
    rig.filter(|_, from, line| {
        let position = line.contains("GLL,") && matches!(from, Profile::Gps | Profile::Ecdis);
        (!position).then(|| line.to_string())
    });
    rig.run(6.0);
    let text = rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    assert_eq!(text, "no position");
    rig.run(5.0);
    assert_eq!(rig.mode(), ModeName::Auto);
}
