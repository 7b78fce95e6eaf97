//! A small craft's parameters, each turned and seen to act; gains changed while she is steered; compasses inside and outside
//! (EMC-2, EMC-5, EMC-7, FA6).

use crate::rig::Rig;
use wheelover_core::alerts::Alert;
use wheelover_core::settings::{HeadingLaw, Value};
use wheelover_core::station::Profile;
use wheelover_core::view::{ModeName, ModeRequest, Order};

fn ship() -> Rig {
    let ports = [
        ("hmi", Profile::Hmi),
        ("plotter", Profile::Plotter),
        ("imu", Profile::Imu),
    ];
    let mut rig = Rig::heading_east(&ports, 0.0);
    rig.run(3.0);
    rig
}

/// Steered by gains that fit this ship.
fn by_gains(rig: &mut Rig) {
    rig.unit("PEMC,06,0.3,0.003,12,200,m");
    assert_eq!(rig.settings().heading_law, HeadingLaw::Pid);
    rig.unit("PEMC,00");
}

/// Says for so long what an IMU or a plotter's compass says of the ship: heading of magnetic north, and heel.
fn sail(rig: &mut Rig, profile: Profile, seconds: u32, off: f64) {
    for _ in 0..seconds * 10 {
        let heading = (rig.heading().deg() + off).rem_euclid(360.0);
        rig.say(profile, &format!("HCHDM,{heading:.1},M"));
        rig.say(profile, "YXXDR,A,-7.5,D,HEEL,C,20.1,C,AIR");
        rig.step();
    }
}

// EMC-2: the gains steer; EMC-7: what is set of them is seen in what moves the rudder.
#[test]
fn the_gains_of_the_hand_unit_steer_a_heading() {
    let mut rig = ship();
    by_gains(&mut rig);
    rig.unit("PEMC,02,I");
    rig.run(600.0);
    let off = rig.heading().deg() - rig.set_heading();
    assert!(off.abs() < 2.0, "{off}");
    let terms = rig.autopilot().steered().unwrap().terms;
    assert_eq!(
        terms.feedforward, 0.0,
        "no model of the ship is in it: {terms:?}"
    );
    let told = rig.unit("PEMC,08,A");
    assert!(
        told.starts_with("PEMC,07,A,") && told.contains(",1,"),
        "dead band: {told}"
    );
    rig.check_orders();
}

// FA6: whatever is changed while she is steered, and when.
#[test]
fn gains_and_laws_change_without_a_bump() {
    let mut rig = ship();
    rig.unit("PEMC,00");
    rig.unit("PEMC,02,I");
    rig.run(8.0);
    for gains in [
        "6,0,60,200,m",
        "0.2,0.01,1,1000,M",
        "20,5,200,5000,A",
        "1,0,30,100,m",
    ] {
        let before = rig.autopilot().rudder_order().unwrap().deg();
        rig.unit(&format!("PEMC,06,{gains}"));
        rig.step();
        let after = rig.autopilot().rudder_order().unwrap().deg();
        assert!((after - before).abs() < 0.6, "{gains}: {before} {after}");
        rig.run(9.0);
    }
    let (key, value) = ("heading_law".into(), HeadingLaw::Ship.value());
    rig.command(Order::Setting { key, value }).unwrap();
    rig.run(5.0);
    let terms = rig.autopilot().steered().unwrap().terms;
    assert_ne!(terms.rate, 0.0);
    rig.check_orders();
}

// EMC-7: the largest rudder angle limits the order of AUTO.
#[test]
fn the_largest_rudder_angle_limits_the_order() {
    let mut rig = ship();
    rig.unit("PEMC,04,,12,,,,,,");
    by_gains(&mut rig);
    rig.unit("PEMC,06,20,,,,");
    rig.unit("PEMC,02,S");
    rig.run(20.0);
    let order = rig.autopilot().rudder_order().unwrap().deg();
    assert_eq!((order, rig.autopilot().rudder_limit()), (12.0, 12.0));
    rig.check_orders();
}

// EMC-7: side and centre of the tiller's motor: the gear is ordered to its positions and says them, the rudder is the rudder.
#[test]
fn the_side_turns_the_positions_and_the_centre_shifts_them() {
    for (side, expect) in [("S", 12.0), ("P", -8.0)] {
        let mut rig = ship();
        rig.unit(&format!("PEMC,04,2,,,{side},,,,"));
        rig.run(1.0);
        rig.unit("PEMC,01,I");
        // The rudder stood at 0, which is 2 off the centre.
        rig.until("STANDBY again", 10.0, |rig| rig.mode() == ModeName::Standby);
        let position = rig.world().truth().rudder.deg();
        let start = if side == "S" { -2.0 } else { 2.0 };
        let turned = if side == "S" { 1.0 } else { -1.0 };
        assert!(
            (position - expect - turned * start).abs() < 0.3,
            "{side}: {position}"
        );
        let told = rig.unit("PEMC,08,A");
        let rudder = format!("PEMC,07,S,{:.0},", 10.0 + start);
        assert!(told.starts_with(&rudder), "{side}: {told}");
        rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
        rig.unit("PEMC,04,5,,,,,,,");
        assert!(
            rig.autopilot()
                .why()
                .contains("tiller_centre is changed in STANDBY only")
        );
        rig.run(5.0);
        assert!(!rig.raised(Alert::Rudder));
        rig.check_orders();
    }
}

// EMC-7: the alarm angle is the limit of the off-heading alert.
#[test]
fn the_alarm_angle_is_the_limit_of_the_alert() {
    let mut rig = ship();
    rig.unit("PEMC,04,,,,,,,,9");
    rig.unit("PEMC,00");
    rig.run(1.2);
    assert_eq!(rig.last_htd().off_heading_limit, Some(9.0));
    let at = rig.set_heading();
    for (off, within) in [(7.0, true), (11.0, false)] {
        rig.command(Order::SetHeading((at + off).rem_euclid(360.0)))
            .unwrap();
        rig.run(1.2);
        let status = rig.last_htd().off_heading_status.unwrap();
        assert_eq!(
            status == wheelover_core::nmea::LimitStatus::Within,
            within,
            "{off}"
        );
    }
}

// EMC-7: the rudder rests within the damping.
#[test]
fn damping_saves_moves_of_the_rudder() {
    let moves = |damping: u32| {
        let mut rig = ship();
        rig.unit(&format!("PEMC,04,,,,,{damping},,,"));
        by_gains(&mut rig);
        rig.run(60.0);
        let last = rig.orders.len() - 500;
        let moved = rig.orders[last..]
            .windows(2)
            .filter(|pair| pair[0].1 != pair[1].1);
        moved.count()
    };
    let (none, some) = (moves(0), moves(15));
    assert!(some * 4 < none, "{none} without, {some} with damping");
}

// EMC-7: above the cruise speed the gains are weaker, below it stronger; without a measured speed they are the cruise speed's.
#[test]
fn the_cruise_speed_is_the_speed_of_the_gains() {
    let factor = |cruise: u32, lost: bool| {
        let mut rig = ship();
        rig.unit(&format!("PEMC,04,,,{cruise},,,,,"));
        if lost {
            rig.filter(|_, from, line| {
                let speed = [Profile::Log, Profile::Gps, Profile::Ecdis].contains(&from);
                (!speed).then(|| line.to_string())
            });
            rig.run(7.0);
        }
        rig.unit("PEMC,06,1,0,0,100,m");
        rig.unit("PEMC,00");
        rig.unit("PEMC,02,I");
        let outside = |rig: &Rig| {
            let steered = rig.autopilot().steered().unwrap();
            let heading = rig.autopilot().believed_heading().unwrap();
            let error = (heading - steered.hts).deg();
            // Less the dead band of one degree.
            (
                steered.terms.proportional,
                -(error.abs() - 1.0).copysign(error),
            )
        };
        rig.until("off by more than the dead band", 60.0, |rig| {
            outside(rig).0.abs() > 1.0
        });
        let (term, off) = outside(&rig);
        term / off
    };
    let near = |value: f64, expect: f64| assert!((value - expect).abs() < 0.03, "{value} {expect}");
    let knots = ship().world().truth().water_speed.knots();
    near(factor(8, false), 8.0 / knots);
    near(factor(20, false), 20.0 / knots);
    near(factor(40, false), 2.0);
    near(factor(8, true), 1.0);
}

// EMC-5, EMC-7: an IMU is the compass; alignment and variation make its heading; its heel and it are told to the plotter.
#[test]
fn an_imu_is_the_internal_compass() {
    let mut rig = ship();
    rig.unit("PEMC,04,,,,,,4.1,33.9,");
    rig.silence(Profile::Gyro1, "");
    sail(&mut rig, Profile::Imu, 5, -38.0);
    let heading = rig.autopilot().believed_heading().unwrap().deg();
    assert!((heading - rig.heading().deg()).abs() < 0.5, "{heading}");
    rig.unit("PEMC,00");
    rig.unit("PEMC,04,,,,,,,20,");
    assert!(
        rig.autopilot()
            .why()
            .contains("heading_alignment is changed in STANDBY only")
    );
    let before = rig.sent.len();
    sail(&mut rig, Profile::Imu, 3, -38.0);
    let told: Vec<&str> = rig.sent[before..]
        .iter()
        .map(|(_, line)| line.as_str())
        .collect();
    let starts = |start: &str| told.iter().filter(|line| line.starts_with(start)).count();
    // True 090 is magnetic 085.9, by an IMU that reads 33.9 less.
    for start in [
        "$HCHDM,08",
        "$HCHDG,08",
        "$HCHDT,",
        "$AGRSA,",
        "$AGXDR,A,-7.50,D,HEEL*",
    ] {
        assert_eq!(starts(start), 3, "{start}: {told:?}");
    }
    rig.set("heel_offset", 1.5).unwrap();
    let before = rig.sent.len();
    sail(&mut rig, Profile::Imu, 2, -38.0);
    let offset = |(_, line): &(_, String)| line.starts_with("$AGXDR,A,-6.00,D,HEEL*");
    assert!(rig.sent[before..].iter().any(offset));
}

// EMC-5: the plotter's compass and heel are used only where it is set to be the compass, and it is not told its own.
#[test]
fn a_plotter_is_the_external_compass_only_where_it_is_set() {
    let mut rig = ship();
    rig.set("variation", 4.0).unwrap();
    rig.silence(Profile::Gyro1, "");
    sail(&mut rig, Profile::Plotter, 5, -4.0);
    assert_eq!(rig.autopilot().believed_heading(), None);
    assert!(!rig.sent.iter().any(|(_, line)| line.starts_with("$AGXDR")));
    let (key, value) = ("external_compass".into(), Value::Switch(true));
    rig.command(Order::Setting { key, value }).unwrap();
    let before = rig.sent.len();
    sail(&mut rig, Profile::Plotter, 5, -4.0);
    let heading = rig.autopilot().believed_heading().unwrap().deg();
    assert!((heading - rig.heading().deg()).abs() < 0.5, "{heading}");
    let told = &rig.sent[before..];
    let none = |start: &str| !told.iter().any(|(_, line)| line.starts_with(start));
    assert!(
        none("$HCHD") && none("$AGXDR") && !none("$AGRSA"),
        "{told:?}"
    );
    rig.unit("PEMC,00");
    sail(&mut rig, Profile::Plotter, 10, -4.0);
    assert_eq!(rig.mode(), ModeName::Auto);
}
