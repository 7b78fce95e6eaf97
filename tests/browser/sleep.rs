//! A page that slept (FC6): no picture after it shows what is old as live, not even the first one.

use crate::fed::{Fed, Picture, epoch};
use nix::sys::signal::Signal;
use serde_json::json;
use std::time::Duration;

/// So long the page sleeps: more than any age limit.
const SLEEP: Duration = Duration::from_secs(7);
/// So long after it everything must be live again, milliseconds.
const BACK: f64 = 3_000.0;
/// A heading is lost after 2 s; a picture may stand for two frames and the ends of the measurement differ a little, milliseconds.
const OLDEST: f64 = 2_000.0 + 300.0;

/// What is on the screen of a page that was woken at a time.
fn check(pictures: &[Picture], woken: f64) {
    let after: Vec<_> = pictures
        .iter()
        .filter(|picture| picture.at >= woken)
        .collect();
    assert!(after.len() > 20, "{} pictures after the sleep", after.len());
    for (index, picture) in after.iter().enumerate() {
        let shown = picture.state == "valid" || picture.state == "late";
        if let (true, Some(said)) = (shown, picture.said) {
            let age = picture.at - said;
            assert!(
                age < OLDEST,
                "picture {index} shows {age:.0} ms old data: {picture:?}"
            );
        }
    }
    let live = after
        .iter()
        .find(|picture| picture.state == "valid" && picture.link == "valid");
    let back = live.map(|picture| picture.at - woken);
    println!("live again {back:?} ms after the sleep");
    assert!(back.is_some_and(|back| back < BACK), "{back:?}");
}

#[tokio::test]
async fn a_frozen_page_wakes_without_a_lie() {
    let fed = Fed::start("frozen").await;
    let state = |state: &str| {
        fed.browser
            .protocol("Page.setWebLifecycleState", &json!({"state": state}))
    };
    state("frozen");
    tokio::time::sleep(SLEEP).await;
    let woken = epoch();
    state("active");
    // The protocol hides a page that it freezes; so it comes back into view.
    fed.browser.protocol(
        "Emulation.setFocusEmulationEnabled",
        &json!({"enabled": true}),
    );
    tokio::time::sleep(Duration::from_secs(4)).await;
    check(&fed.pictures().await, woken);
    fed.browser.close().await;
}

#[tokio::test]
async fn a_stopped_renderer_goes_on_without_a_lie() {
    let fed = Fed::start("stopped").await;
    fed.browser.signal_renderers(Signal::SIGSTOP);
    tokio::time::sleep(SLEEP).await;
    let woken = epoch();
    fed.browser.signal_renderers(Signal::SIGCONT);
    tokio::time::sleep(Duration::from_secs(4)).await;
    check(&fed.pictures().await, woken);
    fed.browser.close().await;
}
