//! A real autopilot beside a foreign chart system: the plan shows the path that its sentences tell (AP-23).

use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};
use std::time::Duration;
use wheelover_core::geo::{Plane, Point, Position};
use wheelover_core::path::Path;
use wheelover_core::units::{Course, Radius};
use wheelover_tests::browser::Browser;
use wheelover_tests::program::Program;
use wheelover_tests::with_checksum;

const LONG: Duration = Duration::from_secs(60);
const SILENT: u8 = 9;
/// Parts of the path that can be drawn.
const ALL: [&str; 6] = [
    "leg",
    "arc",
    "next-leg",
    "radius-centre",
    "wheel-over",
    "corridor",
];

/// Northbound, then a turn of half a mile's radius to starboard onto 070.
fn turn() -> Path {
    let centre = Point {
        north: 0.0,
        east: 926.0,
    };
    let course = Course::from_deg;
    Path::turn(course(0.0), centre, Radius::from_nm(0.5), course(70.0))
}

fn place(point: Point) -> String {
    let plane = Plane::at(Position {
        lat: 54.5,
        lon: 11.2,
    });
    let position = plane.position(point);
    let part = |value: f64, width: usize| {
        let minutes = value.fract() * 60.0;
        format!("{:0width$}{minutes:07.4}", value.trunc())
    };
    format!("{},N,{},E", part(position.lat, 2), part(position.lon, 3))
}

/// What a chart system says each second in situations 2, 3 and 4 (interface.md section 4).
fn said(situation: u8) -> Vec<String> {
    let (path, out) = (turn(), turn().leg_out());
    let ship = path.at(
        match situation {
            2 => -260.0,
            3 => -240.0,
            _ => 40.0,
        },
        12.0,
    );
    let leg = Path::leg(path.point, path.course_in).progress(ship);
    let arc = path.progress(ship);
    let (display, control) = match situation {
        4 => (arc.cross_track, out.progress(ship).cross_track),
        _ => (leg.cross_track, leg.cross_track),
    };
    let side = |metres: f64| {
        let letter = if metres > 0.0 { 'L' } else { 'R' };
        format!("{:.4},{letter},N,A", metres.abs() / 1852.0)
    };
    let (radius, track, centre) = match (situation, path.turn) {
        (3 | 4, Some(arc)) => ("0.500", "070.0", place(arc.centre)),
        _ => ("", "000.0", ",,,".to_owned()),
    };
    [
        format!("EIHTC,V,,,T,R,,,{radius},,,0.10,{track},T,C"),
        format!("EIXTE,A,A,{}", side(display)),
        format!("PNEY,001,A,A,{}", side(control)),
        format!("PNEY,002,{centre},HAMBURG"),
        format!("EIGLL,{},101010.00,A,A", place(ship)),
        "EIVTG,000.0,T,,M,15.0,N,27.8,K,A".to_owned(),
    ]
    .iter()
    .map(|body| with_checksum(body))
    .collect()
}

/// Whether of all parts of the path just these are drawn.
fn drawn(parts: &[&str]) -> String {
    let part = |name: &&str| {
        let there = if parts.contains(name) { "!!" } else { "!" };
        format!("{there}document.querySelector('.plan [data-plan=\"{name}\"]')")
    };
    format!(
        "return {};",
        ALL.iter().map(part).collect::<Vec<_>>().join(" && ")
    )
}

#[tokio::test]
async fn the_path_of_a_foreign_chart_system_is_drawn_from_its_sentences_and_no_more() {
    let (program, ecdis) = Program::beside("foreign", "ecdis");
    let situation = Arc::new(AtomicU8::new(2));
    let now = situation.clone();
    let _chart = ecdis.talk(move |tick| match now.load(Ordering::Relaxed) {
        situation if tick % 10 == 0 && situation != SILENT => said(situation),
        _ => Vec::new(),
    });
    let browser = Browser::open().await;
    browser.go(&format!("http://{}/", program.address)).await;
    let strip = |words: &str| {
        format!("return document.querySelector('.strip').innerText.includes('{words}');")
    };

    let leg = drawn(&["leg", "corridor"]);
    browser.until("the leg alone", LONG, &leg).await;
    let named = "return document.querySelector('.plan svg').textContent.includes('PATH FROM HTC');";
    browser.until("where it is from", LONG, named).await;
    browser.until("where to", LONG, &strip("HAM")).await;
    assert_eq!(browser.run(&strip("070")).await, false);

    situation.store(3, Ordering::Relaxed);
    browser.until("the whole turn", LONG, &drawn(&ALL)).await;
    browser.until("the next track", LONG, &strip("070")).await;
    browser
        .until("the past line", LONG, &strip("WOL passed"))
        .await;

    situation.store(4, Ordering::Relaxed);
    browser.until("the arc", LONG, &drawn(&ALL[1..])).await;
    // A page that comes into the turn is told of the leg by the lines before it came.
    browser.go(&format!("http://{}/", program.address)).await;
    browser
        .until("the arc again", LONG, &drawn(&ALL[1..]))
        .await;

    situation.store(SILENT, Ordering::Relaxed);
    browser.until("nothing old", LONG, &drawn(&[])).await;
    assert_eq!(browser.run(&strip("070")).await, false);
}
