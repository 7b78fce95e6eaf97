//! Modes of the autopilot and every transition between them (AP-6, TCS-8 to TCS-10, HTC-1, FA7).
//!
//! A mode is one file with its state, its row in the table, what it demands of the steering, what HTD says of it and what
//! it does with commands. It owns all that ends with it. Beside its file another mode takes a line in `modes!` and its
//! transitions in [`Mode::next`], which holds them all (`mode`).
//!
//! [`Modes`] is the part of the station: it holds the mode (`part`), selects it (`selection`, `ordered`, `met`), watches it
//! (`supervise`, `off_heading`) and obeys the chart system (`follow`).

mod auto;
mod autonav_ti;
mod autonav_tn;
mod autotuning;
mod by_heading;
mod carry_out;
mod document;
mod dodge;
mod event;
mod ffu_override;
mod follow;
mod former;
mod installation;
mod jog;
mod met;
mod mode;
mod need;
mod nfu_override;
mod off_heading;
mod off_track;
mod ordered;
mod part;
mod plotted;
mod river_pilot;
mod rudder_hold;
mod selection;
mod set_value;
mod stand;
mod standby;
mod state;
mod steady_speed;
mod supervise;
mod table;
mod track;
mod wind_vane;

pub use auto::{Auto, Finish};
pub use autonav_ti::AutonavTi;
pub use autonav_tn::AutonavTn;
pub use autotuning::Autotuning;
pub use document::document;
pub use dodge::Dodge;
pub use ffu_override::FfuOverride;
pub use former::Former;
pub use installation::Installation;
pub use mode::{Mode, title_of};
pub use nfu_override::NfuOverride;
pub(super) use part::Modes;
pub use river_pilot::RiverPilot;
pub use rudder_hold::RudderHold;
pub use standby::Standby;
pub use table::ModeName;
pub use track::Track;
pub use wind_vane::WindVane;

#[cfg(test)]
mod tests;
