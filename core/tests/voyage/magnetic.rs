//! A magnetic compass steers: by its variation or the ship's she steers true, without one by magnetic north (AP-9, AP-10, AP-12).

use crate::rig::Rig;
use std::sync::{Arc, Mutex};
use wheelover_core::nmea::Reference;
use wheelover_core::station::Profile;
use wheelover_core::view::{ModeName, ModeRequest, Order};

/// East, degrees: what the compass deviates by, and what magnetic north is off true north.
const DEVIATION: f64 = 2.0;
const VARIATION: f64 = -7.5;

/// What of a magnetic compass is heard, and how.
#[derive(Clone, Copy)]
struct Heard {
    /// The gyro is heard too.
    gyro: bool,
    /// HDG with both; HDG without variation; else HDM.
    sentence: &'static str,
    /// RMC says the variation.
    rmc: bool,
    /// The variation is set.
    set: bool,
}

/// A ship with a magnetic compass on a port of its own.
fn ship(heard: Heard) -> (Rig, Arc<Mutex<Heard>>) {
    let mut rig = Rig::with_compass(Some(Profile::Magn));
    if heard.set {
        rig.set("variation", VARIATION).unwrap();
    }
    let shared = Arc::new(Mutex::new(heard));
    let gyro = shared.clone();
    rig.filter(move |_, from, line| {
        let heard = from != Profile::Gyro1 || gyro.lock().unwrap().gyro;
        heard.then(|| line.to_string())
    });
    (rig, shared)
}

fn sail(rig: &mut Rig, heard: &Arc<Mutex<Heard>>, seconds: u32) {
    for step in 0..seconds * 10 {
        let now = *heard.lock().unwrap();
        let sensed = (rig.heading().deg() - DEVIATION - VARIATION).rem_euclid(360.0);
        let magnetic = (rig.heading().deg() - VARIATION).rem_euclid(360.0);
        rig.say(
            Profile::Magn,
            &match now.sentence {
                "HDG" => format!("HCHDG,{sensed:.1},2.0,E,7.5,W"),
                "HDG without variation" => format!("HCHDG,{sensed:.1},2.0,E,,"),
                _ => format!("HCHDM,{magnetic:.1},M"),
            },
        );
        if now.rmc && step % 10 == 0 {
            rig.say(
                Profile::Gps,
                "GPRMC,120000.00,A,5400.000,N,00730.000,E,15.0,90.0,281126,7.5,W,A,S",
            );
        }
        rig.step();
    }
}

// AP-9, AP-10: every way in which a variation may be known, and none.
#[test]
fn a_magnetic_compass_alone_steers_true_wherever_a_variation_is_known() {
    let check = |sentence, rmc, set, reference: Reference| {
        let heard = Heard {
            gyro: false,
            sentence,
            rmc,
            set,
        };
        let (mut rig, shared) = ship(heard);
        sail(&mut rig, &shared, 5);
        rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
        sail(&mut rig, &shared, 30);
        let truth = rig.heading().deg();
        let off = match reference {
            Reference::True => 0.0,
            Reference::Magnetic => -VARIATION,
        };
        let believed = rig.autopilot().believed_heading().unwrap().deg();
        assert!(
            (believed - truth - off).abs() < 0.6,
            "{sentence}: {believed} of {truth}"
        );
        assert!(
            (truth - 90.0).abs() < 1.0,
            "{sentence}: {truth}, set {}",
            rig.set_heading()
        );
        let htd = rig.last_htd();
        assert_eq!(htd.reference, Some(reference), "{sentence}");
        // AP-12: what is not true is not said as HDT; the talker is the compass's.
        let said = rig.count("HDT");
        sail(&mut rig, &shared, 5);
        match reference {
            Reference::True => {
                assert!(rig.count("HDT") >= said + 4, "{sentence}");
                assert_eq!(rig.told("HDT").get(1..3), Some("HC"), "{sentence}");
            }
            Reference::Magnetic => assert_eq!(rig.count("HDT"), said, "{sentence}"),
        }
        let asked = rig.command(Order::Mode(ModeRequest::Autonav));
        match reference {
            Reference::True => assert!(asked.is_ok(), "{sentence}: {asked:?}"),
            Reference::Magnetic => assert_eq!(
                asked.unwrap_err(),
                "the heading is magnetic, and no variation is known"
            ),
        }
        rig.check_orders();
    };
    check("HDG", false, false, Reference::True);
    check("HDG without variation", true, false, Reference::True);
    check("HDG without variation", false, true, Reference::True);
    check("HDM", true, false, Reference::True);
    check("HDM", false, true, Reference::True);
    check("HDG without variation", false, false, Reference::Magnetic);
    check("HDM", false, false, Reference::Magnetic);
}

// FA7, AP-9: the gyro is lost in AUTO, the magnetic compass stands in without a step of the order; it is never taken for
// true north where no variation is known.
#[test]
fn a_lost_gyro_falls_back_on_the_magnetic_compass_only_with_a_variation() {
    for (sentence, mode) in [("HDG", ModeName::Auto), ("HDM", ModeName::RudderHold)] {
        let heard = Heard {
            gyro: true,
            sentence,
            rmc: false,
            set: false,
        };
        let (mut rig, shared) = ship(heard);
        sail(&mut rig, &shared, 5);
        rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
        sail(&mut rig, &shared, 30);
        shared.lock().unwrap().gyro = false;
        sail(&mut rig, &shared, 10);
        assert_eq!(rig.mode(), mode, "{sentence}");
        rig.check_orders();
        let turned = rig.heading().deg() - 90.0;
        assert!(turned.abs() < 1.5, "{sentence}: {turned} degrees");
    }
}

// AP-10, AP-12: the variation comes while she is steered by magnetic north: nothing steps.
#[test]
fn a_variation_that_comes_late_changes_nothing_until_the_next_standby() {
    let heard = Heard {
        gyro: false,
        sentence: "HDM",
        rmc: false,
        set: false,
    };
    let (mut rig, shared) = ship(heard);
    sail(&mut rig, &shared, 5);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    sail(&mut rig, &shared, 20);
    shared.lock().unwrap().rmc = true;
    sail(&mut rig, &shared, 20);
    assert_eq!(rig.last_htd().reference, Some(Reference::Magnetic));
    assert!((rig.heading().deg() - 90.0).abs() < 1.0);
    rig.check_orders();
    rig.command(Order::Mode(ModeRequest::Standby)).unwrap();
    sail(&mut rig, &shared, 5);
    assert_eq!(rig.last_htd().reference, Some(Reference::True));
}
