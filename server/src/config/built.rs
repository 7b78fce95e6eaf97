//! What a configuration may name that is not built yet, or that no station here would use: refused, since an
//! engineer who wrote it would rely on it.
//!
//! Who builds one takes its name out of these lists.

use super::port::Mistake;
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::{Spanned, Value};
use wheelover_core::voyage::Role;

/// Keys of the file, its sections, ports and ship.
const KEYS: [&str; 2] = ["commissioning", "skipped_by"];

/// Profiles of ports.
const PROFILES: [&str; 1] = ["targets"];

/// Keys of `[ship]` that only some stations use.
const SHIP: [(&str, &[Role]); 21] = [
    ("model", &[Role::Autopilot, Role::World]),
    ("antenna_forward_m", &[Role::Autopilot, Role::ChartSystem]),
    ("antenna_starboard_m", &[Role::Autopilot, Role::ChartSystem]),
    ("conning_forward_m", &[Role::Autopilot, Role::ChartSystem]),
    ("conning_starboard_m", &[Role::Autopilot, Role::ChartSystem]),
    ("pivot_forward_m", &[Role::Autopilot]),
    ("rudder_forward_m", &[Role::Autopilot]),
    ("rudder_max_deg", &[Role::Autopilot]),
    ("rudder_slew_deg_s", &[Role::Autopilot]),
    ("rudders", &[Role::Autopilot, Role::World]),
    ("start_lat", &[Role::World]),
    ("start_lon", &[Role::World]),
    ("start_heading", &[Role::World]),
    ("gain_per_s", &[Role::Autopilot]),
    ("time_constant_s", &[Role::Autopilot]),
    ("steady_turn", &[Role::Autopilot]),
    ("current_set", &[Role::World]),
    ("current_drift_kn", &[Role::World]),
    ("wind_from", &[Role::World]),
    ("wind_kn", &[Role::World]),
    ("gustiness", &[Role::World]),
];

/// Which keys were written, with their places.
#[derive(Default, Deserialize)]
#[serde(default)]
struct Written {
    port: Vec<BTreeMap<Spanned<String>, Spanned<Value>>>,
    ship: BTreeMap<Spanned<String>, Value>,
    autopilot: Option<Spanned<BTreeMap<Spanned<String>, Value>>>,
    gear: Option<Spanned<Value>>,
    chart_system: Option<Spanned<Value>>,
    route: Option<Spanned<Value>>,
    #[serde(flatten)]
    rest: BTreeMap<String, Value>,
}

/// Whether a key of `[ship]` is used by a station that runs here.
pub(super) fn ship_uses(name: &str, roles: &[Role]) -> bool {
    let row = SHIP.iter().find(|(key, _)| *key == name);
    !KEYS.contains(&name) && row.is_none_or(|(_, users)| uses(users, roles))
}

/// Whether a route is used by a station that runs here.
pub(super) fn route_is_used(roles: &[Role]) -> bool {
    uses(&[Role::ChartSystem, Role::World], roles)
}

fn uses(users: &[Role], roles: &[Role]) -> bool {
    users.iter().any(|user| roles.contains(user))
}

/// What is written and not built, whatever else the file says.
pub(super) fn unbuilt(text: &str) -> Result<(), Mistake> {
    let refuse = |key: &Spanned<String>| match KEYS.contains(&key.get_ref().as_str()) {
        true => Err((key.span(), not_built(key.get_ref()))),
        false => Ok(()),
    };
    let written = written(text);
    written.ship.keys().try_for_each(refuse)?;
    for port in &written.port {
        port.keys().try_for_each(refuse)?;
        for (key, value) in port {
            if key.get_ref() == "profile"
                && let Some(name) = value.get_ref().as_str()
                && PROFILES.contains(&name)
            {
                let text = format!("profile = \"{name}\" is not built yet");
                return Err((value.span(), text));
            }
        }
    }
    if let Some(section) = written.rest.keys().find(|key| KEYS.contains(&key.as_str())) {
        let at = text.find(&format!("[{section}]")).unwrap_or_default();
        return Err((at..at, not_built(section)));
    }
    Ok(())
}

/// What is written and used by no station that runs here.
pub(super) fn unused(text: &str, roles: &[Role]) -> Result<(), Mistake> {
    let nobody = |users: &[Role]| {
        let names: Vec<&str> = users.iter().map(|role| role.name()).collect();
        format!(
            "only {} uses it, which does not run here",
            names.join(" or ")
        )
    };
    let written = written(text);
    for key in written.ship.keys() {
        let row = SHIP.iter().find(|(name, _)| name == key.get_ref());
        if let Some((name, users)) = row
            && !uses(users, roles)
        {
            return Err((key.span(), format!("`{name}`: {}", nobody(users))));
        }
    }
    if let Some(table) = &written.autopilot
        && !roles.contains(&Role::Autopilot)
    {
        let text = format!("[autopilot]: {}", nobody(&[Role::Autopilot]));
        return Err((table.span(), text));
    }
    if let Some(gear) = &written.gear
        && !uses(&[Role::Autopilot, Role::World], roles)
    {
        let text = format!("[gear]: {}", nobody(&[Role::Autopilot, Role::World]));
        return Err((gear.span(), text));
    }
    if let Some(chart) = &written.chart_system
        && !roles.contains(&Role::ChartSystem)
    {
        let text = format!("[chart_system]: {}", nobody(&[Role::ChartSystem]));
        return Err((chart.span(), text));
    }
    if let Some(route) = &written.route
        && !route_is_used(roles)
    {
        let text = format!("[route]: {}", nobody(&[Role::ChartSystem, Role::World]));
        return Err((route.span(), text));
    }
    Ok(())
}

/// The keys; none where the text is no TOML, of which others complain.
fn written(text: &str) -> Written {
    toml::from_str(text).unwrap_or_default()
}

fn not_built(name: &str) -> String {
    format!("`{name}` is not built yet")
}
