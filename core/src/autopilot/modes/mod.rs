//! Modes of the autopilot and every transition between them (AP-6, TCS-8 to TCS-10, HTC-1, FA7).
//!
//! A mode is one file with its state, its row in the table, what it demands of the steering, what HTD says of it and what
//! it does with commands. It owns all that ends with it. Beside its file another mode takes a line in `modes!` and its
//! transitions in [`Mode::next`], which holds them all (`mode`).
//!
//! [`Modes`] is the part of the station: it holds the mode (`part`), selects it (`selection`, `met`), watches it
//! (`supervise`, `off_heading`) and obeys the chart system (`follow`).

mod auto;
mod autonav_ti;
mod autonav_tn;
mod document;
mod event;
mod follow;
mod met;
mod mode;
mod need;
mod off_heading;
mod part;
mod rudder_hold;
mod selection;
mod standby;
mod state;
mod supervise;
mod table;

pub use auto::{Auto, Finish};
pub use autonav_ti::AutonavTi;
pub use autonav_tn::AutonavTn;
pub use document::document;
pub use mode::{Mode, title_of};
pub(super) use part::Modes;
pub use rudder_hold::RudderHold;
pub use standby::Standby;
pub use table::ModeName;

#[cfg(test)]
mod tests;
