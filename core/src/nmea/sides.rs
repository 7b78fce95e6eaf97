//! The side of a magnitude, and how the reading of a field says what is wrong.

use super::fault::{Fault, FaultKind};
use super::scan::Field;
use super::table::Sides;
use super::value::Value;
use alloc::vec::Vec;

#[inline(always)]
pub(super) fn fault<'a>(faults: &mut Vec<Fault>, n: usize, kind: FaultKind) -> Value<'a> {
    note(faults, n, kind);
    Value::Invalid
}

#[cold]
#[inline(never)]
pub(super) fn note(faults: &mut Vec<Fault>, n: usize, kind: FaultKind) {
    faults.push(Fault::at(n - 1, kind));
}

/// Whether the side is the negative one; none where it is missing or unknown.
#[inline(always)]
pub(super) fn side(
    field: Field<'_>,
    sides: Sides,
    n: usize,
    faults: &mut Vec<Fault>,
) -> Option<bool> {
    let negative = which_side(field, sides);
    if negative.is_none() {
        wrong_side(field.is_empty(), n, faults);
    }
    negative
}

/// As [`side`], and nothing is said.
#[inline(always)]
pub(super) fn which_side(field: Field<'_>, sides: Sides) -> Option<bool> {
    // Without a branch, as it cannot be foreseen which side it is.
    let other = field.letter()? ^ sides.positive;
    let negative = other != 0;
    let right = other == (sides.positive ^ sides.negative) & 0u8.wrapping_sub(u8::from(negative));
    right.then_some(negative)
}

#[cold]
#[inline(never)]
fn wrong_side(empty: bool, n: usize, faults: &mut Vec<Fault>) {
    let kind = if empty {
        FaultKind::MissingPart
    } else {
        FaultKind::UnknownCode
    };
    note(faults, n, kind);
}
