//! Every printed example of the source documents, with the faults and hints that it must give (SEN-5, SEN-6, EMC-1).
//!
//! `WHEELOVER_REWRITE=1` writes the expectations anew; a change is reviewed like code.

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use wheelover_core::command::htc;
use wheelover_core::nmea::{Checksum, decode, encode, hints, with_checksum};

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/data/seeds")
}

/// A line with its placeholder replaced by the right checksum; a printed checksum stays.
fn repaired(line: &str) -> String {
    for placeholder in ["*hh", "*xx", "*Chksum"] {
        if let Some(body) = line.strip_suffix(placeholder) {
            return with_checksum(body);
        }
    }
    line.to_owned()
}

fn describe(line: &str) -> String {
    let text = repaired(line);
    let sentence = decode(text.as_bytes());
    let mut out = format!("{line}\n  {} {}", sentence.talker(), sentence.formatter);
    match (sentence.known, sentence.checksum) {
        (None, _) => out.push_str(" unknown"),
        (_, Checksum::Right(_)) => {}
        (_, checksum) => _ = write!(out, " {checksum:?}"),
    }
    let faults = sentence.faults();
    if faults.is_empty() && sentence.known.is_some() {
        out.push_str(" clean");
        assert_eq!(
            encode(&sentence).as_deref(),
            Some(text.as_str()),
            "canonical lines come back"
        );
    }
    for fault in &faults {
        let _ = write!(out, "\n  {}: {fault}", fault.kind.name());
    }
    for hint in hints(&sentence) {
        let _ = write!(out, "\n  hint: {hint}");
    }
    if sentence.formatter == "HTC" {
        match htc(&sentence, true) {
            Ok(command) => _ = write!(out, "\n  steers: {command:?}"),
            Err(refusal) => _ = write!(out, "\n  refused: {refusal}"),
        }
    }
    out.push('\n');
    out
}

#[test]
fn printed_examples_give_their_faults() {
    let mut logs = 0;
    for entry in fs::read_dir(folder())
        .expect("the folder of the seeds")
        .flatten()
    {
        let path = entry.path();
        if path.extension().is_none_or(|e| e != "log") {
            continue;
        }
        logs += 1;
        let log = fs::read_to_string(&path).expect("a log");
        let found: String = log
            .lines()
            .filter(|l| !l.starts_with('#'))
            .map(describe)
            .collect();
        let expectation = path.with_extension("chk");
        if std::env::var_os("WHEELOVER_REWRITE").is_some() {
            fs::write(&expectation, &found).expect("the expectation is written");
        }
        let expected = fs::read_to_string(&expectation).expect("an expectation beside each log");
        assert_eq!(found, expected, "{}", path.display());
    }
    assert_eq!(logs, 3);
}

#[test]
fn the_checksummed_examples_of_the_small_craft_document_are_clean() {
    let log = fs::read_to_string(folder().join("emacua.log")).expect("the log");
    let printed = log
        .lines()
        .filter(|l| !l.starts_with('#') && !l.ends_with("*xx"));
    let clean = printed
        .filter(|line| decode(line.as_bytes()).is_clean())
        .count();
    assert_eq!(clean, 19);
}
