//! Alarms and alerts.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::table::{definition, kind, meanings, sentences, view, view_type};

sentences! {
    alr as Alr = "ALR" b'$' [5] "Set alarm state", "IEC 61162-1 ALR; Navis A.7" {
        time: time() "UTC of the change; null from this autopilot.",
        number: integer(whole(0, 99999, 3)) "Number of the alarm at its source.",
        condition: code(AlarmCondition) "Condition.",
        acknowledged: code(AcknowledgeState) "Acknowledge state.",
        text: text(40) "Description; null from this autopilot.",
    }
    ack as Ack = "ACK" b'$' [1] "Acknowledge alarm", "IEC 61162-1 ACK; Furuno AP-10" {
        number: integer(whole(0, 99999, 3)) "Number of the alarm that is acknowledged.",
    }
    alc as Alc = "ALC" b'$' [] "Cyclic alert list", "IEC 61162-1 ALC; Furuno AP-12" {
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
    alf as Alf = "ALF" b'$' [13] "Alert sentence", "IEC 61162-1 ALF; Furuno AP-13" {
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
}
