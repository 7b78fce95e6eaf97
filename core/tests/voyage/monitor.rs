//! The heading monitor: HMS, HMR and HDG DIFF of two compasses (AP-10, N tables A.5 and A.6).

use crate::rig::Rig;
use wheelover_core::alerts::Alert;
use wheelover_core::station::Profile;

/// A ship with a second compass, where 5 degrees between two are the limit.
fn ship(second: Option<Profile>) -> Rig {
    let mut rig = Rig::with_compass(second);
    rig.set("heading_monitor_limit", 5.0).unwrap();
    rig
}

/// The second compass says these sentences, with the true heading less `off` in the place of `@`.
fn sail(rig: &mut Rig, profile: Profile, sentence: &str, off: f64, seconds: u32) {
    for _ in 0..seconds * 10 {
        let said = (rig.heading().deg() - off).rem_euclid(360.0);
        rig.say(profile, &sentence.replace('@', &format!("{said:.1}")));
        rig.step();
    }
}

/// The fields of the last HMR, from 1; the first is empty.
fn hmr(rig: &Rig) -> Vec<String> {
    let line = rig.told("HMR");
    let body = line.split('*').next().unwrap();
    body.split(',').map(str::to_string).collect()
}

fn near(text: &str, value: f64) -> bool {
    text.parse::<f64>()
        .is_ok_and(|read| (read - value).abs() <= 0.5)
}

#[test]
fn each_pair_of_compasses_is_reported_field_by_field() {
    let check = |profile,
                 sentence: &str,
                 off: f64,
                 name: &str,
                 kind: &str,
                 reading: f64,
                 rest: [&str; 5]| {
        let mut rig = ship(Some(profile));
        sail(&mut rig, profile, sentence, off, 10);
        let fields = hmr(&rig);
        assert_eq!(fields.len(), 18, "{fields:?}");
        assert_eq!(fields[1..4], ["GYRO1", name, "5.0"]);
        assert!(
            near(&fields[4], -off + if kind == "M" { 2.0 - 3.0 } else { 0.0 }),
            "{fields:?}"
        );
        assert_eq!(fields[5], "A");
        assert!(near(&fields[6], 90.0), "{fields:?}");
        assert_eq!(fields[7..11], ["A", "T", "", ""]);
        assert!(near(&fields[11], reading), "{fields:?}");
        assert_eq!(fields[12..14], ["A", kind]);
        assert_eq!(fields[14..16], rest[..2]);
        assert_eq!(fields[16..18], rest[2..4]);
    };
    let none = ["", "", "", "", ""];
    check(Profile::Gyro2, "HEHDT,@,T", 2.0, "GYRO2", "T", 88.0, none);
    check(Profile::Thd, "HETHS,@,A", -3.0, "THD", "T", 93.0, none);
    let magnetic = ["2.0", "E", "3.0", "W", ""];
    check(
        Profile::Magn,
        "HCHDG,@,2.0,E,3.0,W",
        1.0,
        "MAGN",
        "M",
        89.0,
        magnetic,
    );
}

#[test]
fn with_one_compass_the_fields_of_the_other_are_null() {
    let mut rig = ship(None);
    rig.run(5.0);
    let fields = hmr(&rig);
    assert_eq!(fields[1..6], ["GYRO1", "", "5.0", "", "A"]);
    assert!(fields[10..].iter().all(String::is_empty), "{fields:?}");
    assert!(!rig.raised(Alert::HeadingDifference));
}

#[test]
fn a_difference_beyond_the_limit_is_an_alert_until_it_is_over() {
    let mut rig = ship(Some(Profile::Gyro2));
    let said = "HEHDT,@,T";
    sail(&mut rig, Profile::Gyro2, said, 0.0, 10);
    for off in [7.0, -7.0] {
        sail(&mut rig, Profile::Gyro2, said, off, 3);
        assert!(rig.raised(Alert::HeadingDifference), "{off}");
        assert!(
            rig.text(Alert::HeadingDifference)
                .starts_with("GYRO1 and GYRO2 are")
        );
        assert_eq!(hmr(&rig)[5], "V");
        sail(&mut rig, Profile::Gyro2, said, off / 2.0, 5);
        assert!(!rig.raised(Alert::HeadingDifference), "{off}");
        assert_eq!(hmr(&rig)[5], "A");
    }
    // One that is silent is not compared: its status says so.
    sail(&mut rig, Profile::Gyro2, said, 7.0, 3);
    rig.run(6.0);
    assert!(!rig.raised(Alert::HeadingDifference));
    assert_eq!(hmr(&rig)[11..13], ["", "V"]);
}

// AP-10: HMS on change and each 30 s.
#[test]
fn what_is_set_is_said_when_it_changes_and_each_half_minute() {
    let mut rig = ship(None);
    let mut said = Vec::new();
    let mut sail = |rig: &mut Rig, seconds: u32| {
        said.clear();
        for _ in 0..seconds * 10 {
            let before = rig.count("HMS");
            rig.step();
            if rig.count("HMS") > before {
                said.push(rig.told("HMS"));
            }
        }
        said.clone()
    };
    assert!(!sail(&mut rig, 5).is_empty());
    let calm = sail(&mut rig, 60);
    assert_eq!(calm.len(), 2, "{calm:?}");
    rig.set("heading_monitor_limit", 7.5).unwrap();
    let changed = sail(&mut rig, 2);
    assert_eq!(changed.len(), 1);
    assert!(changed[0].starts_with("$AGHMS,GYRO1,,7.5*"), "{changed:?}");
}
