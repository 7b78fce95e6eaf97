//! AIS messages in their envelopes.

use crate::nmea::codes::codes;
use crate::nmea::formats::*;
use crate::nmea::table::{definition, kind, meanings, sentences, view, view_type};
use serde::{Deserialize, Serialize};

codes! {
    /// AIS channel.
    AisChannel {
        A = b'A' "channel A (87B)", B = b'B' "channel B (88B)", One = b'1' "channel A, by its number", Two = b'2' "channel B, by its number",
    }
}

sentences! {
    vdm as Vdm = "VDM" b'!' [6] "AIS VHF data-link message", "IEC 61162-1 VDM; Furuno AP-11" {
        total: integer(whole(1, 9, 1)) "Number of sentences of this message.",
        number: integer(whole(1, 9, 1)) "Number of this sentence.",
        sequence: integer(whole(0, 9, 1)) "Identifier that joins them; null for a single one.",
        channel: code(AisChannel) "Channel on which it was heard.",
        payload: payload() "Encapsulated message of ITU-R M.1371.",
        fill_bits: integer(whole(0, 5, 1)) "Bits of the last character that do not count.",
    }
}
