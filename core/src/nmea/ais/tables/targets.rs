//! Tracked-target data of TTD (IEC 61162-1): one structure a target, told apart by its protocol version.

use super::common::*;

/// Number of a target; 0 means none.
const TARGET_NUMBER: Item = number(
    "target",
    10,
    Scale::new(1, 1, 1023, Unit::None).none(0),
    "Number of the target, as in TLB.",
);
const VERSION: Item = whole(
    "protocol_version",
    2,
    "0: target; 1: closest point of approach.",
);
const DIRECTION: Scale = Scale::new(10, 0, 3599, Unit::Degrees).none(4095);
const TARGET_SPEED: Scale = Scale::new(10, 0, 4094, Unit::Knots).none(4095);
const DISTANCE: Scale = Scale::new(100, 0, 16_382, Unit::NauticalMiles).none(16_383);
const TIME: Scale = Scale::new(100, -8191, 8191, Unit::Minutes).none(-8192);
/// 4095 means a radar target, which has no heading; 4094 an AIS target that does not report it.
const REPORTED_HEADING: Scale = Scale::new(10, 0, 3599, Unit::Degrees)
    .none(4095)
    .none_too(4094);

/// Protocol version 0.
pub(in crate::nmea) static TARGET: Layout = Layout {
    kind: 0,
    title: "Tracked target",
    least: 90,
    most: 90,
    items: &[
        VERSION,
        TARGET_NUMBER,
        number("bearing", 12, DIRECTION, "Bearing, true."),
        number(
            "speed",
            12,
            TARGET_SPEED,
            "Speed, as speed_mode and stabilisation say.",
        ),
        number(
            "course",
            12,
            DIRECTION,
            "Course, as speed_mode and stabilisation say.",
        ),
        number(
            "heading",
            12,
            REPORTED_HEADING,
            "Heading that an AIS target reports; null for a radar target.",
        ),
        code(
            "status",
            3,
            NEVER,
            codes::target_status,
            "Status of the target.",
        ),
        code("operation", 1, NEVER, codes::test_target, "Operation mode."),
        number("distance", 14, DISTANCE, "Distance."),
        code(
            "speed_mode",
            1,
            NEVER,
            codes::speed_mode,
            "Whether speed and course are true or relative.",
        ),
        code(
            "stabilisation",
            1,
            NEVER,
            codes::stabilisation,
            "To what they are referred.",
        ),
        spare(2),
        number(
            "correlation",
            8,
            Scale::new(1, 1, 255, Unit::None).none(0),
            "Common number of targets that are taken for one.",
        ),
    ],
};

/// Protocol version 1.
pub(in crate::nmea) static APPROACH: Layout = Layout {
    kind: 1,
    title: "Closest point of approach of a target",
    least: 42,
    most: 42,
    items: &[
        VERSION,
        TARGET_NUMBER,
        number(
            "closest_distance",
            14,
            DISTANCE,
            "Distance at the closest point of approach.",
        ),
        number(
            "closest_time",
            14,
            TIME,
            "Time to it, negative once passed.",
        ),
        spare(2),
    ],
};
