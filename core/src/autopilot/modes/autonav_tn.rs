//! AutoNAV Tn: the heading to steer comes from the chart system (AP-6, TCS-6).

use super::auto::{Auto, Finish};
use super::former::Former;
use super::need::{ENTRY, Need};
use super::state::{Listed, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::autopilot::facts::Facts;
use crate::autopilot::steering::{Demand, TurnBy};
use crate::command::{Refusal, Remote};
use crate::nmea::{Htd, SteeringMode, TurnMode};
use crate::settings::Role;
use crate::time::Stamp;
use crate::units::{Course, Heading, RateOfTurn};
use alloc::format;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// A heading to steer within so many degrees of another is the same.
const SAME_DEG: f64 = 2.0;
/// A heading to steer that changes by more at once, without a turn, counts when it is said twice, degrees.
const HEADING_STEP_DEG: f64 = 15.0;

/// What was commanded last.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct AutonavTn {
    /// Heading to steer, as last commanded.
    pub hts: Heading,
    /// Commanded track.
    pub track: Course,
    /// Commanded rate while the chart system controls the turn.
    pub rate: Option<RateOfTurn>,
    /// When it was commanded.
    agreed: Stamp,
    /// A heading to steer that waits to be said again.
    stepped: Option<Heading>,
}

impl AutonavTn {
    /// As it is commanded now.
    pub(super) const fn on(
        now: Stamp,
        hts: Heading,
        track: Course,
        rate: Option<RateOfTurn>,
    ) -> Self {
        Self {
            hts,
            track,
            rate,
            agreed: now,
            stepped: None,
        }
    }

    /// TCS-8: a turn is finished at its rate, else `held` is held.
    pub(super) fn lost(&self, held: Heading) -> Auto {
        match self.rate {
            Some(rate) => Auto::finishing(
                self.track.as_heading(),
                Finish {
                    by: TurnBy::Rate(rate),
                    wait: None,
                },
            ),
            None => Auto::on(held),
        }
    }
}

impl Listed for AutonavTn {
    const ROW: Row = Row {
        name: ModeName::AutonavTn,
        title: "AutoNAV Tn",
        what: "Remote heading control: the heading to steer of HTC mode H is steered, in a turn at the commanded rate.",
        role: Role::Operator,
        entry: ENTRY,
        needs: &[
            Need::Heading,
            Need::MeasuredSpeed,
            Need::Command,
            Need::Agreement,
        ],
        on_loss: OnLoss::TrackFail,
        limit: Limit::Max,
        htd: Some(SteeringMode::HeadingControl),
        commanded: Some("heading controlled by the chart system"),
        steers: "",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        let (heading, north) = (Heading::from_deg(0.0), Course::from_deg(0.0));
        let on = |rate| Self::on(Stamp(0), heading, north, rate);
        let turn = Some(RateOfTurn::from_deg_per_min(20.0));
        alloc::vec![
            ("AutoNAV Tn on a leg", on(None)),
            ("AutoNAV Tn in a turn", on(turn)),
        ]
    }
}

impl State for AutonavTn {
    fn demand(&mut self, _: &Facts<'_>) -> Option<Demand> {
        Some(Demand::Heading {
            set: self.hts,
            by: self.rate.map_or(TurnBy::Free, TurnBy::Rate),
        })
    }

    fn hts(&self, _: &Facts<'_>) -> Option<Heading> {
        Some(self.hts)
    }

    fn former(&self) -> Option<Former> {
        Some(Former::Autonav)
    }

    fn htd(&self, _: &Facts<'_>, htd: &mut Htd) {
        if let Some(rate) = self.rate {
            htd.turn_mode = Some(TurnMode::Rate);
            htd.rate_of_turn = Some(rate.abs().deg_per_min());
        }
        htd.heading_to_steer = Some(self.hts.deg());
        htd.track = Some(self.track.deg());
    }

    /// A single heading to steer that jumps is a glitch; said twice it is meant.
    fn accepts(&mut self, command: Remote) -> Result<(), Refusal> {
        let Remote::Heading { hts, rate, .. } = command else {
            return Ok(());
        };
        let step = (hts - self.hts).abs().deg();
        let same = |stepped: Heading| (hts - stepped).abs().deg() <= SAME_DEG;
        let said_before = self.stepped.is_some_and(same);
        if rate.is_none() && step > HEADING_STEP_DEG && !said_before {
            self.stepped = Some(hts);
            return Err(Refusal {
                field: Some(10),
                text: format!("heading to steer jumps by {step:.0}° without a turn"),
            });
        }
        self.stepped = None;
        Ok(())
    }

    fn follow(&mut self, now: Stamp, command: Remote) {
        if let Remote::Heading { hts, track, rate } = command {
            *self = Self::on(now, hts, track, rate);
        }
    }

    fn agreed(&self) -> Option<Stamp> {
        Some(self.agreed)
    }
}
