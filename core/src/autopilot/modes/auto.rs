//! AUTO: heading control; also how a lost turn is finished, and where AutoNAV is selected from (AP-1, AP-6, TCS-8).

use super::former::Former;
use super::need::Need;
use super::state::{Listed, PLANE_M, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::autopilot::facts::Facts;
use crate::autopilot::steering::{Demand, TurnBy};
use crate::nmea::{Htd, SteeringMode};
use crate::path::{Part, Path};
use crate::settings::{Role, Settings, SteeringBy};
use crate::time::Stamp;
use crate::units::{Heading, Radius, RateOfTurn};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// What AUTO steers, and what waits in it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Auto {
    /// Set heading.
    pub set: Heading,
    /// How a lost turn is finished; absent where AUTO's own settings hold.
    pub finish: Option<Finish>,
    /// Until when the operator's selection of AutoNAV stands.
    pub selected_until: Option<Stamp>,
    /// Until when a stop by the chart system may still turn out to be the end of the route (TCS-10).
    pub stop_cause_until: Option<Stamp>,
    /// Until when a second selection of AUTOTUNING begins it (AP-19).
    pub tuning_until: Option<Stamp>,
}

/// How a turn is finished after TRACK FAIL on a curve (TCS-8).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finish {
    /// The last commanded rate or radius.
    pub by: TurnBy,
    /// Lost on the forwarding distance: the leg's course is kept until the arc begins.
    pub wait: Option<Path>,
}

impl Auto {
    /// On a heading.
    #[must_use]
    pub const fn on(set: Heading) -> Self {
        Self {
            set,
            finish: None,
            selected_until: None,
            stop_cause_until: None,
            tuning_until: None,
        }
    }

    /// On the course behind a turn that is finished first.
    pub(super) const fn finishing(set: Heading, finish: Finish) -> Self {
        let mut auto = Self::on(set);
        auto.finish = Some(finish);
        auto
    }
}

/// How AUTO turns by its own settings.
pub(super) fn turns_by(settings: &Settings) -> TurnBy {
    match settings.steering_by {
        SteeringBy::Radius => TurnBy::Radius(Radius::from_nm(settings.set_radius)),
        SteeringBy::Rate => TurnBy::Rate(RateOfTurn::from_deg_per_min(settings.set_rate)),
    }
}

impl Listed for Auto {
    const ROW: Row = Row {
        name: ModeName::Auto,
        title: "AUTO",
        what: "Heading control: the set heading is steered, by the set radius or rate; a turn that was lost is finished.",
        role: Role::Operator,
        entry: &[Need::Heading, Need::NoOverride],
        needs: &[Need::Heading],
        on_loss: OnLoss::RudderHold,
        limit: Limit::Set,
        htd: Some(SteeringMode::StandAlone),
        commanded: None,
        steers: "AUTO steers, SWITCH TO AUTO",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        let heading = Heading::from_deg(0.0);
        let finish = Finish {
            by: TurnBy::Radius(Radius::from_nm(1.0)),
            wait: None,
        };
        alloc::vec![
            ("AUTO", Self::on(heading)),
            (
                "AUTO that finishes a turn",
                Self::finishing(heading, finish)
            ),
        ]
    }
}

impl State for Auto {
    fn demand(&mut self, facts: &Facts<'_>) -> Option<Demand> {
        if let Some(Finish {
            by,
            wait: Some(path),
        }) = self.finish
        {
            if facts.is_on(&path, Part::LegIn) {
                return Some(Demand::Heading {
                    set: path.course_in.as_heading(),
                    by: TurnBy::Free,
                });
            }
            self.finish = Some(Finish { by, wait: None });
        }
        let own = turns_by(facts.settings);
        Some(Demand::Heading {
            set: self.set,
            by: self.finish.map_or(own, |finish| finish.by),
        })
    }

    fn hts(&self, _: &Facts<'_>) -> Option<Heading> {
        Some(self.set)
    }

    fn former(&self) -> Option<Former> {
        Some(Former::Auto(self.set))
    }

    fn htd(&self, facts: &Facts<'_>, htd: &mut Htd) {
        let settings = &facts.settings;
        match settings.steering_by {
            SteeringBy::Radius => htd.radius = Some(settings.set_radius),
            SteeringBy::Rate => htd.rate_of_turn = Some(settings.set_rate),
        }
    }

    fn steers(&self, row: &Row) -> &'static str {
        match self.finish {
            Some(_) => "AUTO finishes the turn, SWITCH TO AUTO",
            None => row.steers,
        }
    }

    fn plane_m(&self) -> Option<f64> {
        // What is left of the turn lies in it.
        self.finish.is_none().then_some(PLANE_M)
    }
}
