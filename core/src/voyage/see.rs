//! What can be seen of a voyage: its stations, their alerts, its pace and its ports.

use super::wiring::Voyage;
use crate::alerts::Standing;
use crate::autopilot::Autopilot;
use crate::chart_system::ChartSystem;
use crate::command::FaultKind;
use crate::picture::Picture;
use crate::station::{PortIndex, Role};
use crate::time::Stamp;
use crate::world::World;
use alloc::string::String;
use alloc::vec::Vec;

impl Voyage {
    /// Ship's time for each second of the clock on the wall: in the embedded voyage 1 while a confirmation is open.
    #[must_use]
    pub fn rate(&self) -> f64 {
        let pending = self
            .autopilot
            .as_ref()
            .is_some_and(|autopilot| autopilot.pending().is_some());
        // Who is behind a port knows of no confirmation here.
        if pending && self.is_embedded() {
            1.0
        } else {
            self.speed
        }
    }

    /// Lets ship's time run at another pace from the start. Nothing in the stations depends on it; with real equipment it
    /// is 1.
    pub fn run_at(&mut self, pace: f64) {
        self.speed = pace;
    }

    /// The alerts of the stations that run here, in the order in which they are shown.
    #[must_use]
    pub fn alerts(&self) -> Vec<&Standing> {
        let autopilot = self.autopilot.iter().flat_map(|a| a.alerts().standing());
        let chart = self.chart.iter().flat_map(ChartSystem::alerts);
        let mut alerts: Vec<_> = autopilot.chain(chart).collect();
        alerts.sort_by_key(|standing| standing.rank());
        alerts
    }

    /// Whether the scripted officer has the watch.
    #[must_use]
    pub const fn officer_has_the_watch(&self) -> bool {
        self.officer.on
    }

    /// Which round of the embedded voyage is sailed, from 1.
    #[must_use]
    pub const fn round(&self) -> u32 {
        self.round
    }

    /// Pace asked for; [`Self::rate`] is the one in force.
    #[must_use]
    pub const fn pace(&self) -> f64 {
        self.speed
    }

    /// Faults of the cables in force: cable, kind.
    #[must_use]
    pub fn faults(&self) -> Vec<(String, FaultKind)> {
        self.cables.faults()
    }

    /// The station that is shown.
    #[must_use]
    pub const fn shown(&self) -> Role {
        self.shown
    }

    /// Raised whenever a setting changes.
    #[must_use]
    pub const fn settings_revision(&self) -> u64 {
        self.settings_revision
    }

    /// Whether a port of the shown station is connected.
    #[must_use]
    pub fn port_is_up(&self, port: PortIndex) -> bool {
        let end = (self.shown, port);
        match self.outside.iter().position(|outside| *outside == end) {
            Some(outside) => self.up.get(outside).copied().unwrap_or(false),
            None => !self.cables.cut(end),
        }
    }

    /// Why nothing valid comes on a port of the shown station, where nothing does, in an officer's words; and how many valid
    /// sentences came there that the dictionary does not know (FB10).
    #[must_use]
    pub fn port_state(&self, port: PortIndex) -> (Option<String>, u64) {
        match (&self.autopilot, &self.chart) {
            (Some(autopilot), _) => autopilot.port_state(self.now, port),
            (None, Some(chart)) => chart.port_state(self.now, port),
            (None, None) => (None, 0),
        }
    }

    /// The voyage's time.
    #[must_use]
    pub const fn now(&self) -> Stamp {
        self.now
    }

    /// Number of the last line.
    #[must_use]
    pub const fn line(&self) -> u64 {
        self.line
    }

    /// The simulated ship, for tests.
    #[must_use]
    pub const fn world(&self) -> Option<&World> {
        self.world.as_ref()
    }

    /// The autopilot, where it runs here.
    #[must_use]
    pub const fn autopilot(&self) -> Option<&Autopilot> {
        self.autopilot.as_ref()
    }

    /// The chart system, where it runs here.
    #[must_use]
    pub const fn chart_system(&self) -> Option<&ChartSystem> {
        self.chart.as_ref()
    }

    /// The picture of the station that is shown.
    #[must_use]
    pub fn picture(&self) -> &Picture {
        static EMPTY: Picture = Picture::empty();
        match (&self.autopilot, &self.chart, &self.world) {
            (Some(autopilot), ..) => autopilot.picture(),
            (None, Some(chart), _) => chart.picture(),
            (None, None, Some(world)) => world.picture(),
            (None, None, None) => &EMPTY,
        }
    }

    /// Whether a command reaches anything but the embedded voyage.
    #[must_use]
    pub const fn is_embedded(&self) -> bool {
        self.embedded.is_some()
    }
}
