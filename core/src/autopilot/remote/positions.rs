//! The own and the chart system's position: their difference, slowly averaged, and whether they are of one ship (TCS-4).

use super::super::facts::Outlook;
use crate::geo::Point;
use crate::time::Stamp;
use alloc::format;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// Time constant of the difference of the two positions, seconds.
const OFFSET_TIME_S: f64 = 60.0;
/// A difference that is off the averaged one by more counts as this much, metres.
const LEARNS_M: f64 = 20.0;
/// A difference that leaves the averaged one by more is a jump: refused, not followed, metres.
const JUMPED_M: f64 = 50.0;
/// Own and chart system's position farther apart cannot be the same ship, metres.
const APART_M: f64 = 400.0;

/// What is known of the two positions.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(in super::super) struct Positions {
    /// Own position less the chart system's, slowly averaged, metres (TCS-4).
    offset: Option<Point>,
    /// How far apart the two positions were last, metres.
    apart: f64,
    /// How far their difference was off the averaged one last, metres.
    jumped: f64,
    /// The chart system's position that was last compared.
    compared: Option<Stamp>,
}

impl Positions {
    /// Own position less the chart system's, metres.
    pub(in super::super) fn offset(&self) -> Point {
        self.offset.unwrap_or_default()
    }

    /// The plane has moved by so much, metres; the chart system's places have not moved with it.
    pub(in super::super) fn plane_moved(&mut self, by: Point) {
        if let Some(offset) = &mut self.offset {
            offset.north += by.north;
            offset.east += by.east;
        }
    }

    /// TCS-4: learns the difference between the own and the chart system's position; `engaged`: a track is laid by it.
    pub(in super::super) fn compare(&mut self, outlook: &Outlook<'_>, engaged: bool) {
        let picture = outlook.seen.picture;
        let Some(port) = picture.pney1.as_ref().map(|heard| heard.source.port) else {
            return;
        };
        let Some(own) = outlook.sight.receiver() else {
            return;
        };
        if own.port == port {
            (self.offset, self.apart, self.jumped) = (None, 0.0, 0.0);
            return;
        }
        let charted = picture.fixes.iter().find(|fix| fix.source.port == port);
        let Some(charted) = charted.filter(|fix| self.compared.is_none_or(|at| fix.at > at)) else {
            return;
        };
        let (Some(plane), Some(own)) = (outlook.sight.plane(), outlook.sight.place(charted.at))
        else {
            return;
        };
        let chart = plane.point(charted.value.position);
        let apart = Point {
            north: own.north - chart.north,
            east: own.east - chart.east,
        };
        let since = self.compared.map_or(1_000, |at| charted.at.since(at));
        self.compared = Some(charted.at);
        self.apart = apart.distance(Point::default());
        if self.apart > APART_M {
            return; // another ship's place, or a glitch: nothing is learned of it
        }
        let share = (since as f64 / 1000.0 / OFFSET_TIME_S).min(1.0);
        let off = self.offset.map_or(0.0, |offset| offset.distance(apart));
        self.jumped = if engaged { off } else { 0.0 };
        if engaged && off > JUMPED_M {
            return; // one of the two is wrong: the track stays where it is
        }
        self.offset = Some(match self.offset {
            Some(offset) if off <= JUMPED_M => {
                // A step is learned no faster than a drift.
                let share = share * (LEARNS_M / off.max(LEARNS_M));
                Point {
                    north: offset.north + share * (apart.north - offset.north),
                    east: offset.east + share * (apart.east - offset.east),
                }
            }
            _ => apart,
        });
    }

    /// The two positions are those of one ship.
    pub(in super::super) fn agree(&self) -> Result<(), String> {
        let apart = self.apart;
        if apart > APART_M {
            return Err(format!(
                "own and the chart system's position are {apart:.0} m apart"
            ));
        }
        let jumped = self.jumped;
        if jumped > JUMPED_M {
            return Err(format!(
                "own and the chart system's position moved apart by {jumped:.0} m"
            ));
        }
        Ok(())
    }
}
