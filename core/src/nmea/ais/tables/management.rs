//! Management of the data link: messages 10, 15, 16, 20, 22 and 23.

use super::common::*;

const DESTINATION: Item = number("destination_mmsi", 30, MMSI, "Station that is addressed.");

const INTERROGATION: &[Item] = items! {
    spare(2),
    number("destination_mmsi_1", 30, MMSI, "First station that is asked."),
    whole("message_1_1", 6, "Message asked of it."),
    whole("slot_offset_1_1", 12, "Slot in which it answers."),
    Item::Longer(108, &[
        spare(2),
        whole("message_1_2", 6, "Second message asked of it."),
        whole("slot_offset_1_2", 12, "Slot in which it answers."),
    ]),
    Item::Longer(160, &[
        spare(2),
        number("destination_mmsi_2", 30, MMSI, "Second station that is asked."),
        whole("message_2_1", 6, "Message asked of it."),
        whole("slot_offset_2_1", 12, "Slot in which it answers."),
        spare(2),
    ]),
};

const ASSIGNMENT: &[Item] = items! {
    spare(2),
    Item::Each("assignments", 2, 52, &[
        DESTINATION,
        whole("slot_offset", 12, "From this slot to the first one assigned; or reports in ten minutes."),
        whole("slot_increment", 10, "To the next slot; 0: the offset is a number of reports."),
    ]),
};

const RESERVATION: &[Item] = items! {
    spare(2),
    Item::Each("reservations", 4, 30, &[
        whole("slot_offset", 12, "First slot."),
        whole("number_of_slots", 4, "Consecutive slots."),
        whole("timeout", 3, "Minutes that the reservation lasts."),
        whole("slot_increment", 11, "To the next block; 0: one block a frame."),
    ]),
};

/// Corners of an area.
const AREA: &[Item] = items! {
    number("north_east_longitude", 18, COARSE_LONGITUDE, "Longitude of the north-east corner, east positive."),
    number("north_east_latitude", 17, COARSE_LATITUDE, "Latitude of the north-east corner, north positive."),
    number("south_west_longitude", 18, COARSE_LONGITUDE, "Longitude of the south-west corner, east positive."),
    number("south_west_latitude", 17, COARSE_LATITUDE, "Latitude of the south-west corner, north positive."),
};

/// Bit of message 22 that says whether it is addressed.
const ADDRESSED: Place = Place::Bit(139);

const CHANNELS: &[Item] = items! {
    spare(2),
    whole("channel_a", 12, "Channel A."),
    whole("channel_b", 12, "Channel B."),
    code("transmission_mode", 4, NEVER, codes::transmission_mode, "Transmit and receive mode."),
    code("power", 1, NEVER, codes::power, "Power of the transmissions."),
    when("addressed", ADDRESSED, 1, 1 << 0, AREA),
    when("addressed", ADDRESSED, 1, 1 << 1, &[
        number("destination_mmsi_1", 30, MMSI, "First station that is addressed."),
        spare(5),
        number("destination_mmsi_2", 30, MMSI, "Second station that is addressed."),
        spare(5),
    ]),
    flag("addressed", "Addressed to stations, else for an area."),
    code("bandwidth_a", 1, NEVER, codes::bandwidth, "Bandwidth of channel A."),
    code("bandwidth_b", 1, NEVER, codes::bandwidth, "Bandwidth of channel B."),
    number("transition_zone", 3, ZONE, "Size of the transition zone."),
    spare(23),
};

/// Coded one mile less than it is.
const ZONE: Scale = Scale::new(1, 0, 7, Unit::NauticalMiles).plus(1);

const GROUP: &[Item] = items! {
    spare(2),
    Item::Part(AREA),
    code("station_type", 4, NEVER, codes::station_type, "Stations that are meant."),
    code("ship_type", 8, 0, codes::ship_type, "Ships that are meant; null: all."),
    spare(22),
    code("transmission_mode", 2, NEVER, codes::group_transmission_mode, "Transmit and receive mode."),
    code("reporting_interval", 4, NEVER, codes::reporting_interval, "Reporting interval."),
    number("quiet_time", 4, Scale::new(1, 1, 15, Unit::Minutes).none(0), "Quiet time; null: none is ordered."),
    spare(6),
};

pub(super) static LAYOUTS: &[Layout] = items! {
    Layout {
        kind: 10,
        title: "UTC and date inquiry",
        least: 72,
        most: 72,
        items: &[spare(2), DESTINATION, spare(2)],
    },
    Layout {
        kind: 15,
        title: "Interrogation",
        least: 88,
        most: 160,
        items: INTERROGATION,
    },
    Layout {
        kind: 16,
        title: "Assignment mode command",
        least: 92,
        most: 144,
        items: ASSIGNMENT,
    },
    Layout {
        kind: 20,
        title: "Data link management",
        least: 70,
        most: 160,
        items: RESERVATION,
    },
    Layout {
        kind: 22,
        title: "Channel management",
        least: 168,
        most: 168,
        items: CHANNELS,
    },
    Layout {
        kind: 23,
        title: "Group assignment command",
        least: 160,
        most: 160,
        items: GROUP,
    },
};
