//! Closed loops in fast time: the three stations joined by cables that a test can damage line by line.
#![allow(clippy::unwrap_used)]

mod absurd;
mod alerts;
mod believed;
mod chart_lost;
mod constants;
mod cross_track;
mod differential;
mod entry;
mod hand_unit;
mod heading_command;
mod magnetic;
mod management;
mod modes;
mod monitor;
mod monte_carlo;
mod motor;
mod offsets;
mod ports;
#[path = "../../../tests/random.rs"]
mod random;
mod refused_commands;
mod rig;
mod rudders;
mod sensors_lost;
mod silence;
mod situations;
mod small_craft;
mod speed;
mod spoilt;
mod stand;
mod steps;
mod track;
mod track_refused;
mod wrong_port;
