//! The hull and its rudder servo: the Mariner, nonlinear in three degrees of freedom.
//!
//! ```text
//! (m - Xu.) u' = X U^2/L                                           surge [m/s]
//! [m - Yv.     m xG - Yr.] [v']   [Y U^2/L  ]                      sway [m/s]
//! [m xG - Nv.  Iz - Nr.  ] [r'] = [N U^2/L^2]                      rate of turn [rad/s]
//! delta' = clip(order - delta, 5 deg/s)                            rudder [rad], 1 s, at most 40 deg
//! n' = u cos psi - v sin psi + V_n,  e' = u sin psi + v cos psi + V_e     current V [m/s]
//! ```
//! X, Y, N are polynomials in `du/U`, `v/U`, `r L/U` and the rudder, made non-dimensional with the speed of the
//! moment; `du` is the loss against the approach speed. Chislett and Strom-Tejsen 1965, as in the public MSS
//! toolbox, whose runs it reproduces. Not a real ship's trial: zero rudder turns to starboard. No wind, no roll.

use serde::{Deserialize, Serialize};

const LENGTH: f64 = 160.93;
const RUDDER_MAX: f64 = 40.0 * core::f64::consts::PI / 180.0;
const RUDDER_RATE: f64 = 5.0 * core::f64::consts::PI / 180.0;

const MASS: f64 = 798e-5;
const CENTRE: f64 = -0.023;
const M11: f64 = MASS + 42e-5;
const M22: f64 = MASS + 748e-5;
const M23: f64 = MASS * CENTRE + 9.354e-5;
const M32: f64 = MASS * CENTRE - 4.646e-5;
const M33: f64 = 39.2e-5 + 43.8e-5;
const DETERMINANT: f64 = M22 * M33 - M23 * M32;

/// State of the hull: metres, radians, seconds; starboard, north and east positive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Hull {
    /// Surge through the water, m/s.
    pub surge: f64,
    /// Sway through the water, m/s.
    pub sway: f64,
    /// Rate of turn, rad/s.
    pub rate: f64,
    /// Heading, rad, not wrapped.
    pub heading: f64,
    /// Metres north of the origin.
    pub north: f64,
    /// Metres east of the origin.
    pub east: f64,
    /// Rudder, rad; of a pair, the starboard one.
    pub rudder: f64,
    /// The port one of a pair, rad.
    pub port_rudder: f64,
}

/// What acts on the hull.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Drive {
    /// Rudder order, rad; of a pair, to the starboard one.
    pub order: f64,
    /// Order to the port one of a pair, rad; a single rudder has none.
    pub port_order: Option<f64>,
    /// Rudders that stick where they are: the single or the starboard one, the port one.
    pub stuck: [bool; 2],
    /// Approach speed that the engine keeps, m/s.
    pub approach_speed: f64,
    /// Current towards north, m/s.
    pub current_north: f64,
    /// Current towards east, m/s.
    pub current_east: f64,
}

impl Hull {
    /// At the origin on `heading` (rad), running straight at `speed` (m/s).
    #[must_use]
    pub fn running(heading: f64, speed: f64) -> Self {
        Self {
            surge: speed,
            heading,
            ..Self::default()
        }
    }

    /// Speed through the water, m/s.
    #[must_use]
    pub fn speed(&self) -> f64 {
        libm::sqrt(self.surge * self.surge + self.sway * self.sway)
    }

    /// Velocity over ground: north and east, m/s.
    #[must_use]
    pub fn ground_velocity(&self, drive: &Drive) -> (f64, f64) {
        let (sine, cosine) = (libm::sin(self.heading), libm::cos(self.heading));
        (
            self.surge * cosine - self.sway * sine + drive.current_north,
            self.surge * sine + self.sway * cosine + drive.current_east,
        )
    }

    /// One Runge-Kutta step of the fourth order.
    pub fn step(&mut self, drive: &Drive, dt: f64) {
        let k1 = self.derivative(drive);
        let k2 = self.moved(&k1, dt / 2.0).derivative(drive);
        let k3 = self.moved(&k2, dt / 2.0).derivative(drive);
        let k4 = self.moved(&k3, dt).derivative(drive);
        let mean = |a: f64, b: f64, c: f64, d: f64| (a + 2.0 * (b + c) + d) / 6.0;
        let sum = Self {
            surge: mean(k1.surge, k2.surge, k3.surge, k4.surge),
            sway: mean(k1.sway, k2.sway, k3.sway, k4.sway),
            rate: mean(k1.rate, k2.rate, k3.rate, k4.rate),
            heading: mean(k1.heading, k2.heading, k3.heading, k4.heading),
            north: mean(k1.north, k2.north, k3.north, k4.north),
            east: mean(k1.east, k2.east, k3.east, k4.east),
            rudder: mean(k1.rudder, k2.rudder, k3.rudder, k4.rudder),
            port_rudder: mean(
                k1.port_rudder,
                k2.port_rudder,
                k3.port_rudder,
                k4.port_rudder,
            ),
        };
        *self = self.moved(&sum, dt);
    }

    fn moved(&self, by: &Self, dt: f64) -> Self {
        Self {
            surge: self.surge + dt * by.surge,
            sway: self.sway + dt * by.sway,
            rate: self.rate + dt * by.rate,
            heading: self.heading + dt * by.heading,
            north: self.north + dt * by.north,
            east: self.east + dt * by.east,
            rudder: self.rudder + dt * by.rudder,
            port_rudder: self.port_rudder + dt * by.port_rudder,
        }
    }

    fn derivative(&self, drive: &Drive) -> Self {
        let speed = self.speed().max(0.1);
        let u = (self.surge - drive.approach_speed) / speed;
        let v = self.sway / speed;
        let r = self.rate * LENGTH / speed;
        // The model counts the rudder positive to port. Two rudders act as their mean.
        let d = -match drive.port_order {
            None => self.rudder,
            Some(_) => 0.5 * (self.rudder + self.port_rudder),
        };
        let (uu, vv, dd) = (u * u, v * v, d * d);

        let surge_force = 1e-5
            * (u * (-184.0 - 110.0 * u - 215.0 * uu) - 899.0 * vv + 18.0 * r * r
                - 95.0 * dd
                - 190.0 * u * dd
                + 798.0 * r * v
                + 93.0 * v * d
                + 93.0 * u * v * d);
        let sway_force = 1e-5
            * (-1160.0 * v - 499.0 * r - 8078.0 * v * vv + 15356.0 * vv * r
                - 1160.0 * v * u
                - 499.0 * r * u
                + d * (278.0 - 90.0 * dd + 556.0 * u + 278.0 * uu - 4.0 * v * d + 1190.0 * vv)
                + (-4.0 - 8.0 * u - 4.0 * uu));
        let yaw_moment = 1e-5
            * (-264.0 * v - 166.0 * r + 1636.0 * v * vv
                - 5483.0 * vv * r
                - 264.0 * v * u
                - 166.0 * r * u
                + d * (-139.0 + 45.0 * dd - 278.0 * u - 139.0 * uu + 13.0 * v * d - 489.0 * vv)
                + (3.0 + 6.0 * u + 3.0 * uu));

        let scale = speed * speed / LENGTH;
        let (north, east) = self.ground_velocity(drive);
        let servo = |order: f64, rudder: f64, stuck: bool| {
            let order = order.clamp(-RUDDER_MAX, RUDDER_MAX);
            let rate = (order - rudder).clamp(-RUDDER_RATE, RUDDER_RATE);
            if stuck { 0.0 } else { rate }
        };
        let port_order = drive.port_order.unwrap_or(self.port_rudder);
        Self {
            surge: surge_force * scale / M11,
            sway: (M33 * sway_force - M23 * yaw_moment) * scale / DETERMINANT,
            rate: (M22 * yaw_moment - M32 * sway_force) * scale / LENGTH / DETERMINANT,
            heading: self.rate,
            north,
            east,
            rudder: servo(drive.order, self.rudder, drive.stuck[0]),
            port_rudder: servo(port_order, self.port_rudder, drive.stuck[1]),
        }
    }
}
