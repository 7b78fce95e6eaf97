//! The program is stopped and goes on again, as where its machine is suspended: no burst, and every age counts the gap (FA16, FD6).

use crate::autopilot;
use crate::plotter::{mode, plotter};
use crate::ship::{Orders, gear, gyro};
use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};
use wheelover_core::view::{ModeName, ModeRequest, Order};
use wheelover_tests::folder;
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::Line;

fn signal(program: &Program, signal: Signal) {
    let id = Pid::from_raw(i32::try_from(program.id()).unwrap());
    kill(id, signal).unwrap();
}

/// The orders that were heard between two moments.
fn between(orders: &Orders, from: Instant, to: Instant) -> Vec<f64> {
    let orders = orders.lock().unwrap();
    let within = orders.iter().filter(|(at, _)| (from..to).contains(at));
    within.map(|(_, order)| *order).collect()
}

/// Stops the program in TRACK for so long; what it is in a few seconds later, and whether it said that it stood still.
async fn stopped(seconds: u64) -> (Option<ModeName>, Vec<String>) {
    let folder = folder(&format!("stopped{seconds}"));
    let line = Line::new(&folder.join("plotter"));
    let compass = Line::new(&folder.join("gyro1"));
    let rudder = Line::new(&folder.join("gear"));
    let config = autopilot(&folder, &["plotter", "gyro1", "gear"], true);
    let program = Program::start(&["--config", &config]);
    let orders = gear(rudder);
    let _compass = gyro(&compass, 80.0);
    let _plotter = plotter(&line, Arc::new(AtomicBool::new(true)));
    let mut page = Page::open(program.address).await;
    page.insist(Order::Mode(ModeRequest::Auto), SOON).await;
    page.insist(Order::Mode(ModeRequest::Track), SOON).await;
    page.until("TRACK", SOON, |page| mode(page) == Some(ModeName::Track))
        .await;
    page.follow(Duration::from_secs(2)).await;

    signal(&program, Signal::SIGSTOP);
    std::thread::sleep(Duration::from_secs(seconds));
    let on = Instant::now();
    signal(&program, Signal::SIGCONT);
    // A page that was silent for so long may be taken to be gone: it comes back, as every page does.
    let mut page = Page::open(program.address).await;
    page.follow(Duration::from_secs(3)).await;

    // Ten orders a second, and none for the time that is gone.
    let second = Duration::from_secs(1);
    for part in 0..3 {
        let from = on + part * second;
        let count = between(&orders, from, from + second).len();
        assert!(
            (6..=14).contains(&count),
            "{seconds} s: {count} orders in second {part}"
        );
    }
    // FA6: an order goes on from where it was.
    let whole = between(
        &orders,
        on - Duration::from_secs(seconds) - second,
        on + 3 * second,
    );
    for pair in whole.windows(2) {
        let step = (pair[1] - pair[0]).abs();
        assert!(step <= 0.55, "{seconds} s: the order steps by {step}");
    }
    let alerts = &page.snapshot.as_ref().unwrap().alerts;
    let texts = alerts
        .iter()
        .map(|alert| format!("{}: {}", alert.title, alert.text));
    (mode(&page), texts.collect())
}

/// Whether an alert begins so.
fn said(alerts: &[String], start: &str) -> bool {
    alerts.iter().any(|alert| alert.starts_with(start))
}

#[tokio::test]
async fn a_stop_of_a_second_is_said_and_track_goes_on() {
    let (mode, alerts) = stopped(1).await;
    assert_eq!(mode, Some(ModeName::Track), "{alerts:?}");
    assert!(said(&alerts, "CONTROL STALLED"), "{alerts:?}");
    assert!(!said(&alerts, "TRACK FAIL"), "{alerts:?}");
}

#[tokio::test]
async fn a_stop_of_three_seconds_is_said_and_track_goes_on_by_what_is_said_after_it() {
    let (mode, alerts) = stopped(3).await;
    assert_eq!(mode, Some(ModeName::Track), "{alerts:?}");
    assert!(said(&alerts, "CONTROL STALLED"), "{alerts:?}");
    assert!(!said(&alerts, "TRACK FAIL"), "{alerts:?}");
}

#[tokio::test]
async fn a_stop_of_ten_seconds_is_track_fail_whatever_waited_in_the_lines() {
    let (mode, alerts) = stopped(10).await;
    assert_eq!(mode, Some(ModeName::Auto), "{alerts:?}");
    assert!(said(&alerts, "CONTROL STALLED"), "{alerts:?}");
    assert!(said(&alerts, "TRACK FAIL: APB missing"), "{alerts:?}");
}
