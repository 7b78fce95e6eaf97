//! The walk of a table beside the bits of a message.

use super::bits::Bits;
use super::fault::{MessageFault, MessageFaultKind};
use super::field::{Field, Item, Kind, NO_INDICATOR, Place, Scale, rate_of_turn};
use super::message::Entry;
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
                Item::Field(field) if !self.whole(field) => {
                    self.rest(field);
                    continue;
                }
                Item::Field(field @ Field { kind, width, .. }) => {
                    let at = self.at;
                    self.at = at + width;
                    let value = match kind {
                        Kind::Number(scale) => self.number(field, scale, at),
                        Kind::Code(none, _) => match self.bits.get(at, *width) as i32 {
                            raw if raw == *none => Value::Null,
                            raw => Value::Integer(i64::from(raw)),
                        },
                        Kind::Flag => Value::Flag(self.bits.get(at, 1) == 1),
                        Kind::Text => SixBitText::read(self.bits, at, width / 6)
                            .map_or(Value::Null, Value::Text),
                        Kind::Turn => turn(self.bits.get_signed(at, 8)),
                        Kind::Binary(_) => Value::Null,
                        Kind::Spare => continue,
                    };
                    (field, value)
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

    /// Whether all bits of a field are there.
    #[inline(always)]
    const fn whole(&self, field: &Field) -> bool {
        field.width > 0 && !self.bits.lacks(self.at, field.width)
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

    #[inline(always)]
    fn number(&mut self, field: &'static Field, scale: &Scale, at: usize) -> Value<'m> {
        let raw = if scale.signed {
            self.bits.get_signed(at, field.width)
        } else {
            self.bits.get(at, field.width) as i32
        };
        if raw == scale.none || raw == scale.none_too {
            Value::Null
        } else if raw == scale.top {
            Value::AtLeast(scale.value(raw))
        } else if raw < scale.low || raw > scale.high {
            self.out_of_range(field);
            Value::Null
        } else if scale.divisor == 1 {
            Value::Integer(i64::from(raw + scale.plus))
        } else {
            Value::Number(scale.value(raw))
        }
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

    #[cold]
    fn out_of_range(&mut self, field: &'static Field) {
        self.faults.push(MessageFault {
            field: Some(field.name),
            kind: MessageFaultKind::OutOfRange,
        });
    }
}

/// A coded rate of turn.
#[inline(always)]
fn turn<'m>(raw: i32) -> Value<'m> {
    match raw {
        -128 => Value::Null,
        127 | -127 => Value::AtLeast(NO_INDICATOR * f64::from(raw.signum())),
        126 | -126 => Value::AtLeast(rate_of_turn(raw)),
        raw => Value::Number(rate_of_turn(raw)),
    }
}
