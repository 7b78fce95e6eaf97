//! The ship's constants as they were given, and cautious ones where nobody gave them (AP-20).
//!
//! Everything that a ship does in time scales with `L/U`, her rate of turn with `U/L` (Nomoto 1957: `K' = K L/U`,
//! `T' = T U/L`). Gain and time constant, where given, replace the scaled ones; without a steady-turn curve it is the
//! straight line `delta = r'/K'`.

use super::settings::SteeringSettings;
use crate::settings::Settings;
use crate::units::{RateOfTurn, RudderAngle, Speed};

/// Length and speed where nobody gave them.
const LENGTH_M: f64 = 100.0;
const SPEED_KN: f64 = 12.0;
/// Cautious: the ship is thought to answer the rudder better than most, so that the gains stay low.
const CAUTIOUS_GAIN: f64 = 1.3;
const CAUTIOUS_FREQUENCY: f64 = 0.7;
/// A rudder's lever as a part of half the length: what is farther in or out is no rudder of hers.
const LEVER: (f64, f64) = (0.3, 1.2);

impl SteeringSettings {
    /// The ship as the settings have her: her own constants where gain and time constant are given, else those of the
    /// named ship, else cautious ones. The one rule for the start and for every change (AP-20).
    #[must_use]
    pub fn of(named: Option<&Self>, settings: &Settings) -> Self {
        let mut ship = match named {
            Some(named) if !has_own_constants(settings) => named.clone(),
            _ => Self::cautious(settings),
        };
        // AP-16: what is controlled is the conning position, and it drifts by how far from it the pivot point lies.
        ship.sway = settings.pivot_forward_m.unwrap_or(ship.sway) - settings.conning_forward_m;
        ship.slew = settings.rudder_slew;
        ship.rudder_max = RudderAngle::from_deg(settings.rudder_max);
        ship
    }

    /// A ship of whom length and speed are known at best; what else is given in the settings is taken from there.
    #[must_use]
    pub fn cautious(settings: &Settings) -> Self {
        let like = Self::default();
        let length = settings.length_m.unwrap_or(LENGTH_M);
        let speed = Speed::from_knots(settings.speed_kn.unwrap_or(SPEED_KN));
        let time = (length / speed.mps()) / (like.length / like.reference_speed.mps());
        // AP-16: the moment of the rudder, by its lever from midships.
        let lever = settings.rudder_forward_m.map_or(1.0, |forward| {
            let (least, most) = LEVER;
            (-forward / (0.5 * length)).clamp(least, most)
        });
        let gain = CAUTIOUS_GAIN * like.gain / time * lever;
        let scaled = Self {
            length,
            reference_speed: speed,
            gain,
            time_constant: like.time_constant * time,
            steady_turn: straight(gain, length, speed),
            quick_share: 0.0,
            quick_time: like.quick_time * time,
            sway: like.sway * length / like.length,
            sway_lag: like.sway_lag * time,
            natural_frequency: CAUTIOUS_FREQUENCY * like.natural_frequency / time,
            look_ahead: like.look_ahead * time,
            curvature_window: like.curvature_window * time,
            free_rate: RateOfTurn::from_deg_per_min(like.free_rate.deg_per_min() / time),
            turn_acceleration: like.turn_acceleration / (time * time),
            yaw_disturbance: like.yaw_disturbance / (time * libm::sqrt(time)),
            cruise_speed: speed,
            known: false,
            ..like
        };
        scaled.given(settings)
    }

    /// The yacht of the world station, by her first-order constants.
    #[must_use]
    pub fn yacht() -> Self {
        Self::cautious(&Settings {
            length_m: Some(10.0),
            speed_kn: Some(6.0),
            gain_per_s: Some(0.25),
            time_constant_s: Some(2.0),
            ..Settings::default()
        })
    }

    /// With the constants that are given in the settings.
    fn given(mut self, settings: &Settings) -> Self {
        let (Some(gain), Some(time_constant)) = (settings.gain_per_s, settings.time_constant_s)
        else {
            return self;
        };
        if !self.known {
            self.natural_frequency /= CAUTIOUS_FREQUENCY;
        }
        self.gain = gain;
        self.time_constant = time_constant;
        self.quick_share = 0.0;
        self.known = true;
        self.steady_turn = match (
            settings.steady_turn_0,
            settings.steady_turn_1,
            settings.steady_turn_3,
            settings.steady_turn_5,
        ) {
            (c0, Some(c1), c3, c5) => [
                c0.unwrap_or_default(),
                c1,
                c3.unwrap_or_default(),
                c5.unwrap_or_default(),
            ],
            _ => straight(gain, self.length, self.reference_speed),
        };
        self
    }
}

/// Whether the settings hold her own constants: gain and time constant go together (AP-20).
#[must_use]
pub const fn has_own_constants(settings: &Settings) -> bool {
    settings.gain_per_s.is_some() && settings.time_constant_s.is_some()
}

/// The steady turn of a first-order ship.
fn straight(gain: f64, length: f64, speed: Speed) -> [f64; 4] {
    [0.0, speed.mps() / (gain * length), 0.0, 0.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    // AP-20
    #[test]
    fn a_ship_of_the_same_length_and_speed_has_the_same_times() {
        let settings = Settings {
            length_m: Some(160.93),
            speed_kn: Some(15.0),
            ..Settings::default()
        };
        let cautious = SteeringSettings::cautious(&settings);
        let like = SteeringSettings::default();
        assert!(!cautious.known);
        assert!((cautious.time_constant - like.time_constant).abs() < 1e-9);
        assert!((cautious.look_ahead - like.look_ahead).abs() < 1e-9);
        assert!(cautious.natural_frequency < like.natural_frequency);
    }

    // AP-20: one rule, whatever was given before
    #[test]
    fn her_own_constants_come_before_a_named_ship_and_a_named_ship_before_cautious_ones() {
        let named = SteeringSettings::default();
        let mut settings = Settings {
            rudder_slew: named.slew,
            ..Settings::default()
        };
        assert!(!SteeringSettings::of(None, &settings).known);
        assert_eq!(SteeringSettings::of(Some(&named), &settings), named);
        settings.gain_per_s = Some(0.1);
        assert_eq!(SteeringSettings::of(Some(&named), &settings), named);
        settings.time_constant_s = Some(60.0);
        let own = SteeringSettings::of(Some(&named), &settings);
        assert_eq!((own.gain, own.time_constant), (0.1, 60.0));
        assert_eq!(own, SteeringSettings::of(None, &settings));
        settings.gain_per_s = None;
        assert_eq!(SteeringSettings::of(Some(&named), &settings), named);
    }

    // AP-16: the pivot point is the one that is given, else the ship's; the conning position on it does not drift.
    #[test]
    fn the_conning_position_drifts_by_its_distance_from_the_pivot_point() {
        let named = SteeringSettings::default();
        let sway = |pivot: Option<f64>, conning: f64| {
            let settings = Settings {
                pivot_forward_m: pivot,
                conning_forward_m: conning,
                ..Settings::default()
            };
            SteeringSettings::of(Some(&named), &settings).sway
        };
        assert_eq!(sway(None, 0.0), named.sway);
        assert_eq!(sway(Some(60.0), 0.0), 60.0);
        assert_eq!(sway(Some(60.0), 60.0), 0.0);
        assert_eq!(sway(Some(60.0), -20.0), 80.0);
        assert_eq!(sway(None, 10.0), named.sway - 10.0);
    }

    // AP-16, AP-20: a rudder that stands farther in turns her less; her own constants have it in them.
    #[test]
    fn a_rudder_with_a_shorter_lever_turns_the_cautious_ship_less() {
        let ship = |rudder: Option<f64>, gain: Option<f64>| {
            let settings = Settings {
                length_m: Some(100.0),
                rudder_forward_m: rudder,
                gain_per_s: gain,
                time_constant_s: gain.map(|_| 60.0),
                ..Settings::default()
            };
            SteeringSettings::of(None, &settings)
        };
        let aft = ship(Some(-50.0), None);
        assert_eq!(aft, ship(None, None));
        let inner = ship(Some(-25.0), None);
        assert!((inner.gain - 0.5 * aft.gain).abs() < 1e-12);
        assert!(inner.steady_turn[1] > 1.9 * aft.steady_turn[1]);
        assert_eq!(ship(Some(-25.0), Some(0.1)), ship(None, Some(0.1)));
    }

    #[test]
    fn given_constants_make_a_known_ship() {
        let mut settings = Settings {
            gain_per_s: Some(0.1),
            ..Settings::default()
        };
        assert!(
            !SteeringSettings::cautious(&settings).known,
            "one is not enough"
        );
        settings.time_constant_s = Some(60.0);
        let given = SteeringSettings::cautious(&settings);
        assert!(given.known);
        assert_eq!((given.gain, given.time_constant), (0.1, 60.0));
        assert!(given.smallest_radius().m() >= 0.9 * given.length);
    }
}
