//! `wheelover decode` (CLI-2): explains the sentences of a file, as a table or as JSON lines.

use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, IsTerminal, Read, Write};
use std::path::Path;
use std::time::{Duration, Instant};
use wheelover_core::nmea::explain::{FieldValue, explain, json_line, latin1};
use wheelover_core::nmea::{Checksum, Frame, Framer, Sentence, decode as decode_line, hints};

/// Longest line of a file that is kept; the rest of a longer one is left out.
const LONGEST_LINE: u64 = 64 * 1024;

/// Explains every sentence of `path` (none or `-`: standard input) on standard output.
///
/// Gives the exit code: 0, or 1 where there was no valid sentence.
///
/// # Errors
/// The input cannot be read or the output cannot be written.
pub fn decode(path: Option<&Path>, json: bool, quiet: bool) -> io::Result<i32> {
    let stdout = io::stdout();
    let colour = stdout.is_terminal() && std::env::var_os("NO_COLOR").is_none();
    let mut out = BufWriter::with_capacity(1 << 16, stdout.lock());
    let outcome = match path.filter(|path| path.as_os_str() != "-") {
        Some(path) => {
            let file = File::open(path)?;
            let size = file.metadata().map(|m| m.len()).unwrap_or(0);
            run(
                BufReader::with_capacity(1 << 18, file),
                size,
                &mut out,
                Form {
                    json,
                    colour,
                    quiet,
                },
            )
        }
        None => run(
            io::stdin().lock(),
            0,
            &mut out,
            Form {
                json,
                colour,
                quiet,
            },
        ),
    };
    let flushed = outcome.and_then(|valid| out.flush().map(|()| valid));
    match flushed {
        Ok(valid) => Ok(i32::from(valid == 0)),
        // Whoever reads us has read enough.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(0),
        Err(error) => Err(error),
    }
}

#[derive(Clone, Copy)]
struct Form {
    json: bool,
    colour: bool,
    quiet: bool,
}

fn run(mut input: impl BufRead, size: u64, out: &mut dyn Write, form: Form) -> io::Result<u64> {
    let mut progress = Progress::new(size, form.quiet);
    let mut line = Vec::new();
    let (mut number, mut valid) = (0, 0);
    loop {
        line.clear();
        let read = (&mut input)
            .take(LONGEST_LINE)
            .read_until(b'\n', &mut line)?;
        if read == 0 {
            break;
        }
        if !line.ends_with(b"\n") {
            skip_line(&mut input)?;
        }
        number += 1;
        progress.advance(read, number);
        let (at, text) = time_of(trimmed(&line));
        let mut outcome = Ok(());
        each_sentence(text, &mut |text| {
            let sentence = decode_line(text);
            valid += u64::from(is_valid(&sentence));
            if outcome.is_ok() {
                outcome = if form.json {
                    writeln!(out, "{}", json_line(number, at, &sentence).text())
                } else {
                    table(out, number, at, &sentence, form.colour)
                };
            }
        });
        outcome?;
    }
    progress.end();
    Ok(valid)
}

/// Leaves out the rest of a line that is too long.
fn skip_line(input: &mut impl BufRead) -> io::Result<()> {
    loop {
        let buffer = input.fill_buf()?;
        let length = buffer.len();
        match buffer.iter().position(|&b| b == b'\n') {
            Some(end) => {
                input.consume(end + 1);
                return Ok(());
            }
            None if length == 0 => return Ok(()),
            None => input.consume(length),
        }
    }
}

fn trimmed(line: &[u8]) -> &[u8] {
    line.trim_ascii()
}

/// Takes the time off `12.250 < $EIHTC…` (CLI-3).
fn time_of(line: &[u8]) -> (Option<f64>, &[u8]) {
    let Some(space) = line.iter().position(|&b| b == b' ') else {
        return (None, line);
    };
    let time = std::str::from_utf8(&line[..space])
        .ok()
        .and_then(|t| t.parse::<f64>().ok());
    match (time, &line[space + 1..]) {
        (Some(time), [b'<' | b'>', b' ', rest @ ..]) if time.is_finite() => (Some(time), rest),
        _ => (None, line),
    }
}

/// The sentences of a line of a file; a line without a beginning is taken as it is.
fn each_sentence(line: &[u8], sink: &mut dyn FnMut(&[u8])) {
    if line.is_empty() {
        return;
    }
    if !line.iter().any(|b| matches!(b, b'$' | b'!')) {
        return sink(line);
    }
    let mut framer = Framer::new();
    let mut each = |frame: Frame<'_>| sink(frame.text);
    framer.push(line, &mut each);
    framer.flush(&mut each);
}

/// Whether a line counts as a sentence: right checksum, or none and nothing wrong with a known one.
fn is_valid(sentence: &Sentence<'_>) -> bool {
    match sentence.checksum {
        Checksum::Right(_) => !sentence.address.is_empty(),
        Checksum::Wrong { .. } => false,
        Checksum::Missing { .. } => sentence.known.is_some() && sentence.field_faults().is_empty(),
    }
}

const BOLD: &str = "\x1b[1m";
const DIM: &str = "\x1b[2m";
const RED: &str = "\x1b[31m";
const GREEN: &str = "\x1b[32m";
const YELLOW: &str = "\x1b[33m";
const PLAIN: &str = "\x1b[0m";

fn table(
    out: &mut dyn Write,
    number: u64,
    at: Option<f64>,
    sentence: &Sentence<'_>,
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
        safe(&format!("{} {}", sentence.talker, sentence.formatter)),
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
    writeln!(out)
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

/// How far a large file is read, on standard error where that is a terminal (CLI-5).
struct Progress {
    size: u64,
    done: u64,
    shown: Option<Instant>,
    on: bool,
}

impl Progress {
    fn new(size: u64, quiet: bool) -> Self {
        let on =
            !quiet && size > 1 << 20 && io::stderr().is_terminal() && !io::stdout().is_terminal();
        Self {
            size,
            done: 0,
            shown: None,
            on,
        }
    }

    fn advance(&mut self, bytes: usize, lines: u64) {
        self.done += bytes as u64;
        if !self.on || !lines.is_multiple_of(1024) {
            return;
        }
        let now = Instant::now();
        if self
            .shown
            .is_none_or(|shown| now - shown > Duration::from_millis(200))
        {
            self.shown = Some(now);
            let percent = self.done * 100 / self.size.max(1);
            let _ = write!(io::stderr(), "\r{percent:>3} %  {lines} lines");
        }
    }

    fn end(&self) {
        if self.shown.is_some() {
            let _ = write!(io::stderr(), "\r\x1b[K");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(input: &str, json: bool) -> (u64, String) {
        let mut out = Vec::new();
        let form = Form {
            json,
            colour: false,
            quiet: true,
        };
        let valid = run(input.as_bytes(), 0, &mut out, form).expect("memory can be written");
        (valid, String::from_utf8(out).expect("text"))
    }

    #[test]
    fn json_lines_carry_number_time_and_direction_prefix() {
        let (valid, out) = check("\n12.250 < $PEMC,00*37\r\n$PEMC,09*3E$PEMC,10*36\n", true);
        assert_eq!(valid, 3);
        let lines: Vec<&str> = out.lines().collect();
        assert_eq!(lines.len(), 3);
        assert!(
            lines[0].starts_with(r#"{"line":2,"at":12.25,"raw":"$PEMC,00*37","#),
            "{}",
            lines[0]
        );
        assert!(
            lines[2].starts_with(r#"{"line":3,"at":null,"#),
            "{}",
            lines[2]
        );
    }

    #[test]
    fn garbage_is_no_valid_sentence_and_cannot_colour_the_terminal() {
        let (valid, out) = check("\u{1b}[31mhello\n$EIHTC,V*00\n", false);
        assert_eq!(valid, 0);
        assert!(!out.contains('\u{1b}'), "{out}");
    }
}
