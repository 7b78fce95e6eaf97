//! Recordings of format 1, which began with an image of the stations' own structs, brought to today's format.
//!
//! Of the image only what made the stations is taken. That is enough where they had not begun to run, as in every
//! file that `--record` wrote; an image from the middle of a voyage is refused.

use super::entry::{Bytes, Entry, Timed};
use super::form::FORMAT;
use crate::command::{Answer, Order, Origin};
use crate::settings::{self, Kind, Value as Setting};
use crate::time::Stamp;
use crate::voyage::{Line, VoyageOutput};
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::Deserialize;
use serde_json::{Map, Value, json};

type Names = &'static [(&'static str, &'static str)];

const SHIP: Names = &[
    ("length", "length_m"),
    ("reference_speed", "reference_speed_mps"),
    ("gain", "gain_per_s"),
    ("time_constant", "time_constant_s"),
    ("steady_turn", "steady_turn_rad"),
    ("steady_turn_limit", "steady_turn_limit_deg"),
    ("quick_share", "quick_share"),
    ("quick_time", "quick_time_s"),
    ("sway", "sway_m"),
    ("sway_lag", "sway_lag_s"),
    ("natural_frequency", "natural_frequency_rad_per_s"),
    ("damping", "damping"),
    ("integral_share", "integral_share"),
    ("look_ahead", "look_ahead_s"),
    ("cross_track_integral", "cross_track_integral"),
    ("approach_angle", "approach_angle_deg"),
    ("curvature_window", "curvature_window_s"),
    ("curvature_lead", "curvature_lead_s"),
    ("current_time", "current_time_s"),
    ("fix_time", "fix_time_s"),
    ("yaw_disturbance", "yaw_disturbance"),
    ("slew", "slew_deg_per_s"),
    ("rudder_max", "rudder_max_deg"),
    ("free_rate", "free_rate_deg_per_min"),
    ("turn_acceleration", "turn_acceleration_deg_per_s2"),
    ("wave_yaw", "wave_yaw_deg"),
    ("wave_frequency", "wave_frequency_rad_per_s"),
    ("cruise_speed", "cruise_speed_mps"),
    ("minimum_speed", "minimum_speed_mps"),
    ("known", "known"),
];
const CHART: Names = &[
    ("forwarding_s", "forwarding_s"),
    ("forwarding_tn_s", "forwarding_tn_s"),
    ("early_s", "early_s"),
    ("soon_s", "soon_s"),
    ("begin_cross_track", "begin_cross_track_m"),
    ("begin_angle_deg", "begin_angle_deg"),
    ("conning_offset_m", "conning_offset_m"),
];
const WORLD: Names = &[
    ("start", "start"),
    ("heading", "heading_deg"),
    ("speed", "speed_mps"),
    ("current_set", "current_set_deg"),
    ("current_drift", "current_drift_mps"),
];
const NOISE: Names = &[
    ("wave_yaw", "wave_yaw_deg"),
    ("wave_frequency", "wave_frequency_rad_per_s"),
    ("gyro", "gyro_deg"),
    ("rate", "rate_deg_per_s"),
    ("position_drift", "position_drift_m"),
    ("position", "position_m"),
    ("velocity", "velocity_mps"),
];
const LIMITS: Names = &[
    ("speed", "speed_mps"),
    ("forwarding_s", "forwarding_s"),
    ("early_s", "early_s"),
    ("settling", "settling_m"),
    ("smallest_radius", "smallest_radius_m"),
    ("largest_radius", "largest_radius_m"),
    ("highest_rate", "highest_rate_deg_per_min"),
    ("largest_turn_deg", "largest_turn_deg"),
];

fn named(object: &Value, names: Names) -> Value {
    let known = names.iter().filter_map(|(before, now)| {
        let value = object.get(before)?;
        Some(((*now).to_string(), value.clone()))
    });
    Value::Object(known.collect::<Map<_, _>>())
}

fn route(before: &Value) -> Option<Value> {
    let waypoints = before.get("waypoints")?.as_array()?.iter().map(|waypoint| {
        json!({
            "id": waypoint["id"],
            "lat": waypoint["position"]["lat"],
            "lon": waypoint["position"]["lon"],
            "radius_m": waypoint["radius"],
            "limit_port_m": waypoint["limit_port"],
            "limit_starboard_m": waypoint["limit_starboard"],
        })
    });
    Some(json!({
        "name": before["name"],
        "waypoints": waypoints.collect::<Vec<_>>(),
        "limits": named(&before["limits"], LIMITS),
    }))
}

/// Settings as they are written today: a switch was the number 0 or 1. Kept settings of that time have no version and are set
/// aside by the server, so that recordings are the only files that are read so.
fn settings(before: Option<&Value>) -> Value {
    let switch = |name: &str| {
        let kind = settings::definition(name).map(|definition| definition.kind);
        matches!(kind, Some(Kind::Switch { .. }))
    };
    let now = |(name, value): (&String, &Value)| {
        let value = match value.as_f64() {
            Some(number) if switch(name) && (number == 0.0 || number == 1.0) => {
                json!(number == 1.0)
            }
            _ => value.clone(),
        };
        (name.clone(), value)
    };
    let before = before.and_then(Value::as_object);
    Value::Object(before.into_iter().flatten().map(now).collect())
}

/// Today's first line, and what stands behind it; nothing where the image is no beginning.
pub(super) fn beginning(first: &Value) -> Option<(Value, Option<Timed>)> {
    let image = first.pointer("/checkpoint/voyage")?;
    if image["now"] != 0 {
        return None;
    }
    let (autopilot, chart, world) = (&image["autopilot"], &image["chart"], &image["world"]);
    let roles: Vec<&str> = [
        ("autopilot", autopilot),
        ("chart_system", chart),
        ("world", world),
    ]
    .into_iter()
    .filter_map(|(role, station)| (!station.is_null()).then_some(role))
    .collect();
    let ports = image["outside"].as_array()?.iter().map(|end| {
        let setups = match end[0].as_str()? {
            "autopilot" => autopilot
                .pointer("/post/picture/ports")
                .or_else(|| autopilot.pointer("/picture/ports"))?,
            "chart_system" => &chart["config"]["ports"],
            _ => &world["config"]["ports"],
        };
        let mut setup = setups.get(end[1].as_u64()? as usize)?.clone();
        setup["station"] = end[0].clone();
        Some(setup)
    });
    // What is not her own was scaled from the settings.
    let ship = &autopilot["steering"]["settings"];
    let named_ship = ship.is_object() && ship["known"] != false;
    let world = &world["config"];
    let beginning = json!({
        "recording": FORMAT,
        "program": "",
        "seed": world["seed"].as_u64().unwrap_or_default(),
        "configuration": {
            "embedded": !image["embedded"].is_null(),
            "roles": roles,
            "ports": ports.collect::<Option<Vec<_>>>()?,
            "route": route(&chart["config"]["route"]),
            "ship": named_ship.then(|| named(ship, SHIP)),
            "chart_system": named(&chart["config"], CHART),
            "world": named(world, WORLD),
            "noise": named(&world["noise"], NOISE),
        },
        "settings": settings(autopilot.get("settings")),
    });
    // What came out while the pace was set was not written.
    let begun = image["line"] != 0;
    Some((
        beginning,
        begun.then_some(Timed(Stamp(0), Entry::OutputsBegin)),
    ))
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Before {
    Event(Stamp, Event),
    Output(Stamp, #[serde(with = "Output")] VoyageOutput),
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Event {
    Bytes {
        port: usize,
        bytes: Vec<u8>,
    },
    PortUp {
        port: usize,
        up: bool,
    },
    Order {
        id: u64,
        by: Origin,
        order: Order,
    },
    /// An order before it was said whose it is.
    Command {
        id: u64,
        action: Order,
    },
    Stalled {
        ms: u64,
    },
    Tick,
}

#[derive(Deserialize)]
#[serde(remote = "VoyageOutput", rename_all = "snake_case")]
enum Output {
    Send { port: usize, bytes: Vec<u8> },
    Line(Line),
    Answer(Answer),
    Persist { key: String, value: Setting },
    Route,
    Settings,
}

/// A further line of format 1.
///
/// # Errors
/// What is wrong with it.
pub(super) fn entry(line: &str) -> Result<Timed, serde_json::Error> {
    Ok(match serde_json::from_str(line)? {
        Before::Event(at, event) => Timed(at, event.into()),
        Before::Output(at, output) => Timed(at, output.into()),
    })
}

impl From<Event> for Entry {
    fn from(event: Event) -> Self {
        match event {
            Event::Bytes { port, bytes } => Self::Heard(port, Bytes(bytes)),
            Event::PortUp { port, up } => Self::Up(port, up),
            Event::Order { id, by, order } => Self::Order { id, by, order },
            Event::Command { id, action } => Self::Order {
                id,
                by: Origin::Officer,
                order: action,
            },
            Event::Stalled { ms } => Self::Stalled(ms),
            Event::Tick => Self::Tick,
        }
    }
}
