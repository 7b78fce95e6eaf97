//! Cross-track distance in 1 kn of current: within 50 m on every leg and arc, a test a direction.

use crate::rig::off_path;
use wheelover_core::view::{ModeName, Order, Origin};
use wheelover_core::voyage::{Event, Voyage};

fn check(set: f64) {
    let mut voyage = Voyage::embedded(11);
    let mut out = Vec::new();
    let action = Order::Current { set, drift: 1.0 };
    voyage.handle(
        voyage.now(),
        Event::Order {
            id: 1,
            by: Origin::Officer,
            order: action,
        },
        &mut out,
    );
    let route = voyage.chart_system().unwrap().route().unwrap().clone();
    let mut worst = vec![[0.0_f64; 2]; route.legs().len()];
    let mut order = None::<f64>;
    for _ in 0..4_200 * 10 {
        out.clear();
        voyage.handle(voyage.now() + 100, Event::Tick, &mut out);
        let (autopilot, chart) = (voyage.autopilot().unwrap(), voyage.chart_system().unwrap());
        // FA6 over the whole voyage.
        let now = autopilot.rudder_order().map(|order| order.deg());
        if let (Some(before), Some(now)) = (order, now) {
            assert!((now - before).abs() <= 0.5 + 1e-9, "{before} -> {now}");
        }
        order = now;
        if autopilot.mode().name() == ModeName::AutonavTi {
            let off = off_path(&route, chart, voyage.world().unwrap().truth().position);
            let slot = &mut worst[chart.leg().unwrap_or(0)][usize::from(chart.situation() == 4)];
            *slot = slot.max(off);
        }
    }
    for (leg, [on_leg, on_arc]) in worst.iter().enumerate() {
        assert!(
            *on_leg > 0.0,
            "leg {leg} was not sailed under track control"
        );
        assert!(*on_leg < 50.0, "leg {leg}: {on_leg:.1} m; all {worst:.1?}");
        assert!(*on_arc < 50.0, "arc {leg}: {on_arc:.1} m; all {worst:.1?}");
    }
}

#[test]
fn current_setting_north() {
    check(0.0);
}

#[test]
fn current_setting_east() {
    check(90.0);
}

#[test]
fn current_setting_south() {
    check(180.0);
}

#[test]
fn current_setting_west() {
    check(270.0);
}
