//! The ship at one moment of a bench.

/// Control and integration step, s.
pub(super) const STEP: f64 = 0.1;

/// The ship at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Seconds from the start.
    pub time: f64,
    /// Metres north.
    pub north: f64,
    /// Metres east.
    pub east: f64,
    /// True heading, degrees, not wrapped.
    pub heading: f64,
    /// Rate of turn, degrees a second.
    pub rate: f64,
    /// Actual rudder, degrees.
    pub rudder: f64,
    /// Rudder order, degrees.
    pub order: f64,
    /// Speed through the water, m/s.
    pub speed: f64,
    /// Distance from the leg, or from the circle in arcs, m; right of track positive.
    pub cross_track: f64,
    /// Where on the route.
    pub stage: Stage,
}

/// Leg or arc, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// On a leg.
    Leg(usize),
    /// On the arc at its end.
    Arc(usize),
}
