//! Who may load what a plotter offers, and when (TCS-13).

use super::control::Commanding;
use super::offered::Offer;
use super::state::ChartSystem;
use crate::command::Refusal;
use crate::nmea::Sentence;
use crate::route::Route;
use crate::station::{PortIndex, Profile};
use crate::time::Stamp;
use alloc::format;
use alloc::string::String;

impl ChartSystem {
    /// Takes what a plotter says of its route.
    pub(super) fn hear_of_routes(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        if self.post.ports()[port].profile == Profile::Plotter {
            self.offered.hear(now, sentence, &self.config);
        }
    }

    /// The route that a plotter offers (TCS-13).
    #[must_use]
    pub const fn offer(&self) -> Option<&Offer> {
        self.offered.offer.as_ref()
    }

    /// The offer with this number, where it may be loaded now.
    ///
    /// # Errors
    /// There is none, another one is offered now, it cannot be sailed, or control is active.
    pub fn may_load(&self, number: u64) -> Result<&Route, Refusal> {
        let refuse = |text: String| Err(Refusal::because(text));
        let Some(offer) = self.offer() else {
            return refuse("no route is offered".into());
        };
        if offer.number != number {
            return refuse("another route is offered now: look at it first".into());
        }
        if self.control != Commanding::Off {
            return refuse(format!(
                "{} control is active: stop it first",
                self.control.name()
            ));
        }
        offer.route().or_else(|why| refuse(why.clone()))
    }

    /// Loads the offer that an officer saw.
    pub(super) fn load_offer(&mut self, number: u64) -> Result<String, Refusal> {
        let route = self.may_load(number)?.clone();
        let text = format!("route {} loaded, {} legs", route.name(), route.legs().len());
        self.load(route);
        Ok(text)
    }
}
