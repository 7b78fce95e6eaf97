//! Waypoints, routes, bearings, distances and times.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};
use crate::nmea::table::{Format, Unit};
use serde::{Deserialize, Serialize};

codes! {
    /// Which route is transferred.
    TransferKind { Monitored = b'M' "monitored route", Alternate = b'A' "alternate route for editing", Query = b'Q' "query for any route" }
    /// Reception of a route file.
    TransferFile { Received = b'A' "received", Error = b'E' "error in the reception" }
    /// What became of a transferred route.
    TransferApplication {
        Accepted = b'A' "accepted and valid", Rejected = b'V' "rejected", Pending = b'P' "not yet evaluated", NotApplicable = b'N' "not applicable",
    }
    /// Result of an integrity check.
    Integrity { Passed = b'P' "passed", Failed = b'F' "failed", Doubtful = b'D' "doubtful, no check possible", NotAvailable = b'N' "not available" }
    /// Result of a plausibility check.
    Plausibility { Plausible = b'A' "plausible", NotPlausible = b'V' "not plausible", NotAvailable = b'N' "not available" }
    /// How a speed through water is known.
    WaterSpeedMode { Measured = b'W' "measured, water reference", Estimated = b'E' "estimated from other sources", Manual = b'M' "manual input", NotAvailable = b'N' "not available" }
    /// What an RTE lists.
    RouteMode { Complete = b'c' "complete route", Working = b'w' "working route" }
    /// Kind of a variable point.
    PointKind { Collision = b'C' "collision", Turning = b'T' "turning point", Reference = b'R' "reference", Wheelover = b'W' "wheel-over" }
}

words! {
    /// What a selection is of.
    SelectedData {
        "POS" "position", "SOG" "speed and course over ground", "STW" "speed through water", "DEP" "depth below keel", "HEA" "heading", "TIM" "time",
    }
}

const KILOMETRES: Format = Format::new(Unit::Kilometres, 0, i32::MAX, 1, 3);

sentences! {
    bod as Bod = "BOD" b'$' [6] "Bearing origin to destination", "IEC 61162-1 BOD; OpenPlotter interface 1.2" {
        bearing_true: lettered(DIRECTION, b'T') "Bearing from origin to destination, true.",
        bearing_magnetic: lettered(DIRECTION, b'M') "The same, magnetic.",
        destination: text(20) "Destination waypoint.",
        origin: text(20) "Origin waypoint.",
    }
    bww = "BWW" b'$' [6] "Bearing waypoint to waypoint", "IEC 61162-1 BWW" {
        bearing_true: lettered(DIRECTION, b'T') "Bearing, true.",
        bearing_magnetic: lettered(DIRECTION, b'M') "Bearing, magnetic.",
        to: text(20) "To waypoint.",
        from: text(20) "From waypoint.",
    }
    bwc as Bwc = "BWC" b'$' [13, 12] "Bearing and distance to waypoint, great circle", "IEC 61162-1 BWC; Navis A.1" {
        time: time() "UTC of the observation.",
        position: position(4) "Position of the waypoint.",
        bearing_true: lettered(DIRECTION, b'T') "Bearing, true.",
        bearing_magnetic: lettered(DIRECTION, b'M') "Bearing, magnetic.",
        distance: lettered(MILES, b'N') "Distance; shown in TRACK.",
        waypoint: text(20) "Waypoint.",
        mode: code(ModeIndicator) "Mode indicator.",
    }
    bwr as Bwr = "BWR" b'$' [13, 12] "Bearing and distance to waypoint, rhumb line", "IEC 61162-1 BWR; Navis A.1" {
        time: time() "UTC of the observation.",
        position: position(4) "Position of the waypoint.",
        bearing_true: lettered(DIRECTION, b'T') "Bearing, true.",
        bearing_magnetic: lettered(DIRECTION, b'M') "Bearing, magnetic.",
        distance: lettered(MILES, b'N') "Distance; shown in TRACK.",
        waypoint: text(20) "Waypoint.",
        mode: code(ModeIndicator) "Mode indicator.",
    }
    bec = "BEC" b'$' [12] "Bearing and distance to waypoint, dead reckoning", "IEC 61162-1 BEC" {
        time: time() "UTC of the observation.",
        position: position(4) "Position of the waypoint.",
        bearing_true: lettered(DIRECTION, b'T') "Bearing, true.",
        bearing_magnetic: lettered(DIRECTION, b'M') "Bearing, magnetic.",
        distance: lettered(MILES, b'N') "Distance.",
        waypoint: text(20) "Waypoint.",
    }
    rmb as Rmb = "RMB" b'$' [14, 13] "Recommended minimum navigation information", "IEC 61162-1 RMB; OpenPlotter interface 1.2" {
        status: code(DataStatus) "Status.",
        cross_track: sided(CROSS, STEER_TO) "Cross-track distance and the side to steer to; positive where the ship is right of the track.",
        origin: text(20) "Origin waypoint.",
        destination: text(20) "Destination waypoint.",
        position: position(4) "Position of the destination.",
        range: number(MILES) "Range to the destination.",
        bearing: number(DIRECTION) "Bearing to the destination, true.",
        closing: number(SPEED_THROUGH) "Closing velocity.",
        arrival: code(Arrival) "Arrival.",
        mode: code(ModeIndicator) "Mode indicator.",
    }
    wpl as Wpl = "WPL" b'$' [5] "Waypoint location", "IEC 61162-1 WPL; OpenPlotter interface 1.2" {
        position: position(4) "Position.",
        waypoint: text(20) "Waypoint.",
    }
    rte as Rte = "RTE" b'$' [] "Routes", "IEC 61162-1 RTE; OpenPlotter interface 1.2" {
        total: integer(whole(1, 999, 1)) "Number of sentences of this route.",
        number: integer(whole(1, 999, 1)) "Number of this sentence.",
        mode: code(RouteMode) "Complete route, or the part that is still to be sailed.",
        route: text(20) "Route.";
        each Open() RteWaypoint waypoints {
            waypoint: text(20) "Waypoint.",
        }
    }
    aam = "AAM" b'$' [5] "Waypoint arrival alarm", "IEC 61162-1 AAM" {
        arrival: code(Arrival) "Arrival circle.",
        passed: code(Arrival) "Perpendicular.",
        radius: lettered(MILES, b'N') "Radius of the arrival circle.",
        waypoint: text(20) "Waypoint.",
    }
    apa = "APA" b'$' [10] "Autopilot sentence A", "NMEA 0183 APA" {
        status: code(DataStatus) "General warning.",
        cycle_lock: code(DataStatus) "Loran-C cycle lock.",
        cross_track: sided(CROSS, STEER_TO) "Cross-track distance; positive where the ship is right of the track.",
        cross_track_unit: code(DistanceUnit) "Its unit.",
        arrival: code(Arrival) "Arrival circle.",
        passed: code(Arrival) "Perpendicular.",
        bearing: number(DIRECTION) "Bearing from origin to destination.",
        bearing_reference: code(Reference) "Its reference.",
        waypoint: text(20) "Destination waypoint.",
    }
    xtr = "XTR" b'$' [3] "Cross-track error, dead reckoning", "IEC 61162-1 XTR" {
        cross_track: crossed(CROSS, STEER_TO, b'N') "Cross-track distance; positive where the ship is right of the track.",
    }
    wcv = "WCV" b'$' [4, 3] "Waypoint closure velocity", "IEC 61162-1 WCV" {
        velocity: lettered(SPEED_THROUGH, b'N') "Velocity towards the waypoint.",
        waypoint: text(20) "Waypoint.",
        mode: code(ModeIndicator) "Mode indicator.",
    }
    wnc = "WNC" b'$' [6] "Distance waypoint to waypoint", "IEC 61162-1 WNC" {
        distance_miles: lettered(MILES, b'N') "Distance.",
        distance_kilometres: lettered(KILOMETRES, b'K') "The same in kilometres.",
        to: text(20) "To waypoint.",
        from: text(20) "From waypoint.",
    }
    zdl = "ZDL" b'$' [3] "Time and distance to variable point", "IEC 61162-1 ZDL" {
        remaining: text(9) "Time to the point, hhmmss.ss.",
        distance: number(MILES) "Distance to the point.",
        point: code(PointKind) "Kind of the point.",
    }
    zfo = "ZFO" b'$' [3] "UTC and time from origin waypoint", "IEC 61162-1 ZFO" {
        time: time() "UTC of the observation.",
        elapsed: text(9) "Time since the origin, hhmmss.ss.",
        origin: text(20) "Origin waypoint.",
    }
    ztg = "ZTG" b'$' [3] "UTC and time to destination waypoint", "IEC 61162-1 ZTG" {
        time: time() "UTC of the observation.",
        remaining: text(9) "Time to the destination, hhmmss.ss.",
        destination: text(20) "Destination waypoint.",
    }
    rrt = "RRT" b'$' [6] "Report route transfer", "IEC 61162-1 RRT, as SwiftNMEA reads it" {
        kind: code(TransferKind) "Which route.",
        name: text(40) "Name of the route.",
        version: text(20) "Version of the route.",
        waypoint: text(20) "Present waypoint.",
        file: code(TransferFile) "Whether the file came.",
        application: code(TransferApplication) "What became of it.",
    }
    sel = "SEL" b'$' [] "Selection report", "IEC 61162-1 SEL, as SwiftNMEA reads it" {
        ; each Open() SelSelection selections {
            kind: words(SelectedData) "Kind of data.",
            source: text(6) "System function identifier of the sensor in use; null: who sends.",
        }
    }
    nsr = "NSR" b'$' [13] "Navigation status report", "IEC 61162-1 NSR, as SwiftNMEA reads it" {
        heading_integrity: code(Integrity) "Integrity of the heading.",
        heading_plausibility: code(Plausibility) "Plausibility of the heading.",
        position_integrity: code(Integrity) "Integrity of the position.",
        position_plausibility: code(Plausibility) "Plausibility of the position.",
        water_speed_integrity: code(Integrity) "Integrity of the speed through water.",
        water_speed_plausibility: code(Plausibility) "Plausibility of the speed through water.",
        ground_speed_integrity: code(Integrity) "Integrity of speed and course over ground.",
        ground_speed_plausibility: code(Plausibility) "Plausibility of speed and course over ground.",
        depth_integrity: code(Integrity) "Integrity of the depth.",
        depth_plausibility: code(Plausibility) "Plausibility of the depth.",
        water_speed_mode: code(WaterSpeedMode) "How the speed through water is known.",
        time_integrity: code(Integrity) "Integrity of the time.",
        time_plausibility: code(Plausibility) "Plausibility of the time.",
    }
}
