//! A plotter as a test has it: it sees where the ship is, goes from waypoint to waypoint, and says APB, RMB, XTE and BWC.

use crate::rig::Rig;
use wheelover_core::geo::rhumb;
use wheelover_core::route::Route;
use wheelover_core::station::Profile;

/// The next waypoint is taken so near, nautical miles.
const NEXT_NM: f64 = 0.2;
/// The arrival circle, nautical miles.
const ARRIVAL_NM: f64 = 0.4;

/// What becomes of a sentence: its body, changed, or nothing.
pub(crate) type Spoil<'a> = &'a dyn Fn(&str) -> Option<String>;

#[derive(Clone)]
pub(crate) struct Plotter {
    pub(crate) route: Route,
    pub(crate) leg: usize,
    /// Cross-track distances of APB in kilometres.
    pub(crate) kilometres: bool,
    /// Directions of APB are of magnetic north, with this variation, degrees east.
    pub(crate) variation: Option<f64>,
    /// APB has a heading to steer.
    pub(crate) heading_to_steer: bool,
    pub(crate) goes_on: bool,
}

impl Plotter {
    pub(crate) fn new(route: &Route) -> Self {
        Self {
            route: route.clone(),
            leg: 0,
            kilometres: false,
            variation: None,
            heading_to_steer: false,
            goes_on: true,
        }
    }

    /// What it says now.
    pub(crate) fn says(&mut self, rig: &Rig) -> Vec<String> {
        let ship = rig.world().truth().position;
        let last = self.route.legs().len() - 1;
        if self.goes_on
            && self.leg < last
            && self.route.leg(self.leg).remaining(ship).nm() < NEXT_NM
        {
            self.leg += 1;
        }
        let leg = self.route.leg(self.leg);
        let across = leg.cross_track(ship);
        let (bearing, range) = rhumb::between(ship, leg.to());
        let steer = if across.m() > 0.0 { 'L' } else { 'R' };
        let nm = across.nm().abs();
        let arrived = if range.nm() < ARRIVAL_NM { 'A' } else { 'V' };
        let passed = if leg.remaining(ship).m() < 0.0 {
            'A'
        } else {
            'V'
        };
        let north = if self.variation.is_some() { 'M' } else { 'T' };
        let of = |degrees: f64| (degrees - self.variation.unwrap_or(0.0)).rem_euclid(360.0);
        let (size, unit) = if self.kilometres {
            (across.m().abs() / 1000.0, 'K')
        } else {
            (nm, 'N')
        };
        let name = format!("WP{}", self.leg + 1);
        let (course, bears) = (leg.course().deg(), bearing.deg());
        let hts = if self.heading_to_steer {
            let angle = (across.m() / 5.0).clamp(-30.0, 30.0);
            format!("{:.1},{north}", of(course - angle))
        } else {
            ",".into()
        };
        vec![
            format!("GPXTE,A,A,{nm:.3},{steer},N,A"),
            format!(
                "GPRMB,A,{nm:.2},{steer},WP{},{name},,,,,{:.2},{bears:.1},15.0,{arrived},A",
                self.leg,
                range.nm()
            ),
            format!(
                "GPBWC,120000.00,,,,,{bears:.1},T,,M,{:.2},N,{name},A",
                range.nm()
            ),
            format!(
                "GPAPB,A,A,{size:.3},{steer},{unit},{arrived},{passed},{:.1},{north},{name},{:.1},{north},{hts},A",
                of(course),
                of(bears)
            ),
        ]
    }
}

impl Rig {
    /// Sails so long with what the plotter says, each sentence as `spoil` leaves it.
    pub(crate) fn follow(&mut self, plotter: &mut Plotter, seconds: u32, spoil: Spoil<'_>) {
        for _ in 0..seconds {
            for body in plotter.says(self) {
                if let Some(body) = spoil(&body) {
                    self.say(Profile::Plotter, &body);
                }
            }
            self.run(1.0);
        }
    }
}

/// Everything as it is said.
pub(crate) fn whole(body: &str) -> Option<String> {
    Some(body.into())
}
