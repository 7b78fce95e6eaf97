//! Trials of the chart system: a foreign autopilot that leaves its control, or falls silent (TCS-13).

use super::Trial;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};
use std::time::{Duration, Instant};
use wheelover_core::alerts::Alert;
use wheelover_core::geo::{Plane, Point, Position};
use wheelover_core::view::{ChartRequest, Order};
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::Line;
use wheelover_tests::with_checksum;

pub(super) const TRIALS: &[Trial] = &[
    ("autopilot leaves", |folder| commands(folder, b'M')),
    ("autopilot is silent", |folder| commands(folder, 0)),
];

/// Commands an autopilot that obeys, until its mode is `left`: a letter of HTD, or 0 where it says nothing more.
fn commands(folder: &Path, left: u8) {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build();
    runtime.unwrap().block_on(sail(folder, left));
}

async fn sail(folder: &Path, left: u8) {
    let [mut ecdis, gps, gyro] =
        ["ecdis", "gps", "gyro1"].map(|name| Line::new(&folder.join(name)));
    let mut text = "roles = [\"chart_system\"]\nallow_output = true\n".to_string();
    for name in ["ecdis", "gps", "gyro1"] {
        text += &format!(
            "[[port]]\nname = \"{name}\"\nkind = \"serial\"\npath = \"{}\"\nbaud = 38400\nprofile = \"{name}\"\noutput = {}\n",
            folder.join(name).display(),
            name == "ecdis"
        );
    }
    text += "[route]\n[[route.waypoint]]\nid = \"one\"\nlat = 54.0\nlon = 8.0\n[[route.waypoint]]\nid = \"two\"\nlat = 54.2\nlon = 8.0\n";
    let config = folder.join("wheelover.toml");
    std::fs::write(&config, text).unwrap();
    let program = Program::start(&["--config", &config.display().to_string()]);
    let plane = Plane::at(Position {
        lat: 54.0,
        lon: 8.0,
    });
    let _gps = gps.talk(move |tick| {
        if !tick.is_multiple_of(10) {
            return vec![];
        }
        let north = 500.0 + tick as f64 * 0.6;
        let place = plane.position(Point { north, east: 0.0 });
        let minutes = (place.lat - 54.0) * 60.0;
        vec![
            with_checksum(&format!(
                "GPGLL,54{minutes:08.5},N,00800.00000,E,{:06}.00,A,D",
                tick / 10 % 60
            )),
            with_checksum("GPVTG,0.0,T,,M,11.7,N,21.6,K,D"),
        ]
    });
    let _gyro = gyro.talk(|_| vec![with_checksum("HEHDT,0.00,T"), with_checksum("HEROT,0.0,A")]);
    let mode = Arc::new(AtomicU8::new(b'S'));
    let said = mode.clone();
    let _autopilot = ecdis.talk(move |tick| match said.load(Ordering::Relaxed) {
        0 => vec![],
        _ if !tick.is_multiple_of(10) => vec![],
        mode => {
            let track = if mode == b'T' { "0.0" } else { "" };
            let mode = char::from(mode);
            vec![with_checksum(&format!(
                "AGHTD,V,,,{mode},N,35.0,20.0,0.500,,{track},,{track},T,A,A,,0.0"
            ))]
        }
    });
    let mut page = Page::open(program.address).await;
    page.insist(Order::Chart(ChartRequest::Track), SOON).await;
    page.leave().await;
    until(&mut ecdis, "track control", SOON, |line| {
        commanded(line) == Some("T")
    });
    mode.store(b'T', Ordering::Relaxed);
    // It is obeyed: no reason to stop.
    let lines = ecdis.listen(Duration::from_secs(7));
    let last = lines.iter().rev().find_map(|(_, line)| commanded(line));
    assert_eq!(last, Some("T"));
    mode.store(left, Ordering::Relaxed);
    let begun = Instant::now();
    until(&mut ecdis, "its end", Duration::from_secs(9), |line| {
        commanded(line) == Some("S")
    });
    // 5 s, and HTC goes out once a second.
    assert!(
        begun.elapsed() < Duration::from_millis(7_500),
        "{:?}",
        begun.elapsed()
    );
    let mut page = Page::open(program.address).await;
    page.until("AUTOPILOT LEFT", SOON, |page| {
        let alerts = page.snapshot.as_ref().map(|snapshot| &snapshot.alerts);
        alerts.is_some_and(|alerts| {
            alerts
                .iter()
                .any(|alert| alert.number == Alert::AutopilotLeft.number())
        })
    })
    .await;
    let lines = ecdis.listen(Duration::from_secs(3));
    assert!(
        lines
            .iter()
            .all(|(_, line)| commanded(line).is_none_or(|mode| mode == "S"))
    );
}

/// Steering mode of an HTC.
fn commanded(line: &str) -> Option<&str> {
    line.strip_prefix("$EIHTC,")?.split(',').nth(3)
}

fn until(line: &mut Line, name: &str, within: Duration, holds: impl Fn(&str) -> bool) {
    let end = Instant::now() + within;
    while Instant::now() < end {
        if line.hear(SOON).is_some_and(|(_, said)| holds(&said)) {
            return;
        }
    }
    panic!("{name} not within {within:?}");
}
