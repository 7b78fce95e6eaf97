//! Control steps at other rates, and what AUTO's set values do in AutoNAV (AP-8, AP-15, FA6).

use crate::rig::{Rig, SLEW, route};
use wheelover_core::time::Stamp;
use wheelover_core::view::{ModeName, ModeRequest, Order};

/// Rudder orders of leg, arc and leg, 500 s, with these settings changed under track control.
fn sail(changed: &[(&str, f64)]) -> Vec<(Stamp, Option<f64>)> {
    let mut rig = Rig::tracking_on(route(&[(245.0, 1.2), (305.0, 2.5)], 0.5));
    for (key, value) in changed {
        rig.set(key, *value).unwrap();
    }
    let mut turned = false;
    for _ in 0..5_000 {
        rig.step();
        turned |= rig.chart().situation() == 4;
    }
    assert!(turned && rig.mode() == ModeName::AutonavTi);
    rig.orders
}

// AP-8: the smallest rudder limit, rate and radius move no order of track control.
#[test]
fn set_values_of_auto_have_no_effect_in_autonav() {
    let plain = sail(&[]);
    let furthest = plain.iter().filter_map(|(_, order)| *order);
    assert!(furthest.fold(0.0, |most: f64, order| most.max(order.abs())) > 4.0);
    for changed in [
        ("rudder_limit", 4.0),
        ("set_rate", 1.0),
        ("set_radius", 10.0),
    ] {
        assert!(sail(&[changed]) == plain, "{changed:?}");
    }
    // In AUTO the limit acts.
    let mut rig = Rig::tracking();
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.set("rudder_limit", 4.0).unwrap();
    let from = rig.orders.len() + 30;
    rig.command(Order::AdjustHeading(60.0)).unwrap();
    rig.run(30.0);
    let most = rig.orders[from..].iter().filter_map(|(_, order)| *order);
    assert!((most.fold(0.0, f64::max) - 4.0).abs() < 1e-9);
}

// AP-15: at 5, 10 and 20 steps a second she turns alike, and the order moves within the slew of a step.
#[test]
fn she_is_steered_alike_at_every_rate_of_control_steps() {
    for step_hz in [5.0, 10.0, 20.0] {
        let mut rig = Rig::tracking();
        rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
        rig.set("step_hz", step_hz).unwrap();
        rig.run(10.0);
        let from = rig.heading().deg();
        rig.command(Order::SetHeading((from + 40.0) % 360.0))
            .unwrap();
        let mut most = 0.0_f64;
        let mut before = rig.autopilot().rudder_order().unwrap().deg();
        for _ in 0..2_400 {
            rig.step();
            let order = rig.autopilot().rudder_order().unwrap().deg();
            assert!((order - before).abs() <= SLEW * 0.2 + 1e-9, "{step_hz} Hz");
            before = order;
            most = most.max((rig.heading().deg() - from).rem_euclid(360.0));
        }
        let turned = (rig.heading().deg() - from).rem_euclid(360.0);
        assert!((turned - 40.0).abs() < 1.5, "{step_hz} Hz: {turned}");
        assert!(most < 44.0, "{step_hz} Hz: overshot to {most}");
    }
}
