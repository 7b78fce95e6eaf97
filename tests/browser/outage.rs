//! No link: everything goes dead together, nothing that is pressed is lost without a word, and no clock on the wall hides it.

use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use std::time::{Duration, Instant};
use wheelover_core::view::ModeName;
use wheelover_tests::browser::Browser;
use wheelover_tests::page::Page;
use wheelover_tests::program::Program;

const LONG: Duration = Duration::from_secs(60);

/// Everything on the bridge view that still looks alive.
const LIT: &str = "const lit = []; \
    for (const e of document.querySelectorAll('[data-value][data-state=\"valid\"], [data-value][data-state=\"late\"]')) lit.push(e.dataset.value); \
    for (const e of document.querySelectorAll('[data-command][aria-pressed=\"true\"]')) \
        if (!/-up$/.test(e.dataset.command)) lit.push(e.dataset.command); \
    for (const e of document.querySelectorAll('[data-alert]')) lit.push('alert ' + e.dataset.alert); \
    const label = (text) => [...document.querySelectorAll('p, span')].find((e) => e.children.length === 0 && e.innerText.startsWith(text)); \
    for (const text of ['WOL', 'NEXT TRACK', 'TURN END']) { \
        const number = label(text)?.nextElementSibling?.innerText ?? ''; if (/[0-9]/.test(number)) lit.push(`${text} ${number}`); } \
    const terms = label('ORDER =')?.parentElement?.innerText ?? ''; if (/[0-9]/.test(terms)) lit.push(terms); \
    const gauge = document.querySelector('[aria-label=\"rudder order and response\"]')?.textContent ?? ''; \
    if (/limit [0-9]/.test(gauge)) lit.push(gauge); \
    return lit.join(', ');";

const NO_LINK: &str = "const e = document.querySelector('[data-value=\"no-link\"]'); return !!e && e.innerText.includes('NO LINK');";

const UNSENT: &str = "return document.querySelector('[data-value=\"no-link\"]').innerText\
    .includes(\"NO LINK: STANDBY not sent, use the ship's own override\");";

fn signal(program: &Program, signal: Signal) {
    let id = i32::try_from(program.id()).unwrap();
    kill(Pid::from_raw(id), signal).unwrap();
}

async fn sailing(program: &Program) -> (Browser, Page) {
    let browser = Browser::open().await;
    browser.go(&format!("http://{}/", program.address)).await;
    let lit =
        "return document.querySelector('[data-value=\"mode\"]')?.dataset.mode === 'autonav_ti';";
    browser
        .until("track control on the page", Duration::from_secs(120), lit)
        .await;
    (browser, Page::open(program.address).await)
}

/// AP-25: without a link STANDBY is not disabled, and answered at once.
async fn standby_is_answered(browser: &Browser) {
    let none = browser.value("no-alerts").await.0;
    assert_eq!(none, "ALERTS NOT KNOWN");
    browser.press("standby").await;
    browser
        .until("STANDBY was not sent", Duration::from_secs(1), UNSENT)
        .await;
}

// FC5, FD5, AP-25.
#[tokio::test]
async fn without_a_link_everything_is_dead_and_standby_says_so() {
    let program = Program::start(&[]);
    let (browser, mut page) = sailing(&program).await;
    assert_ne!(browser.run(LIT).await, "", "the page is alive");
    signal(&program, Signal::SIGSTOP);
    let stopped = Instant::now();
    // Somebody sets the clock on the wall back while nothing comes.
    browser
        .run("const now = Date.now; Date.now = () => now() - 3600000;")
        .await;
    browser
        .until("NO LINK", Duration::from_secs(10), NO_LINK)
        .await;
    let took = stopped.elapsed();
    println!("NO LINK {took:?} after the server stood still");
    assert!(took < Duration::from_secs(4), "{took:?}");
    assert_eq!(browser.run(LIT).await, "", "what is still lit with NO LINK");
    // It stays so.
    for _ in 0..10 {
        tokio::time::sleep(Duration::from_millis(200)).await;
        assert_eq!(browser.run(LIT).await, "");
    }
    standby_is_answered(&browser).await;
    signal(&program, Signal::SIGCONT);
    browser
        .until(
            "the link",
            Duration::from_secs(20),
            "return document.querySelector('[data-value=\"link-age\"]').dataset.state === 'valid';",
        )
        .await;
    page.follow(Duration::from_secs(3)).await;
    let mode = page
        .snapshot
        .as_ref()
        .and_then(|s| s.own.as_ref())
        .map(|own| own.mode);
    assert_ne!(mode, Some(ModeName::Standby), "it is not sent later");
    browser.press("standby").await;
    page.until("STANDBY with a link", LONG, |page| {
        let own = page.snapshot.as_ref().and_then(|s| s.own.as_ref());
        own.is_some_and(|own| own.mode == ModeName::Standby)
    })
    .await;
    assert_eq!(browser.errors(), [] as [String; 0]);
    browser.close().await;
}

#[tokio::test]
async fn standby_into_a_link_that_has_just_died_is_not_waited_for() {
    let program = Program::start(&[]);
    let (browser, _page) = sailing(&program).await;
    signal(&program, Signal::SIGSTOP);
    browser.press("standby").await;
    let said = "return /NO (LINK|ANSWER): STANDBY/.test(document.querySelector('[data-value=\"no-link\"]').innerText);";
    browser
        .until("no answer to STANDBY", Duration::from_secs(4), said)
        .await;
    signal(&program, Signal::SIGCONT);
    browser.close().await;
}

#[tokio::test]
async fn a_page_that_begins_without_a_server_says_so() {
    let mut program = Program::start(&[]);
    let browser = Browser::open().await;
    browser.go(&format!("http://{}/", program.address)).await;
    // The service worker has the page when it controls it.
    let kept = "return !!navigator.serviceWorker.controller;";
    browser.until("the page is kept", LONG, kept).await;
    program.stop();
    browser.go(&format!("http://{}/", program.address)).await;
    browser.until("NO LINK", LONG, NO_LINK).await;
    assert_eq!(browser.run(LIT).await, "");
    standby_is_answered(&browser).await;
    browser.close().await;
}
