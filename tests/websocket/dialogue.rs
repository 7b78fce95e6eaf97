//! The dialogue is checked as it runs: what the checker has found is at hand while the ship sails (CON-2).

use serde_json::Value;
use std::time::{Duration, Instant};
use wheelover_core::view::{FaultKind, ModeName, Order};
use wheelover_tests::http::get;
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;

fn found(program: &Program) -> Value {
    let answer = get(program.address, "/api/dialogue", &[]);
    assert_eq!(answer.status, 200);
    serde_json::from_slice(&answer.body).unwrap()
}

async fn until(
    program: &Program,
    page: &mut Page,
    name: &str,
    holds: impl Fn(&Value) -> bool,
) -> Value {
    let end = Instant::now() + Duration::from_secs(60);
    loop {
        let found = found(program);
        if holds(&found) {
            return found;
        }
        assert!(Instant::now() < end, "{name}: {found}");
        page.follow(Duration::from_millis(500)).await;
    }
}

// CON-2
#[tokio::test]
async fn a_dialogue_without_faults_is_without_breach_and_a_silent_chart_system_is_not() {
    let program = Program::start(&["--speed", "20"]);
    let mut page = Page::open(program.address).await;
    page.until("track control", Duration::from_secs(60), |page| {
        let own = page.snapshot.as_ref().and_then(|s| s.own.as_ref());
        own.is_some_and(|own| own.mode == ModeName::AutonavTi)
    })
    .await;
    let clean = until(&program, &mut page, "two minutes of it", |found| {
        found["sentences"].as_u64() > Some(1_000)
    })
    .await;
    assert_eq!(clean["breaches"], 0, "{clean}");
    let situations = clean["situations"].as_array().unwrap();
    assert!(
        situations.iter().any(|span| span["situation"] == 2),
        "{clean}"
    );
    let silent = Order::Fault {
        cable: "ecdis".into(),
        kind: FaultKind::Silent,
        on: true,
    };
    assert!(page.command(silent).await.ok);
    page.follow(SOON.min(Duration::from_secs(1))).await;
    let broken = until(&program, &mut page, "a missing sentence", |found| {
        found["rules"]["CON-1"].as_u64() > Some(0)
    })
    .await;
    let breach = broken["recent"].as_array().unwrap().last().unwrap();
    assert!(breach["line"].as_u64() > Some(0), "{broken}");
}
