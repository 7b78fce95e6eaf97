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

use super::hull::{Drive, Hull};

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

/// Rate of change of the Mariner's state.
pub(super) fn derivative(hull: &Hull, drive: &Drive) -> Hull {
    let speed = hull.speed().max(0.1);
    let u = (hull.surge - drive.approach_speed) / speed;
    let v = hull.sway / speed;
    let r = hull.rate * LENGTH / speed;
    // The model counts the rudder positive to port. Two rudders act as their mean.
    let d = -match drive.port_order {
        None => hull.rudder,
        Some(_) => 0.5 * (hull.rudder + hull.port_rudder),
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
    let (north, east) = hull.ground_velocity(drive);
    let servo = |order: f64, rudder: f64, stuck: bool| {
        let order = order.clamp(-RUDDER_MAX, RUDDER_MAX);
        let rate = (order - rudder).clamp(-RUDDER_RATE, RUDDER_RATE);
        if stuck { 0.0 } else { rate }
    };
    let port_order = drive.port_order.unwrap_or(hull.port_rudder);
    Hull {
        surge: surge_force * scale / M11,
        sway: (M33 * sway_force - M23 * yaw_moment) * scale / DETERMINANT,
        rate: (M22 * yaw_moment - M32 * sway_force) * scale / LENGTH / DETERMINANT,
        heading: hull.rate,
        north,
        east,
        rudder: servo(drive.order, hull.rudder, drive.stuck[0]),
        port_rudder: servo(port_order, hull.port_rudder, drive.stuck[1]),
        heel: 0.0,
        heel_rate: 0.0,
        ship: hull.ship,
    }
}
