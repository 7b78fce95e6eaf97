//! Lays the path as it is commanded, held against everything else that is heard (TCS-4, HTC-3).
//!
//! The leg lies through the chart system's position less PNEY,001; the arc about the centre of PNEY,002, tangent to the
//! leg with the commanded radius. Both are moved by the slowly averaged difference of the own and the chart system's
//! position, so that PNEY,001 comes to zero and the own receiver tells the motion between.
//!
//! **Invariant:** the path changes only to one that fits the path before it; what does not fit is named, and nothing moves.

use super::followed::{AutonavTi, TurnPlan};
use crate::autopilot::facts::Outlook;
use crate::autopilot::remote::{Charted, nearest};
use crate::geo::Point;
use crate::path::{Arc, Part, Path};
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
/// Centres this far apart belong to different turns, metres.
const SAME_TURN_M: f64 = 50.0;

impl AutonavTi {
    /// Lays the path anew as track and radius are commanded now, or says what does not agree.
    pub(super) fn lay(
        &mut self,
        outlook: &Outlook<'_>,
        charted: Charted<'_>,
        (commanded, radius): (Course, Option<Radius>),
    ) -> Result<(), String> {
        charted.distances_said()?;
        let now = outlook.facts.now;
        let (Some(line), Some(ship)) = (charted.leg(commanded), outlook.sight.place(now)) else {
            return Ok(());
        };
        charted.positions_agree()?;
        let around = Around {
            outlook,
            charted,
            ship,
        };
        let (path, track) = (self.path, self.track);
        let next = match (radius, path.turn) {
            (None, None) => self.on_leg(line, around)?,
            (None, Some(turn)) => self.turn_ends(&path, &turn, line, around)?,
            (Some(radius), None) => self.turn_begins(&path, commanded, radius, around)?,
            (Some(radius), Some(turn)) => {
                self.in_turn(&path, &turn, (track, commanded), radius, around)?
            }
        };
        let Some(next) = next else {
            return Ok(()); // what belongs to it has not come yet
        };
        self.agreed = now;
        self.without_centre = radius.is_some() && charted.centre().is_none();
        self.path = next;
        self.track = commanded;
        if let Some(turn) = next.turn {
            self.radius = radius.or(Some(turn.radius));
        }
        Ok(())
    }

    /// Situations 2 and 5.
    fn on_leg(&mut self, line: Path, around: Around<'_>) -> Result<Option<Path>, String> {
        let (ship, settings) = (around.ship, around.outlook.facts.settings);
        self.wheel_over = None;
        self.turn = TurnPlan::default();
        let (course, point) = self.leg;
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
        if libm::fabs(moved) > settings.leg_tolerance {
            return Err(format!(
                "PNEY,001 moves the leg by {:.0} m",
                libm::fabs(moved)
            ));
        }
        around.charted.displays_agree()?;
        // What was accepted follows slowly, so that many small steps are a large one.
        let dt = settings.step_ms() as f64 / 1000.0;
        let (degrees, metres) = (LEG_FOLLOWS.0 * dt, LEG_FOLLOWS.1 * dt);
        let course = course + SignedAngle::from_deg(turned.deg().clamp(-degrees, degrees));
        let point =
            nearest(&accepted, ship).towards(course.deg() + 90.0, moved.clamp(-metres, metres));
        self.leg = (course, point);
        Ok(Some(line))
    }

    /// From situation 4 to 5, or a turn that is taken back before it began.
    fn turn_ends(
        &mut self,
        path: &Path,
        turn: &Arc,
        line: Path,
        around: Around<'_>,
    ) -> Result<Option<Path>, String> {
        let (ship, settings) = (around.ship, around.outlook.facts.settings);
        if self.straight < 2 {
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
            || self.turn.altered && off(tangent) <= TURN_LEFT_DEG
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
        let tolerance = settings.leg_tolerance.max(0.15 * turn.radius.m());
        if moved > tolerance {
            return Err(format!(
                "PNEY,001 puts the leg {moved:.0} m beside the end of the turn"
            ));
        }
        self.leg = (line.course_in, line.point);
        self.wheel_over = None;
        self.turn = TurnPlan::default();
        Ok(Some(line))
    }

    /// Situation 3: the arc is laid about the commanded centre.
    fn turn_begins(
        &mut self,
        path: &Path,
        track: Course,
        radius: Radius,
        around: Around<'_>,
    ) -> Result<Option<Path>, String> {
        let (now, ship) = (around.outlook.facts.now, around.ship);
        let (_, since) = *self.wheel_over.get_or_insert((ship, now));
        let Some(centre) = around.charted.centre() else {
            if now.since(since) <= CENTRE_GRACE_MS {
                return Ok(None);
            }
            // With the forwarding time known the arc is certain from leg, radius and place.
            let known = around.outlook.facts.settings.forwarding_s.is_some();
            let laid = self.turn_without_centre(around.outlook, track, radius);
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
        let side = around.fits(path, centre, radius)?;
        if turned * side < -LEG_STEP_DEG {
            return Err("PNEY,002: the centre lies on the other side than the turn".into());
        }
        around.pney1_is_near(path)?;
        let open = turned * side < 1.0;
        self.turn = TurnPlan {
            altered: open,
            open,
        };
        let ahead = if open { TURN_AHEAD_DEG } else { turned * side };
        let out = path.course_in + SignedAngle::from_deg(side * ahead);
        Ok(Some(Path::turn(path.course_in, centre, radius, out)))
    }

    /// Situations 3 and 4 of a turn that is laid already.
    fn in_turn(
        &mut self,
        path: &Path,
        turn: &Arc,
        (before, track): (Course, Course),
        radius: Radius,
        around: Around<'_>,
    ) -> Result<Option<Path>, String> {
        let (ship, settings) = (around.ship, around.outlook.facts.settings);
        let centre = around.charted.centre().unwrap_or(turn.centre);
        let progress = path.progress(ship);
        let near_end = progress.part == Part::LegOut
            || path.arc_length() - progress.along < 0.3 * turn.radius.m();
        if centre.distance(turn.centre) > SAME_TURN_M && near_end {
            // The next turn follows at once: its leg in is this one's leg out.
            let leg = path.leg_out();
            let side = around.fits(&leg, centre, radius)?;
            let turned = (track - turn.course_out).deg() * side;
            if (1.0..=175.0).contains(&turned) {
                self.turn = TurnPlan::default();
                return Ok(Some(Path::turn(turn.course_out, centre, radius, track)));
            }
        }
        let tolerance = settings.centre_tolerance;
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
        self.turn.altered |= step >= TRACK_SAME_DEG;
        let TurnPlan { altered, open } = self.turn;
        if !altered {
            around.pney1_is_near(path)?;
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

    /// Lays the turn that was commanded, where it is not laid yet, for it to be finished (TCS-8).
    pub(super) fn lay_what_was_commanded(
        &mut self,
        outlook: &Outlook<'_>,
        track: Course,
        radius: Radius,
    ) {
        if self.path.turn.is_some() {
            return;
        }
        if let Some(turn) = self.turn_without_centre(outlook, track, radius) {
            self.path = turn;
            self.track = track;
        }
    }

    /// The arc that begins one forwarding time after the radius was commanded.
    fn turn_without_centre(
        &self,
        outlook: &Outlook<'_>,
        track: Course,
        radius: Radius,
    ) -> Option<Path> {
        let path = &self.path;
        let (wheel_over, _) = self.wheel_over?;
        let turned = (track - path.course_in).deg();
        if !(1.0..=175.0).contains(&libm::fabs(turned)) {
            return None;
        }
        let seconds =
            (outlook.facts.settings.forwarding_s).unwrap_or_else(|| outlook.ship.forwarding_time());
        let start = nearest(path, wheel_over)
            .towards(path.course_in.deg(), seconds * outlook.speed().mps());
        let side = libm::copysign(1.0, turned);
        let centre = start.towards(path.course_in.deg() + 90.0 * side, radius.m());
        Some(Path::turn(path.course_in, centre, radius, track))
    }
}

/// What a path is held against.
#[derive(Clone, Copy)]
struct Around<'a> {
    outlook: &'a Outlook<'a>,
    charted: Charted<'a>,
    /// Where the ship is.
    ship: Point,
}

impl Around<'_> {
    /// The side of a centre that lies one radius off the leg, ahead of the ship.
    fn fits(self, path: &Path, centre: Point, radius: Radius) -> Result<f64, String> {
        let settings = self.outlook.facts.settings;
        let leg = Path::leg(self.ship, path.course_in);
        let ahead = leg.progress(centre).along;
        let across = Path::leg(path.point, path.course_in)
            .progress(centre)
            .cross_track;
        let off = libm::fabs(across) - radius.m();
        if libm::fabs(off) > settings.centre_tolerance {
            return Err(format!(
                "PNEY,002: the centre lies {:.2} nm off the leg, the radius is {:.2} nm",
                libm::fabs(across) / METRES_PER_NAUTICAL_MILE,
                radius.nm()
            ));
        }
        let farthest = (ARC_AHEAD.0 * self.outlook.speed().mps()).max(ARC_AHEAD.1);
        if !(-0.7 * radius.m() - 200.0..=farthest).contains(&ahead) {
            return Err(format!(
                "PNEY,002: the arc would begin {:.2} nm ahead of the ship",
                ahead / METRES_PER_NAUTICAL_MILE
            ));
        }
        Ok(libm::copysign(1.0, across))
    }

    /// In a turn PNEY,001 belongs to the leg before it or after it.
    fn pney1_is_near(self, path: &Path) -> Result<(), String> {
        let (Some(ship), Some(distance)) = (self.charted.ship(), self.charted.control_distance())
        else {
            return Ok(());
        };
        let before = Path::leg(path.point, path.course_in).cross_track(ship).m();
        let after = path.turn.map(|_| path.leg_out().cross_track(ship).m());
        let off = |expected: f64| libm::fabs(distance - expected);
        let least = after.map_or(off(before), |after| off(before).min(off(after)));
        if least > self.outlook.facts.settings.leg_tolerance.max(100.0) {
            return Err(format!(
                "PNEY,001 is {least:.0} m off both legs of the turn"
            ));
        }
        Ok(())
    }
}
