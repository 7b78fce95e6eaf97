//! Heading, rate of turn, speed through the water and transducers.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::table::{Format, Unit, definition, kind, meanings, sentences, view, view_type};

const READING: Format = Format::new(Unit::None, -i32::MAX, i32::MAX, 1, 2);

sentences! {
    hdt as Hdt = "HDT" b'$' [2] "Heading, true", "IEC 61162-1 HDT; Navis A.9, A.10; Furuno AP-10" {
        heading: lettered(DIRECTION, b'T') "True heading; steered by, at most 2 s old. Forwarded with its source's talker.",
    }
    ths as Ths = "THS" b'$' [2] "True heading and status", "IEC 61162-1 THS; Navis A.11; Furuno AP-10" {
        heading: number(DIRECTION) "True heading.",
        mode: code(ThsMode) "Mode indicator; only A is used.",
    }
    hdg as Hdg = "HDG" b'$' [5] "Heading, deviation and variation", "IEC 61162-1 HDG; Navis A.12; EMACUA System Interfaces" {
        heading: number(DIRECTION) "Magnetic sensor heading.",
        deviation: sided(DEVIATION, EW) "Deviation, east positive; used with the sensor heading.",
        variation: sided(DEVIATION, EW) "Variation, east positive; used to make the heading true.",
    }
    hdm as Hdm = "HDM" b'$' [2] "Heading, magnetic", "NMEA 0183 HDM; Navis A.13; EMACUA System Interfaces" {
        heading: lettered(DIRECTION, b'M') "Magnetic heading.",
    }
    rot as Rot = "ROT" b'$' [2] "Rate of turn", "IEC 61162-1 ROT; Navis A.16" {
        rate: number(RATE) "Rate of turn, starboard positive; shown as S, else calculated from the heading (C).",
        status: code(DataStatus) "V makes the sentence count as not received.",
    }
    vhw as Vhw = "VHW" b'$' [8] "Water speed and heading", "IEC 61162-1 VHW; Navis A.14; Furuno AP-12" {
        heading_true: lettered(DIRECTION, b'T') "True heading; not used.",
        heading_magnetic: lettered(DIRECTION, b'M') "Magnetic heading; not used.",
        speed_knots: lettered(WATER_KNOTS, b'N') "Speed through the water; the speed source LOG.",
        speed_kmh: lettered(WATER_KMH, b'K') "The same in kilometres an hour; not used.",
    }
    xdr as Xdr = "XDR" b'$' [] "Transducer measurements", "IEC 61162-1 XDR" {
        ; each Open() XdrReading readings {
            kind: text(2) "Type of the transducer: A angular displacement, C temperature, D linear displacement, P pressure and others.",
            reading: number(READING) "Its reading.",
            unit: text(2) "Unit of the reading: D degrees, C Celsius, M metres, B bars and others.",
            name: text(30) "Name of the transducer, such as HEEL.",
        }
    }
}

const WATER_KNOTS: Format = Format::new(Unit::Knots, -999, 9999, 1, 1);
const WATER_KMH: Format = Format::new(Unit::KilometresPerHour, -1999, 19999, 1, 1);
