//! CFG-1: a configuration printed as it is in force, with every default.

use super::built;
use super::types::{At, Config, Place, Wire, policy_name};
use std::fmt::Write;
use wheelover_core::geo::to_millimetre;
use wheelover_core::settings::{Kind, TABLE, Value};
use wheelover_core::voyage::Role;

/// The configuration as TOML that gives the same again.
#[must_use]
pub(crate) fn in_force(config: &Config) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = write(config, &mut text);
    text
}

fn write(config: &Config, out: &mut String) -> std::fmt::Result {
    let roles: Vec<String> = config
        .roles
        .iter()
        .map(|role| quoted(role.name()))
        .collect();
    writeln!(out, "roles = [{}]", roles.join(", "))?;
    writeln!(out, "listen = \"{}\"", config.listen)?;
    writeln!(out, "allow_output = {}", config.allow_output)?;
    for port in &config.ports {
        let setup = &port.setup;
        writeln!(out, "\n[[port]]\nname = {}", quoted(&setup.name))?;
        writeln!(out, "station = \"{}\"", port.station.name())?;
        let (kind, key, place) = match &port.place {
            Place::File(path) => ("file", "path", path.display().to_string()),
            Place::Serial(path, _) => ("serial", "path", path.display().to_string()),
            Place::TcpClient(address) => ("tcp-client", "address", address.clone()),
            Place::TcpServer(address) => ("tcp-server", "address", address.to_string()),
            Place::Udp(address) => ("udp", "address", address.to_string()),
        };
        writeln!(out, "kind = \"{kind}\"\n{key} = {}", quoted(&place))?;
        if let Place::Serial(_, baud) = port.place {
            writeln!(out, "baud = {baud}")?;
        }
        writeln!(out, "profile = \"{}\"", setup.profile.name())?;
        writeln!(out, "checksum = \"{}\"", policy_name(setup.checksum))?;
        if !setup.talkers.is_empty() {
            let talkers: Vec<String> = setup.talkers.iter().map(|t| quoted(t)).collect();
            writeln!(out, "talkers = [{}]", talkers.join(", "))?;
        }
        writeln!(out, "output = {}", setup.output)?;
    }
    contacts(config, out)?;
    ship(config, out)?;
    if config.roles.contains(&Role::Autopilot) {
        settings(config, out)?;
    }
    if config.roles.contains(&Role::ChartSystem) {
        chart(config, out)?;
    }
    route(config, out)
}

fn chart(config: &Config, out: &mut String) -> std::fmt::Result {
    let chart = &config.chart;
    writeln!(out, "\n[chart_system]\nearly_s = {:?}", chart.early_s)?;
    writeln!(out, "soon_s = {:?}\neve = {}", chart.soon_s, chart.eve)?;
    writeln!(out, "dead_reckoning = {}", chart.dead_reckoning)?;
    writeln!(
        out,
        "offered_radius_nm = {:?}\noffered_xtd_m = {:?}",
        chart.offered_radius_nm, chart.offered_xtd_m
    )
}

fn contacts(config: &Config, out: &mut String) -> std::fmt::Result {
    for contact in &config.contacts {
        writeln!(out, "\n[[contact]]\nwhat = \"{}\"", contact.switch.name())?;
        let (key, place) = match &contact.at {
            At::Port(port) => ("port", config.ports[*port].setup.name.clone()),
            At::Device(path) => ("path", path.display().to_string()),
            At::Chip(path) => ("gpio", path.display().to_string()),
        };
        writeln!(out, "{key} = {}", quoted(&place))?;
        match contact.line {
            Wire::Control(line) => writeln!(out, "line = \"{}\"", line.name())?,
            Wire::Gpio(line, bias) => writeln!(out, "line = {line}\nbias = \"{}\"", bias.name())?,
        }
        writeln!(out, "inverted = {}", contact.inverted)?;
    }
    Ok(())
}

fn settings(config: &Config, out: &mut String) -> std::fmt::Result {
    writeln!(out, "\n[autopilot]")?;
    for (line, (name, value)) in TABLE.iter().zip(config.settings.values()) {
        let shown = match value {
            Value::Absent => format!("# {name} ="),
            _ => format!("{name} = {}", written(&value)),
        };
        let allowed = match line.kind {
            Kind::Switch { .. } => "true or false".to_owned(),
            Kind::Choice { names, .. } => names.join(" or "),
            Kind::Number { unit, min, max, .. } => format!("{min} to {max} {unit}"),
        };
        writeln!(out, "{shown:<30}# {allowed}: {}", line.help)?;
    }
    Ok(())
}

fn ship(config: &Config, out: &mut String) -> std::fmt::Result {
    let ship = &config.ship;
    writeln!(out, "\n[ship]")?;
    if config.roles.contains(&Role::Autopilot) {
        let constants = config.constants_in_force();
        writeln!(out, "# the constants that steer (AP-20): {constants}")?;
    }
    if let Some(model) = ship.model
        && built::ship_uses("model", &config.roles)
    {
        writeln!(out, "model = {}", quoted(model.name()))?;
    }
    if let Some(rudders) = ship.rudders
        && built::ship_uses("rudders", &config.roles)
    {
        writeln!(out, "rudders = {}", written(&rudders.value()))?;
    }
    for (name, value) in [
        ("length_m", ship.length_m),
        ("beam_m", Some(ship.beam_m)),
        ("antenna_forward_m", Some(ship.antenna_forward_m)),
        ("antenna_starboard_m", Some(ship.antenna_starboard_m)),
        ("conning_forward_m", Some(ship.conning_forward_m)),
        ("conning_starboard_m", Some(ship.conning_starboard_m)),
        ("pivot_forward_m", ship.pivot_forward_m),
        ("rudder_forward_m", ship.rudder_forward_m),
        ("rudder_max_deg", ship.rudder_max_deg),
        ("rudder_slew_deg_s", ship.rudder_slew_deg_s),
        ("start_lat", ship.start_lat),
        ("start_lon", ship.start_lon),
        ("start_heading", ship.start_heading),
        ("gain_per_s", ship.gain_per_s),
        ("time_constant_s", ship.time_constant_s),
        ("forwarding_s", ship.forwarding_s),
        ("speed_kn", ship.speed_kn),
        ("current_set", Some(ship.current_set)),
        ("current_drift_kn", Some(ship.current_drift_kn)),
        ("wind_from", Some(ship.wind_from)),
        ("wind_kn", Some(ship.wind_kn)),
        ("gustiness", Some(ship.gustiness)),
    ] {
        if let Some(value) = value
            && built::ship_uses(name, &config.roles)
        {
            writeln!(out, "{name} = {value:?}")?;
        }
    }
    Ok(())
}

fn route(config: &Config, out: &mut String) -> std::fmt::Result {
    if !built::route_is_used(&config.roles) {
        return Ok(());
    }
    let Some(route) = &config.route else {
        return writeln!(
            out,
            "\n# [route]: none; a chart-system side here monitors none"
        );
    };
    let document = wheelover_core::view::drawn_route(route, 0);
    writeln!(out, "\n[route]\nname = {}", quoted(&document.name))?;
    for waypoint in &document.waypoints {
        writeln!(out, "\n[[route.waypoint]]\nid = {}", quoted(&waypoint.id))?;
        writeln!(
            out,
            "lat = {:?}\nlon = {:?}",
            to_millimetre(waypoint.position.lat),
            to_millimetre(waypoint.position.lon)
        )?;
        if let Some(radius) = waypoint.radius_nm {
            writeln!(out, "radius_nm = {:?}", (radius * 1e6).round() / 1e6)?;
        }
        writeln!(
            out,
            "xtd_port_m = {:?}\nxtd_starboard_m = {:?}",
            waypoint.xtd_m[0], waypoint.xtd_m[1]
        )?;
    }
    Ok(())
}

/// A value as TOML.
fn written(value: &Value) -> String {
    match value {
        Value::Switch(on) => on.to_string(),
        Value::Number(number) => format!("{number:?}"),
        Value::Choice(name) => quoted(name),
        Value::Absent => quoted(""),
    }
}

fn quoted(text: &str) -> String {
    format!("{text:?}").replace("\\'", "'")
}
