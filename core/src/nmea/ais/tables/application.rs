//! Binary and safety-related messages and their acknowledgements: 6 to 8, 12 to 14, 17, 25 and 26.

use super::common::*;

const SEQUENCE: Item = whole("sequence_number", 2, "Number by which it is acknowledged.");
const DESTINATION: Item = number("destination_mmsi", 30, MMSI, "Station that is addressed.");
const RETRANSMITTED: Item = flag("retransmitted", "Sent again.");
const SAFETY_TEXT: Item = field("text", 0, Kind::Text, "Safety-related text.");

const ADDRESSED: &[Item] = &[SEQUENCE, DESTINATION, RETRANSMITTED, spare(1)];

const ACKNOWLEDGE: &[Item] = items! {
    spare(2),
    Item::Each("acknowledgements", 4, 32, &[DESTINATION, SEQUENCE]),
};

const CORRECTION: &[Item] = items! {
    spare(2),
    number("longitude", 18, COARSE_LONGITUDE, "Longitude of the reference station, east positive."),
    number("latitude", 17, COARSE_LATITUDE, "Latitude of the reference station, north positive."),
    spare(5),
    Item::Longer(120, &[
            whole("correction_type", 6, "Message type of ITU-R M.823."),
            whole("reference_station", 10, "Identifier of the reference station."),
            number("z_count", 13, Scale::new(1, 0, 8191, Unit::None), "Time within the hour, in 0.6 s."),
            whole("correction_sequence", 3, "Sequence number."),
            whole("words", 5, "Number of words that follow, of 24 bits each."),
            whole("health", 3, "Health of the reference station."),
            field("data", 0, Kind::Binary(0), "Correction data, not read here."),
    ]),
};

/// Who is addressed, and whether an application is named.
const SELECTED: &[Item] = items! {
    flag("addressed", "Addressed to one station, else broadcast."),
    flag("structured", "The data begin with an application identifier."),
    when("addressed", Place::Bit(38), 1, 1 << 1, &[DESTINATION, spare(2)]),
};
const STRUCTURED: Item = when("structured", Place::Bit(39), 1, 1 << 1, APPLICATION);

pub(super) static LAYOUTS: &[Layout] = items! {
    Layout {
        kind: 6,
        title: "Binary addressed message",
        least: 88,
        most: 1008,
        items: &[Item::Part(ADDRESSED), Item::Part(APPLICATION), DATA],
    },
    Layout {
        kind: 7,
        title: "Binary acknowledgement",
        least: 72,
        most: 168,
        items: ACKNOWLEDGE,
    },
    Layout {
        kind: 8,
        title: "Binary broadcast message",
        least: 56,
        most: 1008,
        items: &[spare(2), Item::Part(APPLICATION), DATA],
    },
    Layout {
        kind: 12,
        title: "Addressed safety-related message",
        least: 72,
        most: 1008,
        items: &[Item::Part(ADDRESSED), SAFETY_TEXT],
    },
    Layout {
        kind: 13,
        title: "Safety-related acknowledgement",
        least: 72,
        most: 168,
        items: ACKNOWLEDGE,
    },
    Layout {
        kind: 14,
        title: "Safety-related broadcast message",
        least: 40,
        most: 1008,
        items: &[spare(2), SAFETY_TEXT],
    },
    Layout {
        kind: 17,
        title: "GNSS broadcast binary message",
        least: 80,
        most: 816,
        items: CORRECTION,
    },
    Layout {
        kind: 25,
        title: "Single-slot binary message",
        least: 40,
        most: 168,
        items: &[Item::Part(SELECTED), STRUCTURED, DATA],
    },
    Layout {
        kind: 26,
        title: "Multiple-slot binary message with communication state",
        least: 64,
        most: 1064,
        items: &[
            Item::Part(SELECTED),
            STRUCTURED,
            field("data", 0, Kind::Binary(24), "Data of the application, not read here."),
            spare(4),
            Item::Part(SELECTED_STATE),
        ],
    },
};

/// What ABM and BBM carry for messages 6, 8 and structured 25 and 26.
pub(in crate::nmea) static BINARY: &[Item] = &[Item::Part(APPLICATION), DATA];
/// What they carry for messages 12 and 14.
pub(in crate::nmea) static TEXT: &[Item] = &[SAFETY_TEXT];
/// What they carry for unstructured messages 25 and 26 (numbers 70 and 71).
pub(in crate::nmea) static UNSTRUCTURED: &[Item] = &[DATA];
