//! What the chart system says: whose commands are obeyed, what a ship can do, where it lies in the own plane (HTC-1 to HTC-4,
//! TCS-4, AP-16, FB13).
//!
//! An HTC is obeyed in three steps. `command::htc` makes it a command or refuses it; `dialogue` holds it against the
//! ship's constants and the authority of its source; the mode that follows it holds it against everything else that is
//! heard. What is refused moves nothing, is said, and is TRACK FAIL when it lasts (TCS-8).

mod authority;
mod charted;
mod dialogue;
mod positions;

pub(super) use authority::Authority;
pub(super) use charted::{Charted, nearest};
pub(super) use dialogue::{Remote, can_do};
pub(super) use positions::Positions;
