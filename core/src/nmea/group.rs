//! How often a group of members stands in a line.

use super::decimal::Decimal;
use super::scan::FieldList;
use super::table::{Definition, Repeat};

/// How many entries the group of a line has, as far as its fields go.
#[inline(never)]
pub(crate) fn group_count(definition: &Definition, fields: &FieldList<'_>) -> usize {
    let Some(group) = &definition.group else {
        return 0;
    };
    let rest = fields.len().saturating_sub(definition.fixed_width());
    let there = rest / group.width();
    match group.repeat {
        Repeat::Open => rest.div_ceil(group.width()),
        Repeat::UpTo(most) => there.min(usize::from(most)),
        Repeat::Counted(at) => {
            let said = Decimal::parse(fields.at(usize::from(at))).map_or(0, |d| d.value() as usize);
            said.min(there)
        }
    }
}
