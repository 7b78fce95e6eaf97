//! What the plan is drawn from (DSP-4).

use super::frame::Frame;
use crate::readings::Readings;
use crate::trail::Trail;
use wheelover_core::route::foreign::Told;
use wheelover_core::view::{ChartOwn, Outline, RouteDocument};

/// Everything that the plan shows, at one moment.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// Its projection.
    pub frame: Frame,
    /// Its range, nautical miles.
    pub range_nm: f64,
    /// Own ship.
    pub ship: Outline,
    /// What was heard.
    pub readings: &'a Readings,
    /// The route.
    pub route: &'a RouteDocument,
    /// Where on it our chart-system side stands; absent with a foreign one.
    pub chart: Option<&'a ChartOwn>,
    /// What the sentences of a foreign one tell; absent with our own.
    pub told: Option<Told>,
    /// The track made good.
    pub trail: &'a Trail,
}

/// Minutes that the vectors reach ahead, by range.
#[must_use]
pub fn vector_minutes(range_nm: f64) -> f64 {
    match range_nm {
        range if range <= 0.75 => 1.5,
        range if range <= 1.5 => 3.0,
        range if range <= 3.0 => 6.0,
        _ => 12.0,
    }
}
