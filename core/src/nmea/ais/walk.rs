//! The walk of a table beside the bits of a message.

use super::bits::Bits;
use super::fault::{MessageFault, MessageFaultKind};
use super::field::{Field, Item, Kind, Place};
use super::message::Entry;
use super::value::Value;
use alloc::vec::Vec;

/// The station is an auxiliary craft of a mother ship.
pub(super) const fn auxiliary(mmsi: u32) -> bool {
    mmsi / 10_000_000 == 98
}

pub(super) struct Walk<'w, 'm, F> {
    bits: &'m Bits,
    at: usize,
    group: Option<&'static str>,
    entry: usize,
    sink: &'w mut F,
    faults: &'w mut Vec<MessageFault>,
}

impl<'w, 'm, F: FnMut(Entry<'m>)> Walk<'w, 'm, F> {
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
            match item {
                Item::Field(field) => self.field(field),
                Item::Part(items) => self.items(items),
                Item::When(when, items) => {
                    let place = match when.place {
                        Place::List(bits) => begin + bits,
                        Place::Bit(at) => at,
                    };
                    if when.values >> self.bits.get(place, when.width) & 1 == 1 {
                        self.items(items);
                    }
                }
                Item::Longer(bits, items) => {
                    if self.bits.len() >= *bits {
                        self.items(items);
                    }
                }
                Item::Auxiliary(are, items) => {
                    if auxiliary(self.bits.get(8, 30)) == *are {
                        self.items(items);
                    }
                }
                Item::Each(name, most, width, items) => self.each(name, *most, *width, items),
            }
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

    #[inline]
    fn field(&mut self, field: &'static Field) {
        let value = if field.width > 0 && !self.bits.lacks(self.at, field.width) {
            let at = self.at;
            self.at += field.width;
            if matches!(field.kind, Kind::Spare) {
                return;
            }
            let (value, wrong) = field.read(self.bits, at);
            if wrong {
                self.out_of_range(field);
            }
            value
        } else {
            self.rest(field)
        };
        if !matches!(field.kind, Kind::Spare) {
            (self.sink)(Entry {
                group: self.group,
                entry: self.entry,
                value,
                field,
            });
        }
    }

    /// A field to the end, or one of which bits are missing.
    #[inline(never)]
    fn rest(&mut self, field: &'static Field) -> Value<'m> {
        let value = field.read_rest(self.bits, self.at);
        self.at = match field.kind {
            Kind::Binary(but) => self.at.max(self.bits.len().saturating_sub(but)),
            _ => self.at.max(self.bits.len()),
        };
        value
    }

    #[cold]
    fn out_of_range(&mut self, field: &'static Field) {
        self.faults.push(MessageFault {
            field: Some(field.name),
            kind: MessageFaultKind::OutOfRange,
        });
    }
}
