//! From a configuration to the stations that run here.

use super::ship::Model;
use super::types::Config;
use wheelover_core::autopilot::steering::{SteeringSettings, has_own_constants};
use wheelover_core::chart_system::ChartConfig;
use wheelover_core::motor::MotorSetup;
use wheelover_core::route::embedded_start;
use wheelover_core::settings::Rudders;
use wheelover_core::station::PortSetup;
use wheelover_core::station::Role;
use wheelover_core::units::{Course, Distance, Heading, Radius, Speed};
use wheelover_core::voyage::VoyageConfig;
use wheelover_core::world::{ShipModel, WorldConfig};

impl Config {
    /// The voyage of this configuration.
    #[must_use]
    pub(crate) fn voyage(&self) -> VoyageConfig {
        let ship = &self.ship;
        let ports = self.ports.iter().enumerate().map(|(index, port)| {
            let setup = PortSetup {
                output: self.may_send(index),
                ..port.setup.clone()
            };
            (port.station, setup)
        });
        let chart = ChartConfig {
            // TCS-2: without a route there is none; the embedded one is the embedded voyage's.
            route: self.route.clone(),
            early_s: self.chart.early_s,
            soon_s: self.chart.soon_s,
            eve: self.chart.eve,
            dead_reckoning: self.chart.dead_reckoning,
            offered_radius: Radius::from_nm(self.chart.offered_radius_nm),
            offered_corridor: Distance::from_m(self.chart.offered_xtd_m),
            planned_speed: Speed::from_knots(ship.speed()),
            conning_offset_m: [
                ship.conning_forward_m - ship.antenna_forward_m,
                ship.conning_starboard_m - ship.antenna_starboard_m,
            ],
            ..ChartConfig::default()
        };
        VoyageConfig {
            embedded: false,
            roles: self.roles.clone(),
            ports: ports.collect(),
            settings: self.settings.clone(),
            ship: self.named_ship(),
            chart,
            world: self.world(),
        }
    }

    /// AP-20: a ship that is named, by `model` or by running here, brings her constants; her own ones go before.
    fn named_ship(&self) -> Option<SteeringSettings> {
        let named = self.ship.model.is_some() || self.roles.contains(&Role::World);
        named.then(|| match self.model() {
            Model::Mariner => SteeringSettings::default(),
            Model::Yacht => SteeringSettings::yacht(),
        })
    }

    fn model(&self) -> Model {
        self.ship.model.unwrap_or_default()
    }

    /// Whose constants steer, for the engineer who checks the configuration (AP-20).
    pub(super) fn constants_in_force(&self) -> &'static str {
        if has_own_constants(&self.settings) {
            "gain_per_s and time_constant_s, as given"
        } else if self.ship.model.is_some() || self.roles.contains(&Role::World) {
            match self.model() {
                Model::Mariner => "those of the model \"mariner\"",
                Model::Yacht => "those of the model \"yacht\"",
            }
        } else {
            "cautious ones, scaled from length_m and speed_kn: no track control"
        }
    }

    /// A ship that is named and has constants of her own is steered by her own.
    pub(crate) fn two_ships(&self) -> Option<String> {
        let both = self.ship.model.is_some() && has_own_constants(&self.settings);
        both.then(|| "[ship]: gain_per_s and time_constant_s steer, not those of model".to_owned())
    }

    /// The simulated ship: where she is told to be, else at the beginning of the route.
    fn world(&self) -> WorldConfig {
        let ship = &self.ship;
        let (mut start, mut heading) = embedded_start();
        if let Some(route) = &self.route {
            let document = wheelover_core::view::drawn_route(route, 0);
            if let [first, second, ..] = document.waypoints.as_slice() {
                start = first.position;
                heading = Heading::from_deg(second.course.unwrap_or_default());
            }
        }
        if let (Some(lat), Some(lon)) = (ship.start_lat, ship.start_lon) {
            start.lat = lat;
            start.lon = lon;
        }
        if let Some(told) = ship.start_heading {
            heading = Heading::from_deg(told);
        }
        WorldConfig {
            start,
            heading,
            speed: Speed::from_knots(ship.speed()),
            current_set: Course::from_deg(ship.current_set),
            current_drift: Speed::from_knots(ship.current_drift_kn),
            wind_from: Course::from_deg(ship.wind_from),
            wind_speed: Speed::from_knots(ship.wind_kn),
            gustiness: ship.gustiness,
            ship: match self.model() {
                Model::Mariner => ShipModel::Mariner,
                Model::Yacht => ShipModel::Yacht,
            },
            motor: MotorSetup::of(&self.settings).map(|setup| setup.protocol),
            pair: self.settings.rudders == Rudders::Independent,
            ..WorldConfig::default()
        }
    }
}
