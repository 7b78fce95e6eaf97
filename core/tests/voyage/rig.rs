//! The voyage as it is shipped, with a tap on its cables: every line to the autopilot passes a filter that a test sets.

mod outside;
mod plan;
mod ships;
mod wire;

pub(crate) use outside::outside;
pub(crate) use plan::{off_path, route};
use std::sync::{Arc, Mutex};
use wheelover_core::alerts::Alert;
use wheelover_core::autopilot::{Autopilot, Mode};
use wheelover_core::chart_system::ChartSystem;
use wheelover_core::nmea::{Htd, with_checksum};
use wheelover_core::route::Route;
use wheelover_core::settings::Value;
use wheelover_core::station::{PortSetup, Profile, Role, Switch};
use wheelover_core::time::Stamp;
use wheelover_core::units::{Course, Distance, Heading, Speed};
use wheelover_core::view::{ChartRequest, FaultKind, ModeName, ModeRequest, Order, Origin};
use wheelover_core::voyage::{Event, Voyage, VoyageConfig, VoyageOutput};
use wheelover_core::world::{World, WorldConfig};
use wire::Wire;

/// The gear's slew in these tests, degrees a second (the Mariner's).
pub(crate) const SLEW: f64 = 5.0;

/// A voyage with a tap on its cables, and what is watched all the time.
pub(crate) struct Rig {
    voyage: Voyage,
    wire: Arc<Mutex<Wire>>,
    pub(crate) now: Stamp,
    pub(crate) route: Route,
    /// HTD lines of the autopilot with their time.
    pub(crate) htd: Vec<(Stamp, Htd)>,
    /// Rudder orders at each control step, of a pair the starboard ones; absent in STANDBY.
    pub(crate) orders: Vec<(Stamp, Option<f64>)>,
    /// Those to the port one of a pair.
    port_orders: Vec<(Stamp, Option<f64>)>,
    /// Headings as the autopilot read them, one a step.
    pub(crate) read: Vec<f64>,
    /// Lines that left by ports to the outside.
    pub(crate) sent: Vec<(Stamp, String)>,
}

impl Rig {
    /// The ship on the first leg of `route`, half a cable from its beginning, 1 kn of current across.
    pub(crate) fn new(route: Route, seed: u64) -> Self {
        Self::sailing(route.clone(), Some(route), seed, Vec::new())
    }

    /// The same in a wind of 15 kn from 40 degrees on the port bow.
    pub(crate) fn windy(route: Route, seed: u64) -> Self {
        Self::sailing_as(route.clone(), Some(route), seed, Vec::new(), |config| {
            config.world.wind_speed = Speed::from_knots(15.0);
        })
    }

    /// The same where the chart system has no route.
    pub(crate) fn without_route(route: Route, seed: u64) -> Self {
        Self::sailing(route, None, seed, Vec::new())
    }

    fn sailing(
        route: Route,
        loaded: Option<Route>,
        seed: u64,
        ports: Vec<(Role, PortSetup)>,
    ) -> Self {
        Self::sailing_as(route, loaded, seed, ports, |_| {})
    }

    fn sailing_as(
        route: Route,
        loaded: Option<Route>,
        seed: u64,
        ports: Vec<(Role, PortSetup)>,
        change: impl FnOnce(&mut VoyageConfig),
    ) -> Self {
        let leg = route.leg(0);
        let mut config = VoyageConfig::embedded(seed);
        config.ports = ports;
        config.settings.rudder_slew = SLEW;
        config.chart.route = loaded;
        config.world = WorldConfig {
            start: leg.at(Distance::from_m(100.0)),
            heading: leg.course().as_heading(),
            seed,
            current_set: Course::from_deg(leg.course().deg() + 90.0),
            current_drift: Speed::from_knots(1.0),
            wind_from: Course::from_deg(leg.course().deg() - 40.0),
            ..WorldConfig::default()
        };
        change(&mut config);
        Self::of(Voyage::configured(config), route)
    }

    /// Under track control on the first leg of two with a turn of 60 degrees, in a voyage that is made a little otherwise.
    pub(crate) fn tracking_as(change: impl FnOnce(&mut VoyageConfig)) -> Self {
        let route = route(&[(245.0, 2.5), (305.0, 2.5)], 0.5);
        let mut rig = Self::sailing_as(route.clone(), Some(route), 3, Vec::new(), change);
        rig.engage();
        rig
    }

    /// Under track control, with real ports besides: whose, and what.
    pub(crate) fn tracking_with(ports: Vec<(Role, PortSetup)>) -> Self {
        let route = route(&[(245.0, 2.5), (305.0, 2.5)], 0.5);
        let mut rig = Self::sailing(route.clone(), Some(route), 3, ports);
        rig.engage();
        rig
    }

    /// A voyage of its own; the scripted officer is off.
    pub(crate) fn of(mut voyage: Voyage, route: Route) -> Self {
        let wire = Arc::new(Mutex::new(Wire::default()));
        let tapped = wire.clone();
        voyage.tap(Box::new(move |parcel| tapped.lock().unwrap().pass(parcel)));
        let mut rig = Self {
            voyage,
            wire,
            now: Stamp(0),
            route,
            htd: Vec::new(),
            orders: Vec::new(),
            port_orders: Vec::new(),
            read: Vec::new(),
            sent: Vec::new(),
        };
        if rig.voyage.is_embedded() {
            rig.command(Order::Officer(false)).unwrap();
        }
        rig
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
        filter: impl FnMut(Stamp, Profile, &str) -> Option<String> + Send + 'static,
    ) {
        self.wire.lock().unwrap().filter = Box::new(filter);
    }

    /// From now on nothing of that formatter (all, if empty) comes from that profile.
    pub(crate) fn silence(&mut self, profile: Profile, formatter: &'static str) {
        self.filter(move |_, from, line| {
            (from != profile || !line.contains(formatter)).then(|| line.to_string())
        });
    }

    pub(crate) fn command(&mut self, order: Order) -> Result<String, String> {
        let (id, by) = (1, Origin::Officer);
        let answer = self.event(Event::Order { id, by, order });
        let answer = answer.into_iter().find_map(|output| match output {
            VoyageOutput::Answer(answer) => Some(answer),
            _ => None,
        });
        let answer = answer.expect("every order is answered");
        if answer.ok {
            Ok(answer.text)
        } else {
            Err(answer.text)
        }
    }

    /// Changes a setting that is a number.
    pub(crate) fn set(&mut self, key: &str, value: f64) -> Result<String, String> {
        let (key, value) = (key.into(), Value::Number(value));
        self.command(Order::Setting { key, value })
    }

    pub(crate) fn ask(&mut self, request: ChartRequest) -> Result<String, String> {
        self.command(Order::Chart(request))
    }

    /// Hurts or heals a sensor of the ship.
    pub(crate) fn injure(&mut self, sensor: Profile, kind: FaultKind, on: bool) {
        let cable = sensor.name().to_string();
        self.command(Order::Fault { cable, kind, on }).unwrap();
    }

    /// The caller's loop was late by so much.
    pub(crate) fn stall(&mut self, ms: u64) -> Vec<VoyageOutput> {
        self.event(Event::Stalled { ms })
    }

    /// A contact is so now.
    pub(crate) fn switch(&mut self, switch: Switch, closed: Option<bool>) {
        self.event(Event::Contact { switch, closed });
    }

    fn event(&mut self, event: Event) -> Vec<VoyageOutput> {
        let mut out = Vec::new();
        self.voyage.handle(self.now, event, &mut out);
        self.note(&out);
        out
    }

    /// Notes what left by ports to the outside.
    fn note(&mut self, out: &[VoyageOutput]) {
        for output in out {
            if let VoyageOutput::Send { bytes, .. } = output {
                let text = String::from_utf8_lossy(bytes);
                let lines = text.lines().map(|line| (self.now, line.to_string()));
                self.sent.extend(lines);
            }
        }
    }

    /// Says a line to the autopilot now; the checksum is added.
    pub(crate) fn say(&mut self, profile: Profile, body: &str) {
        self.say_raw(profile, &with_checksum(body));
    }

    /// Says a line to the chart system now; the checksum is added.
    pub(crate) fn tell_chart(&mut self, profile: Profile, body: &str) {
        let bytes = format!("{}\r\n", with_checksum(body)).into_bytes();
        let hearer = (Role::ChartSystem, profile);
        self.voyage.say(self.now, hearer, &bytes, &mut Vec::new());
    }

    /// Says a line to the autopilot as it stands.
    pub(crate) fn say_raw(&mut self, profile: Profile, line: &str) {
        let bytes = format!("{line}\r\n").into_bytes();
        let hearer = (Role::Autopilot, profile);
        let mut out = Vec::new();
        self.voyage.say(self.now, hearer, &bytes, &mut out);
        self.note(&out);
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
                self.autopilot().mode(),
                self.chart().situation(),
                self.autopilot().alerts().standing()
            );
            self.step();
        }
        self.now
    }

    /// A tenth of a second.
    pub(crate) fn step(&mut self) {
        self.now = self.now + 100;
        self.event(Event::Tick);
        self.htd.append(&mut self.wire.lock().unwrap().htd);
        let orders = self.autopilot().rudder_orders();
        let [order, port] = orders.map(|order| order.map(|order| order.deg()));
        self.orders.push((self.now, order));
        self.port_orders.push((self.now, port));
        let read = self.autopilot().picture().heading(self.now);
        let read = read.and_then(|read| Some(read.value.true_heading(None)?.deg()));
        self.read.extend(read);
    }

    pub(crate) fn autopilot(&self) -> &Autopilot {
        self.voyage.autopilot().unwrap()
    }

    pub(crate) fn chart(&self) -> &ChartSystem {
        self.voyage.chart_system().unwrap()
    }

    pub(crate) fn world(&self) -> &World {
        self.voyage.world().unwrap()
    }

    pub(crate) fn mode(&self) -> ModeName {
        self.autopilot().mode().name()
    }

    /// Set heading of AUTO, degrees.
    pub(crate) fn set_heading(&self) -> f64 {
        match self.autopilot().mode() {
            Mode::Auto(auto) => auto.set.deg(),
            other => panic!("not AUTO: {other:?}"),
        }
    }

    pub(crate) fn heading(&self) -> Heading {
        self.world().truth().heading
    }

    pub(crate) fn raised(&self, alert: Alert) -> bool {
        self.autopilot().alerts().raised(alert)
    }

    /// Text of a raised alert, empty where it is not raised.
    pub(crate) fn text(&self, alert: Alert) -> String {
        let standing = self.autopilot().alerts().standing();
        let found = standing.iter().find(|standing| standing.alert == alert);
        found.map_or(String::new(), |standing| self.autopilot().text_of(standing))
    }

    pub(crate) fn last_htd(&self) -> &Htd {
        &self.htd.last().unwrap().1
    }

    /// The last line of that formatter that the autopilot said to the chart system, empty where it said none.
    pub(crate) fn told(&self, formatter: &str) -> String {
        let told = &self.wire.lock().unwrap().told;
        let found = told.iter().find(|(name, ..)| name == formatter);
        found.map_or(String::new(), |(_, line, _)| line.clone())
    }

    /// How many of those it said.
    pub(crate) fn count(&self, formatter: &str) -> usize {
        let told = &self.wire.lock().unwrap().told;
        let found = told.iter().find(|(name, ..)| name == formatter);
        found.map_or(0, |(.., count)| *count)
    }

    /// The last line of that formatter that the chart system sent.
    pub(crate) fn line(&self, formatter: &str) -> String {
        let said = &self.wire.lock().unwrap().said;
        let found = said.iter().find(|(name, _)| name == formatter);
        let (_, line) = found.unwrap_or_else(|| panic!("no {formatter} was sent"));
        line.clone()
    }

    /// FA6: every step of the order within slew and limit, from the first order on.
    pub(crate) fn check_orders(&self) {
        let sides = [&self.orders, &self.port_orders];
        for pair in sides.into_iter().flat_map(|side| side.windows(2)) {
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

/// Replaces fields of a line (counted from 1) and repairs its checksum.
pub(crate) fn edited(line: &str, changes: &[(usize, &str)]) -> String {
    let body = line.trim_start_matches('$').split('*').next().unwrap();
    let mut fields: Vec<&str> = body.split(',').collect();
    for (index, text) in changes {
        fields[*index] = text;
    }
    with_checksum(&fields.join(","))
}
