//! Two programs, one the ship with her chart system and one the autopilot, joined by null modems: two legs and the turn.

use crate::autopilot;
use std::fmt::Write;
use std::time::Duration;
use wheelover_core::geo::{Position, rhumb};
use wheelover_core::nmea::{self, Htc, Htd, Pney1, SteeringMode, TurnMode, Xte};
use wheelover_core::station::Direction;
use wheelover_core::units::{Course, Distance};
use wheelover_core::view::{ChartRequest, Line, ModeName, ModeRequest, Order};
use wheelover_tests::folder;
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::NullModem;

const LINES: [(&str, &str); 5] = [
    ("ecdis", "chart_system"),
    ("gyro1", "world"),
    ("gps", "world"),
    ("log", "world"),
    ("gear", "world"),
];

/// The situations of a dialogue as the autopilot's line shows them, and the largest distance off leg or arc.
fn situations(lines: &[Line]) -> (Vec<u8>, f64) {
    let (mut seen, mut worst, mut turned) = (Vec::new(), 0.0_f64, false);
    let (mut htc, mut xte) = (None::<Htc>, None::<Xte>);
    for Line { dir, text, .. } in lines {
        let sentence = nmea::decode(text.as_bytes());
        if *dir == Direction::In {
            htc = Htc::from_sentence(&sentence).or(htc);
            xte = Xte::from_sentence(&sentence).or(xte);
        }
        // PNEY,001 closes the pair of distances of a second.
        let (Some(pney1), Some(htc), Some(xte)) = (
            Pney1::from_sentence(&sentence).filter(|_| *dir == Direction::In),
            &htc,
            &xte,
        ) else {
            continue;
        };
        if htc.steering_mode != Some(SteeringMode::TrackControl) {
            continue;
        }
        worst = worst.max(xte.cross_track.unwrap_or(0.0).abs() * 1852.0);
        // On the arc the two distances differ, but for a moment near its end.
        let on_leg = pney1.cross_track == xte.cross_track && seen.last() != Some(&4);
        let situation = match (htc.radius, on_leg) {
            (None, _) if turned => 5,
            (None, _) => 2,
            (Some(_), true) => 3,
            (Some(_), false) => 4,
        };
        turned |= situation == 4;
        if seen.last() != Some(&situation) {
            seen.push(situation);
        }
    }
    (seen, worst)
}

#[tokio::test]
async fn two_legs_and_the_turn_between_them_over_serial_lines() {
    let folder = folder("two");
    let _modems: Vec<NullModem> = LINES
        .iter()
        .map(|(name, _)| NullModem::new(&folder, name))
        .collect();
    let mut text = String::from("roles = [\"chart_system\", \"world\"]\nallow_output = true\n");
    for (name, station) in LINES {
        let path = folder.join(format!("{name}.a"));
        let _ = write!(
            text,
            "[[port]]\nname = \"{name}\"\nstation = \"{station}\"\nkind = \"serial\"\npath = \"{}\"\n\
             baud = 38400\nprofile = \"{name}\"\noutput = true\n",
            path.display()
        );
        std::os::unix::fs::symlink(folder.join(format!("{name}.b")), folder.join(name)).unwrap();
    }
    text += "[ship]\ncurrent_set = 330\ncurrent_drift_kn = 1.0\n[route]\n";
    let mut place = Position {
        lat: 59.8,
        lon: 25.0,
    };
    let legs = [
        ("one", 0.0, 0.0, None),
        ("two", 245.0, 0.62, Some(0.4)),
        ("three", 275.0, 1.6, None),
    ];
    for (id, course, miles, radius) in legs {
        place = rhumb::destination(place, Course::from_deg(course), Distance::from_nm(miles));
        let _ = write!(
            text,
            "[[route.waypoint]]\nid = \"{id}\"\nlat = {:.6}\nlon = {:.6}\n",
            place.lat, place.lon
        );
        if let Some(radius) = radius {
            let _ = writeln!(text, "radius_nm = {radius}");
        }
    }
    let file = folder.join("ship.toml");
    std::fs::write(&file, text).unwrap();
    let config = autopilot(&folder, &LINES.map(|(name, _)| name), true);
    let steering = Program::start(&["--config", &config]);
    let ship = Program::start(&["--config", &file.display().to_string()]);

    let mut page = Page::open(steering.address).await;
    page.insist(Order::Mode(ModeRequest::Auto), SOON).await;
    let mut chart = Page::open(ship.address).await;
    assert_eq!(chart.hello.station, "chart_system");
    chart.insist(Order::Chart(ChartRequest::Track), SOON).await;
    chart.leave().await;
    page.insist(Order::Mode(ModeRequest::Autonav), SOON).await;
    page.until("track control", SOON, |page| {
        mode(page) == Some(ModeName::AutonavTi)
    })
    .await;
    page.until("the leg after the turn", Duration::from_secs(330), |page| {
        assert_eq!(mode(page), Some(ModeName::AutonavTi), "{:?}", page.snapshot);
        situations(&page.lines).0.last() == Some(&5)
    })
    .await;
    page.follow(Duration::from_secs(20)).await;
    let (seen, worst) = situations(&page.lines);
    assert_eq!(seen, [2, 3, 4, 5]);
    assert!(worst < 50.0, "{worst} m off the track");
    assert_eq!(page.gaps, [] as [u64; 0]);
    let htd = page.lines.iter().filter(|line| line.dir == Direction::Out);
    let htd: Vec<Htd> = htd
        .filter_map(|line| Htd::from_sentence(&nmea::decode(line.text.as_bytes())))
        .collect();
    let turning = htd
        .iter()
        .filter(|htd| htd.turn_mode == Some(TurnMode::Radius));
    assert!(turning.clone().count() > 40);
    assert!(turning.clone().all(|htd| htd.radius == Some(0.4)));
    assert_eq!(htd.last().unwrap().turn_mode, Some(TurnMode::NotControlled));
    println!(
        "largest cross-track distance {worst:.1} m, {} lines",
        page.lines.len()
    );
}

fn mode(page: &Page) -> Option<ModeName> {
    page.snapshot.as_ref()?.own.as_ref().map(|own| own.mode)
}
