//! Where the commanded leg, centre and turn lie in the own plane (TCS-4, AP-16).

use super::super::{Autopilot, Mode};
use crate::command;
use crate::facts::Quantity;
use crate::geo::{Point, Position};
use crate::path::Path;
use crate::time::Stamp;
use crate::units::{Course, METRES_PER_NAUTICAL_MILE, Radius};
use alloc::format;
use alloc::string::String;

/// Time constant of the difference of the two positions, seconds.
const OFFSET_TIME_S: f64 = 60.0;
/// A difference that is off the averaged one by more counts as this much, metres.
const LEARNS_M: f64 = 20.0;
/// A difference that leaves the averaged one by more is a jump: refused, not followed, metres.
const JUMPED_M: f64 = 50.0;
/// Own and chart system's position farther apart cannot be the same ship, metres.
const POSITIONS_APART_M: f64 = 400.0;

impl Autopilot {
    /// The commanded centre in the own plane.
    pub(super) fn centre(&self) -> Option<Point> {
        let pney2 = self.fresh(self.post.picture.pney2.as_ref(), Quantity::Control)?;
        self.own_point(pney2.centre?)
    }

    /// A place of the chart system's in the own plane, moved by the difference of the two positions.
    fn own_point(&self, place: Position) -> Option<Point> {
        let point = self.sight.plane()?.point(place);
        let offset = self.remote.offset.unwrap_or_default();
        Some(Point {
            north: point.north + offset.north,
            east: point.east + offset.east,
        })
    }

    /// Cross-track distance for control, metres, ship right of the track positive.
    pub(super) fn control_distance(&self) -> Option<f64> {
        let heard = self.fresh(self.post.picture.pney1.as_ref(), Quantity::Control)?;
        Some(heard.cross_track? * METRES_PER_NAUTICAL_MILE)
    }

    /// The ship as the chart system sees her, in the second of PNEY,001; the own place where it says none.
    pub(super) fn charted(&self) -> Option<Point> {
        let heard = self.post.picture.pney1.as_ref()?;
        let fixes = &self.post.picture.fixes;
        let charted = fixes.iter().find(|fix| {
            fix.source.port == heard.source.port
                && fix.at.since(heard.at).max(heard.at.since(fix.at)) <= 1_100
        });
        charted
            .and_then(|fix| self.own_point(fix.value.position))
            .or_else(|| self.sight.place(self.now))
    }

    /// Where the commanded leg passes: the chart system's position less its cross-track distance.
    pub(in super::super) fn leg_line(&self, track: Course) -> Option<Path> {
        let distance = self.control_distance()?;
        let point = self.charted()?.towards(track.deg() + 90.0, -distance);
        Some(Path::leg(point, track))
    }

    /// TCS-4: learns the difference between the own and the chart system's position.
    pub(super) fn compare_positions(&mut self) {
        let picture = &self.post.picture;
        let Some(port) = picture.pney1.as_ref().map(|heard| heard.source.port) else {
            return;
        };
        let Some(own) = self.sight.receiver() else {
            return;
        };
        if own.port == port {
            (self.remote.offset, self.remote.apart, self.remote.jumped) = (None, 0.0, 0.0);
            return;
        }
        let charted = picture.fixes.iter().find(|fix| fix.source.port == port);
        let Some(charted) = charted.filter(|fix| self.remote.compared.is_none_or(|at| fix.at > at))
        else {
            return;
        };
        let (Some(plane), Some(own)) = (self.sight.plane(), self.sight.place(charted.at)) else {
            return;
        };
        let chart = plane.point(charted.value.position);
        let apart = Point {
            north: own.north - chart.north,
            east: own.east - chart.east,
        };
        let since = self
            .remote
            .compared
            .map_or(1_000, |at| charted.at.since(at));
        self.remote.compared = Some(charted.at);
        self.remote.apart = apart.distance(Point::default());
        if self.remote.apart > POSITIONS_APART_M {
            return; // another ship's place, or a glitch: nothing is learned of it
        }
        let share = (since as f64 / 1000.0 / OFFSET_TIME_S).min(1.0);
        let engaged = matches!(self.mode, Mode::AutonavTi { .. });
        let off = self
            .remote
            .offset
            .map_or(0.0, |offset| offset.distance(apart));
        self.remote.jumped = if engaged { off } else { 0.0 };
        if engaged && off > JUMPED_M {
            return; // one of the two is wrong: the track stays where it is
        }
        self.remote.offset = Some(match self.remote.offset {
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
    pub(in super::super) fn positions_agree(&self) -> Result<(), String> {
        let apart = self.remote.apart;
        if apart > POSITIONS_APART_M {
            return Err(format!(
                "own and the chart system's position are {apart:.0} m apart"
            ));
        }
        let jumped = self.remote.jumped;
        if jumped > JUMPED_M {
            return Err(format!(
                "own and the chart system's position moved apart by {jumped:.0} m"
            ));
        }
        Ok(())
    }

    /// A turn that was commanded but never laid is finished from leg, radius and the time of wheel-over (TCS-8).
    pub(super) fn lay_the_lost_turn(&mut self, now: Stamp) {
        let Mode::AutonavTi(ti) = &self.mode else {
            return;
        };
        let (path, fail) = (ti.path, self.settings.track_fail_ms() + 1_000);
        let Some(command::Remote::Track {
            track,
            radius: Some(radius),
            ..
        }) = self.remote.command(now, fail)
        else {
            return;
        };
        if path.turn.is_some() {
            return;
        }
        let laid = self.turn_without_centre(&path, track, radius);
        if let (Some(turn), Mode::AutonavTi(ti)) = (laid, &mut self.mode) {
            ti.path = turn;
            ti.track = track;
        }
    }

    /// The arc that begins one forwarding time after the radius was commanded.
    pub(super) fn turn_without_centre(
        &self,
        path: &Path,
        track: Course,
        radius: Radius,
    ) -> Option<Path> {
        let (wheel_over, _) = self.remote.wheel_over?;
        let turned = (track - path.course_in).deg();
        if !(1.0..=175.0).contains(&libm::fabs(turned)) {
            return None;
        }
        let seconds = (self.settings.forwarding_s)
            .unwrap_or_else(|| self.steering.settings().forwarding_time());
        let start = nearest(path, wheel_over).towards(
            path.course_in.deg(),
            seconds * self.sight.speed(&self.settings).mps(),
        );
        let side = libm::copysign(1.0, turned);
        let centre = start.towards(path.course_in.deg() + 90.0 * side, radius.m());
        Some(Path::turn(path.course_in, centre, radius, track))
    }

    /// Lays the local plane anew where the ship is: at once outside track control, on very long legs in it.
    pub(in super::super) fn recentre(&mut self) {
        let metres = match &self.mode {
            Mode::Auto(auto) if auto.finish.is_some() => return,
            Mode::AutonavTi(ti) if ti.path.turn.is_some() => return,
            Mode::AutonavTi(_) => 60_000.0,
            _ => 10_000.0,
        };
        let Some(old) = self.sight.recentre(metres) else {
            return;
        };
        let Some(new) = self.sight.plane().copied() else {
            return;
        };
        let carry = |point: Point| new.point(old.position(point));
        if let Mode::AutonavTi(ti) = &mut self.mode {
            ti.path.point = carry(ti.path.point);
        }
        if let Some((_, point)) = &mut self.remote.leg {
            *point = carry(*point);
        }
        if let Some((point, _)) = &mut self.remote.wheel_over {
            *point = carry(*point);
        }
        if let Some(measured) = self.measured() {
            self.gear.engage(self.gear.order());
            self.steering.engage(&measured);
        }
    }
}

/// The point of a leg that is nearest to `point`.
pub(super) fn nearest(leg: &Path, point: Point) -> Point {
    let leg = Path::leg(leg.point, leg.course_in);
    let along = leg.progress(point).along;
    leg.point.towards(leg.course_in.deg(), along)
}
