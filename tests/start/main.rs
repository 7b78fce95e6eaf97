//! How soon a slow tablet shows a live value. Alone in its program, so that no other test takes the time.

use serde_json::json;
use std::time::Duration;
use wheelover_tests::browser::Browser;
use wheelover_tests::program::Program;

/// What a first load may take on a tablet a quarter as fast as this machine, milliseconds.
const LIMIT: f64 = 2_000.0;

/// Starts of a new browser; the machine may be busy during some.
const STARTS: usize = 5;

/// Notes when the heading is live, and has been painted: the frame after the one that changed it has begun.
const WATCH: &str = "new MutationObserver((_, watch) => { \
        if (document.querySelector('[data-value=\"heading\"]')?.dataset.state !== 'valid') return; \
        watch.disconnect(); \
        requestAnimationFrame(() => setTimeout(() => { window.firstLive = performance.now(); })); \
    }).observe(document, { subtree: true, childList: true, attributes: true });";

#[tokio::test]
async fn the_first_value_is_live_soon_on_a_slow_tablet() {
    let program = Program::start(&[]);
    let mut best = f64::INFINITY;
    for _ in 0..STARTS {
        // Nothing is in a new browser's cache.
        let browser = Browser::open().await;
        let source = json!({"source": WATCH});
        browser.protocol("Page.addScriptToEvaluateOnNewDocument", &source);
        browser.protocol("Emulation.setCPUThrottlingRate", &json!({"rate": 4}));
        browser.go(&format!("http://{}/", program.address)).await;
        let done = "return window.firstLive !== undefined;";
        let long = Duration::from_secs(60);
        browser.until("a live heading", long, done).await;
        let took = browser.run("return window.firstLive;").await.as_f64();
        let took = took.expect("a time");
        println!("first live value painted after {took:.0} ms at 4x CPU throttle");
        assert_eq!(browser.errors(), [] as [String; 0]);
        browser.close().await;
        best = best.min(took);
        if best <= LIMIT {
            return;
        }
    }
    panic!("{best:.0} ms at best");
}
