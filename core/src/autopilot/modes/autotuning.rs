//! AUTOTUNING: a bounded zigzag about the heading of AUTO (AP-19). What is identified from it is not built: the log alone
//! keeps the manoeuvre, and no constant changes.

use super::need::Need;
use super::state::{Ended, Listed, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::autopilot::facts::{Facts, Outlook};
use crate::autopilot::steering::Demand;
use crate::settings::{Role, Settings};
use crate::time::Stamp;
use crate::units::{Heading, RudderAngle};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// So many times the rudder is put over to the other side.
const REVERSALS: u8 = 5;

/// How far the zigzag is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Autotuning {
    /// The heading before, to which AUTO returns.
    pub before: Heading,
    /// When it began.
    begun: Stamp,
    /// The rudder is to starboard.
    starboard: bool,
    reversals: u8,
}

impl Autotuning {
    /// About the heading of AUTO.
    pub(super) const fn on(now: Stamp, before: Heading) -> Self {
        Self {
            before,
            begun: now,
            starboard: true,
            reversals: 0,
        }
    }
}

/// What bounds the manoeuvre, and what becomes of it, for the officer before and while it is sailed.
pub(super) fn bounds(settings: &Settings) -> String {
    format!(
        "zigzag of {:.0}° of rudder, turned back {:.0}° off the heading, at most {:.0}° off it and {:.0} s; any command ends it; \
         the log alone keeps it, no constant changes",
        rudder(settings),
        settings.tuning_heading,
        settings.tuning_bound,
        settings.tuning_time
    )
}

/// Degrees to each side, within the operator's limit.
const fn rudder(settings: &Settings) -> f64 {
    settings.tuning_rudder.min(settings.rudder_limit)
}

impl Listed for Autotuning {
    const ROW: Row = Row {
        name: ModeName::Autotuning,
        title: "AUTOTUNING",
        what: "A zigzag about the heading of AUTO, bounded by `tuning_rudder`, `tuning_heading`, `tuning_bound` and `tuning_time`, selected twice; any command ends it, and it ends in AUTO on the heading before. The log alone keeps it: nothing is identified, no constant changes.",
        role: Role::Engineer,
        entry: &[
            Need::AutoSteers,
            Need::Heading,
            Need::NoOverride,
            Need::MeasuredSpeed,
            Need::SteadySpeed,
        ],
        needs: &[Need::Heading, Need::MeasuredSpeed],
        on_loss: OnLoss::RudderHold,
        limit: Limit::Set,
        htd: None,
        commanded: None,
        steers: "AUTOTUNING, a zigzag is sailed",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        alloc::vec![("AUTOTUNING", Self::on(Stamp(0), Heading::from_deg(0.0)))]
    }
}

impl State for Autotuning {
    fn demand(&mut self, facts: &Facts<'_>) -> Option<Demand> {
        let rudder = rudder(facts.settings);
        let rudder = if self.starboard { rudder } else { -rudder };
        Some(Demand::Rudder(RudderAngle::from_deg(rudder)))
    }

    fn watch(&mut self, outlook: &Outlook<'_>) -> Option<Ended> {
        let (facts, settings) = (&outlook.facts, outlook.facts.settings);
        let off = (facts.heading - self.before).deg();
        let turned = if self.starboard { off } else { -off };
        let over = if turned >= settings.tuning_heading {
            self.starboard = !self.starboard;
            self.reversals += 1;
            (self.reversals > REVERSALS).then_some("the zigzag is sailed")
        } else {
            None
        };
        let over = match over {
            _ if outlook.sight.measured_speed().is_none() => Some("no measured speed"),
            _ if libm::fabs(off) > settings.tuning_bound => Some("too far off the heading"),
            _ if facts.now.since(self.begun) as f64 >= settings.tuning_time * 1000.0 => {
                Some("its time is over")
            }
            over => over,
        };
        over.map(|over| Ended {
            set: self.before,
            why: format!("AUTOTUNING ended, {over}: AUTO on the heading before"),
            alert: None,
        })
    }
}
