//! A port that says what it may not say, and a sensor with one bad sentence among good ones (FE11, SEN-4, FA7).

use crate::rig::Rig;
use wheelover_core::alerts::Alert;
use wheelover_core::nmea::with_checksum;
use wheelover_core::station::Profile;
use wheelover_core::view::ModeName;

/// Says `body(heading)` on a port ten times a second.
fn say_for(rig: &mut Rig, seconds: f64, profile: Profile, body: impl Fn(f64) -> String) {
    for _ in 0..(seconds * 10.0) as u32 {
        let heading = rig.world().truth().heading.deg();
        rig.say(profile, &body(heading));
        rig.step();
    }
}

fn unused(rig: &Rig) -> u64 {
    let counts = &rig.autopilot().picture().counts;
    counts.iter().map(|count| count.unused).sum()
}

#[test]
fn an_echo_of_our_heading_does_not_keep_a_dead_gyro_alive() {
    for echo in ["AGHDT", "HEHDT", "EIHDT"] {
        let mut rig = Rig::tracking();
        rig.silence(Profile::Gyro1, "");
        say_for(&mut rig, 3.0, Profile::Ecdis, |heading| {
            format!("{echo},{heading:.1},T")
        });
        assert_eq!(rig.mode(), ModeName::RudderHold, "{echo}");
        assert!(rig.raised(Alert::HeadingLost), "{echo}");
        assert!(unused(&rig) >= 30, "counted as not used from here");
        rig.check_orders();
    }
}

#[test]
fn the_chart_systems_heading_and_rate_never_become_the_ships() {
    let mut rig = Rig::tracking();
    rig.silence(Profile::Gyro1, "");
    say_for(&mut rig, 1.0, Profile::Ecdis, |heading| {
        format!("EIHDT,{:.1},T", heading + 4.0)
    });
    say_for(&mut rig, 1.0, Profile::Ecdis, |_| "EITHS,4.0,A".into());
    say_for(&mut rig, 1.0, Profile::Ecdis, |_| "EIROT,90.0,A".into());
    let picture = rig.autopilot().picture();
    let gyro = |port: usize| picture.ports[port].profile == Profile::Gyro1;
    assert!(picture.headings.iter().all(|heard| gyro(heard.source.port)));
    assert!(picture.rates.iter().all(|heard| gyro(heard.source.port)));
}

#[test]
fn the_chart_systems_rudder_is_no_feedback() {
    let mut rig = Rig::tracking();
    rig.silence(Profile::Gear, "RSA");
    say_for(&mut rig, 3.0, Profile::Ecdis, |_| "EIRSA,25.0,A,,V".into());
    assert!(rig.raised(Alert::Rudder));
    let rudder = rig.autopilot().picture().rudder.as_ref().unwrap();
    assert!(rudder.value.deg().abs() < 20.0, "{rudder:?}");
    rig.check_orders();
}

#[test]
fn one_bad_sentence_of_a_sensor_among_good_ones_changes_nothing() {
    for (profile, bad) in [
        (Profile::Gyro1, "HEHDT,,T"),
        (Profile::Gyro1, "HEHDT,3x1.0,T"),
        (Profile::Gyro1, "HEHDT,361.0,T"),
        (Profile::Gyro1, "HEROT,,A"),
        (Profile::Gyro1, "HEROT,5.0,V"),
        (Profile::Gps, "GPGLL,,,,,,A,D"),
        (Profile::Gps, "GPVTG,,T,,M,,N,,K,D"),
        (Profile::Log, "VDVHW,,T,,M,,N,,K"),
        (Profile::Gear, "IIRSA,,V,,V"),
        (Profile::Gear, "IIRSA,,A,,V"),
    ] {
        let mut rig = Rig::tracking();
        rig.run(2.0);
        rig.say(profile, bad);
        rig.run(2.0);
        assert_eq!(rig.mode(), ModeName::AutonavTi, "{bad}");
        for alert in [Alert::HeadingLost, Alert::Rudder, Alert::SpeedLost] {
            assert!(!rig.raised(alert), "{bad}: {alert:?}");
        }
        rig.check_orders();
    }
}

// FA7: bad sentences alone are no heading.
#[test]
fn nothing_but_bad_sentences_is_a_lost_heading_after_its_age_limit() {
    for bad in ["HEHDT,,T", "HEHDT,3x1.0,T"] {
        let mut rig = Rig::tracking();
        rig.filter(move |_, profile, line| {
            let heading = profile == Profile::Gyro1 && line.contains("HDT,");
            Some(if heading {
                with_checksum(bad)
            } else {
                line.into()
            })
        });
        rig.run(1.8);
        assert_eq!(rig.mode(), ModeName::AutonavTi, "{bad}");
        rig.run(0.5);
        assert_eq!(rig.mode(), ModeName::RudderHold, "{bad}");
    }
}
