//! Heading, rate of turn, speed through the water and transducers.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};
use crate::nmea::table::{Format, Unit};
use serde::{Deserialize, Serialize};

const METRES_THROUGH: Format = Format::new(Unit::MetresPerSecond, -9999, 9999, 1, 1);
const READING: Format = Format::new(Unit::None, -i32::MAX, i32::MAX, 1, 2);

codes! {
    /// What the heading of HCR is corrected for.
    CorrectionState {
        Both = b'A' "speed, latitude and dynamic corrections", Dynamic = b'D' "dynamic correction", Static = b'S' "speed and latitude correction",
        None = b'N' "no correction", NotAvailable = b'V' "not available",
    }
    /// Type of a transducer.
    TransducerType {
        Angle = b'A' "angular displacement", AbsoluteHumidity = b'B' "absolute humidity", Temperature = b'C' "temperature",
        Displacement = b'D' "linear displacement", Level = b'E' "fluid level", Frequency = b'F' "frequency", Generic = b'G' "generic",
        Humidity = b'H' "humidity", Current = b'I' "current", Salinity = b'L' "salinity", Force = b'N' "force", Pressure = b'P' "pressure",
        Flow = b'R' "flow rate", Switch = b'S' "switch or valve", Tachometer = b'T' "tachometer", Voltage = b'U' "voltage", Volume = b'V' "volume", DewPoint = b'W' "dew point",
    }
    /// Unit of a transducer's reading; some letters have a meaning for each type.
    TransducerUnit {
        Ampere = b'A' "amperes", Bar = b'B' "bars; of a switch: 1 on or closed, 0 off or open", Celsius = b'C' "degrees Celsius", Degree = b'D' "degrees", Hertz = b'H' "hertz",
        Density = b'K' "kilograms per cubic metre", Litres = b'l' "litres a second", LitresAlso = b'L' "litres or litres a second, as some write it",
        Metre = b'M' "metres or cubic metres", Newton = b'N' "newtons", Pascal = b'P' "pascals or per cent", Revolutions = b'R' "revolutions a minute",
        PartsPerThousand = b'S' "parts per thousand", Volt = b'V' "volts",
    }
}

sentences! {
    hdt as Hdt = "HDT" b'$' [2] "Heading, true", "IEC 61162-1 HDT; Navis A.9, A.10; Furuno appendix p. 10" {
        heading: lettered(DIRECTION, b'T') "True heading; steered by, at most 2 s old. Forwarded with its source's talker.",
    }
    ths as Ths = "THS" b'$' [2] "True heading and status", "IEC 61162-1 THS; Navis A.11; Furuno appendix p. 10" {
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
    vhw as Vhw = "VHW" b'$' [8] "Water speed and heading", "IEC 61162-1 VHW; Navis A.14; Furuno appendix p. 12" {
        heading_true: lettered(DIRECTION, b'T') "True heading; not used.",
        heading_magnetic: lettered(DIRECTION, b'M') "Magnetic heading; not used.",
        speed_knots: lettered(SPEED_THROUGH, b'N') "Speed through the water; the speed source LOG.",
        speed_kmh: lettered(KMH_THROUGH, b'K') "The same in kilometres an hour; not used.",
    }
    hms as Hms = "HMS" b'$' [3] "Heading monitor set", "IEC 61162-1 HMS; Navis A.5" {
        sensor_1: text(20) "First heading sensor: GYRO1, GYRO2, THD or MAGN.",
        sensor_2: text(20) "Second heading sensor.",
        limit: number(LIMIT) "Greatest difference allowed; a larger one raises HDG DIFF.",
    }
    hmr as Hmr = "HMR" b'$' [17] "Heading monitor receive", "IEC 61162-1 HMR; Navis A.6" {
        sensor_1: text(20) "First heading sensor: GYRO1, GYRO2, THD or MAGN.",
        sensor_2: text(20) "Second heading sensor; null where there is only one.",
        limit: number(LIMIT) "Difference set by HMS.",
        difference: number(SIGNED_ANGLE) "Actual difference of the two headings.",
        warning: code(LimitStatus) "A: within the set limit, V: beyond it.",
        heading_1: number(DIRECTION) "Heading of the first sensor.",
        status_1: code(DataStatus) "Its status.",
        type_1: code(Reference) "Its type: gyros and THD are true.",
        deviation_1: sided(DEVIATION, EW) "Its deviation, for a magnetic sensor.",
        heading_2: number(DIRECTION) "Heading of the second sensor.",
        status_2: code(DataStatus) "Its status.",
        type_2: code(Reference) "Its type.",
        deviation_2: sided(DEVIATION, EW) "Its deviation, for a magnetic sensor.",
        variation: sided(DEVIATION, EW) "Variation, for a magnetic sensor.",
    }
    hcr as Hcr = "HCR" b'$' [4] "Heading correction report", "IEC 61162-1 HCR" {
        heading: number(DIRECTION) "True heading.",
        mode: code(ThsMode) "Mode indicator.",
        correction: code(CorrectionState) "What is corrected.",
        value: number(SIGNED_ANGLE) "The correction; null where it is not known.",
    }
    hrm as Hrm = "HRM" b'$' [10, 13] "Heel angle, roll period and roll amplitude", "IEC 61162-1 HRM; EMACUA System Interfaces" {
        heel: number(SIGNED_ANGLE) "Heel, starboard positive.",
        roll_period: number(SECONDS) "Roll period.",
        amplitude_port: number(SIGNED_ANGLE) "Roll amplitude to port.",
        amplitude_starboard: number(SIGNED_ANGLE) "Roll amplitude to starboard.",
        status: code(DataStatus) "Status.",
        peak_port: number(SIGNED_ANGLE) "Peak hold to port.",
        peak_starboard: number(SIGNED_ANGLE) "Peak hold to starboard.",
        reset_time: time() "When the peaks were reset, UTC.",
        reset_day: integer(whole(1, 31, 2)) "Day of the reset.",
        reset_month: integer(whole(1, 12, 2)) "Month of the reset.";
        later {
            later_1: any() "Since the edition of 2024.",
            later_2: any() "Since the edition of 2024.",
            later_3: any() "Since the edition of 2024.",
        }
    }
    vbw as Vbw = "VBW" b'$' [10, 6] "Dual ground/water speed", "IEC 61162-1 VBW; Navis A.15; Furuno appendix p. 12" {
        water_ahead: number(SPEED_THROUGH) "Longitudinal water speed, ahead positive; the speed source LOG.",
        water_athwart: number(SPEED_THROUGH) "Transverse water speed, starboard positive; not used.",
        water_status: code(DataStatus) "V makes the water speed count as not received.",
        ground_ahead: number(SPEED_THROUGH) "Longitudinal ground speed; not used.",
        ground_athwart: number(SPEED_THROUGH) "Transverse ground speed; not used.",
        ground_status: code(DataStatus) "Status of the ground speed; not used.",
        stern_water: number(SPEED_THROUGH) "Stern transverse water speed; not used.",
        stern_water_status: code(DataStatus) "Its status; not used.",
        stern_ground: number(SPEED_THROUGH) "Stern transverse ground speed; not used.",
        stern_ground_status: code(DataStatus) "Its status; not used.",
    }
    vlw as Vlw = "VLW" b'$' [8, 4] "Dual ground/water distance", "IEC 61162-1 VLW" {
        water_total: lettered(MILES, b'N') "Total distance through the water.",
        water_trip: lettered(MILES, b'N') "Distance through the water since reset.",
        ground_total: lettered(MILES, b'N') "Total distance over ground.",
        ground_trip: lettered(MILES, b'N') "Distance over ground since reset.",
    }
    vdr as Vdr = "VDR" b'$' [6] "Set and drift", "IEC 61162-1 VDR; Furuno appendix p. 12" {
        set_true: lettered(DIRECTION, b'T') "Direction towards which the current sets, true.",
        set_magnetic: lettered(DIRECTION, b'M') "The same, magnetic.",
        drift: lettered(KNOTS, b'N') "Speed of the current.",
    }
    vpw = "VPW" b'$' [4] "Speed measured parallel to wind", "IEC 61162-1 VPW" {
        knots: lettered(SPEED_THROUGH, b'N') "Speed parallel to the wind, negative downwind.",
        metres: lettered(METRES_THROUGH, b'M') "The same in metres a second.",
    }
    xdr as Xdr = "XDR" b'$' [] "Transducer measurements", "IEC 61162-1 XDR" {
        ; each Open() XdrReading readings {
            kind: code(TransducerType) "Type of the transducer.",
            reading: number(READING) "Its reading.",
            unit: code(TransducerUnit) "Unit of the reading; null for a switch and a generic one.",
            name: text(30) "Name of the transducer, such as HEEL.",
        }
    }
    vbc = "VBC" b'$' [10] "Water-referenced and ground-referenced docking speed data", "IEC 61162-1 VBC, as SwiftNMEA reads it" {
        water_longitudinal: number(SPEED_THROUGH) "Longitudinal water speed, negative astern.",
        water_bow: number(SPEED_THROUGH) "Transverse water speed at the bow, negative to port.",
        water_transverse: number(SPEED_THROUGH) "Transverse water speed, negative to port.",
        water_stern: number(SPEED_THROUGH) "Transverse water speed at the stern, negative to port.",
        water_status: code(DataStatus) "Status of the water speeds.",
        ground_longitudinal: number(SPEED_THROUGH) "Longitudinal ground speed, negative astern.",
        ground_bow: number(SPEED_THROUGH) "Transverse ground speed at the bow, negative to port.",
        ground_transverse: number(SPEED_THROUGH) "Transverse ground speed, negative to port.",
        ground_stern: number(SPEED_THROUGH) "Transverse ground speed at the stern, negative to port.",
        ground_status: code(DataStatus) "Status of the ground speeds.",
    }
}
