//! A scripted hand unit at the program: all codes over a pseudo-terminal act on the simulated ship, and what is saved stays
//! (EMC-2, EMC-4, EMC-5, EMC-7).

use crate::plotter::mode;
use crate::{autopilot, fields};
use std::path::Path;
use std::time::{Duration, Instant};
use wheelover_core::settings::Value;
use wheelover_core::view::{ModeName, Order};
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::Line;
use wheelover_tests::{folder, with_checksum};

/// The autopilot of the simulated ship, with a hand unit.
fn ship(folder: &Path) -> String {
    let text = format!(
        "roles = [\"autopilot\", \"world\"]\nallow_output = true\n[ship]\nmodel = \"mariner\"\n[autopilot]\nrudder_slew = 5.0\n\
         variation = 4.0\n[[port]]\nname = \"hmi\"\nkind = \"serial\"\npath = \"{}\"\nbaud = 38400\nstation = \"autopilot\"\nprofile = \"hmi\"\noutput = true\n",
        folder.join("hmi").display(),
    );
    let file = folder.join("wheelover.toml");
    std::fs::write(&file, text).unwrap();
    file.display().to_string()
}

/// Says it, and gives the next answer of that code; what comes by itself is passed over.
fn ask(unit: &mut Line, body: &str, code: &str) -> String {
    unit.say(body);
    answer(unit, code)
}

fn answer(unit: &mut Line, code: &str) -> String {
    let end = Instant::now() + SOON;
    while let Some((_, line)) = unit.hear(end.saturating_duration_since(Instant::now())) {
        let body = line.trim_start_matches('$').split('*').next().unwrap();
        assert_eq!(with_checksum(body), line);
        if body.starts_with(&format!("PEMC,{code},")) {
            return body.to_string();
        }
    }
    panic!("no PEMC,{code}");
}

fn own(page: &Page) -> &wheelover_core::view::Own {
    let snapshot = page.snapshot.as_ref().unwrap();
    snapshot.own.as_ref().unwrap()
}

const INSTALLATION: &str = "PEMC,03,0,35,12,S,1,4.0,0.0,20";
const GAINS: &str = "PEMC,05,1.000,0.010,2.000,200,A";

#[tokio::test]
async fn a_hand_unit_steers_the_ship_by_every_code() {
    let folder = folder("hand-unit");
    let mut unit = Line::new(&folder.join("hmi"));
    let program = Program::start(&["--config", &ship(&folder)]);
    let mut page = Page::open(program.address).await;
    let heading = |page: &Page| page.snapshot.as_ref()?.own.as_ref()?.heading;
    page.until("a heading", SOON, |page| heading(page).is_some())
        .await;

    // 08, 03, 05, 07, and 07 by itself.
    assert_eq!(ask(&mut unit, "PEMC,08,I", "03"), INSTALLATION);
    assert_eq!(ask(&mut unit, "PEMC,08,G", "05"), GAINS);
    assert_eq!(fields(&ask(&mut unit, "PEMC,08,A", "07"))[2], "S");
    let begun = Instant::now();
    answer(&mut unit, "07");
    answer(&mut unit, "07");
    assert!(begun.elapsed() > Duration::from_secs(4));

    // 01 from STANDBY, and STANDBY again.
    unit.say("PEMC,01,I");
    let jogs = |page: &Page| mode(page) == Some(ModeName::FfuOverride);
    page.until("the tiller", SOON, jogs).await;
    page.until("STANDBY", SOON, |page| {
        mode(page) == Some(ModeName::Standby)
    })
    .await;
    assert_eq!(fields(&ask(&mut unit, "PEMC,08,A", "07"))[3], "10");

    // 04 and 06 are in force at once.
    let set = ask(&mut unit, "PEMC,04,0,30,10,S,2,4.1,0.0,9", "03");
    assert_eq!(set, "PEMC,03,0,30,10,S,2,4.1,0.0,9");
    let set = ask(&mut unit, "PEMC,06,1,0.002,30,1000,m", "05");
    assert_eq!(set, "PEMC,05,1.000,0.002,30.000,1000,m");

    // 00, 02: she is steered, and turns.
    unit.say("PEMC,00");
    page.until("AUTO", SOON, |page| mode(page) == Some(ModeName::Auto))
        .await;
    let before = own(&page).set_heading.unwrap();
    for letter in ["I", "I", "i", "r", "S", "P"] {
        unit.say(&format!("PEMC,02,{letter}"));
    }
    let changed = move |page: &Page| {
        let set = own(page).set_heading;
        set.is_some_and(|set| ((set - before).rem_euclid(360.0) - 20.0).abs() < 0.01)
    };
    page.until("the course", SOON, changed).await;
    page.until("rudder to starboard", SOON, |page| {
        own(page).rudder_order.is_some_and(|order| order > 2.0) && own(page).terms.is_some()
    })
    .await;
    assert_eq!(
        own(&page).terms.unwrap().feedforward,
        0.0,
        "the gains steer"
    );
    let told = ask(&mut unit, "PEMC,08,A", "07");
    assert_eq!((fields(&told)[2], fields(&told)[6]), ("A", "1"));
    page.until("she turns", SOON * 2, |page| {
        let off = heading(page).map(|now| (now - before).rem_euclid(360.0));
        off.is_some_and(|off| (1.0..60.0).contains(&off))
    })
    .await;

    // What is wrong is refused whole, counted and said.
    assert_eq!(ask(&mut unit, "PEMC,06,99,0.002,30,1000,m", "05"), set);
    unit.send(b"$PEMC,00*36\r\n");
    let said = |page: &Page| {
        own(page)
            .why
            .contains("PEMC,00 refused (2 so far): checksum")
    };
    page.until("the refusals", SOON, said).await;
    assert_eq!(mode(&page), Some(ModeName::Auto));

    // 09 and 10 in STANDBY.
    unit.say("PEMC,09");
    page.until("a refusal", SOON, |page| {
        own(page).why.contains("in STANDBY only")
    })
    .await;
    unit.say("PEMC,00");
    page.until("STANDBY", SOON, |page| {
        mode(page) == Some(ModeName::Standby) && own(page).rudder_order.is_none()
    })
    .await;
    for code in ["09", "10"] {
        unit.say(&format!("PEMC,{code}"));
        let on = |page: &Page| own(page).why.contains("send it again to end it");
        page.until("a calibration", SOON, on).await;
        unit.say(&format!("PEMC,{code}"));
        let poor = |page: &Page| own(page).why.contains("refused");
        page.until("nothing is found", SOON, poor).await;
    }
    assert!(page.differed.is_empty());
}

#[tokio::test]
async fn what_is_saved_survives_a_restart_and_restore_brings_the_defaults_back() {
    let folder = folder("hand-unit-saves");
    let config = ship(&folder);
    let mut unit = Line::new(&folder.join("hmi"));
    let installed = "PEMC,04,2,30,10,P,3,-3.2,-32.9,10";
    let gains = "PEMC,06,2,0.01,0.5,1000,M";
    let (told, gained) = (
        "PEMC,03,2,30,10,P,3,-3.2,-32.9,10",
        "PEMC,05,2.000,0.010,0.500,1000,M",
    );
    // What is saved by which letter, and what is found after the restart.
    for (letter, installation, expected) in [
        ("", INSTALLATION, GAINS),
        ("G", INSTALLATION, gained),
        ("I", told, gained),
        ("R", "PEMC,03,0,35,12,S,1,,0.0,20", GAINS), // no variation is given by default
    ] {
        let mut program = Program::start(&["--config", &config]);
        assert_eq!(ask(&mut unit, installed, "03"), told);
        assert_eq!(ask(&mut unit, gains, "05"), gained);
        if !letter.is_empty() {
            unit.say(&format!("PEMC,11,{letter}"));
        }
        ask(&mut unit, "PEMC,08,A", "07");
        assert_eq!(program.stop(), Some(0));
        let mut program = Program::start(&["--config", &config]);
        assert_eq!(ask(&mut unit, "PEMC,08,I", "03"), installation, "{letter}");
        assert_eq!(ask(&mut unit, "PEMC,08,G", "05"), expected, "{letter}");
        program.stop();
        let said = program.last_words();
        assert!(
            !said.iter().any(|line| line.contains("not in force")),
            "{said:?}"
        );
    }
}

// EMC-5: an IMU inside, told to the plotter; then the plotter's own compass.
#[tokio::test]
async fn a_plotter_is_told_the_compass_and_the_heel_or_is_the_compass() {
    let folder = folder("small-craft");
    let mut plotter = Line::new(&folder.join("plotter"));
    let imu = Line::new(&folder.join("imu"));
    let config = autopilot(&folder, &["plotter", "imu"], true);
    let program = Program::start(&["--config", &config]);
    let talk = |line: &Line, heel: f64| {
        line.talk(move |_| {
            let heel = format!("YXXDR,A,{heel:.1},D,HEEL");
            vec![with_checksum("HCHDM,080.0,M"), with_checksum(&heel)]
        })
    };
    let inside = talk(&imu, -7.5);
    let mut page = Page::open(program.address).await;
    page.until("a heading", SOON, |page| {
        page.snapshot.is_some() && own(page).heading == Some(80.0)
    })
    .await;
    drop(plotter.listen(Duration::from_millis(200)));
    let told = plotter.listen(Duration::from_secs(5));
    let count = |told: &[(Instant, String)], start: &str| {
        told.iter()
            .filter(|(_, line)| line.starts_with(start))
            .count()
    };
    for start in ["$HCHDM,080.0,M", "$HCHDG,080.0,", "$AGXDR,A,-7.50,D,HEEL*"] {
        assert!((4..=6).contains(&count(&told, start)), "{start}: {told:?}");
    }
    drop(inside);
    let _outside = talk(&plotter, 5.0);
    let (key, value) = ("external_compass".into(), Value::Switch(true));
    page.insist(Order::Setting { key, value }, SOON).await;
    page.until("the plotter's heading", SOON, |page| {
        let sources = &own(page).sources;
        let source = sources.iter().find(|(name, _)| name == "heading");
        source.is_some_and(|(_, source)| source == "plotter/HC/HDM")
            && own(page).heading == Some(80.0)
    })
    .await;
    drop(plotter.listen(Duration::from_millis(1_500)));
    let told = plotter.listen(Duration::from_secs(3));
    assert_eq!(count(&told, "$HC") + count(&told, "$AGXDR"), 0, "{told:?}");
    assert!(count(&told, "$AGRSA") >= 2, "{told:?}");
}
