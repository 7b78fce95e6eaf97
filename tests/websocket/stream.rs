//! Hello, documents, lines, snapshots with digests, answers, resume and the window of three.

use std::time::{Duration, Instant};
use wheelover_core::view::{Down, FaultKind, ModeName, ModeRequest, Order, PROTOCOL, Up};
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;

// CLI-1
#[tokio::test]
async fn hello_comes_first_and_the_documents_follow() {
    let program = Program::start(&[]);
    let mut page = Page::open(program.address).await;
    assert_eq!(page.hello.protocol, PROTOCOL);
    assert!(page.hello.simulated && page.hello.may_command);
    assert_eq!(page.hello.station, "autopilot");
    let names: Vec<&str> = page
        .hello
        .ports
        .iter()
        .map(|port| port.name.as_str())
        .collect();
    for name in ["ecdis", "gyro1", "gps", "log", "gear"] {
        assert!(names.contains(&name), "{names:?}");
    }
    page.until("the documents", SOON, |page| {
        page.route.is_some() && page.settings.is_some() && page.ports.is_some()
    })
    .await;
    let route = page.route.as_ref().unwrap();
    assert!(route.waypoints.len() >= 6, "at least five legs");
    let both = [1.0, -1.0].map(|side| route.turns.iter().any(|turn| turn.turn * side > 0.0));
    assert_eq!(both, [true, true], "turns both ways");
    for waypoint in &route.waypoints {
        assert!(waypoint.radius_nm.is_none_or(|radius| radius >= 0.5));
    }
}

#[tokio::test]
async fn lines_have_no_gap_and_the_digests_agree_at_ten_times_the_time() {
    let program = Program::start(&["--speed", "10"]);
    let mut page = Page::open(program.address).await;
    page.until(
        "a hundred agreeing snapshots",
        Duration::from_secs(90),
        |page| page.agreed >= 100,
    )
    .await;
    assert_eq!(page.differed, [] as [u64; 0]);
    assert_eq!(page.gaps, [] as [u64; 0]);
    assert!(page.lines.len() > 1_000);
    let numbers: Vec<u64> = page.lines.iter().map(|line| line.seq).collect();
    assert!(numbers.windows(2).all(|pair| pair[1] == pair[0] + 1));
    let text = page
        .lines
        .iter()
        .map(|line| line.text.as_str())
        .collect::<String>();
    for formatter in ["HTC,", "HTD,", "PNEY,002", "HDT,", "ROR,", "RSA,", "GLL,"] {
        assert!(text.contains(formatter), "{formatter}");
    }
}

/// AP-26, AP-25: two tablets; what the second one shows has changed by the first one's press.
#[tokio::test]
async fn a_press_for_what_is_no_longer_so_is_refused_and_standby_never() {
    let program = Program::start(&[]);
    let mut first = Page::open(program.address).await;
    let mut second = Page::open(program.address).await;
    assert!(first.command(Order::Officer(false)).await.ok);
    first.insist(Order::Mode(ModeRequest::Auto), SOON).await;
    second
        .until("AUTO", SOON, |page| mode(page) == Some(ModeName::Auto))
        .await;
    let frame = second.snapshot.as_ref().map(|snapshot| snapshot.frame);
    assert!(frame.is_some());
    assert!(second.press(frame, Order::SetHeading(250.0)).await.ok);
    // The frame that was pressed beside showed another set heading.
    let refused = second.press(frame, Order::AdjustHeading(10.0)).await;
    assert!(
        !refused.ok && refused.text.contains("250.0 now"),
        "{}",
        refused.text
    );
    let refused = first.press(frame, Order::Mode(ModeRequest::Auto)).await;
    assert!(!refused.ok, "{}", refused.text);
    let standby = Order::Mode(ModeRequest::Standby);
    assert!(second.press(frame, standby).await.ok);
}

#[tokio::test]
async fn commands_are_answered_once_with_what_followed_or_why_not() {
    let program = Program::start(&[]);
    let mut page = Page::open(program.address).await;
    let answer = page.command(Order::Officer(false)).await;
    assert!(answer.ok, "{}", answer.text);
    page.insist(Order::Mode(ModeRequest::Auto), SOON).await;
    page.until("AUTO", SOON, |page| mode(page) == Some(ModeName::Auto))
        .await;
    let answer = page.command(Order::SetHeading(250.0)).await;
    assert_eq!(
        (answer.ok, answer.text.as_str()),
        (true, "set heading 250.0")
    );
    let answer = page.command(Order::AdjustHeading(10.0)).await;
    assert_eq!(answer.text, "set heading 260.0");
    let answer = page.command(Order::Speed(600.0)).await;
    assert_eq!(
        (answer.ok, answer.text.as_str()),
        (false, "speed is 600, allowed are 1 to 60")
    );
    let answer = page.command(Order::Acknowledge(101)).await;
    assert!(!answer.ok);
    let fault = |on| Order::Fault {
        cable: "ecdis".into(),
        kind: FaultKind::Silent,
        on,
    };
    assert!(page.command(fault(true)).await.ok);
    page.until("the fault in the snapshot", SOON, |page| {
        let voyage = page.snapshot.as_ref().and_then(|s| s.voyage.as_ref());
        voyage.is_some_and(|voyage| !voyage.faults.is_empty())
    })
    .await;
    assert!(page.command(fault(false)).await.ok);
    page.insist(Order::Mode(ModeRequest::Standby), SOON).await;
    page.until("STANDBY", SOON, |page| {
        mode(page) == Some(ModeName::Standby)
    })
    .await;
    assert_eq!(page.gaps, [] as [u64; 0]);
}

fn mode(page: &Page) -> Option<ModeName> {
    let own = page.snapshot.as_ref()?.own.as_ref()?;
    Some(own.mode)
}

#[tokio::test]
async fn after_thirty_seconds_away_no_line_is_missed() {
    let program = Program::start(&[]);
    let mut page = Page::open(program.address).await;
    page.until("the first lines", SOON, |page| page.lines.len() > 20)
        .await;
    let before = page.lines.len();
    let left = page.line;
    let page = page.leave().await;
    // Another client tells how far the voyage has come: no clock of ours is trusted.
    let mut watch = Page::open(program.address).await;
    let began = watch.hello.at;
    watch
        .until("thirty seconds", Duration::from_secs(60), |watch| {
            watch
                .snapshot
                .as_ref()
                .is_some_and(|s| s.at >= began + 30_000)
        })
        .await;
    let now = watch.line;
    let mut page = page.come_back(program.address).await;
    page.until("all missed lines", SOON, |page| page.line >= now)
        .await;
    assert_eq!(page.gaps, [] as [u64; 0]);
    assert!(now > left + 500);
    assert!(page.lines.len() as u64 >= before as u64 + (now - left));
    page.until("an agreeing digest", SOON, |page| page.agreed > 0)
        .await;
    assert_eq!(page.differed, [] as [u64; 0]);
}

// FC4
#[tokio::test]
async fn at_most_three_snapshots_wait_for_their_acknowledgement() {
    let program = Program::start(&[]);
    let mut page = Page::open(program.address).await;
    page.acknowledges = false;
    let end = Instant::now() + Duration::from_secs(4);
    let mut frames = Vec::new();
    while Instant::now() < end {
        let left = end.saturating_duration_since(Instant::now());
        if let Some(Down::Snapshot(snapshot)) = page.next(left).await {
            frames.push(snapshot.frame);
        }
    }
    assert_eq!(frames.len(), 3, "{frames:?}");
    let last = frames[2];
    page.acknowledges = true;
    page.say(&Up::Ack { frame: last }).await;
    page.until("a newer snapshot", SOON, |page| {
        page.snapshot.as_ref().is_some_and(|s| s.frame > last)
    })
    .await;
    // The newest only: what was made in the meantime is not sent.
    let newest = page.snapshot.as_ref().unwrap().frame;
    assert!(newest > last + 10, "{last} then {newest}");
}
