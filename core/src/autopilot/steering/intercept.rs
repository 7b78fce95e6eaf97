//! Intercept: from a leg's course and the cross-track distance that a plotter says to the heading that closes it (AP-14).
//!
//! ```text
//! psi = chi - clip(atan((y + z)/D), A)        heading to steer [rad], chi the leg's course
//! y'  = (Y - y)/T                             cross-track distance [m], Y as it is said, right of the track positive
//! z'  = k y U/D      while |y| < D/2          what current and leeway ask for, |z| <= D tan C [m]
//! D   = 2 n U                                 look-ahead [m], n the ship's look-ahead [s], U her speed [m/s]
//! ```
//! The line of sight with an integral of Breivik and Fossen 2009 and Borhaug 2008, with what is said once a second by a few
//! decimals smoothed over `T`. `A` bounds the angle at which a leg is met, `C` the crab angle.

use super::SteeringSettings;
use crate::units::{Course, Distance, Heading, SignedAngle, Speed};
use serde::{Deserialize, Serialize};

/// Smoothing of the distance, s.
const SMOOTHING: f64 = 5.0;
/// The look-ahead beside that of the track law, which knows the ship's place ten times a second.
const FARTHER: f64 = 2.0;
/// Least look-ahead, m.
const LEAST: f64 = 30.0;
/// Largest angle to the leg, degrees.
const APPROACH_DEG: f64 = 40.0;
/// Largest crab angle that is learned, degrees.
const CRAB_DEG: f64 = 20.0;
/// How fast it is learned.
const LEARNS: f64 = 0.2;

/// What is known of the approach.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Intercept {
    /// Cross-track distance, smoothed, m; absent before the first.
    across: Option<f64>,
    /// What was learned of the drift, m.
    learned: f64,
}

impl Intercept {
    /// The heading to steer, `dt` seconds after the last one.
    pub fn step(
        &mut self,
        course: Course,
        cross_track: Distance,
        (ship, speed): (&SteeringSettings, Speed),
        dt: f64,
    ) -> Heading {
        let before = self.across.unwrap_or(cross_track.m());
        let across = before + (cross_track.m() - before) * (dt / SMOOTHING).min(1.0);
        self.across = Some(across);
        let speed = speed.mps().max(0.5);
        let look_ahead = (FARTHER * ship.look_ahead * speed).max(LEAST);
        if libm::fabs(across) < 0.5 * look_ahead {
            let most = look_ahead * libm::tan(CRAB_DEG.to_radians());
            let change = LEARNS * across * speed / look_ahead * dt;
            self.learned = (self.learned + change).clamp(-most, most);
        }
        let angle = libm::atan((across + self.learned) / look_ahead).to_degrees();
        let angle = angle.clamp(-APPROACH_DEG, APPROACH_DEG);
        course.as_heading() + SignedAngle::from_deg(-angle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steers a point that takes each heading at once, with a current across; its distance from the leg in the end, m.
    fn sail(start: f64, current: f64) -> (f64, f64) {
        let (mut intercept, ship) = (Intercept::default(), SteeringSettings::default());
        let (course, speed) = (Course::from_deg(350.0), Speed::from_knots(12.0));
        let (mut across, mut steepest) = (start, 0.0_f64);
        for step in 0..30_000 {
            // Said once a second with two decimals of a mile.
            let said = if step % 10 == 0 {
                across
            } else {
                across - across % 1.0
            };
            let said = Distance::from_nm(libm::round(Distance::from_m(said).nm() * 100.0) / 100.0);
            let hts = intercept.step(course, said, (&ship, speed), 0.1);
            let angle = (hts - course.as_heading()).deg();
            steepest = steepest.max(angle.abs());
            across += (speed.mps() * libm::sin(angle.to_radians()) + current) * 0.1;
        }
        (across, steepest)
    }

    // AP-14
    #[test]
    fn the_leg_is_met_from_either_side_whatever_the_current_and_never_too_steeply() {
        for start in [0.0, 100.0, -100.0, 2_000.0, -2_000.0] {
            for current in [0.0, 0.5, -1.0] {
                let (across, steepest) = sail(start, current);
                assert!(across.abs() < 12.0, "{start} m, {current} m/s: {across} m");
                assert!(steepest <= APPROACH_DEG, "{start} m: {steepest} degrees");
            }
        }
    }

    // AP-14: right of the track the ship is steered to port
    #[test]
    fn the_ship_is_steered_towards_the_leg() {
        let ship = SteeringSettings::default();
        let steered = |metres| {
            let distance = Distance::from_m(metres);
            let speed = Speed::from_knots(12.0);
            let hts =
                Intercept::default().step(Course::from_deg(10.0), distance, (&ship, speed), 0.1);
            (hts - Heading::from_deg(10.0)).deg()
        };
        assert!(steered(300.0) < -20.0 && steered(-300.0) > 20.0);
        assert_eq!(steered(0.0), 0.0);
    }
}
