//! One rudder: its order, whether it follows it, and where it is taken to stand (AP-4, FA11).
//!
//! A single rudder is steered by its order whatever its feedback says. Of an independent pair a rudder that fails is given the
//! order of a whole pair on: frozen, it would stay laid over where only its feedback has failed. It is taken to
//! stand where its feedback last said, or at its order where that says nothing, and it is believed again once it has
//! followed for ten seconds.

use super::response::{Follows, Response};
use super::rudder::Rudder;
use crate::time::Stamp;
use crate::units::RudderAngle;
use serde::{Deserialize, Serialize};

/// A response that is off its order by more is no measure of the rudder that acts: the gear does not follow, or its
/// feedback lies (FA11).
const NOT_FOLLOWED_DEG: f64 = 10.0;
/// A rudder that failed is believed again after it has followed for so long.
const TRUST_MS: u64 = 10_000;

/// A rudder with its order.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Side {
    pub(super) rudder: Rudder,
    response: Response,
    failed: Option<Failed>,
}

/// What is known of a rudder that failed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Failed {
    /// Where its feedback last said that it stands, degrees.
    at: Option<f64>,
    /// Since when it follows again.
    follows_since: Option<Stamp>,
}

impl Side {
    /// A second rudder, which begins at the order of the first.
    pub(super) fn beside(first: &Self) -> Self {
        Self {
            rudder: first.rudder,
            ..Self::default()
        }
    }

    /// Its order, degrees.
    pub(super) const fn order(&self) -> f64 {
        self.rudder.order()
    }

    /// Whether it has failed and is not believed again yet.
    pub(super) const fn has_failed(&self) -> bool {
        self.failed.is_some()
    }

    /// FA11: holds the response against the order, where one is given.
    pub(super) fn watch(
        &mut self,
        now: Stamp,
        ordered: bool,
        response: Option<RudderAngle>,
        slew: f64,
    ) -> Follows {
        let order = ordered.then(|| RudderAngle::from_deg(self.order()));
        self.response.watch(now, order, response, slew)
    }

    /// The same of a rudder of a pair; one that failed has to follow for a while.
    pub(super) fn watch_in_pair(
        &mut self,
        now: Stamp,
        ordered: bool,
        response: Option<RudderAngle>,
        slew: f64,
    ) -> Follows {
        let follows = self.watch(now, ordered, response, slew);
        let before = self.failed.and_then(|failed| failed.at);
        let at = response.map(RudderAngle::deg).or(before);
        let since = match (follows, self.failed) {
            (Follows::Yes, Some(failed)) if ordered => Some(failed.follows_since.unwrap_or(now)),
            (Follows::No(_), _) | (Follows::NotYet, Some(_)) => None,
            _ => {
                self.failed = None;
                return follows;
            }
        };
        let trusted = since.is_some_and(|since| now.since(since) >= TRUST_MS);
        self.failed = (!trusted).then_some(Failed {
            at,
            follows_since: since,
        });
        match follows {
            Follows::Yes if !trusted => Follows::NotYet,
            follows => follows,
        }
    }

    /// Where it is taken to stand where it has failed, degrees.
    pub(super) fn stands(&self) -> Option<f64> {
        self.failed
            .map(|failed| failed.at.unwrap_or(self.rudder.order()))
    }

    /// Its angle for the laws, degrees; absent where nothing believable is fed back.
    pub(super) fn acting(&self, response: Option<RudderAngle>) -> Option<f64> {
        if let Some(failed) = self.failed {
            return failed.at;
        }
        let off = |angle: f64| libm::fabs(angle - self.order());
        let response = response.map(RudderAngle::deg);
        response.filter(|angle| off(*angle) <= NOT_FOLLOWED_DEG)
    }
}
