//! The decoder works with the network off, and as one file from a disk.

use std::time::Duration;
use wheelover_tests::browser::Browser;
use wheelover_tests::folder;
use wheelover_tests::http::get;
use wheelover_tests::program::Program;

const LONG: Duration = Duration::from_secs(60);

const SUMMARY: &str = "const e = document.querySelector('[data-value=\"decoder-summary\"]'); \
    return !!e && /^[1-9][0-9]* lines/.test(e.innerText.trim());";

/// The page explains its own example and what is typed into it.
async fn explains(browser: &Browser) {
    browser
        .until(
            "the decoder",
            LONG,
            "return !!document.querySelector('[data-command=\"example\"]');",
        )
        .await;
    browser.press("example").await;
    browser.until("the example's lines", LONG, SUMMARY).await;
    let script = "const t = document.querySelector('[data-input=\"lines\"]'); \
        t.value = '$EIHTC,V,,,T,R,,,,,245.0,T,C*00'; t.dispatchEvent(new Event('input', {bubbles: true}));";
    browser.run(script).await;
    let faults = "return document.querySelector('[data-value=\"decoder-summary\"]').innerText.includes('1 with faults');";
    browser
        .until("the faults of a printed example", LONG, faults)
        .await;
}

#[tokio::test]
async fn the_decoder_goes_on_when_the_server_is_gone() {
    let mut program = Program::start(&[]);
    let browser = Browser::open().await;
    browser
        .go(&format!("http://{}/#/decoder", program.address))
        .await;
    browser
        .until(
            "the decoder",
            LONG,
            "return !!document.querySelector('[data-command=\"example\"]');",
        )
        .await;
    assert_eq!(browser.errors(), [] as [String; 0]);
    program.stop();
    let offline = serde_json::json!({"offline": true, "latency": 0, "downloadThroughput": 0, "uploadThroughput": 0});
    browser.protocol("Network.enable", &serde_json::json!({}));
    browser.protocol("Network.emulateNetworkConditions", &offline);
    explains(&browser).await;
    browser.close().await;
}

#[tokio::test]
async fn the_decoder_works_from_a_disk() {
    let program = Program::start(&[]);
    let answer = get(program.address, "/decoder.html", &[]);
    assert_eq!(answer.status, 200);
    let file = folder("decoder").join("decoder.html");
    std::fs::write(&file, &answer.body).unwrap();
    drop(program);
    let browser = Browser::open().await;
    browser.go(&format!("file://{}", file.display())).await;
    explains(&browser).await;
    assert_eq!(browser.errors(), [] as [String; 0]);
    browser.close().await;
}
