//! Modes of the autopilot and every transition between them (AP-6, TCS-8 to TCS-10, HTC-1, FA7).
//!
//! A mode is one file with its state, its row in the table, what it demands of the steering and what HTD says of it. It
//! owns all that ends with it. [`Mode::next`] holds every transition.

mod auto;
mod autonav_ti;
mod autonav_tn;
mod document;
mod event;
mod mode;
mod need;
mod rudder_hold;
mod standby;
mod state;
mod table;

pub use auto::{Auto, Finish};
pub use autonav_ti::AutonavTi;
pub use autonav_tn::AutonavTn;
pub use document::document;
pub(super) use event::{Cause, Event};
pub use mode::Mode;
pub(super) use mode::row;
pub(super) use need::{Lost, Need};
pub use rudder_hold::RudderHold;
pub use standby::Standby;
pub(super) use state::Facts;
pub use table::ModeName;
pub(super) use table::{OnLoss, Row};

#[cfg(test)]
mod tests;
