//! FB14: what we encode, gpsd's decoder reads with the same values, to its last printed digit.
#![allow(clippy::unwrap_used)]

mod ais;
#[path = "../random.rs"]
mod random;
mod sentences;
mod values;

use serde_json::Value;
use std::io::Write;
use std::process::{Command, Stdio};
use wheelover_core::nmea::{JsonValue, decode, json_line};

/// Rounds of random values for each sentence.
const ROUNDS: usize = 25;

/// Makes gpsd 3.22 print what it holds; it prints at the end of a cycle, and this ends one.
const PRINT: &str = "$SDDBT,,f,12.5,M,,F*30";

/// Lines of our encoder, and what gpsd must print of them.
struct Case {
    /// What goes before, without which gpsd keeps its values to itself.
    before: Vec<String>,
    /// What our encoder made.
    lines: Vec<String>,
    /// What goes behind: it ends the cycle.
    after: Vec<String>,
    wants: Vec<Want>,
}

/// A value that gpsd must print.
struct Want {
    /// Class of its report.
    class: &'static str,
    /// Where in the report, as a JSON pointer.
    at: String,
    /// What must stand there.
    value: Expected,
}

enum Expected {
    /// A number, to half a unit of that many decimals.
    Number(f64, i32),
    /// A text or a truth value.
    Exact(Value),
}

impl Case {
    fn new(lines: Vec<String>) -> Self {
        Self {
            before: vec![PRINT.into()],
            lines,
            after: vec![PRINT.into()],
            wants: Vec::new(),
        }
    }
    fn number(mut self, class: &'static str, at: &str, value: f64, decimals: i32) -> Self {
        let value = Expected::Number(value, decimals);
        let at = at.to_string();
        self.wants.push(Want { class, at, value });
        self
    }
    fn exact(mut self, class: &'static str, at: &str, value: impl Into<Value>) -> Self {
        let value = Expected::Exact(value.into());
        let at = at.to_string();
        self.wants.push(Want { class, at, value });
        self
    }
    /// What our own decoder reads must be the value itself, and gpsd must print it times `factor`.
    fn both(
        self,
        class: &'static str,
        at: &str,
        (name, value, factor): (&str, f64, f64),
        decimals: i32,
    ) -> Self {
        let read = ours(self.lines.last().unwrap(), name);
        assert!((read - value).abs() < 1e-9, "{name} was {value}, is {read}");
        self.number(class, at, read * factor, decimals)
    }
}

/// What our own decoder reads from a line.
fn ours(line: &str, name: &str) -> f64 {
    let sentence = decode(line.as_bytes());
    assert!(sentence.is_clean(), "{line}: {:?}", sentence.faults());
    let json = json_line(1, None, &sentence);
    let field = json.fields.iter().find(|field| field.name == name);
    match field.map(|field| &field.value) {
        Some(JsonValue::Number(value)) => *value,
        Some(JsonValue::Integer(value)) => *value as f64,
        other => panic!("{line}: {name} is {other:?}"),
    }
}

/// The reports of gpsd's decoder for these lines.
fn gpsd(lines: &[String]) -> Vec<Value> {
    let started = Command::new("gpsdecode")
        .arg("-j")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn();
    let mut child = started.unwrap_or_else(|error| {
        panic!(
            "gpsdecode does not start ({error}): install gpsd's command-line tools, \
             the package gpsd-clients of Debian and Ubuntu, gpsd elsewhere"
        )
    });
    let mut input = child.stdin.take().unwrap();
    for line in lines {
        write!(input, "{line}\r\n").unwrap();
    }
    drop(input);
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "gpsdecode: {}", output.status);
    let text = String::from_utf8_lossy(&output.stdout);
    let report = |line| serde_json::from_str(line).unwrap_or_else(|e| panic!("{e}: {line}"));
    text.lines().map(report).collect()
}

/// Gives a case to gpsd and compares every value.
fn check(name: &str, case: &Case) {
    let mut stream = case.before.clone();
    stream.extend(case.lines.iter().cloned());
    stream.extend(case.after.iter().cloned());
    let reports = gpsd(&stream);
    for want in &case.wants {
        let of_class = reports
            .iter()
            .filter(|report| report["class"] == want.class);
        // A report holds what its sentence changed; the last one with the value counts.
        let found = of_class
            .filter_map(|report| report.pointer(&want.at))
            .next_back();
        let agrees = match (&want.value, found) {
            (Expected::Number(value, decimals), Some(found)) => {
                let half = 0.501 * 10f64.powi(-decimals);
                found
                    .as_f64()
                    .is_some_and(|found| (found - value).abs() <= half)
            }
            (Expected::Exact(value), Some(found)) => found == value,
            (_, None) => false,
        };
        let value = match &want.value {
            Expected::Number(value, _) => value.to_string(),
            Expected::Exact(value) => value.to_string(),
        };
        assert!(
            agrees,
            "{name}: {}{} is {found:?} for gpsd, {value} for us\n{:#?}\n{reports:#?}",
            want.class, want.at, stream
        );
    }
}

/// Random values of one kind, several times; the seed is printed.
fn rounds(name: &str, mut make: impl FnMut(&mut random::Random) -> Case) {
    let mut random = random::Random::seeded(name);
    for _ in 0..ROUNDS {
        check(name, &make(&mut random));
    }
}
