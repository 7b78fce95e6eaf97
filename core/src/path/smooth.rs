//! The path that is steered along: a leg, or two legs joined by an arc, with its curvature smoothed.
//!
//! A ship cannot change her curvature at once. With the planned curvature `k(s)` averaged over a window
//! of half length `h`, the path that can be sailed leaves the planned one by `o(s)`, `o'' = k_mean - k`:
//! `o` grows to `h^2/(6R)` inside the arc and is nothing on the legs. Everything is in closed form, as
//! the sum of two steps of curvature, `e(s)` at the start of the arc and `-e(s - length)` at its end.

use super::Path;

/// The smoothed path at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Smooth {
    /// Cross-track distance of the smoothed path from the planned one, m.
    pub(crate) offset: f64,
    /// Its direction, rad.
    pub(crate) tangent: f64,
    /// Its curvature, 1/m.
    pub(crate) curvature: f64,
    /// Change of the curvature along the path, 1/m^2.
    pub(crate) bend: f64,
}

impl Path {
    /// The smoothed path `along` metres from the start of the arc, averaged over `half` to both sides.
    pub(crate) fn smooth(&self, along: f64, half: f64) -> Smooth {
        let Some(turn) = self.turn else {
            let tangent = self.course_in.rad();
            return Smooth {
                offset: 0.0,
                tangent,
                curvature: 0.0,
                bend: 0.0,
            };
        };
        let kappa = self.side() / turn.radius.m().max(1.0);
        let length = self.arc_length();
        let [o0, t0, k0, b0] = step_of_curvature(along, half.max(1.0));
        let [o1, t1, k1, b1] = step_of_curvature(along - length, half.max(1.0));
        let planned = along.clamp(0.0, length);
        Smooth {
            offset: kappa * (o0 - o1),
            tangent: self.course_in.rad() + kappa * (planned + t0 - t1),
            curvature: kappa * (k0 - k1),
            bend: kappa * (b0 - b1),
        }
    }
}

/// Offset, change of direction beyond the planned one, curvature and its slope, for a unit step at 0.
fn step_of_curvature(s: f64, h: f64) -> [f64; 4] {
    if s <= -h {
        return [0.0; 4];
    }
    if s >= h {
        return [h * h / 6.0, 0.0, 1.0, 0.0];
    }
    let mean = (s + h) / (2.0 * h);
    let slope = 1.0 / (2.0 * h);
    if s < 0.0 {
        let u = s + h;
        [u * u * u / (12.0 * h), u * u / (4.0 * h), mean, slope]
    } else {
        let u = s - h;
        [
            h * h / 6.0 + u * u * u / (12.0 * h),
            u * u / (4.0 * h),
            mean,
            slope,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::right_turn;
    use core::f64::consts::PI;

    #[test]
    fn the_smoothed_path_is_the_integral_of_its_curvature() {
        let path = right_turn();
        let (mut before, step) = (path.smooth(-250.0, 200.0), 0.5);
        let mut s = -250.0;
        while s < 1100.0 {
            let next = path.smooth(s + step, 200.0);
            let mean = 0.5 * (before.curvature + next.curvature);
            assert!(
                (next.tangent - before.tangent - mean * step).abs() < 1e-6,
                "at {s}"
            );
            before = next;
            s += step;
        }
        assert!((before.tangent - PI / 2.0).abs() < 1e-9 && before.offset.abs() < 1e-9);
        assert!((path.smooth(400.0, 200.0).offset - 200.0 * 200.0 / 3000.0).abs() < 1e-9);
    }
}
