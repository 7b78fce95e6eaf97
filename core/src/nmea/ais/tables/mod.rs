//! The message types in tables by subject.

/// A table, as it is written here.
macro_rules! items {
    ($($item:expr),* $(,)?) => { &[$($item),*] };
}

mod application;
mod management;
mod report;
mod statics;
mod targets;

use super::codes;
use super::field::{Field, Item, Kind, Layout, NEVER, Place, Scale, When};
use crate::nmea::table::Unit;

pub(super) use application::{BINARY, TEXT, UNSTRUCTURED};
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

/// What every message begins with.
pub(in crate::nmea) static HEADER: &[Item] = items! {
    number("type", 6, WHOLE, "Number of the message."),
    code("repeat_indicator", 2, NEVER, codes::repeat, "How often the message has been repeated."),
    number("mmsi", 30, MMSI, "Station that sends."),
};

const MAX: i32 = i32::MAX;
const WHOLE: Scale = Scale::new(1, 0, MAX, Unit::None);
const MMSI: Scale = Scale::new(1, 0, 999_999_999, Unit::None);
const SPEED: Scale = Scale::new(10, 0, 1022, Unit::Knots).none(1023).top();
const COURSE: Scale = Scale::new(10, 0, 3599, Unit::Degrees).none(3600);
const HEADING: Scale = Scale::new(1, 0, 359, Unit::Degrees).none(511);
/// Positions in 1/10000 minute.
const LONGITUDE: Scale =
    Scale::new(600_000, -108_000_000, 108_000_000, Unit::Degrees).none(108_600_000);
const LATITUDE: Scale =
    Scale::new(600_000, -54_000_000, 54_000_000, Unit::Degrees).none(54_600_000);
/// Positions in 1/10 minute.
const COARSE_LONGITUDE: Scale = Scale::new(600, -108_000, 108_000, Unit::Degrees).none(108_600);
const COARSE_LATITUDE: Scale = Scale::new(600, -54_000, 54_000, Unit::Degrees).none(54_600);
/// Length and breadth from the reference point.
const LONG: Scale = Scale::new(1, 0, 511, Unit::Metres).top();
const BROAD: Scale = Scale::new(1, 0, 63, Unit::Metres).top();
const MONTH: Scale = Scale::new(1, 1, 12, Unit::None).none(0);
const DAY: Scale = Scale::new(1, 1, 31, Unit::None).none(0);
const HOUR: Scale = Scale::new(1, 0, 23, Unit::None).none(24);
const MINUTE: Scale = Scale::new(1, 0, 59, Unit::None).none(60);

type Meaning = fn(u32) -> Option<&'static str>;

const fn field(name: &'static str, width: usize, kind: Kind, note: &'static str) -> Item {
    Item::Field(Field {
        name,
        width,
        kind,
        note,
    })
}
const fn number(name: &'static str, width: usize, scale: Scale, note: &'static str) -> Item {
    field(name, width, scale.kind(), note)
}
const fn whole(name: &'static str, width: usize, note: &'static str) -> Item {
    field(name, width, WHOLE.kind(), note)
}
const fn code(
    name: &'static str,
    width: usize,
    none: i32,
    meaning: Meaning,
    note: &'static str,
) -> Item {
    field(name, width, Kind::Code(none, meaning), note)
}
const fn flag(name: &'static str, note: &'static str) -> Item {
    field(name, 1, Kind::Flag, note)
}
const fn text(name: &'static str, characters: usize, note: &'static str) -> Item {
    field(name, characters * 6, Kind::Text, note)
}
const fn spare(width: usize) -> Item {
    field("", width, Kind::Spare, "Not used.")
}
/// Fields that depend on a field of `width` bits at a place.
const fn when(
    field: &'static str,
    place: Place,
    width: usize,
    values: u32,
    items: &'static [Item],
) -> Item {
    Item::When(
        When {
            field,
            place,
            width,
            values,
        },
        items,
    )
}

/// Position with its accuracy.
const POSITION: &[Item] = items! {
    code("position_accuracy", 1, NEVER, codes::accuracy, "Accuracy of the position."),
    number("longitude", 28, LONGITUDE, "Longitude, east positive."),
    number("latitude", 27, LATITUDE, "Latitude, north positive."),
};
const RAIM: Item = flag(
    "raim",
    "Receiver autonomous integrity monitoring is in use.",
);
const ASSIGNED: Item = flag(
    "assigned_mode",
    "Works in assigned mode, else autonomously and continuously.",
);
const FIXING: Item = code(
    "position_fixing_device",
    4,
    NEVER,
    codes::position_fixing,
    "Type of the electronic position-fixing device.",
);
const TIME_STAMP: Item = code(
    "time_stamp",
    6,
    60,
    codes::time_stamp,
    "UTC second of the report.",
);
const TERMINAL: Item = code(
    "data_terminal",
    1,
    NEVER,
    codes::terminal,
    "Data terminal equipment.",
);
const SHIP_TYPE: Item = code(
    "ship_type",
    8,
    0,
    codes::ship_type,
    "Type of ship and cargo.",
);
const DIMENSIONS: &[Item] = items! {
    number("to_bow", 9, LONG, "From the reference point of the position to the bow."),
    number("to_stern", 9, LONG, "From the reference point to the stern."),
    number("to_port", 6, BROAD, "From the reference point to the port side."),
    number("to_starboard", 6, BROAD, "From the reference point to the starboard side."),
};
/// Application identifier.
const APPLICATION: &[Item] = items! {
    whole("designated_area_code", 10, "Area whose authority defines the data; 1 is international."),
    whole("function_identifier", 6, "Which of its applications."),
};
const DATA: Item = field(
    "data",
    0,
    Kind::Binary(0),
    "Data of the application, not read here.",
);

/// Communication state of self-organised access.
const SOTDMA: &[Item] = items! {
    code("sync_state", 2, NEVER, codes::sync, "To what the station is synchronised."),
    whole("slot_timeout", 3, "Frames until a new slot is selected."),
    when("slot_timeout", Place::List(2), 3, 1 << 3 | 1 << 5 | 1 << 7, &[whole("received_stations", 14, "Stations received.")]),
    when("slot_timeout", Place::List(2), 3, 1 << 2 | 1 << 4 | 1 << 6, &[whole("slot_number", 14, "Slot used.")]),
    when("slot_timeout", Place::List(2), 3, 1 << 1, &[
        number("utc_hour", 5, HOUR, "UTC hour."),
        number("utc_minute", 7, MINUTE, "UTC minute."),
        spare(2),
    ]),
    when("slot_timeout", Place::List(2), 3, 1 << 0, &[whole("slot_offset", 14, "To the slot of the next frame.")]),
};
/// Communication state of incremental access.
const ITDMA: &[Item] = items! {
    code("sync_state", 2, NEVER, codes::sync, "To what the station is synchronised."),
    whole("slot_increment", 13, "To the next slot; 0: no more transmissions."),
    whole("number_of_slots", 3, "Consecutive slots."),
    flag("keep_slot", "The slot stays allocated for another frame."),
};
/// Either, as a flag before it says.
const SELECTED_STATE: &[Item] = items! {
    code("communication_state", 1, NEVER, codes::state_selector, "Access scheme of the state that follows."),
    when("communication_state", Place::List(0), 1, 1 << 0, SOTDMA),
    when("communication_state", Place::List(0), 1, 1 << 1, ITDMA),
};

#[cfg(test)]
mod tests {
    use super::*;

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
