//! From every mode to every other: who may go where, and no order steps or leaves its limit by it (FA6).

use crate::rig::{Rig, route};
use wheelover_core::station::Profile;
use wheelover_core::view::{ChartRequest, ModeName, ModeRequest, Order};

const MODES: [ModeName; 11] = [
    ModeName::Standby,
    ModeName::Auto,
    ModeName::AutonavTn,
    ModeName::AutonavTi,
    ModeName::RudderHold,
    ModeName::WindVane,
    ModeName::RiverPilot,
    ModeName::Dodge,
    ModeName::FfuOverride,
    ModeName::Installation,
    ModeName::Autotuning,
];

/// How a mode is asked for; RUDDER HOLD by nobody.
fn request(mode: ModeName) -> Option<ModeRequest> {
    Some(match mode {
        ModeName::Standby => ModeRequest::Standby,
        ModeName::Auto => ModeRequest::Auto,
        ModeName::AutonavTn | ModeName::AutonavTi => ModeRequest::Autonav,
        ModeName::WindVane => ModeRequest::WindVane,
        ModeName::RiverPilot => ModeRequest::RiverPilot,
        ModeName::Dodge => ModeRequest::Dodge,
        ModeName::FfuOverride => ModeRequest::FfuOverride,
        ModeName::Installation => ModeRequest::Installation,
        ModeName::Autotuning => ModeRequest::Autotuning,
        _ => return None,
    })
}

/// Whether the operator comes from one mode to the other by one selection, all needs being met.
fn may(from: ModeName, to: ModeName) -> bool {
    use ModeName::{
        Auto, AutonavTi, AutonavTn, Autotuning, Dodge, Installation, Standby, WindVane,
    };
    match (from, to) {
        (_, Standby) => true,
        (Installation, _) => false,
        (_, Installation) => from == Standby,
        (_, Auto) => true,
        // A command ends AUTOTUNING in AUTO, and is done from there.
        (_, AutonavTn | AutonavTi | Dodge) if from == Autotuning => true,
        (_, AutonavTn | AutonavTi) => from == Auto,
        (_, Autotuning) => from == Auto || from == Autotuning,
        // Asked for again it is released.
        (_, Dodge) => [Auto, AutonavTn, AutonavTi, WindVane, Dodge].contains(&from),
        (from, to) => from != to,
    }
}

/// A ship that has had a steady speed for long enough, in AUTO.
fn ship() -> Rig {
    let mut rig = Rig::windy(route(&[(245.0, 6.0), (305.0, 3.0)], 0.5), 3);
    rig.run(3.0);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.run(34.0);
    rig
}

fn engage(rig: &mut Rig, chart: ChartRequest, mode: ModeName) {
    rig.ask(chart).unwrap();
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    rig.until("AutoNAV", 20.0, |rig| rig.mode() == mode);
}

/// Brings the ship into a mode, with rudder where it has any.
fn bring(rig: &mut Rig, mode: ModeName) {
    match mode {
        ModeName::Standby => {}
        ModeName::Auto => {
            rig.command(Order::AdjustHeading(40.0)).unwrap();
        }
        ModeName::AutonavTn => engage(rig, ChartRequest::Heading, mode),
        ModeName::AutonavTi => engage(rig, ChartRequest::Track, mode),
        ModeName::RudderHold => {
            rig.command(Order::AdjustHeading(40.0)).unwrap();
            rig.run(8.0);
            rig.silence(Profile::Gyro1, "");
            rig.until("RUDDER HOLD", 3.0, |rig| rig.mode() == mode);
            rig.filter(|_, _, line| Some(line.to_string()));
        }
        ModeName::Installation => {
            rig.command(Order::Mode(ModeRequest::Standby)).unwrap();
        }
        _ => {}
    }
    if mode == ModeName::Autotuning {
        rig.command(Order::Mode(ModeRequest::Autotuning)).unwrap();
    }
    let standing = [
        ModeName::Auto,
        ModeName::AutonavTn,
        ModeName::AutonavTi,
        ModeName::RudderHold,
    ];
    if !standing.contains(&mode) {
        let request = request(mode).unwrap();
        rig.command(Order::Mode(request)).unwrap();
    }
    let set = match mode {
        ModeName::WindVane => Some(Order::SetWindAngle(20.0)),
        ModeName::RiverPilot => Some(Order::SetRate(-30.0)),
        ModeName::Dodge => Some(Order::SetDodge(-45.0)),
        ModeName::FfuOverride => Some(Order::SetRudder(30.0)),
        _ => None,
    };
    if let Some(set) = set {
        rig.command(set).unwrap();
    }
    rig.run(7.0);
    assert_eq!(rig.mode(), mode);
}

/// Runs on, and holds each order against the limit in force: outside of it only where it is walked in.
fn watched(rig: &mut Rig, seconds: u32) {
    let mut before = rig
        .autopilot()
        .rudder_order()
        .map(|order| order.deg().abs());
    for _ in 0..seconds * 10 {
        rig.step();
        let order = rig
            .autopilot()
            .rudder_order()
            .map(|order| order.deg().abs());
        let limit = rig.autopilot().rudder_limit();
        if let (Some(before), Some(order)) = (before, order) {
            assert!(order <= limit.max(before) + 1e-9, "{order} of {limit}");
        }
        before = order;
    }
}

fn check(from: ModeName, to: ModeName) {
    let mut rig = ship();
    bring(&mut rig, from);
    let Some(request) = request(to) else {
        return;
    };
    if matches!(to, ModeName::AutonavTn | ModeName::AutonavTi) && from == ModeName::Auto {
        // Not while she turns away from the leg.
        rig.command(Order::SetHeading(245.0)).unwrap();
        rig.run(60.0);
        let chart = match to {
            ModeName::AutonavTn => ChartRequest::Heading,
            _ => ChartRequest::Track,
        };
        let _ = rig.ask(chart);
    }
    if (from, to) == (ModeName::Auto, ModeName::Autotuning) {
        let _ = rig.command(Order::SetHeading(rig.heading().deg()));
        rig.run(60.0);
        rig.command(Order::Mode(request)).unwrap();
    }
    let answer = rig.command(Order::Mode(request));
    assert_eq!(
        answer.is_ok(),
        may(from, to),
        "{from:?} to {to:?}: {answer:?}"
    );
    if answer.is_err() {
        // What is refused has ended AUTOTUNING nevertheless (AP-19).
        let stays = match from {
            ModeName::Autotuning => ModeName::Auto,
            from => from,
        };
        assert_eq!(rig.mode(), stays, "{from:?} to {to:?}");
    }
    watched(&mut rig, 25);
    rig.check_orders();
    // And STANDBY from wherever that led (AP-25).
    rig.command(Order::Mode(ModeRequest::Standby)).unwrap();
    assert_eq!(rig.mode(), ModeName::Standby, "{from:?} to {to:?}");
}

// FA6, AP-25
#[test]
fn no_order_steps_from_any_mode_to_any_other() {
    for from in MODES {
        for to in MODES {
            check(from, to);
        }
    }
}
