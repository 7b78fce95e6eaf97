//! Static and voyage-related data: messages 5 and 24.

use super::common::*;

const IMO: Scale = Scale::new(1, 1, 0x3FFF_FFFF, Unit::None).none(0);
const DRAUGHT: Scale = Scale::new(10, 1, 255, Unit::Metres).none(0).top();

const VOYAGE: &[Item] = items! {
    code("ais_version", 2, NEVER, codes::edition, "Edition that the station complies with."),
    number("imo_number", 30, IMO, "IMO number, or an official number of the flag state."),
    text("call_sign", 7, "Call sign."),
    text("name", 20, "Name of the ship."),
    SHIP_TYPE,
    Item::Part(DIMENSIONS),
    FIXING,
    number("arrival_month", 4, MONTH, "Estimated UTC of arrival: month."),
    number("arrival_day", 5, DAY, "Day of arrival."),
    number("arrival_hour", 5, HOUR, "Hour of arrival."),
    number("arrival_minute", 6, MINUTE, "Minute of arrival."),
    number("draught", 8, DRAUGHT, "Greatest present static draught."),
    text("destination", 20, "Destination."),
    TERMINAL,
    spare(1),
};

const PART_B: &[Item] = items! {
    SHIP_TYPE,
    text("vendor", 3, "Maker of the unit."),
    whole("unit_model", 4, "Model of the unit."),
    whole("serial_number", 20, "Serial number of the unit."),
    text("call_sign", 7, "Call sign."),
    Item::Auxiliary(false, DIMENSIONS),
    Item::Auxiliary(true, &[number("mothership_mmsi", 30, MMSI, "Mother ship of an auxiliary craft.")]),
    FIXING,
    spare(2),
};

pub(super) static LAYOUTS: &[Layout] = items! {
    // The bits of the last character are not always taken off.
    Layout {
        kind: 5,
        title: "Static and voyage-related data, class A",
        least: 424,
        most: 426,
        items: VOYAGE,
    },
    Layout {
        kind: 24,
        title: "Static data, class B",
        least: 160,
        most: 168,
        items: &[
            number("part", 2, Scale::new(1, 0, 1, Unit::None), "0: part A; 1: part B."),
            when("part", Place::Bit(38), 2, 1 << 0, &[text("name", 20, "Name of the ship.")]),
            when("part", Place::Bit(38), 2, 1 << 1, PART_B),
        ],
    },
};
