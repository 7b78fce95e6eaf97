//! Track control holds what is commanded against everything else that is heard (TCS-4, HTC-3).
//!
//! The leg lies through the chart system's position less PNEY,001; the arc about the centre of PNEY,002, tangent to the
//! leg with the commanded radius. Both are moved by the slowly averaged difference of the own and the chart system's
//! position, so that PNEY,001 comes to zero and the own receiver tells the motion between.
//!
//! **Invariant:** the path changes only to one that fits the path before it; what does not fit is named, and nothing moves.

use super::super::{Autopilot, Mode};
use super::TurnPlan;
use super::place::nearest;
use crate::command;
use crate::facts::Quantity;
use crate::geo::Point;
use crate::path::{Arc, Part, Path};
use crate::time::Stamp;
use crate::units::{Course, METRES_PER_NAUTICAL_MILE, Radius, SignedAngle};
use alloc::format;
use alloc::string::String;

/// A leg's course may be altered by so much without a turn, degrees.
const LEG_STEP_DEG: f64 = 5.0;
/// The leg as it was accepted follows so slowly: degrees and metres a second.
const LEG_FOLLOWS: (f64, f64) = (0.1, 0.5);
/// A turn is over when the planned arc is, but for so many degrees.
const TURN_LEFT_DEG: f64 = 12.0;
/// A track may be altered in a turn by so much at once beyond the planned one, degrees (HTC-3).
const TRACK_STEP_DEG: f64 = 30.0;
/// Tracks within so many degrees are the same.
const TRACK_SAME_DEG: f64 = 0.05;
/// A turn where the track is the tangent itself goes on at least so far, degrees.
const TURN_AHEAD_DEG: f64 = 40.0;
/// PNEY,002 may come so long after the HTC that it belongs to.
const CENTRE_GRACE_MS: u64 = 1_500;
/// An arc begins at most so far ahead of the ship, seconds of way and metres.
const ARC_AHEAD: (f64, f64) = (150.0, 1_500.0);
/// Said while a turn is made without its centre.
const NO_CENTRE: &str = "PNEY,002 has no centre: the turn is made by leg, radius and place";
/// Centres this far apart belong to different turns, metres.
const SAME_TURN_M: f64 = 50.0;

impl Autopilot {
    /// Lays the path anew as it is commanded now, or says what does not agree.
    pub(super) fn agree(&mut self, now: Stamp) -> Result<(), String> {
        let Mode::AutonavTi(ti) = &self.mode else {
            return Ok(());
        };
        let (path, track) = (ti.path, ti.track);
        let Some(command::Remote::Track {
            track: commanded,
            radius,
            ..
        }) = self.remote.command(now, self.settings.track_fail_ms())
        else {
            return Ok(()); // its age is watched
        };
        self.distances_said()?;
        let (Some(line), Some(ship)) = (self.leg_line(commanded), self.sight.place(now)) else {
            return Ok(());
        };
        self.positions_agree()?;
        let next = match (radius, path.turn) {
            (None, None) => self.on_leg(&path, line, ship)?,
            (None, Some(turn)) => self.turn_ends(&path, &turn, line, ship)?,
            (Some(radius), None) => self.turn_begins(now, &path, commanded, radius, ship)?,
            (Some(radius), Some(turn)) => {
                self.in_turn(&path, &turn, (track, commanded), radius, ship)?
            }
        };
        let Some(next) = next else {
            return Ok(()); // what belongs to it has not come yet
        };
        self.remote.agreed = now;
        let centred = radius.is_none() || self.centre().is_some();
        self.remote.makeshift = (!centred).then(|| NO_CENTRE.into());
        if let Mode::AutonavTi(ti) = &mut self.mode {
            ti.path = next;
            ti.track = commanded;
            if let Some(turn) = next.turn {
                ti.radius = radius.or(Some(turn.radius));
            }
        }
        Ok(())
    }

    /// Why nothing was agreed for so long.
    pub(super) fn disagreement(&mut self, now: Stamp) -> String {
        self.agree(now)
            .err()
            .unwrap_or_else(|| "the chart system's sentences do not agree".into())
    }

    /// Situations 2 and 5.
    fn on_leg(&mut self, path: &Path, line: Path, ship: Point) -> Result<Option<Path>, String> {
        self.remote.wheel_over = None;
        self.remote.turn = TurnPlan::default();
        let (course, point) = self.remote.leg.unwrap_or((path.course_in, path.point));
        let turned = line.course_in - course;
        if turned.abs().deg() > LEG_STEP_DEG {
            return Err(format!(
                "HTC field 12: track {:.1} is {:.0}° off the leg {:.1}, and no radius is commanded",
                line.course_in.deg(),
                turned.abs().deg(),
                course.deg()
            ));
        }
        let accepted = Path::leg(point, course);
        let moved = accepted.cross_track(ship).m() - line.cross_track(ship).m();
        if libm::fabs(moved) > self.settings.leg_tolerance {
            return Err(format!(
                "PNEY,001 moves the leg by {:.0} m",
                libm::fabs(moved)
            ));
        }
        self.displays_agree()?;
        // What was accepted follows slowly, so that many small steps are a large one.
        let dt = self.settings.step_ms() as f64 / 1000.0;
        let (degrees, metres) = (LEG_FOLLOWS.0 * dt, LEG_FOLLOWS.1 * dt);
        let course = course + SignedAngle::from_deg(turned.deg().clamp(-degrees, degrees));
        let point =
            nearest(&accepted, ship).towards(course.deg() + 90.0, moved.clamp(-metres, metres));
        self.remote.leg = Some((course, point));
        Ok(Some(line))
    }

    /// FA4: XTE and PNEY,001 that come without a distance are no distances; only a chart system without a route says so.
    fn distances_said(&self) -> Result<(), String> {
        let picture = &self.post.picture;
        let xte = self.fresh(picture.xte.as_ref(), Quantity::Control);
        let pney1 = self.fresh(picture.pney1.as_ref(), Quantity::Control);
        let silent = [
            ("XTE", xte.map(|xte| xte.cross_track)),
            ("PNEY,001", pney1.map(|pney1| pney1.cross_track)),
        ];
        match silent.iter().find(|(_, said)| matches!(said, Some(None))) {
            Some((name, _)) => Err(format!("{name} has no distance")),
            None => Ok(()),
        }
    }

    /// XTE is for display, but on a leg it says the same (situations 2 and 5).
    fn displays_agree(&self) -> Result<(), String> {
        let picture = &self.post.picture;
        let xte = self.fresh(picture.xte.as_ref(), Quantity::Control);
        let pney1 = self.fresh(picture.pney1.as_ref(), Quantity::Control);
        let (Some(xte), Some(pney1)) = (
            xte.and_then(|xte| xte.cross_track),
            pney1.and_then(|pney1| pney1.cross_track),
        ) else {
            return Ok(());
        };
        let apart = libm::fabs(xte - pney1) * METRES_PER_NAUTICAL_MILE;
        if apart > self.settings.leg_tolerance {
            return Err(format!("XTE and PNEY,001 differ by {apart:.0} m on a leg"));
        }
        Ok(())
    }

    /// From situation 4 to 5, or a turn that is taken back before it began.
    fn turn_ends(
        &mut self,
        path: &Path,
        turn: &Arc,
        line: Path,
        ship: Point,
    ) -> Result<Option<Path>, String> {
        if self.remote.straight < 2 {
            return Ok(None); // a single one is a glitch
        }
        let progress = path.progress(ship);
        let off = |course: Course| (line.course_in - course).abs().deg();
        let turned = path.side() * progress.along / turn.radius.m().max(1.0);
        let tangent = path.course_in + SignedAngle::from_deg(turned.to_degrees());
        let left = (turn.course_out - tangent).abs().deg();
        let expected = if progress.part == Part::LegIn && off(path.course_in) <= LEG_STEP_DEG {
            Path::leg(path.point, path.course_in)
        } else if progress.part == Part::LegOut && off(turn.course_out) <= LEG_STEP_DEG
            || progress.part == Part::Arc
                && left <= TURN_LEFT_DEG
                && off(turn.course_out) <= LEG_STEP_DEG
            || self.remote.turn.altered && off(tangent) <= TURN_LEFT_DEG
        {
            let end = turn
                .centre
                .towards(line.course_in.deg() - 90.0 * path.side(), turn.radius.m());
            Path::leg(end, line.course_in)
        } else {
            return Err(format!(
                "HTC field 8: no radius, but {left:.0}° of the turn are left"
            ));
        };
        let moved = libm::fabs(expected.cross_track(ship).m() - line.cross_track(ship).m());
        let tolerance = self.settings.leg_tolerance.max(0.15 * turn.radius.m());
        if moved > tolerance {
            return Err(format!(
                "PNEY,001 puts the leg {moved:.0} m beside the end of the turn"
            ));
        }
        self.remote.leg = Some((line.course_in, line.point));
        self.remote.wheel_over = None;
        self.remote.turn = TurnPlan::default();
        Ok(Some(line))
    }

    /// Situation 3: the arc is laid about the commanded centre.
    fn turn_begins(
        &mut self,
        now: Stamp,
        path: &Path,
        track: Course,
        radius: Radius,
        ship: Point,
    ) -> Result<Option<Path>, String> {
        let (_, since) = *self.remote.wheel_over.get_or_insert((ship, now));
        let Some(centre) = self.centre() else {
            if now.since(since) <= CENTRE_GRACE_MS {
                return Ok(None);
            }
            // With the forwarding time known the arc is certain from leg, radius and place.
            let known = self.settings.forwarding_s.is_some();
            let laid = self.turn_without_centre(path, track, radius);
            return match laid.filter(|_| known) {
                Some(laid) => Ok(Some(laid)),
                None => Err("PNEY,002 has no centre of the commanded radius".into()),
            };
        };
        let turned = (track - path.course_in).deg();
        if libm::fabs(turned) > 175.0 {
            return Err(format!(
                "HTC field 12: track {:.1} turns the ship by {:.0}°",
                track.deg(),
                libm::fabs(turned)
            ));
        }
        let side = self.fits(path, centre, radius, ship)?;
        if turned * side < -LEG_STEP_DEG {
            return Err("PNEY,002: the centre lies on the other side than the turn".into());
        }
        self.pney1_is_near(path)?;
        let open = turned * side < 1.0;
        self.remote.turn = TurnPlan {
            altered: open,
            open,
        };
        let ahead = if open { TURN_AHEAD_DEG } else { turned * side };
        let out = path.course_in + SignedAngle::from_deg(side * ahead);
        Ok(Some(Path::turn(path.course_in, centre, radius, out)))
    }

    /// The side of a centre that lies one radius off the leg, ahead of the ship.
    fn fits(&self, path: &Path, centre: Point, radius: Radius, ship: Point) -> Result<f64, String> {
        let leg = Path::leg(ship, path.course_in);
        let ahead = leg.progress(centre).along;
        let across = Path::leg(path.point, path.course_in)
            .progress(centre)
            .cross_track;
        let off = libm::fabs(across) - radius.m();
        if libm::fabs(off) > self.settings.centre_tolerance {
            return Err(format!(
                "PNEY,002: the centre lies {:.2} nm off the leg, the radius is {:.2} nm",
                libm::fabs(across) / METRES_PER_NAUTICAL_MILE,
                radius.nm()
            ));
        }
        let farthest = (ARC_AHEAD.0 * self.sight.speed(&self.settings).mps()).max(ARC_AHEAD.1);
        if !(-0.7 * radius.m() - 200.0..=farthest).contains(&ahead) {
            return Err(format!(
                "PNEY,002: the arc would begin {:.2} nm ahead of the ship",
                ahead / METRES_PER_NAUTICAL_MILE
            ));
        }
        Ok(libm::copysign(1.0, across))
    }

    /// Situations 3 and 4 of a turn that is laid already.
    fn in_turn(
        &mut self,
        path: &Path,
        turn: &Arc,
        (before, track): (Course, Course),
        radius: Radius,
        ship: Point,
    ) -> Result<Option<Path>, String> {
        let centre = self.centre().unwrap_or(turn.centre);
        let progress = path.progress(ship);
        let near_end = progress.part == Part::LegOut
            || path.arc_length() - progress.along < 0.3 * turn.radius.m();
        if centre.distance(turn.centre) > SAME_TURN_M && near_end {
            // The next turn follows at once: its leg in is this one's leg out.
            let leg = path.leg_out();
            let side = self.fits(&leg, centre, radius, ship)?;
            let turned = (track - turn.course_out).deg() * side;
            if (1.0..=175.0).contains(&turned) {
                self.remote.turn = TurnPlan::default();
                return Ok(Some(Path::turn(turn.course_out, centre, radius, track)));
            }
        }
        let tolerance = self.settings.centre_tolerance;
        if centre.distance(turn.centre) > tolerance {
            return Err(format!(
                "PNEY,002: the centre jumps by {:.2} nm in the turn",
                centre.distance(turn.centre) / METRES_PER_NAUTICAL_MILE
            ));
        }
        if libm::fabs(radius.m() - turn.radius.m()) > tolerance {
            return Err(format!(
                "HTC field 8: the radius changes from {:.2} to {:.2} nm in the turn",
                turn.radius.nm(),
                radius.nm()
            ));
        }
        let side = path.side();
        let of = |course: Course| {
            let turned = side * (course - path.course_in).deg();
            if turned < -90.0 {
                turned + 360.0
            } else {
                turned
            }
        };
        let (planned, asked, last) = (of(turn.course_out), of(track), of(before));
        let step = libm::fabs(asked - last);
        let within = (-LEG_STEP_DEG..=planned + LEG_STEP_DEG).contains(&asked);
        if !(within || step <= TRACK_STEP_DEG) || asked > 200.0 {
            return Err(format!(
                "HTC field 12: the track jumps by {step:.0}° in the turn"
            ));
        }
        self.remote.turn.altered |= step >= TRACK_SAME_DEG;
        let TurnPlan { altered, open } = self.remote.turn;
        if !altered {
            self.pney1_is_near(path)?;
        }
        // HTC-3: the ship stays on the planned radius until it is taken away, wherever the track points.
        let turned = (progress.along / turn.radius.m().max(1.0)).to_degrees();
        let tangent = libm::fabs(asked - turned) < TURN_LEFT_DEG;
        let end = if altered && (open || tangent && asked > planned - 1.0) {
            planned.max(turned.max(asked) + TURN_AHEAD_DEG)
        } else {
            planned.max(asked)
        };
        let out = path.course_in + SignedAngle::from_deg(side * end.min(178.0));
        Ok(Some(Path::turn(path.course_in, centre, radius, out)))
    }

    /// In a turn PNEY,001 belongs to the leg before it or after it.
    fn pney1_is_near(&self, path: &Path) -> Result<(), String> {
        let (Some(ship), Some(distance)) = (self.charted(), self.control_distance()) else {
            return Ok(());
        };
        let before = Path::leg(path.point, path.course_in).cross_track(ship).m();
        let after = path.turn.map(|_| path.leg_out().cross_track(ship).m());
        let off = |expected: f64| libm::fabs(distance - expected);
        let least = after.map_or(off(before), |after| off(before).min(off(after)));
        if least > self.settings.leg_tolerance.max(100.0) {
            return Err(format!(
                "PNEY,001 is {least:.0} m off both legs of the turn"
            ));
        }
        Ok(())
    }
}
