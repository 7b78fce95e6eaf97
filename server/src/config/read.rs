//! Reading a configuration: every mistake is one line with file, line, key and what is allowed.

use super::built;
use super::chart::Chart;
use super::contact::{ContactForm, contact};
use super::gear::Gear;
use super::port::{Mistake, PortForm, port, socket};
use super::route;
use super::rules::conflict;
use super::ship::Ship;
use super::types::{Config, Port};
use crate::error::{Error, reason};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::net::SocketAddr;
use std::path::Path;
use toml::Spanned;
use wheelover_core::settings::{Settings, TABLE, Value, definition};
use wheelover_core::voyage::Role;

/// The file as written.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct Form {
    roles: Spanned<Vec<Role>>,
    listen: Option<Spanned<String>>,
    allow_output: bool,
    port: Vec<Spanned<PortForm>>,
    contact: Vec<Spanned<ContactForm>>,
    ship: Spanned<Ship>,
    gear: Spanned<Gear>,
    autopilot: BTreeMap<Spanned<String>, Spanned<Value>>,
    chart_system: Spanned<Chart>,
    route: Option<Spanned<route::Form>>,
}

impl Default for Form {
    fn default() -> Self {
        Self {
            roles: Spanned::new(0..0, Role::ALL.to_vec()),
            listen: None,
            allow_output: false,
            port: Vec::new(),
            contact: Vec::new(),
            ship: Spanned::new(0..0, Ship::default()),
            gear: Spanned::new(0..0, Gear::default()),
            autopilot: BTreeMap::new(),
            chart_system: Spanned::new(0..0, Chart::default()),
            route: None,
        }
    }
}

/// Reads and checks a configuration.
///
/// # Errors
/// The file cannot be read, or says something that cannot be.
pub(crate) fn read(path: &Path) -> Result<Config, Error> {
    let file = path.display().to_string();
    let text = std::fs::read_to_string(path).map_err(|source| Error::File {
        path: file.clone(),
        source,
    })?;
    from_text(&file, &text, path.parent())
}

/// Checks a configuration given as text; `folder` is where its other files are looked for.
///
/// # Errors
/// It says something that cannot be.
pub(crate) fn from_text(file: &str, text: &str, folder: Option<&Path>) -> Result<Config, Error> {
    built::unbuilt(text)
        .and_then(|()| {
            toml::from_str::<Form>(text)
                .map_err(|error| (error.span().unwrap_or(0..0), in_our_words(error.message())))
        })
        .and_then(|form| check(form, folder.unwrap_or(Path::new(""))))
        .and_then(|config| built::unused(text, &config.roles).map(|()| config))
        .map_err(|(span, text_of)| Error::Config {
            file: file.to_owned(),
            line: Some(1 + text[..span.start.min(text.len())].matches('\n').count()),
            text: text_of,
        })
}

/// The parser's words, as an officer would put them.
fn in_our_words(message: &str) -> String {
    let line = message.lines().collect::<Vec<_>>().join("; ");
    line.replace("unknown field", "unknown key")
        .replace("unknown variant", "unknown value")
        .replace("missing field", "missing key")
        .replace(", expected one of ", "; allowed are ")
        .replace(", expected ", "; allowed is ")
}

fn check(form: Form, folder: &Path) -> Result<Config, Mistake> {
    let roles = roles(form.roles)?;
    let listen = match form.listen {
        None => SocketAddr::from(([127, 0, 0, 1], 8080)),
        Some(text) => socket("listen", &text)?,
    };
    let mut settings = settings(form.autopilot, &form.ship, &form.gear)?;
    let mut ports: Vec<Port> = Vec::new();
    let mut spans = Vec::new();
    for written in form.port {
        spans.push(written.span());
        if let Some(accepted) = &written.get_ref().null_status {
            settings.accept_null_status = *accepted.get_ref(); // HTC 14: one chart system a station
        }
        let span = written.span();
        ports.push(port(written.into_inner(), span, &roles, folder, &ports)?);
    }
    if let Some((number, text)) = conflict(&ports, &settings) {
        return Err((spans[number].clone(), text));
    }
    let mut contacts = Vec::new();
    for written in form.contact {
        let (span, form) = (written.span(), written.into_inner());
        contacts.push(contact(&form, span, &roles, &ports, &contacts)?);
    }
    form.ship
        .get_ref()
        .check()
        .map_err(|text| (form.ship.span(), text))?;
    let chart = *form.chart_system.get_ref();
    chart
        .check()
        .map_err(|text| (form.chart_system.span(), text))?;
    let ship = form.ship.into_inner();
    let route = match form.route {
        None => None,
        Some(written) => Some(planned(written, folder, ship.speed())?),
    };
    Ok(Config {
        roles,
        listen,
        allow_output: form.allow_output,
        ports,
        contacts,
        ship,
        settings,
        chart,
        route,
    })
}

fn roles(written: Spanned<Vec<Role>>) -> Result<Vec<Role>, Mistake> {
    let span = written.span();
    let named = written.into_inner();
    let roles: Vec<Role> = Role::ALL
        .into_iter()
        .filter(|role| named.contains(role))
        .collect();
    if roles.is_empty() || roles.len() != named.len() {
        let allowed =
            "roles must name one or more of \"autopilot\", \"chart_system\", \"world\", each once";
        return Err((span, allowed.to_owned()));
    }
    Ok(roles)
}

fn settings(
    written: BTreeMap<Spanned<String>, Spanned<Value>>,
    ship: &Spanned<Ship>,
    gear: &Spanned<Gear>,
) -> Result<Settings, Mistake> {
    for key in written.keys() {
        if definition(key.get_ref()).is_none() {
            let names: Vec<String> = TABLE
                .iter()
                .map(|line| format!("`{}`", line.name))
                .collect();
            let text = format!(
                "unknown key `{}`; allowed are {}",
                key.get_ref(),
                names.join(", ")
            );
            return Err((key.span(), text));
        }
    }
    let on_board = ship.get_ref().on_board();
    let on_board = on_board.map(|(name, value)| (name, value, ship.span()));
    let written = written.into_iter().map(|(key, value)| {
        let span = value.span();
        let name = definition(key.get_ref()).map_or("", |line| line.name);
        (name, value.into_inner(), span)
    });
    let of_gear = gear.get_ref().settings();
    let of_gear = of_gear.map_err(|text| (gear.span(), format!("[gear]: {text}")))?;
    let of_gear = of_gear.into_iter();
    let of_gear = of_gear.map(|(name, value)| (name, value, gear.span()));
    let mut left: Vec<_> = written.chain(on_board).chain(of_gear).collect();
    let mut settings = Settings::default();
    // Two that agree with each other may not agree one by one with the defaults.
    while !left.is_empty() {
        let before = left.len();
        let mut refused = None;
        left.retain(|(name, value, span)| match settings.set(name, value) {
            Ok(()) => false,
            Err(text) => {
                refused.get_or_insert((span.clone(), text));
                true
            }
        });
        if let Some(mistake) = refused.filter(|_| left.len() == before) {
            return Err(mistake);
        }
    }
    Ok(settings)
}

fn planned(
    written: Spanned<route::Form>,
    folder: &Path,
    speed_kn: f64,
) -> Result<wheelover_core::route::Route, Mistake> {
    let span = written.span();
    let mistake = |text: String| (span.clone(), format!("route: {text}"));
    let mut form = written.into_inner();
    if let Some(file) = form.file.take() {
        if !form.waypoint.is_empty() {
            return Err(mistake(
                "allowed is either file or waypoint, not both".to_owned(),
            ));
        }
        let path = folder.join(&file);
        let text = std::fs::read_to_string(&path)
            .map_err(|e| mistake(format!("{file}: {}", reason(&e))))?;
        form = toml::from_str(&text).map_err(|error| {
            let start = error.span().map_or(0, |span| span.start).min(text.len());
            let line = 1 + text[..start].matches('\n').count();
            mistake(format!("{file}:{line}: {}", in_our_words(error.message())))
        })?;
    }
    let name = form.name.unwrap_or_else(|| "route".to_owned());
    route::route(&name, &form.waypoint, speed_kn).map_err(mistake)
}
