//! A sailing yacht of eleven metres under engine and sail, in a first form.
//!
//! ```text
//! T r' = K (delta - h phi) U/U0 - r - c r |r|              yaw; h phi is weather helm      T = T0 U0/U
//! phi'' = w^2 (phi_w - phi) - 2 zeta w phi'                 heel to starboard positive
//! phi_w = -k V^2 sin beta cos phi,  |phi_w| <= 0.6          V, beta: apparent wind, m/s, from starboard positive
//! v' = (l U sin phi - v) / T_v                              leeway
//! u' = (U_e (1 - d |delta|) - u) / T_u                      U_e: the speed that engine and sails keep
//! ```
//! Form and size after Nomoto's first order with weather helm as a rudder that the heel lays; the figures are those of a
//! cruising yacht of 10 m waterline and 8 t (turning circle about three lengths at 25 degrees, 17 degrees of heel in 16 kn
//! across), not of one that was measured. Rudder: 35 degrees, 12 degrees a second where no motor turns it.

use super::hull::{Drive, Hull};

/// Speed at which gain and time constant hold, m/s.
const SPEED: f64 = 3.09;
const GAIN: f64 = 0.25;
const TIME: f64 = 2.0;
/// Loss of rate by the turn itself, s.
const TURN_LOSS: f64 = 1.5;
const WEATHER_HELM: f64 = 0.3;
const HEEL_FREQUENCY: f64 = 2.1;
const HEEL_DAMPING: f64 = 0.2;
/// Heel for each square of the wind's speed across, rad/(m/s)^2.
const STIFFNESS: f64 = 0.0043;
const MOST_HEEL: f64 = 0.6;
const LEEWAY: f64 = 0.2;
const LEEWAY_TIME: f64 = 2.0;
const SPEED_TIME: f64 = 8.0;
/// Speed lost for each radian of rudder.
const DRAG: f64 = 0.3;
const RUDDER_MAX: f64 = 35.0 * core::f64::consts::PI / 180.0;
const RUDDER_RATE: f64 = 12.0 * core::f64::consts::PI / 180.0;

/// Rate of change of the yacht's state.
pub(super) fn derivative(hull: &Hull, drive: &Drive) -> Hull {
    let speed = hull.speed().max(0.1);
    let ratio = speed / SPEED;
    let (beta, wind) = hull.apparent_wind(drive);
    let pressed = -STIFFNESS * wind * wind * libm::sin(beta) * libm::cos(hull.heel);
    let pressed = pressed.clamp(-MOST_HEEL, MOST_HEEL);
    let rudder = hull.rudder - WEATHER_HELM * hull.heel;
    let turned = GAIN * ratio * rudder - hull.rate - TURN_LOSS * hull.rate * libm::fabs(hull.rate);
    let (north, east) = hull.ground_velocity(drive);
    let order = drive.order.clamp(-RUDDER_MAX, RUDDER_MAX);
    let servo = ((order - hull.rudder) / 0.2).clamp(-RUDDER_RATE, RUDDER_RATE);
    let kept = drive.approach_speed * (1.0 - DRAG * libm::fabs(hull.rudder));
    Hull {
        surge: (kept - hull.surge) / SPEED_TIME,
        sway: (LEEWAY * speed * libm::sin(hull.heel) - hull.sway) / LEEWAY_TIME,
        rate: turned * ratio / TIME,
        heading: hull.rate,
        north,
        east,
        rudder: if drive.stuck[0] { 0.0 } else { servo },
        port_rudder: 0.0,
        heel: hull.heel_rate,
        heel_rate: HEEL_FREQUENCY * HEEL_FREQUENCY * (pressed - hull.heel)
            - 2.0 * HEEL_DAMPING * HEEL_FREQUENCY * hull.heel_rate,
        ship: hull.ship,
    }
}

#[cfg(test)]
mod tests {
    use super::super::hull::ShipModel;
    use super::*;

    fn sailed(rudder_deg: f64, wind: (f64, f64), seconds: f64) -> Hull {
        let mut hull = Hull::of(ShipModel::Yacht, 0.0, SPEED);
        let drive = Drive {
            order: rudder_deg.to_radians(),
            approach_speed: SPEED,
            wind_north: wind.0,
            wind_east: wind.1,
            ..Drive::default()
        };
        for _ in 0..(seconds * 10.0) as u32 {
            hull.step(&drive, 0.1);
        }
        hull
    }

    #[test]
    fn she_turns_in_about_three_lengths() {
        let hull = sailed(25.0, (0.0, 0.0), 60.0);
        let radius = hull.speed() / hull.rate;
        assert!((25.0..45.0).contains(&radius), "{radius} m");
        let other = sailed(-25.0, (0.0, 0.0), 60.0);
        assert!((hull.rate + other.rate).abs() < 1e-9, "both sides alike");
    }

    #[test]
    fn wind_across_heels_her_to_leeward_and_turns_her_into_it() {
        // From starboard.
        let hull = sailed(0.0, (0.0, 8.0), 4.0);
        assert!(hull.heel < -0.17, "heels to port: {}", hull.heel);
        assert!(hull.rate > 0.0, "turns to starboard: {}", hull.rate);
        assert!(hull.sway < 0.0, "goes to leeward: {}", hull.sway);
        let still = sailed(0.0, (0.0, 0.0), 4.0);
        assert_eq!((still.heel, still.rate, still.sway), (0.0, 0.0, 0.0));
    }
}
