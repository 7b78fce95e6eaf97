//! What the bridge says of a state: nothing more than is so.

use crate::layout::{Frames, staged};
use serde_json::{Value, json};
use wheelover_core::nmea::Xte;
use wheelover_core::view::ModeName;
use wheelover_tests::browser::Browser;
use wheelover_tests::program::{Program, binary};

/// Shows a state, and waits until it is painted: what comes is drawn within a few pictures.
async fn show(browser: &Browser, state: Value) {
    let script = "const done = arguments[1]; \
        const wait = (n) => n ? requestAnimationFrame(() => wait(n - 1)) : done(null); \
        stage.show(arguments[0]).then(() => wait(12));";
    let shown = browser.client.execute_async(script, vec![json!(state)]);
    shown.await.unwrap();
}

async fn says(browser: &Browser, name: &str, expect: &str) {
    let (said, state) = browser.value(name).await;
    assert_eq!(said, expect, "{name}, {state}");
}

#[tokio::test]
async fn the_bridge_says_nothing_that_is_not_so() {
    let program = Program::start(&["--speed", "60"]);
    let turn = Frames::sail(&program).await;
    let browser = staged(&program, &turn.clone().state("turning")).await;
    for name in ["dtw", "eta"] {
        let (said, _) = browser.value(name).await;
        assert!(
            said.starts_with(|c: char| c.is_ascii_digit()),
            "{name}: {said}"
        );
    }

    // TCS-2: at the end of the route there is no way to go, though the last leg is still the last.
    let mut end = turn.clone();
    end.snapshot.chart.as_mut().unwrap().situation = 6;
    show(&browser, end.state("end of route")).await;
    says(&browser, "situation", "6").await;
    says(&browser, "dtw", "-.--").await;
    says(&browser, "eta", "--:--").await;

    // FA7: the order is held, and no law has an opinion of it.
    let mut held = turn
        .clone()
        .mode(ModeName::RudderHold, "no heading for 2 s: rudder held");
    let own = held.snapshot.own.as_mut().unwrap();
    (own.terms, own.rudder_order) = (None, Some(-3.5));
    show(&browser, held.state("RUDDER HOLD")).await;
    let (terms, _) = browser.value("terms").await;
    assert_eq!(
        terms.split_whitespace().collect::<Vec<_>>().join(" "),
        "ORDER = HELD P 3.5"
    );

    // AP-9, FA8, FA9: what is rejected is marked, and no ship is drawn by it.
    show(&browser, turn.clone().refused().state("nothing believed")).await;
    for (name, dashes) in [
        ("heading", "---.-"),
        ("position", "--°--.---′\n---°--.---′"),
        ("drift", "- --"),
    ] {
        let (said, state) = browser.value(name).await;
        assert_eq!((said.as_str(), state.as_str()), (dashes, "lost"), "{name}");
    }
    let right = "return document.querySelector('.right').innerText;";
    let right = browser.run(right).await.to_string();
    for mark in ["GYRO1 jumped", "GPS, ECDIS jumped", "ECDIS does not fit"] {
        assert!(right.contains(mark), "{mark}: {right}");
    }
    let drawn = "return document.querySelectorAll('[data-plan=own-ship], [data-plan=heading-line]').length;";
    assert_eq!(browser.run(drawn).await, 0);

    // Beyond its limit a cross-track distance has no side's colour.
    let fill = "const bar = [...document.querySelectorAll('.gauge')].at(-1); return [bar.querySelector('.over, .port, .stbd')?.getAttribute('class'), bar.textContent.includes('OVER limit')];";
    show(&browser, turn.clone().state("turning")).await;
    assert_ne!(browser.run(fill).await[0], "over");
    let mut over = turn;
    let heard = over.hello.picture.xte.as_mut().unwrap();
    heard.value = Xte {
        cross_track: Some(0.4),
        ..heard.value.clone()
    };
    over.snapshot.digest = over.hello.picture.digest();
    show(&browser, over.state("far off")).await;
    assert_eq!(browser.run(fill).await, json!(["over", true]));
    assert_eq!(browser.errors(), [] as [String; 0]);
    browser.close().await;
}

/// AP-17: the README, `--help` and the page say for which ships this is, and that it is not approved.
#[tokio::test]
async fn every_door_says_that_it_is_not_approved() {
    let help = std::process::Command::new(binary()).arg("--help").output();
    let help = String::from_utf8(help.unwrap().stdout).unwrap();
    let program = Program::start(&[]);
    let browser = Browser::open().await;
    browser
        .go(&format!("http://{}/#/about", program.address))
        .await;
    let there = "return /SOLAS/.test(document.querySelector('main.about')?.innerText ?? '');";
    let long = std::time::Duration::from_secs(60);
    browser
        .until("what is said about the program", long, there)
        .await;
    let about = browser
        .run("return document.querySelector('main.about').innerText;")
        .await;
    let readme = include_str!("../../README.md");
    for (door, text) in [
        ("README", readme),
        ("--help", &help),
        ("About", about.as_str().unwrap()),
    ] {
        let text = text.to_lowercase();
        for words in ["not ", "approved", "solas", "leisure craft"] {
            assert!(text.contains(words), "{door}: {words}");
        }
    }
    browser.close().await;
}
