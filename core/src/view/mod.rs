//! What crosses between server and browser: the messages, the projections that make them, and what an order was pressed beside.

mod message;
mod offered;
mod own;
mod past;
mod press;
mod route;
mod voyage;

pub use crate::autopilot::ModeName;
pub use crate::autopilot::steering::Terms;
pub use crate::command::{Answer, ChartRequest, FaultKind, ModeRequest, Order, Origin, Side};
pub use crate::settings::Value;
pub use crate::voyage::Line;
pub use message::*;
pub use offered::{OfferedRoute, offered_route};
pub use own::own;
pub use past::{AlertsDocument, PastView, alerts_document};
pub use press::Presses;
pub use route::drawn_route;
pub use voyage::{hello, ports_document, route_document, settings_document, snapshot};

#[cfg(test)]
mod tests;
