//! The autopilot: what it hears, which mode it is in and how it moves the rudder.

pub mod steering;
