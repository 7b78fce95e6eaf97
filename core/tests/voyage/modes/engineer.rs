//! INSTALLATION and AUTOTUNING, which the engineer selects (AP-18, AP-19).

use super::{order, rate, refused, sea, select, turned};
use crate::rig::Rig;
use wheelover_core::alerts::Alert;
use wheelover_core::station::Profile;
use wheelover_core::view::{ModeName, ModeRequest, Order};

// AP-18, AP-11
#[test]
fn installation_gives_no_orders_and_only_standby_ends_it() {
    let mut rig = sea();
    refused(
        &mut rig,
        Order::Mode(ModeRequest::Installation),
        "from STANDBY only",
    );
    select(&mut rig, ModeRequest::Standby);
    select(&mut rig, ModeRequest::Installation);
    rig.run(3.0);
    assert!(rig.autopilot().rudder_order().is_none());
    let htd = rig.last_htd();
    assert_eq!(
        (htd.steering_mode, htd.turn_mode, htd.rudder_angle),
        (None, None, None)
    );
    assert_eq!(
        (htd.radius, htd.rate_of_turn, htd.heading_to_steer),
        (None, None, None)
    );
    assert!(rig.told("ROR").contains("ROR,,V"), "{}", rig.told("ROR"));
    // What is reported now is reported by the unit of the installation.
    rig.set("heading_monitor_limit", 9.0).unwrap();
    rig.stall(400);
    rig.run(3.0);
    let ala = rig.told("ALA");
    assert!(ala.contains(",OT,JP,03,"), "{ala}");
    for mode in [
        ModeRequest::Auto,
        ModeRequest::Autonav,
        ModeRequest::FfuOverride,
        ModeRequest::RiverPilot,
        ModeRequest::WindVane,
        ModeRequest::Dodge,
        ModeRequest::Autotuning,
    ] {
        refused(
            &mut rig,
            Order::Mode(mode),
            "INSTALLATION is ended by STANDBY only",
        );
    }
    refused(
        &mut rig,
        Order::Mode(ModeRequest::Installation),
        "on already",
    );
    rig.silence(Profile::Gyro1, "");
    rig.run(4.0);
    assert_eq!(rig.mode(), ModeName::Installation);
    select(&mut rig, ModeRequest::Standby);
    assert_eq!(rig.mode(), ModeName::Standby);
}

/// A ship whose speed has been steady for long enough, and AUTOTUNING was asked for once.
fn asked() -> Rig {
    let mut rig = sea();
    refused(
        &mut rig,
        Order::Mode(ModeRequest::Autotuning),
        "not been steady for 30 s",
    );
    rig.run(60.0);
    let shown = select(&mut rig, ModeRequest::Autotuning);
    assert_eq!(rig.mode(), ModeName::Auto, "the limits are shown first");
    for limit in [
        "10° of rudder",
        "35° off it",
        "600 s",
        "no constant changes",
    ] {
        assert!(shown.contains(limit), "{shown}");
    }
    assert_eq!(rig.autopilot().why(), shown);
    rig
}

// AP-19
#[test]
fn autotuning_sails_a_bounded_zigzag_and_ends_on_the_heading_before() {
    let mut rig = asked();
    let (before, settings) = (rig.set_heading(), rig.autopilot().settings().clone());
    select(&mut rig, ModeRequest::Autotuning);
    assert!(rig.autopilot().why().contains("at most 35° off it"));
    rig.run(3.0);
    assert_eq!((rig.mode(), order(&rig)), (ModeName::Autotuning, 10.0));
    assert_eq!(rig.last_htd().steering_mode, None);
    let (mut farthest, mut reversals, mut last) = ([0.0_f64; 2], 0, 10.0);
    while rig.mode() == ModeName::Autotuning {
        rig.step();
        let off = turned(&rig, before);
        farthest = [farthest[0].min(off), farthest[1].max(off)];
        if rig.mode() == ModeName::Autotuning && order(&rig).abs() == 10.0 && order(&rig) != last {
            (reversals, last) = (reversals + 1, order(&rig));
        }
        assert!(rig.now.seconds() < 700.0);
    }
    assert_eq!(reversals, 5);
    assert!(
        farthest[0] < -10.0 && farthest[1] > 10.0 && farthest[1] < 35.0,
        "{farthest:?}"
    );
    assert_eq!((rig.mode(), rig.set_heading()), (ModeName::Auto, before));
    assert!(rig.autopilot().why().contains("the zigzag is sailed"));
    rig.run(240.0);
    assert!(turned(&rig, before).abs() < 1.5 && rate(&rig).abs() < 3.0);
    assert_eq!(*rig.autopilot().settings(), settings, "no constant changes");
    rig.check_orders();
}

// AP-19: any command ends it.
#[test]
fn any_command_ends_autotuning() {
    let ends: [(Order, bool, ModeName); 6] = [
        (Order::AdjustHeading(5.0), false, ModeName::Auto),
        (Order::SetRudder(5.0), false, ModeName::Auto),
        (Order::Mode(ModeRequest::Cancel), true, ModeName::Auto),
        (Order::Mode(ModeRequest::Autonav), true, ModeName::Auto),
        (Order::Mode(ModeRequest::Standby), true, ModeName::Standby),
        (
            Order::Mode(ModeRequest::FfuOverride),
            true,
            ModeName::FfuOverride,
        ),
    ];
    for (command, done, mode) in ends {
        let mut rig = asked();
        let before = rig.set_heading();
        select(&mut rig, ModeRequest::Autotuning);
        rig.run(25.0);
        assert_eq!(rig.mode(), ModeName::Autotuning);
        assert_eq!(rig.command(command.clone()).is_ok(), done, "{command:?}");
        assert_eq!(rig.mode(), mode, "{command:?}");
        if mode == ModeName::Auto {
            assert_eq!(rig.set_heading(), before, "{command:?}");
        }
        rig.run(20.0);
        rig.check_orders();
    }
    // The second selection is asked for within 20 s.
    let mut rig = asked();
    rig.run(21.0);
    select(&mut rig, ModeRequest::Autotuning);
    assert_eq!(rig.mode(), ModeName::Auto);
}

// AP-19: it is bounded in time and heading, and ends without a speed.
#[test]
fn autotuning_ends_at_its_bounds() {
    let start = |rig: &mut Rig| select(rig, ModeRequest::Autotuning);
    let ended = |rig: &mut Rig, seconds: f64, why: &str| {
        let auto = |rig: &Rig| rig.mode() == ModeName::Auto;
        rig.until(why, seconds, auto);
        let said = rig.autopilot().why().to_string();
        assert!(said.contains(why), "{said}");
        rig.run(20.0);
        rig.check_orders();
    };
    let mut rig = asked();
    rig.set("tuning_time", 60.0).unwrap();
    start(&mut rig);
    rig.run(59.0);
    assert_eq!(rig.mode(), ModeName::Autotuning);
    ended(&mut rig, 2.0, "its time is over");
    let mut rig = asked();
    rig.set("tuning_heading", 20.0).unwrap();
    rig.set("tuning_bound", 15.0).unwrap();
    start(&mut rig);
    ended(&mut rig, 120.0, "too far off the heading");
    let mut rig = asked();
    start(&mut rig);
    rig.run(5.0);
    rig.filter(|_, from, line| {
        let speed = [Profile::Log, Profile::Gps, Profile::Ecdis].contains(&from);
        (!speed).then(|| line.to_string())
    });
    ended(&mut rig, 8.0, "no measured speed");
    assert!(rig.raised(Alert::SpeedLost));
    let mut rig = asked();
    start(&mut rig);
    rig.run(5.0);
    super::check_heading_lost(&mut rig);
}
