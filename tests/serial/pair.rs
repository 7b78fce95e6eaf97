//! Two programs joined by null modems: one the ship with her chart system, one the autopilot.

use crate::autopilot;
use std::fmt::Write;
use std::time::Duration;
use wheelover_core::geo::Position;
use wheelover_core::nmea::{self, Htc, Pney1, SteeringMode, Xte};
use wheelover_core::station::{Direction, Profile};
use wheelover_core::units::Radius;
use wheelover_core::view::{AlertView, ChartRequest, Line, ModeName, ModeRequest, Order};
use wheelover_tests::folder;
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::{NullModem, Tap};

const LINES: [(&str, &str); 5] = [
    ("ecdis", "chart_system"),
    ("gyro1", "world"),
    ("gps", "world"),
    ("log", "world"),
    ("gear", "world"),
];

/// Both programs, and the lines between them.
pub(crate) struct Pair {
    pub(crate) ship: Program,
    pub(crate) autopilot: Program,
    _modems: Vec<NullModem>,
}

impl Pair {
    /// Both sail at this pace; `ship` is what stands in the ship's configuration beside her ports. What the chart system says
    /// passes the tap.
    pub(crate) fn begin(name: &str, pace: &str, ship: &str, mut tap: Option<Tap>) -> Self {
        let folder = folder(name);
        let modem = |(line, _): &(&str, &str)| {
            let tap = tap.take_if(|_| *line == "ecdis");
            NullModem::tapped(&folder, line, tap)
        };
        let modems = LINES.iter().map(modem).collect();
        let mut text = String::from("roles = [\"chart_system\", \"world\"]\nallow_output = true\n");
        for (name, station) in LINES {
            let path = folder.join(format!("{name}.a"));
            let _ = write!(
                text,
                "[[port]]\nname = \"{name}\"\nstation = \"{station}\"\nkind = \"serial\"\npath = \"{}\"\n\
                 baud = 38400\nprofile = \"{name}\"\noutput = true\n",
                path.display()
            );
            let near = folder.join(format!("{name}.b"));
            std::os::unix::fs::symlink(near, folder.join(name)).unwrap();
        }
        let file = folder.join("ship.toml");
        std::fs::write(&file, text + ship).unwrap();
        let config = autopilot(&folder, &LINES.map(|(name, _)| name), true);
        Self {
            autopilot: Program::start(&["--speed", pace, "--config", &config]),
            ship: Program::start(&["--speed", pace, "--config", &file.display().to_string()]),
            _modems: modems,
        }
    }

    /// The officer sets AUTO, has the chart system command, and confirms AutoNAV.
    pub(crate) async fn track(&self, page: &mut Page) {
        page.insist(Order::Mode(ModeRequest::Auto), SOON).await;
        let mut chart = Page::open(self.ship.address).await;
        assert_eq!(chart.hello.station, "chart_system");
        chart.insist(Order::Chart(ChartRequest::Track), SOON).await;
        chart.leave().await;
        page.insist(Order::Mode(ModeRequest::Autonav), SOON).await;
        let tracks = |page: &Page| mode(page) == Some(ModeName::AutonavTi);
        page.until("track control", SOON, tracks).await;
    }
}

/// Waypoints of a route, as a configuration writes them.
pub(crate) fn waypoints<'a>(
    all: impl Iterator<Item = (&'a str, Position, Option<Radius>)>,
) -> String {
    let mut text = String::from("[route]\n");
    for (id, place, radius) in all {
        let _ = write!(
            text,
            "[[route.waypoint]]\nid = \"{id}\"\nlat = {:.8}\nlon = {:.8}\n",
            place.lat, place.lon
        );
        if let Some(radius) = radius {
            let _ = writeln!(text, "radius_nm = {}", radius.nm());
        }
    }
    text
}

pub(crate) fn mode(page: &Page) -> Option<ModeName> {
    page.snapshot.as_ref()?.own.as_ref().map(|own| own.mode)
}

/// The lines between chart system and autopilot.
pub(crate) fn dialogue(page: &Page) -> impl Iterator<Item = &Line> {
    let ports = &page.hello.ports;
    let port = ports.iter().position(|port| port.profile == Profile::Ecdis);
    let lines = page.lines.iter();
    lines.filter(move |line| Some(line.port) == port)
}

/// A part of the way under track control.
#[derive(Debug)]
pub(crate) struct Part {
    /// 2 to 5, as table A.3 numbers them.
    pub(crate) situation: u8,
    /// Largest distance off leg or arc, metres.
    pub(crate) off: f64,
}

/// The parts of a way, as the autopilot's line shows them.
pub(crate) fn parts(page: &Page) -> Vec<Part> {
    let (mut parts, mut turned) = (Vec::<Part>::new(), false);
    let (mut htc, mut xte) = (None::<Htc>, None::<Xte>);
    for Line { dir, text, .. } in dialogue(page) {
        let sentence = nmea::decode(text.as_bytes());
        if *dir == Direction::In {
            htc = Htc::from_sentence(&sentence).or(htc);
            xte = Xte::from_sentence(&sentence).or(xte);
        }
        // PNEY,001 closes the pair of distances of a second.
        let (Some(pney1), Some(htc), Some(xte)) = (
            Pney1::from_sentence(&sentence).filter(|_| *dir == Direction::In),
            &htc,
            &xte,
        ) else {
            continue;
        };
        if htc.steering_mode != Some(SteeringMode::TrackControl) {
            continue;
        }
        let last = parts.last().map(|part| part.situation);
        // On the arc the two distances differ, but for a moment near its end.
        let on_leg = pney1.cross_track == xte.cross_track && last != Some(4);
        let situation = match (htc.radius, on_leg) {
            (None, _) if turned => 5,
            (None, _) => 2,
            (Some(_), true) => 3,
            (Some(_), false) => 4,
        };
        turned |= situation == 4;
        let off = xte.cross_track.unwrap_or(0.0).abs() * 1852.0;
        match parts.last_mut() {
            Some(part) if part.situation == situation => part.off = part.off.max(off),
            _ => parts.push(Part { situation, off }),
        }
    }
    parts
}

/// Follows for so long on board.
pub(crate) async fn follow(page: &mut Page, seconds: f64) {
    let rate = page.hello.rate;
    page.follow(Duration::from_secs_f64(seconds / rate)).await;
}

/// The alert of that title, where it stands.
pub(crate) fn alert<'a>(page: &'a Page, title: &str) -> Option<&'a AlertView> {
    let alerts = &page.snapshot.as_ref()?.alerts;
    alerts.iter().find(|alert| alert.title == title)
}
