//! The page: bridge view, dialogue and decoder (Leptos, client-side rendered).
//!
//! In: frames of [`wheelover_core::view`]. The heard is folded here from the raw lines by the core itself; the own
//! facts come from the snapshot; the digest of both pictures is compared. Out: commands, acknowledgements.
//!
//! What tests and scripts hold on to stands in attributes, never in classes: `data-value` with `data-state` for each
//! value, `data-alert` for alerts, `data-plan` for what the plan draws, `data-closed` for why a mode cannot be selected, and
//! `data-command` for buttons: `standby`, `auto`, `autonav`, `adjust-10`, `adjust-1`, `adjust+1`, `adjust+10`, `confirm`,
//! `cancel`, `silence`, `acknowledge`, `speed-1` … `speed-60`, `officer`, `chart-track`, `chart-heading`, `chart-stop`,
//! `fault-chart-silent`, `fault-gyro-jump`, `fault-position-jump`, `current`, `north-up`, `head-up`, `course-up`,
//! `range-in`, `range-out`, `palette`; in the modes' view also `wind_vane`, `river_pilot`, `dodge`, `ffu_override`, `installation`, `autotuning`,
//! `set-10`, `set-1`, `set+1`, `set+10`, `tack-port`, `tack-starboard`; in the dialogue view `load-route`. All that moves the rudder but STANDBY is pressed and then confirmed.
//!
//! **Invariant:** nothing older than its limit is shown as live: ages are computed here, by a clock that nobody can set, before
//! each picture that the browser paints.
#![allow(
    unreachable_pub,
    reason = "Leptos makes a public item of every component"
)]

pub mod believed;
pub mod checked;
pub mod clock;
pub mod drawing;
pub mod explained;
pub mod format;
pub mod gauge;
pub mod heard;
mod message;
pub mod plan;
pub mod reading;
pub mod readings;
pub mod text;
pub mod trail;

#[cfg(target_arch = "wasm32")]
mod about;
#[cfg(target_arch = "wasm32")]
mod alerts;
#[cfg(target_arch = "wasm32")]
pub mod app;
#[cfg(target_arch = "wasm32")]
mod asking;
#[cfg(target_arch = "wasm32")]
mod bridge;
#[cfg(target_arch = "wasm32")]
mod deck;
#[cfg(target_arch = "wasm32")]
mod decoder;
#[cfg(target_arch = "wasm32")]
mod dialogue;
#[cfg(target_arch = "wasm32")]
pub mod later;
#[cfg(target_arch = "wasm32")]
pub mod link;
#[cfg(target_arch = "wasm32")]
mod lookup;
#[cfg(target_arch = "wasm32")]
mod modes;
#[cfg(target_arch = "wasm32")]
mod offered;
#[cfg(target_arch = "wasm32")]
mod palette;
#[cfg(target_arch = "wasm32")]
mod situation;
#[cfg(target_arch = "wasm32")]
mod steady;
#[cfg(target_arch = "wasm32")]
mod top;
#[cfg(target_arch = "wasm32")]
mod value;
#[cfg(target_arch = "wasm32")]
pub mod views;
