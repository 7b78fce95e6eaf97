//! The buttons of the modes: one that would be refused is greyed and says what it waits for; STANDBY never is (AP-6, AP-25).

use std::time::Duration;
use wheelover_core::view::{FaultKind, ModeRequest, Order};
use wheelover_tests::browser::Browser;
use wheelover_tests::page::Page;
use wheelover_tests::program::Program;

const LONG: Duration = Duration::from_secs(60);

/// Waits until a mode's button is greyed with this reason, for eyes, pointers and screen readers alike; without one, until it is not.
async fn shows(browser: &Browser, button: &str, line: &str, reason: &str) {
    let script = format!(
        "const b = document.querySelector('[data-command=\"{button}\"]'), l = document.querySelector('[data-closed=\"{button}\"]'); \
        const greyed = b.getAttribute('aria-disabled') === 'true' && Number(getComputedStyle(b).opacity) < 1; \
        const described = b.getAttribute('aria-describedby') === l.id; \
        const seen = l.getClientRects().length > 0; \
        const told = l.innerText === {line:?} && (b.getAttribute('title') ?? '') === {reason:?}; \
        return told && [greyed, described, seen].every((one) => one === ({line:?} !== ''));"
    );
    let name = format!("{button}: {line}");
    browser.until(&name, LONG, &script).await;
}

/// No press of a greyed button arms anything, and STANDBY is no button that can be greyed.
async fn inert(browser: &Browser, button: &str) {
    browser.press(button).await;
    let armed = "return !document.querySelector('[data-command=\"confirm\"]').disabled;";
    assert_eq!(browser.run(armed).await, false, "{button}");
    let standby = "const b = document.querySelector('[data-command=\"standby\"]'); \
        return !b.disabled && !b.hasAttribute('aria-disabled');";
    assert_eq!(browser.run(standby).await, true);
}

#[tokio::test]
async fn a_mode_that_would_be_refused_is_greyed_with_what_it_waits_for() {
    const FROM_AUTO: &str = "AutoNAV is selected from AUTO only";
    let program = Program::start(&[]);
    let browser = Browser::open().await;
    browser.go(&format!("http://{}/", program.address)).await;
    let mut page = Page::open(program.address).await;
    assert!(page.command(Order::Officer(false)).await.ok);
    browser
        .until(
            "the buttons",
            LONG,
            "return !!document.querySelector('[data-command=\"standby\"]');",
        )
        .await;
    browser.press("standby").await;
    shows(&browser, "autonav", FROM_AUTO, FROM_AUTO).await;
    shows(&browser, "auto", "", "").await;
    inert(&browser, "autonav").await;

    browser.press("auto").await;
    browser.press("confirm").await;
    shows(&browser, "autonav", "", "").await;
    shows(&browser, "auto", "", "").await;

    // FA7: without a heading the rudder is held, and AUTO waits for one.
    let fault = Order::Fault {
        cable: "gyro1".into(),
        kind: FaultKind::Silent,
        on: true,
    };
    assert!(page.command(fault).await.ok);
    shows(&browser, "auto", "AUTO: no heading", "no heading").await;
    inert(&browser, "auto").await;
    assert_eq!(browser.errors(), [] as [String; 0]);
    browser.close().await;
}

/// Waits until the page shows this, and the autopilot is in that mode.
async fn comes_to(browser: &Browser, mode: &str, set: &str) {
    let script = format!(
        "const value = (name) => document.querySelector(`[data-value=\"${{name}}\"]`); \
        return value('mode').dataset.mode === {mode:?} && value('set-value').innerText.startsWith({set:?});"
    );
    browser
        .until(&format!("{mode}: {set}"), LONG, &script)
        .await;
}

// AP-21, AP-25: selected and set by press and confirm, and STANDBY has its place beside them.
#[tokio::test]
async fn the_modes_are_selected_and_set_by_press_and_confirm() {
    let program = Program::start(&[]);
    let browser = Browser::open().await;
    let mut page = Page::open(program.address).await;
    assert!(page.command(Order::Officer(false)).await.ok);
    let standby = Order::Mode(ModeRequest::Standby);
    assert!(page.command(standby).await.ok);
    browser
        .go(&format!("http://{}/#/modes", program.address))
        .await;
    let there = "return !!document.querySelector('[data-command=\"ffu_override\"]') \
        && !document.querySelector('[data-command=\"ffu_override\"]').disabled;";
    browser.until("the modes", LONG, there).await;
    let reason = "DODGE is selected from AUTO, AutoNAV, TRACK or WIND VANE only";
    let told = format!(
        "const b = document.querySelector('[data-command=\"dodge\"]'); \
        return b.getAttribute('aria-disabled') === 'true' \
        && document.querySelector('[data-closed=\"dodge\"]').innerText === {reason:?};"
    );
    browser.until("DODGE is closed", LONG, &told).await;
    inert(&browser, "dodge").await;

    let steps: [(&str, &[&str], &str, &str); 2] = [
        (
            "ffu_override",
            &["set+10", "set-1"],
            "ffu_override",
            "RUDDER S 4°",
        ),
        ("river_pilot", &["set-10"], "river_pilot", "ROT P 10°/min"),
    ];
    for (mode, presses, key, set) in steps {
        browser.press(mode).await;
        browser.press("confirm").await;
        comes_to(&browser, key, "").await;
        for press in presses {
            browser.press(press).await;
        }
        browser.press("confirm").await;
        comes_to(&browser, key, set).await;
    }
    browser.press("standby").await;
    comes_to(&browser, "standby", "nothing is set").await;
    assert_eq!(browser.errors(), [] as [String; 0]);
    browser.close().await;
}
