//! What the program says on standard error while it runs: one line each, foreign text escaped (FE15).
//!
//! **Invariant:** whoever logs never waits. A reader of standard error that stops reading loses lines, not the
//! steering.

use std::fmt::{self, Write as _};
use std::io::Write as _;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread::JoinHandle;
use tracing::{Event, Level, Subscriber};
use tracing_subscriber::fmt::format::Writer;
use tracing_subscriber::fmt::{FmtContext, FormatEvent, FormatFields, MakeWriter};
use tracing_subscriber::registry::LookupSpan;

/// Lines that may wait for the reader.
const QUEUE: usize = 256;

/// Logging, until this value is dropped.
#[derive(Debug)]
pub(crate) struct Log {
    lines: Option<SyncSender<Vec<u8>>>,
    writer: Option<JoinHandle<()>>,
}

impl Log {
    /// Begins to log; with `quiet` errors only.
    ///
    /// # Errors
    /// The system gives no thread.
    pub(crate) fn begin(quiet: bool) -> std::io::Result<Self> {
        let (lines, waiting) = sync_channel(QUEUE);
        let writer = std::thread::Builder::new()
            .name("log".to_owned())
            .spawn(move || write(&waiting))?;
        let level = if quiet { Level::ERROR } else { Level::INFO };
        let subscriber = tracing_subscriber::fmt()
            .with_max_level(level)
            .event_format(Plain)
            .with_writer(Lines(lines.clone()))
            .finish();
        // A second log in one process has the first one's reader.
        let _ = tracing::subscriber::set_global_default(subscriber);
        Ok(Self {
            lines: Some(lines),
            writer: Some(writer),
        })
    }

    /// Waits until what was logged is written, at most for as long as `patience`.
    pub(crate) fn end(mut self, patience: std::time::Duration) {
        let end = std::time::Instant::now() + patience;
        // An empty line is the end: the subscriber keeps its own way to the writer for ever.
        if let Some(lines) = self.lines.take() {
            let _ = lines.try_send(Vec::new());
        }
        let Some(writer) = self.writer.take() else {
            return;
        };
        while !writer.is_finished() && std::time::Instant::now() < end {
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
    }
}

fn write(lines: &Receiver<Vec<u8>>) {
    while let Ok(line) = lines.recv() {
        if line.is_empty() {
            return;
        }
        let _ = std::io::stderr().write_all(&line);
    }
}

/// `caution: …`: the level in an officer's words, then what is said.
struct Plain;

impl<S, N> FormatEvent<S, N> for Plain
where
    S: Subscriber + for<'a> LookupSpan<'a>,
    N: for<'a> FormatFields<'a> + 'static,
{
    fn format_event(
        &self,
        context: &FmtContext<'_, S, N>,
        mut out: Writer<'_>,
        event: &Event<'_>,
    ) -> fmt::Result {
        let mut text = String::new();
        context.format_fields(Writer::new(&mut text), event)?;
        let level = match *event.metadata().level() {
            Level::ERROR => "error",
            Level::WARN => "caution",
            _ => "note",
        };
        writeln!(out, "{level}: {}", escaped(&text))
    }
}

/// Text in which nothing moves a cursor, changes a colour or begins a line.
pub(crate) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        // Marks that turn the direction of writing can make a line say something else.
        let turns = matches!(letter, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
        if letter.is_control() || turns {
            // Writing to a string cannot fail.
            let _ = write!(out, "{}", letter.escape_unicode());
        } else {
            out.push(letter);
        }
    }
    out
}

/// Makes a line of what is written, and gives it to the writer if there is room.
struct Lines(SyncSender<Vec<u8>>);

impl<'a> MakeWriter<'a> for Lines {
    type Writer = Ink<'a>;

    fn make_writer(&'a self) -> Ink<'a> {
        Ink(&self.0)
    }
}

/// One write is one line.
struct Ink<'a>(&'a SyncSender<Vec<u8>>);

impl std::io::Write for Ink<'_> {
    fn write(&mut self, line: &[u8]) -> std::io::Result<usize> {
        if !line.is_empty() {
            let _ = self.0.try_send(line.to_vec());
        }
        Ok(line.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is logged by `say`, at most four lines.
    fn logged(level: Level, say: impl FnOnce()) -> Vec<String> {
        let (lines, waiting) = sync_channel(4);
        let subscriber = tracing_subscriber::fmt()
            .with_max_level(level)
            .event_format(Plain)
            .with_writer(Lines(lines))
            .finish();
        tracing::subscriber::with_default(subscriber, say);
        let text = |line: Vec<u8>| String::from_utf8(line).unwrap();
        waiting.try_iter().map(text).collect()
    }

    // FE15
    #[test]
    fn a_name_with_escapes_is_one_plain_line() {
        let name = "\u{1b}[2J\u{1b}]0;x\u{7}WP\r\nerror: forged\u{202e}";
        let said = logged(Level::INFO, || tracing::warn!("{name}: gone"));
        let [line] = said.as_slice() else {
            panic!("{said:?}");
        };
        let line = line.strip_suffix('\n').unwrap();
        assert!(
            !line.contains(|letter: char| letter.is_control()),
            "{line:?}"
        );
        assert!(line.starts_with("caution: \\"), "{line}");
        assert!(line.ends_with("error: forged\\u{202e}: gone"), "{line}");
    }

    #[test]
    fn levels_have_an_officers_words_and_quiet_leaves_errors() {
        let all = || {
            tracing::error!("a");
            tracing::warn!("b");
            tracing::info!("c");
            tracing::debug!("d");
        };
        assert_eq!(
            logged(Level::INFO, all),
            ["error: a\n", "caution: b\n", "note: c\n"]
        );
        assert_eq!(logged(Level::ERROR, all), ["error: a\n"]);
    }

    #[test]
    fn a_reader_that_stopped_holds_nobody_up() {
        let said = logged(Level::INFO, || {
            for number in 0..10_000 {
                tracing::info!(number);
            }
        });
        assert_eq!(said.len(), 4);
    }
}
