//! Samples with meanings written by hand from the sources: value, unit, meaning, faults, hints and encoding
//! (SEN-3, SEN-5, SEN-6, SEN-7, SEN-8, SEN-9, EMC-1, EMC-3, EMC-4).

use std::fs;
use std::path::PathBuf;
use wheelover_core::nmea::{JsonField, JsonValue, decode, encode, json_line, with_checksum};

/// The sentences of the four documents (interface, section 6), those of `$PEMC` with their numbers (EMC-1, EMC-4).
const SENTENCES: &str = "HTC HTD XTE APB BWC BWR HSC VTG GGA GLL VHW VBW HDT THS HDG HDM ROT RSA ROR HMS HMR ALR ALA \
    PNEY,001 PNEY,002 \
    ABM ACK ALC ALF ARC BBM EVE HBT MTW MWV OSD RMC RSD TLB TTD TTM VDM VDO VDR VSD ZDA \
    MWD VWR XDR BOD RMB WPL RTE VLW \
    PEMC,00 PEMC,01 PEMC,02 PEMC,03 PEMC,04 PEMC,05 PEMC,06 PEMC,07 PEMC,08 PEMC,09 PEMC,10 PEMC,11 \
    PEMC,12 PEMC,13 PEMC,14 PEMC,99";

/// A line and what its source says of it.
#[derive(Debug, Default)]
struct Sample {
    file: String,
    line: String,
    fields: Vec<String>,
    faults: Vec<String>,
    hints: Vec<String>,
    /// The encoder gives another line, on purpose.
    not_canonical: bool,
}

fn samples() -> Vec<Sample> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/data/samples");
    let mut samples: Vec<Sample> = Vec::new();
    for entry in fs::read_dir(folder).expect("the samples").flatten() {
        let path = entry.path();
        if path.extension().is_none_or(|extension| extension != "txt") {
            continue;
        }
        let file = entry.file_name().to_string_lossy().into_owned();
        let text = fs::read_to_string(&path).expect("a file of samples");
        for line in text.lines() {
            let text = line.trim();
            if line.starts_with(['$', '!', '\\']) {
                samples.push(Sample {
                    file: file.clone(),
                    line: repaired(line),
                    ..Sample::default()
                });
            } else if !text.is_empty() && !text.starts_with('#') {
                let last = samples.last_mut().expect("a sentence first");
                match text.split_at(2) {
                    ("! ", fault) => last.faults.push(fault.into()),
                    ("? ", hint) => last.hints.push(hint.into()),
                    ("~ ", _) => last.not_canonical = true,
                    _ => last.fields.push(text.into()),
                }
            }
        }
    }
    samples
}

/// A line with its placeholder replaced by the right checksum; a printed checksum stays.
fn repaired(line: &str) -> String {
    let body = ["*hh", "*xx", "*Chksum"]
        .iter()
        .find_map(|placeholder| line.strip_suffix(placeholder));
    body.map_or_else(|| line.to_owned(), with_checksum)
}

/// A field as decoded, in the words of the samples; numbers as the sample writes them where they agree.
fn written(field: &JsonField, expected: &str) -> String {
    let (left, meaning) = match expected.split_once(" | ") {
        Some((left, _)) => (left, field.meaning.map(|words| format!(" | {words}"))),
        None => (expected, field.meaning.map(|words| format!(" | {words}"))),
    };
    let number = left
        .split(' ')
        .nth(3)
        .and_then(|text| Some((text, text.parse::<f64>().ok()?)));
    let same = |value: f64| number.filter(|(_, wanted)| (value - wanted).abs() < 1e-9);
    let value = match &field.value {
        JsonValue::Null => "null".into(),
        JsonValue::Number(value) => {
            same(*value).map_or_else(|| value.to_string(), |(text, _)| text.into())
        }
        JsonValue::Integer(value) => value.to_string(),
        JsonValue::Text(text) if meaning.is_some() => text.clone(),
        JsonValue::Text(text) => format!("\"{text}\""),
    };
    let unit = field.unit.map(|unit| format!(" {unit}"));
    format!(
        "{} {} = {value}{}{}",
        field.n,
        field.name,
        unit.unwrap_or_default(),
        meaning.unwrap_or_default()
    )
}

#[test]
fn every_sample_means_what_its_source_says() {
    let samples = samples();
    let mut differences = Vec::new();
    for sample in &samples {
        let sentence = decode(sample.line.as_bytes());
        let json = json_line(1, None, &sentence);
        let mut found: Vec<String> = Vec::new();
        for (at, field) in json.fields.iter().enumerate() {
            let expected = sample.fields.get(at).map_or("", String::as_str);
            found.push(written(field, expected));
        }
        let mut expected = sample.fields.clone();
        let faults = json.faults.iter().map(|fault| {
            let field = fault.n.map_or_else(|| "-".into(), |n| n.to_string());
            format!("! {} {field}: {}", fault.kind, fault.text)
        });
        found.extend(faults);
        expected.extend(sample.faults.iter().map(|fault| format!("! {fault}")));
        found.extend(json.hints.iter().map(|hint| format!("? {hint}")));
        expected.extend(sample.hints.iter().map(|hint| format!("? {hint}")));
        for at in 0..found.len().max(expected.len()) {
            let (found, expected) = (found.get(at), expected.get(at));
            if found != expected {
                let (file, line) = (&sample.file, &sample.line);
                let nothing = String::from("nothing");
                differences.push(format!(
                    "{file}: {line}\n  source:  {}\n  decoder: {}",
                    expected.unwrap_or(&nothing),
                    found.unwrap_or(&nothing)
                ));
            }
        }
    }
    assert!(differences.is_empty(), "{}", differences.join("\n"));
    assert!(samples.len() > 80, "{} samples", samples.len());
}

#[test]
fn a_canonical_sample_comes_back_byte_for_byte() {
    let mut canonical = 0;
    for sample in samples() {
        if sample.faults.is_empty() && !sample.not_canonical {
            let sentence = decode(sample.line.as_bytes());
            assert_eq!(encode(&sentence).as_deref(), Some(sample.line.as_str()));
            canonical += 1;
        }
    }
    assert!(canonical > 80, "{canonical} canonical samples");
}

/// Every kind of fault, as JSON names it.
const KINDS: &str = "bad_address bad_character bad_date bad_checksum bad_hex bad_payload bad_time bad_width extra_field \
    field_count minutes_too_large missing_checksum missing_part not_an_integer not_a_number out_of_range too_long \
    too_much_text unknown_code wrong_letter";

#[test]
fn every_kind_of_fault_has_a_sample() {
    let samples = samples();
    let has = |kind: &&str| {
        let mut faults = samples.iter().flat_map(|sample| &sample.faults);
        faults.any(|fault| fault.split(' ').next() == Some(*kind))
    };
    let missing: Vec<&str> = KINDS.split_whitespace().filter(|kind| !has(kind)).collect();
    assert!(missing.is_empty(), "no sample of {missing:?}");
}

#[test]
fn every_sentence_of_the_documents_has_a_sample() {
    let samples = samples();
    let missing: Vec<&str> = SENTENCES
        .split_whitespace()
        .filter(|formatter| {
            !samples
                .iter()
                .any(|sample| decode(sample.line.as_bytes()).formatter == *formatter)
        })
        .collect();
    assert!(missing.is_empty(), "no sample of {missing:?}");
    assert_eq!(SENTENCES.split_whitespace().count(), 70);
}
