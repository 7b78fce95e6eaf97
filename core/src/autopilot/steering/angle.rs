//! Angles of the laws, in radians.

use crate::units::wrap_180;
use core::f64::consts::PI;

/// Wraps an angle in radians into -pi to pi.
pub(super) fn wrap(angle: f64) -> f64 {
    wrap_180(angle * 180.0 / PI) * PI / 180.0
}
