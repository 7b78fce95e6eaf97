//! The route that a plotter offers, as an officer looks at it before he loads it (TCS-13).

use crate::voyage::Voyage;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// A route that is offered.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OfferedRoute {
    /// Its number, which an order to load it names.
    pub number: u64,
    /// Its name.
    pub name: String,
    /// RTE says complete route; else it is the part that is still to be sailed.
    pub complete: bool,
    /// Identifiers of its waypoints, in order.
    pub waypoints: Vec<String>,
    /// Its length along the legs, nautical miles; absent where it cannot be sailed.
    pub length_nm: Option<f64>,
    /// Why it would not be loaded now, in an officer's words; empty where it would.
    pub refusal: String,
    /// Server time at which it was last heard, milliseconds.
    pub at: u64,
}

/// What a plotter offers to our chart-system side; none where nothing was heard.
#[must_use]
pub fn offered_route(voyage: &Voyage) -> Option<OfferedRoute> {
    let chart = voyage.chart_system()?;
    let offer = chart.offer()?;
    let miles =
        |route: &crate::route::Route| route.legs().iter().map(|leg| leg.length().nm()).sum();
    let refusal = chart.may_load(offer.number).err();
    Some(OfferedRoute {
        number: offer.number,
        name: offer.name.clone(),
        complete: offer.complete,
        waypoints: offer.waypoints.clone(),
        length_nm: offer.route().ok().map(miles),
        refusal: refusal.map_or_else(String::new, |refusal| refusal.to_string()),
        at: offer.at.0,
    })
}
