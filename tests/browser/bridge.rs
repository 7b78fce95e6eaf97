//! The bridge view of the embedded voyage: what it shows is what the lines say, and its buttons work.

use std::time::{Duration, Instant};
use wheelover_core::alerts::State;
use wheelover_core::nmea::{self, Hdt, Htc, Pney2, Xte};
use wheelover_core::station::Direction;
use wheelover_core::view::{FaultKind, ModeName, Order};
use wheelover_tests::browser::Browser;
use wheelover_tests::page::Page;
use wheelover_tests::program::Program;

const LONG: Duration = Duration::from_secs(60);

const LIVE: &str = "const e = document.querySelector('[data-value=\"heading\"]'); \
    return !!e && e.dataset.state === 'valid' && /^[0-9]/.test(e.innerText.trim());";

async fn live(program: &Program) -> Browser {
    let browser = Browser::open().await;
    browser.go(&format!("http://{}/", program.address)).await;
    browser.until("a live heading", LONG, LIVE).await;
    browser
}

fn mode(page: &Page) -> Option<ModeName> {
    page.snapshot.as_ref()?.own.as_ref().map(|own| own.mode)
}

/// The number that a text begins with.
fn number(text: &str) -> Option<f64> {
    let kept: String = text
        .chars()
        .filter(|c| c.is_ascii_digit() || *c == '.')
        .collect();
    kept.parse().ok()
}

/// Degrees and thousandths of a minute, as the page writes them.
fn angle(degrees: f64, digits: usize, side: char) -> String {
    let thousandths = (degrees.abs() * 60_000.0).round();
    let whole = (thousandths / 60_000.0).floor();
    let minutes = (thousandths - whole * 60_000.0) / 1000.0;
    format!("{whole:0digits$.0}°{minutes:06.3}′{side}")
}

#[tokio::test]
async fn the_picture_moves_and_equals_the_lines() {
    let program = Program::start(&["--speed", "5"]);
    let browser = live(&program).await;
    let mut page = Page::open(program.address).await;
    page.until(
        "a radius centre under track control",
        Duration::from_secs(120),
        |page| {
            let pney2 = page.picture.pney2.as_ref();
            mode(page) == Some(ModeName::AutonavTi)
                && pney2.is_some_and(|heard| heard.value.centre.is_some())
        },
    )
    .await;
    page.command(Order::Speed(1.0)).await;
    page.follow(Duration::from_secs(3)).await;

    let place =
        "return document.querySelector('[data-plan=\"heading-line\"]')?.getAttribute('d') || '';";
    let (before, from) = (browser.run(place).await, page.line);
    let centre = browser.value("radius-centre").await.0;
    let mut headings = Vec::new();
    let mut distances = Vec::new();
    for _ in 0..5 {
        headings.push(browser.value("heading").await.0);
        distances.push(browser.value("xtd").await.0);
        page.follow(Duration::from_millis(700)).await;
    }
    assert_ne!(before, "", "the ship's heading line is drawn");
    assert_ne!(browser.run(place).await, before, "the ship moves");
    for part in ["own-ship", "leg", "arc", "radius-centre", "track-made-good"] {
        let script = format!("return !!document.querySelector('[data-plan=\"{part}\"]');");
        assert_eq!(browser.run(&script).await, true, "{part}");
    }

    // Each value shown stands, as the page writes it, in a line of these seconds (five before, for the way to the page).
    let recent = page
        .lines
        .iter()
        .filter(|line| line.seq + 300 > from && line.dir == Direction::In);
    let recent: Vec<_> = recent
        .map(|line| nmea::decode(line.text.as_bytes()))
        .collect();
    let heard: Vec<f64> = recent
        .iter()
        .filter_map(|s| Hdt::from_sentence(s)?.heading)
        .collect();
    for shown in &headings {
        let shown = number(shown).unwrap_or(-1.0);
        let nearest = heard.iter().fold(999.0_f64, |least, heading| {
            least.min((heading - shown).abs())
        });
        assert!(nearest < 0.051, "{shown} is in no line: {heard:?}");
    }
    let heard: Vec<f64> = recent
        .iter()
        .filter_map(|s| Xte::from_sentence(s)?.cross_track)
        .collect();
    for shown in &distances {
        let shown = number(shown).unwrap_or(-1.0);
        let nearest = heard.iter().fold(999.0_f64, |least, xtd| {
            least.min(((xtd * 1852.0).abs() - shown).abs())
        });
        assert!(nearest <= 0.51, "{shown} m is in no line: {heard:?}");
    }
    let of_lines: Vec<String> = recent
        .iter()
        .filter_map(|s| Pney2::from_sentence(s)?.centre)
        .map(|p| format!("{}{}", angle(p.lat, 2, 'N'), angle(p.lon, 3, 'E')))
        .collect();
    let shown: String = centre.split_whitespace().collect();
    assert!(of_lines.contains(&shown), "{shown}: {of_lines:?}");
    let radius = recent
        .iter()
        .filter_map(|s| Htc::from_sentence(s)?.radius)
        .next_back();
    assert_eq!(number(&browser.value("radius").await.0), radius);
    assert_eq!(browser.errors(), [] as [String; 0]);
    browser.close().await;
}

#[tokio::test]
async fn a_silenced_chart_brings_track_fail_and_it_is_acknowledged() {
    let program = Program::start(&["--speed", "5"]);
    let browser = live(&program).await;
    let mut page = Page::open(program.address).await;
    page.until("track control", Duration::from_secs(120), |page| {
        mode(page) == Some(ModeName::AutonavTi)
    })
    .await;
    page.command(Order::Speed(1.0)).await;
    // Nobody but this page may acknowledge.
    assert!(page.command(Order::Officer(false)).await.ok);
    page.follow(Duration::from_secs(2)).await;
    let from = page.lines.len();
    browser.press("fault-chart-silent").await;
    let shown =
        |number: u16| format!("return !!document.querySelector('[data-alert=\"{number}\"]');");
    browser
        .until("TRACK FAIL on the page", LONG, &shown(101))
        .await;
    page.until("TRACK FAIL in the snapshot", LONG, |page| {
        alert(page, 101).is_some()
    })
    .await;
    // FA1, by the ship's own clock: the last HTC heard, and the time of the alarm.
    let htc = page.lines[from.saturating_sub(300)..].iter();
    let last = htc
        .filter(|line| line.dir == Direction::In && line.text.contains("HTC,"))
        .map(|line| line.at)
        .max();
    let alarm = alert(&page, 101).unwrap_or_default();
    let waited = alarm.saturating_sub(last.unwrap_or_default());
    assert!((5_000..=5_200).contains(&waited), "{waited} ms");
    browser
        .until(
            "AUTO on the page",
            LONG,
            "return /AUTO/.test(document.querySelector('[data-value=\"mode\"]').innerText);",
        )
        .await;
    assert!(!browser.alert(101).await.is_empty());
    page.follow(Duration::from_secs(10)).await;
    assert_eq!(state(&page, 101), Some(State::Unacknowledged));
    browser.press("acknowledge").await;
    let taken = "const e = document.querySelector('[data-alert=\"101\"]'); return !!e && e.dataset.state === 'acknowledged';";
    browser
        .until("the acknowledgement on the page", LONG, taken)
        .await;
    page.follow(Duration::from_secs(1)).await;
    assert_eq!(state(&page, 101), Some(State::Acknowledged));
    let fault = Order::Fault {
        cable: "ecdis".into(),
        kind: FaultKind::Silent,
        on: false,
    };
    assert!(page.command(fault).await.ok);
    assert_eq!(browser.errors(), [] as [String; 0]);
    browser.close().await;
}

fn state(page: &Page, number: u16) -> Option<State> {
    let alerts = &page.snapshot.as_ref()?.alerts;
    alerts
        .iter()
        .find(|alert| alert.number == number)
        .map(|alert| alert.state)
}

fn alert(page: &Page, number: u16) -> Option<u64> {
    let alerts = &page.snapshot.as_ref()?.alerts;
    alerts
        .iter()
        .find(|alert| alert.number == number)
        .map(|alert| alert.at)
}

#[tokio::test]
async fn the_digests_agree_over_a_whole_voyage_at_sixty_times_the_time() {
    let program = Program::start(&["--speed", "60"]);
    let browser = live(&program).await;
    browser
        .go(&format!("http://{}/#/about", program.address))
        .await;
    let mut page = Page::open(program.address).await;
    let end = Instant::now() + Duration::from_secs(400);
    let (mut agreed, mut round) = (0, 1);
    while round < 2 {
        assert!(
            Instant::now() < end,
            "round {round} does not end: {:?}",
            page.snapshot
        );
        page.follow(Duration::from_millis(500)).await;
        let voyage = page.snapshot.as_ref().and_then(|s| s.voyage.as_ref());
        round = voyage.map_or(1, |voyage| voyage.round);
        let text = browser.value("agreement").await.0;
        assert!(!text.contains("DIFFERS"), "{text}");
        agreed += u32::from(text.starts_with("agrees"));
    }
    assert!(agreed > 50, "{agreed} looks agreed");
    assert_eq!(page.differed, [] as [u64; 0]);
    assert_eq!(browser.errors(), [] as [String; 0]);
    browser.close().await;
}
