//! Texts, radio, versions and identities.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};
use crate::nmea::table::{Format, Unit};
use serde::{Deserialize, Serialize};

codes! {
    /// Whether a value is automatic.
    Automatic { Automatic = b'A' "automatic", Manual = b'M' "manual" }
    /// Mode of operation of a radio.
    RadioMode {
        Simplex = b'd' "F3E/G3E telephone, simplex", Duplex = b'e' "F3E/G3E telephone, duplex", J3e = b'm' "J3E telephone", H3e = b'o' "H3E telephone",
        Fec = b'q' "F1B/J2B teleprinter, forward error correction", Arq = b's' "F1B/J2B teleprinter, repeat on request",
        Receive = b't' "F1B/J2B teleprinter or DSC, receive only", Teleprinter = b'w' "F1B/J2B teleprinter or DSC",
        MorseRecorder = b'x' "A1A Morse, tape recorder", MorseKey = b'{' "A1A Morse, key and head set", Facsimile = b'|' "F1C/F2C/F3C facsimile",
    }
    /// Acknowledgement of a selective call.
    CallAcknowledgement { Request = b'R' "acknowledge request", Given = b'B' "acknowledgement", End = b'S' "neither, end of sequence" }
    /// Whether a call has an expansion.
    CallExpansion { Follows = b'E' "a DSE follows" }
    /// What an expansion is.
    ExpansionKind { Query = b'Q' "query", Reply = b'R' "reply", Automatic = b'A' "automatic" }
    /// Where the position of an emitter comes from.
    EmitterPosition { Vessel = b'0' "estimated by the vessel", Emitter = b'1' "reported by the emitter", Error = b'6' "error" }
    /// Battery of an emitter.
    EmitterBattery { Good = b'0' "good", Low = b'1' "low", Error = b'6' "error" }
    /// Service of a return link message.
    ReturnLinkService {
        Reserved = b'0' "reserved", Acknowledgement = b'1' "acknowledgement", Command = b'2' "command", Message = b'3' "message", Test = b'F' "test",
    }
    /// State of an emitter on a person.
    EmitterStatus { Activated = b'A' "activated", Test = b'T' "test mode", Manual = b'M' "manual button", InUse = b'V' "not in use", Fault = b'E' "error" }
}

words! {
    /// Format specifier of ITU-R M.493, its last two digits, as all that follow.
    CallFormat { "02" "to an area", "12" "distress", "14" "to a group", "16" "to all ships", "20" "to a station", "23" "to a station, automatic service" }
    CallCategory { "00" "routine", "08" "safety", "10" "urgency", "12" "distress" }
    DistressNature {
        "00" "fire, explosion", "01" "flooding", "02" "collision", "03" "grounding", "04" "listing, in danger of capsizing", "05" "sinking",
        "06" "disabled and adrift", "07" "undesignated", "08" "abandoning ship", "09" "piracy or armed robbery", "10" "man over board", "12" "EPIRB emission",
    }
    /// Of a distress its nature, of all other calls the first telecommand.
    FirstTelecommand {
        "00" "fire, explosion; F3E/G3E telephony", "01" "flooding; F3E/G3E duplex telephony", "02" "collision", "03" "grounding; polling",
        "04" "listing; unable to comply", "05" "sinking; end of call", "06" "adrift; data", "07" "undesignated", "08" "abandoning ship",
        "09" "piracy; J3E telephony", "10" "man over board; distress acknowledgement", "12" "EPIRB emission; distress relay",
        "13" "teleprinter, forward error correction", "15" "teleprinter, repeat on request", "18" "test", "21" "position or registration", "26" "no information",
    }
    /// Of a distress the communication that is wanted, of all other calls the second telecommand.
    SecondTelecommand {
        "00" "F3E/G3E telephony; no reason", "01" "F3E/G3E duplex telephony; congestion", "02" "busy", "03" "queue", "04" "station barred", "05" "no operator",
        "06" "operator not available", "07" "equipment disabled", "08" "unable to use the channel", "09" "J3E telephony; unable to use the mode",
        "10" "not party to an armed conflict", "11" "medical transport", "12" "public call office", "13" "teleprinter, forward error correction; facsimile, data",
        "15" "teleprinter, repeat on request", "20" "0 calls follow", "21" "1 call follows", "22" "2 calls follow", "23" "3 calls follow",
        "24" "4 calls follow", "25" "5 calls follow", "26" "no information",
    }
    /// Code of an expansion of ITU-R M.821.
    Expansion {
        "00" "enhanced position", "01" "source and datum of the position", "02" "speed", "03" "course", "04" "additional identification",
        "05" "enhanced area", "06" "persons on board",
    }
}

const KILOHERTZ: Format = Format::new(Unit::Kilohertz, 0, i32::MAX, 1, 1);
const BIT_RATE: Format = Format::new(Unit::BitsPerSecond, 0, i32::MAX, 1, 0);
const DECIBELS: Format = Format::new(Unit::Decibels, -999, 999, 1, 1);

sentences! {
    txt as Txt = "TXT" b'$' [4] "Text transmission", "IEC 61162-1 TXT" {
        total: integer(whole(1, 99, 2)) "Number of sentences of this message.",
        number: integer(whole(1, 99, 2)) "Number of this sentence.",
        identifier: integer(whole(0, 99, 2)) "Identifier of the text.",
        text: text(61) "Text.",
    }
    tut = "TUT" b'$' [6] "Transmission of multi-language text", "IEC 61162-1 TUT" {
        source: text(2) "Source of the text.",
        total: hex(2) "Number of sentences, hexadecimal.",
        number: hex(2) "Number of this sentence, hexadecimal.",
        sequence: integer(whole(0, 9, 1)) "Identifier of the message.",
        coding: text(10) "Translation code.",
        text: text(60) "Text.",
    }
    ver = "VER" b'$' [10] "Version", "IEC 61162-1 VER" {
        total: integer(whole(1, 9, 1)) "Number of sentences.",
        number: integer(whole(1, 9, 1)) "Number of this sentence.",
        sequence: integer(whole(0, 9, 1)) "Identifier of the message.",
        device: text(2) "Type of the device.",
        vendor: text(20) "Vendor.",
        identifier: text(15) "Unique identifier.",
        serial: text(32) "Serial number.",
        model: text(32) "Model.",
        software: text(32) "Software revision.",
        hardware: text(32) "Hardware revision.",
    }
    stn = "STN" b'$' [1] "Multiple data ID", "IEC 61162-1 STN" {
        number: integer(whole(0, 99, 2)) "Talker number.",
    }
    uid = "UID" b'$' [2] "User identification code transmission", "IEC 61162-1 UID" {
        code_1: text(20) "First code.",
        code_2: text(20) "Second code.",
    }
    spw = "SPW" b'$' [4] "Security password sentence", "IEC 61162-1 SPW" {
        protected: text(3) "Sentence that is protected.",
        identifier: text(15) "Unique identifier.",
        level: integer(whole(0, 9, 1)) "Password level.",
        password: text(32) "Password.",
    }
    generic = "GEN" b'$' [] "Generic binary information", "IEC 61162-1 GEN" {
        index: hex(4) "Index of the first group.",
        time: time() "Time stamp.";
        each Open() GenWord words {
            word: hex(4) "Data.",
        }
    }
    msk = "MSK" b'$' [6, 5] "MSK receiver interface", "IEC 61162-1 MSK" {
        frequency: number(KILOHERTZ) "Beacon frequency.",
        frequency_mode: code(Automatic) "Automatic or manual.",
        bit_rate: number(BIT_RATE) "Beacon bit rate.",
        bit_rate_mode: code(Automatic) "Automatic or manual.",
        interval: number(SECONDS) "Interval of MSS.",
        channel: integer(whole(0, 99, 1)) "Channel.",
    }
    mss = "MSS" b'$' [5] "MSK receiver signal status", "IEC 61162-1 MSS" {
        strength: number(DECIBELS) "Signal strength.",
        ratio: number(DECIBELS) "Signal to noise ratio.",
        frequency: number(KILOHERTZ) "Beacon frequency.",
        bit_rate: number(BIT_RATE) "Beacon bit rate.",
        channel: integer(whole(0, 99, 1)) "Channel.",
    }
    sfi = "SFI" b'$' [] "Scanning frequency information", "IEC 61162-1 SFI" {
        total: integer(whole(1, 9, 1)) "Number of sentences.",
        number: integer(whole(1, 9, 1)) "Number of this sentence.";
        each Open() SfiChannel channels {
            frequency: text(6) "Frequency or channel.",
            mode: code(RadioMode) "Mode of operation.",
        }
    }
    fsi = "FSI" b'$' [5, 4] "Frequency set information", "IEC 61162-1 FSI" {
        transmit: text(6) "Transmitting frequency or channel.",
        receive: text(6) "Receiving frequency or channel.",
        mode: code(RadioMode) "Mode of operation.",
        power: integer(whole(0, 9, 1)) "Power level: 0 stand-by, 1 lowest, 9 highest.",
        status: code(CommandStatus) "Sentence status.",
    }
    dsc = "DSC" b'$' [11] "Digital selective calling information", "IEC 61162-1 DSC" {
        format: words(CallFormat) "Format specifier.",
        address: text(10) "Address.",
        category: words(CallCategory) "Category.",
        nature: words(FirstTelecommand) "Nature of distress or first telecommand.",
        communication: words(SecondTelecommand) "Type of communication or second telecommand.",
        position: text(20) "Position, channel or frequency.",
        time: text(16) "Time or telephone number.",
        distress: text(10) "MMSI of the ship in distress.",
        distress_nature: words(DistressNature) "Nature of its distress.",
        acknowledgement: code(CallAcknowledgement) "Acknowledgement.",
        expansion: code(CallExpansion) "Whether a DSE follows.",
    }
    dse = "DSE" b'$' [] "Expanded digital selective calling", "IEC 61162-1 DSE" {
        total: integer(whole(1, 9, 1)) "Number of sentences.",
        number: integer(whole(1, 9, 1)) "Number of this sentence.",
        flag: code(ExpansionKind) "Query, reply or automatic.",
        mmsi: text(10) "Vessel.";
        each Open() DseData expansions {
            code: words(Expansion) "Code.",
            data: text(32) "Data.",
        }
    }
    mob = "MOB" b'$' [14] "Man over board notification", "IEC 61162-1 MOB" {
        emitter: hex(5) "Emitter.",
        status: code(EmitterStatus) "Its status.",
        activation: time() "Time of the activation.",
        source: code(EmitterPosition) "Source of the position.",
        date: date() "Date of the position.",
        time: time() "Time of the position.",
        position: position(4) "Position.",
        course: number(DIRECTION) "Course over ground.",
        speed: number(KNOTS) "Speed over ground.",
        mmsi: integer(MMSI) "MMSI.",
        battery: code(EmitterBattery) "Battery.",
    }
    rlm = "RLM" b'$' [4] "Return link message", "IEC 61162-1 RLM" {
        beacon: text(15) "Beacon.",
        time: time() "Time of reception.",
        code: code(ReturnLinkService) "Message code.",
        body: text(50) "Message body.",
    }
}
