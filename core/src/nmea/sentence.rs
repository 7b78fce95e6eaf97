//! A decoded line: a sentence with its raw fields; values and faults are read from it by its table.
//!
//! **Invariant:** decoding never fails and never panics; nothing is allocated where nothing is wrong.

use super::checksum::Checksum;
use super::fault::{Fault, FaultKind};
use super::group::group_count;
use super::known::{Known, identify, text_of};
use super::read::{read, read_here};
use super::scan::{Cursor, FieldList, LONGEST_BODY};
use super::table::{Definition, Kind};
use super::tag::TagBlock;
use super::value::{Value, hex_byte, hex_digits};
use super::whole;
use alloc::vec::Vec;

/// A decoded line: its parts, borrowed from it.
#[derive(Clone, Debug)]
pub struct Sentence<'a> {
    /// The line, TAG block included, without CR LF.
    pub raw: &'a [u8],
    /// The sentence alone, from `$` or `!` on.
    pub text: &'a [u8],
    /// Its TAG block.
    pub tag: Option<TagBlock<'a>>,
    /// Its formatter, such as `HTC` or `PNEY,001`.
    pub formatter: &'a str,
    /// Its checksum.
    pub checksum: Checksum,
    /// Its entry in the dictionary.
    pub known: Option<&'static Definition>,
    /// Its raw fields, numbered from 1.
    pub fields: FieldList<'a>,
}

/// A member of a decoded sentence.
#[derive(Clone, Copy, Debug)]
pub struct Item<'a> {
    /// Number of its first field, from 1.
    pub field: usize,
    /// What it is.
    pub kind: &'static Kind,
    /// Which entry of the group, from 1; 0 outside.
    pub entry: usize,
    /// Index of the member within its list (members, group or tail).
    pub(crate) index: usize,
    /// Whether it stands behind the group.
    pub(crate) in_tail: bool,
    /// Its value.
    pub value: Value<'a>,
}

/// Decodes one line by that choice of the dictionary.
#[inline(always)]
pub(crate) fn decode_knowing<K: Known>(line: &[u8]) -> Sentence<'_> {
    let raw = trim(line);
    let (tag, text) = match raw {
        [b'\\', ..] => TagBlock::take(raw),
        _ => (None, raw),
    };
    let inside = match text {
        [b'$' | b'!', inside @ ..] => inside,
        _ => text,
    };
    let (body, given) = match inside {
        [body @ .., b'*', high, low] => (body, Some([*high, *low])),
        _ => match inside.iter().position(|&b| b == b'*') {
            Some(star) => (&inside[..star], Some([0; 2])),
            None => (inside, None),
        },
    };
    let (fields, computed) = match body.split_at_checked(LONGEST_BODY) {
        None => FieldList::scan(body),
        Some((start, rest)) => scan_long(start, rest),
    };
    let checksum = match given {
        Some(given) if given == hex_digits(computed) => Checksum::Right(computed),
        Some(given) => match hex_byte(&given) {
            Some(given) if given == computed => Checksum::Right(computed),
            given => Checksum::Wrong { given, computed },
        },
        None => Checksum::Missing { computed },
    };
    let (formatter, known) = identify::<K>(&fields);
    Sentence {
        raw,
        text,
        tag,
        formatter,
        checksum,
        known,
        fields,
    }
}

/// A body of which only the start is told apart.
#[cold]
#[inline(never)]
fn scan_long<'a>(start: &'a [u8], rest: &[u8]) -> (FieldList<'a>, u8) {
    let (fields, sum) = FieldList::scan(start);
    (fields, rest.iter().fold(sum, |sum, b| sum ^ b))
}

#[inline(always)]
fn trim(mut line: &[u8]) -> &[u8] {
    while let [rest @ .., b'\r' | b'\n' | b' ' | b'\t'] = line {
        line = rest;
    }
    while let [b' ' | b'\t' | b'\n' | b'\r', rest @ ..] = line {
        line = rest;
    }
    line
}

/// Where the line ends inside a member, its last field bears the faults.
#[cold]
#[inline(never)]
fn name_last(faults: &mut [Fault], before: usize, last: usize) {
    for fault in faults.iter_mut().skip(before) {
        fault.field = fault.field.map(|n| n.min(last as u8));
    }
}

impl<'a> Sentence<'a> {
    /// Its address, such as `EIHTC` or `PNEY`; empty where it cannot be read.
    #[must_use]
    pub fn address(&self) -> &'a str {
        text_of(self.fields.address())
    }

    /// Whether it begins as a sentence does (SEN-1); anything else is no sentence, whatever is in it.
    #[must_use]
    pub fn begins(&self) -> bool {
        matches!(self.text, [b'$' | b'!', ..])
    }

    /// Its talker; `P` for a proprietary sentence, empty where there is none.
    #[must_use]
    pub fn talker(&self) -> &'a str {
        let address = self.address();
        match address.split_at_checked(2) {
            _ if address.len() > 1 && address.starts_with('P') => &address[..1],
            Some((talker, formatter)) if formatter.len() == 3 => talker,
            _ => "",
        }
    }

    /// Visits every member with its value, and every fault of the fields.
    #[inline]
    pub fn walk(&self, item: impl FnMut(Item<'a>), faults: &mut Vec<Fault>) {
        self.walk_by(read_here, item, faults);
    }

    /// As [`Self::walk`], in one copy for all callers that are not pressed for time.
    pub(crate) fn visit(&self, item: &mut dyn FnMut(Item<'a>), faults: &mut Vec<Fault>) {
        self.walk_by(read, item, faults);
    }

    #[inline(always)]
    fn walk_by(
        &self,
        read: impl Fn(&Kind, &mut Cursor<'_, 'a>, &mut Vec<Fault>) -> Option<Value<'a>>,
        mut item: impl FnMut(Item<'a>),
        faults: &mut Vec<Fault>,
    ) {
        let Some(definition) = self.known else { return };
        let before = faults.len();
        let mut cursor = self.fields.cursor();
        if definition.first() > 0 {
            cursor.part();
        }
        let entries = match definition.group {
            None => 0,
            Some(_) => group_count(definition, &self.fields),
        };
        // The fixed members, each entry of the group, the tail.
        let (mut members, mut entry, mut in_tail) = (definition.members, 0, false);
        'line: loop {
            for (index, kind) in members.iter().enumerate() {
                let field = cursor.taken() + 1;
                let Some(value) = read(kind, &mut cursor, faults) else {
                    break 'line;
                };
                item(Item {
                    field,
                    kind,
                    entry,
                    index,
                    in_tail,
                    value,
                });
            }
            let Some(group) = &definition.group else {
                break;
            };
            if in_tail {
                break;
            }
            if entry < entries {
                (members, entry) = (group.members, entry + 1);
            } else {
                (members, entry, in_tail) = (definition.tail, 0, true);
            }
        }
        if faults.len() > before {
            name_last(faults, before, self.fields.len());
        }
    }

    /// Everything that is wrong: frame, number of fields, fields. Empty and free of cost where nothing is.
    #[must_use]
    pub fn faults(&self) -> Vec<Fault> {
        let mut faults = Vec::new();
        self.frame_faults(&mut faults);
        self.visit(&mut |_| (), &mut faults);
        faults
    }

    /// Faults of the fields alone: address, number, contents; without checksum and length.
    #[must_use]
    pub fn field_faults(&self) -> Vec<Fault> {
        let mut faults = self.faults();
        faults.retain(|fault| !fault.kind.of_frame());
        faults
    }

    /// Whether frame, checksum and every field are right.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.checksum.is_right() && self.faults().is_empty()
    }

    /// Whether this is a sentence of that formatter.
    #[must_use]
    pub fn is(&self, formatter: &str) -> bool {
        self.formatter == formatter
    }

    pub(crate) fn frame_faults(&self, faults: &mut Vec<Fault>) {
        let computed = self.checksum.computed();
        match self.checksum {
            Checksum::Right(_) => {}
            Checksum::Wrong { given, .. } => {
                faults.push(Fault::line(FaultKind::BadChecksum { given, computed }));
            }
            Checksum::Missing { .. } => {
                faults.push(Fault::line(FaultKind::MissingChecksum(computed)));
            }
        }
        // CR and LF count too (SEN-1).
        if self.text.len() + 2 > 82 {
            let length = u16::try_from(self.text.len() + 2).unwrap_or(u16::MAX);
            faults.push(Fault::line(FaultKind::TooLong(length)));
        }
        let address = self.address();
        let plain = address
            .bytes()
            .all(|b| b.is_ascii_uppercase() || b.is_ascii_digit());
        if address.is_empty() || !plain || self.talker().is_empty() {
            faults.push(Fault::line(FaultKind::BadAddress));
        }
        if let Some(definition) = self.known {
            whole::faults(definition, &self.fields, faults);
        }
    }
}
