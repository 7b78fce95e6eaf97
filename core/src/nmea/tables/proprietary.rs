//! Proprietary sentences with a sub-address, and queries.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};
use crate::nmea::table::{Format, Unit};
use serde::{Deserialize, Serialize};

codes! {
    /// Change of the rudder by the hand unit.
    RudderChange {
        Increment = b'i' "1 position unit more", IncrementTen = b'I' "10 position units more", Reduce = b'r' "1 position unit less", ReduceTen = b'R' "10 position units less",
    }
    /// Change of the course by the hand unit.
    CourseChange {
        Increment = b'i' "1 position unit more", IncrementTen = b'I' "10 position units more", Reduce = b'r' "1 position unit less", ReduceTen = b'R' "10 position units less",
        TackPort = b'P' "tack 100 degrees to port", TackStarboard = b'S' "tack 100 degrees to starboard",
    }
    /// Side of the installation.
    InstallationSide { Starboard = b'S' "starboard", Port = b'P' "port" }
    /// Deadband of the small-craft controller.
    Deadband { Least = b'm' "least", Greatest = b'M' "greatest", Automatic = b'A' "automatic" }
    /// Mode of the small-craft autopilot.
    SmallCraftMode { Standby = b'S' "STAND-BY", Auto = b'A' "AUTO", Track = b'T' "TRACK", Calibration = b'C' "calibrating" }
    /// What the hand unit asks for.
    InformationRequest { Installation = b'I' "installation parameters (03)", Gains = b'G' "gains (05)", Information = b'A' "autopilot information (07)" }
    /// What is calibrated.
    CalibrationPart { All = b'-' "all", Gyro = b'G' "gyroscope", Accelerometer = b'A' "accelerometer", Magnetometer = b'M' "magnetometer" }
    /// What is saved.
    SaveRequest {
        Installation = b'I' "save installation and feedback", Gains = b'G' "save gains", Offsets = b'C' "save IMU offsets", Restore = b'R' "restore defaults",
    }
    /// State of a calibration; the handbook gives letters without words.
    CalibrationState { NotStarted = b'-' "not started", O = b'O' "state O", R = b'R' "state R", N = b'N' "state N", C = b'C' "state C, with Euler angles" }
    /// Service command.
    ServiceCommand { Event = b'E' "event", Loop = b'F' "loop frequency", Reset = b'R' "reset the memory", Telemetry = b'T' "telemetry" }
}

const ANY_ANGLE: Format = Format::new(Unit::Degrees, -i32::MAX, i32::MAX, 1, 1);
const WHOLE_ANGLE: Format = Format::new(Unit::Degrees, 0, i32::MAX, 1, 0);
const CRUISE_SPEED: Format = Format::new(Unit::Knots, 0, i32::MAX, 1, 0);
const SAMPLE_TIME: Format = Format::new(Unit::Milliseconds, 0, 999_999, 1, 0);
const INSTALLED: Format = Format::new(Unit::None, -i32::MAX, i32::MAX, 1, 0);
const GAIN: Format = Format::new(Unit::None, -i32::MAX, i32::MAX, 1, 3);
const RUDDER_WHOLE: Format = Format::new(Unit::Degrees, -180, 180, 1, 0);
const HUNDREDTHS: Format = Format::new(Unit::Degrees, 0, 360, 1, 2);
const DEADBAND_VALUE: Format = Format::new(Unit::None, 0, i32::MAX, 1, 0);
const TRIM: Format = Format::new(Unit::Degrees, -i32::MAX, i32::MAX, 1, 2);

// EMC-1: the numbers and forms of the document. EMC-4: what later firmware adds is understood, the document's forms are sent.
sentences! {
    query = "Q" b'$' [1] "Query", "IEC 61162-1 query sentence" {
        formatter: text(3) "The sentence that is asked for.",
    }
    pney1 as Pney1 = "PNEY,001" b'$' [7] "Cross-track distance for control", "Navis A.22" {
        status: code(DataStatus) "Status of the position: V makes the sentence count as not received.",
        cycle_lock: code(DataStatus) "Loran-C cycle lock; always A.",
        cross_track: crossed(CROSS, STEER_TO, b'N') "Cross-track distance for control and the side to steer to; positive where the ship is right of the track (L on the wire). On the arc it refers to the next leg. Null without a route.",
        mode: code(ModeIndicator) "Mode indicator of the position.",
    }
    pney2 as Pney2 = "PNEY,002" b'$' [6] "Radius centre and waypoint", "Navis A.23" {
        centre: position(4) "Centre of the radius of turn; null on a leg.",
        waypoint: text(20) "Waypoint; displays show its first three characters. Null without a route.",
    }
    pemc00 as Pemc00 = "PEMC,00" b'$' [1] "Switch between STAND-BY and AUTO", "EMACUA System Interfaces" {}
    pemc01 as Pemc01 = "PEMC,01" b'$' [2] "Change current rudder", "EMACUA System Interfaces" {
        rate: code(RudderChange) "By how many degrees of rudder; acts in STAND-BY.",
    }
    pemc02 as Pemc02 = "PEMC,02" b'$' [2] "Change course to steer", "EMACUA System Interfaces; Fenix handbook" {
        rate: code(CourseChange) "By how many degrees of course; acts in AUTO and TRACK.",
    }
    pemc03 as Pemc03 = "PEMC,03" b'$' [9] "Installation parameters (reply)", "EMACUA System Interfaces" {
        tiller: number(INSTALLED) "Position of the centred tiller.",
        max_rudder: number(WHOLE_ANGLE) "Largest rudder angle.",
        cruise_speed: number(CRUISE_SPEED) "Average cruise speed.",
        side: code(InstallationSide) "Side of the installation.",
        damping: number(COUNT) "Rudder damping.",
        variation: number(ANY_ANGLE) "Magnetic variation, east positive.",
        alignment: number(ANY_ANGLE) "Heading alignment.",
        off_course: number(WHOLE_ANGLE) "Off-course alarm angle.",
    }
    pemc04 as Pemc04 = "PEMC,04" b'$' [9] "Set installation parameters; an empty field leaves its value", "EMACUA System Interfaces" {
        tiller: number(INSTALLED) "Position of the centred tiller.",
        max_rudder: number(WHOLE_ANGLE) "Largest rudder angle.",
        cruise_speed: number(CRUISE_SPEED) "Average cruise speed.",
        side: code(InstallationSide) "Side of the installation.",
        damping: number(COUNT) "Rudder damping.",
        variation: number(ANY_ANGLE) "Magnetic variation, east positive.",
        alignment: number(ANY_ANGLE) "Heading alignment.",
        off_course: number(WHOLE_ANGLE) "Off-course alarm angle.",
    }
    pemc05 as Pemc05 = "PEMC,05" b'$' [6] "PID gains (reply)", "EMACUA System Interfaces" {
        kp: number(GAIN) "Proportional gain.",
        ki: number(GAIN) "Integral gain.",
        kd: number(GAIN) "Derivative gain.",
        sample_time: integer(SAMPLE_TIME) "Sample time; 100 to 5000 in whole control steps.",
        deadband: code(Deadband) "Deadband: m smallest, M largest, A automatic.",
    }
    pemc06 as Pemc06 = "PEMC,06" b'$' [6, 5] "Set PID gains; an empty field leaves its value", "EMACUA System Interfaces" {
        kp: number(GAIN) "Proportional gain.",
        ki: number(GAIN) "Integral gain.",
        kd: number(GAIN) "Derivative gain.",
        sample_time: integer(SAMPLE_TIME) "Sample time; 100 to 5000 in whole control steps.",
        deadband: code(Deadband) "Deadband: m smallest, M largest, A automatic.",
    }
    pemc07 as Pemc07 = "PEMC,07" b'$' [7] "Autopilot information (reply)", "EMACUA System Interfaces; Fenix handbook" {
        mode: code(SmallCraftMode) "Mode.",
        rudder: number(RUDDER_WHOLE) "Current rudder, degrees.",
        heading: number(HUNDREDTHS) "Heading, magnetic (true in later firmware).",
        course_to_steer: number(HUNDREDTHS) "Course to steer, magnetic.",
        deadband: number(DEADBAND_VALUE) "Deadband value.",
        trim: number(TRIM) "Trim.",
    }
    pemc08 as Pemc08 = "PEMC,08" b'$' [2] "Request information", "EMACUA System Interfaces" {
        request: code(InformationRequest) "What is asked for.",
    }
    pemc09 as Pemc09 = "PEMC,09" b'$' [1, 2] "Enter or leave IMU calibration", "EMACUA System Interfaces; Fenix handbook" {
        part: code(CalibrationPart) "What is calibrated, in later firmware.",
    }
    pemc10 as Pemc10 = "PEMC,10" b'$' [1] "Enter or leave feedback calibration", "EMACUA System Interfaces" {}
    pemc11 as Pemc11 = "PEMC,11" b'$' [2] "Save values", "EMACUA System Interfaces" {
        what: code(SaveRequest) "What is saved or restored.",
    }
    pemc12 = "PEMC,12" b'$' [6, 9, 2] "IMU calibration state", "Fenix handbook" {
        state: code(CalibrationState) "State.",
        system: integer(whole(0, 1, 1)) "First flag.",
        gyro: integer(whole(0, 1, 1)) "Second flag.",
        accelerometer: integer(whole(0, 1, 1)) "Third flag.",
        magnetometer: integer(whole(0, 1, 1)) "Fourth flag.",
        euler_1: number(ANY_ANGLE) "First Euler angle; only in state C.",
        euler_2: number(ANY_ANGLE) "Second Euler angle.",
        euler_3: number(ANY_ANGLE) "Third Euler angle.",
    }
    pemc13 = "PEMC,13" b'$' [3] "Rudder feedback range", "Fenix handbook" {
        least: number(BARE) "Least feedback.",
        greatest: number(BARE) "Greatest feedback.",
    }
    pemc14 = "PEMC,14" b'$' [14] "Calibration numbers; longer than 82 characters, never sent", "Fenix handbook" {
        number_1: number(BARE) "Calibration number 1.",
        number_2: number(BARE) "Calibration number 2.",
        number_3: number(BARE) "Calibration number 3.",
        number_4: number(BARE) "Calibration number 4.",
        number_5: number(BARE) "Calibration number 5.",
        number_6: number(BARE) "Calibration number 6.",
        number_7: number(BARE) "Calibration number 7.",
        number_8: number(BARE) "Calibration number 8.",
        number_9: number(BARE) "Calibration number 9.",
        number_10: number(BARE) "Calibration number 10.",
        number_11: number(BARE) "Calibration number 11.",
        number_12: number(BARE) "Calibration number 12.",
        sensor: text(1) "Sensor.",
    }
    pemc99 = "PEMC,99" b'$' [2] "Service command", "Fenix handbook" {
        command: code(ServiceCommand) "What is done.",
    }
}
