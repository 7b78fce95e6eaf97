//! The message types in tables by subject.

mod application;
mod common;
mod management;
mod report;
mod statics;
mod targets;

use super::field::Layout;

pub(super) use application::{BINARY, TEXT, UNSTRUCTURED};
pub(in crate::nmea) use common::HEADER;
pub(in crate::nmea) use targets::{APPROACH, TARGET};

/// All message types in the order of their numbers.
pub(in crate::nmea) fn layouts() -> impl Iterator<Item = &'static Layout> {
    LAYOUTS.iter().copied().flatten()
}

/// The table of a message type.
pub(super) fn layout(kind: u8) -> Option<&'static Layout> {
    LAYOUTS.get(usize::from(kind)).copied().flatten()
}

pub(super) const KINDS: usize = 28;

pub(super) static LAYOUTS: [Option<&Layout>; KINDS] = {
    let lists: [&[Layout]; 4] = [
        report::LAYOUTS,
        statics::LAYOUTS,
        application::LAYOUTS,
        management::LAYOUTS,
    ];
    let mut all = [None; KINDS];
    let mut list = 0;
    while list < lists.len() {
        let mut n = 0;
        while n < lists[list].len() {
            all[lists[list][n].kind as usize] = Some(&lists[list][n]);
            n += 1;
        }
        list += 1;
    }
    all
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nmea::ais::field::{Item, Kind, Scale};

    fn bits(items: &[Item]) -> usize {
        items
            .iter()
            .map(|item| match item {
                Item::Field(field) => field.width,
                Item::Part(items) => bits(items),
                // One of several: they are as long as each other.
                Item::When(when, items) if when.values & 1 == 1 => bits(items),
                Item::Auxiliary(true, items) => bits(items),
                _ => 0,
            })
            .sum()
    }

    fn scales(items: &[Item], check: &mut dyn FnMut(&str, &Scale)) {
        for item in items {
            match item {
                Item::Field(field) => {
                    if let Kind::Whole(scale) | Kind::Number(scale) = &field.kind {
                        check(field.name, scale);
                    }
                }
                Item::Part(items)
                | Item::When(_, items)
                | Item::Longer(_, items)
                | Item::Auxiliary(_, items)
                | Item::Each(_, _, _, items) => scales(items, check),
            }
        }
    }

    #[test]
    fn what_is_not_available_lies_outside_the_range() {
        let mut check = |name: &str, scale: &Scale| {
            for none in [scale.none, scale.none_too] {
                assert!(!(scale.low..=scale.high).contains(&none), "{name}");
            }
        };
        for layout in layouts().chain([&TARGET, &APPROACH]) {
            scales(layout.items, &mut check);
        }
        scales(HEADER, &mut check);
    }

    #[test]
    fn fixed_messages_have_the_lengths_of_the_recommendation() {
        let lengths = [
            (1, 168),
            (2, 168),
            (3, 168),
            (4, 168),
            (5, 424),
            (6, 88),
            (8, 56),
            (9, 168),
            (10, 72),
            (11, 168),
            (18, 168),
            (19, 312),
            (22, 168),
            (23, 160),
            (27, 96),
        ];
        for (kind, length) in lengths {
            let layout = layout(kind).unwrap();
            assert_eq!(bits(HEADER) + bits(layout.items), length, "message {kind}");
            assert_eq!(layout.least, length, "message {kind}");
        }
        assert_eq!((bits(TARGET.items), bits(APPROACH.items)), (90, 42));
        assert_eq!(layouts().count(), 27);
    }
}
