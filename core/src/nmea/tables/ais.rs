//! AIS messages in their envelopes.

use crate::nmea::codes::codes;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};
use crate::nmea::table::{Format, Unit};
use serde::{Deserialize, Serialize};

codes! {
    /// Why an AIS station did not send.
    SilenceReason {
        PowerOff = b'1' "power off", Silent = b'2' "silent mode", Management = b'3' "switched off by channel management",
        Malfunction = b'4' "equipment malfunction", Configuration = b'5' "invalid configuration",
    }
    /// Channel for a broadcast.
    BroadcastChannel { Any = b'0' "no preference", A = b'1' "channel A", B = b'2' "channel B", Both = b'3' "both channels" }
    /// What became of a message that was to be sent.
    BroadcastResult {
        Received = b'0' "message 6 or 12 received by the addressed station", NoAnswer = b'1' "message 6 or 12 sent, not acknowledged",
        Failed = b'2' "could not be sent", Completed = b'3' "message 8, 14 or 15 sent", Late = b'4' "acknowledgement 7 or 13 received late",
        Read = b'5' "read and acknowledged on a display",
    }
    /// Bandwidth of a channel.
    Bandwidth { ByNumber = b'0' "as the channel number says", Narrow = b'1' "12.5 kHz" }
    /// On which channels an AIS station sends and receives.
    AisChannelMode {
        Both = b'0' "transmits on A and B, receives on A and B", A = b'1' "transmits on A, receives on A and B",
        B = b'2' "transmits on B, receives on A and B", Silent = b'3' "does not transmit, receives on A and B",
        SilentA = b'4' "does not transmit, receives on A", SilentB = b'5' "does not transmit, receives on B",
    }
    /// Power of a transmitter.
    AisPower { High = b'0' "high", Low = b'1' "low" }
    /// Where a channel assignment comes from.
    AssignmentSource {
        Addressed = b'A' "message 22, addressed", Broadcast = b'B' "message 22, for an area", Sentence = b'C' "an ACA sentence",
        Telecommand = b'D' "a DSC telecommand on channel 70", Manual = b'M' "manual input",
    }
    /// Whether an assignment is in use.
    AssignmentUse { Unused = b'0' "not in use", Used = b'1' "in use" }
    /// Whether keyboard and display are there.
    DataTerminal { Available = b'0' "keyboard and display are available", NotAvailable = b'1' "not available" }
    /// When an AIS station answers.
    ReplyLogic { Normal = b'0' "where addressed, or in the area and not asked within 24 h", Geographic = b'1' "wherever within the area" }
    /// What is asked of a ship far away.
    LongRangeFunction {
        Identity = b'A' "name, call sign and IMO number", Time = b'B' "date and time", Position = b'C' "position", Course = b'E' "course over ground",
        Speed = b'F' "speed over ground", Destination = b'I' "destination and arrival", Draught = b'O' "draught", Cargo = b'P' "ship and cargo",
        Dimensions = b'U' "length, breadth and type", Persons = b'W' "persons on board",
    }
    /// What is answered to it.
    LongRangeStatus { Given = b'2' "given", NotAvailable = b'3' "not available", Withheld = b'4' "withheld by the master" }
    /// AIS channel.
    AisChannel {
        A = b'A' "channel A (87B)", B = b'B' "channel B (88B)", One = b'1' "channel A, by its number", Two = b'2' "channel B, by its number",
    }
}

/// A whole number of metres.
const fn metres(high: i32, digits: u8) -> Format {
    Format::new(Unit::Metres, 0, high, digits, 0)
}
const TRANSITION: Format = Format::new(Unit::NauticalMiles, 1, 8, 1, 0);
const DRAUGHT: Format = Format::new(Unit::Metres, 0, 25, 1, 1);

sentences! {
    vdm as Vdm = "VDM" b'!' [6] "AIS VHF data-link message", "IEC 61162-1 VDM; Furuno appendix p. 11" {
        total: integer(whole(1, 9, 1)) "Number of sentences of this message.",
        number: integer(whole(1, 9, 1)) "Number of this sentence.",
        sequence: integer(whole(0, 9, 1)) "Identifier that joins them; null for a single one.",
        channel: code(AisChannel) "Channel on which it was heard.",
        payload: payload() "Encapsulated message of ITU-R M.1371.",
        fill_bits: integer(whole(0, 5, 1)) "Bits of the last character that do not count.",
    }
    vdo as Vdo = "VDO" b'!' [6] "AIS VHF data-link own-vessel report", "IEC 61162-1 VDO; Furuno appendix p. 11" {
        total: integer(whole(1, 9, 1)) "Number of sentences of this message.",
        number: integer(whole(1, 9, 1)) "Number of this sentence.",
        sequence: integer(whole(0, 9, 1)) "Identifier that joins them.",
        channel: code(AisChannel) "Channel; null where it was not sent by radio.",
        payload: payload() "Encapsulated message of ITU-R M.1371.",
        fill_bits: integer(whole(0, 5, 1)) "Bits of the last character that do not count.",
    }
    abm as Abm = "ABM" b'!' [8] "AIS addressed binary and safety-related message", "IEC 61162-1 ABM; Furuno appendix p. 13" {
        total: integer(whole(1, 9, 1)) "Number of sentences of this message.",
        number: integer(whole(1, 9, 1)) "Number of this sentence.",
        sequence: integer(whole(0, 3, 1)) "Identifier of the message.",
        mmsi: integer(MMSI) "Station that is addressed.",
        channel: code(BroadcastChannel) "Channel for the broadcast.",
        message: number(COUNT) "Number of the radio message, 6 or 12.",
        payload: payload() "Encapsulated data.",
        fill_bits: integer(whole(0, 5, 1)) "Bits of the last character that do not count.",
    }
    bbm as Bbm = "BBM" b'!' [7] "AIS broadcast binary message", "IEC 61162-1 BBM; Furuno appendix p. 13" {
        total: integer(whole(1, 9, 1)) "Number of sentences of this message.",
        number: integer(whole(1, 9, 1)) "Number of this sentence.",
        sequence: integer(whole(0, 9, 1)) "Identifier of the message.",
        channel: code(BroadcastChannel) "Channel for the broadcast.",
        message: number(COUNT) "Number of the radio message, 8 or 14.",
        payload: payload() "Encapsulated data.",
        fill_bits: integer(whole(0, 5, 1)) "Bits of the last character that do not count.",
    }
    vsd as Vsd = "VSD" b'$' [9] "AIS voyage static data", "IEC 61162-1 VSD; Furuno appendix p. 15" {
        ship_type: integer(whole(0, 255, 1)) "Type of ship and cargo.",
        draught: number(DRAUGHT) "Greatest present static draught.",
        persons: integer(whole(0, 8191, 1)) "Persons on board.",
        destination: text(20) "Destination.",
        arrival_time: time() "Estimated UTC of arrival.",
        arrival_day: integer(whole(0, 31, 2)) "Day of arrival.",
        arrival_month: integer(whole(0, 12, 2)) "Month of arrival.",
        status: integer(whole(0, 15, 1)) "Navigational status of ITU-R M.1371.",
        flags: integer(whole(0, 15, 1)) "Regional application flags.",
    }
    ssd = "SSD" b'$' [8] "AIS ship static data", "IEC 61162-1 SSD" {
        call_sign: text(7) "Call sign.",
        name: text(20) "Name of the ship.",
        bow: integer(metres(511, 3)) "From the reference point to the bow.",
        stern: integer(metres(511, 3)) "To the stern.",
        port: integer(metres(63, 2)) "To port.",
        starboard: integer(metres(63, 2)) "To starboard.",
        dte: code(DataTerminal) "Data terminal equipment.",
        source: text(2) "Source of the data.",
    }
    abk = "ABK" b'$' [5] "AIS addressed and binary broadcast acknowledgement", "IEC 61162-1 ABK" {
        mmsi: integer(MMSI) "Station that was addressed.",
        channel: code(AisChannel) "Channel of the reception.",
        message: number(COUNT) "Number of the radio message.",
        sequence: integer(whole(0, 9, 1)) "Identifier of the message.",
        kind: code(BroadcastResult) "Type of the acknowledgement.",
    }
    acs = "ACS" b'$' [6] "AIS channel management information source", "IEC 61162-1 ACS" {
        sequence: integer(whole(0, 9, 1)) "Identifier.",
        mmsi: integer(MMSI) "Originator.",
        time: time() "UTC of the receipt.",
        day: integer(whole(1, 31, 2)) "Day.",
        month: integer(whole(1, 12, 2)) "Month.",
        year: integer(whole(0, 9999, 4)) "Year.",
    }
    aca = "ACA" b'$' [19] "AIS channel assignment", "IEC 61162-1 ACA" {
        sequence: integer(whole(0, 9, 1)) "Identifier.",
        north_east: position(2) "North-east corner of the region.",
        south_west: position(2) "South-west corner of the region.",
        transition: integer(TRANSITION) "Transition zone.",
        channel_a: integer(whole(0, 9999, 4)) "Channel A.",
        bandwidth_a: code(Bandwidth) "Its bandwidth.",
        channel_b: integer(whole(0, 9999, 4)) "Channel B.",
        bandwidth_b: code(Bandwidth) "Its bandwidth.",
        mode: code(AisChannelMode) "Transmit and receive mode.",
        power: code(AisPower) "Power level.",
        source: code(AssignmentSource) "Source of the information.",
        in_use: code(AssignmentUse) "In use.",
        changed: time() "When that changed.",
    }
    air = "AIR" b'$' [8, 12] "AIS interrogation request", "IEC 61162-1 AIR" {
        mmsi_1: integer(MMSI) "First station.",
        message_1: number(COUNT) "Message asked of it.",
        section_1: integer(whole(0, 99, 1)) "Its sub-section.",
        message_2: number(COUNT) "Second message asked of it.",
        section_2: integer(whole(0, 99, 1)) "Its sub-section.",
        mmsi_2: integer(MMSI) "Second station.",
        message_3: number(COUNT) "Message asked of it.",
        section_3: integer(whole(0, 99, 1)) "Its sub-section.",
        channel: code(AisChannel) "Channel, since the edition of 2018.",
        identifier_1: text(10) "First message identifier, since the edition of 2018.",
        identifier_2: text(10) "Second message identifier, since the edition of 2018.",
        identifier_3: text(10) "Third message identifier, since the edition of 2018.",
    }
    lr1 = "LR1" b'$' [6] "AIS long-range reply sentence 1", "IEC 61162-1 LR1" {
        sequence: integer(whole(0, 9, 1)) "Identifier.",
        responder: integer(MMSI) "Who answers.",
        requestor: integer(MMSI) "Who asked.",
        name: text(20) "Name of the ship.",
        call_sign: text(7) "Call sign.",
        imo: integer(whole(0, 999_999_999, 9)) "IMO number.",
    }
    lr2 = "LR2" b'$' [12] "AIS long-range reply sentence 2", "IEC 61162-1 LR2" {
        sequence: integer(whole(0, 9, 1)) "Identifier.",
        responder: integer(MMSI) "Who answers.",
        date: text(8) "Date, ddmmyyyy.",
        time: time() "UTC of the position.",
        position: position(2) "Position.",
        course: lettered(DIRECTION, b'T') "Course over ground.",
        speed: lettered(KNOTS, b'N') "Speed over ground.",
    }
    lr3 = "LR3" b'$' [11] "AIS long-range reply sentence 3", "IEC 61162-1 LR3" {
        sequence: integer(whole(0, 9, 1)) "Identifier.",
        responder: integer(MMSI) "Who answers.",
        destination: text(20) "Destination.",
        arrival_date: text(6) "Date of arrival, ddmmyy.",
        arrival_time: time() "Time of arrival.",
        draught: number(DRAUGHT) "Draught.",
        cargo: text(10) "Ship and cargo.",
        length: number(metres(i32::MAX, 1)) "Length.",
        breadth: number(metres(i32::MAX, 1)) "Breadth.",
        ship_type: text(10) "Type of ship.",
        persons: integer(whole(0, 8191, 1)) "Persons on board.",
    }
    lrf = "LRF" b'$' [5, 4] "AIS long-range function", "IEC 61162-1 LRF" {
        sequence: integer(whole(0, 9, 1)) "Identifier.",
        mmsi: integer(MMSI) "Who asks.",
        name: text(20) "Name of who asks.",
        functions: letters(LongRangeFunction, 26) "Functions that are asked for.",
        status: letters(LongRangeStatus, 26) "What is answered.",
    }
    lri = "LRI" b'$' [12] "AIS long-range interrogation", "IEC 61162-1 LRI" {
        sequence: integer(whole(0, 9, 1)) "Identifier.",
        control: code(ReplyLogic) "When an answer is given.",
        requestor: integer(MMSI) "Who asks.",
        destination: integer(MMSI) "Who is asked.",
        north_east: position(2) "North-east corner of the area.",
        south_west: position(2) "South-west corner of the area.",
    }
    trl = "TRL" b'$' [8] "AIS transmitter non-functioning log", "IEC 61162-1 TRL, as SwiftNMEA reads it" {
        total: integer(whole(0, 99, 1)) "Number of entries; 0: none, and all else is null.",
        number: integer(whole(1, 99, 1)) "Number of this entry.",
        sequence: integer(whole(0, 9, 1)) "Identifier of the message.",
        off_date: text(8) "When it was switched off: date, ddmmyyyy.",
        off_time: time() "When it was switched off: UTC.",
        on_date: text(8) "When it was switched on: date, ddmmyyyy.",
        on_time: time() "When it was switched on: UTC.",
        reason: code(SilenceReason) "Why it was off.",
    }
}
