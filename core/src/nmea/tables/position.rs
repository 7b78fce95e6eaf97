//! Position, course and speed over ground, satellites.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};
use crate::nmea::table::{Format, Sides, Unit};
use serde::{Deserialize, Serialize};

const ELEVATION: Format = Format::new(Unit::Degrees, -90, 90, 2, 0);
const AZIMUTH: Format = Format::new(Unit::Degrees, 0, 360, 3, 0);
const SIGNAL: Format = Format::new(Unit::Decibels, 0, 99, 2, 0);

const ZONE_HOURS: Format = Format::new(Unit::Hours, -13, 13, 2, 0);
const ZONE_MINUTES: Format = Format::new(Unit::Minutes, -59, 59, 2, 0);
const ARC_MINUTES: Format = Format::new(Unit::ArcMinutes, 0, i32::MAX, 1, 4);
const NS: Sides = Sides { negative: b'S', positive: b'N' };

codes! {
    /// Quality of a GGA fix.
    FixQuality {
        Invalid = b'0' "not valid", Standard = b'1' "GPS standard positioning", Differential = b'2' "differential GPS",
        Precise = b'3' "GPS precise positioning", RealTimeKinematic = b'4' "real-time kinematic", FloatRtk = b'5' "float RTK",
        Estimated = b'6' "estimated (dead reckoning)", Manual = b'7' "manual input", Simulator = b'8' "simulator",
    }
    /// Navigational status of a receiver.
    NavigationStatus { Safe = b'S' "safe", Caution = b'C' "caution", Unsafe = b'U' "unsafe", NotValid = b'V' "navigational status not valid" }
    /// Selection of 2D and 3D fixes.
    FixSelection { Automatic = b'A' "automatic", Manual = b'M' "manual" }
    /// Dimension of a fix.
    FixDimension { None = b'1' "no fix", Two = b'2' "2D", Three = b'3' "3D" }
    /// How range residuals were calculated.
    ResidualMode { Used = b'0' "used for the position of the matching line", After = b'1' "calculated after the position" }
}

words! {
    ReferenceDatum { "W84" "WGS 84", "W72" "WGS 72", "S85" "SGS 85", "P90" "PE 90" }
}

impl FixQuality {
    /// Whether the position may be used (AP-9).
    #[must_use]
    pub const fn valid(self) -> bool {
        matches!(
            self,
            Self::Standard | Self::Differential | Self::Precise | Self::RealTimeKinematic | Self::FloatRtk
        )
    }
}

sentences! {
    gll as Gll = "GLL" b'$' [7, 6] "Geographic position, latitude/longitude", "IEC 61162-1 GLL; Navis A.19" {
        position: position(5) "Position; from the chart system that of the conning station.",
        time: time() "UTC of the position; not used.",
        status: code(DataStatus) "V makes the sentence count as not received.",
        mode: code(ModeIndicator) "Mode indicator; E, M, S and N are not used.",
    }
    vtg as Vtg = "VTG" b'$' [9, 8] "Course over ground and ground speed", "IEC 61162-1 VTG; Navis A.17; Furuno appendix p. 13" {
        course_true: lettered(DIRECTION, b'T') "Course over ground, true.",
        course_magnetic: lettered(DIRECTION, b'M') "Course over ground, magnetic; not used.",
        speed_knots: lettered(KNOTS, b'N') "Speed over ground; the speed source SOG.",
        speed_kmh: lettered(KMH, b'K') "The same in kilometres an hour; not used.",
        mode: code(ModeIndicator) "Mode indicator; E, M, S and N are not used.",
    }
    gga as Gga = "GGA" b'$' [14] "Global positioning system fix data", "IEC 61162-1 GGA; Navis A.18" {
        time: time() "UTC of the position; not used.",
        position: position(5) "Position of the pivot point.",
        quality: code(FixQuality) "Quality: 1 to 5 are used; 0, 6, 7 and 8 are not.",
        satellites: integer(whole(0, 99, 2)) "Satellites in use; not used.",
        hdop: number(SIZE) "Horizontal dilution of precision; not used.",
        altitude: lettered(METRES, b'M') "Antenna above mean sea level; not used.",
        separation: lettered(METRES, b'M') "Geoidal separation; not used.",
        age: number(SECONDS) "Age of the differential data; not used.",
        station: text(4) "Differential reference station; not used.",
    }
    rmc as Rmc = "RMC" b'$' [13, 12, 11] "Recommended minimum specific GNSS data", "IEC 61162-1 RMC; Furuno appendix p. 10; OpenPlotter interface 1.2.1" {
        time: time() "UTC of the position.",
        status: code(DataStatus) "V makes the sentence count as not received.",
        position: position(5) "Position.",
        speed: number(KNOTS) "Speed over ground.",
        course: number(DIRECTION) "Course over ground, true.",
        date: date() "Date.",
        variation: sided(DEVIATION, EW) "Variation, east positive; null is not zero.",
        mode: code(ModeIndicator) "Mode indicator, since NMEA 2.3; E, M, S and N are not used.",
        safety: code(NavigationStatus) "Navigational status, since NMEA 4.1.",
    }
    zda as Zda = "ZDA" b'$' [6] "Time and date", "IEC 61162-1 ZDA; Furuno appendix p. 13" {
        time: time() "UTC.",
        day: integer(whole(1, 31, 2)) "Day.",
        month: integer(whole(1, 12, 2)) "Month.",
        year: integer(whole(0, 9999, 4)) "Year.",
        zone_hours: number(ZONE_HOURS) "Hours of the local zone; not used.",
        zone_minutes: number(ZONE_MINUTES) "Minutes of the local zone; not used.",
    }
    gns as Gns = "GNS" b'$' [13, 12] "GNSS fix data", "IEC 61162-1 GNS" {
        time: time() "UTC of the position.",
        position: position(5) "Position.",
        modes: letters(ModeIndicator, 8) "Mode indicator of each system: GPS, GLONASS, Galileo and further ones.",
        satellites: integer(whole(0, 99, 2)) "Satellites in use.",
        hdop: number(SIZE) "Horizontal dilution of precision.",
        altitude: number(METRES) "Antenna above mean sea level.",
        separation: number(METRES) "Geoidal separation.",
        age: number(SECONDS) "Age of the differential data.",
        station: text(4) "Differential reference station.",
        safety: code(NavigationStatus) "Navigational status.",
    }
    gsa = "GSA" b'$' [] "GNSS DOP and active satellites", "IEC 61162-1 GSA" {
        selection: code(FixSelection) "Selection of 2D and 3D.",
        fix: code(FixDimension) "Fix.";
        each UpTo(12) GsaSatellite satellites {
            id: integer(whole(1, 999, 2)) "Satellite used.",
        };
        tail {
            pdop: number(SIZE) "Position dilution of precision.",
            hdop: number(SIZE) "Horizontal dilution of precision.",
            vdop: number(SIZE) "Vertical dilution of precision.",
            system: hex(1) "System, since NMEA 4.10.",
        }
    }
    gst = "GST" b'$' [8] "GNSS pseudorange error statistics", "IEC 61162-1 GST" {
        time: time() "UTC of the position.",
        rms: number(SIZE) "Standard deviation of the ranges.",
        major: number(METRES) "Semi-major axis of the error ellipse.",
        minor: number(METRES) "Semi-minor axis of the error ellipse.",
        orientation: number(DIRECTION) "Orientation of the semi-major axis.",
        latitude_error: number(METRES) "Standard deviation of the latitude.",
        longitude_error: number(METRES) "Standard deviation of the longitude.",
        altitude_error: number(METRES) "Standard deviation of the altitude.",
    }
    gbs = "GBS" b'$' [10, 8] "GNSS satellite fault detection", "IEC 61162-1 GBS" {
        time: time() "UTC of the position.",
        latitude_error: number(METRES) "Expected error in latitude.",
        longitude_error: number(METRES) "Expected error in longitude.",
        altitude_error: number(METRES) "Expected error in altitude.",
        satellite: integer(whole(1, 999, 2)) "Satellite that most likely failed.",
        probability: number(SIZE) "Probability of missing it.",
        bias: number(METRES) "Estimate of its bias.",
        deviation: number(SIZE) "Standard deviation of the bias.",
        system: hex(1) "System, since NMEA 4.10.",
        signal: hex(1) "Signal, since NMEA 4.10.",
    }
    grs = "GRS" b'$' [] "GNSS range residuals", "IEC 61162-1 GRS" {
        time: time() "UTC of the position.",
        mode: code(ResidualMode) "How the residuals were calculated.";
        each UpTo(12) GrsResidual residuals {
            residual: number(METRES) "Range residual.",
        };
        tail {
            system: hex(1) "System, since NMEA 4.10.",
            signal: hex(1) "Signal, since NMEA 4.10.",
        }
    }
    dtm = "DTM" b'$' [8] "Datum reference", "IEC 61162-1 DTM" {
        datum: text(3) "Local datum: W84, W72, S85, P90, 999 or another.",
        subdivision: text(1) "Subdivision of the local datum.",
        latitude_offset: sided(ARC_MINUTES, NS) "Offset of the latitude, north positive.",
        longitude_offset: sided(ARC_MINUTES, EW) "Offset of the longitude, east positive.",
        altitude_offset: number(METRES) "Offset of the altitude.",
        reference: words(ReferenceDatum) "Reference datum.",
    }
    rma = "RMA" b'$' [11] "Recommended minimum specific LORAN-C data", "IEC 61162-1 RMA" {
        status: code(DataStatus) "Status.",
        position: position(4) "Position.",
        difference_a: number(BARE) "Time difference A, microseconds.",
        difference_b: number(BARE) "Time difference B, microseconds.",
        speed: number(KNOTS) "Speed over ground.",
        course: number(DIRECTION) "Course over ground.",
        variation: sided(DEVIATION, EW) "Variation.",
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
    gdc = "GDC" b'$' [10] "GNSS differential correction", "IEC 61162-1 GDC, as SwiftNMEA reads it" {
        total: integer(whole(1, 99, 1)) "Number of sentences of this message.",
        number: integer(whole(1, 99, 1)) "Number of this sentence.",
        satellites: integer(whole(0, 99, 1)) "Satellites with a correction.",
        satellite: integer(whole(1, 999, 1)) "Satellite; its system is the talker.",
        correction: number(METRES) "Correction of the range.",
        issue: integer(whole(0, 999, 1)) "Issue of the data.",
        epoch: integer(whole(0, 604_800, 1)) "Time of the ephemeris, seconds.",
        z_count: number(SECONDS) "Modified Z-count.",
        range_error: number(METRES) "User differential range error.",
        signal: hex(1) "Signal.",
    }
    gfa = "GFA" b'$' [9] "GNSS fix accuracy and integrity", "IEC 61162-1 GFA, as SwiftNMEA reads it" {
        time: time() "UTC of the position.",
        horizontal_limit: number(METRES) "Horizontal protection level.",
        vertical_limit: number(METRES) "Vertical protection level.",
        major: number(METRES) "Semi-major axis of the error ellipse, standard deviation.",
        minor: number(METRES) "Semi-minor axis of the error ellipse, standard deviation.",
        orientation: number(DIRECTION) "Orientation of the semi-major axis.",
        altitude_error: number(METRES) "Standard deviation of the altitude.",
        accuracy: number(METRES) "Selected accuracy level.",
        integrity: letters(NavigationStatus, 3) "A letter each for RAIM, SBAS and Galileo; V where it is not in use.",
    }
}
