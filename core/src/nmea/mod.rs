//! Sentences of NMEA 0183 / IEC 61162-1: framing, one dictionary, decoding, encoding, explanation.
//!
//! In go bytes, out come sentences with values and faults. One table entry makes decoder, encoder,
//! explanation and, where code needs it, a typed view.
//!
//! | from | to | with |
//! |---|---|---|
//! | bytes of a port | lines | [`Framer`] |
//! | a line | a sentence with raw fields, checksum, faults | [`decode`] |
//! | a sentence | a typed view | `from_sentence` of [`Htc`], [`Rmc`] and the others |
//! | a sentence | every member with its exact value | [`Sentence::walk`], [`Sentence::member`] |
//! | a sentence | names, units, meanings, hints | [`explain()`], [`hints()`], [`json_line`] |
//! | sentences of one message | the message | [`Assembler`] |
//! | a typed view | a line | its `line` |
//! | a sentence | the same line | [`encode`], [`Values`] |
//! | an HTC | a command, or why not | [`crate::command::htc()`] |
//!
//! ```
//! use wheelover_core::nmea::{decode, Framer, Hdt, Rot};
//! let mut framer = Framer::new();
//! let mut heading = None;
//! // Bytes come in pieces as the port gives them.
//! for piece in [b"$HEHDT,216".as_slice(), b".8,T*22\r\n$HEROT,-0"] {
//!     framer.push(piece, &mut |frame| {
//!         let sentence = decode(frame.text);
//!         if sentence.is_clean() {
//!             heading = Hdt::from_sentence(&sentence).and_then(|hdt| hdt.heading).or(heading);
//!         }
//!     });
//! }
//! assert_eq!(heading, Some(216.8));
//! // And out again, with the decimals of the table and the checksum.
//! let rot = Rot { rate: Some(-27.5), ..Rot::default() };
//! assert_eq!(rot.line("AG"), "$AGROT,-027.5,*4C");
//! ```
//!
//! **Invariant:** decoding never fails, obeying is strict: only [`crate::command::htc()`] makes a command of a line.

pub mod ais;
mod angles;
mod armour;
mod assemble;
mod checksum;
mod codes;
mod decimal;
mod decode;
mod document;
mod ear;
mod encode;
pub mod explain;
mod explain_text;
mod explain_units;
mod explained;
mod fault;
mod formats;
mod framer;
mod group;
mod hints;
mod json;
mod known;
mod longest;
mod macros;
mod read;
mod scan;
mod sentence;
mod sides;
mod table;
mod tables;
mod tag;
mod value;
mod values;
mod view;
mod whole;

#[cfg(test)]
mod tests;

pub use assemble::{Assembler, Message};
pub use checksum::Checksum;
pub use codes::*;
pub use decimal::Decimal;
pub use decode::decode;
pub use document::document;
pub(crate) use ear::Ear;
pub use encode::with_checksum;
pub use explain::explain;
pub use fault::{Fault, FaultKind};
pub use framer::{Frame, FrameKind, Framer};
pub use hints::hints;
pub use json::{JsonChecksum, JsonFault, JsonField, JsonLine, JsonValue, json, json_line};
pub(crate) use known::Known;
pub use scan::FieldList;
pub(crate) use sentence::decode_knowing;
pub use sentence::{Item, Sentence};
pub(crate) use table::key;
pub use table::{Definition, Format, Kind, Sides, Unit};
pub use tables::*;
pub use tag::{TagBlock, TagGroup};
pub(crate) use value::unescape;
pub use value::{Date, UtcTime, Value};
pub use values::{Values, encode};
