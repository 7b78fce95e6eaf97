//! A message of six-bit characters: its table walked beside its bits.

use super::bits::{Bits, NoArmour};
use super::entry::Entry;
use super::fault::{MessageFault, MessageFaultKind};
use super::field::Item;
use super::plan::plan;
use super::tables::{BINARY, HEADER, TEXT, UNSTRUCTURED, layout};
use super::value::Value;
use super::walk::Walk;
use alloc::vec::Vec;

/// A message of ITU-R M.1371, or a part of one, or one tracked target.
///
/// ```
/// use wheelover_core::nmea::ais::{RadioMessage, Value};
/// let message = RadioMessage::decode(b"15RTgt0PAso;90TKcjM8h6g208CQ", 0);
/// assert_eq!(message.kind(), Some(1));
/// assert_eq!(message.field("mmsi"), Value::Integer(371_798_000));
/// assert_eq!(message.field("speed_over_ground"), Value::Number(12.3));
/// assert!(message.faults().is_empty());
/// ```
#[derive(Clone, Debug)]
pub struct RadioMessage<'p> {
    payload: &'p [u8],
    fill_bits: u32,
    pub(super) bits: Bits,
    kind: Option<u8>,
    title: Option<&'static str>,
    items: [&'static [Item]; 2],
    fault: Option<MessageFaultKind>,
}

impl<'p> RadioMessage<'p> {
    /// The message of a VDM or VDO. Never fails: what is wrong is found in [`Self::faults`].
    #[must_use]
    #[inline]
    pub fn decode(payload: &'p [u8], fill_bits: u32) -> Self {
        let mut message = Self::new(payload, fill_bits);
        message.take();
        message
    }

    /// Reads what it was made of.
    #[inline(always)]
    pub(super) fn take(&mut self) {
        self.take_bits();
        self.take_type();
    }

    /// Finds the table of its type.
    fn take_type(&mut self) {
        if self.bits.is_empty() {
            self.fault.get_or_insert(MessageFaultKind::Empty);
            return;
        }
        let kind = self.bits.get(0, 6) as u8;
        self.kind = Some(kind);
        self.items[0] = HEADER;
        match layout(kind) {
            Some(layout) => self.lay_out(layout.title, layout.items, layout.least, layout.most),
            None => {
                _ = self
                    .fault
                    .get_or_insert(MessageFaultKind::UnknownType(kind))
            }
        }
    }

    /// What ABM or BBM gives an AIS unit to send as message `number`: the part behind the addresses.
    #[must_use]
    pub fn contents(number: u8, payload: &'p [u8], fill_bits: u32) -> Self {
        let mut message = Self::new(payload, fill_bits);
        message.take_bits();
        message.kind = Some(number);
        let longest = 968;
        match number {
            6 | 8 | 25 | 26 => message.lay_out("Binary data to be sent", BINARY, 16, longest),
            12 | 14 => message.lay_out("Safety-related text to be sent", TEXT, 6, longest),
            70 | 71 => message.lay_out("Unstructured data to be sent", UNSTRUCTURED, 1, longest),
            _ => {
                _ = message
                    .fault
                    .get_or_insert(MessageFaultKind::UnknownType(number))
            }
        }
        message
    }

    /// The target at the beginning of the data of a TTD.
    pub(super) fn target(payload: &'p [u8], layout: &'static super::Layout) -> Self {
        let mut message = Self::new(payload, 0);
        message.take_bits();
        message.lay_out(layout.title, layout.items, layout.least, layout.most);
        message
    }

    // It is made in its place: a whole one is not moved.
    #[inline(always)]
    pub(super) const fn new(payload: &'p [u8], fill_bits: u32) -> Self {
        Self {
            payload,
            fill_bits,
            bits: Bits::new(),
            kind: None,
            title: None,
            items: [&[], &[]],
            fault: None,
        }
    }

    fn take_bits(&mut self) {
        let (payload, fill_bits) = (self.payload, self.fill_bits);
        if let Some(NoArmour { at, byte }) = self.bits.fill(payload) {
            let place = at + 1;
            self.fault = Some(MessageFaultKind::BadCharacter { place, byte });
        } else if fill_bits > 5 {
            self.fault = Some(MessageFaultKind::BadFillBits(fill_bits));
        } else if payload.len() * 6 <= Bits::MOST {
            self.bits.drop_last(fill_bits as usize);
        }
    }

    fn lay_out(&mut self, title: &'static str, items: &'static [Item], least: usize, most: usize) {
        self.title = Some(title);
        self.items[1] = items;
        let found = match self.bits.len() {
            held if self.payload.len() * 6 <= Bits::MOST => held,
            _ => self.payload.len() * 6,
        };
        if found < least {
            self.fault
                .get_or_insert(MessageFaultKind::TooShort { found, least });
        } else if found > most {
            self.fault
                .get_or_insert(MessageFaultKind::TooLong { found, most });
        }
    }

    /// Number of the message; none where there is no bit.
    #[must_use]
    pub const fn kind(&self) -> Option<u8> {
        self.kind
    }
    /// What the message is; none where its type is unknown.
    #[must_use]
    pub const fn title(&self) -> Option<&'static str> {
        self.title
    }
    /// Its armoured characters as they came.
    #[must_use]
    pub const fn payload(&self) -> &'p [u8] {
        self.payload
    }
    /// Bits of the last character that do not count, as they were given.
    #[must_use]
    pub const fn fill_bits(&self) -> u32 {
        self.fill_bits
    }
    /// How many bits it has.
    #[must_use]
    pub const fn length(&self) -> usize {
        self.bits.len()
    }

    /// Who tells of a target of TTD: `radar`, or `ais` where there is a place for a reported heading.
    pub(super) fn source(&self) -> Option<&'static str> {
        self.entries()
            .iter()
            .find(|entry| entry.name() == "heading")?;
        // Behind version, number, bearing, speed and course.
        Some(if self.bits.get(48, 12) == 4095 {
            "radar"
        } else {
            "ais"
        })
    }

    /// Gives every field to `sink`, in the order of the message, and what is wrong to `faults`.
    #[inline]
    pub fn walk<'m>(&'m self, mut sink: impl FnMut(Entry<'m>), faults: &mut Vec<MessageFault>) {
        // What is no whole message, or a part of one, has no header.
        if self.fault.is_none()
            && let ([_, ..], Some(kind)) = (self.items[0], self.kind)
            && let Some(plan) = plan(kind, &self.bits)
        {
            plan.walk(&self.bits, &mut sink, faults);
        } else {
            self.walk_by(&mut sink, faults);
        }
    }

    /// As [`Self::walk`], in one copy for all callers that are not pressed for time.
    pub(super) fn visit<'m>(
        &'m self,
        sink: &mut dyn FnMut(Entry<'m>),
        faults: &mut Vec<MessageFault>,
    ) {
        self.walk_by(sink, faults);
    }

    #[inline]
    fn walk_by<'m, F: FnMut(Entry<'m>) + ?Sized>(
        &'m self,
        sink: &mut F,
        faults: &mut Vec<MessageFault>,
    ) {
        if let Some(kind) = self.fault {
            faults.push(MessageFault { field: None, kind });
        }
        let mut walk = Walk::new(&self.bits, sink, faults);
        walk.items(self.items[0]);
        walk.items(self.items[1]);
    }

    /// The value of the first field with that name; null where there is none.
    #[must_use]
    pub fn field(&self, name: &str) -> Value<'_> {
        let mut found = None;
        self.visit(
            &mut |entry| {
                if found.is_none() && entry.name() == name {
                    found = Some(entry.value);
                }
            },
            &mut Vec::new(),
        );
        found.unwrap_or(Value::Null)
    }

    /// All its fields.
    #[must_use]
    pub fn entries(&self) -> Vec<Entry<'_>> {
        let mut entries = Vec::with_capacity(32);
        self.visit(&mut |entry| entries.push(entry), &mut Vec::new());
        entries
    }

    /// Everything that is wrong.
    #[must_use]
    pub fn faults(&self) -> Vec<MessageFault> {
        let mut faults = Vec::new();
        self.visit(&mut |_| {}, &mut faults);
        faults
    }
}
