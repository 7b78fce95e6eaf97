//! What a walk through a message gives.

use super::field::Field;
use super::value::Value;

/// A field of a message.
#[derive(Clone, Copy, Debug)]
pub struct Entry<'m> {
    /// The list that it belongs to, and which of its entries, from 1; none and 0 outside.
    pub group: Option<&'static str>,
    /// Which entry of the list.
    pub entry: usize,
    /// Its value.
    pub value: Value<'m>,
    pub(super) field: &'static Field,
}

impl Entry<'_> {
    /// Its name, such as `speed_over_ground`.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.field.name
    }
    /// Its unit; none for a bare number.
    #[must_use]
    pub const fn unit(&self) -> Option<&'static str> {
        self.field.unit().name()
    }
    /// What it is.
    #[must_use]
    pub const fn note(&self) -> &'static str {
        self.field.note
    }
    /// What its value means.
    #[must_use]
    pub fn meaning(&self) -> Option<&'static str> {
        self.field.meaning(&self.value)
    }
}
