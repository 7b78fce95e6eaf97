//! Alarms and alerts.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};

use serde::{Deserialize, Serialize};

codes! {
    /// Condition of an ALA alarm.
    DetailedCondition {
        Normal = b'N' "normal state", High = b'H' "alarm state, threshold exceeded", ExtremeHigh = b'J' "alarm state, extreme threshold exceeded",
        Low = b'L' "alarm state, low threshold not reached", ExtremeLow = b'K' "alarm state, extreme low threshold not reached", Other = b'X' "other",
    }
    /// Acknowledge state of an ALA alarm.
    DetailedAcknowledge {
        Acknowledged = b'A' "acknowledged", NotAcknowledged = b'V' "not acknowledged", Broadcast = b'B' "broadcast, acknowledgement not applicable",
        Harbour = b'H' "harbour mode", Override = b'O' "override",
    }
    /// Status of equipment.
    EquipmentStatus { Normal = b'A' "normal", Failed = b'V' "system fail" }
}

words! {
    /// Systems that may raise an alarm.
    AlarmSystem {
        "SG" "steering gear", "PC" "propulsion control", "AM" "auxiliary machinery", "DE" "diesel plant", "ST" "steam turbine plant",
        "GT" "gas turbine plant", "EP" "electric plant", "PB" "propulsion boiler", "AB" "auxiliary boiler", "AD" "auxiliary diesel",
        "AT" "auxiliary turbine", "AG" "auxiliary gas turbine", "CG" "cargo control plant", "WD" "watertight door controller",
        "HD" "hull door controller", "FD" "fire door controller", "FR" "fire detection", "OT" "other systems",
    }
}

sentences! {
    alr as Alr = "ALR" b'$' [5] "Set alarm state", "IEC 61162-1 ALR; Navis A.7" {
        time: time() "UTC of the change; null from this autopilot.",
        number: integer(whole(0, 99999, 3)) "Number of the alarm at its source.",
        condition: code(AlarmCondition) "Condition.",
        acknowledged: code(AcknowledgeState) "Acknowledge state.",
        text: text(40) "Description; null from this autopilot.",
    }
    ack as Ack = "ACK" b'$' [1] "Acknowledge alarm", "IEC 61162-1 ACK; Furuno appendix p. 10" {
        number: integer(whole(0, 99999, 3)) "Number of the alarm that is acknowledged.",
    }
    ala as Ala = "ALA" b'$' [8] "Report detailed alarm condition", "IEC 61162-1 ALA; Navis A.8" {
        time: time() "Event time; null from this autopilot.",
        system: words(AlarmSystem) "System of the alarm source; always OT, other systems.",
        subsystem: text(2) "Subsystem of the alarm source; always JP, joystick and autopilot.",
        instance: integer(whole(0, 99, 2)) "00 standby, 01 autopilot, 02 joystick (never sent), 03 installation menu.",
        number: integer(whole(0, 999, 3)) "Number of the alarm.",
        condition: code(DetailedCondition) "Condition; N and H are sent.",
        acknowledged: code(DetailedAcknowledge) "Acknowledge state; A and V are sent.",
        text: text(40) "Description; null from this autopilot.",
    }
    arc as Arc = "ARC" b'$' [5] "Alert command refused", "IEC 61162-1 ARC; Furuno appendix p. 13" {
        time: time() "Time of the refusal.",
        manufacturer: text(3) "Manufacturer of a proprietary alert.",
        alert: integer(whole(0, 9_999_999, 1)) "Alert identifier.",
        instance: integer(whole(0, 999_999, 1)) "Alert instance.",
        command: code(AlertCommand) "The command that was refused.",
    }
    acn as Acn = "ACN" b'$' [6] "Alert command", "IEC 61162-1 ACN" {
        time: time() "Time of the command.",
        manufacturer: text(3) "Manufacturer of a proprietary alert.",
        alert: integer(whole(0, 9_999_999, 1)) "Alert identifier.",
        instance: integer(whole(0, 999_999, 1)) "Alert instance.",
        command: code(AlertCommand) "What is asked.",
        status: code(CommandStatus) "Sentence status; C.",
    }
    hbt as Hbt = "HBT" b'$' [3] "Heartbeat supervision sentence", "IEC 61162-1 HBT; Furuno appendix p. 10" {
        interval: number(SECONDS) "Configured repeat interval.",
        status: code(EquipmentStatus) "Equipment status.",
        sequence: integer(whole(0, 9, 1)) "Counts from 0 to 9.",
    }
    eve as Eve = "EVE" b'$' [3] "General event message", "IEC 61162-1 EVE; Furuno appendix p. 13" {
        time: time() "Event time.",
        tag: text(6) "Source of the event, such as EI0001.",
        text: text(60) "Description, such as OPERATION.",
    }
    nak = "NAK" b'$' [5] "Negative acknowledgement", "IEC 61162-1 NAK" {
        talker: text(2) "Talker that is answered.",
        formatter: text(3) "Sentence that is refused.",
        identifier: text(15) "Unique identifier.",
        reason: integer(whole(0, 99, 1)) "Reason code.",
        text: text(60) "Description.",
    }
    alc as Alc = "ALC" b'$' [] "Cyclic alert list", "IEC 61162-1 ALC; Furuno appendix p. 12" {
        total: integer(whole(1, 99, 2)) "Number of sentences of this list.",
        number: integer(whole(1, 99, 2)) "Number of this sentence.",
        sequence: integer(whole(0, 99, 2)) "Identifier of the list.",
        count: integer(whole(0, 99, 1)) "Number of entries in this sentence; an entry is never split over two.";
        each Counted(3) AlcEntry entries {
            manufacturer: text(3) "Manufacturer of a proprietary alert.",
            alert: integer(whole(0, 9_999_999, 1)) "Alert identifier.",
            instance: integer(whole(0, 999_999, 1)) "Alert instance.",
            revision: integer(whole(0, 99, 1)) "Revision counter.",
        }
    }
    alf as Alf = "ALF" b'$' [13] "Alert sentence", "IEC 61162-1 ALF; Furuno appendix p. 13" {
        total: integer(whole(1, 2, 1)) "Number of sentences of this alert.",
        number: integer(whole(1, 2, 1)) "Number of this sentence; the second carries the additional text.",
        sequence: integer(whole(0, 9, 1)) "Identifier that joins the two.",
        time: time() "Time of the last change.",
        category: code(AlertCategory) "Category; null in the second sentence.",
        priority: code(AlertPriority) "Priority; null in the second sentence.",
        state: code(AlertState) "State; null in the second sentence.",
        manufacturer: text(3) "Manufacturer of a proprietary alert.",
        alert: integer(whole(0, 9_999_999, 1)) "Alert identifier.",
        instance: integer(whole(0, 999_999, 1)) "Alert instance.",
        revision: integer(whole(0, 99, 1)) "Revision counter.",
        escalation: integer(whole(0, 9, 1)) "Escalation counter.",
        text: text(58) "Title in the first sentence, description in the second.",
    }
    agl = "AGL" b'$' [] "Alert group list", "IEC 61162-1 AGL, as SwiftNMEA reads it" {
        total: integer(whole(1, 99, 1)) "Number of sentences of this list.",
        number: integer(whole(1, 99, 1)) "Number of this sentence.",
        sequence: integer(whole(0, 99, 1)) "Identifier of the list.";
        each Open() AglEntry entries {
            source: text(6) "System function identifier of the source; null: who sends. The first entry is the head of the group.",
            manufacturer: text(3) "Manufacturer of a proprietary alert.",
            alert: integer(whole(0, 9_999_999, 1)) "Alert identifier.",
            instance: integer(whole(0, 999_999, 1)) "Alert instance.",
        }
    }
    akd = "AKD" b'$' [8] "Acknowledge detail alarm condition", "IEC 61162-1 AKD, as SwiftNMEA reads it" {
        time: time() "Time of the acknowledgement.",
        system: words(AlarmSystem) "System of the alarm source.",
        subsystem: text(2) "Subsystem of the alarm source.",
        instance: integer(whole(0, 99, 2)) "Instance of the alarm source.",
        number: integer(whole(0, 999, 3)) "Number of the alarm.",
        sender_system: text(2) "System that acknowledges.",
        sender_subsystem: text(2) "Subsystem that acknowledges.",
        sender_instance: integer(whole(0, 99, 2)) "Its instance.",
    }
}
