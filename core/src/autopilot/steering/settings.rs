//! What the steering laws know of the ship and how tightly they steer her.

use crate::units::{RateOfTurn, RudderAngle, Speed};
use serde::{Deserialize, Serialize};

/// The ship as the laws see her, and the gains. The default is the Mariner at 15 knots.
///
/// Nomoto: `T r' + r = K delta`, with `K = K0 U/U0` and `T = T0 U0/U`. Steady turn:
/// `delta = c0 + c1 q + c3 q^3 + c5 q^5`, `q = r L/U`, fitted to a spiral or learned on board.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SteeringSettings {
    /// Length between perpendiculars, metres.
    pub length: f64,
    /// Speed at which `gain` and `time_constant` hold.
    pub reference_speed: Speed,
    /// Nomoto gain K0, 1/s.
    pub gain: f64,
    /// Nomoto time constant T0, s.
    pub time_constant: f64,
    /// Steady-turn curve c0, c1, c3, c5; radians of rudder.
    pub steady_turn: [f64; 4],
    /// Largest rudder for which the steady-turn curve was fitted.
    pub steady_turn_limit: RudderAngle,
    /// Part of `T/K` that an acceleration of the reference is given as rudder, 0 to 1.
    pub inertia_share: f64,
    /// Sway for each unit of turn: `v = -sway r`, metres.
    pub sway: f64,
    /// Lag of the sway behind the turn, s at the reference speed.
    pub sway_lag: f64,
    /// Natural frequency of the heading loop at the reference speed, rad/s.
    pub natural_frequency: f64,
    /// Damping of the heading loop.
    pub damping: f64,
    /// Integral gain as a part of `natural_frequency * K_p`.
    pub integral_share: f64,
    /// Look-ahead in seconds at the reference speed.
    pub look_ahead: f64,
    /// Integral of the cross-track distance as a part of the neutral one.
    pub cross_track_integral: f64,
    /// Largest angle at which a track is approached, degrees.
    pub approach_angle: f64,
    /// Duration over which the planned curvature is averaged, s.
    pub curvature_window: f64,
    /// Lead of the planned curvature, s.
    pub curvature_lead: f64,
    /// Time constant of the estimate of the current, s.
    pub current_time: f64,
    /// Time constant with which fixes correct the reckoned position, s.
    pub fix_time: f64,
    /// Yaw disturbance that the observer expects, radians a second in the root of a second.
    pub yaw_disturbance: f64,
    /// Order slew limit, degrees a second (FA6).
    pub slew: f64,
    /// Largest rudder angle.
    pub rudder_max: RudderAngle,
    /// Rate of turn of heading changes that nobody limits.
    pub free_rate: RateOfTurn,
    /// Largest acceleration of a heading change, degrees a second squared.
    pub turn_acceleration: f64,
    /// Wave yaw expected, standard deviation in degrees; 0 for no wave filter.
    pub wave_yaw: f64,
    /// Encounter frequency of the waves, rad/s.
    pub wave_frequency: f64,
    /// Speed used where none is measured (FA10).
    pub cruise_speed: Speed,
    /// Speed below which gains rise no further.
    pub minimum_speed: Speed,
}

impl Default for SteeringSettings {
    fn default() -> Self {
        Self {
            length: 160.93,
            reference_speed: Speed::from_knots(15.0),
            gain: 0.185,
            time_constant: 107.3,
            steady_turn: [-0.0222, 0.287, 10.62, 85.1],
            steady_turn_limit: RudderAngle::from_deg(28.0),
            inertia_share: 0.5,
            sway: 73.0,
            sway_lag: 5.0,
            natural_frequency: 0.05,
            damping: 0.9,
            integral_share: 0.1,
            look_ahead: 30.0,
            cross_track_integral: 0.1,
            approach_angle: 30.0,
            curvature_window: 45.0,
            curvature_lead: 2.0,
            current_time: 50.0,
            fix_time: 10.0,
            yaw_disturbance: 4.0e-6,
            slew: 5.0,
            rudder_max: RudderAngle::from_deg(35.0),
            free_rate: RateOfTurn::from_deg_per_min(24.0),
            turn_acceleration: 0.02,
            wave_yaw: 0.3,
            wave_frequency: 0.55,
            cruise_speed: Speed::from_knots(15.0),
            minimum_speed: Speed::from_knots(4.0),
        }
    }
}

/// The ship at one speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ship {
    /// Speed through the water, m/s, at least the minimum.
    pub(super) speed: f64,
    /// Speed as a part of the reference speed.
    pub(super) ratio: f64,
    /// `T/K`, s^2.
    pub(super) inertia: f64,
    length: f64,
    curve: [f64; 4],
    curve_limit: f64,
}

impl SteeringSettings {
    /// Seconds before the start of an arc at which its radius and centre should be known: half the window
    /// over which the curvature is averaged, and the lead.
    #[must_use]
    pub fn forwarding_time(&self) -> f64 {
        0.5 * self.curvature_window + self.curvature_lead
    }

    pub(super) fn at_speed(&self, speed: f64) -> Ship {
        let reference = self.reference_speed.mps().max(0.5);
        let speed = speed.max(self.minimum_speed.mps()).max(0.5);
        let ratio = speed / reference;
        let inertia = self.time_constant / self.gain / (ratio * ratio);
        Ship {
            speed,
            ratio,
            inertia,
            length: self.length,
            curve: self.steady_turn,
            curve_limit: self.steady_turn_limit.rad(),
        }
    }
}

impl Ship {
    /// Rudder that holds a rate of turn: `delta_ss(r)`, rad.
    pub(super) fn steady_rudder(&self, rate: f64) -> f64 {
        let q = rate * self.length / self.speed;
        let q2 = q * q;
        let [c0, c1, c3, c5] = self.curve;
        (c0 + q * (c1 + q2 * (c3 + q2 * c5))).clamp(-self.curve_limit, self.curve_limit)
    }

    /// Slope of the steady-turn curve, rad of rudder for each rad/s.
    pub(super) fn steady_slope(&self, rate: f64) -> f64 {
        let q = rate * self.length / self.speed;
        let q2 = (q * q).min(0.09);
        let [_, c1, c3, c5] = self.curve;
        (c1 + q2 * (3.0 * c3 + q2 * 5.0 * c5)) * self.length / self.speed
    }
}
