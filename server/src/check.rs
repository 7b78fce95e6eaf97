//! `wheelover check` (CLI-3): the breaches of a recorded dialogue, as a list or as JSON lines.

use serde_json::json;
use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::path::Path;
use wheelover_core::conformance::{Breach, Checker, Span, timed};

/// Longest line that is looked at; the rest of a longer one is left out.
const LONGEST_LINE: u64 = 64 * 1024;

/// Checks the dialogue in `path` (`-`: standard input) and lists the breaches on standard output.
///
/// Gives the exit code: 0, or 1 where breaches were found.
///
/// # Errors
/// One line: the input cannot be read, holds no sentence of the dialogue, or the output cannot be written.
pub(crate) fn check(path: &Path, json: bool, quiet: bool) -> Result<i32, String> {
    let mut out = BufWriter::new(io::stdout().lock());
    let outcome = if path.as_os_str() == "-" {
        run(io::stdin().lock(), json, quiet, &mut out)
    } else {
        let name = |error: io::Error| format!("{}: {error}", path.display());
        let file = File::open(path).map_err(name)?;
        run(
            BufReader::with_capacity(1 << 18, file),
            json,
            quiet,
            &mut out,
        )
    };
    match outcome.and_then(|found| out.flush().map(|()| found)) {
        Ok(Some(found)) => Ok(i32::from(found)),
        Ok(None) => Err(format!(
            "{}: no sentence of the dialogue between chart system and autopilot",
            path.display()
        )),
        // Whoever reads us has read enough.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(1),
        Err(error) => Err(format!("{}: {error}", path.display())),
    }
}

/// Whether breaches were found; none where there was nothing to check.
fn run(
    mut input: impl BufRead,
    json: bool,
    quiet: bool,
    out: &mut impl Write,
) -> io::Result<Option<bool>> {
    let mut checker = Checker::new();
    let mut breaches = Vec::new();
    let mut line = Vec::new();
    let mut number = 0;
    while next_line(&mut input, &mut line)? {
        number += 1;
        let parts = timed(&line);
        if parts.text.is_empty() {
            continue;
        }
        checker.take(number, parts.at, parts.text, &mut breaches);
        for breach in breaches.drain(..) {
            write_breach(out, &breach, json)?;
        }
    }
    checker.finish(&mut breaches);
    for breach in breaches.drain(..) {
        write_breach(out, &breach, json)?;
    }
    if checker.sentences() == 0 {
        return Ok(None);
    }
    if json {
        let situations: Vec<_> = checker
            .spans()
            .iter()
            .map(|span| json!({"situation": span.situation, "from": span.from, "to": span.to}))
            .collect();
        let summary = json!({
            "lines": number,
            "breaches": checker.breaches(),
            "situations": situations,
        });
        writeln!(out, "{}", json!({ "summary": summary }))?;
    } else if !quiet {
        write_summary(out, number, &checker)?;
    }
    Ok(Some(checker.breaches() > 0))
}

/// Reads one line; false at the end.
fn next_line(input: &mut impl BufRead, line: &mut Vec<u8>) -> io::Result<bool> {
    line.clear();
    let read = input.by_ref().take(LONGEST_LINE).read_until(b'\n', line)?;
    let mut cut = read as u64 == LONGEST_LINE && line.last() != Some(&b'\n');
    while cut {
        let mut rest = Vec::new();
        let more = input
            .by_ref()
            .take(LONGEST_LINE)
            .read_until(b'\n', &mut rest)?;
        cut = more > 0 && rest.last() != Some(&b'\n');
    }
    Ok(read > 0)
}

fn write_breach(out: &mut impl Write, breach: &Breach, json: bool) -> io::Result<()> {
    if json {
        let object = json!({
            "at": breach.at,
            "line": breach.line,
            "rule": breach.rule,
            "situation": breach.situation,
            "text": breach.text,
        });
        return writeln!(out, "{object}");
    }
    if let Some(at) = breach.at {
        write!(out, "{at:.3} s, ")?;
    }
    write!(out, "line {}", breach.line)?;
    if let Some(situation) = breach.situation {
        write!(out, ", situation {situation}")?;
    }
    writeln!(out, ": {}: {}", breach.rule, breach.text)
}

fn write_summary(out: &mut impl Write, lines: u64, checker: &Checker) -> io::Result<()> {
    writeln!(out, "{lines} lines, {} breaches", checker.breaches())?;
    for Span {
        situation,
        from,
        to,
    } in checker.spans()
    {
        match (from, to) {
            (Some(from), Some(to)) => {
                writeln!(out, "situation {situation}: {from:.1} s to {to:.1} s")?;
            }
            _ => writeln!(out, "situation {situation}")?,
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use wheelover_core::nmea::with_checksum;

    fn checked(text: &str, json: bool) -> (Option<bool>, String) {
        let mut out = Vec::new();
        let found = run(text.as_bytes(), json, false, &mut out).unwrap();
        (found, String::from_utf8(out).unwrap())
    }

    // CLI-3
    #[test]
    fn a_breach_is_one_object_and_the_summary_the_last() {
        let text = format!(
            "0.000 < {}\n1.000 < {}\n",
            with_checksum("EIHTC,V,,,T,R,,,,,,,245.0,T,C"),
            with_checksum("EIHTC,V,,,T,N,,,,,,,245.0,T,C")
        );
        let (found, out) = checked(&text, true);
        assert_eq!(found, Some(true));
        let objects: Vec<serde_json::Value> = out
            .lines()
            .map(|line| serde_json::from_str(line).unwrap())
            .collect();
        let breach = objects.iter().find(|o| o["rule"] == "TCS-1").unwrap();
        assert_eq!((&breach["line"], &breach["at"]), (&json!(2), &json!(1.0)));
        assert_eq!(breach["situation"], json!(2));
        let summary = &objects.last().unwrap()["summary"];
        assert_eq!(summary["lines"], json!(2));
        assert_eq!(summary["breaches"], json!(objects.len() - 1));
        assert_eq!(
            summary["situations"],
            json!([{"situation": 2, "from": 0.0, "to": 1.0}])
        );
    }

    #[test]
    fn without_times_and_breaches_the_result_is_clean() {
        let (found, out) = checked(&with_checksum("EIHTC,V,,,S,N,,,,,,,,T,C"), false);
        assert_eq!(
            (found, out.as_str()),
            (Some(false), "1 lines, 0 breaches\nsituation 1\n")
        );
        let (found, out) = checked("", true);
        assert_eq!((found, out.as_str()), (None, ""));
    }
}
