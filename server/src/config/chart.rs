//! `[chart_system]`: when the chart-system side indicates a turn, and whether it tells that somebody operates it.

use serde::Deserialize;
use std::ops::RangeInclusive;

/// Allowed times before wheel-over, seconds (TCS-11, MSC.74(69) A2 5.1.5 and 5.1.6).
const EARLY: RangeInclusive<f64> = 60.0..=900.0;
const SOON: RangeInclusive<f64> = 10.0..=120.0;

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
}

impl Default for Chart {
    fn default() -> Self {
        Self {
            early_s: 180.0,
            soon_s: 30.0,
            eve: false,
            dead_reckoning: false,
        }
    }
}

impl Chart {
    /// Whether it can be, or what is allowed.
    pub(super) fn check(&self) -> Result<(), String> {
        for (name, value, allowed) in [
            ("early_s", self.early_s, EARLY),
            ("soon_s", self.soon_s, SOON),
        ] {
            if !allowed.contains(&value) {
                let (low, high) = (allowed.start(), allowed.end());
                return Err(format!("{name} = {value}; allowed are {low} to {high} s"));
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
