//! The alerts with their history over HTTP: what stands, and what has been, with its times (DSP-5).

use std::time::Duration;
use wheelover_core::alerts::State;
use wheelover_core::view::{AlertsDocument, FaultKind, ModeRequest, Order, PastView};
use wheelover_tests::http::get;
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;

const HEADING_LOST: u16 = 110;

fn document(program: &Program) -> AlertsDocument {
    let answer = get(program.address, "/api/alerts", &[]);
    assert_eq!(answer.status, 200);
    assert_eq!(answer.header("content-type"), Some("application/json"));
    serde_json::from_slice(&answer.body).unwrap()
}

fn lost(document: &AlertsDocument) -> Option<&PastView> {
    let mut history = document.history.iter();
    history.find(|past| past.number == HEADING_LOST)
}

fn stands(page: &Page) -> bool {
    let snapshot = page.snapshot.as_ref();
    snapshot.is_some_and(|s| s.alerts.iter().any(|alert| alert.number == HEADING_LOST))
}

#[tokio::test]
async fn an_alert_leaves_its_times_in_the_history() {
    let program = Program::start(&[]);
    let mut page = Page::open(program.address).await;
    assert!(page.command(Order::Officer(false)).await.ok);
    page.insist(Order::Mode(ModeRequest::Auto), SOON).await;
    let silent = |on| Order::Fault {
        cable: "gyro1".into(),
        kind: FaultKind::Silent,
        on,
    };
    assert_eq!(lost(&document(&program)), None);
    assert!(page.command(silent(true)).await.ok);
    page.until("HEADING LOST", SOON, stands).await;
    let now = document(&program);
    let raised = lost(&now).unwrap();
    assert_eq!(raised.state, State::Unacknowledged);
    assert_eq!((raised.acknowledged, raised.back), (None, None));
    assert_eq!(raised.station, "autopilot");
    assert!(raised.raised > 0 && raised.raised <= now.at, "{raised:?}");
    assert!(
        now.standing
            .iter()
            .any(|alert| alert.number == HEADING_LOST)
    );

    assert!(page.command(Order::Acknowledge(HEADING_LOST)).await.ok);
    assert!(page.command(silent(false)).await.ok);
    page.insist(Order::Mode(ModeRequest::Standby), SOON).await;
    page.until("its end", SOON, |page| !stands(page)).await;
    page.follow(Duration::from_millis(200)).await;
    let later = document(&program);
    let over = lost(&later).unwrap();
    assert_eq!((over.state, over.raised), (State::Normal, raised.raised));
    let taken = over.acknowledged.unwrap();
    assert!(
        taken >= over.raised && over.back.unwrap() >= taken,
        "{over:?}"
    );
    assert!(
        !later
            .standing
            .iter()
            .any(|alert| alert.number == HEADING_LOST)
    );
}
