//! Sentences of NMEA 0183 / IEC 61162-1: framing, one dictionary, decoding, encoding, explanation.
//!
//! In go bytes, out come sentences with values and faults. One table entry makes decoder, encoder,
//! explanation and, where code needs it, a typed view.
//!
//! **Invariant:** decoding never fails, obeying is strict: only [`steering`] makes a command of a line.

pub mod ais;
mod assemble;
mod checksum;
mod codes;
mod decimal;
mod decode;
mod document;
mod encode;
pub mod explain;
mod explain_text;
mod explain_units;
mod fault;
mod formats;
mod framer;
mod hints;
mod json;
mod macros;
mod read;
mod scan;
mod strict;
mod table;
mod tables;
mod tag;
mod value;
mod view;

#[cfg(test)]
mod tests;

pub use assemble::{Assembler, Message};
pub use checksum::ChecksumGate;
pub use codes::*;
pub use decimal::Decimal;
pub use decode::{Checksum, Item, Sentence, decode};
pub use encode::{Values, encode, with_checksum};
pub use explain::explain;
pub use fault::{Fault, FaultKind};
pub use framer::{Frame, FrameKind, Framer};
pub use hints::hints;
pub use json::{JsonChecksum, JsonFault, JsonField, JsonLine, JsonValue, json, json_line};
pub use scan::FieldList;
pub use strict::{HtcCommand, HtcRefusal, steering};
pub use table::{Definition, Format, Kind, Sides, Unit};
pub use tables::*;
pub use tag::{TagBlock, TagGroup};
pub use value::{Date, UtcTime, Value, unescape};
