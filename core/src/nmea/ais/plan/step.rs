//! What a plan is made of.

use crate::nmea::ais::field::{Field, Kind};

/// The most steps of a message; one with more has no plan.
pub(super) const STEPS: usize = 40;
/// No step.
pub(super) const END: u8 = u8::MAX;

/// What is done at a step.
#[derive(Clone, Copy)]
pub(super) enum Op {
    /// A whole number, or a code of which the least value may mean "not available".
    Whole,
    /// A code that means "not available" by a value among others.
    Code,
    /// A number in tenths.
    Tenths,
    /// An angle in 1/10000 minute.
    Fine,
    /// An angle in 1/10 minute.
    Coarse,
    Flag,
    Text,
    /// What goes to the end.
    Rest,
    Turn,
    /// Goes on where a field of at most three bits says.
    Switch,
    /// Goes on where the kind of craft says.
    Craft,
}

#[derive(Clone, Copy)]
pub(super) struct Step {
    pub(super) field: &'static Field,
    /// Where its bits begin: the byte, and the bit in it.
    pub(super) byte: u16,
    pub(super) bit: u8,
    /// How far its bits are from the end of a word of 64.
    pub(super) shift: u8,
    pub(super) op: Op,
    /// The step behind it.
    pub(super) next: u8,
    /// The bit of the sign; none of an unsigned number.
    pub(super) sign: u32,
    pub(super) low: i32,
    pub(super) span: u32,
    /// What is added to the coded value; of a code the value that means "not available".
    pub(super) more: i32,
}

impl Step {
    /// Where its bits begin.
    pub(super) const fn at(&self) -> usize {
        self.byte as usize * 8 + self.bit as usize
    }
    pub(super) const fn placed(mut self, at: usize) -> Self {
        self.byte = (at / 8) as u16;
        self.bit = (at % 8) as u8;
        self
    }
}

/// The steps of a message type.
#[derive(Clone, Copy)]
pub(in crate::nmea::ais) struct Plan {
    pub(super) steps: [Step; STEPS],
    /// Where a switch goes on, by the number of the switch and what it reads.
    pub(super) targets: [[u8; 8]; 2],
    pub(super) count: usize,
    pub(super) switches: usize,
    /// Bits that a message must have to be read by it.
    pub(super) bits: usize,
    pub(super) fits: bool,
}

static NOTHING: Field = Field {
    name: "",
    width: 1,
    kind: Kind::Spare,
    note: "",
};

pub(super) const FIRST: Step = Step {
    field: &NOTHING,
    byte: 0,
    bit: 0,
    shift: 0,
    op: Op::Flag,
    next: 0,
    sign: 0,
    low: 0,
    span: 0,
    more: 0,
};

impl Plan {
    pub(super) const EMPTY: Self = Self {
        steps: [FIRST; STEPS],
        targets: [[0; 8]; 2],
        count: 0,
        switches: 0,
        bits: 0,
        fits: true,
    };

    /// Where a switch goes on.
    #[inline(always)]
    pub(super) fn target(&self, step: &Step, value: usize) -> usize {
        usize::from(self.targets[step.low as usize & 1][value & 7])
    }
}
