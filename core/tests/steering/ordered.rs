//! What an operator orders directly: a rudder, a rate of turn (AP-21).

use super::{LIMIT, Sea, heading};
use wheelover_core::autopilot::steering::{Demand, TurnBy};
use wheelover_core::units::{RateOfTurn, RudderAngle};

// AP-21, FA6
#[test]
fn an_ordered_rudder_is_given_as_it_stands_with_and_without_a_heading() {
    let mut sea = Sea::new(15.0, 0.0, 0.0);
    for _ in 0..100 {
        sea.step(&heading(20.0, TurnBy::Free));
    }
    // From a law, in the middle of its transfer, at once at the slew of the gear.
    let from = sea.last_order;
    let rudder = RudderAngle::from_deg(-20.0);
    let steps = ((from + 20.0) / (sea.steering.ship().slew * 0.1)).ceil() as u32;
    for step in 1..=steps {
        let order = sea.step(&Demand::Rudder(rudder)).order.deg();
        assert!(step == steps || order > -20.0);
    }
    assert_eq!(sea.last_order, -20.0);
    let limit = RudderAngle::from_deg(LIMIT);
    let wanted = sea.steering.without_heading(RudderAngle::from_deg(-24.5));
    let ship = sea.steering.ship();
    for _ in 0..10 {
        sea.gear.steer(&wanted, limit, ship, 0.1);
    }
    assert_eq!(sea.gear.order().deg(), -24.5);
    // Back into a law from there.
    sea.last_order = -24.5;
    let set = sea.heading();
    for _ in 0..3_000 {
        sea.step(&heading(set, TurnBy::Free));
    }
    assert!((sea.heading() - set).abs() < 0.5);
}

// AP-21
#[test]
fn an_ordered_rate_is_held_at_every_speed_and_none_holds_the_heading() {
    for (knots, rate) in [(8.0, 12.0), (15.0, 25.0), (15.0, -25.0), (20.0, -40.0)] {
        let mut sea = Sea::new(knots, 60.0, 1.0);
        let turn = |rate| Demand::Rate(RateOfTurn::from_deg_per_min(rate));
        for _ in 0..1_500 {
            sea.step(&turn(rate));
        }
        let from = sea.heading();
        let mut fastest = 0.0_f64;
        for _ in 0..1_200 {
            sea.step(&turn(rate));
            fastest = fastest.max((sea.hull.rate.to_degrees() * 60.0 / rate).abs());
        }
        let turned = (sea.heading() - from) / 2.0;
        assert!(
            (turned - rate).abs() < 0.02 * rate.abs(),
            "{knots} kn: {turned}"
        );
        assert!(fastest < 1.1, "{knots} kn: {fastest}");
        for _ in 0..2_400 {
            sea.step(&turn(0.0));
        }
        let held = sea.heading();
        for _ in 0..9_000 {
            sea.step(&turn(0.0));
        }
        let drift = sea.heading() - held;
        assert!(drift.abs() < 0.5, "{knots} kn: {drift}");
    }
}
