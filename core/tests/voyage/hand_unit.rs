//! The hand unit of a small craft: every code does what it says, whole or not at all (EMC-2, EMC-4, EMC-7, HTC-4).

use crate::rig::Rig;
use wheelover_core::nmea::SteeringMode;
use wheelover_core::settings::Settings;
use wheelover_core::station::{Profile, Switch};
use wheelover_core::view::{ModeName, ModeRequest, Order};

/// A ship heading 090 with a hand unit, and a variation of 4 degrees east.
fn ship() -> Rig {
    let ports = [
        ("hmi", Profile::Hmi),
        ("plotter", Profile::Plotter),
        ("imu", Profile::Imu),
    ];
    let mut rig = Rig::heading_east(&ports, 0.0);
    rig.set("variation", 4.0).unwrap();
    rig.run(3.0);
    rig
}

impl Rig {
    /// The hand unit says this; what it is told at once.
    pub(crate) fn unit(&mut self, body: &str) -> String {
        let before = self.sent.len();
        self.say(Profile::Hmi, body);
        self.step();
        let mut told = self.sent[before..].iter().map(|(_, line)| line);
        let line = told.find(|line| line.starts_with("$PEMC"));
        let body = line.map_or("", |line| line.trim_start_matches('$'));
        body.split('*').next().unwrap().to_string()
    }

    pub(crate) fn settings(&self) -> &Settings {
        self.autopilot().settings()
    }

    fn order(&self) -> Option<f64> {
        self.autopilot().rudder_order().map(|order| order.deg())
    }
}

// EMC-7: 00 toggles; STANDBY by it ends the orders in the same step.
#[test]
fn the_button_switches_between_standby_and_auto() {
    let mut rig = ship();
    rig.unit("PEMC,00");
    assert_eq!(
        (rig.mode(), rig.set_heading().round()),
        (ModeName::Auto, 90.0)
    );
    rig.unit("PEMC,02,I");
    rig.run(5.0);
    assert!(rig.order().unwrap() > 2.0);
    rig.say(Profile::Hmi, "PEMC,00");
    assert_eq!((rig.mode(), rig.order()), (ModeName::Standby, None));
    rig.run(1.2);
    assert_eq!(rig.last_htd().steering_mode, Some(SteeringMode::Manual));
    // From any mode that gives orders.
    rig.command(Order::Mode(ModeRequest::RiverPilot)).unwrap();
    rig.unit("PEMC,00");
    assert_eq!(rig.mode(), ModeName::Standby);
    rig.check_orders();
}

// EMC-7: 01 acts in STANDBY, in which no orders are given (AP-1): they are given in FFU OVERRIDE for as long as it takes.
#[test]
fn the_tiller_is_moved_from_standby_and_let_go_again() {
    let mut rig = ship();
    let before = rig.world().truth().rudder.deg();
    rig.unit("PEMC,01,I");
    assert_eq!(rig.mode(), ModeName::FfuOverride);
    rig.unit("PEMC,01,i");
    rig.run(1.0);
    assert_eq!(
        rig.last_htd().steering_mode,
        Some(SteeringMode::RudderControl)
    );
    rig.until("STANDBY again", 12.0, |rig| rig.mode() == ModeName::Standby);
    let moved = rig.world().truth().rudder.deg() - before;
    assert!((moved - 11.0).abs() < 0.5, "{moved}");
    rig.run(1.2);
    assert_eq!(rig.last_htd().steering_mode, Some(SteeringMode::Manual));
    assert!(rig.told("ROR").starts_with("$AGROR,,V"));
    for _ in 0..5 {
        rig.unit("PEMC,01,R");
    }
    rig.unit("PEMC,01,r");
    rig.until("STANDBY again", 30.0, |rig| rig.mode() == ModeName::Standby);
    let rudder = rig.world().truth().rudder.deg();
    assert!(
        (rudder + 35.0).abs() < 0.5,
        "the gear's maximum ends it: {rudder}"
    );
    // 00 ends it at once.
    rig.unit("PEMC,01,I");
    rig.unit("PEMC,00");
    assert_eq!((rig.mode(), rig.order()), (ModeName::Standby, None));
    rig.unit("PEMC,00");
    let why = |rig: &Rig| rig.autopilot().why().to_string();
    rig.unit("PEMC,01,I");
    assert_eq!(rig.mode(), ModeName::Auto);
    assert!(
        why(&rig).contains("in STANDBY and FFU OVERRIDE only"),
        "{}",
        why(&rig)
    );
    rig.check_orders();
}

// EMC-7, EMC-4: 02 acts in AUTO, by one, by ten, by a tack.
#[test]
fn the_course_is_changed_in_auto() {
    let mut rig = ship();
    rig.unit("PEMC,02,i");
    assert!(
        rig.autopilot().why().contains("in AUTO only"),
        "not in STANDBY"
    );
    rig.unit("PEMC,00");
    let begun = rig.set_heading();
    for (letter, expect) in [
        ("i", 1.0),
        ("I", 11.0),
        ("r", 10.0),
        ("R", 0.0),
        ("S", 100.0),
        ("P", 0.0),
    ] {
        rig.unit(&format!("PEMC,02,{letter}"));
        let off = (rig.set_heading() - begun).rem_euclid(360.0);
        assert!((off - expect).abs() < 1e-6, "{letter}: {off}");
    }
    rig.check_orders();
}

// EMC-3, EMC-7: 02 acts in TRACK: round something by DODGE, and back to TRACK where nothing is left of it.
#[test]
fn the_course_is_changed_in_track_and_changed_back() {
    let mut rig = ship();
    let plot = |rig: &mut Rig| {
        for _ in 0..4 {
            rig.say(
                Profile::Plotter,
                "GPAPB,A,A,0.01,R,N,V,V,090,T,DEST,091,T,095,T",
            );
            rig.run(1.0);
        }
    };
    plot(&mut rig);
    rig.unit("PEMC,00");
    rig.command(Order::Mode(ModeRequest::Track)).unwrap();
    plot(&mut rig);
    let told = rig.unit("PEMC,08,A");
    assert!(
        told.starts_with("PEMC,07,T,") && told.contains(",91.00,"),
        "{told}"
    );
    rig.unit("PEMC,02,I");
    rig.unit("PEMC,02,i");
    assert_eq!(rig.mode(), ModeName::Dodge);
    let told = rig.unit("PEMC,08,A");
    assert!(
        told.starts_with("PEMC,07,T,") && told.contains(",102.00,"),
        "{told}"
    );
    rig.unit("PEMC,02,R");
    rig.unit("PEMC,02,r");
    assert_eq!(rig.mode(), ModeName::Track);
    rig.check_orders();
}

// EMC-2, EMC-4: 08 asks, 07 comes by itself every five seconds, in E's forms.
#[test]
fn the_unit_is_told_what_it_asks_for_and_its_state_by_itself() {
    let mut rig = ship();
    let installation = rig.unit("PEMC,08,I");
    assert_eq!(installation, "PEMC,03,0,35,12,S,1,4.0,0.0,20");
    assert_eq!(rig.unit("PEMC,08,G"), "PEMC,05,1.000,0.010,2.000,200,A");
    let told = rig.unit("PEMC,08,A");
    let fields: Vec<&str> = told.split(',').collect();
    let [_, _, mode, rudder, heading, course, band, trim] = fields.as_slice() else {
        panic!("{told}");
    };
    assert_eq!((*mode, *course, *band, *trim), ("S", "", "", "0.00"));
    assert_eq!(*rudder, "0");
    let heading: f64 = heading.parse().unwrap();
    assert!((heading - 86.0).abs() < 0.5, "magnetic: {heading}");
    let before = rig.sent.len();
    rig.run(30.0);
    let state = |(_, line): &&(_, String)| line.starts_with("$PEMC,07,");
    let times = rig.sent[before..].iter().filter(state).map(|(at, _)| at.0);
    let times: Vec<u64> = times.collect();
    assert_eq!(times.len(), 6);
    assert!(
        times.windows(2).all(|pair| pair[1] - pair[0] == 5_000),
        "{times:?}"
    );
}

// EMC-7: what is out of range, of another length, or not whole control steps, is refused whole, counted and said.
#[test]
fn a_refused_sentence_changes_nothing_and_is_counted() {
    let mut rig = ship();
    let before = rig.settings().clone();
    let mut refused = 0;
    let mut check = |rig: &mut Rig, body: &str, word: &str| {
        rig.unit(body);
        refused += 1;
        let why = rig.autopilot().why();
        assert!(
            why.contains(&format!("refused ({refused} so far)")),
            "{body}: {why}"
        );
        assert!(why.contains(word), "{body}: {why}");
        assert_eq!(*rig.settings(), before, "{body}");
        assert_eq!(rig.mode(), ModeName::Standby, "{body}");
    };
    check(
        &mut rig,
        "PEMC,04,2,99,4,S,3,4.1,33.9,9",
        "rudder_max is 99, allowed are 10 to 45",
    );
    check(
        &mut rig,
        "PEMC,04,2,40,4,S,3,4.1,33.9,1",
        "off_heading_limit is 1",
    );
    check(&mut rig, "PEMC,04,2,40,4,S,3,4.1", "fields");
    check(
        &mut rig,
        "PEMC,06,3,0.11,0.7,150,m",
        "whole control steps of 100 ms",
    );
    check(&mut rig, "PEMC,06,3,0.11,0.7,99,m", "sample_time is 99");
    check(&mut rig, "PEMC,06,99,0.11,0.7,1000,m", "pid_kp is 99");
    check(&mut rig, "PEMC,01,x", "field 2");
    rig.say_raw(Profile::Hmi, "$PEMC,00*38");
    assert!(
        rig.autopilot()
            .why()
            .contains("PEMC,00 refused (8 so far): checksum")
    );
    rig.say_raw(Profile::Hmi, "$PEMC,00");
    assert!(rig.autopilot().why().contains("(9 so far)"));
    assert_eq!(rig.mode(), ModeName::Standby);
    // The unit is told what is still in force.
    assert_eq!(
        rig.unit("PEMC,06,99,,,,"),
        "PEMC,05,1.000,0.010,2.000,200,A"
    );
    assert_eq!(
        rig.unit("PEMC,04,,99,,,,,,"),
        "PEMC,03,0,35,12,S,1,4.0,0.0,20"
    );
}

// HTC-4: the NFU line goes before the hand unit, and its STANDBY before the lever.
#[test]
fn the_hand_unit_has_its_rank() {
    let mut rig = ship();
    rig.switch(Switch::Nfu, Some(true));
    for body in ["PEMC,00", "PEMC,01,I", "PEMC,02,I"] {
        rig.unit(body);
        let why = rig.autopilot().why();
        assert!(
            why.contains("the NFU line goes before the hand unit"),
            "{body}: {why}"
        );
        assert_eq!(rig.mode(), ModeName::NfuOverride);
    }
    rig.switch(Switch::Nfu, Some(false));
    rig.run(1.5);
    rig.unit("PEMC,00");
    assert_eq!(rig.mode(), ModeName::Auto);
    rig.switch(Switch::Ffu, Some(true));
    rig.step();
    rig.unit("PEMC,02,I");
    assert!(rig.autopilot().why().contains("goes before the hand unit"));
    rig.unit("PEMC,00");
    assert_eq!(
        rig.mode(),
        ModeName::Standby,
        "STANDBY goes before all but the NFU line"
    );
}

// EMC-2: the IMU at rest, the feedback from stop to stop; in STANDBY only, and orders end it.
#[test]
fn imu_and_feedback_are_calibrated() {
    let mut rig = ship();
    let imu = |rig: &mut Rig, seconds: u32| {
        for _ in 0..seconds * 10 {
            rig.say(Profile::Imu, "YXXDR,A,3.0,D,HEEL");
            rig.step();
        }
    };
    rig.unit("PEMC,09");
    assert!(rig.autopilot().why().contains("calibration of the IMU"));
    imu(&mut rig, 5);
    rig.unit("PEMC,10");
    assert!(
        rig.autopilot()
            .why()
            .contains("the calibration of the IMU is on")
    );
    rig.unit("PEMC,09");
    assert_eq!(rig.settings().heel_offset, -3.0);
    // The gear's own port says where it stands.
    rig.silence(Profile::Gear, "RSA");
    let stop = |rig: &mut Rig, at: f64| {
        for _ in 0..5 {
            rig.step();
            let say = format!("IIRSA,{at:.1},A,,V");
            rig.filter(|_, _, line| Some(line.to_string()));
            rig.say(Profile::Gear, &say);
            rig.silence(Profile::Gear, "RSA");
            rig.step();
        }
    };
    rig.unit("PEMC,10");
    for at in [0.0, -28.0, 34.0, 3.0] {
        stop(&mut rig, at);
    }
    rig.unit("PEMC,10");
    let settings = rig.settings();
    assert_eq!((settings.tiller_centre, settings.rudder_max), (3.0, 31.0));
    rig.filter(|_, _, line| Some(line.to_string()));
    rig.run(3.0);
    rig.unit("PEMC,09");
    rig.unit("PEMC,00");
    rig.unit("PEMC,09");
    assert!(
        rig.autopilot().why().contains("in STANDBY only"),
        "orders have ended it"
    );
}
