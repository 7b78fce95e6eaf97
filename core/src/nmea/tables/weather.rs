//! Wind, water and depth.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};
use crate::nmea::table::{Format, Unit};
use serde::{Deserialize, Serialize};

codes! {
    /// Reference of a wind angle.
    WindReference { Relative = b'R' "relative (apparent)", True = b'T' "theoretical (true)" }
    /// Unit of a wind speed.
    WindUnit { Kilometres = b'K' "kilometres an hour", Metres = b'M' "metres a second", Knots = b'N' "knots", Miles = b'S' "statute miles an hour" }
    /// Reference of a speed or depth of a current.
    CurrentReference { Bottom = b'B' "bottom track", Position = b'P' "positioning system", Water = b'W' "water track" }
}

const HUMIDITY: Format = Format::new(Unit::Percent, 0, 100, 1, 1);
const BARS: Format = Format::new(Unit::Bars, 0, i32::MAX, 1, 4);
const INCHES: Format = Format::new(Unit::InchesOfMercury, 0, i32::MAX, 1, 2);

sentences! {
    mtw as Mtw = "MTW" b'$' [2] "Water temperature", "IEC 61162-1 MTW; Furuno appendix p. 10" {
        temperature: lettered(CELSIUS, b'C') "Water temperature.",
    }
    mwv as Mwv = "MWV" b'$' [5] "Wind speed and angle", "IEC 61162-1 MWV; Furuno appendix p. 10" {
        angle: number(DIRECTION) "Wind angle from the bow.",
        reference: code(WindReference) "R apparent, T true.",
        speed: number(SIZE) "Wind speed.",
        unit: code(WindUnit) "Its unit.",
        status: code(DataStatus) "Status.",
    }
    mwd as Mwd = "MWD" b'$' [8] "Wind direction and speed", "IEC 61162-1 MWD" {
        direction_true: lettered(DIRECTION, b'T') "Direction from which the wind blows, true.",
        direction_magnetic: lettered(DIRECTION, b'M') "The same, magnetic.",
        speed_knots: lettered(KNOTS, b'N') "Wind speed.",
        speed_mps: lettered(MPS, b'M') "The same in metres a second.",
    }
    vwr as Vwr = "VWR" b'$' [8] "Relative wind speed and angle", "NMEA 0183 VWR" {
        angle: sided(RUDDER_SIZE, LR) "Apparent wind angle from the bow, starboard positive.",
        speed_knots: lettered(KNOTS, b'N') "Wind speed.",
        speed_mps: lettered(MPS, b'M') "The same in metres a second.",
        speed_kmh: lettered(KMH, b'K') "The same in kilometres an hour.",
    }
    vwt as Vwt = "VWT" b'$' [8] "True wind speed and angle", "NMEA 0183 VWT" {
        angle: sided(RUDDER_SIZE, LR) "True wind angle from the bow, starboard positive.",
        speed_knots: lettered(KNOTS, b'N') "Wind speed.",
        speed_mps: lettered(MPS, b'M') "The same in metres a second.",
        speed_kmh: lettered(KMH, b'K') "The same in kilometres an hour.",
    }
    mta = "MTA" b'$' [2] "Air temperature", "NMEA 0183 MTA" {
        temperature: lettered(CELSIUS, b'C') "Air temperature.",
    }
    mda = "MDA" b'$' [20] "Meteorological composite", "NMEA 0183 MDA" {
        pressure_inches: lettered(INCHES, b'I') "Barometric pressure.",
        pressure_bars: lettered(BARS, b'B') "The same in bars.",
        air: lettered(CELSIUS, b'C') "Air temperature.",
        water: lettered(CELSIUS, b'C') "Water temperature.",
        relative_humidity: number(HUMIDITY) "Relative humidity.",
        absolute_humidity: number(HUMIDITY) "Absolute humidity.",
        dew_point: lettered(CELSIUS, b'C') "Dew point.",
        direction_true: lettered(DIRECTION, b'T') "Wind direction, true.",
        direction_magnetic: lettered(DIRECTION, b'M') "Wind direction, magnetic.",
        speed_knots: lettered(KNOTS, b'N') "Wind speed.",
        speed_mps: lettered(MPS, b'M') "The same in metres a second.",
    }
    dbt as Dbt = "DBT" b'$' [6] "Depth below transducer", "IEC 61162-1 DBT" {
        feet: lettered(FEET, b'f') "Depth in feet.",
        metres: lettered(METRES, b'M') "Depth in metres.",
        fathoms: lettered(FATHOMS, b'F') "Depth in fathoms.",
    }
    dbk = "DBK" b'$' [6] "Depth below keel", "NMEA 0183 DBK" {
        feet: lettered(FEET, b'f') "Depth in feet.",
        metres: lettered(METRES, b'M') "Depth in metres.",
        fathoms: lettered(FATHOMS, b'F') "Depth in fathoms.",
    }
    dbs = "DBS" b'$' [6] "Depth below surface", "NMEA 0183 DBS" {
        feet: lettered(FEET, b'f') "Depth in feet.",
        metres: lettered(METRES, b'M') "Depth in metres.",
        fathoms: lettered(FATHOMS, b'F') "Depth in fathoms.",
    }
    dpt as Dpt = "DPT" b'$' [3, 2] "Depth", "IEC 61162-1 DPT" {
        depth: number(METRES) "Depth below the transducer.",
        offset: number(METRES) "Offset: positive to the water line, negative to the keel.",
        range: number(METRES) "Greatest range of the scale in use.",
    }
    cur = "CUR" b'$' [11] "Water current layer", "IEC 61162-1 CUR" {
        status: code(DataStatus) "Validity of the data.",
        set: integer(whole(0, 9, 1)) "Number of the data set.",
        layer: number(SIZE) "Number of the layer.",
        depth: number(METRES) "Depth of the current.",
        direction: number(DIRECTION) "Direction of the current.",
        direction_reference: code(RelativeReference) "Its reference.",
        speed: number(KNOTS) "Speed of the current.",
        reference_depth: number(METRES) "Depth of the reference layer.",
        heading: number(DIRECTION) "Heading.",
        heading_reference: code(Reference) "Its reference.",
        speed_reference: code(CurrentReference) "Reference of the speed.",
    }
}
