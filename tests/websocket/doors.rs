//! Who may speak to the server, and how long a message may be (FE2, FE3, FE14, FC11).

use std::time::Duration;
use wheelover_tests::http::{UPGRADE, get};
use wheelover_tests::page::Page;
use wheelover_tests::program::Program;

const POLICY: &str = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; \
    img-src 'self' data:; font-src 'self'; connect-src 'self'; manifest-src 'self'; worker-src 'self'; \
    base-uri 'none'; form-action 'self'; frame-ancestors 'none'";

fn upgrade_from(program: &Program, more: &[&str]) -> u16 {
    let headers: Vec<&str> = UPGRADE.iter().chain(more).copied().collect();
    get(program.address, "/ws", &headers).status
}

// FE2
#[test]
fn a_page_from_elsewhere_opens_no_socket() {
    let program = Program::start(&[]);
    for origin in [
        "Origin: http://example.com",
        "Origin: null",
        "Origin: https://127.0.0.1.example.com",
        "Origin: http://127.0.0.1:1",
    ] {
        assert_eq!(upgrade_from(&program, &[origin]), 403, "{origin}");
    }
    // No origin, but a cookie: a browser that hides where its page is from.
    assert_eq!(upgrade_from(&program, &["Cookie: a=b"]), 403);
}

// FE3
#[test]
fn another_name_is_not_served() {
    let program = Program::start(&[]);
    for host in [
        "Host: example.com",
        "Host: wheelover.example:8080",
        "Host: 10.1.2.3",
    ] {
        for path in [
            "/",
            "/healthz",
            "/api/hello",
            "/api/route",
            "/api/alerts",
            "/api/dialogue",
            "/ws",
        ] {
            let answer = get(program.address, path, &[host]);
            assert_eq!(answer.status, 421, "{host} {path}");
            assert!(answer.body.is_empty(), "{host} {path}");
        }
    }
}

// FE14: exact, on every answer.
#[test]
fn every_answer_carries_the_policy() {
    let program = Program::start(&[]);
    for path in [
        "/",
        "/healthz",
        "/api/hello",
        "/api/route",
        "/api/alerts",
        "/api/dialogue",
        "/nothing/here",
    ] {
        let answer = get(program.address, path, &[]);
        assert_eq!(
            answer.header("content-security-policy"),
            Some(POLICY),
            "{path}"
        );
        assert_eq!(
            answer.header("x-content-type-options"),
            Some("nosniff"),
            "{path}"
        );
        assert_eq!(
            answer.header("referrer-policy"),
            Some("no-referrer"),
            "{path}"
        );
    }
    let hello = get(program.address, "/api/hello", &[]);
    let text = String::from_utf8_lossy(&hello.body).into_owned();
    assert!(text.contains("\"protocol\""), "{text}");
    assert_eq!(get(program.address, "/healthz", &[]).status, 200);
}

// FC11: 16 KiB and no more; others go on.
#[tokio::test]
async fn a_longer_frame_ends_that_connection_alone() {
    let program = Program::start(&[]);
    let mut other = Page::open(program.address).await;
    for text in ["x".repeat(16 * 1024 + 1), "x".repeat(2_000_000)] {
        let mut page = Page::open(program.address).await;
        page.say_text(text).await;
        assert!(page.closed(Duration::from_secs(20)).await);
    }
    let mut page = Page::open(program.address).await;
    page.say_text("{\"type\":\"nonsense\"}".into()).await;
    assert!(page.closed(Duration::from_secs(20)).await);
    let before = other.agreed;
    other
        .until("more snapshots", Duration::from_secs(20), |page| {
            page.agreed > before + 5
        })
        .await;
}

/// A client's frame of a kind, masked with zeros, so that its content is as it is.
fn frame(first: u8, content: &[u8]) -> Vec<u8> {
    let mut frame = vec![
        first,
        0x80 | u8::try_from(content.len()).unwrap(),
        0,
        0,
        0,
        0,
    ];
    frame.extend_from_slice(content);
    frame
}

// FC11: each by its own code, so that a page can tell "too long" from "not a frame".
#[tokio::test]
async fn a_connection_is_closed_with_the_code_of_what_was_wrong() {
    let program = Program::start(&[]);
    // The head says 16 KiB and one byte; more need not be sent.
    let too_long = vec![0x81, 0xfe, 0x40, 0x01, 0, 0, 0, 0];
    for (bytes, code, words) in [
        (too_long, 1009, "longer than 16 KiB"),
        (frame(0x83, b"x"), 1002, "not a frame"),
        (frame(0xf1, b"x"), 1002, "not a frame"),
        (frame(0x81, b"\xff\xfe"), 1007, "not text"),
        (frame(0x82, b"x"), 1003, "text only"),
        (frame(0x81, b"{}"), 1007, "not understood"),
    ] {
        let mut page = Page::open(program.address).await;
        page.say_bytes(&bytes).await;
        let closing = page.closing(Duration::from_secs(20)).await;
        assert_eq!(
            closing,
            Some((code, words.to_string())),
            "{:?}",
            &bytes[..2]
        );
    }
}
