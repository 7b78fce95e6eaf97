//! Radar, tracked targets and own ship as the radar takes it.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};
use crate::nmea::table::{Format, Unit};
use serde::{Deserialize, Serialize};

codes! {
    /// What a course or speed is referred to.
    MotionReference {
        Bottom = b'B' "bottom tracking log", Manual = b'M' "manually entered", Water = b'W' "water referenced",
        Radar = b'R' "radar tracking of a fixed target", Position = b'P' "positioning system, ground reference",
    }
    /// Unit of speeds and distances of a target.
    RadarUnit {
        Kilometres = b'K' "kilometres, kilometres an hour", Nautical = b'N' "nautical miles, knots", Statute = b'S' "statute miles, statute miles an hour",
    }
    /// Unit of the ranges of a radar.
    RangeUnit { Kilometres = b'K' "kilometres", NauticalMiles = b'N' "nautical miles", StatuteMiles = b'S' "statute miles" }
    /// Unit of own speed and drift.
    SpeedUnit { Kilometres = b'K' "kilometres an hour", Knots = b'N' "knots", StatuteMiles = b'S' "statute miles an hour" }
    /// Rotation of a display.
    DisplayRotation {
        Course = b'C' "course-up, course over ground up", Head = b'H' "head-up, ship's heading up", North = b'N' "north-up, true north up",
    }
    /// Status of a target.
    TargetStatus { Lost = b'L' "lost", Acquiring = b'Q' "acquiring", Tracking = b'T' "tracking" }
    /// Whether a target is a reference target.
    TargetReference { Reference = b'R' "reference target, used to find own position or speed" }
    /// How a target was acquired.
    Acquisition { Automatic = b'A' "automatic", Manual = b'M' "manual", Reported = b'R' "reported" }
}

const MINUTES: Format = Format::new(Unit::Minutes, -i32::MAX, i32::MAX, 1, 2);

sentences! {
    osd as Osd = "OSD" b'$' [9] "Own ship data", "IEC 61162-1 OSD; Furuno appendix p. 14" {
        heading: number(DIRECTION) "Heading, true.",
        heading_status: code(DataStatus) "Its status.",
        course: number(DIRECTION) "Course, true.",
        course_reference: code(MotionReference) "What the course is referred to.",
        speed: number(SIZE) "Speed.",
        speed_reference: code(MotionReference) "What the speed is referred to.",
        set: number(DIRECTION) "Set, true, manually entered.",
        drift: number(SIZE) "Drift, manually entered.",
        unit: code(SpeedUnit) "Unit of the speeds.",
    }
    rsd as Rsd = "RSD" b'$' [13] "Radar system data", "IEC 61162-1 RSD; Furuno appendix p. 14" {
        origin_1_range: number(SIZE) "Range of origin 1 from own ship.",
        origin_1_bearing: number(DIRECTION) "Bearing of origin 1.",
        vrm_1: number(SIZE) "Variable range marker 1.",
        ebl_1: number(DIRECTION) "Bearing line 1.",
        origin_2_range: number(SIZE) "Range of origin 2.",
        origin_2_bearing: number(DIRECTION) "Bearing of origin 2.",
        vrm_2: number(SIZE) "Variable range marker 2.",
        ebl_2: number(DIRECTION) "Bearing line 2.",
        cursor_range: number(SIZE) "Range of the cursor from own ship.",
        cursor_bearing: number(DIRECTION) "Bearing of the cursor.",
        scale: number(SIZE) "Range scale in use.",
        unit: code(RangeUnit) "Unit of the ranges.",
        rotation: code(DisplayRotation) "Rotation of the display.",
    }
    ttm as Ttm = "TTM" b'$' [15, 14, 13] "Tracked target message", "IEC 61162-1 TTM; Furuno appendix p. 15" {
        target: integer(whole(0, 1023, 2)) "Number of the target.",
        distance: number(SIZE) "Distance from own ship.",
        bearing: number(DIRECTION) "Bearing from own ship.",
        bearing_reference: code(RelativeReference) "Its reference.",
        speed: number(SIZE) "Speed of the target.",
        course: number(DIRECTION) "Course of the target.",
        course_reference: code(RelativeReference) "Its reference.",
        closest_distance: number(SIZE) "Distance of the closest point of approach.",
        closest_time: number(MINUTES) "Time to it, negative once passed.",
        unit: code(RadarUnit) "Unit of speeds and distances.",
        name: text(20) "Name of the target.",
        status: code(TargetStatus) "Status of the target.",
        reference: code(TargetReference) "R for a reference target, else null.",
        time: time() "UTC of the data.",
        acquisition: code(Acquisition) "How it was acquired.",
    }
    tlb as Tlb = "TLB" b'$' [] "Target label", "IEC 61162-1 TLB; Furuno appendix p. 14" {
        ; each Open() TlbLabel labels {
            target: number(COUNT) "Number of the target.",
            label: text(20) "Label assigned to it.",
        }
    }
    tll = "TLL" b'$' [9] "Target latitude and longitude", "IEC 61162-1 TLL" {
        target: integer(whole(0, 99, 2)) "Number of the target.",
        position: position(4) "Its position.",
        name: text(20) "Its name.",
        time: time() "UTC of the data.",
        status: code(TargetStatus) "Its status.",
        reference: code(TargetReference) "R for a reference target, else null.",
    }
    ttd as Ttd = "TTD" b'!' [5] "Tracked target data", "IEC 61162-1 TTD; Furuno appendix p. 14" {
        total: hex(2) "Number of sentences of this message, hexadecimal.",
        number: hex(2) "Number of this sentence, hexadecimal.",
        sequence: integer(whole(0, 9, 1)) "Identifier of the message.",
        payload: payload() "Encapsulated tracked-target data.",
        fill_bits: integer(whole(0, 5, 1)) "Bits of the last character that do not count.",
    }
}
