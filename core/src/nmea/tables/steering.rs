//! Heading and track control, rudder and rudder order.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};


// HTC-2: the notes of both speak of F1's notes 1 to 7 in our own words.
sentences! {
    htc as Htc = "HTC" b'$' [14, 13] "Heading/track control command", "IEC 61162-1 HTC; Navis A.20; Furuno RD-50 appendix p. 9" {
        override_status: code(OverrideStatus) "Override: while in use, steering is done by special devices for a time, both modes are ignored and the controller computes as in manual steering; the autopilot goes to STANDBY at once and resumes only by the operator.",
        rudder_angle: sided(RUDDER_SIZE, LR) "Commanded rudder angle, for rudder control only; shown, not used in AutoNAV.",
        steering_mode: code(SteeringMode) "Selected steering mode, by a selector switch or by an earlier HTC; which of them goes first, and which fields are used, each maker states (here: NFU, operator, hand unit, HTC, HSC, APB). M: the main steering system steers. S: works as a stand-alone heading controller, takes no heading to steer from outside. H (Tn): takes the heading to steer from an external device, as a remotely controlled heading controller. T (Ti): corrects the course of the commanded track by the track errors that it receives, from XTE or APB. R: takes rudder angle and side from an external device and steers by the same electronic means as S, H and T; never obeyed from outside here.",
        turn_mode: code(TurnMode) "How the heading changes in modes S, H and T: by the radius (R, throughout Ti) or by the rate of turn (T, in turns of Tn) that is given; with N turns are not controlled and only the ship's manoeuvrability and the rudder angles applied decide.",
        rudder_limit: number(LIMIT) "Commanded rudder limit, unsigned; shown, not used in AutoNAV.",
        off_heading_limit: number(LIMIT) "Commanded off-heading limit, unsigned; shown, not used in AutoNAV.",
        radius: number(MILES) "Commanded radius of turn; in Ti present from wheel-over to the end of the turn, and steered.",
        rate_of_turn: number(RATE_SIZE) "Commanded rate of turn; steered in Tn with turn mode T, ignored with N.",
        heading_to_steer: number(DIRECTION) "Commanded heading to steer, in the heading reference in use; steered in Tn, where it equals the commanded track during turns.",
        off_track_limit: number(MILES) "Commanded off-track limit, unsigned; belongs to mode T. Reserved: accepted and shown.",
        track: number(DIRECTION) "Commanded track: the course of the leg between two waypoints, in the heading reference in use; may be altered during a turn along a planned radius.",
        reference: code(Reference) "Heading reference in use; null or the autopilot's own is accepted, another refuses the sentence.",
        status: code(CommandStatus) "Sentence status: only C is a command; R reports present settings, as the answer to a query. It should not be null: null counts as a command only where the port accepts it.",
    }
    htd as Htd = "HTD" b'$' [17] "Heading/track control data", "IEC 61162-1 HTD; Navis A.4; Furuno RD-50 appendix p. 9" {
        override_status: code(OverrideStatus) "Override: steering is done by special devices for a time and both modes are to be ignored; in use only while the hardware override (NFU) steers.",
        rudder_angle: sided(RUDDER_SIZE, LR) "Commanded rudder angle: the autopilot's rudder order.",
        steering_mode: code(SteeringMode) "Steering mode: M STANDBY, S AUTO, H AutoNAV Tn, T AutoNAV Ti or TRACK, R rudder control; null in the installation menu.",
        turn_mode: code(TurnMode) "Turn mode: R in turns of Ti, T in turns of Tn, N on legs and in AUTO.",
        rudder_limit: number(LIMIT) "Rudder limit in force; in AutoNAV the maximum rudder angle.",
        off_heading_limit: number(LIMIT) "Off-heading limit.",
        radius: number(MILES) "Radius of turn in use; in Ti the last accepted one.",
        rate_of_turn: number(RATE_SIZE) "Rate of turn in use.",
        heading_to_steer: number(DIRECTION) "Heading to steer, in the heading reference in use: in Ti the autopilot's own, in Tn the commanded one.",
        off_track_limit: number(MILES) "Off-track limit; not used.",
        track: number(DIRECTION) "Commanded track, the course of the leg between two waypoints, in the heading reference in use; may be altered during a turn along a planned radius. Null in AUTO.",
        reference: code(Reference) "Heading reference of the master compass.",
        rudder_status: code(LimitStatus) "V when the rudder order is at its limit.",
        off_heading_status: code(LimitStatus) "V when the heading is farther from the set one than the off-heading limit.",
        off_track_status: code(LimitStatus) "Off-track status, which only mode T can give; not used.",
        heading: number(DIRECTION) "Vessel heading of the master compass.",
    }
    xte as Xte = "XTE" b'$' [6, 5] "Cross-track error, measured", "IEC 61162-1 XTE; Navis A.21" {
        status: code(DataStatus) "Status of the position: V makes the sentence count as not received.",
        cycle_lock: code(DataStatus) "Loran-C cycle lock; always A.",
        cross_track: crossed(CROSS, STEER_TO, b'N') "Cross-track distance and the side to steer to; positive where the ship is right of the track (L on the wire). Null without a route. For display: leg, or the arc in a turn.",
        mode: code(ModeIndicator) "Mode indicator of the position; E, M, S and N are not used.",
    }
    hsc as Hsc = "HSC" b'$' [4, 5] "Heading steering command", "IEC 61162-1 HSC; Navis A.1" {
        heading_true: lettered(DIRECTION, b'T') "Commanded true heading; an alternative source of the heading to steer in Tn.",
        heading_magnetic: lettered(DIRECTION, b'M') "Commanded magnetic heading.",
        status: code(CommandStatus) "Sentence status, since the edition of 2024.",
    }
    apb as Apb = "APB" b'$' [15, 14] "Heading/track controller (autopilot) sentence B", "IEC 61162-1 APB; OpenPlotter interface 1.2.2" {
        status: code(DataStatus) "General warning: V when no reliable fix is available; ends TRACK.",
        cycle_lock: code(DataStatus) "Loran-C cycle lock: A in order or not used; V ends TRACK.",
        cross_track: sided(CROSS, STEER_TO) "Cross-track distance and the side to steer to; positive where the ship is right of the track (L on the wire).",
        cross_track_unit: code(DistanceUnit) "Unit of the cross-track distance; the standard has only N.",
        arrival: code(Arrival) "A: the arrival circle is entered; a caution in TRACK.",
        passed: code(Arrival) "A: the perpendicular at the waypoint is passed; a caution in TRACK.",
        bearing_origin: number(DIRECTION) "Bearing from origin to destination: the leg's course.",
        bearing_origin_reference: code(Reference) "Its reference.",
        waypoint: text(20) "Destination waypoint; the next leg is taken only with a new one.",
        bearing_present: number(DIRECTION) "Bearing from the present position to the destination.",
        bearing_present_reference: code(Reference) "Its reference.",
        heading_to_steer: number(DIRECTION) "Heading to steer to the destination; steered in TRACK where present.",
        heading_to_steer_reference: code(Reference) "Its reference.",
        mode: code(ModeIndicator) "Mode indicator of the position.",
    }
    rsa as Rsa = "RSA" b'$' [4, 8] "Rudder sensor angle", "IEC 61162-1 RSA; Navis A.2; EMACUA System Interfaces" {
        starboard: number(RUDDER) "Starboard or single rudder, starboard positive.",
        starboard_status: code(DataStatus) "V on a feedback failure.",
        port: number(RUDDER) "Port rudder, starboard positive; null with a single rudder.",
        port_status: code(DataStatus) "V on a feedback failure or with a single rudder.";
        later {
            centre: number(RUDDER) "Centre rudder, since the edition of 2024.",
            centre_status: code(DataStatus) "Its status.",
            bow: number(RUDDER) "Bow rudder, since the edition of 2024.",
            bow_status: code(DataStatus) "Its status.",
        }
    }
    ror as Ror = "ROR" b'$' [5, 9] "Rudder order status", "IEC 61162-1 ROR; Navis A.3; Furuno FMD-3100 appendix p. 13" {
        starboard: number(RUDDER) "Starboard or single rudder order, starboard positive.",
        starboard_status: code(DataStatus) "Its status.",
        port: number(RUDDER) "Port rudder order; null with a single rudder.",
        port_status: code(DataStatus) "Its status; V with a single rudder.",
        source: code(CommandSource) "Where the order comes from; the autopilot sends B.";
        later {
            centre: number(RUDDER) "Centre rudder order, since the edition of 2024.",
            centre_status: code(DataStatus) "Its status.",
            bow: number(RUDDER) "Bow rudder order, since the edition of 2024.",
            bow_status: code(DataStatus) "Its status.",
        }
    }
}
