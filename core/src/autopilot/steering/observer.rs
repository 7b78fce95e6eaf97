//! Heading and rate of turn without the waves: a Kalman filter of five states.
//!
//! ```text
//! xi'    = psi_w                                       waves, xi [rad s], psi_w [rad]
//! psi_w' = -w0^2 xi - 2 lambda w0 psi_w + w1           w0 [rad/s], lambda 0.1
//! psi'   = r                                           [rad]
//! r'     = (delta - delta_ss(r) - b)/J + q' + w2       [rad/s], Norrbin instead of Nomoto, J slow inertia
//! q'     = (B K delta - q)/T2                          [rad/s], the part of the rate that answers at once
//! b'     = w3                                          rudder bias [rad]
//! y1 = psi + psi_w + v1,   y2 = r + psi_w' + v2        gyro, rate of turn sensor
//! ```
//! Fossen 2021, 13.4; Fossen and Perez, IEEE CSM 29(6), 2009. The steady-turn curve in the predictor keeps
//! the rate unbiased in tight turns. An innovation beyond 8 degrees is a jump: not used for a second, then
//! the filter begins anew there (FA8).

use super::angle::wrap;
use super::settings::{ShipAtSpeed, SteeringSettings};
use serde::{Deserialize, Serialize};

const GYRO_DEVIATION: f64 = 0.0020;
const RATE_DEVIATION: f64 = 0.00040;
const BIAS_NOISE: f64 = 1.0e-4;
/// Part of the waves' rate of turn that their model does not foresee.
const ROUGHNESS: f64 = 1.5;
/// Time in which the sea is learned, s, and the largest yaw counted, rad^2.
const SEA_TIME: f64 = 100.0;
const LARGEST_YAW: f64 = 0.005;
const DAMPING: f64 = 0.1;
const JUMP: f64 = 0.14;
const JUMP_TIME: f64 = 1.0;

/// State of the filter: waves (2), heading, rate, bias; and their covariance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Observer {
    x: [f64; 5],
    p: [[f64; 5]; 5],
    quick: f64,
    sway: f64,
    jumped: f64,
    /// Variance of the yaw by waves, rad^2.
    waves: f64,
    begun: bool,
}

/// What the filter says, rad and seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Motion {
    pub(super) heading: f64,
    pub(super) rate: f64,
    /// Sway through the water, m/s, starboard positive.
    pub(super) sway: f64,
}

impl Observer {
    pub(super) const fn new() -> Self {
        Self {
            x: [0.0; 5],
            p: [[0.0; 5]; 5],
            quick: 0.0,
            sway: 0.0,
            jumped: 0.0,
            waves: 0.0,
            begun: false,
        }
    }

    /// The frame of the compass turned by `change` (rad), the ship did not.
    pub(super) fn turn_frame(&mut self, change: f64) {
        self.x[2] = wrap(self.x[2] + change);
        self.jumped = 0.0;
    }

    fn begin(&mut self, heading: f64, rate: f64) {
        let bias = self.x[4];
        self.x = [0.0, 0.0, heading, rate, bias];
        self.p = [[0.0; 5]; 5];
        for (i, variance) in [1e-4, 1e-4, 1e-4, 1e-6, 1e-4].into_iter().enumerate() {
            self.p[i][i] = variance;
        }
        self.jumped = 0.0;
        self.begun = true;
    }

    /// One step: predict with the rudder, correct with gyro and rate of turn (rad, rad/s).
    pub(super) fn step(
        &mut self,
        heading: f64,
        rate: f64,
        rudder: f64,
        ship: &ShipAtSpeed,
        settings: &SteeringSettings,
        dt: f64,
    ) -> Motion {
        if !self.begun {
            self.begin(heading, rate);
            self.sway = -settings.sway * rate;
            self.quick = ship.quick_gain * rudder;
            let expected = settings.wave_yaw.to_radians();
            self.waves = expected * expected;
        }
        self.predict(rudder, ship, settings, dt);
        let innovation = wrap(heading - self.x[2] - self.x[1]);
        if libm::fabs(innovation) > JUMP {
            self.jumped += dt;
            if self.jumped >= JUMP_TIME {
                self.begin(heading, rate);
            }
        } else {
            self.jumped = 0.0;
            self.learn_waves(wrap(heading - self.x[2]), dt);
            self.correct(innovation, [0.0, 1.0, 1.0, 0.0, 0.0], GYRO_DEVIATION, dt);
            let w = settings.wave_frequency;
            let row = [-w * w, -2.0 * DAMPING * w, 0.0, 1.0, 0.0];
            let expected: f64 = row.iter().zip(self.x).map(|(h, x)| h * x).sum();
            let rough = ROUGHNESS * w * libm::sqrt(self.waves);
            let deviation = libm::hypot(RATE_DEVIATION, rough);
            self.correct(rate - expected, row, deviation, dt);
        }
        self.x[2] = wrap(self.x[2]);
        let lag = settings.sway_lag / ship.ratio;
        self.sway += (-settings.sway * self.x[3] - self.sway) * (dt / lag.max(dt));
        Motion {
            heading: self.x[2],
            rate: self.x[3],
            sway: self.sway,
        }
    }

    /// Learns the sea from the difference between the gyro and the estimate.
    fn learn_waves(&mut self, yaw: f64, dt: f64) {
        let heard = (yaw * yaw - GYRO_DEVIATION * GYRO_DEVIATION).clamp(0.0, LARGEST_YAW);
        self.waves += (heard - self.waves) * dt / SEA_TIME;
    }

    fn predict(&mut self, rudder: f64, ship: &ShipAtSpeed, settings: &SteeringSettings, dt: f64) {
        let w = settings.wave_frequency.max(0.05);
        let damped = w * libm::sqrt(1.0 - DAMPING * DAMPING);
        let (fade, sine, cosine) = (
            libm::exp(-DAMPING * w * dt),
            libm::sin(damped * dt),
            libm::cos(damped * dt),
        );
        let mut f = [[0.0; 5]; 5];
        f[0][0] = fade * (cosine + DAMPING * w / damped * sine);
        f[0][1] = fade * sine / damped;
        f[1][0] = -fade * w * w / damped * sine;
        f[1][1] = fade * (cosine - DAMPING * w / damped * sine);
        f[2][2] = 1.0;
        f[2][3] = dt;
        f[3][3] = 1.0 - dt * (ship.steady_slope(self.x[3]) / ship.slow_inertia).min(1.0);
        f[3][4] = -dt / ship.slow_inertia;
        f[4][4] = 1.0;
        let drive = rudder - ship.steady_rudder(self.x[3]) - self.x[4];
        let [a, b, heading, rate, bias] = self.x;
        let quick = ship.quick_rate(self.quick, rudder, dt);
        let kick = quick - self.quick;
        self.quick = quick;
        self.x = [
            f[0][0] * a + f[0][1] * b,
            f[1][0] * a + f[1][1] * b,
            heading + dt * rate,
            rate + dt * drive / ship.slow_inertia + kick,
            bias.clamp(-0.2, 0.2),
        ];
        let q = [
            0.0,
            4.0 * DAMPING * w * self.waves * dt,
            0.0,
            settings.yaw_disturbance * settings.yaw_disturbance * ship.ratio * dt,
            BIAS_NOISE * BIAS_NOISE * dt,
        ];
        let fp = product(&f, &self.p, false);
        self.p = product(&fp, &f, true);
        for (i, q) in q.into_iter().enumerate() {
            self.p[i][i] += q;
        }
    }

    /// Takes one scalar measurement, `innovation = y - row x`.
    fn correct(&mut self, innovation: f64, row: [f64; 5], deviation: f64, dt: f64) {
        let mut ph = [0.0; 5];
        for (i, ph) in ph.iter_mut().enumerate() {
            *ph = self.p[i].iter().zip(row).map(|(p, h)| p * h).sum();
        }
        let spread: f64 = row.iter().zip(ph).map(|(h, p)| h * p).sum();
        let variance = spread + deviation * deviation * 0.1 / dt.max(0.01);
        let before = self.p;
        for i in 0..5 {
            let gain = ph[i] / variance;
            self.x[i] += gain * innovation;
            for j in 0..5 {
                self.p[i][j] = before[i][j] - gain * ph[j];
            }
        }
    }
}

/// `a b`, or `a b^T`.
fn product(a: &[[f64; 5]; 5], b: &[[f64; 5]; 5], transposed: bool) -> [[f64; 5]; 5] {
    let mut c = [[0.0; 5]; 5];
    for i in 0..5 {
        for j in 0..5 {
            for k in 0..5 {
                c[i][j] += a[i][k] * if transposed { b[j][k] } else { b[k][j] };
            }
        }
    }
    c
}
