//! A silenced alarm sounds again by itself after 30 s, at either station, and that is told (FA15, MSC.302(87) 7.3.5).

use crate::rig::{Rig, outside};
use wheelover_core::alerts::{Alert, State};
use wheelover_core::nmea::{self, AlertState, Alf};
use wheelover_core::station::{Profile, Role};
use wheelover_core::view::{FaultKind, Order};

fn state(rig: &Rig, alert: Alert) -> State {
    let chart = rig.chart().alerts().iter();
    let mut all = rig.autopilot().alerts().standing().iter().chain(chart);
    let found = all.find(|standing| standing.alert == alert);
    found.map_or(State::Normal, |standing| standing.state)
}

/// Silences, and waits for the sound; nothing else happens meanwhile.
fn check(rig: &mut Rig, alert: Alert) {
    rig.command(Order::Silence(true)).unwrap();
    let silenced = rig.now;
    assert_eq!(state(rig, alert), State::Silenced, "{alert:?}");
    let again = rig.until("the sound", 35.0, |rig| {
        state(rig, alert) != State::Silenced
    });
    assert_eq!(state(rig, alert), State::Unacknowledged, "{alert:?}");
    let took = again.since(silenced);
    assert!((29_000..=31_000).contains(&took), "{alert:?}: {took} ms");
}

// FA15
#[test]
fn a_silenced_alarm_sounds_again_by_itself_at_either_station() {
    let mut rig = Rig::tracking();
    rig.silence(Profile::Ecdis, "HTC,");
    rig.until("TRACK FAIL", 6.0, |rig| rig.raised(Alert::TrackFail));
    rig.injure(Profile::Gps, FaultKind::Cut, true);
    rig.until("NO POSITION", 9.0, |rig| {
        state(rig, Alert::ChartPositionLost) == State::Unacknowledged
    });
    // As often as it is silenced.
    for alert in [Alert::TrackFail, Alert::ChartPositionLost, Alert::TrackFail] {
        check(&mut rig, alert);
    }
    // One that was taken while it was silent does not.
    rig.command(Order::Silence(true)).unwrap();
    let number = Alert::TrackFail.number();
    rig.command(Order::Acknowledge(number)).unwrap();
    rig.run(40.0);
    assert_eq!(state(&rig, Alert::TrackFail), State::Acknowledged);
}

/// States of TRACK FAIL as a bridge alert management is told them, each once.
fn told(rig: &Rig) -> Vec<AlertState> {
    let mut states: Vec<AlertState> = Vec::new();
    for (_, line) in &rig.sent {
        let alf = Alf::from_sentence(&nmea::decode(line.as_bytes()));
        let of =
            |alf: &Alf| alf.alert.map(u64::from) == Some(u64::from(Alert::TrackFail.identifier()));
        let state = alf.filter(of).and_then(|alf| alf.state);
        states.extend(state.filter(|state| states.last() != Some(state)));
    }
    states
}

// FA15, AP-11: who sounds for the autopilot hears it without asking.
#[test]
fn that_it_sounds_again_is_told_to_the_alert_management() {
    let (station, mut port) = outside(Role::Autopilot, "bams", Profile::Bams);
    port.output = true;
    let mut rig = Rig::tracking_with(vec![(station, port)]);
    rig.silence(Profile::Ecdis, "HTC,");
    rig.until("TRACK FAIL", 6.0, |rig| rig.raised(Alert::TrackFail));
    rig.run(2.0);
    rig.sent.clear();
    check(&mut rig, Alert::TrackFail);
    rig.run(2.0);
    let told = told(&rig);
    assert_eq!(
        told,
        [AlertState::Silenced, AlertState::ActiveUnacknowledged]
    );
}
