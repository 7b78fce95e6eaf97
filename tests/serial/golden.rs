//! FB14: golden logs through a real pseudo-terminal into the server, and directly: the same lines, the same explanation.

use crate::autopilot;
use std::fmt::Write;
use std::time::Duration;
use wheelover_core::nmea::{Framer, json, with_checksum};
use wheelover_core::station::Direction;
use wheelover_core::view;
use wheelover_core::voyage::{Event, Voyage, VoyageOutput};
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::Line;
use wheelover_tests::{data, folder};

/// Every printed example of the documents: as it is printed, and with its placeholder replaced by a checksum.
fn seeds() -> Vec<Vec<u8>> {
    let mut lines = Vec::new();
    for name in ["navis", "emacua", "furuno"] {
        let log = std::fs::read_to_string(data(&format!("seeds/{name}.log"))).unwrap();
        for line in log.lines().filter(|line| !line.starts_with('#')) {
            lines.push(line.as_bytes().to_vec());
            let body = line.split('*').next().unwrap();
            lines.push(with_checksum(body).into_bytes());
        }
    }
    lines
}

/// What the autopilot of the embedded voyage hears and says in that many seconds.
fn voyage(seconds: u64) -> Vec<Vec<u8>> {
    let mut voyage = Voyage::embedded(14);
    let mut out = Vec::new();
    for _ in 0..seconds {
        voyage.handle(voyage.now() + 1_000, Event::Tick, &mut out);
    }
    let line = |output: VoyageOutput| match output {
        VoyageOutput::Line(line) => Some(line.text.chars().map(|c| c as u8).collect()),
        _ => None,
    };
    out.into_iter().filter_map(line).collect()
}

/// The log as a port gets it: with the ends of lines that makers use, and noise between.
fn stream(lines: &[Vec<u8>]) -> Vec<u8> {
    let noise: [&[u8]; 5] = [
        b"",
        b"\x00\xff\x80noise\r\n",
        b"$EIHTC,V,,,S,N",
        b"\\s:EI0001,c:1700000000*1F\\",
        b"\r\n\r\n",
    ];
    let mut bytes = Vec::new();
    for (at, line) in lines.iter().enumerate() {
        if at.is_multiple_of(7) {
            bytes.extend_from_slice(noise[at / 7 % noise.len()]);
        }
        bytes.extend_from_slice(line);
        let end: &[u8] = if at.is_multiple_of(11) {
            b"\n"
        } else {
            b"\r\n"
        };
        bytes.extend_from_slice(end);
    }
    bytes
}

/// One JSON object a line, as `decode --json` prints them.
fn explained(lines: impl Iterator<Item = Vec<u8>>) -> String {
    let mut text = String::new();
    for (at, line) in lines.enumerate() {
        let _ = writeln!(text, "{}", json(at as u64 + 1, None, &line));
    }
    text
}

#[tokio::test]
async fn a_golden_log_over_a_serial_line_is_what_it_is_directly() {
    let mut lines = seeds();
    lines.extend(voyage(60));
    let bytes = stream(&lines);
    // More at once is a flood, which a port holds back.
    assert!(bytes.len() < 250_000, "{} bytes", bytes.len());

    let mut framer = Framer::new();
    let mut frames = Vec::new();
    framer.push(&bytes, &mut |frame| frames.push(frame.text.to_vec()));
    assert!(frames.len() > 3_000, "{} frames", frames.len());
    let direct = explained(frames.iter().cloned());

    let folder = folder("golden");
    let mut port = Line::new(&folder.join("ecdis"));
    let config = autopilot(&folder, &["ecdis"], false);
    let program = Program::start(&["--config", &config]);
    let mut page = Page::open(program.address).await;
    // What a terminal holds when it is opened is thrown away.
    page.until("the port", SOON, |page| {
        let mut ports = page.ports.iter().flat_map(|ports| &ports.ports);
        ports.any(|port| port.name == "ecdis" && port.up)
    })
    .await;
    // Pieces of changing size, as a driver hands them over.
    let sender = std::thread::spawn(move || {
        let (mut rest, mut size) = (bytes.as_slice(), 1);
        while !rest.is_empty() {
            let (piece, after) = rest.split_at(size.min(rest.len()));
            port.send(piece);
            rest = after;
            size = size * 7 % 1_021 + 1;
        }
        port
    });
    let wanted = frames.len();
    let heard = |page: &Page| {
        let lines = page.lines.iter();
        let heard = |line: &&view::Line| line.dir == Direction::In;
        lines.filter(heard).count()
    };
    let name = format!("{wanted} lines");
    page.until(&name, Duration::from_secs(60), |page| heard(page) >= wanted)
        .await;
    drop(sender.join());
    let of_line = |line: &view::Line| line.text.chars().map(|c| c as u8).collect();
    let served = explained(
        page.lines
            .iter()
            .filter(|line| line.dir == Direction::In)
            .map(of_line),
    );
    assert!(page.gaps.is_empty(), "{:?}", page.gaps);
    for (a, b) in served.lines().zip(direct.lines()) {
        assert_eq!(a, b);
    }
    assert_eq!(served.lines().count(), direct.lines().count());
}
