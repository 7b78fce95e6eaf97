//! AutoNAV Tn: the heading to steer comes from the chart system (AP-6, TCS-6).

use super::auto::{Auto, Finish};
use super::need::{ENTRY, Need};
use super::state::{Facts, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::autopilot::steering::{Demand, TurnBy};
use crate::nmea::{Htd, SteeringMode, TurnMode};
use crate::units::{Course, Heading, RateOfTurn};
use serde::{Deserialize, Serialize};

/// What was commanded last.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct AutonavTn {
    /// Heading to steer, as last commanded.
    pub hts: Heading,
    /// Commanded track.
    pub track: Course,
    /// Commanded rate while the chart system controls the turn.
    pub rate: Option<RateOfTurn>,
}

impl AutonavTn {
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

impl State for AutonavTn {
    const ROW: Row = Row {
        name: ModeName::AutonavTn,
        title: "AutoNAV Tn",
        what: "Remote heading control: the heading to steer of HTC mode H is steered, in a turn at the commanded rate.",
        entry: ENTRY,
        needs: &[
            Need::Heading,
            Need::MeasuredSpeed,
            Need::Command,
            Need::Agreement,
        ],
        on_loss: OnLoss::TrackFail,
        limit: Limit::Max,
        htd: SteeringMode::HeadingControl,
    };

    fn demand(&mut self, _: &Facts) -> Option<Demand> {
        Some(Demand::Heading {
            set: self.hts,
            by: self.rate.map_or(TurnBy::Free, TurnBy::Rate),
        })
    }

    fn hts(&self, _: &Facts) -> Option<Heading> {
        Some(self.hts)
    }

    fn htd(&self, _: &Facts, htd: &mut Htd) {
        if let Some(rate) = self.rate {
            htd.turn_mode = Some(TurnMode::Rate);
            htd.rate_of_turn = Some(rate.abs().deg_per_min());
        }
        htd.heading_to_steer = Some(self.hts.deg());
        htd.track = Some(self.track.deg());
    }
}
