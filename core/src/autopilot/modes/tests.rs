//! Transitions: where each loss leaves the ship, and what the operator alone can end.

use super::event::{Cause, Event};
use super::mode::TABLE;
use super::need::Need;
use super::table::OnLoss;
use super::*;
use crate::autopilot::facts::Facts;
use crate::geo::Point;
use crate::path::Path;
use crate::time::Stamp;
use crate::units::{Course, Heading, Radius, RudderAngle};
use alloc::boxed::Box;

fn facts() -> Facts<'static> {
    Facts {
        now: Stamp(1_000),
        heading: Heading::from_deg(100.0),
        order: RudderAngle::from_deg(4.0),
        place: None,
        steered: None,
        settings: Box::leak(Box::default()),
    }
}

fn leg(course: f64) -> Mode {
    let path = Path::leg(Point::default(), Course::from_deg(course));
    Mode::AutonavTi(AutonavTi::on(Stamp(0), path, None))
}

fn turning() -> Mode {
    let path = Path::turn(
        Course::from_deg(100.0),
        Point::default(),
        Radius::from_nm(0.5),
        Course::from_deg(160.0),
    );
    let mut ti = AutonavTi::on(Stamp(0), path, None);
    ti.track = Course::from_deg(160.0);
    Mode::AutonavTi(ti)
}

fn auto(mode: Mode) -> Auto {
    let Mode::Auto(auto) = mode else {
        panic!("{mode:?}")
    };
    auto
}

fn missing() -> Event {
    Event::TrackFail(Cause::Missing)
}

// TCS-8, FA1
#[test]
fn lost_on_a_leg_holds_the_actual_heading() {
    let lost = auto(leg(103.0).next(&missing(), &facts()));
    assert_eq!((lost.set.deg(), lost.finish), (100.0, None));
    // TCS-10, FA3
    let stopped = Event::TrackFail(Cause::StandAlone);
    let lost = auto(leg(103.0).next(&stopped, &facts()));
    assert_eq!(lost.set.deg(), 103.0);
    assert!(lost.stop_cause_until.is_some());
}

// TCS-8, FA2
#[test]
fn lost_in_a_turn_finishes_the_turn() {
    let lost = auto(turning().next(&missing(), &facts()));
    assert_eq!(lost.set.deg(), 160.0);
    assert_eq!(lost.finish.unwrap().wait, None);
    let before = Facts {
        place: Some(Point {
            north: -2_000.0,
            east: -3_000.0,
        }),
        ..facts()
    };
    let lost = auto(turning().next(&missing(), &before));
    assert!(lost.finish.unwrap().wait.is_some());
}

// HTC-1, FA12
#[test]
fn override_ends_every_mode_in_standby() {
    for mode in [turning(), Mode::Auto(Auto::on(facts().heading))] {
        assert_eq!(mode.next(&Event::Override, &facts()), Mode::STANDBY);
    }
}

// FA7
#[test]
fn a_lost_heading_freezes_the_rudder_and_only_the_operator_ends_it() {
    let held = turning().next(&Event::HeadingLost, &facts());
    let order = facts().order;
    assert_eq!(held, Mode::RudderHold(RudderHold { order }));
    let kept = held.next(&Event::SetHeading(facts().heading), &facts());
    assert_eq!(kept, held);
    assert!(matches!(
        held.next(&Event::Auto, &facts()),
        Mode::Auto { .. }
    ));
}

// AP-6
#[test]
fn track_control_is_entered_from_auto_only() {
    let path = Path::leg(Point::default(), Course::from_deg(100.0));
    let engage = Event::EngageTi {
        path,
        radius: Radius::from_nm(0.5),
    };
    assert_eq!(Mode::STANDBY.next(&engage, &facts()), Mode::STANDBY);
    let auto = Mode::Auto(Auto::on(facts().heading));
    assert!(auto.next(&engage, &facts()).is_autonav());
}

// AP-6: a selection is the mode's own
#[test]
fn a_selection_outlives_a_set_heading_and_nothing_else() {
    let mut mode = Mode::Auto(Auto::on(facts().heading));
    mode.select(Some(Stamp(5)));
    let set = Event::SetHeading(Heading::from_deg(90.0));
    assert_eq!(mode.next(&set, &facts()).selected_until(), Some(Stamp(5)));
    for event in [Event::Auto, Event::Standby, Event::HeadingLost] {
        assert_eq!(mode.next(&event, &facts()).selected_until(), None);
    }
}

#[test]
fn every_mode_that_gives_orders_by_the_heading_needs_one() {
    for row in TABLE {
        let without = [ModeName::RudderHold, ModeName::FfuOverride];
        let steers = row.gives_orders() && !without.contains(&row.name);
        let needs = row.needs(Need::Heading) || row.needs(Need::HeadingOrRate);
        assert_eq!(needs, steers, "{}", row.title);
        let watched = row.on_loss != OnLoss::Nothing;
        assert_eq!(watched, steers, "{}", row.title);
    }
}
