//! The route that a plotter offers by RTE and WPL (TCS-13): gathered, checked by the rules of every route (TCS-11), and
//! taken by an officer's order alone.
//!
//! In: WPL for the places and RTE for their order, complete or working, over as many sentences as it takes. Out: the offer as it
//! stands, with what speaks against it. Radius and corridor are those of the configuration: neither sentence has any.
//!
//! **Invariant:** nothing that is heard changes the route in monitoring. An offer has a number, and another one as soon as
//! anything of it changes; an order names the number that its officer saw.

use super::config::ChartConfig;
use crate::geo::Position;
use crate::nmea::{Assembler, Message, RouteMode, Sentence, Wpl};
use crate::route::{Route, RouteLimits, Waypoint};
use crate::time::Stamp;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Places that are kept; the oldest goes first.
const MOST_PLACES: usize = 256;
/// Waypoints of an offered route.
const MOST_WAYPOINTS: usize = 200;
/// For so long a complete route goes before the working route of the same name, milliseconds.
const COMPLETE_MS: u64 = 60_000;
/// Waypoints without a place that are named.
const NAMED: usize = 3;

/// What a plotter has said of its route.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Offered {
    assembler: Assembler,
    /// The newest last.
    places: Vec<(String, Position)>,
    list: Option<List>,
    pub(super) offer: Option<Offer>,
    number: u64,
}

/// The waypoints in their order, as RTE lists them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct List {
    name: String,
    complete: bool,
    waypoints: Vec<String>,
}

/// A route that is offered.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Offer {
    /// Its number: another one as soon as anything of it changes.
    pub number: u64,
    /// Its name.
    pub name: String,
    /// RTE says complete route; else it is the part that is still to be sailed.
    pub complete: bool,
    /// Its waypoints, in order.
    pub waypoints: Vec<String>,
    /// When RTE was last heard.
    pub at: Stamp,
    /// The route, or why it cannot be sailed.
    route: Result<Route, String>,
}

impl Offer {
    /// The route as it would be loaded.
    ///
    /// # Errors
    /// Why it cannot be sailed: a waypoint without a place, or what the rules of a route say (TCS-11).
    pub const fn route(&self) -> Result<&Route, &String> {
        self.route.as_ref()
    }
}

impl Offered {
    /// Takes what a plotter says.
    pub(super) fn hear(&mut self, now: Stamp, sentence: &Sentence<'_>, config: &ChartConfig) {
        match sentence.formatter {
            "WPL" => {
                let Some(wpl) = Wpl::from_sentence(sentence) else {
                    return;
                };
                if let (Some(place), Some(id)) = (wpl.position, wpl.waypoint) {
                    self.places.retain(|(known, _)| *known != id);
                    self.places.push((id, place));
                    if self.places.len() > MOST_PLACES {
                        self.places.remove(0);
                    }
                }
            }
            "RTE" => {
                let whole = self.assembler.push(now, sentence);
                let Some(Message::Route {
                    route,
                    mode,
                    waypoints,
                }) = whole
                else {
                    return;
                };
                self.take(
                    now,
                    List {
                        name: route.unwrap_or_else(|| "offered route".into()),
                        complete: mode != Some(RouteMode::Working),
                        waypoints,
                    },
                );
            }
            _ => return,
        }
        self.judge(now, config);
    }

    fn take(&mut self, now: Stamp, list: List) {
        let hidden = !list.complete
            && self
                .list
                .as_ref()
                .zip(self.offer.as_ref())
                .is_some_and(|(known, offer)| {
                    known.complete && known.name == list.name && now.since(offer.at) < COMPLETE_MS
                });
        if hidden {
            return;
        }
        self.list = Some(list);
        if let Some(offer) = &mut self.offer {
            offer.at = now;
        }
    }

    /// Makes the offer anew where anything of it has changed.
    fn judge(&mut self, now: Stamp, config: &ChartConfig) {
        let Some(list) = &self.list else { return };
        let route = self.route(list, config);
        let same = self.offer.as_ref().is_some_and(|offer| {
            offer.name == list.name
                && offer.complete == list.complete
                && offer.waypoints == list.waypoints
                && offer.route == route
        });
        if same {
            return;
        }
        self.number += 1;
        self.offer = Some(Offer {
            number: self.number,
            name: list.name.clone(),
            complete: list.complete,
            waypoints: list.waypoints.clone(),
            at: self.offer.as_ref().map_or(now, |offer| offer.at),
            route,
        });
    }

    fn route(&self, list: &List, config: &ChartConfig) -> Result<Route, String> {
        let count = list.waypoints.len();
        if count > MOST_WAYPOINTS {
            return Err(format!(
                "{count} waypoints; at most {MOST_WAYPOINTS} are taken"
            ));
        }
        let place = |id: &String| {
            let known = self.places.iter().find(|(known, _)| known == id);
            known.map(|(_, place)| *place)
        };
        let missing = list.waypoints.iter().filter(|id| place(id).is_none());
        let missing: Vec<&str> = missing.map(String::as_str).collect();
        if !missing.is_empty() {
            let named = missing[..missing.len().min(NAMED)].join(", ");
            let more = match missing.len().saturating_sub(NAMED) {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            return Err(format!("no WPL for waypoint {named}{more}"));
        }
        let waypoint = |(index, id): (usize, &String)| {
            let turns = index > 0 && index + 1 < count;
            let radius = turns.then_some(config.offered_radius);
            Some(Waypoint {
                limit_port: config.offered_corridor,
                limit_starboard: config.offered_corridor,
                ..Waypoint::new(id, place(id)?, radius)
            })
        };
        let waypoints = list.waypoints.iter().enumerate().filter_map(waypoint);
        let limits = RouteLimits {
            speed: config.planned_speed,
            ..RouteLimits::default()
        };
        Route::new(&list.name, waypoints.collect(), limits).map_err(|fault| fault.to_string())
    }
}
