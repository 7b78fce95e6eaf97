//! The first line of a recording: format, program, seed, configuration and settings, each by a name chosen for it.
//!
//! In: how a voyage is made. Out: its form, and from the form the same again. The names and units here are the
//! format (`docs/recording.md`); what they are called in the program may change without it.

use crate::autopilot::steering::SteeringSettings;
use crate::chart_system::ChartConfig;
use crate::geo::Position;
use crate::motor::Protocol;
use crate::route::{Route, RouteFault, RouteLimits, Waypoint};
use crate::settings::{Settings, Value};
use crate::station::{ChecksumPolicy, PortSetup, Profile, Role};
use crate::units::{Course, Distance, Heading, Radius, RateOfTurn, RudderAngle, Speed};
use crate::voyage::VoyageConfig;
use crate::world::{Noise, ShipModel, WorldConfig};
use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Raised whenever an older recording has to be read in another way.
pub const FORMAT: u32 = 2;

/// The form of a struct: a key for each of its fields. A key that an older file lacks has its value by default;
/// a field without a key does not compile.
macro_rules! form {
    ($form:ident of $real:ty { $($key:ident: $type:ty = $field:ident;)* } $(rest { $($rest:ident: $value:expr;)* })?) => {
        #[derive(Clone, Debug, Serialize, Deserialize)]
        #[serde(deny_unknown_fields, default)]
        struct $form { $($key: $type,)* }
        impl From<&$real> for $form {
            fn from(real: &$real) -> Self {
                Self { $($key: real.$field.clone(),)* }
            }
        }
        impl From<$form> for $real {
            fn from(form: $form) -> Self {
                Self { $($field: form.$key,)* $($($rest: $value,)*)? }
            }
        }
        impl Default for $form {
            fn default() -> Self {
                Self::from(&<$real>::default())
            }
        }
    };
}

form!(Ship of SteeringSettings {
    length_m: f64 = length;
    reference_speed_mps: Speed = reference_speed;
    gain_per_s: f64 = gain;
    time_constant_s: f64 = time_constant;
    steady_turn_rad: [f64; 4] = steady_turn;
    steady_turn_limit_deg: RudderAngle = steady_turn_limit;
    quick_share: f64 = quick_share;
    quick_time_s: f64 = quick_time;
    sway_m: f64 = sway;
    sway_lag_s: f64 = sway_lag;
    natural_frequency_rad_per_s: f64 = natural_frequency;
    damping: f64 = damping;
    integral_share: f64 = integral_share;
    look_ahead_s: f64 = look_ahead;
    cross_track_integral: f64 = cross_track_integral;
    approach_angle_deg: f64 = approach_angle;
    curvature_window_s: f64 = curvature_window;
    curvature_lead_s: f64 = curvature_lead;
    current_time_s: f64 = current_time;
    fix_time_s: f64 = fix_time;
    yaw_disturbance: f64 = yaw_disturbance;
    slew_deg_per_s: f64 = slew;
    rudder_max_deg: RudderAngle = rudder_max;
    free_rate_deg_per_min: RateOfTurn = free_rate;
    turn_acceleration_deg_per_s2: f64 = turn_acceleration;
    wave_yaw_deg: f64 = wave_yaw;
    wave_frequency_rad_per_s: f64 = wave_frequency;
    cruise_speed_mps: Speed = cruise_speed;
    minimum_speed_mps: Speed = minimum_speed;
    known: bool = known;
});

form!(Chart of ChartConfig {
    forwarding_s: Option<f64> = forwarding_s;
    forwarding_tn_s: f64 = forwarding_tn_s;
    early_s: f64 = early_s;
    soon_s: f64 = soon_s;
    eve: bool = eve;
    dead_reckoning: bool = dead_reckoning;
    begin_cross_track_m: Distance = begin_cross_track;
    begin_angle_deg: f64 = begin_angle_deg;
    offered_radius_m: Radius = offered_radius;
    offered_corridor_m: Distance = offered_corridor;
    planned_speed_mps: Speed = planned_speed;
    conning_offset_m: [f64; 2] = conning_offset_m;
} rest { route: None; ports: Vec::new(); });

form!(World of WorldConfig {
    start: Position = start;
    heading_deg: Heading = heading;
    speed_mps: Speed = speed;
    current_set_deg: Course = current_set;
    current_drift_mps: Speed = current_drift;
    wind_from_deg: Course = wind_from;
    wind_mps: Speed = wind_speed;
    gustiness: f64 = gustiness;
    ship: ShipModel = ship;
    motor: Option<Protocol> = motor;
    pair_of_rudders: bool = pair;
} rest { seed: 0; ports: Vec::new(); noise: Noise::default(); });

form!(Deviations of Noise {
    wave_yaw_deg: f64 = wave_yaw;
    wave_frequency_rad_per_s: f64 = wave_frequency;
    gyro_deg: f64 = gyro;
    rate_deg_per_s: f64 = rate;
    position_drift_m: f64 = position_drift;
    position_m: f64 = position;
    velocity_mps: f64 = velocity;
});

form!(Limits of RouteLimits {
    speed_mps: Speed = speed;
    forwarding_s: f64 = forwarding_s;
    early_s: f64 = early_s;
    settling_m: Distance = settling;
    smallest_radius_m: Radius = smallest_radius;
    largest_radius_m: Radius = largest_radius;
    highest_rate_deg_per_min: RateOfTurn = highest_rate;
    largest_turn_deg: f64 = largest_turn_deg;
});

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Mark {
    id: String,
    lat: f64,
    lon: f64,
    radius_m: Option<Radius>,
    limit_port_m: Distance,
    limit_starboard_m: Distance,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Plan {
    name: String,
    waypoints: Vec<Mark>,
    limits: Limits,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Port {
    station: Role,
    name: String,
    profile: Profile,
    checksum: ChecksumPolicy,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    talkers: Vec<String>,
    baud: u32,
    output: bool,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Configuration {
    /// The scripted officer sails the route round and round.
    embedded: bool,
    roles: Vec<Role>,
    ports: Vec<Port>,
    route: Option<Plan>,
    /// The named ship; none where only the settings know her.
    ship: Option<Ship>,
    chart_system: Chart,
    world: World,
    noise: Deviations,
}

/// The first line.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Beginning {
    recording: u32,
    pub(super) program: String,
    seed: u64,
    configuration: Configuration,
    settings: BTreeMap<String, Value>,
}

impl Beginning {
    /// The form of a voyage that has not begun.
    pub(super) fn of(config: &VoyageConfig, program: &str) -> Self {
        let ports = config.ports.iter().map(|(station, setup)| Port {
            station: *station,
            name: setup.name.clone(),
            profile: setup.profile,
            checksum: setup.checksum,
            talkers: setup.talkers.clone(),
            baud: setup.baud,
            output: setup.output,
        });
        Self {
            recording: FORMAT,
            program: program.to_string(),
            seed: config.world.seed,
            configuration: Configuration {
                embedded: config.embedded,
                roles: config.roles.clone(),
                ports: ports.collect(),
                route: config.chart.route.as_ref().map(plan),
                ship: config.ship.as_ref().map(Ship::from),
                chart_system: Chart::from(&config.chart),
                world: World::from(&config.world),
                noise: Deviations::from(&config.world.noise),
            },
            settings: config.settings.values().into_iter().collect(),
        }
    }

    /// The voyage again, and what of it this program does not take as it was.
    ///
    /// # Errors
    /// The route does not fit by the rules of this program.
    pub(super) fn voyage(self) -> Result<(VoyageConfig, Vec<String>), RouteFault> {
        let form = self.configuration;
        let (settings, notes) = settings(self.settings);
        let ports = form.ports.into_iter().map(|port| {
            let setup = PortSetup {
                name: port.name,
                profile: port.profile,
                checksum: port.checksum,
                talkers: port.talkers,
                baud: port.baud,
                output: port.output,
            };
            (port.station, setup)
        });
        let config = VoyageConfig {
            embedded: form.embedded,
            roles: form.roles,
            ports: ports.collect(),
            settings,
            ship: form.ship.map(Ship::into),
            chart: ChartConfig {
                route: form.route.map(route).transpose()?,
                ..form.chart_system.into()
            },
            world: WorldConfig {
                seed: self.seed,
                noise: form.noise.into(),
                ..form.world.into()
            },
        };
        Ok((config, notes))
    }
}

/// Settings by name. They may have to agree with each other, so that the order in which they are set matters.
fn settings(mut values: BTreeMap<String, Value>) -> (Settings, Vec<String>) {
    let mut settings = Settings::default();
    loop {
        let before = values.len();
        values.retain(|name, value| settings.set(name, value).is_err());
        if values.len() == before {
            break;
        }
    }
    let why = |(name, value): (&String, &Value)| {
        let refused = settings.clone().set(name, value).err();
        refused.map(|why| format!("setting {name}: {why}"))
    };
    let notes = values.iter().filter_map(why).collect();
    (settings, notes)
}

fn plan(route: &Route) -> Plan {
    let mark = |waypoint: &Waypoint| Mark {
        id: waypoint.id.clone(),
        lat: waypoint.position.lat,
        lon: waypoint.position.lon,
        radius_m: waypoint.radius,
        limit_port_m: waypoint.limit_port,
        limit_starboard_m: waypoint.limit_starboard,
    };
    Plan {
        name: route.name().to_string(),
        waypoints: route.waypoints().iter().map(mark).collect(),
        limits: Limits::from(route.limits()),
    }
}

fn route(plan: Plan) -> Result<Route, RouteFault> {
    let waypoint = |mark: Mark| Waypoint {
        id: mark.id,
        position: Position {
            lat: mark.lat,
            lon: mark.lon,
        },
        radius: mark.radius_m,
        limit_port: mark.limit_port_m,
        limit_starboard: mark.limit_starboard_m,
    };
    let waypoints = plan.waypoints.into_iter().map(waypoint).collect();
    Route::new(&plan.name, waypoints, plan.limits.into())
}
