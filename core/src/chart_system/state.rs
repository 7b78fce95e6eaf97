//! The chart system: what it keeps, and what can be seen of it.

use super::config::ChartConfig;
use super::control::{Commanding, CrossTracks, Followed};
use super::current::Current;
use super::offered::Offered;
use super::place::PositionGuard;
use super::reckoning::{Known, Reckoning};
use super::watch::TurnIndications;
use crate::alerts::{Alerts, HeardAlert, HeardAlerts, Reports, Standing};
use crate::picture::Picture;
use crate::post::Post;
use crate::route::{Progress, Route};
use crate::station::{PortIndex, Role};
use crate::time::Stamp;
use crate::timers::Timers;
use crate::units::{Distance, Speed};
use alloc::format;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// The chart system as a station.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ChartSystem {
    pub(super) config: ChartConfig,
    pub(super) route: Option<Route>,
    pub(super) revision: u64,
    pub(super) post: Post,
    pub(super) guard: PositionGuard,
    pub(super) current: Current,
    pub(super) known: Option<Known>,
    pub(super) reckoning: Option<Reckoning>,
    pub(super) progress: Option<Progress>,
    /// Forwarding distance before the next turn; fixed a minute before the wheel-over line.
    pub(super) forwarding: Distance,
    pub(super) control: Commanding,
    pub(super) followed: Followed,
    pub(super) shown: CrossTracks,
    pub(super) watch: TurnIndications,
    /// What is said of its alerts.
    pub(super) reports: Reports,
    /// The autopilot's (TCS-13).
    pub(super) heard: HeardAlerts,
    /// What a plotter offers (TCS-13).
    pub(super) offered: Offered,
    pub(super) why: String,
    pub(super) now: Stamp,
    pub(super) timers: Timers<Timer>,
}

/// The chart system's own times.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum Timer {
    /// When the next second's sentences are due; it runs from the first input on.
    Second,
}

impl ChartSystem {
    /// A chart system that controls nothing yet.
    #[must_use]
    pub fn new(config: ChartConfig) -> Self {
        let mut system = Self {
            post: Post::new(Role::ChartSystem, config.ports.clone()),
            reports: Reports::new(Role::ChartSystem, &config.ports),
            heard: HeardAlerts::default(),
            guard: PositionGuard::default(),
            current: Current::default(),
            known: None,
            reckoning: None,
            progress: None,
            forwarding: Distance::default(),
            control: Commanding::Off,
            followed: Followed::default(),
            shown: CrossTracks::default(),
            watch: TurnIndications::default(),
            offered: Offered::default(),
            why: String::new(),
            now: Stamp::default(),
            timers: Timers::new(&[]),
            route: None,
            revision: 0,
            config,
        };
        if let Some(route) = system.config.route.clone() {
            system.load(route);
        }
        system
    }

    /// Loads a route: control ends, and the ship is looked for on it.
    pub fn load(&mut self, route: Route) {
        self.forwarding = self.forwarding_at(route.limits().speed, &route);
        self.route = Some(route);
        self.revision += 1;
        self.control = Commanding::Off;
        self.progress = None;
        self.shown = CrossTracks::default();
        self.watch.begin_anew(self.now);
        self.why = String::from("route loaded");
    }

    /// Takes the route out of monitoring; control ends.
    pub fn unload(&mut self) {
        self.route = None;
        self.revision += 1;
        self.control = Commanding::Off;
        self.progress = None;
        self.shown = CrossTracks::default();
        self.watch.begin_anew(self.now);
        self.why = String::from("no route");
    }

    /// Control ends; HTC goes to S (TCS-3, TCS-10).
    pub(super) fn end_control(&mut self, why: &str) {
        self.control = Commanding::Off;
        self.why = format!("control ended: {why}");
    }

    /// The forwarding distance at a speed.
    pub(super) fn forwarding_at(&self, speed: Speed, route: &Route) -> Distance {
        let seconds = self
            .config
            .forwarding_s
            .unwrap_or(route.limits().forwarding_s);
        Distance::from_m(speed.mps() * seconds)
    }

    /// The route in monitoring.
    #[must_use]
    pub const fn route(&self) -> Option<&Route> {
        self.route.as_ref()
    }

    /// Raised on every change of the route.
    #[must_use]
    pub const fn revision(&self) -> u64 {
        self.revision
    }

    /// Index of the leg that is sailed, from 0.
    #[must_use]
    pub fn leg(&self) -> Option<usize> {
        self.progress.and_then(|progress| progress.leg())
    }

    /// The forwarding distance in force.
    #[must_use]
    pub const fn forwarding(&self) -> Distance {
        self.forwarding
    }

    /// `off`, `heading` (Tn) or `track` (Ti).
    #[must_use]
    pub const fn control_name(&self) -> &'static str {
        self.control.name()
    }

    /// Its time.
    #[must_use]
    pub const fn now(&self) -> Stamp {
        self.now
    }

    /// What it has heard and sent; pages fold the same lines.
    #[must_use]
    pub const fn picture(&self) -> &Picture {
        &self.post.picture
    }

    /// Why nothing valid comes on a port, where nothing does, in an officer's words; and how many valid sentences came there
    /// that the dictionary does not know (FB10).
    #[must_use]
    pub fn port_state(&self, now: Stamp, port: PortIndex) -> (Option<String>, u64) {
        self.post.port_state(now, port)
    }

    /// Its alerts that are not normal, the highest first.
    #[must_use]
    pub fn alerts(&self) -> &[Standing] {
        self.watch.alerts.standing()
    }

    /// Its alerts with their history.
    #[must_use]
    pub const fn all_alerts(&self) -> &Alerts {
        &self.watch.alerts
    }

    /// The autopilot's alerts as they are heard.
    #[must_use]
    pub fn heard_alerts(&self) -> &[HeardAlert] {
        self.heard.standing()
    }
}
