//! Alerts by IEC 62923: one table of numbers and texts, one state machine, and what is said of them (AP-11, FA15, DSP-5).
//!
//! [`Alert`] is what can be raised, [`Alerts`] the states of one station's, [`Past`] what has been; `Reports` says them on
//! the ports and hears who acknowledges, `HeardAlerts` are those of another system.

mod document;
mod elsewhere;
mod heard;
mod history;
mod machine;
mod peer;
mod reports;
mod sentences;
mod standing;
mod table;

pub use document::document;
pub use elsewhere::CommandRefused;
pub use heard::HeardAlert;
pub(crate) use heard::HeardAlerts;
pub use history::Past;
pub use machine::{Alerts, REPEAT_MS, SILENCE_MS, UNANSWERED_MS};
pub(crate) use reports::Reports;
pub use standing::{Standing, State};
pub use table::{Alert, Category, Definition, Priority};

#[cfg(test)]
mod tests;
