//! Two programs at ten times the clock's pace: each fault on the line has its answer (FA1, FA3, FA4, FA5, TCS-13); with real
//! equipment there is no other pace than the clock's.

use crate::autopilot;
use crate::pair::{Pair, alert, dialogue, follow, mode, waypoints};
use std::process::Command;
use std::sync::{Arc, Mutex};
use wheelover_core::geo::{Position, rhumb};
use wheelover_core::nmea;
use wheelover_core::units::{Course, Distance};
use wheelover_core::view::{Line, ModeName, Order};
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::binary;
use wheelover_tests::serial::Tap;
use wheelover_tests::{folder, with_checksum};

#[test]
fn with_real_equipment_another_pace_is_refused() {
    let folder = folder("real");
    // What is there and is no pseudo-terminal may be anything.
    std::os::unix::fs::symlink("/dev/null", folder.join("gear")).unwrap();
    let config = autopilot(&folder, &["gear"], true);
    let done = Command::new(binary())
        .args(["serve", "--speed", "10", "--config", &config])
        .output()
        .unwrap();
    assert_eq!(done.status.code(), Some(2), "{done:?}");
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    let gear = folder.join("gear");
    let expect = format!(
        "--speed 10: port \"gear\": {} is no pseudo-terminal; with real equipment ship's time runs at 1\n",
        gear.display()
    );
    assert_eq!(said, expect);
}

/// What is done to a line of the chart system.
type Damage = fn(&str) -> Option<String>;

/// The same fields but one, with the right checksum.
fn edited(line: &str, field: usize, value: &str) -> String {
    let body = line.trim_start_matches('$').split('*').next().unwrap();
    let mut fields: Vec<&str> = body.split(',').collect();
    fields[field] = value;
    with_checksum(&fields.join(","))
}

fn lost(_: &str) -> Option<String> {
    None
}

#[tokio::test]
async fn each_fault_on_the_line_has_its_answer() {
    let faults: [(&str, &str, Damage); 5] = [
        ("$EIHTC", "HTC", lost),
        ("$EIXTE", "XTE", |line| Some(edited(line, 1, "V"))),
        ("$PNEY,001", "PNEY,001", lost),
        ("$PNEY,002", "PNEY,002", |line| {
            let wrong = if line.ends_with('0') { '1' } else { '0' };
            Some(format!("{}{wrong}", &line[..line.len() - 1]))
        }),
        ("$EIHTC", "stopped by chart system", |line| {
            Some(edited(line, 4, "S"))
        }),
    ];
    let fault = Arc::new(Mutex::new(None::<(&str, Damage)>));
    let now = fault.clone();
    let tap: Tap = Box::new(move |line| match *now.lock().unwrap() {
        Some((begins, damage)) if line.starts_with(begins) => damage(line),
        _ => Some(line.to_owned()),
    });
    let begins = Position {
        lat: 59.8,
        lon: 25.0,
    };
    let ends = rhumb::destination(begins, Course::from_deg(245.0), Distance::from_nm(12.0));
    let marks = [("one", begins, None), ("two", ends, None)];
    let ship = waypoints(marks.into_iter());
    let pair = Pair::begin("line_faults", "10", &ship, Some(tap));
    let mut page = Page::open(pair.autopilot.address).await;
    for (begins, named, damage) in faults {
        pair.track(&mut page).await;
        page.until("the last alarm over", SOON, |page| {
            alert(page, "TRACK FAIL").is_none()
        })
        .await;
        follow(&mut page, 10.0).await;
        *fault.lock().unwrap() = Some((begins, damage));
        page.until("TRACK FAIL", SOON, |page| {
            alert(page, "TRACK FAIL").is_some()
        })
        .await;
        let failed = alert(&page, "TRACK FAIL").unwrap().clone();
        assert!(failed.text.contains(named), "{named}: {failed:?}");
        // Of this sentence the last that nothing was done to.
        let good = |line: &&Line| {
            let text = line.text.as_str();
            let right = nmea::decode(text.as_bytes()).checksum.is_right();
            right && text.starts_with(begins) && damage(text).as_deref() != Some(text)
        };
        let last = dialogue(&page).filter(good).last().unwrap().at;
        let took = failed.at.saturating_sub(last) as f64 / 1_000.0;
        println!(
            "{named}: TRACK FAIL after {took:.1} s on board: {}",
            failed.text
        );
        assert_eq!(mode(&page), Some(ModeName::Auto), "{named}");
        // FA1, FA4, FA5: five seconds after the last good one; FA3: by the next one.
        let expect = if named.starts_with("stopped") {
            0.3..=2.0
        } else {
            5.0..=5.2
        };
        assert!(expect.contains(&took), "{named}: {took}");
        // TCS-13: the chart system sees it, ends control and says so.
        let mut chart = Page::open(pair.ship.address).await;
        chart
            .until("AUTOPILOT LEFT", SOON, |page| {
                alert(page, "AUTOPILOT LEFT").is_some()
            })
            .await;
        let own = chart.snapshot.as_ref().unwrap().chart.clone().unwrap();
        assert_eq!(own.control, "off", "{named}");
        *fault.lock().unwrap() = None;
        // The officers take both alarms, and begin again.
        let left = alert(&chart, "AUTOPILOT LEFT").unwrap().number;
        chart.insist(Order::Acknowledge(left), SOON).await;
        chart.leave().await;
        page.insist(Order::Acknowledge(failed.number), SOON).await;
    }
    assert_eq!(page.gaps, [] as [u64; 0]);
}
