//! The alert table, the states of an alert, the order in which alerts are shown.

use super::elsewhere::Elsewhere;
use super::*;
use crate::nmea::AlertCommand;
use crate::time::Stamp;
use alloc::vec::Vec;

#[test]
fn every_title_fits_the_alert_sentence() {
    for alert in Alert::ALL {
        assert!(alert.definition().title.len() <= 18, "{alert:?}");
        assert_eq!(Alert::of_number(alert.number()), Some(*alert));
        assert_eq!(Alert::of_identifier(alert.identifier()), Some(*alert));
        assert!((10_001..=10_999).contains(&alert.identifier()), "{alert:?}");
    }
}

/// What happens to an alert.
enum Do {
    Raise,
    Rectify,
    End,
    Take,
    Silence,
    Sound,
    /// Only time passes.
    Wait,
    Command(AlertCommand, Elsewhere),
    TakeBack,
}

const BAMS: Elsewhere = Elsewhere {
    shows_reason: false,
    alive: true,
};
const CHART: Elsewhere = Elsewhere {
    shows_reason: true,
    alive: true,
};
const DEAD: Elsewhere = Elsewhere {
    shows_reason: false,
    alive: false,
};

/// Each step: seconds, what happens, the state after it with revision and escalation counter.
fn check(alert: Alert, steps: &[(u64, Do, State, u8, u8)]) -> Alerts {
    let mut alerts = Alerts::default();
    for (number, (seconds, what, state, revision, escalation)) in steps.iter().enumerate() {
        let now = Stamp(seconds * 1_000);
        alerts.tick(now);
        match what {
            Raise => alerts.raise(now, alert, ""),
            Rectify => alerts.rectify(now, alert),
            End => alerts.end(now, alert),
            Take => {
                let _ = alerts.acknowledge(now, alert.number());
            }
            Silence => alerts.silence(now),
            Sound => alerts.sound_again(),
            Wait => {}
            Command(command, by) => {
                let _ = alerts.obey(now, alert, *command, *by);
            }
            TakeBack => alerts.take_back(now),
        }
        let standing = alerts.standing_of(alert);
        let is = (
            alerts.state(alert),
            alerts.revision(alert),
            standing.map_or(0, |standing| standing.escalation),
        );
        assert_eq!(
            is,
            (*state, *revision, *escalation),
            "{alert:?} step {number}"
        );
    }
    alerts
}

use Do::*;
use State::*;

// IEC 62923-1: each state and each way between them; FA15.
#[test]
fn an_alarm_goes_through_its_states() {
    let alarm = Alert::TrackFail;
    check(
        alarm,
        &[
            (0, Raise, Unacknowledged, 1, 0),
            (1, Raise, Unacknowledged, 1, 0),
            (2, Take, Acknowledged, 2, 0),
            (3, Take, Acknowledged, 2, 0),
            (4, Silence, Acknowledged, 2, 0),
            (5, Rectify, Normal, 3, 0),
            (6, Raise, Unacknowledged, 4, 0),
            (7, Rectify, RectifiedUnacknowledged, 5, 0),
            (8, Rectify, RectifiedUnacknowledged, 5, 0),
            (9, Raise, Unacknowledged, 6, 0),
            (10, Rectify, RectifiedUnacknowledged, 7, 0),
            (11, Take, Normal, 8, 0),
            (12, Take, Normal, 8, 0),
        ],
    );
    // FA15: silent for 30 s; it escalates all the same.
    check(
        alarm,
        &[
            (0, Raise, Unacknowledged, 1, 0),
            (1, Silence, Silenced, 2, 0),
            (29, Wait, Silenced, 2, 0),
            (30, Wait, Silenced, 3, 1),
            (31, Wait, Unacknowledged, 4, 1),
            (32, Silence, Silenced, 5, 1),
            (33, Sound, Unacknowledged, 6, 1),
            (90, Wait, Unacknowledged, 6, 1),
            (91, Silence, Silenced, 7, 1),
            (92, Rectify, RectifiedUnacknowledged, 8, 1),
            (93, Silence, RectifiedUnacknowledged, 8, 1),
            (94, End, Normal, 9, 0),
        ],
    );
}

#[test]
fn a_warning_is_repeated_and_a_caution_waits_for_nobody() {
    check(
        Alert::OffHeading,
        &[
            (0, Raise, Unacknowledged, 1, 0),
            (290, Silence, Silenced, 2, 0),
            (299, Wait, Silenced, 2, 0),
            (300, Wait, Unacknowledged, 3, 1),
            (599, Wait, Unacknowledged, 3, 1),
            (600, Wait, Unacknowledged, 4, 2),
            (601, Take, Acknowledged, 5, 2),
            (999, Wait, Acknowledged, 5, 2),
        ],
    );
    let caution = check(
        Alert::SpeedLost,
        &[
            (0, Raise, Acknowledged, 1, 0),
            (1, Silence, Acknowledged, 1, 0),
            (2, Take, Acknowledged, 1, 0),
            (
                3,
                Command(AlertCommand::Acknowledge, BAMS),
                Acknowledged,
                1,
                0,
            ),
            (900, Wait, Acknowledged, 1, 0),
            (901, Rectify, Normal, 2, 0),
        ],
    );
    assert_eq!(caution.history().count(), 1);
}

#[test]
fn responsibility_goes_to_who_is_alive_and_comes_back() {
    check(
        Alert::TrackFail,
        &[
            (0, Command(AlertCommand::Transfer, BAMS), Normal, 1, 0),
            (1, Raise, Unacknowledged, 1, 0),
            (
                2,
                Command(AlertCommand::Transfer, DEAD),
                Unacknowledged,
                1,
                0,
            ),
            (3, Command(AlertCommand::Transfer, BAMS), Transferred, 2, 0),
            (50, Wait, Transferred, 2, 0),
            (51, TakeBack, Unacknowledged, 3, 0),
            (80, Wait, Unacknowledged, 3, 0),
            (81, Wait, Unacknowledged, 4, 1),
            (82, Command(AlertCommand::Transfer, BAMS), Transferred, 5, 1),
            (
                83,
                Command(AlertCommand::Acknowledge, BAMS),
                Acknowledged,
                6,
                1,
            ),
            (84, TakeBack, Acknowledged, 6, 1),
            (85, Rectify, Normal, 7, 0),
            (86, Raise, Unacknowledged, 8, 0),
            (87, Command(AlertCommand::Silence, DEAD), Silenced, 9, 0),
            (
                88,
                Command(AlertCommand::Transfer, CHART),
                Transferred,
                10,
                0,
            ),
            (89, Rectify, Normal, 11, 0),
        ],
    );
}

#[test]
fn category_a_is_taken_where_its_reason_is_shown() {
    check(
        Alert::OffTrack,
        &[
            (0, Raise, Unacknowledged, 1, 0),
            (
                1,
                Command(AlertCommand::Acknowledge, BAMS),
                Unacknowledged,
                1,
                0,
            ),
            (
                2,
                Command(AlertCommand::Transfer, CHART),
                Unacknowledged,
                1,
                0,
            ),
            (3, Command(AlertCommand::Silence, BAMS), Silenced, 2, 0),
            (
                4,
                Command(AlertCommand::Acknowledge, CHART),
                Acknowledged,
                3,
                0,
            ),
            (5, Rectify, Normal, 4, 0),
            (6, Raise, Unacknowledged, 5, 0),
            (7, Take, Acknowledged, 6, 0),
        ],
    );
}

#[test]
fn a_refused_command_says_why() {
    let mut alerts = Alerts::default();
    let mut refused = |seconds: u64, alert, command, by| {
        let now = Stamp(seconds * 1_000);
        if seconds == 1 {
            alerts.raise(now, Alert::OffTrack, "");
            alerts.raise(now, Alert::TrackFail, "");
            alerts.raise(now, Alert::SpeedLost, "");
        }
        alerts.obey(now, alert, command, by).err()
    };
    let (ack, transfer) = (AlertCommand::Acknowledge, AlertCommand::Transfer);
    let not_waiting = Some(CommandRefused::NotWaiting);
    assert_eq!(refused(0, Alert::TrackFail, ack, BAMS), not_waiting);
    let shown = refused(1, Alert::OffTrack, ack, BAMS);
    assert_eq!(shown, Some(CommandRefused::ReasonNotShown));
    let dead = refused(2, Alert::TrackFail, transfer, DEAD);
    assert_eq!(dead, Some(CommandRefused::NoHeartbeat));
    assert_eq!(refused(3, Alert::SpeedLost, ack, BAMS), not_waiting);
    assert_eq!(refused(3, Alert::SpeedLost, transfer, BAMS), not_waiting);
    assert_eq!(
        refused(3, Alert::SpeedLost, AlertCommand::Request, BAMS),
        None
    );
    assert_eq!(refused(4, Alert::TrackFail, ack, BAMS), None);
    assert_eq!(refused(5, Alert::TrackFail, ack, BAMS), not_waiting);
}

#[test]
fn counters_go_on_with_one() {
    let mut alerts = Alerts::default();
    for round in 0..99 {
        alerts.raise(Stamp(round), Alert::SpeedLost, "");
        alerts.rectify(Stamp(round), Alert::SpeedLost);
    }
    assert_eq!(alerts.revision(Alert::SpeedLost), 99);
    alerts.raise(Stamp(100), Alert::SpeedLost, "");
    assert_eq!(alerts.revision(Alert::SpeedLost), 1);
    alerts.raise(Stamp(0), Alert::OffHeading, "");
    for repeat in 1..=10 {
        alerts.tick(Stamp(repeat * REPEAT_MS));
    }
    let standing = alerts.standing_of(Alert::OffHeading);
    assert_eq!(standing.map(|standing| standing.escalation), Some(1));
}

// FA15, TCS-11: at 30 s, once, until the alarm or the call itself is answered.
#[test]
fn an_alarm_that_nobody_takes_calls_the_back_up_navigator() {
    let call = Alert::BackupCalled;
    let mut alerts = Alerts::default();
    let at = |ms: u64, alerts: &mut Alerts| {
        alerts.tick(Stamp(ms));
        (alerts.call_backup(Stamp(ms), call), alerts.state(call))
    };
    alerts.raise(Stamp(0), Alert::SpeedLost, "");
    alerts.raise(Stamp(0), Alert::OffHeading, "");
    assert_eq!(at(100_000, &mut alerts), (None, Normal));
    alerts.raise(Stamp(100_000), Alert::TrackFail, "");
    alerts.silence(Stamp(110_000));
    assert_eq!(at(129_900, &mut alerts), (None, Normal));
    assert_eq!(at(130_000, &mut alerts), (Some(true), Unacknowledged));
    // The call calls for nobody else, and lasts.
    assert_eq!(at(200_000, &mut alerts), (None, Unacknowledged));
    assert!(alerts.acknowledge(Stamp(200_000), call.number()));
    assert_eq!(at(200_100, &mut alerts), (Some(false), Acknowledged));
    assert!(alerts.acknowledge(Stamp(200_200), Alert::TrackFail.number()));
    assert_eq!(at(200_200, &mut alerts), (None, Normal));
    // An alarm whose condition ends needs no other navigator.
    alerts.raise(Stamp(300_000), Alert::HeadingLost, "");
    assert_eq!(at(330_000, &mut alerts), (Some(true), Unacknowledged));
    alerts.rectify(Stamp(330_500), Alert::HeadingLost);
    assert_eq!(at(330_600, &mut alerts), (Some(false), Normal));
}

// DSP-5
#[test]
fn the_history_tells_when_each_came_was_taken_and_went() {
    let mut alerts = Alerts::default();
    alerts.raise(Stamp(1), Alert::TrackFail, "HTC missing");
    alerts.retext(Alert::TrackFail, "end of route");
    alerts.rectify(Stamp(2), Alert::TrackFail);
    alerts.acknowledge(Stamp(3), 101);
    alerts.raise(Stamp(4), Alert::TrackFail, "");
    alerts.acknowledge(Stamp(5), 101);
    alerts.raise(Stamp(6), Alert::SpeedLost, "");
    alerts.rectify(Stamp(7), Alert::SpeedLost);
    let told: Vec<_> = alerts
        .history()
        .map(|past| {
            let time = |at: Option<Stamp>| at.map(|at| at.0);
            let (taken, back) = (time(past.acknowledged), time(past.back));
            (past.alert, past.detail.as_str(), past.raised.0, taken, back)
        })
        .collect();
    assert_eq!(
        told,
        [
            (Alert::SpeedLost, "", 6, None, Some(7)),
            (Alert::TrackFail, "", 4, Some(5), None),
            (Alert::TrackFail, "end of route", 1, Some(3), Some(2)),
        ]
    );
    for round in 10..500 {
        alerts.raise(Stamp(round), Alert::SpeedLost, "");
        alerts.rectify(Stamp(round), Alert::SpeedLost);
    }
    assert_eq!(alerts.history().count(), 100);
    assert_eq!(alerts.history().next().map(|past| past.raised.0), Some(499));
}

#[test]
fn only_what_alr_can_tell_is_a_change_for_it() {
    let mut alerts = Alerts::default();
    alerts.raise(Stamp(0), Alert::TrackFail, "");
    assert_eq!(alerts.take_changed(), [Alert::TrackFail]);
    assert_eq!(alerts.take_revised(), [Alert::TrackFail]);
    alerts.silence(Stamp(1));
    assert_eq!(alerts.take_changed(), []);
    assert_eq!(alerts.take_revised(), [Alert::TrackFail]);
}

// DSP-5
#[test]
fn what_nobody_has_taken_stands_before_what_was_taken_and_the_newest_first() {
    fn order(alerts: &Alerts, expect: &[u16]) {
        let mut standing: Vec<&Standing> = alerts.standing().iter().collect();
        standing.sort_by_key(|standing| standing.rank());
        let numbers: Vec<u16> = standing.iter().map(|s| s.alert.number()).collect();
        assert_eq!(numbers, expect);
    }
    let mut alerts = Alerts::default();
    alerts.raise(Stamp(0), Alert::SpeedLost, "");
    alerts.raise(Stamp(1), Alert::TrackFail, "");
    alerts.raise(Stamp(2), Alert::OffHeading, "");
    order(&alerts, &[101, 112, 122]);
    alerts.acknowledge(Stamp(3), 101);
    order(&alerts, &[112, 101, 122]);
    alerts.raise(Stamp(4), Alert::HeadingLost, "");
    alerts.raise(Stamp(5), Alert::Rudder, "");
    order(&alerts, &[130, 110, 112, 101, 122]);
    alerts.silence(Stamp(6));
    alerts.rectify(Stamp(7), Alert::Rudder);
    order(&alerts, &[110, 130, 112, 101, 122]);
    alerts.acknowledge(Stamp(8), 112);
    order(&alerts, &[110, 130, 101, 112, 122]);
}
