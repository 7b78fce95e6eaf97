//! What a voyage shows: first frame, snapshot, and the documents.

use super::message::{
    AlertView, Hello, Outline, PROTOCOL, PortView, PortsDocument, RouteDocument, SettingsDocument,
    Snapshot, VoyageOwn,
};
use super::own::{alert, chart_own, heard_alert, own};
use super::route::drawn_route;
use crate::chart_system::ChartSystem;
use crate::picture::PortCount;
use crate::station::PortSetup;
use crate::voyage::Voyage;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// Own facts; the caller gives the frame its number.
#[must_use]
pub fn snapshot(voyage: &Voyage) -> Snapshot {
    let now = voyage.now();
    Snapshot {
        frame: 0,
        at: now.0,
        rate: voyage.rate(),
        line: voyage.line(),
        digest: voyage.picture().digest(),
        own: voyage.autopilot().map(|autopilot| own(autopilot, now)),
        chart: voyage.chart_system().map(chart_own),
        voyage: voyage.is_embedded().then(|| voyage_own(voyage)),
        alerts: voyage
            .alerts()
            .into_iter()
            .map(|standing| alert(standing, voyage.autopilot()))
            .chain(heard_alerts(voyage))
            .collect(),
    }
}

/// Alerts of a foreign autopilot, as our chart system hears them (TCS-13).
fn heard_alerts(voyage: &Voyage) -> impl Iterator<Item = AlertView> {
    let foreign = voyage
        .chart_system()
        .filter(|_| voyage.autopilot().is_none());
    let heard = foreign.into_iter().flat_map(ChartSystem::heard_alerts);
    heard.filter_map(heard_alert)
}

fn voyage_own(voyage: &Voyage) -> VoyageOwn {
    let current = voyage.world().map(crate::world::World::current);
    VoyageOwn {
        officer: voyage.officer_has_the_watch(),
        round: voyage.round(),
        speed: voyage.pace(),
        faults: voyage.faults(),
        current: current.map_or([0.0; 2], |(set, drift)| [set.deg(), drift.knots()]),
    }
}

/// First frame of a connection; the caller says whether that client may command, and how large a real ship is.
#[must_use]
pub fn hello(voyage: &Voyage, build: &str) -> Hello {
    let picture = voyage.picture();
    Hello {
        protocol: PROTOCOL,
        build: build.to_string(),
        dictionary: crate::nmea::dictionary().len() as u32,
        picture: picture.clone(),
        line: voyage.line(),
        at: voyage.now().0,
        rate: voyage.rate(),
        ports: picture.ports.clone(),
        station: voyage.shown().name().to_string(),
        ship: Outline::default(),
        simulated: voyage.is_embedded(),
        may_command: false,
    }
}

/// The route with its geometry; empty where the chart system is a foreign one.
#[must_use]
pub fn route_document(voyage: &Voyage) -> RouteDocument {
    voyage
        .chart_system()
        .map_or_else(RouteDocument::default, chart_route)
}

/// The route as it is drawn, with the forwarding distance in force.
fn chart_route(chart: &ChartSystem) -> RouteDocument {
    let revision = chart.revision();
    let Some(route) = chart.route() else {
        return RouteDocument {
            revision,
            ..RouteDocument::default()
        };
    };
    let mut document = drawn_route(route, revision);
    let leg = chart.leg().unwrap_or(0);
    if let (Some(turn), Some(view)) = (route.turn_after(leg), document.turns.get_mut(leg)) {
        view.forwarding_m = chart.forwarding().m();
        view.wheel_over = turn.wheel_over(chart.forwarding());
    }
    document
}

/// All settings.
#[must_use]
pub fn settings_document(voyage: &Voyage) -> SettingsDocument {
    SettingsDocument {
        revision: voyage.settings_revision(),
        values: voyage
            .autopilot()
            .map_or_else(Vec::new, |autopilot| autopilot.settings().values()),
    }
}

/// State of the shown station's ports.
#[must_use]
pub fn ports_document(voyage: &Voyage) -> PortsDocument {
    let picture = voyage.picture();
    let view = |(index, (port, count)): (usize, (&PortSetup, &PortCount))| {
        let up = voyage.port_is_up(index);
        let (quiet, unknown) = voyage.port_state(index);
        PortView {
            name: port.name.clone(),
            up,
            trouble: if up {
                quiet.map_or_else(String::new, |why| {
                    alloc::format!("no valid sentence: {why}")
                })
            } else {
                "the port is gone; it is tried again".into()
            },
            heard: count.heard,
            sent: count.sent,
            bad_checksum: count.bad_checksum,
            garbage: count.garbage,
            unknown,
            unused: count.unused.saturating_sub(unknown),
        }
    };
    PortsDocument {
        revision: voyage.line(),
        ports: picture
            .ports
            .iter()
            .zip(&picture.counts)
            .enumerate()
            .map(view)
            .collect(),
    }
}
