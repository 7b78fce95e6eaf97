//! Whether a rudder follows its order (FA11, AP-4).

use crate::time::Stamp;
use crate::timers::Timers;
use crate::units::RudderAngle;
use serde::{Deserialize, Serialize};

/// Order and response may differ by so much, degrees, for so long beyond the time to go (FA11).
const ERROR_DEG: f64 = 5.0;
const ERROR_MS: u64 = 5_000;

/// What is known of the response of one rudder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Response {
    timers: Timers<Timer>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Timer {
    /// Since when the rudder is off its order.
    Off,
}

/// How a rudder answers its order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum Follows {
    /// As it should, or nothing is asked of it.
    Yes,
    /// It is off its order, and may still be on its way.
    NotYet,
    /// It does not.
    No(Fails),
}

/// How a rudder fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum Fails {
    /// Its feedback is lost, or says V.
    NoFeedback,
    /// It stays off its order.
    OffOrder,
}

impl Default for Response {
    fn default() -> Self {
        Self {
            timers: Timers::new(&[]),
        }
    }
}

impl Response {
    /// Holds the response against the order; `slew` is the gear's, degrees a second. Without an order nothing is asked.
    pub(super) fn watch(
        &mut self,
        now: Stamp,
        order: Option<RudderAngle>,
        response: Option<RudderAngle>,
        slew: f64,
    ) -> Follows {
        let Some(order) = order else {
            self.timers.stop(Timer::Off);
            return Follows::Yes;
        };
        let Some(response) = response else {
            return Follows::No(Fails::NoFeedback);
        };
        let difference = libm::fabs(order.deg() - response.deg());
        if difference <= ERROR_DEG {
            self.timers.stop(Timer::Off);
            return Follows::Yes;
        }
        let since = self.timers.begin(Timer::Off, now);
        let to_go = (difference / slew * 1000.0) as u64;
        if now.since(since) > to_go + ERROR_MS {
            Follows::No(Fails::OffOrder)
        } else {
            Follows::NotYet
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // FA11
    #[test]
    fn a_rudder_has_the_time_to_go_and_five_seconds_more() {
        let angle = |degrees| Some(RudderAngle::from_deg(degrees));
        let mut rudder = Response::default();
        let mut at = |ms: u64, order, response| rudder.watch(Stamp(ms), order, response, 5.0);
        assert_eq!(at(0, angle(20.0), angle(0.0)), Follows::NotYet);
        assert_eq!(at(9_000, angle(20.0), angle(0.0)), Follows::NotYet);
        let failed = at(9_001, angle(20.0), angle(0.0));
        assert_eq!(failed, Follows::No(Fails::OffOrder));
        assert_eq!(at(9_100, angle(20.0), angle(15.0)), Follows::Yes);
        assert_eq!(
            at(9_200, angle(20.0), angle(0.0)),
            Follows::NotYet,
            "it counts anew"
        );
        let silent = at(9_300, angle(20.0), None);
        assert_eq!(silent, Follows::No(Fails::NoFeedback));
        assert_eq!(at(30_000, None, None), Follows::Yes, "no order, no error");
        assert_eq!(at(30_100, angle(20.0), angle(0.0)), Follows::NotYet);
    }
}
