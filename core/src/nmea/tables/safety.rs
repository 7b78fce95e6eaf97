//! Maritime safety information: NAVTEX and SafetyNET.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences};
use crate::nmea::table::{Format, Unit};
use serde::{Deserialize, Serialize};

codes! {
    /// What a NAVTEX mask is for.
    MaskFunction { Request = b'0' "messages are asked for", Storage = b'1' "storage", Printer = b'2' "printer", Ins = b'3' "integrated navigation system" }
    /// Frequency of a NAVTEX receiver.
    NavtexFrequency { Local = b'1' "490 kHz", International = b'2' "518 kHz", Tropical = b'3' "4209.5 kHz" }
    /// Ocean region of the satellite.
    OceanRegion {
        AtlanticWest = b'0' "Atlantic, west", AtlanticEast = b'1' "Atlantic, east", Pacific = b'2' "Pacific", Indian = b'3' "Indian", All = b'9' "all",
    }
    /// Priority of a message.
    MessagePriority { Routine = b'0' "routine", Safety = b'1' "safety", Urgency = b'2' "urgency", Distress = b'3' "distress" }
    /// Subject of a coastal warning.
    WarningSubject {
        Navigation = b'A' "navigational warning", Weather = b'B' "meteorological warning", Ice = b'C' "ice report",
        Rescue = b'D' "search and rescue, piracy", Forecast = b'E' "meteorological forecast", Pilot = b'F' "pilot service", Ais = b'G' "AIS",
        Loran = b'H' "LORAN", Spare = b'I' "spare", Satellite = b'J' "satellite navigation", OtherAids = b'K' "other navigational aids",
        Additional = b'L' "additional navigational warning", SpecialV = b'V' "special service", SpecialW = b'W' "special service",
        SpecialX = b'X' "special service", SpecialY = b'Y' "special service", Nothing = b'Z' "no message",
    }
    /// State of a distress.
    DistressStatus { Active = b'D' "distress", Cancelled = b'C' "cancelled" }
}

const DEGREES: Format = Format::new(Unit::Degrees, 0, 360, 1, 0);

sentences! {
    nrm = "NRM" b'$' [5] "NAVTEX receiver mask", "IEC 61162-1 NRM, as SwiftNMEA reads it" {
        function: code(MaskFunction) "What the mask is for.",
        frequency: code(NavtexFrequency) "Frequency.",
        areas: hex(8) "Transmitter areas; the lowest bit is A.",
        kinds: hex(8) "Kinds of messages; the lowest bit is A.",
        status: code(CommandStatus) "Sentence status.",
    }
    nrx = "NRX" b'$' [13] "MSI received message", "IEC 61162-1 NRX, as SwiftNMEA reads it" {
        total: integer(whole(1, 999, 3)) "Number of sentences of this message.",
        number: integer(whole(1, 999, 3)) "Number of this sentence; what follows up to the status stands in the first one only.",
        sequence: integer(whole(0, 99, 2)) "Identifier that joins them.",
        code: text(4) "Area, kind and number of the message, such as IE69.",
        frequency: code(NavtexFrequency) "Frequency.",
        time: time() "UTC of the reception.",
        day: integer(whole(1, 31, 2)) "Day of the reception.",
        month: integer(whole(1, 12, 2)) "Month.",
        year: integer(whole(0, 9999, 4)) "Year.",
        characters: number(SIZE) "Characters of the message.",
        bad_characters: number(SIZE) "Characters that were not received.",
        status: code(DataStatus) "Whether the receiver takes the message for valid.",
        text: text(72) "Text, or a part of it.",
    }
    sm1 = "SM1" b'$' [14] "SafetyNET message, all ships/NavArea", "IEC 61162-1 SM1, as SwiftNMEA reads it" {
        status: code(DataStatus) "A: the message is complete.",
        message: integer(whole(0, 999_999, 1)) "Number of the message, which its SMB repeats.",
        sequence: integer(whole(0, 999_999, 1)) "Sequence number of the land earth station.",
        station: integer(whole(0, 999, 3)) "Land earth station.",
        region: code(OceanRegion) "Ocean region.",
        priority: code(MessagePriority) "Priority.",
        service: integer(whole(0, 99, 1)) "Service code.",
        presentation: integer(whole(0, 99, 1)) "Presentation code; 0: International Alphabet 5.",
        year: integer(whole(0, 9999, 4)) "UTC of the reception: year.",
        month: integer(whole(1, 12, 1)) "Month.",
        day: integer(whole(1, 31, 1)) "Day.",
        hour: integer(whole(0, 23, 1)) "Hour.",
        minute: integer(whole(0, 59, 1)) "Minute.",
        area: integer(whole(0, 21, 1)) "NAVAREA; 0: all ships.",
    }
    sm2 = "SM2" b'$' [16] "SafetyNET message, coastal warning area", "IEC 61162-1 SM2, as SwiftNMEA reads it" {
        status: code(DataStatus) "A: the message is complete.",
        message: integer(whole(0, 999_999, 1)) "Number of the message, which its SMB repeats.",
        sequence: integer(whole(0, 999_999, 1)) "Sequence number of the land earth station.",
        station: integer(whole(0, 999, 3)) "Land earth station.",
        region: code(OceanRegion) "Ocean region.",
        priority: code(MessagePriority) "Priority.",
        service: integer(whole(0, 99, 1)) "Service code.",
        presentation: integer(whole(0, 99, 1)) "Presentation code; 0: International Alphabet 5.",
        year: integer(whole(0, 9999, 4)) "UTC of the reception: year.",
        month: integer(whole(1, 12, 1)) "Month.",
        day: integer(whole(1, 31, 1)) "Day.",
        hour: integer(whole(0, 23, 1)) "Hour.",
        minute: integer(whole(0, 59, 1)) "Minute.",
        area: integer(whole(1, 21, 1)) "NAVAREA.",
        coast: text(1) "Letter of the coastal warning area.",
        subject: code(WarningSubject) "Subject.",
    }
    sm3 = "SM3" b'$' [18] "SafetyNET message, circular area address", "IEC 61162-1 SM3, as SwiftNMEA reads it" {
        status: code(DataStatus) "A: the message is complete.",
        message: integer(whole(0, 999_999, 1)) "Number of the message, which its SMB repeats.",
        sequence: integer(whole(0, 999_999, 1)) "Sequence number of the land earth station.",
        station: integer(whole(0, 999, 3)) "Land earth station.",
        region: code(OceanRegion) "Ocean region.",
        priority: code(MessagePriority) "Priority.",
        service: integer(whole(0, 99, 1)) "Service code.",
        presentation: integer(whole(0, 99, 1)) "Presentation code; 0: International Alphabet 5.",
        year: integer(whole(0, 9999, 4)) "UTC of the reception: year.",
        month: integer(whole(1, 12, 1)) "Month.",
        day: integer(whole(1, 31, 1)) "Day.",
        hour: integer(whole(0, 23, 1)) "Hour.",
        minute: integer(whole(0, 59, 1)) "Minute.",
        centre: position(2) "Centre of the area.",
        radius: number(MILES) "Radius of the area.",
    }
    sm4 = "SM4" b'$' [19] "SafetyNET message, rectangular area address", "IEC 61162-1 SM4, as SwiftNMEA reads it" {
        status: code(DataStatus) "A: the message is complete.",
        message: integer(whole(0, 999_999, 1)) "Number of the message, which its SMB repeats.",
        sequence: integer(whole(0, 999_999, 1)) "Sequence number of the land earth station.",
        station: integer(whole(0, 999, 3)) "Land earth station.",
        region: code(OceanRegion) "Ocean region.",
        priority: code(MessagePriority) "Priority.",
        service: integer(whole(0, 99, 1)) "Service code.",
        presentation: integer(whole(0, 99, 1)) "Presentation code; 0: International Alphabet 5.",
        year: integer(whole(0, 9999, 4)) "UTC of the reception: year.",
        month: integer(whole(1, 12, 1)) "Month.",
        day: integer(whole(1, 31, 1)) "Day.",
        hour: integer(whole(0, 23, 1)) "Hour.",
        minute: integer(whole(0, 59, 1)) "Minute.",
        south_west: position(2) "South-west corner of the area.",
        latitude_extent: number(DEGREES) "From it to the north.",
        longitude_extent: number(DEGREES) "From it to the east.",
    }
    smb = "SMB" b'$' [5] "IMO SafetyNET message body", "IEC 61162-1 SMB, as SwiftNMEA reads it" {
        total: integer(whole(1, 999, 1)) "Number of sentences of this body.",
        number: integer(whole(1, 999, 1)) "Number of this sentence; null for a single one.",
        sequence: integer(whole(0, 9, 1)) "Identifier that joins them.",
        message: integer(whole(0, 999_999, 1)) "Number of the message, as in SM1 to SM4.",
        text: text(72) "Text, or a part of it.",
    }
    smv = "SMV" b'$' [16] "SafetyNET message, vessel in distress information", "IEC 61162-1 SMV, as SwiftNMEA reads it" {
        total: integer(whole(1, 9, 1)) "Number of sentences of this message.",
        number: integer(whole(1, 9, 1)) "Number of this sentence; null for a single one.",
        sequence: integer(whole(0, 9, 1)) "Identifier that joins them.",
        message: integer(whole(0, 999_999, 1)) "Number of the message, as in SM1 to SM4.",
        mmsi: integer(MMSI) "Vessel in distress.",
        name: text(30) "Her name.",
        position: position(2) "Her position.",
        year: integer(whole(0, 9999, 4)) "UTC of the position: year.",
        month: integer(whole(1, 12, 2)) "Month.",
        day: integer(whole(1, 31, 2)) "Day.",
        hour: integer(whole(0, 23, 2)) "Hour.",
        minute: integer(whole(0, 59, 2)) "Minute.",
        status: code(DistressStatus) "Status of the distress.",
    }
}
