//! What the tables share: how a field is written, scales, and lists that stand in several messages.

pub(super) use crate::nmea::ais::codes;
pub(super) use crate::nmea::ais::field::{Field, Item, Kind, Layout, NEVER, Place, Scale, When};
pub(super) use crate::nmea::table::Unit;

/// A table, as it is written here.
macro_rules! items {
    ($($item:expr),* $(,)?) => { &[$($item),*] };
}
pub(super) use items;

/// What every message begins with.
pub(in crate::nmea) static HEADER: &[Item] = items! {
    number("type", 6, WHOLE, "Number of the message."),
    code("repeat_indicator", 2, NEVER, codes::repeat, "How often the message has been repeated."),
    number("mmsi", 30, MMSI, "Station that sends."),
};

pub(super) const MAX: i32 = i32::MAX;
pub(super) const WHOLE: Scale = Scale::new(1, 0, MAX, Unit::None);
pub(super) const MMSI: Scale = Scale::new(1, 0, 999_999_999, Unit::None);
pub(super) const SPEED: Scale = Scale::new(10, 0, 1022, Unit::Knots).none(1023).top();
pub(super) const COURSE: Scale = Scale::new(10, 0, 3599, Unit::Degrees).none(3600);
pub(super) const HEADING: Scale = Scale::new(1, 0, 359, Unit::Degrees).none(511);
/// Positions in 1/10000 minute.
pub(super) const LONGITUDE: Scale =
    Scale::new(600_000, -108_000_000, 108_000_000, Unit::Degrees).none(108_600_000);
pub(super) const LATITUDE: Scale =
    Scale::new(600_000, -54_000_000, 54_000_000, Unit::Degrees).none(54_600_000);
/// Positions in 1/10 minute.
pub(super) const COARSE_LONGITUDE: Scale =
    Scale::new(600, -108_000, 108_000, Unit::Degrees).none(108_600);
pub(super) const COARSE_LATITUDE: Scale =
    Scale::new(600, -54_000, 54_000, Unit::Degrees).none(54_600);
/// Length and breadth from the reference point.
pub(super) const LONG: Scale = Scale::new(1, 0, 511, Unit::Metres).top();
pub(super) const BROAD: Scale = Scale::new(1, 0, 63, Unit::Metres).top();
pub(super) const MONTH: Scale = Scale::new(1, 1, 12, Unit::None).none(0);
pub(super) const DAY: Scale = Scale::new(1, 1, 31, Unit::None).none(0);
pub(super) const HOUR: Scale = Scale::new(1, 0, 23, Unit::None).none(24);
pub(super) const MINUTE: Scale = Scale::new(1, 0, 59, Unit::None).none(60);

pub(super) type Meaning = fn(u32) -> Option<&'static str>;

pub(super) const fn field(
    name: &'static str,
    width: usize,
    kind: Kind,
    note: &'static str,
) -> Item {
    Item::Field(Field {
        name,
        width,
        kind,
        note,
    })
}
pub(super) const fn number(
    name: &'static str,
    width: usize,
    scale: Scale,
    note: &'static str,
) -> Item {
    field(name, width, scale.kind(), note)
}
pub(super) const fn whole(name: &'static str, width: usize, note: &'static str) -> Item {
    field(name, width, WHOLE.kind(), note)
}
pub(super) const fn code(
    name: &'static str,
    width: usize,
    none: i32,
    meaning: Meaning,
    note: &'static str,
) -> Item {
    field(name, width, Kind::Code(none, meaning), note)
}
pub(super) const fn flag(name: &'static str, note: &'static str) -> Item {
    field(name, 1, Kind::Flag, note)
}
pub(super) const fn text(name: &'static str, characters: usize, note: &'static str) -> Item {
    field(name, characters * 6, Kind::Text, note)
}
pub(super) const fn spare(width: usize) -> Item {
    field("", width, Kind::Spare, "Not used.")
}
/// Fields that depend on a field of `width` bits at a place.
pub(super) const fn when(
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
pub(super) const POSITION: &[Item] = items! {
    code("position_accuracy", 1, NEVER, codes::accuracy, "Accuracy of the position."),
    number("longitude", 28, LONGITUDE, "Longitude, east positive."),
    number("latitude", 27, LATITUDE, "Latitude, north positive."),
};
pub(super) const RAIM: Item = flag(
    "raim",
    "Receiver autonomous integrity monitoring is in use.",
);
pub(super) const ASSIGNED: Item = flag(
    "assigned_mode",
    "Works in assigned mode, else autonomously and continuously.",
);
pub(super) const FIXING: Item = code(
    "position_fixing_device",
    4,
    NEVER,
    codes::position_fixing,
    "Type of the electronic position-fixing device.",
);
pub(super) const TIME_STAMP: Item = code(
    "time_stamp",
    6,
    60,
    codes::time_stamp,
    "UTC second of the report.",
);
pub(super) const TERMINAL: Item = code(
    "data_terminal",
    1,
    NEVER,
    codes::terminal,
    "Data terminal equipment.",
);
pub(super) const SHIP_TYPE: Item = code(
    "ship_type",
    8,
    0,
    codes::ship_type,
    "Type of ship and cargo.",
);
pub(super) const DIMENSIONS: &[Item] = items! {
    number("to_bow", 9, LONG, "From the reference point of the position to the bow."),
    number("to_stern", 9, LONG, "From the reference point to the stern."),
    number("to_port", 6, BROAD, "From the reference point to the port side."),
    number("to_starboard", 6, BROAD, "From the reference point to the starboard side."),
};
/// Application identifier.
pub(super) const APPLICATION: &[Item] = items! {
    whole("designated_area_code", 10, "Area whose authority defines the data; 1 is international."),
    whole("function_identifier", 6, "Which of its applications."),
};
pub(super) const DATA: Item = field(
    "data",
    0,
    Kind::Binary(0),
    "Data of the application, not read here.",
);

/// Communication state of self-organised access.
pub(super) const SOTDMA: &[Item] = items! {
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
pub(super) const ITDMA: &[Item] = items! {
    code("sync_state", 2, NEVER, codes::sync, "To what the station is synchronised."),
    whole("slot_increment", 13, "To the next slot; 0: no more transmissions."),
    whole("number_of_slots", 3, "Consecutive slots."),
    flag("keep_slot", "The slot stays allocated for another frame."),
};
/// Either, as a flag before it says.
pub(super) const SELECTED_STATE: &[Item] = items! {
    code("communication_state", 1, NEVER, codes::state_selector, "Access scheme of the state that follows."),
    when("communication_state", Place::List(0), 1, 1 << 0, SOTDMA),
    when("communication_state", Place::List(0), 1, 1 << 1, ITDMA),
};
