//! Position, course and speed over ground, satellites.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::table::{Format, Unit, definition, kind, meanings, sentences, view, view_type};

const ELEVATION: Format = Format::new(Unit::Degrees, -90, 90, 2, 0);
const AZIMUTH: Format = Format::new(Unit::Degrees, 0, 360, 3, 0);
const SIGNAL: Format = Format::new(Unit::Decibels, 0, 99, 2, 0);

sentences! {
    gll as Gll = "GLL" b'$' [7, 6] "Geographic position, latitude/longitude", "IEC 61162-1 GLL; Navis A.19" {
        position: position(5) "Position; from the chart system that of the conning station.",
        time: time() "UTC of the position; not used.",
        status: code(DataStatus) "V makes the sentence count as not received.",
        mode: code(ModeIndicator) "Mode indicator; E, M, S and N are not used.",
    }
    vtg as Vtg = "VTG" b'$' [9, 8] "Course over ground and ground speed", "IEC 61162-1 VTG; Navis A.17; Furuno AP-13" {
        course_true: lettered(DIRECTION, b'T') "Course over ground, true.",
        course_magnetic: lettered(DIRECTION, b'M') "Course over ground, magnetic; not used.",
        speed_knots: lettered(KNOTS, b'N') "Speed over ground; the speed source SOG.",
        speed_kmh: lettered(KMH, b'K') "The same in kilometres an hour; not used.",
        mode: code(ModeIndicator) "Mode indicator; E, M, S and N are not used.",
    }
    gsv as Gsv = "GSV" b'$' [] "GNSS satellites in view", "IEC 61162-1 GSV" {
        total: integer(whole(1, 9, 1)) "Number of sentences of this message.",
        number: integer(whole(1, 9, 1)) "Number of this sentence.",
        in_view: integer(whole(0, 999, 2)) "Satellites in view.";
        each UpTo(4) GsvSatellite satellites {
            id: integer(whole(1, 999, 2)) "Satellite.",
            elevation: number(ELEVATION) "Elevation.",
            azimuth: number(AZIMUTH) "Azimuth, true.",
            signal: number(SIGNAL) "Carrier to noise ratio; null when not tracked.",
        };
        tail {
            signal_id: hex(1) "Signal, since NMEA 4.10.",
        }
    }
}
