//! What a voyage shows: first frame, snapshot, and the documents.

use super::Voyage;
use crate::chart_system::ChartSystem;
use crate::picture::PortCount;
use crate::station::PortSetup;
use crate::stream::{
    Hello, Outline, PROTOCOL, PortView, PortsDocument, RouteDocument, SettingsDocument, Snapshot,
    VoyageOwn,
};
use crate::world::World;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

impl Voyage {
    /// Own facts; the caller gives the frame its number.
    #[must_use]
    pub fn snapshot(&self) -> Snapshot {
        let now = self.now;
        let mut alerts = self
            .autopilot
            .as_ref()
            .map_or_else(Vec::new, |autopilot| autopilot.alerts().views());
        if let Some(chart) = &self.chart {
            alerts.extend(chart.alerts());
        }
        alerts.sort_by_key(|alert| alert.priority);
        Snapshot {
            frame: 0,
            at: now.0,
            rate: self.rate(),
            line: self.line,
            digest: self.picture().digest(),
            own: self.autopilot.as_ref().map(|autopilot| autopilot.own(now)),
            chart: self.chart.as_ref().map(ChartSystem::own),
            voyage: self.embedded.as_ref().map(|_| self.voyage_own()),
            alerts,
        }
    }

    fn voyage_own(&self) -> VoyageOwn {
        let current = self.world.as_ref().map(World::current);
        VoyageOwn {
            officer: self.officer.on,
            round: self.round,
            speed: self.speed,
            faults: self.cables.faults(),
            current: current.map_or([0.0; 2], |(set, drift)| [set.deg(), drift.knots()]),
        }
    }

    /// First frame of a connection; the caller says whether that client may command, and how large a real ship is.
    #[must_use]
    pub fn hello(&self, build: &str) -> Hello {
        let picture = self.picture();
        Hello {
            protocol: PROTOCOL,
            build: build.to_string(),
            dictionary: crate::nmea::dictionary().len() as u32,
            picture: picture.clone(),
            line: self.line,
            at: self.now.0,
            rate: self.rate(),
            ports: picture.ports.clone(),
            station: self.shown.name().to_string(),
            ship: Outline::default(),
            simulated: self.embedded.is_some(),
            may_command: false,
        }
    }

    /// The route with its geometry; empty where the chart system is a foreign one.
    #[must_use]
    pub fn route_document(&self) -> RouteDocument {
        self.chart
            .as_ref()
            .map_or_else(RouteDocument::default, ChartSystem::document)
    }

    /// All settings.
    #[must_use]
    pub fn settings_document(&self) -> SettingsDocument {
        SettingsDocument {
            revision: self.settings_revision,
            values: self
                .autopilot
                .as_ref()
                .map_or_else(Vec::new, |autopilot| autopilot.settings().values()),
        }
    }

    /// State of the shown station's ports.
    #[must_use]
    pub fn ports_document(&self) -> PortsDocument {
        let picture = self.picture();
        let view = |(index, (port, count)): (usize, (&PortSetup, &PortCount))| {
            let outside = self
                .outside
                .iter()
                .position(|end| *end == (self.shown, index));
            let up = match outside {
                Some(port) => self.up.get(port).copied().unwrap_or(false),
                None => !self.cables.cut((self.shown, index)),
            };
            PortView {
                name: port.name.clone(),
                up,
                trouble: if up {
                    String::new()
                } else {
                    "the port is gone; it is tried again".into()
                },
                heard: count.heard,
                sent: count.sent,
                bad_checksum: count.bad_checksum,
                garbage: count.garbage,
            }
        };
        PortsDocument {
            revision: self.line,
            ports: picture
                .ports
                .iter()
                .zip(&picture.counts)
                .enumerate()
                .map(view)
                .collect(),
        }
    }
}
