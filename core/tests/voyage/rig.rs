//! Three stations on cables; every line to the autopilot passes a filter that a test sets.

use crate::order::ask;
use std::collections::VecDeque;
use wheelover_core::alerts::Alert;
use wheelover_core::autopilot::steering::SteeringSettings;
use wheelover_core::autopilot::{Autopilot, Mode};
use wheelover_core::chart_system::{ChartConfig, ChartSystem};
use wheelover_core::geo::{Position, rhumb};
use wheelover_core::nmea::{self, Htd};
use wheelover_core::route::{Route, RouteLimits, Waypoint};
use wheelover_core::settings::Settings;
use wheelover_core::station::{ChecksumPolicy, Input, Output, PortSetup, Profile};
use wheelover_core::time::Stamp;
use wheelover_core::units::{Course, Distance, Heading, Radius, Speed};
use wheelover_core::view::{ChartRequest, ModeName, ModeRequest, Order};
use wheelover_core::world::{World, WorldConfig};

/// The gear's slew in these tests, degrees a second (the Mariner's).
pub(crate) const SLEW: f64 = 5.0;

/// What becomes of a line to the autopilot: its text without CR LF, or nothing.
pub(crate) type Filter = Box<dyn FnMut(Stamp, Profile, &str) -> Option<String>>;

const AUTOPILOT_PORTS: [Profile; 5] = [
    Profile::Ecdis,
    Profile::Gyro1,
    Profile::Gps,
    Profile::Log,
    Profile::Gear,
];

/// The stations, the cables and what is watched all the time.
pub(crate) struct Rig {
    pub(crate) world: World,
    pub(crate) chart: ChartSystem,
    pub(crate) autopilot: Autopilot,
    pub(crate) now: Stamp,
    pub(crate) route: Route,
    pub(crate) filter: Filter,
    /// Last line of each formatter that the chart system said, as it was sent.
    pub(crate) said: Vec<(String, String)>,
    /// HTD lines of the autopilot with their time.
    pub(crate) htd: Vec<(Stamp, Htd)>,
    /// Rudder orders at each control step; absent in STANDBY.
    pub(crate) orders: Vec<(Stamp, Option<f64>)>,
    /// Headings as the autopilot read them, one a step.
    pub(crate) read: Vec<f64>,
    queue: VecDeque<(Profile, bool, Vec<u8>)>,
}

/// Legs of `(course, miles)`; a radius at each waypoint between them.
pub(crate) fn route(legs: &[(f64, f64)], radius: f64) -> Route {
    let mut place = Position {
        lat: 59.8,
        lon: 25.0,
    };
    let mut waypoints = vec![Waypoint::new("WP0", place, None)];
    for (index, (course, miles)) in legs.iter().enumerate() {
        place = rhumb::destination(place, Course::from_deg(*course), Distance::from_nm(*miles));
        let last = index + 1 == legs.len();
        let id = format!("WP{}", index + 1);
        waypoints.push(Waypoint::new(
            &id,
            place,
            (!last).then(|| Radius::from_nm(radius)),
        ));
    }
    Route::new("test", waypoints, RouteLimits::default()).unwrap()
}

impl Rig {
    /// The ship on the first leg of `route`, half a cable from its beginning, 1 kn of current across.
    pub(crate) fn new(route: Route, seed: u64) -> Self {
        let leg = route.leg(0);
        let world = World::new(WorldConfig {
            start: leg.at(Distance::from_m(100.0)),
            heading: leg.course().as_heading(),
            seed,
            current_set: Course::from_deg(leg.course().deg() + 90.0),
            current_drift: Speed::from_knots(1.0),
            ..WorldConfig::default()
        });
        let chart = ChartSystem::new(ChartConfig {
            route: Some(route.clone()),
            ..ChartConfig::default()
        });
        let ports = AUTOPILOT_PORTS.map(|profile| PortSetup {
            name: format!("{profile:?}").to_lowercase(),
            profile,
            checksum: ChecksumPolicy::Required,
            baud: 38_400,
            output: true,
        });
        let settings = Settings {
            rudder_slew: SLEW,
            external_tcs: true,
            ..Settings::default()
        };
        let autopilot = Autopilot::new(
            ports.to_vec(),
            settings,
            Some(SteeringSettings::default()),
            Stamp(0),
        );
        Self {
            world,
            chart,
            autopilot,
            now: Stamp(0),
            route,
            filter: Box::new(|_, _, line| Some(line.to_string())),
            said: Vec::new(),
            htd: Vec::new(),
            orders: Vec::new(),
            read: Vec::new(),
            queue: VecDeque::new(),
        }
    }

    /// Two legs with a turn of 60 degrees to starboard of half a mile between them, under track control.
    pub(crate) fn tracking() -> Self {
        Self::tracking_on(route(&[(245.0, 2.5), (305.0, 2.5)], 0.5))
    }

    /// Under track control on the first leg of `route`.
    pub(crate) fn tracking_on(route: Route) -> Self {
        let mut rig = Self::new(route, 3);
        rig.engage();
        rig
    }

    /// From STANDBY to track control.
    pub(crate) fn engage(&mut self) {
        self.run(5.0);
        self.command(Order::Mode(ModeRequest::Auto)).unwrap();
        self.run(5.0);
        self.ask(ChartRequest::Track).unwrap();
        self.command(Order::Mode(ModeRequest::Autonav)).unwrap();
        let engaged = |rig: &Self| rig.mode() == ModeName::AutonavTi;
        self.until("track control", 20.0, engaged);
    }

    /// Sets what becomes of lines to the autopilot.
    pub(crate) fn filter(
        &mut self,
        filter: impl FnMut(Stamp, Profile, &str) -> Option<String> + 'static,
    ) {
        self.filter = Box::new(filter);
    }

    /// From now on nothing of that formatter (all, if empty) comes from that profile.
    pub(crate) fn silence(&mut self, profile: Profile, formatter: &'static str) {
        self.filter(move |_, from, line| {
            (from != profile || !line.contains(formatter)).then(|| line.to_string())
        });
    }

    pub(crate) fn command(&mut self, action: Order) -> Result<String, String> {
        ask(&action, |input, out| {
            self.autopilot.handle(self.now, input, out);
        })
    }

    pub(crate) fn ask(&mut self, request: ChartRequest) -> Result<String, String> {
        ask(&Order::Chart(request), |input, out| {
            self.chart.handle(self.now, input, out);
        })
    }

    /// Says a line to the autopilot now; the checksum is added.
    pub(crate) fn say(&mut self, profile: Profile, body: &str) {
        self.say_raw(profile, &with_checksum(body));
    }

    /// Says a line to the autopilot as it stands.
    pub(crate) fn say_raw(&mut self, profile: Profile, line: &str) {
        let bytes = format!("{line}\r\n").into_bytes();
        self.tell_autopilot(profile, &bytes);
        self.carry();
    }

    pub(crate) fn run(&mut self, seconds: f64) {
        let end = self.now + (seconds * 1000.0) as u64;
        while self.now < end {
            self.step();
        }
    }

    /// Runs until `condition` holds; fails with `name` after `seconds`.
    pub(crate) fn until(
        &mut self,
        name: &str,
        seconds: f64,
        mut condition: impl FnMut(&Self) -> bool,
    ) -> Stamp {
        let end = self.now + (seconds * 1000.0) as u64;
        while !condition(self) {
            assert!(
                self.now < end,
                "{name} not within {seconds} s: {:?} situation {} {:?}",
                self.autopilot.mode(),
                self.chart.situation(),
                self.autopilot.alerts().standing()
            );
            self.step();
        }
        self.now
    }

    /// A tenth of a second.
    pub(crate) fn step(&mut self) {
        self.now = self.now + 100;
        let mut out = Vec::new();
        self.world.handle(self.now, Input::Tick, &mut out);
        self.sort(0, &mut out);
        self.carry();
        self.chart.handle(self.now, Input::Tick, &mut out);
        self.sort(1, &mut out);
        self.carry();
        self.autopilot.handle(self.now, Input::Tick, &mut out);
        self.sort(2, &mut out);
        self.carry();
        let order = self.autopilot.rudder_order().map(|order| order.deg());
        self.orders.push((self.now, order));
        let read = self.autopilot.picture().heading(self.now);
        self.read.extend(read.map(|read| read.value.deg()));
    }

    fn sort(&mut self, station: usize, out: &mut Vec<Output>) {
        for output in out.drain(..) {
            let Output::Send { port, bytes } = output else {
                continue;
            };
            let profile = match station {
                0 => self.world.ports()[port].profile,
                1 => Profile::Ecdis,
                _ => AUTOPILOT_PORTS[port],
            };
            self.queue.push_back((profile, station == 2, bytes));
        }
    }

    fn carry(&mut self) {
        while let Some((profile, from_autopilot, bytes)) = self.queue.pop_front() {
            if from_autopilot {
                self.heard_from_autopilot(profile, &bytes);
                continue;
            }
            let index = match profile {
                Profile::Gps => Some(1),
                Profile::Gyro1 => Some(2),
                Profile::Log => Some(3),
                _ => None,
            };
            if let Some(port) = index {
                self.tell_chart(port, &bytes);
            }
            if profile == Profile::Ecdis {
                self.note(&bytes);
            }
            self.tell_autopilot(profile, &bytes);
        }
    }

    fn note(&mut self, bytes: &[u8]) {
        for line in String::from_utf8_lossy(bytes).lines() {
            let formatter = nmea::decode(line.as_bytes()).formatter.to_string();
            self.said.retain(|(name, _)| *name != formatter);
            self.said.push((formatter, line.to_string()));
        }
    }

    fn tell_chart(&mut self, port: usize, bytes: &[u8]) {
        let mut out = Vec::new();
        self.chart
            .handle(self.now, Input::Bytes { port, bytes }, &mut out);
        self.sort(1, &mut out);
    }

    fn tell_autopilot(&mut self, profile: Profile, bytes: &[u8]) {
        let port = AUTOPILOT_PORTS
            .iter()
            .position(|known| *known == profile)
            .unwrap();
        for line in String::from_utf8_lossy(bytes).lines() {
            let Some(line) = (self.filter)(self.now, profile, line) else {
                continue;
            };
            let line = format!("{line}\r\n");
            let mut out = Vec::new();
            let bytes = line.as_bytes();
            self.autopilot
                .handle(self.now, Input::Bytes { port, bytes }, &mut out);
            self.sort(2, &mut out);
        }
    }

    fn heard_from_autopilot(&mut self, profile: Profile, bytes: &[u8]) {
        match profile {
            Profile::Gear => {
                let port = self.world.port(Profile::Gear).unwrap();
                let mut out = Vec::new();
                self.world
                    .handle(self.now, Input::Bytes { port, bytes }, &mut out);
                self.sort(0, &mut out);
            }
            Profile::Ecdis => {
                for line in String::from_utf8_lossy(bytes).lines() {
                    if let Some(htd) = Htd::from_sentence(&nmea::decode(line.as_bytes())) {
                        self.htd.push((self.now, htd));
                    }
                }
                self.tell_chart(0, bytes);
            }
            _ => {}
        }
    }

    pub(crate) fn mode(&self) -> ModeName {
        self.autopilot.mode().name()
    }

    /// Set heading of AUTO, degrees.
    pub(crate) fn set_heading(&self) -> f64 {
        match self.autopilot.mode() {
            Mode::Auto(auto) => auto.set.deg(),
            other => panic!("not AUTO: {other:?}"),
        }
    }

    pub(crate) fn heading(&self) -> Heading {
        self.world.truth().heading
    }

    pub(crate) fn raised(&self, alert: Alert) -> bool {
        self.autopilot.alerts().raised(alert)
    }

    /// Text of a raised alert, empty where it is not raised.
    pub(crate) fn text(&self, alert: Alert) -> String {
        let standing = self.autopilot.alerts().standing();
        let found = standing.iter().find(|standing| standing.alert == alert);
        found.map_or(String::new(), |standing| self.autopilot.text_of(standing))
    }

    pub(crate) fn last_htd(&self) -> &Htd {
        &self.htd.last().unwrap().1
    }

    /// The last line of that formatter that the chart system sent.
    pub(crate) fn line(&self, formatter: &str) -> &str {
        let found = self.said.iter().find(|(name, _)| name == formatter);
        &found.unwrap_or_else(|| panic!("no {formatter} was sent")).1
    }

    /// FA6: every step of the order within slew and limit, from the first order on.
    pub(crate) fn check_orders(&self) {
        for pair in self.orders.windows(2) {
            if let [(from, Some(before)), (at, Some(order))] = pair {
                let step = (order - before).abs();
                assert!(
                    step <= SLEW * 0.1 + 1e-9 && at.since(*from) >= 100,
                    "order stepped by {step} at {} s",
                    at.seconds()
                );
                assert!(order.abs() <= 35.0 + 1e-9, "order {order}");
            }
        }
    }
}

/// Distance of the leg or arc that belongs to the chart system's situation, metres, without sign.
pub(crate) fn off_path(route: &Route, chart: &ChartSystem, position: Position) -> f64 {
    let index = chart.leg().unwrap_or(0);
    let on_arc = chart.situation() == 4;
    let leg = route.leg(index);
    match route.turn_after(index) {
        Some(turn) if on_arc => turn.cross_track(position).m().abs(),
        _ => leg.cross_track(position).m().abs(),
    }
}

/// A whole sentence from its body without `$` and checksum.
pub(crate) fn with_checksum(body: &str) -> String {
    let sum = body.bytes().fold(0_u8, |sum, byte| sum ^ byte);
    format!("${body}*{sum:02X}")
}

/// Replaces fields of a line (counted from 1) and repairs its checksum.
pub(crate) fn edited(line: &str, changes: &[(usize, &str)]) -> String {
    let body = line.trim_start_matches('$').split('*').next().unwrap();
    let mut fields: Vec<&str> = body.split(',').collect();
    for (index, text) in changes {
        fields[*index] = text;
    }
    with_checksum(&fields.join(","))
}
