//! The configuration file: its names, its defaults, and the form in which it is in force.

mod built;
mod chart;
mod contact;
mod gear;
mod load;
mod pace;
mod port;
mod read;
mod route;
mod rules;
mod ship;
mod show;
#[cfg(test)]
mod tests;
mod types;
mod voyage;

pub(crate) use pace::pseudo_terminal;
pub(crate) use read::read;
pub(crate) use rules::Rules;
pub(crate) use show::in_force;
pub(crate) use types::{At, Bias, Config, Contact, ControlLine, Place, Port, Wire};
