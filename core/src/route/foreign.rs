//! The path as a foreign chart system's sentences tell it: leg, arc, centre and next track from HTC, XTE, PNEY and its position (AP-23).
//!
//! In: its sentences in their order, for what must be remembered ([`Before`]), and the picture that was made of them.
//! Out: as much of the path as follows from what is in force at a moment ([`Told`]).
//!
//! **Invariant:** nothing is guessed. What no sentence tells is absent: later waypoints, the wheel-over line before it comes,
//! the leg before a turn that was not heard, and everything that contradicts itself.

use crate::command::{self, Remote};
use crate::facts::Quantity;
use crate::facts::read::{self, Reading};
use crate::geo::{Plane, Point, Position};
use crate::nmea::{Pney2, Sentence, SteeringMode, TurnMode};
use crate::path::{Part, Path};
use crate::picture::{Heard, Picture};
use crate::station::PortIndex;
use crate::time::Stamp;
use crate::units::{Course, Distance, METRES_PER_NAUTICAL_MILE, Radius, SignedAngle};

/// A centre that is off the leg and the radius by more contradicts them, metres, and part of the radius.
const FITS: (f64, f64) = (60.0, 0.05);
/// Centres farther apart belong to different turns, metres.
const SAME_TURN_M: f64 = 20.0;
/// Position and distance of one second come at most so far apart, milliseconds.
const ONE_SECOND_MS: u64 = 1_100;
/// A turn of less is none, of more cannot be drawn, degrees.
const TURNS_DEG: (f64, f64) = (0.5, 178.0);

/// What must be remembered of the sentences before: the leg before the turn, and where the turn was commanded.
///
/// A gap in the commands, another port or another turn without a leg between forgets it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Before {
    /// Who commands, and when it last did.
    last: Option<(PortIndex, Stamp)>,
    /// Track of the leg that was last commanded without a radius.
    track: Option<Course>,
    /// Where the chart system last saw the ship.
    place: Option<Position>,
    /// A radius is commanded since then, when the ship was there.
    wheel_over: Option<(Stamp, Position)>,
    centre: Option<Position>,
}

impl Before {
    /// Hears a sentence of a chart system's port, whole or not.
    pub fn hear(&mut self, at: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        let late = |(from, last): (PortIndex, Stamp)| {
            from != port || at.since(last) > Quantity::Control.limits().1
        };
        if self.last.is_some_and(late) {
            *self = Self::default();
        }
        if !sentence.checksum.is_right() {
            return;
        }
        match sentence.formatter {
            "GLL" => {
                if let Reading::Value(fix) = read::gll(sentence) {
                    self.place = Some(fix.position);
                }
            }
            "PNEY,002" => self.hear_centre(sentence),
            "HTC" => {
                let Ok(command) = command::htc(sentence, true) else {
                    return;
                };
                let place = self.place;
                match command {
                    Remote::Track {
                        track,
                        radius: None,
                        ..
                    } => {
                        (self.track, self.wheel_over, self.centre) = (Some(track), None, None);
                    }
                    Remote::Track { .. } => {
                        if self.track.is_some() && self.wheel_over.is_none() {
                            self.wheel_over = place.map(|place| (at, place));
                        }
                    }
                    _ => {
                        *self = Self {
                            place,
                            ..Self::default()
                        }
                    }
                }
                self.last = Some((port, at));
            }
            _ => {}
        }
    }

    /// A turn that follows another at once has a leg before it that was never commanded.
    fn hear_centre(&mut self, sentence: &Sentence<'_>) {
        let Some(centre) = Pney2::from_sentence(sentence).and_then(|pney2| pney2.centre) else {
            return;
        };
        if let Some(before) = self.centre
            && before.distance(centre) > SAME_TURN_M
        {
            (self.track, self.wheel_over) = (None, None);
        }
        self.centre = Some(centre);
    }
}

/// As much of the path as the sentences in force tell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Told {
    /// The situation: 1 not active, 2 on a leg, 3 wheel-over passed, 4 on the radius.
    pub situation: Option<u8>,
    /// The leg that is sailed, laid through the point abeam of the ship; none on the arc.
    pub leg: Option<Path>,
    /// The turn that is commanded. Where the leg before it is not known, its arc begins abeam of the ship.
    pub turn: Option<Path>,
    /// The leg before the turn is known.
    pub whole: bool,
    /// Where the ship was when the turn was first commanded, and when.
    pub wheel_over: Option<(Stamp, Point)>,
    /// Course of the leg after the turn.
    pub next_track: Option<Course>,
    /// How far off the track the chart system allows, to both sides.
    pub limit: Option<Distance>,
}

impl Told {
    /// What is told at `now`, in a plane near the ship.
    #[must_use]
    pub fn of(picture: &Picture, before: &Before, now: Stamp, plane: &Plane) -> Self {
        let mut told = Self::default();
        let Some(heard) = picture.htc.as_ref() else {
            return told;
        };
        let port = heard.source.port;
        let Some(htc) = heard.usable(Quantity::Control, now).map(|heard| &heard.htc) else {
            return told;
        };
        let (Some(mode), Some(track)) = (htc.steering_mode, htc.track.map(Course::from_deg)) else {
            told.situation = (htc.steering_mode == Some(SteeringMode::StandAlone)).then_some(1);
            return told;
        };
        let here = place(picture, port, now).map(|place| plane.point(place));
        let control = in_force(picture.pney1.as_ref(), port, now).and_then(|x| x.cross_track);
        let display = in_force(picture.xte.as_ref(), port, now).and_then(|x| x.cross_track);
        let metres = |miles: f64| miles * METRES_PER_NAUTICAL_MILE;
        let leg = |course: Course, miles: Option<f64>| {
            let (here, miles) = here.zip(miles)?;
            let abeam = here.towards(course.deg() + 90.0, -metres(miles));
            Some(Path::leg(abeam, course))
        };
        told.limit = htc.off_track_limit.map(Distance::from_nm);
        let radius = htc.radius.map(Radius::from_nm);
        match (mode, radius) {
            (SteeringMode::StandAlone, _) => told.situation = Some(1),
            (SteeringMode::TrackControl, None) => {
                told.situation = Some(2);
                told.leg = leg(track, control.or(display));
            }
            // In a turn of "Tn" nobody says to which leg the distance belongs.
            (SteeringMode::HeadingControl, _) if htc.turn_mode != Some(TurnMode::Rate) => {
                told.leg = leg(track, display.or(control));
            }
            (SteeringMode::TrackControl, Some(radius)) => {
                told.next_track = Some(track);
                // The two distances are the same until the arc begins.
                let same = display
                    .zip(control)
                    .map(|(display, control)| libm::fabs(metres(display - control)) < 2.0);
                told.situation = same.map(|same| if same { 3 } else { 4 });
                let centre = in_force(picture.pney2.as_ref(), port, now).and_then(|p| p.centre);
                if let (Some(ship), Some(centre), Some(control)) = (here, centre, control) {
                    let arc = CommandedArc {
                        ship,
                        centre: plane.point(centre),
                        radius,
                        track,
                        control: metres(control),
                    };
                    let known = before.last.is_some_and(|(from, _)| from == port);
                    match before.track.filter(|_| known) {
                        Some(course) => told.whole_turn(&arc, course, before, plane),
                        None => told.rest_of_turn(&arc),
                    }
                }
            }
            _ => {}
        }
        told
    }

    /// The leg before the turn is known.
    fn whole_turn(&mut self, arc: &CommandedArc, course: Course, before: &Before, plane: &Plane) {
        let turned = (arc.track - course).abs().deg();
        if !(TURNS_DEG.0..=TURNS_DEG.1).contains(&turned) {
            return;
        }
        let path = Path::turn(course, arc.centre, arc.radius, arc.track);
        let leg_in = arc.side(course) == Some(path.side());
        let leg_out = arc.side(arc.track) == Some(path.side());
        let before_arc = match (leg_in, leg_out) {
            (true, true) => path.progress(arc.ship).part == Part::LegIn,
            (false, false) => return,
            (leg_in, _) => leg_in,
        };
        self.situation = Some(if before_arc { 3 } else { 4 });
        (self.turn, self.whole) = (Some(path), true);
        if before_arc {
            let abeam = arc.ship.towards(course.deg() + 90.0, -arc.control);
            self.leg = Some(Path::leg(abeam, course));
        }
        let leg = Path::leg(path.point, course);
        self.wheel_over = before.wheel_over.map(|(at, place)| {
            let along = leg.progress(plane.point(place)).along;
            (at, leg.at(along, 0.0))
        });
    }

    /// The leg before the turn is not known: on the arc what is left of it follows from the leg after it.
    fn rest_of_turn(&mut self, arc: &CommandedArc) {
        let Some(side) = arc.side(arc.track) else {
            return;
        };
        let tangent = Course::from_deg(arc.centre.bearing(arc.ship) + 90.0 * side);
        let left = side * (arc.track - tangent).deg();
        let beside = libm::fabs(arc.centre.distance(arc.ship) - arc.radius.m());
        if beside > arc.tolerance() || !(TURNS_DEG.0..=TURNS_DEG.1).contains(&left) {
            return;
        }
        self.situation = Some(4);
        let out = tangent + SignedAngle::from_deg(side * left);
        self.turn = Some(Path::turn(tangent, arc.centre, arc.radius, out));
    }
}

/// A turn as it is commanded, in the plane.
struct CommandedArc {
    ship: Point,
    centre: Point,
    radius: Radius,
    track: Course,
    /// Cross-track distance for control, metres.
    control: f64,
}

impl CommandedArc {
    /// On which side of a leg on `course`, if PNEY,001 belongs to it, the centre lies; none where it is not one radius off.
    fn side(&self, course: Course) -> Option<f64> {
        let across = self.control
            + Path::leg(self.ship, course)
                .progress(self.centre)
                .cross_track;
        let fits = libm::fabs(libm::fabs(across) - self.radius.m()) <= self.tolerance();
        fits.then(|| libm::copysign(1.0, across))
    }

    fn tolerance(&self) -> f64 {
        FITS.0.max(FITS.1 * self.radius.m())
    }
}

/// A sentence of this port that is in force.
fn in_force<T>(heard: Option<&Heard<T>>, port: PortIndex, now: Stamp) -> Option<&T> {
    heard
        .filter(|heard| heard.source.port == port)?
        .usable(Quantity::Control, now)
}

/// The ship as the chart system sees her, in the second of its distance.
fn place(picture: &Picture, port: PortIndex, now: Stamp) -> Option<Position> {
    let at = picture.pney1.as_ref().map(|heard| heard.at);
    let at = at.max(picture.xte.as_ref().map(|heard| heard.at))?;
    let apart = |fix: &Heard<_>| fix.at.since(at).max(at.since(fix.at));
    let own = picture.fixes.iter().filter(|fix| {
        fix.source.port == port
            && apart(fix) <= ONE_SECOND_MS
            && fix.usable(Quantity::Position, now).is_some()
    });
    own.min_by_key(|fix| apart(fix))
        .map(|fix| fix.value.position)
}

#[cfg(test)]
mod tests;
