//! What is said of a sentence and its fields.

use super::decimal::Decimal;
use super::fault::{Fault, FaultKind};
use super::value::Date;
use alloc::vec::Vec;

/// A sentence explained.
#[derive(Clone, Debug)]
pub struct Explanation<'a> {
    /// What the sentence is; none where it is unknown.
    pub title: Option<&'static str>,
    /// The documents that define it.
    pub source: Option<&'static str>,
    /// Its fields in order.
    pub fields: Vec<Field<'a>>,
    /// Everything that is wrong.
    pub faults: Vec<Fault>,
}

/// A field explained.
#[derive(Clone, Debug)]
pub struct Field<'a> {
    /// Its number, from 1.
    pub n: usize,
    /// Its name.
    pub name: Name,
    /// What stands there.
    pub raw: &'a [u8],
    /// Its typed value.
    pub value: FieldValue<'a>,
    /// Its unit.
    pub unit: Option<&'static str>,
    /// What its code means.
    pub meaning: Option<&'static str>,
    /// What it is and what this interface does with it.
    pub note: &'static str,
    /// What is wrong with it.
    pub fault: Option<FaultKind>,
}

/// Value of one wire field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FieldValue<'a> {
    /// Empty, or faulty.
    None,
    /// A number in the sentence's own unit.
    Number(f64),
    /// A latitude or longitude in decimal degrees, north and east positive; as text to a millimetre.
    Degrees(f64),
    /// A whole number.
    Integer(i64),
    /// A letter.
    Letter(u8),
    /// A text with escapes.
    Text(&'a [u8]),
    /// A time of day, hhmmss and decimals of a second.
    Time(Decimal),
    /// A date.
    Date(Date),
}

/// What of a member a wire field holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Facet {
    Whole,
    Side,
    Unit,
    Latitude,
    LatitudeSide,
    Longitude,
    LongitudeSide,
}

/// Name of a wire field: its member, what of it, and the entry of the group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Name {
    pub(super) member: &'static str,
    pub(super) facet: Facet,
    pub(super) entry: usize,
}

impl Explanation<'_> {
    /// The field with that name, such as `heading_to_steer`.
    #[must_use]
    pub fn field(&self, name: &str) -> Option<&Field<'_>> {
        self.fields
            .iter()
            .find(|f| f.name.facet == Facet::Whole && f.name.member == name)
    }
}
