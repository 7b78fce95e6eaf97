//! `[ship]`: the hull of the world station, and what is fixed on board.

use serde::Deserialize;
use wheelover_core::settings::{Rudders, Value};

/// The ship of the world station, and what is fixed on board.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Ship {
    /// A named ship: her constants, and the hull of the world station; none: her own constants below (AP-20).
    pub(crate) model: Option<Model>,
    /// Length, metres.
    pub(crate) length_m: Option<f64>,
    /// Beam, metres.
    pub(crate) beam_m: f64,
    /// Antenna of the position receiver forward of midships, metres.
    pub(crate) antenna_forward_m: f64,
    /// Antenna to starboard of the midship line, metres.
    pub(crate) antenna_starboard_m: f64,
    /// Conning position forward of midships, metres.
    pub(crate) conning_forward_m: f64,
    /// Conning position to starboard of the midship line, metres.
    pub(crate) conning_starboard_m: f64,
    /// Pivot point in a turn forward of midships, metres; none: the named ship's, else by the length.
    pub(crate) pivot_forward_m: Option<f64>,
    /// Rudder stock forward of midships, metres, so less than nothing; none: at the stern.
    pub(crate) rudder_forward_m: Option<f64>,
    /// Largest rudder angle, degrees; none: the setting `rudder_max`.
    pub(crate) rudder_max_deg: Option<f64>,
    /// Slew of the gear, degrees a second; none: the setting `rudder_slew`.
    pub(crate) rudder_slew_deg_s: Option<f64>,
    /// How her rudders hang together, those of the world station's ship too; none: the setting `rudders` (AP-4).
    pub(crate) rudders: Option<Rudders>,
    /// Where the world station starts; none: at the first waypoint.
    pub(crate) start_lat: Option<f64>,
    /// Where the world station starts; none: at the first waypoint.
    pub(crate) start_lon: Option<f64>,
    /// Heading at the start, degrees; none: the first leg's course.
    pub(crate) start_heading: Option<f64>,
    /// Nomoto gain at `speed_kn`, 1/s.
    pub(crate) gain_per_s: Option<f64>,
    /// Nomoto time constant at `speed_kn`, s.
    pub(crate) time_constant_s: Option<f64>,
    /// Steady turn, rudder (rad) over r' = r L / U: constant, r', r'^3, r'^5.
    pub(crate) steady_turn: Option<[f64; 4]>,
    /// Time from wheel-over to the start of the arc that the chart system is set to, s.
    pub(crate) forwarding_s: Option<f64>,
    /// Speed of her constants, and of the world station's ship, knots.
    pub(crate) speed_kn: Option<f64>,
    /// Direction towards which the current of the world station sets, degrees.
    pub(crate) current_set: f64,
    /// Its speed, knots.
    pub(crate) current_drift_kn: f64,
    /// Where the wind of the world station comes from, degrees.
    pub(crate) wind_from: f64,
    /// Its mean speed, knots; 0: none is measured, and none acts.
    pub(crate) wind_kn: f64,
    /// How it gusts: the deviation of its speed as a part of it.
    pub(crate) gustiness: f64,
}

/// Hull of the world station.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Model {
    /// The Mariner-class cargo ship.
    #[default]
    Mariner,
    /// A sailing yacht of eleven metres.
    Yacht,
}

impl Model {
    /// Its name in the configuration.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Mariner => "mariner",
            Self::Yacht => "yacht",
        }
    }

    /// Length that is drawn, metres, and speed, knots, where none is given.
    const fn size(self) -> (f64, f64) {
        match self {
            Self::Mariner => (160.93, 15.0),
            Self::Yacht => (11.0, 6.0),
        }
    }
}

impl Default for Ship {
    fn default() -> Self {
        Self {
            model: None,
            length_m: None,
            beam_m: 23.17,
            antenna_forward_m: 0.0,
            antenna_starboard_m: 0.0,
            conning_forward_m: 0.0,
            conning_starboard_m: 0.0,
            pivot_forward_m: None,
            rudder_forward_m: None,
            rudder_max_deg: None,
            rudder_slew_deg_s: None,
            rudders: None,
            start_lat: None,
            start_lon: None,
            start_heading: None,
            gain_per_s: None,
            time_constant_s: None,
            steady_turn: None,
            forwarding_s: None,
            speed_kn: None,
            current_set: 0.0,
            current_drift_kn: 0.0,
            wind_from: 0.0,
            wind_kn: 0.0,
            gustiness: 0.0,
        }
    }
}

impl Ship {
    /// Length that is drawn, metres.
    pub(crate) fn length(&self) -> f64 {
        self.length_m
            .unwrap_or(self.model.unwrap_or_default().size().0)
    }

    /// Speed of her constants, and of the world station's ship, knots.
    pub(crate) fn speed(&self) -> f64 {
        self.speed_kn
            .unwrap_or(self.model.unwrap_or_default().size().1)
    }

    /// What is fixed on board by the names of the settings table (AP-4, AP-16, AP-20).
    pub(super) fn on_board(&self) -> impl Iterator<Item = (&'static str, Value)> {
        let rudders = self.rudders.map(|rudders| ("rudders", rudders.value()));
        let numbers = self.constants().into_iter();
        let numbers = numbers.filter_map(|(name, value)| Some((name, Value::Number(value?))));
        rudders.into_iter().chain(numbers)
    }

    /// Her constants and offsets.
    fn constants(&self) -> [(&'static str, Option<f64>); 17] {
        let turn = |index: usize| self.steady_turn.map(|curve| curve[index]);
        let offset = |metres: f64| (metres != 0.0).then_some(metres);
        [
            ("rudder_max", self.rudder_max_deg),
            ("rudder_slew", self.rudder_slew_deg_s),
            ("antenna_forward_m", offset(self.antenna_forward_m)),
            ("antenna_starboard_m", offset(self.antenna_starboard_m)),
            ("conning_forward_m", offset(self.conning_forward_m)),
            ("conning_starboard_m", offset(self.conning_starboard_m)),
            ("pivot_forward_m", self.pivot_forward_m),
            ("rudder_forward_m", self.rudder_forward_m),
            ("length_m", self.length_m),
            ("speed_kn", self.speed_kn),
            ("gain_per_s", self.gain_per_s),
            ("time_constant_s", self.time_constant_s),
            ("steady_turn_0", turn(0)),
            ("steady_turn_1", turn(1)),
            ("steady_turn_3", turn(2)),
            ("steady_turn_5", turn(3)),
            ("forwarding_s", self.forwarding_s),
        ]
    }

    /// Values that no ship has are refused, by name and with what is allowed.
    pub(super) fn check(&self) -> Result<(), String> {
        let offset = -400.0..=400.0;
        let ranges = [
            ("length_m", self.length_m, 5.0..=460.0),
            ("beam_m", Some(self.beam_m), 1.0..=80.0),
            (
                "antenna_forward_m",
                Some(self.antenna_forward_m),
                offset.clone(),
            ),
            (
                "antenna_starboard_m",
                Some(self.antenna_starboard_m),
                offset.clone(),
            ),
            (
                "conning_forward_m",
                Some(self.conning_forward_m),
                offset.clone(),
            ),
            (
                "conning_starboard_m",
                Some(self.conning_starboard_m),
                offset.clone(),
            ),
            ("pivot_forward_m", self.pivot_forward_m, -200.0..=230.0),
            ("rudder_forward_m", self.rudder_forward_m, -230.0..=-1.0),
            ("start_lat", self.start_lat, -85.0..=85.0),
            ("start_lon", self.start_lon, -180.0..=180.0),
            ("start_heading", self.start_heading, 0.0..=360.0),
            ("speed_kn", self.speed_kn, 1.0..=40.0),
            ("current_set", Some(self.current_set), 0.0..=360.0),
            ("current_drift_kn", Some(self.current_drift_kn), 0.0..=10.0),
            ("wind_from", Some(self.wind_from), 0.0..=360.0),
            ("wind_kn", Some(self.wind_kn), 0.0..=60.0),
            ("gustiness", Some(self.gustiness), 0.0..=0.5),
        ];
        for (name, value, range) in ranges {
            if let Some(value) = value
                && !range.contains(&value)
            {
                let (low, high) = (range.start(), range.end());
                return Err(format!("{name} = {value}; allowed are {low} to {high}"));
            }
        }
        if self.start_lat.is_some() == self.start_lon.is_some() {
            Ok(())
        } else {
            Err("start_lat and start_lon go together".to_owned())
        }
    }
}
