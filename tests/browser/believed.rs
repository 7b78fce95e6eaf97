//! Rejected data are marked and never drawn as the ship's: a gyro and a receiver jump, and the page is watched picture by picture.

use serde_json::Value;
use std::time::Duration;
use wheelover_core::view::{FaultKind, ModeName, Order};
use wheelover_tests::browser::Browser;
use wheelover_tests::page::Page;
use wheelover_tests::program::Program;

const LONG: Duration = Duration::from_secs(60);

/// Notes of each picture the drawn hull, the shown heading and position with their states, and the longest stretch of the track
/// made good on the screen.
const SAMPLER: &str = "window.pictures = []; \
    const part = (name) => document.querySelector(`[data-value=\"${name}\"]`); \
    const longest = (d) => { \
        let [long, last] = [0, null]; \
        for (const [, begins, x, y] of d.matchAll(/([ML])([-\\d.]+) ([-\\d.]+)/g)) { \
            if (begins === 'L' && last) long = Math.max(long, Math.hypot(x - last[0], y - last[1])); \
            last = [x, y]; \
        } \
        return long; \
    }; \
    const look = () => { \
        const [h, p] = [part('heading'), part('position')]; \
        const hull = document.querySelector('[data-plan=\"own-ship\"]'); \
        const track = document.querySelector('[data-plan=\"track-made-good\"]'); \
        if (!h || !p || !track) return; \
        const number = (name) => hull ? Number(hull.getAttribute(name)) : null; \
        window.pictures.push({ \
            heading: h.innerText.trim(), state: h.dataset.state, place: p.dataset.state, \
            hull: number('data-heading'), lat: number('data-lat'), lon: number('data-lon'), \
            marks: document.querySelector('.right').innerText + document.querySelector('.sources').innerText, \
            longest: longest(track.getAttribute('d')), \
        }); \
    }; \
    const frame = () => { setTimeout(look); requestAnimationFrame(frame); }; \
    frame();";

/// A page under track control on a straight leg, in real time, with nobody but the test to act.
async fn sailing() -> (Program, Browser, Page) {
    let program = Program::start(&["--speed", "5"]);
    let browser = Browser::open().await;
    browser.go(&format!("http://{}/", program.address)).await;
    let live =
        "return document.querySelector('[data-value=\"heading\"]')?.dataset.state === 'valid';";
    browser.until("a live heading", LONG, live).await;
    let mut page = Page::open(program.address).await;
    page.until("track control", Duration::from_secs(120), |page| {
        let own = page.snapshot.as_ref().and_then(|s| s.own.as_ref());
        own.is_some_and(|own| own.mode == ModeName::AutonavTi)
    })
    .await;
    page.command(Order::Speed(1.0)).await;
    page.command(Order::Officer(false)).await;
    page.follow(Duration::from_secs(3)).await;
    browser.run(SAMPLER).await;
    page.follow(Duration::from_secs(2)).await;
    (program, browser, page)
}

async fn pictures(browser: &Browser) -> Vec<Value> {
    let found = browser.run("return window.pictures;").await;
    found.as_array().cloned().unwrap_or_default()
}

fn text<'a>(picture: &'a Value, name: &str) -> &'a str {
    picture[name].as_str().unwrap_or_default()
}

async fn heal(page: &mut Page, cable: &str) {
    let cable = cable.into();
    let kind = FaultKind::Jump;
    page.command(Order::Fault {
        cable,
        kind,
        on: false,
    })
    .await;
}

#[tokio::test]
async fn the_hull_never_turns_to_a_heading_that_the_autopilot_rejects() {
    let (_program, browser, mut page) = sailing().await;
    let before = pictures(&browser).await.len();
    browser.press("fault-gyro-jump").await;
    page.follow(Duration::from_secs(6)).await;
    let seen = pictures(&browser).await;
    let calm = seen[before - 1]["hull"].as_f64().unwrap_or_default();
    let apart = |heading: f64| ((heading - calm + 540.0) % 360.0 - 180.0).abs();
    let (mut bridged, mut gone) = (0, 0);
    for picture in &seen[before..] {
        // The gyro says 20 degrees more.
        if let Some(hull) = picture["hull"].as_f64() {
            assert!(apart(hull) < 8.0, "from {calm}: {picture}");
        }
        if let Ok(shown) = text(picture, "heading").parse::<f64>() {
            assert!(apart(shown) < 8.0, "from {calm}: {picture}");
        }
        match text(picture, "state") {
            "low" => bridged += 1,
            "lost" => gone += 1,
            _ => continue,
        }
        let marks = text(picture, "marks");
        assert!(
            marks.contains("GYRO1 jumped") || marks.contains("not judged yet"),
            "{marks}"
        );
    }
    assert!(
        bridged > 5,
        "{bridged} pictures show the prediction as such"
    );
    assert!(gone > 30, "{gone} pictures show no heading");
    assert!(
        seen.last()
            .is_some_and(|last| last["hull"].is_null() && text(last, "heading") == "---.-")
    );
    // FA7: the rudder is held; no law has an opinion of it.
    let terms = browser.value("terms").await.0;
    assert!(
        terms.contains("ORDER =") && terms.contains("HELD"),
        "{terms}"
    );
    assert!(
        !terms.contains("heading") && !terms.contains("bias"),
        "{terms}"
    );
    heal(&mut page, "gyro1").await;
    let live = "return document.querySelector('[data-value=\"heading\"]').dataset.state === 'valid' \
        && !document.querySelector('.sources').innerText.includes('jumped');";
    browser
        .until("the heading is believed again", LONG, live)
        .await;
    assert_eq!(browser.errors(), [] as [String; 0]);
    browser.close().await;
}

#[tokio::test]
async fn the_ship_never_stands_where_the_autopilot_does_not_believe_her() {
    let (_program, browser, mut page) = sailing().await;
    let before = pictures(&browser).await.len();
    browser.press("fault-position-jump").await;
    page.follow(Duration::from_secs(9)).await;
    let seen = pictures(&browser).await;
    let place = |picture: &Value| Some((picture["lat"].as_f64()?, picture["lon"].as_f64()?));
    let (lat, lon) = place(&seen[before - 1]).unwrap_or_default();
    let metres = |(a, b): (f64, f64)| {
        let east = (b - lon) * lat.to_radians().cos();
        (a - lat).hypot(east) * 60.0 * 1852.0
    };
    let calm = seen[before - 1]["longest"].as_f64().unwrap_or_default();
    let (mut marked, mut gone) = (0, 0);
    for picture in &seen[before..] {
        // In nine seconds the ship makes 70 m; the receiver says 370 m.
        match place(picture) {
            Some(there) => assert!(metres(there) < 130.0, "{} m: {picture}", metres(there)),
            None => gone += 1,
        }
        let long = picture["longest"].as_f64().unwrap_or_default();
        assert!(
            long < calm + 30.0,
            "a kink of {long} after {calm}: {picture}"
        );
        let marks = text(picture, "marks");
        marked += u32::from(marks.contains("GPS jumped") || marks.contains("GPS, ECDIS jumped"));
    }
    assert!(
        marked > 30,
        "{marked} pictures of {} mark it: {:?}",
        seen.len() - before,
        seen.last()
    );
    assert!(gone > 10, "{gone} pictures show no ship");
    assert_eq!(browser.errors(), [] as [String; 0]);
    browser.close().await;
}
