//! What the steering laws know of the ship and how tightly they steer her.

use crate::units::{Radius, RateOfTurn, RudderAngle, Speed};
use serde::{Deserialize, Serialize};

/// The ship as the laws see her, and the gains. The default is the Mariner at 15 knots.
///
/// Nomoto: `T r' + r = K delta`, with `K = K0 U/U0` and `T = T0 U0/U`; in the second order a part `B` of the
/// gain has the time constant `T2` and the rest `T1 = (T - B T2)/(1 - B)`. Steady turn:
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
    /// Part of the gain that acts at once, with `quick_time`: second-order Nomoto; 0 for first order.
    pub quick_share: f64,
    /// Time constant of the quick part at the reference speed, s.
    pub quick_time: f64,
    /// Sway of the controlled point for each unit of turn: `v = -sway r`; how far forward of it the pivot point lies, metres (AP-16).
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
    /// The constants are the ship's own, not scaled from her length and speed (AP-20).
    pub known: bool,
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
            quick_share: 0.097,
            quick_time: 7.8,
            sway: 73.0,
            sway_lag: 5.0,
            natural_frequency: 0.05,
            damping: 0.9,
            integral_share: 0.1,
            look_ahead: 30.0,
            cross_track_integral: 0.1,
            approach_angle: 30.0,
            curvature_window: 45.0,
            curvature_lead: 0.0,
            current_time: 50.0,
            fix_time: 15.0,
            yaw_disturbance: 4.0e-6,
            slew: 5.0,
            rudder_max: RudderAngle::from_deg(35.0),
            free_rate: RateOfTurn::from_deg_per_min(24.0),
            turn_acceleration: 0.02,
            wave_yaw: 0.3,
            wave_frequency: 0.55,
            cruise_speed: Speed::from_knots(15.0),
            minimum_speed: Speed::from_knots(4.0),
            known: true,
        }
    }
}

/// The ship at one speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ShipAtSpeed {
    /// Speed through the water, m/s, at least the minimum.
    pub(super) speed: f64,
    /// Speed as a part of the reference speed.
    pub(super) ratio: f64,
    /// `T/K`, s^2.
    pub(super) inertia: f64,
    /// `T1/((1 - B) K)`: the inertia of the slow part, s^2.
    pub(super) slow_inertia: f64,
    /// `B K`, 1/s.
    pub(super) quick_gain: f64,
    /// `T2`, s.
    pub(super) quick_time: f64,
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

    /// The smallest radius that the ship can hold: with the whole rudder by her steady-turn curve, never less than her length.
    #[must_use]
    pub fn smallest_radius(&self) -> Radius {
        let rate = self.tightest();
        Radius::from_m(0.95 * self.length / rate)
    }

    /// The fastest rate of turn that the ship can hold at a speed.
    #[must_use]
    pub fn fastest_rate(&self, speed: Speed) -> RateOfTurn {
        let speed = speed.mps().max(self.minimum_speed.mps());
        RateOfTurn::from_rad_per_s(1.1 * self.tightest() * speed / self.length)
    }

    /// `r' = r L / U` with the whole rudder, at most 1: a circle of one length.
    fn tightest(&self) -> f64 {
        let [c0, c1, c3, c5] = self.steady_turn;
        let rudder = |q: f64| libm::fabs(c0) + q * (c1 + q * q * (c3 + q * q * c5));
        let (mut low, mut high) = (0.05, 1.0);
        for _ in 0..20 {
            let middle = 0.5 * (low + high);
            if rudder(middle) < self.rudder_max.rad() {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }

    pub(super) fn at_speed(&self, speed: f64) -> ShipAtSpeed {
        let reference = self.reference_speed.mps().max(0.5);
        let speed = speed.max(self.minimum_speed.mps()).max(0.5);
        let ratio = speed / reference;
        let inertia = self.time_constant / self.gain / (ratio * ratio);
        let share = self.quick_share.clamp(0.0, 0.5);
        let slow = (self.time_constant - share * self.quick_time) / (1.0 - share);
        ShipAtSpeed {
            speed,
            ratio,
            inertia,
            slow_inertia: slow / ((1.0 - share) * self.gain) / (ratio * ratio),
            quick_gain: share * self.gain * ratio,
            quick_time: (self.quick_time / ratio).max(1.0),
            length: self.length,
            curve: self.steady_turn,
            curve_limit: self.steady_turn_limit.rad(),
        }
    }
}

impl ShipAtSpeed {
    /// Rudder that holds a rate of turn: `delta_ss(r)`, rad.
    pub(super) fn steady_rudder(&self, rate: f64) -> f64 {
        let q = rate * self.length / self.speed;
        let q2 = q * q;
        let [c0, c1, c3, c5] = self.curve;
        (c0 + q * (c1 + q2 * (c3 + q2 * c5))).clamp(-self.curve_limit, self.curve_limit)
    }

    /// The quick part of the rate after `dt` with that rudder, rad/s.
    pub(super) fn quick_rate(&self, now: f64, rudder: f64, dt: f64) -> f64 {
        now + (self.quick_gain * rudder - now) * (dt / self.quick_time).min(1.0)
    }

    /// Rudder that gives rate and acceleration while the quick part is `quick`: the model inverted.
    pub(super) fn rudder_for(&self, rate: f64, acceleration: f64, quick: f64) -> f64 {
        let slow = 1.0 / self.slow_inertia;
        let steady = self.steady_rudder(rate) * slow;
        (acceleration + steady + quick / self.quick_time)
            / (slow + self.quick_gain / self.quick_time)
    }

    /// The rate of turn that `rudder` (rad) holds, to the side of its sign, rad/s.
    pub(super) fn steady_rate(&self, rudder: f64) -> f64 {
        let (mut low, mut high) = (0.0, 0.3 * self.speed / self.length);
        for _ in 0..12 {
            let middle = 0.5 * (low + high);
            let needed = libm::fabs(self.steady_rudder(libm::copysign(middle, rudder)));
            if needed < libm::fabs(rudder) {
                low = middle
            } else {
                high = middle
            }
        }
        low
    }

    /// Slope of the steady-turn curve, rad of rudder for each rad/s.
    pub(super) fn steady_slope(&self, rate: f64) -> f64 {
        let q = rate * self.length / self.speed;
        let q2 = (q * q).min(0.09);
        let [_, c1, c3, c5] = self.curve;
        (c1 + q2 * (3.0 * c3 + q2 * 5.0 * c5)) * self.length / self.speed
    }
}
