//! The readable table of `wheelover decode`.

use std::io::{self, Write};
use wheelover_core::nmea::ais::{Gathered, Value};
use wheelover_core::nmea::explain::{FieldValue, explain, latin1};
use wheelover_core::nmea::{Checksum, Sentence, hints};

const BOLD: &str = "\x1b[1m";
const DIM: &str = "\x1b[2m";
const RED: &str = "\x1b[31m";
const GREEN: &str = "\x1b[32m";
const YELLOW: &str = "\x1b[33m";
const PLAIN: &str = "\x1b[0m";

/// Prints a line, its fields and the message that it completes.
pub(super) fn table(
    out: &mut dyn Write,
    number: u64,
    at: Option<f64>,
    sentence: &Sentence<'_>,
    message: Option<&Gathered<'_>>,
    colour: bool,
) -> io::Result<()> {
    let paint = |code: &'static str| if colour { code } else { "" };
    let explanation = explain(sentence);
    let (sum, sum_text) = match sentence.checksum {
        Checksum::Right(sum) => (GREEN, format!("checksum {sum:02X} right")),
        Checksum::Wrong { computed, .. } => {
            (RED, format!("checksum wrong, should be {computed:02X}"))
        }
        Checksum::Missing { computed } => {
            (YELLOW, format!("no checksum, should be {computed:02X}"))
        }
    };
    writeln!(
        out,
        "{}{number:>6}  {}{}",
        paint(DIM),
        safe(&latin1(sentence.raw)),
        paint(PLAIN)
    )?;
    let at = at.or_else(|| sentence.tag.and_then(|tag| tag.time()));
    writeln!(
        out,
        "        {}{}{}  {}  {}{sum_text}{}{}",
        paint(BOLD),
        safe(&format!("{} {}", sentence.talker(), sentence.formatter)),
        paint(PLAIN),
        explanation.title.unwrap_or("unknown sentence"),
        paint(sum),
        paint(PLAIN),
        at.map(|at| format!("  at {at} s")).unwrap_or_default(),
    )?;
    for field in &explanation.fields {
        let value = match (&field.value, field.raw) {
            (_, []) => "–".into(),
            (FieldValue::None, raw) => latin1(raw),
            (value, _) => value.to_string(),
        };
        let unit = field.unit.filter(|_| !field.raw.is_empty()).unwrap_or("");
        let name = field.name.to_string();
        write!(
            out,
            "    {:>4}  {name:<28} {:>12} {unit:<8}",
            field.n,
            safe(&value)
        )?;
        match (&field.fault, field.meaning) {
            (Some(fault), _) => writeln!(out, " {}{fault}{}", paint(RED), paint(PLAIN))?,
            (None, Some(meaning)) => writeln!(out, " {meaning}")?,
            (None, None) => writeln!(out)?,
        }
    }
    for fault in explanation
        .faults
        .iter()
        .filter(|fault| fault.field.is_none())
    {
        writeln!(
            out,
            "          {}fault: {fault}{}",
            paint(RED),
            paint(PLAIN)
        )?;
    }
    for hint in hints(sentence) {
        writeln!(
            out,
            "          {}hint: {}{}",
            paint(YELLOW),
            safe(&hint),
            paint(PLAIN)
        )?;
    }
    if let Some(message) = message {
        message_table(out, message, paint)?;
    }
    writeln!(out)
}

/// The message that a line completes (CLI-2).
fn message_table(
    out: &mut dyn Write,
    gathered: &Gathered<'_>,
    paint: impl Fn(&'static str) -> &'static str,
) -> io::Result<()> {
    let (messages, mut faults) = gathered.messages();
    for message in &messages {
        let title = message.title().unwrap_or("unknown message");
        let kind = message.kind().map(|kind| format!("message {kind}  "));
        writeln!(
            out,
            "        {}{}{}{title}",
            paint(BOLD),
            kind.unwrap_or_default(),
            paint(PLAIN)
        )?;
        for entry in message.entries() {
            let name = match entry.entry {
                0 => entry.name().into(),
                n => format!("{}_{n}", entry.name()),
            };
            let value = match entry.value {
                Value::Null => "–".into(),
                value => value.to_string(),
            };
            let unit = entry.unit().filter(|_| entry.value != Value::Null);
            let meaning = entry.meaning().unwrap_or("");
            let unit = unit.unwrap_or("");
            let line = format!("          {name:<28} {value:>12} {unit:<8} {meaning}");
            writeln!(out, "{}", line.trim_end())?;
        }
        faults.extend(message.faults());
    }
    for fault in faults {
        writeln!(
            out,
            "          {}fault: {fault}{}",
            paint(RED),
            paint(PLAIN)
        )?;
    }
    Ok(())
}

/// Control characters cannot reach the terminal.
fn safe(text: &str) -> String {
    text.chars()
        .flat_map(|c| {
            if c.is_control() {
                c.escape_default().collect()
            } else {
                vec![c]
            }
        })
        .collect()
}
