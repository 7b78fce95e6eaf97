//! `[chart_system]`: when the chart-system side indicates a turn, whether it tells that somebody operates it, and what a route has that a
//! plotter offers.

use serde::Deserialize;
use std::ops::RangeInclusive;

/// Allowed times before wheel-over, seconds (TCS-11, MSC.74(69) A2 5.1.5 and 5.1.6).
const EARLY: RangeInclusive<f64> = 60.0..=900.0;
const SOON: RangeInclusive<f64> = 10.0..=120.0;
/// What a route may have (TCS-11): nautical miles, metres.
const RADIUS: RangeInclusive<f64> = 0.1..=10.0;
const CORRIDOR: RangeInclusive<f64> = 1.0..=18_520.0;

/// The section, as written and as checked.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Chart {
    /// Early course change indication before wheel-over, seconds.
    pub(crate) early_s: f64,
    /// Indication before wheel-over, seconds.
    pub(crate) soon_s: f64,
    /// An EVE leaves the port `bams` with each order of an officer (TCS-13).
    pub(crate) eve: bool,
    /// Without a position control goes on by dead reckoning for a while (TCS-14).
    pub(crate) dead_reckoning: bool,
    /// Radius of the turns of a route that a plotter offers, nautical miles (TCS-13).
    pub(crate) offered_radius_nm: f64,
    /// Corridor of its legs to each side, metres.
    pub(crate) offered_xtd_m: f64,
}

impl Default for Chart {
    fn default() -> Self {
        Self {
            early_s: 180.0,
            soon_s: 30.0,
            eve: false,
            dead_reckoning: false,
            offered_radius_nm: 0.5,
            offered_xtd_m: 185.2,
        }
    }
}

impl Chart {
    /// Whether it can be, or what is allowed.
    pub(super) fn check(&self) -> Result<(), String> {
        for (name, value, allowed, unit) in [
            ("early_s", self.early_s, EARLY, "s"),
            ("soon_s", self.soon_s, SOON, "s"),
            ("offered_radius_nm", self.offered_radius_nm, RADIUS, "nm"),
            ("offered_xtd_m", self.offered_xtd_m, CORRIDOR, "m"),
        ] {
            if !allowed.contains(&value) {
                let (low, high) = (allowed.start(), allowed.end());
                return Err(format!(
                    "{name} = {value}; allowed are {low} to {high} {unit}"
                ));
            }
        }
        if self.soon_s >= self.early_s {
            return Err(format!(
                "soon_s ({} s) must be below early_s ({} s)",
                self.soon_s, self.early_s
            ));
        }
        Ok(())
    }
}
