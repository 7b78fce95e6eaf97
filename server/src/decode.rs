//! `wheelover decode` (CLI-2): explains the sentences of a file, as a table or as JSON lines.

mod table;

use self::table::table;
use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, IsTerminal, Read, Write};
use std::path::Path;
use std::time::{Duration, Instant};
use wheelover_core::nmea::ais::Gatherer;
use wheelover_core::nmea::{Checksum, Frame, Framer, Sentence, decode as decode_line, json_line};
use wheelover_core::time::Stamp;

/// Longest line of a file that is kept; the rest of a longer one is left out.
const LONGEST_LINE: u64 = 64 * 1024;

/// Explains every sentence of `path` (none or `-`: standard input) on standard output.
///
/// Gives the exit code: 0, or 1 where there was no valid sentence.
///
/// # Errors
/// The input cannot be read or the output cannot be written.
pub(crate) fn decode(path: Option<&Path>, json: bool, quiet: bool) -> io::Result<i32> {
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
    let mut gatherer = Gatherer::new();
    let mut now = Stamp(0);
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
            if let Some(at) = at.or_else(|| sentence.tag.and_then(|tag| tag.time())) {
                now = Stamp((at * 1000.0) as u64);
            }
            let message = gatherer.push(now, &sentence);
            if outcome.is_ok() {
                outcome = match (form.json, &message) {
                    (true, Some(message)) => {
                        let line = json_line(number, at, &sentence);
                        writeln!(out, "{}", line.text_with(message))
                    }
                    (true, None) => writeln!(out, "{}", json_line(number, at, &sentence).text()),
                    (false, message) => {
                        table(out, number, at, &sentence, message.as_ref(), form.colour)
                    }
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
        Checksum::Right(_) => !sentence.address().is_empty(),
        Checksum::Wrong { .. } => false,
        Checksum::Missing { .. } => sentence.known.is_some() && sentence.field_faults().is_empty(),
    }
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

    // CLI-2
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
    fn the_last_line_of_a_message_tells_what_is_in_it() {
        let parts = "!AIVDM,2,1,1,A,55?MbV02;H;s<HtKR20EHE:0@T4@Dn2222222216L961O5Gf0NSQEp6ClRp8,0*1C\n\
            $HEHDT,216.8,T*22\n!AIVDM,2,2,1,A,88888888880,2*25\n";
        let (_, out) = check(parts, true);
        let lines: Vec<&str> = out.lines().collect();
        assert!(!lines[0].contains("\"message\"") && !lines[1].contains("\"message\""));
        let start = r#""message":{"type":5,"repeat_indicator":0,"#;
        assert!(lines[2].contains(start), "{}", lines[2]);
        assert!(lines[2].contains(r#""name":"EVER DIADEM""#), "{}", lines[2]);
        let (_, out) = check(parts, false);
        assert_eq!(out.matches("EVER DIADEM").count(), 1, "{out}");
        assert!(
            out.contains("message 5  Static and voyage-related data"),
            "{out}"
        );
        // A part that is too old is not joined.
        let timed = |second: &str| {
            parts
                .replace("!AIVDM,2,1", "1.5 < !AIVDM,2,1")
                .replace("!AIVDM,2,2", second)
        };
        assert!(
            check(&timed("2.5 < !AIVDM,2,2"), true)
                .1
                .contains("\"message\"")
        );
        assert!(
            !check(&timed("20.5 < !AIVDM,2,2"), true)
                .1
                .contains("\"message\"")
        );
    }

    #[test]
    fn garbage_is_no_valid_sentence_and_cannot_colour_the_terminal() {
        let (valid, out) = check("\u{1b}[31mhello\n$EIHTC,V*00\n", false);
        assert_eq!(valid, 0);
        assert!(!out.contains('\u{1b}'), "{out}");
    }
}
