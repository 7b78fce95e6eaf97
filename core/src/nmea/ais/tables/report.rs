//! Position reports: messages 1 to 4, 9, 11, 18, 19, 21 and 27.

use super::common::*;

const CLASS_A: &[Item] = items! {
    code("navigational_status", 4, NEVER, codes::navigational_status, "Navigational status."),
    field("rate_of_turn", 8, Kind::Turn, "Rate of turn, to starboard positive."),
    number("speed_over_ground", 10, SPEED, "Speed over ground."),
    Item::Part(POSITION),
    number("course_over_ground", 12, COURSE, "Course over ground, true."),
    number("true_heading", 9, HEADING, "Heading, true."),
    TIME_STAMP,
    code("special_manoeuvre", 2, 0, codes::special_manoeuvre, "Special manoeuvre indicator, such as a blue sign."),
    spare(3),
    RAIM,
};

const BASE: &[Item] = items! {
    number("year", 14, Scale::new(1, 1, 9999, Unit::None).none(0), "UTC year."),
    number("month", 4, MONTH, "UTC month."),
    number("day", 5, DAY, "UTC day."),
    number("hour", 5, HOUR, "UTC hour."),
    number("minute", 6, MINUTE, "UTC minute."),
    number("second", 6, MINUTE, "UTC second."),
    Item::Part(POSITION),
    FIXING,
    flag("long_range_requested", "A class A station is asked to send message 27 within the area of a base station."),
    spare(9),
    RAIM,
    Item::Part(SOTDMA),
};

/// Altitude of an aircraft, and its speed in whole knots.
const ALTITUDE: Scale = Scale::new(1, 0, 4094, Unit::Metres).none(4095).top();
const AIR_SPEED: Scale = Scale::new(1, 0, 1022, Unit::Knots).none(1023).top();

const AIRCRAFT: &[Item] = items! {
    number("altitude", 12, ALTITUDE, "Altitude."),
    number("speed_over_ground", 10, AIR_SPEED, "Speed over ground."),
    Item::Part(POSITION),
    number("course_over_ground", 12, COURSE, "Course over ground, true."),
    TIME_STAMP,
    code("altitude_sensor", 1, NEVER, codes::altitude_sensor, "Source of the altitude."),
    spare(7),
    TERMINAL,
    spare(3),
    ASSIGNED,
    RAIM,
    Item::Part(SELECTED_STATE),
};

const MOTION: &[Item] = items! {
    spare(8),
    number("speed_over_ground", 10, SPEED, "Speed over ground."),
    Item::Part(POSITION),
    number("course_over_ground", 12, COURSE, "Course over ground, true."),
    number("true_heading", 9, HEADING, "Heading, true."),
    TIME_STAMP,
};

const CLASS_B: &[Item] = items! {
    Item::Part(MOTION),
    spare(2),
    code("class_b_unit", 1, NEVER, codes::class_b_unit, "Kind of unit."),
    flag("display", "Has a display for messages 12 and 14."),
    flag("digital_selective_calling", "Has a DSC function."),
    flag("whole_band", "Works over the whole marine band, else the upper 525 kHz."),
    flag("message_22", "Can be given channels by message 22."),
    ASSIGNED,
    RAIM,
    Item::Part(SELECTED_STATE),
};

const CLASS_B_EXTENDED: &[Item] = items! {
    Item::Part(MOTION),
    spare(4),
    text("name", 20, "Name of the ship."),
    SHIP_TYPE,
    Item::Part(DIMENSIONS),
    FIXING,
    RAIM,
    TERMINAL,
    ASSIGNED,
    spare(4),
};

const AID: &[Item] = items! {
    code("aid_type", 5, 0, codes::aid_type, "Type of the aid to navigation."),
    text("name", 20, "Name of the aid."),
    Item::Part(POSITION),
    Item::Part(DIMENSIONS),
    FIXING,
    TIME_STAMP,
    flag("off_position", "Off its position; for floating aids with a time stamp up to 59."),
    whole("aid_status", 8, "Status of the aid, as its authority defines."),
    RAIM,
    code("virtual_aid", 1, NEVER, codes::virtual_aid, "Whether the aid is there at all."),
    ASSIGNED,
    spare(1),
    field("name_extension", 0, Kind::Text, "Rest of a name of more than 20 characters."),
};

/// Speed and course of a long-range report.
const LONG_RANGE_SPEED: Scale = Scale::new(1, 0, 62, Unit::Knots).none(63).top();
const LONG_RANGE_COURSE: Scale = Scale::new(1, 0, 359, Unit::Degrees).none(511);

const LONG_RANGE: &[Item] = items! {
    code("position_accuracy", 1, NEVER, codes::accuracy, "Accuracy of the position."),
    RAIM,
    code("navigational_status", 4, NEVER, codes::navigational_status, "Navigational status."),
    number("longitude", 18, COARSE_LONGITUDE, "Longitude to a tenth of a minute, east positive."),
    number("latitude", 17, COARSE_LATITUDE, "Latitude to a tenth of a minute, north positive."),
    number("speed_over_ground", 6, LONG_RANGE_SPEED, "Speed over ground."),
    number("course_over_ground", 9, LONG_RANGE_COURSE, "Course over ground, true."),
    code("position_latency", 1, NEVER, codes::position_latency, "Age of the position when it was sent."),
    spare(1),
};

const fn layout(kind: u8, title: &'static str, length: usize, items: &'static [Item]) -> Layout {
    Layout {
        kind,
        title,
        least: length,
        most: length,
        items,
    }
}

pub(super) static LAYOUTS: &[Layout] = items! {
    layout(1, "Position report, class A, scheduled", 168, &[Item::Part(CLASS_A), Item::Part(SOTDMA)]),
    layout(2, "Position report, class A, assigned schedule", 168, &[Item::Part(CLASS_A), Item::Part(SOTDMA)]),
    layout(3, "Position report, class A, response to interrogation", 168, &[Item::Part(CLASS_A), Item::Part(ITDMA)]),
    layout(4, "Base station report", 168, BASE),
    layout(9, "Position report of a search and rescue aircraft", 168, AIRCRAFT),
    layout(11, "UTC and date response", 168, BASE),
    layout(18, "Position report, class B", 168, CLASS_B),
    layout(19, "Extended position report, class B", 312, CLASS_B_EXTENDED),
    Layout {
        kind: 21,
        title: "Aid-to-navigation report",
        least: 272,
        most: 360,
        items: AID,
    },
    // Some stations fill the whole slot.
    Layout {
        kind: 27,
        title: "Position report for long range",
        least: 96,
        most: 168,
        items: LONG_RANGE,
    },
};
