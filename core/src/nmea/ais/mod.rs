//! Messages of ITU-R M.1371 (AIS) and tracked-target data, carried as six-bit characters in VDM, VDO, ABM, BBM and TTD.
//!
//! One table of bit fields a message type gives decoder, encoder, JSON and document. Decoding never fails: it gives
//! values and faults. What a table calls "not available" is null. Nothing of this is on the way of a steering command.

mod bits;
mod codes;
mod document;
mod draft;
mod entry;
mod fault;
mod field;
mod gather;
mod json;
mod message;
mod plan;
mod tables;
mod value;
mod walk;

#[cfg(test)]
mod tests;

pub use bits::Bits;
pub use draft::{Draft, Input};
pub use entry::Entry;
pub use fault::{MessageFault, MessageFaultKind};
pub use gather::{Gathered, Gatherer};
pub use message::RadioMessage;
pub use value::{Binary, SixBitText, Value};

pub(super) use document::document;
use field::Layout;
