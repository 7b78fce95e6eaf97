//! The dialogue page checks what it shows (CON-2), and a decoder does so with what is pasted.

use std::time::Duration;
use wheelover_core::view::{FaultKind, Order};
use wheelover_tests::browser::Browser;
use wheelover_tests::page::Page;
use wheelover_tests::program::Program;

const LONG: Duration = Duration::from_secs(60);

/// Whether the section is there, not flat, within the screen, and says that nothing is broken.
const CLEAN: &str = "const e = document.querySelector('[data-value=\"dialogue-check\"]'); \
    if (!e) return false; const r = e.getBoundingClientRect(); \
    return r.height > 40 && r.right <= innerWidth + 1 && /no breach/.test(e.innerText) \
        && !!e.querySelector('[data-situation=\"2\"], [data-situation=\"1\"], [data-situation=\"5\"]');";

// CON-2
#[tokio::test]
async fn the_dialogue_page_names_the_situation_and_every_breach() {
    let program = Program::start(&["--speed", "5"]);
    let mut page = Page::open(program.address).await;
    let browser = Browser::open().await;
    browser
        .go(&format!("http://{}/#/dialogue", program.address))
        .await;
    browser
        .until("a dialogue without breach", LONG, CLEAN)
        .await;
    let silent = Order::Fault {
        cable: "ecdis".into(),
        kind: FaultKind::Silent,
        on: true,
    };
    assert!(page.command(silent).await.ok);
    let broken =
        "return !!document.querySelector('[data-value=\"dialogue-check\"] [data-rule=\"CON-1\"]');";
    browser.until("a missing sentence", LONG, broken).await;
    assert_eq!(browser.errors(), [] as [String; 0]);
    browser.close().await;
}
