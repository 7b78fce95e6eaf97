//! Who says what, where, how often and how long: one table (interface section 3a).
//!
//! From it come what the stations say and when, the load of a line (FB12), the share of alert reports (AP-11), which
//! sentence takes the place of an unsent one (FB11), the cadence that the checker expects (CON-1), and `docs/talk.md`.
//! What a sentence carries is its station's.

mod document;
mod load;
mod share;
mod slot;
mod table;

pub use document::document;
pub use load::{Load, load};
pub(crate) use share::Share;
pub use slot::{Slot, slot};
pub use table::{HAND_UNIT_MS, HMS_MS, Row, SECOND_MS, Saying, TABLE, Told, When, told};
