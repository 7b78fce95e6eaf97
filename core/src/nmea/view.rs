//! How a typed view is read from a sentence: member by member, in the order of the table.

use super::encode::Cell;
use super::group::group_count;
use super::read::read;
use super::scan::Cursor;
use super::table::{Definition, Kind};
use super::value::{Date, UtcTime, Value};
use super::{FieldList, Sentence};
use crate::geo::Position;
use alloc::string::String;
use alloc::vec::Vec;

/// Walks the members of a sentence.
pub(crate) struct Reader<'s, 'a> {
    fields: &'s FieldList<'a>,
    cursor: Cursor<'s, 'a>,
    definition: &'static Definition,
    members: core::slice::Iter<'static, Kind>,
    in_tail: bool,
    faults: Vec<super::Fault>,
}

impl<'s, 'a> Reader<'s, 'a> {
    pub(crate) fn new(sentence: &'s Sentence<'a>, definition: &'static Definition) -> Option<Self> {
        if !core::ptr::eq(sentence.known?, definition) {
            return None;
        }
        Some(Self {
            fields: &sentence.fields,
            cursor: sentence.fields.cursor_at(definition.first()),
            definition,
            members: definition.members.iter(),
            in_tail: false,
            faults: Vec::new(),
        })
    }

    fn value(&mut self) -> Value<'a> {
        if self.members.len() == 0 && !self.in_tail {
            self.in_tail = true;
            self.members = self.definition.tail.iter();
        }
        let Some(kind) = self.members.next() else {
            return Value::Null;
        };
        read(kind, &mut self.cursor, &mut self.faults).unwrap_or(Value::Null)
    }

    /// The value of the next member.
    pub(crate) fn take<T: FromValue>(&mut self) -> T {
        T::from_value(self.value())
    }

    /// The entries of the group.
    pub(crate) fn entries<T>(&mut self, one: impl Fn(&mut Self) -> T) -> Vec<T> {
        let mut entries = Vec::new();
        if let Some(group) = &self.definition.group {
            for _ in 0..group_count(self.definition, self.fields) {
                self.members = group.members.iter();
                entries.push(one(self));
            }
        }
        self.members = self.definition.tail.iter();
        self.in_tail = true;
        entries
    }
}

/// A type that a value becomes in a view.
pub(crate) trait FromValue {
    /// Absent where the value is null or faulty.
    fn from_value(value: Value<'_>) -> Self;
}

/// A type that a view writes.
pub(crate) trait ToCell {
    /// What is written.
    fn to_cell(&self) -> Cell<'_>;
}

impl FromValue for Option<f64> {
    fn from_value(value: Value<'_>) -> Self {
        value.number()
    }
}
impl FromValue for Option<u32> {
    fn from_value(value: Value<'_>) -> Self {
        match value {
            Value::Number(number) if !number.negative() => u32::try_from(number.mantissa()).ok(),
            _ => None,
        }
    }
}
impl FromValue for Option<String> {
    fn from_value(value: Value<'_>) -> Self {
        value.text()
    }
}
impl FromValue for Option<Position> {
    fn from_value(value: Value<'_>) -> Self {
        value.position()
    }
}
impl FromValue for Option<UtcTime> {
    fn from_value(value: Value<'_>) -> Self {
        match value {
            Value::Time(time) => Some(UtcTime::from_wire(time)),
            _ => None,
        }
    }
}
impl FromValue for Option<Date> {
    fn from_value(value: Value<'_>) -> Self {
        match value {
            Value::Date(date) => Some(Date::from_wire(date)),
            _ => None,
        }
    }
}

impl ToCell for Option<f64> {
    fn to_cell(&self) -> Cell<'_> {
        self.map_or(Cell::Null, Cell::Float)
    }
}
impl ToCell for Option<u32> {
    fn to_cell(&self) -> Cell<'_> {
        self.map_or(Cell::Null, Cell::Integer)
    }
}
impl ToCell for Option<String> {
    fn to_cell(&self) -> Cell<'_> {
        self.as_deref().map_or(Cell::Null, Cell::Str)
    }
}
impl ToCell for Option<Position> {
    fn to_cell(&self) -> Cell<'_> {
        self.map_or(Cell::Null, Cell::Position)
    }
}
impl ToCell for Option<UtcTime> {
    fn to_cell(&self) -> Cell<'_> {
        self.map_or(Cell::Null, |time| Cell::Value(Value::Time(time.to_wire())))
    }
}
impl ToCell for Option<Date> {
    fn to_cell(&self) -> Cell<'_> {
        self.map_or(Cell::Null, |date| Cell::Value(Value::Date(date.to_wire())))
    }
}
