//! The alert table, the states of an alert, the order in which alerts are shown.

use super::*;

#[test]
fn every_title_fits_the_alert_sentence() {
    for alert in Alert::ALL {
        assert!(alert.definition().title.len() <= 18, "{alert:?}");
        assert_eq!(Alert::of_number(alert.number()), Some(*alert));
    }
}

// FA15
#[test]
fn a_silenced_alarm_sounds_again_after_thirty_seconds() {
    let mut alerts = Alerts::default();
    alerts.raise(Stamp(0), Alert::TrackFail, "HTC missing");
    alerts.silence(Stamp(1_000));
    alerts.tick(Stamp(30_999));
    assert_eq!(alerts.state(Alert::TrackFail), State::Silenced);
    alerts.tick(Stamp(31_000));
    assert_eq!(alerts.state(Alert::TrackFail), State::Unacknowledged);
}

#[test]
fn a_rectified_alarm_stays_until_it_is_taken() {
    let mut alerts = Alerts::default();
    alerts.raise(Stamp(0), Alert::TrackFail, "");
    alerts.rectify(Stamp(5), Alert::TrackFail);
    assert_eq!(
        alerts.state(Alert::TrackFail),
        State::RectifiedUnacknowledged
    );
    assert!(alerts.acknowledge(Stamp(6), 101));
    assert_eq!(alerts.state(Alert::TrackFail), State::Normal);
    assert!(!alerts.acknowledge(Stamp(7), 101));
}

#[test]
fn a_caution_needs_no_acknowledgement() {
    let mut alerts = Alerts::default();
    alerts.raise(Stamp(0), Alert::SpeedLost, "");
    alerts.rectify(Stamp(5), Alert::SpeedLost);
    assert_eq!(alerts.state(Alert::SpeedLost), State::Normal);
    assert_eq!(alerts.take_changed(), [Alert::SpeedLost]);
}

// DSP-5
#[test]
fn what_nobody_has_taken_stands_before_what_was_taken_and_the_newest_first() {
    fn check(alerts: &Alerts, expect: &[u16]) {
        let mut standing: Vec<&Standing> = alerts.standing().iter().collect();
        standing.sort_by_key(|standing| standing.rank());
        let numbers: Vec<u16> = standing.iter().map(|s| s.alert.number()).collect();
        assert_eq!(numbers, expect);
    }
    let mut alerts = Alerts::default();
    alerts.raise(Stamp(0), Alert::SpeedLost, "");
    alerts.raise(Stamp(1), Alert::TrackFail, "");
    alerts.raise(Stamp(2), Alert::OffHeading, "");
    check(&alerts, &[101, 112, 122]);
    alerts.acknowledge(Stamp(3), 101);
    check(&alerts, &[112, 101, 122]);
    alerts.raise(Stamp(4), Alert::HeadingLost, "");
    alerts.raise(Stamp(5), Alert::Rudder, "");
    check(&alerts, &[130, 110, 112, 101, 122]);
    alerts.silence(Stamp(6));
    alerts.rectify(Stamp(7), Alert::Rudder);
    check(&alerts, &[110, 130, 112, 101, 122]);
    alerts.acknowledge(Stamp(8), 112);
    check(&alerts, &[110, 130, 101, 112, 122]);
}
