//! The walk of a table beside the bits of a message.

use super::bits::Bits;
use super::entry::Entry;
use super::fault::{MessageFault, MessageFaultKind};
use super::field::{Field, Item, Kind, NO_INDICATOR, Place, Scale, rate_of_turn};
use super::value::{SixBitText, Value};
use alloc::vec::Vec;

/// The station is an auxiliary craft of a mother ship.
pub(super) const fn auxiliary(mmsi: u32) -> bool {
    mmsi / 10_000_000 == 98
}

pub(super) struct Walk<'w, 'm, F: ?Sized> {
    bits: &'m Bits,
    at: usize,
    group: Option<&'static str>,
    entry: usize,
    sink: &'w mut F,
    faults: &'w mut Vec<MessageFault>,
}

impl<'w, 'm, F: FnMut(Entry<'m>) + ?Sized> Walk<'w, 'm, F> {
    pub(super) fn new(bits: &'m Bits, sink: &'w mut F, faults: &'w mut Vec<MessageFault>) -> Self {
        Self {
            bits,
            at: 0,
            group: None,
            entry: 0,
            sink,
            faults,
        }
    }

    pub(super) fn items(&mut self, items: &'static [Item]) {
        let begin = self.at;
        for item in items {
            // One decision for what an item is, and one place where values are given: a processor foresees few.
            let (field, value) = match item {
                Item::Field(
                    field @ Field {
                        kind: Kind::Whole(scale),
                        ..
                    },
                ) => {
                    let Some(at) = self.take(field) else { continue };
                    let raw = self.bits.get_scaled(at, field.width, scale.signed);
                    let value = if scale.holds(raw) {
                        Value::Integer(i64::from(raw + scale.plus))
                    } else {
                        self.strange(field, scale, raw)
                    };
                    (field, value)
                }
                Item::Field(
                    field @ Field {
                        kind: Kind::Number(scale),
                        ..
                    },
                ) => {
                    let Some(at) = self.take(field) else { continue };
                    let raw = self.bits.get_scaled(at, field.width, scale.signed);
                    let value = if scale.holds(raw) {
                        Value::Number(scale.value(raw))
                    } else {
                        self.strange(field, scale, raw)
                    };
                    (field, value)
                }
                Item::Field(
                    field @ Field {
                        kind: Kind::Code(none, _),
                        ..
                    },
                ) => {
                    let Some(at) = self.take(field) else { continue };
                    let raw = self.bits.get(at, field.width) as i32;
                    let value = if raw == *none {
                        Value::Null
                    } else {
                        Value::Integer(i64::from(raw))
                    };
                    (field, value)
                }
                Item::Field(
                    field @ Field {
                        kind: Kind::Flag, ..
                    },
                ) => {
                    let Some(at) = self.take(field) else { continue };
                    (field, Value::Flag(self.bits.get(at, 1) == 1))
                }
                Item::Field(
                    field @ Field {
                        kind: Kind::Text, ..
                    },
                ) => {
                    let Some(at) = self.take(field) else { continue };
                    let text = SixBitText::read(self.bits, at, field.width / 6);
                    (field, text.map_or(Value::Null, Value::Text))
                }
                Item::Field(
                    field @ Field {
                        kind: Kind::Turn, ..
                    },
                ) => {
                    let Some(at) = self.take(field) else { continue };
                    (field, turn(self.bits.get_signed(at, 8)))
                }
                Item::Field(
                    field @ Field {
                        kind: Kind::Spare | Kind::Binary(_),
                        ..
                    },
                ) => {
                    self.take(field);
                    continue;
                }
                Item::Part(items) => {
                    self.items(items);
                    continue;
                }
                Item::When(when, items) => {
                    let place = match when.place {
                        Place::List(bits) => begin + bits,
                        Place::Bit(at) => at,
                    };
                    if when.values >> self.bits.get(place, when.width) & 1 == 1 {
                        self.items(items);
                    }
                    continue;
                }
                Item::Longer(bits, items) => {
                    if self.bits.len() >= *bits {
                        self.items(items);
                    }
                    continue;
                }
                Item::Auxiliary(are, items) => {
                    if auxiliary(self.bits.get(8, 30)) == *are {
                        self.items(items);
                    }
                    continue;
                }
                Item::Each(name, most, width, items) => {
                    self.each(name, *most, *width, items);
                    continue;
                }
            };
            self.give(field, value);
        }
    }

    /// Where a field begins that is there with all its bits; another one is given as far as it is there.
    #[inline(always)]
    fn take(&mut self, field: &'static Field) -> Option<usize> {
        let at = self.at;
        if field.width > 0 && !self.bits.lacks(at, field.width) {
            self.at = at + field.width;
            Some(at)
        } else {
            self.rest(field);
            None
        }
    }

    fn each(&mut self, name: &'static str, most: usize, width: usize, items: &'static [Item]) {
        self.group = Some(name);
        for entry in 1..=most {
            // The spare bits of the last entry are often left out.
            let first = match items.first() {
                Some(Item::Field(field)) => field.width,
                _ => width,
            };
            if self.bits.lacks(self.at, first) {
                break;
            }
            // A slot filled up with zeros has no entries there.
            let half = width / 2;
            let zeros = self.bits.get(self.at, half) == 0
                && self.bits.get(self.at + half, width - half) == 0;
            if entry > 1 && zeros {
                self.at += width;
                continue;
            }
            self.entry = entry;
            self.items(items);
        }
        (self.group, self.entry) = (None, 0);
    }

    /// A coded value that does not mean itself.
    fn strange(&mut self, field: &'static Field, scale: &Scale, raw: i32) -> Value<'m> {
        strange(field, scale, raw, self.faults)
    }

    #[inline(always)]
    fn give(&mut self, field: &'static Field, value: Value<'m>) {
        (self.sink)(Entry {
            group: self.group,
            entry: self.entry,
            value,
            field,
        });
    }

    /// A field to the end, or one of which bits are missing.
    #[inline(never)]
    fn rest(&mut self, field: &'static Field) {
        let value = field.read_rest(self.bits, self.at);
        self.at = match field.kind {
            Kind::Binary(but) => self.at.max(self.bits.len().saturating_sub(but)),
            _ => self.at.max(self.bits.len()),
        };
        if !matches!(field.kind, Kind::Spare) {
            self.give(field, value);
        }
    }
}

/// A coded value that does not mean itself.
pub(super) fn strange<'m>(
    field: &'static Field,
    scale: &Scale,
    raw: i32,
    faults: &mut Vec<MessageFault>,
) -> Value<'m> {
    if raw == scale.top {
        return Value::AtLeast(scale.value(raw));
    }
    if raw != scale.none && raw != scale.none_too {
        faults.push(MessageFault {
            field: Some(field.name),
            kind: MessageFaultKind::OutOfRange,
        });
    }
    Value::Null
}

/// A coded rate of turn.
#[inline(always)]
pub(super) fn turn<'m>(raw: i32) -> Value<'m> {
    match raw {
        -128 => Value::Null,
        127 | -127 => Value::AtLeast(NO_INDICATOR * f64::from(raw.signum())),
        126 | -126 => Value::AtLeast(rate_of_turn(raw)),
        raw => Value::Number(rate_of_turn(raw)),
    }
}
