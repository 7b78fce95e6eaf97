//! Track: from the path and the ship's place to the heading and the rate that keep her on it.
//!
//! ```text
//! chi = pi_s - f((y - o + k int y)/D)                         course over ground [rad], D look-ahead [m]
//! r_c = U_g k_s + d/dt of the second term                     [rad/s]
//! chi_w = chi - asin(V_c_right/U_w)                           course through the water, current V_c [m/s]
//! r   = r_c U_g/(U_w cos(chi_w - chi))                        the rate needed through the water
//! psi = chi_w + c_v r/U_w                                     heading: the sway turns the bow inwards
//! ```
//! `f` is the line of sight near the track; far from it the angle that a turn of limited rate can take off again.
//! `pi_s`, `k_s`, `o` are the planned direction, curvature and place averaged over a window centred on the
//! ship (`path/smooth.rs`): the forwarding distance is half that window. Course control with the speed over ground
//! holds the radius in a current; Lekkas and Fossen 2013 for the line of sight, the rest worked out here.
//! A change of path fades in over 10 s, and a turn that is done keeps its window until it has passed, so
//! that no step reaches the rudder.

use super::angle::wrap;
use super::heading::ReferenceModel;
use super::reckoning::Sailing;
use super::settings::{ShipAtSpeed, SteeringSettings};
use crate::geo::Point;
use crate::path::Path;
use serde::{Deserialize, Serialize};

/// Memory of the guidance.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Guidance {
    /// The path as commanded.
    path: Option<Path>,
    /// The turn that was just made, moved onto the new leg.
    tail: Option<Path>,
    /// Course correction in use, rad, and whether it was begun.
    correction: Option<f64>,
    correction_rate: f64,
    /// What is left of the last change of path: course (rad), curvature (1/m).
    fade: [f64; 2],
    /// Course and curvature of the step before.
    last: [f64; 2],
    integral: f64,
}

/// What the heading loop is to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Steer {
    pub(super) reference: ReferenceModel,
    /// Cross-track distance from the planned path, m.
    pub(super) cross_track: f64,
}

const FADE_TIME: f64 = 10.0;
/// Part of the smoothed path's offset that is sailed; the rest is worked off towards the planned arc.
const OFFSET_KEPT: f64 = 0.25;
/// Fastest change of the approach angle, rad/s at the reference speed.
const APPROACH_RATE: f64 = 0.006;
/// Rate at which the approach angle is taken off, rad/s at the reference speed.
const BRAKE_RATE: f64 = 0.0035;
const APPROACH_LAG: f64 = 6.0;

impl Guidance {
    /// One step from position `p` and the ground estimate.
    pub(super) fn step(
        &mut self,
        path: &Path,
        p: Point,
        (sailing, heading): (&Sailing, f64),
        (ship, settings): (&ShipAtSpeed, &SteeringSettings),
        dt: f64,
    ) -> Steer {
        let ground_speed = libm::hypot(sailing.velocity.north, sailing.velocity.east).max(0.5);
        let half = 0.5 * settings.curvature_window * ground_speed;
        let lead = settings.curvature_lead * ground_speed;
        let changed = self.path != Some(*path);
        if changed {
            self.keep_tail(path, p);
        }
        if self
            .tail
            .is_some_and(|t| t.progress(p).along > t.arc_length() + half + lead)
        {
            self.tail = None;
        }
        let sailed = self.tail.unwrap_or(*path);
        let here = sailed.progress(p);
        let smooth = sailed.smooth(here.along, half);
        let ahead = sailed.smooth(here.along + lead, half);

        if changed && self.path.is_some() {
            self.fade[0] += wrap(self.last[0] - smooth.tangent - self.fade[0]);
            self.fade[1] = self.last[1] - ahead.curvature;
        }
        self.path = Some(*path);
        for left in &mut self.fade {
            *left -= *left * dt / FADE_TIME;
        }
        let tangent = smooth.tangent + self.fade[0];
        let curvature = ahead.curvature + self.fade[1];
        self.last = [tangent, curvature];

        let made_good = libm::atan2(sailing.velocity.east, sailing.velocity.north);
        let look_ahead = (settings.look_ahead * settings.reference_speed.mps()).max(10.0);
        let across = here.cross_track - OFFSET_KEPT * smooth.offset;
        let straight = ahead.curvature == 0.0 && smooth.curvature == 0.0;
        if straight && libm::fabs(across) < 0.1 * look_ahead {
            let rate = settings.cross_track_integral * ground_speed / look_ahead;
            self.integral =
                (self.integral + rate * across * dt).clamp(-0.05 * look_ahead, 0.05 * look_ahead);
        }
        let drifting = ground_speed * libm::sin(wrap(made_good - smooth.tangent));
        let bound = settings.approach_angle.to_radians();
        let brake = BRAKE_RATE * ship.ratio / ground_speed;
        let (angle, slope) = approach_angle(across + self.integral, look_ahead, brake, bound);
        let (wanted, wanted_rate) = (-angle, -slope * drifting);
        let (correction, correction_rate) = self.approach(
            wanted,
            wanted_rate,
            wrap(made_good - tangent),
            ship.ratio,
            dt,
        );

        let course = tangent + correction;
        let course_rate = ground_speed * curvature + correction_rate;
        let course_bend = ground_speed * ground_speed * ahead.bend;
        let set =
            sailing.current.east * libm::cos(course) - sailing.current.north * libm::sin(course);
        let water_speed = sailing.water_speed.max(0.5);
        let crab = libm::asin((set / water_speed).clamp(-0.7, 0.7));
        let stretch = ground_speed / (water_speed * libm::cos(crab));
        let rate = course_rate * stretch;
        let bend = course_bend * stretch;
        let bow_in = settings.sway / water_speed;
        let wanted_heading = wrap(course - crab + bow_in * rate);
        debug_assert!(wanted_heading.is_finite() && heading.is_finite());
        let reference = ReferenceModel {
            heading: wanted_heading,
            rate: rate + bow_in * bend,
            acceleration: bend,
        };
        Steer {
            reference,
            cross_track: here.cross_track,
        }
    }

    /// The approach angle: begins with the course made good, moves at a limited rate, then follows freely.
    fn approach(&mut self, wanted: f64, rate: f64, now: f64, ratio: f64, dt: f64) -> (f64, f64) {
        let Some(last) = self.correction else {
            self.correction = Some(now);
            self.correction_rate = 0.0;
            return (now, 0.0);
        };
        let most = APPROACH_RATE * ratio;
        let gap = wanted - last;
        let speed = (gap / APPROACH_LAG + rate).clamp(-most, most);
        let swing = most / APPROACH_LAG * dt;
        self.correction_rate += (speed - self.correction_rate).clamp(-swing, swing);
        let next = last + self.correction_rate * dt;
        self.correction = Some(next);
        (next, self.correction_rate)
    }

    /// After a turn the next path is a leg: the arc behind is remembered, moved onto that leg.
    fn keep_tail(&mut self, path: &Path, p: Point) {
        let old = self.tail.or(self.path);
        self.tail = None;
        if path.turn.is_some() {
            return;
        }
        let Some((old, mut turn)) = old.and_then(|o| Some((o, o.turn?))) else {
            return;
        };
        let same = libm::fabs((turn.course_out - path.course_in).deg()) < 2.0;
        let at = old.progress(p);
        let leg = path.progress(p).cross_track;
        if same && at.along > 0.5 * old.arc_length() && libm::fabs(leg) < 200.0 {
            let shift = old.leg_out().progress(p).cross_track - leg;
            turn.centre = turn.centre.towards(path.course_in.deg() + 90.0, shift);
            self.tail = Some(Path::turn(
                old.course_in,
                turn.centre,
                turn.radius,
                path.course_in,
            ));
        }
    }
}

/// Angle towards the track and its slope over the distance (rad, rad/m): `y/D` near the track, farther out
/// the square root that is taken off with `brake` radians a metre, so that the turn onto the track can be made.
fn approach_angle(across: f64, look_ahead: f64, brake: f64, bound: f64) -> (f64, f64) {
    let distance = libm::fabs(across);
    let near = brake * look_ahead * look_ahead;
    let (angle, slope) = if distance < near {
        (distance / look_ahead, 1.0 / look_ahead)
    } else {
        let angle = libm::sqrt(2.0 * brake * (distance - near / 2.0));
        (angle, brake / angle)
    };
    if angle < bound {
        (libm::copysign(angle, across), slope)
    } else {
        (libm::copysign(bound, across), 0.0)
    }
}
