//! A text of many lines, pasted or from a file, explained: what it holds in words, what its dialogue breaks (CON-2), and its
//! lines as tables.
//!
//! This belongs to the dictionary's module, which holds the texts.

use crate::checked;
use crate::drawing::Drawing;
use crate::explained::article;
use crate::message;
use std::fmt::Write;
use wheelover_core::conformance::{Live, timed};
use wheelover_core::nmea::ais::Gatherer;
use wheelover_core::nmea::{decode, json_line};
use wheelover_core::time::Stamp;

/// So many lines of a text are explained from its beginning on, and so many of the later ones that have faults.
const SHOWN: u64 = 100;
/// A line that is longer is read in pieces, bytes.
const LONGEST: usize = 4_096;

/// A text of many lines that is read part by part, so that a large file neither freezes the page nor is cut.
#[derive(Debug)]
pub struct Text {
    /// What has come of the line that has not ended.
    begun: Vec<u8>,
    /// Whether the last line ended with a carriage return: a line feed after it belongs to the same end.
    returned: bool,
    /// Number of the line that has not ended, from 1 as an editor counts.
    number: u64,
    lines: u64,
    faulty: u64,
    explained: u64,
    faulty_later: u64,
    tables: Drawing,
    later: Drawing,
    gatherer: Gatherer,
    live: Live,
}

impl Default for Text {
    fn default() -> Self {
        Self {
            begun: Vec::new(),
            returned: false,
            number: 1,
            lines: 0,
            faulty: 0,
            explained: 0,
            faulty_later: 0,
            tables: Drawing::new(),
            later: Drawing::new(),
            gatherer: Gatherer::new(),
            live: Live::default(),
        }
    }
}

impl Text {
    /// Reads the next part.
    pub fn take(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            let belongs = byte == b'\n' && self.returned;
            self.returned = byte == b'\r';
            match byte {
                _ if belongs => {}
                b'\n' | b'\r' => self.end_line(),
                _ => {
                    // No line is so long: what never ends is read in pieces.
                    if self.begun.len() >= LONGEST {
                        self.line();
                    }
                    self.begun.push(byte);
                }
            }
        }
    }

    /// The text has ended.
    pub fn end(&mut self) {
        self.line();
        self.live.finish();
    }

    fn end_line(&mut self) {
        self.line();
        self.number += 1;
    }

    fn line(&mut self) {
        let begun = std::mem::take(&mut self.begun);
        let line = sentence(&begun);
        if !line.is_empty() {
            self.lines += 1;
            let parts = timed(&begun);
            self.live.take(self.number, parts.at, parts.text);
            let decoded = decode(line);
            let faulty = !decoded.faults().is_empty();
            self.faulty += u64::from(faulty);
            if self.explained < SHOWN {
                self.explained += 1;
                article(
                    &mut self.tables,
                    &json_line(self.number, None, &decoded),
                    None,
                );
                // One after the other, as fast as they were typed: no message waits too long for its rest.
                if let Some(complete) = self.gatherer.push(Stamp(0), &decoded) {
                    message::draw(&mut self.tables, &complete);
                }
            } else if faulty && self.faulty_later < SHOWN {
                self.faulty_later += 1;
                self.later
                    .element("h2", "", format_args!("line {}", self.number));
                article(
                    &mut self.later,
                    &json_line(self.number, None, &decoded),
                    None,
                );
            }
        }
        self.begun = begun;
        self.begun.clear();
    }

    /// What it holds so far, in words.
    #[must_use]
    pub fn words(&self) -> String {
        let faulty = self.faulty;
        let mut words = match self.lines {
            0 => return "no lines".to_owned(),
            1 => format!("1 line, {faulty} with faults"),
            lines => format!("{lines} lines, {faulty} with faults"),
        };
        if self.lines > self.explained {
            let _written = write!(words, "; the first {SHOWN} are explained");
        }
        if self.faulty_later > 0 {
            let _written = write!(words, ", and {} later with faults", self.faulty_later);
        }
        words
    }

    /// The lines that are explained, as tables.
    #[must_use]
    pub fn tables(&self) -> String {
        let mut all = Drawing::new();
        let found = self.live.found();
        if found.sentences > 0 {
            checked::draw(&mut all, &found);
        }
        let tables = self.tables.clone().markup();
        all.plain(&tables);
        if self.faulty_later > 0 {
            all.element("h2", "", "Further lines with faults");
            let later = self.later.clone().markup();
            all.plain(&later);
        }
        all.markup()
    }
}

/// The sentence of a line: what stands before its start (a time, a direction) is left away.
fn sentence(line: &[u8]) -> &[u8] {
    let line = line.trim_ascii();
    let start = line.iter().position(|byte| b"$!\\".contains(byte));
    line.get(start.unwrap_or(0)..).unwrap_or(line)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::heard::latin1;

    /// What a text holds, read in parts of a length.
    fn read(text: &str, part: usize) -> (String, String) {
        let mut reading = Text::default();
        for part in latin1(text).chunks(part) {
            reading.take(part);
        }
        reading.end();
        (reading.words(), reading.tables())
    }

    #[test]
    fn the_message_stands_under_the_line_that_completes_it() {
        let (_, text) = read("!AIVDM,1,1,,A,15RTgt0PAso;90TKcjM8h6g208CQ,0*4A", 7);
        assert!(text.contains("data-message=\"1\""), "{text}");
        assert!(text.contains("371798000") && text.contains("under way using engine"));
    }

    #[test]
    fn a_text_says_how_many_lines_have_faults_however_it_is_cut() {
        let good = "12.250 < $HEHDT,216.8,T*22\r\n";
        for part in [1, 2, 3, 29, 30, 31, 65_536] {
            let said = |text: &str| read(text, part).0;
            assert_eq!(said(" \n"), "no lines");
            assert_eq!(
                said("$EIHTC,V,,,T,R,,,,,245.0,T,C*00"),
                "1 line, 1 with faults"
            );
            assert_eq!(
                said(&good.repeat(101)),
                "101 lines, 0 with faults; the first 100 are explained"
            );
            assert_eq!(
                said("$HEHDT,216.8,T*22\r$HEHDT,216.8,T*22\n\n"),
                "2 lines, 0 with faults"
            );
        }
        let odd = read("<script>alert(1)</script>", 5).1;
        assert!(!odd.contains("<script"), "{odd}");
    }

    #[test]
    fn a_fault_far_behind_the_first_lines_is_found_and_explained() {
        let text = "$HEHDT,216.8,T*22\r\n".repeat(30_000) + "$HEHDT,216.8,T*23\r\n";
        let (words, tables) = read(&text, 4_096);
        assert_eq!(
            words,
            "30001 lines, 1 with faults; the first 100 are explained, and 1 later with faults"
        );
        assert!(tables.contains("line 30001") && tables.contains("should be 22"));
    }

    // CON-2
    #[test]
    fn the_dialogue_of_a_dropped_file_is_checked_and_what_is_none_is_not() {
        let recorded =
            "0.0 < $EIHTC,V,,,T,R,,,,,,,245.0,T,C*39\n1.0 < $EIHTC,V,,,T,N,,,,,,,245.0,T,C*25\n";
        for part in [1, 17, 4_096] {
            let (_, tables) = read(recorded, part);
            assert!(tables.contains("data-rule=\"TCS-1\""), "{tables}");
            assert!(tables.contains("1.0 s, line 2, situation 2"), "{tables}");
        }
        let (_, tables) = read("$HEHDT,216.8,T*22\n", 5);
        assert!(!tables.contains("dialogue-check"), "{tables}");
    }

    #[test]
    fn what_never_ends_is_read_in_pieces() {
        let (words, _) = read(&"x".repeat(10_000), 999);
        assert_eq!(words, "3 lines, 3 with faults");
    }
}
