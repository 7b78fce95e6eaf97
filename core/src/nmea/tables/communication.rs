//! Texts, radio, versions and identities.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};
use crate::nmea::table::{Format, Unit};
use serde::{Deserialize, Serialize};

codes! {
    /// Whether a value is automatic.
    Automatic { Automatic = b'A' "automatic", Manual = b'M' "manual" }
    /// State of an emitter on a person.
    EmitterStatus { Activated = b'A' "activated", Test = b'T' "test mode", Manual = b'M' "manual button", InUse = b'V' "not in use", Fault = b'E' "error" }
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
            mode: text(1) "Mode of operation.",
        }
    }
    fsi = "FSI" b'$' [5, 4] "Frequency set information", "IEC 61162-1 FSI" {
        transmit: text(6) "Transmitting frequency or channel.",
        receive: text(6) "Receiving frequency or channel.",
        mode: text(1) "Mode of operation.",
        power: integer(whole(0, 9, 1)) "Power level.",
        status: code(CommandStatus) "Sentence status.",
    }
    dsc = "DSC" b'$' [11] "Digital selective calling information", "IEC 61162-1 DSC" {
        format: text(2) "Format specifier.",
        address: text(10) "Address.",
        category: text(2) "Category.",
        nature: text(2) "Nature of distress or first telecommand.",
        communication: text(2) "Type of communication or second telecommand.",
        position: text(20) "Position, channel or frequency.",
        time: text(16) "Time or telephone number.",
        distress: text(10) "MMSI of the ship in distress.",
        distress_nature: text(2) "Nature of its distress.",
        acknowledgement: text(1) "Acknowledgement.",
        expansion: text(1) "E: a DSE follows.",
    }
    dse = "DSE" b'$' [] "Expanded digital selective calling", "IEC 61162-1 DSE" {
        total: integer(whole(1, 9, 1)) "Number of sentences.",
        number: integer(whole(1, 9, 1)) "Number of this sentence.",
        flag: text(1) "Query, reply or automatic.",
        mmsi: text(10) "Vessel.";
        each Open() DseData expansions {
            code: text(2) "Code.",
            data: text(32) "Data.",
        }
    }
    mob = "MOB" b'$' [14] "Man over board notification", "IEC 61162-1 MOB" {
        emitter: hex(5) "Emitter.",
        status: code(EmitterStatus) "Its status.",
        activation: time() "Time of the activation.",
        source: integer(whole(0, 9, 1)) "Source of the position: 0 estimated by the vessel, 1 reported by the emitter.",
        date: date() "Date of the position.",
        time: time() "Time of the position.",
        position: position(4) "Position.",
        course: number(DIRECTION) "Course over ground.",
        speed: number(KNOTS) "Speed over ground.",
        mmsi: integer(MMSI) "MMSI.",
        battery: integer(whole(0, 9, 1)) "Battery: 0 good, 1 low.",
    }
    rlm = "RLM" b'$' [4] "Return link message", "IEC 61162-1 RLM" {
        beacon: text(15) "Beacon.",
        time: time() "Time of reception.",
        code: text(1) "Message code.",
        body: text(50) "Message body.",
    }
}
