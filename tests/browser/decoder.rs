//! The decoder works with the network off, and as one file from a disk.

use std::time::Duration;
use wheelover_tests::browser::Browser;
use wheelover_tests::folder;
use wheelover_tests::http::get;
use wheelover_tests::program::Program;

const LONG: Duration = Duration::from_secs(60);

const OPENED: &str = "return !!document.querySelector('[data-command=\"example\"]');";

const SUMMARY: &str = "const e = document.querySelector('[data-value=\"decoder-summary\"]'); \
    return !!e && /^[1-9][0-9]* lines/.test(e.innerText.trim());";

/// The page explains its own example and what is typed into it.
async fn explains(browser: &Browser) {
    browser.until("the decoder", LONG, OPENED).await;
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
    browser.until("the decoder", LONG, OPENED).await;
    assert_eq!(browser.errors(), [] as [String; 0]);
    program.stop();
    let offline = serde_json::json!({"offline": true, "latency": 0, "downloadThroughput": 0, "uploadThroughput": 0});
    browser.protocol("Network.enable", &serde_json::json!({}));
    browser.protocol("Network.emulateNetworkConditions", &offline);
    explains(&browser).await;
    browser.close().await;
}

/// Widths of a phone, a tablet on end, the width where the layout changes, a notebook, a wide screen.
const WIDTHS: [u32; 6] = [390, 800, 900, 901, 1280, 1920];

/// Whether the decoder's box, its words and its first table are on the screen and not flat.
const SEEN: &str = "const seen = (e) => { const r = e?.getBoundingClientRect(); \
        return !!r && r.width > 200 && r.height > 60 && r.left >= 0 && r.right <= innerWidth + 1; }; \
    return seen(document.querySelector('[data-input=\"lines\"]')) \
        && seen(document.querySelector('[data-sentence]')) \
        && document.querySelector('[data-value=\"decoder-summary\"]').getBoundingClientRect().height > 10;";

/// The page explains its own example at every width, and nothing is refused by a policy or fails.
async fn works_at_every_width(address: &str) {
    let browser = Browser::open().await;
    for width in WIDTHS {
        let size = serde_json::json!({"width": width, "height": 800, "deviceScaleFactor": 1, "mobile": false});
        browser.protocol("Emulation.setDeviceMetricsOverride", &size);
        browser.go(address).await;
        browser.until("the example's lines", LONG, SUMMARY).await;
        browser
            .until(
                &format!("everything at {width}"),
                Duration::from_secs(5),
                SEEN,
            )
            .await;
    }
    explains(&browser).await;
    drops_a_large_file(&browser).await;
    assert_eq!(browser.errors(), [] as [String; 0], "{address}");
    browser.close().await;
}

/// A file of 5 MB whose only fault is in its last line is dropped: it is read whole, and the page lives on meanwhile.
async fn drops_a_large_file(browser: &Browser) {
    let script = "const line = '$HEHDT,216.8,T*22\\r\\n'; const count = Math.ceil(5e6 / line.length); \
        const file = new File([line.repeat(count), '$HEHDT,216.8,T*23\\r\\n'], 'night.nmea'); \
        window.longest = 0; window.said = []; let last = performance.now(); \
        const beat = setInterval(() => { const now = performance.now(); \
            window.longest = Math.max(window.longest, now - last); last = now; \
            window.said.push(document.querySelector('[data-value=\"decoder-summary\"]').innerText); }, 10); \
        const data = new DataTransfer(); data.items.add(file); \
        const target = document.querySelector('[data-input=\"lines\"]'); \
        target.dispatchEvent(new DragEvent('drop', {dataTransfer: data, bubbles: true, cancelable: true})); \
        return count + 1;";
    let lines = browser.run(script).await;
    let words = format!(
        "return document.querySelector('[data-value=\"decoder-summary\"]').innerText.startsWith('{lines} lines, 1 with faults');"
    );
    browser.until("the whole file", LONG, &words).await;
    let found = format!(
        "return document.body.innerText.includes('line {lines}') \
        && document.body.innerText.includes('checksum 23: should be 22');"
    );
    browser.until("the fault at its end", LONG, &found).await;
    let seen = browser
        .run("return window.said.some((words) => words.startsWith('reading, '));")
        .await;
    assert_eq!(seen, true, "how far it has come is shown");
    let longest = browser
        .run("return window.longest;")
        .await
        .as_f64()
        .unwrap();
    println!("longest pause of the page while it read 5 MB: {longest:.0} ms");
    assert!(longest < 1_000.0, "the page froze for {longest:.0} ms");
    let file = browser.value("decoder-file").await.0;
    assert!(
        file.contains("night.nmea") && file.contains("whole"),
        "{file}"
    );
}

#[tokio::test]
async fn the_decoder_works_from_a_disk_at_every_width() {
    let program = Program::start(&[]);
    let answer = get(program.address, "/decoder.html", &[]);
    assert_eq!(answer.status, 200);
    let file = folder("decoder").join("decoder.html");
    std::fs::write(&file, &answer.body).unwrap();
    drop(program);
    works_at_every_width(&format!("file://{}", file.display())).await;
}

// FE14: its scripts stand in it, and its own policy names each by its hash.
#[tokio::test]
async fn the_decoder_works_from_the_server_at_every_width() {
    let program = Program::start(&[]);
    let answer = get(program.address, "/decoder.html", &[]);
    let policy = answer.header("content-security-policy").unwrap_or_default();
    assert!(
        policy.starts_with("default-src 'none'; script-src 'wasm-unsafe-eval' 'sha256-"),
        "{policy}"
    );
    assert!(
        !policy.contains("unsafe-inline") && !policy.contains("'self'"),
        "{policy}"
    );
    works_at_every_width(&format!("http://{}/decoder.html", program.address)).await;
}
