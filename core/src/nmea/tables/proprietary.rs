//! Proprietary sentences with a sub-address, and queries.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::table::{definition, kind, meanings, sentences, view, view_type};

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
}
