//! Which position is believed: each receiver is judged by its own track, then the best good one is taken (AP-9, FA9).
//!
//! In: fixes with their source. Out: the believed place, carried on by the ground velocity for five seconds. A fix off its
//! receiver's dead reckoning is left out; three in a row, or one far off, are a jump: that receiver is not believed until it
//! has been steady for ten seconds where it now says the ship is. Another receiver is taken without a step of the place in
//! the plane: the plane moves instead.

use super::way::Way;
use crate::geo::{Plane, Point, Position};
use crate::picture::Source;
use crate::time::Stamp;
use crate::units::RateOfTurn;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// A position is bridged by dead reckoning for so long (AP-9).
const BRIDGE_MS: u64 = 5_000;
/// So many rejected positions in a row mean a jump (FA9).
const REJECTS: u8 = 3;
/// One rejected position this far off means a jump (FA9), metres.
const JUMP_M: f64 = 185.2;
/// A receiver that jumped is believed again after so long without a jump; a better one is taken back after so long of agreement.
const TRUST_MS: u64 = 10_000;

/// A fix of a receiver.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Said<'a> {
    /// Whose it is.
    pub(crate) source: &'a Source,
    /// Order of preference, the lowest first.
    pub(crate) rank: u8,
    /// Where the ship is by it.
    pub(crate) position: Position,
    /// When it was heard.
    pub(crate) at: Stamp,
}

/// What became of the receiver in use.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Judged {
    /// It jumped: track control must end.
    pub(crate) jumped: bool,
    /// Another one is in use, and the plane has moved by so much with it, metres.
    pub(crate) moved: Option<Point>,
}

/// A receiver and its own track.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Receiver {
    source: Source,
    rank: u8,
    /// The last fix that was taken.
    fix: (Point, Stamp),
    /// When the last one was judged.
    judged: Stamp,
    rejects: u8,
    /// It jumped: its last fix since, and since when it has been steady.
    suspect: Option<(Point, Stamp, Stamp)>,
    /// What its fixes make of course and speed.
    way: Way,
}

/// All receivers, and the dead reckoning.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct PositionGuard {
    plane: Option<Plane>,
    /// The last fix of the receiver in use that was taken.
    fix: Option<(Point, Stamp)>,
    velocity: (f64, f64),
    turn: RateOfTurn,
    list: Vec<Receiver>,
    in_use: Option<Source>,
    agrees_since: Option<Stamp>,
}

impl PositionGuard {
    /// The plane in which points are given.
    #[must_use]
    pub(crate) fn plane(&self) -> Option<&Plane> {
        self.plane.as_ref()
    }

    /// Lays a new plane at the ship once she is `metres` from where it touches.
    /// Gives the old plane, for points that must be carried over.
    pub(crate) fn recentre(&mut self, metres: f64) -> Option<Plane> {
        let (old, (fix, _)) = (self.plane?, self.fix?);
        if fix.distance(Point::default()) < metres {
            return None;
        }
        let new = Plane::at(old.position(fix));
        self.lay(old, new);
        Some(old)
    }

    /// The last fix that was taken, unless it is too old.
    #[must_use]
    pub(crate) fn fix(&self, now: Stamp) -> Option<Point> {
        let (fix, at) = self.fix?;
        (now.since(at) <= BRIDGE_MS).then_some(fix)
    }

    /// The receiver in use.
    #[must_use]
    pub(crate) const fn in_use(&self) -> Option<&Source> {
        self.in_use.as_ref()
    }

    /// Receivers whose last fix is not believed.
    pub(crate) fn doubted(&self) -> impl Iterator<Item = &Source> {
        let doubted = |receiver: &&Receiver| receiver.suspect.is_some() || receiver.rejects > 0;
        self.list
            .iter()
            .filter(doubted)
            .map(|receiver| &receiver.source)
    }

    /// Takes how she goes over ground, metres a second, where that is known, and her rate of turn.
    pub(crate) fn goes(&mut self, over_ground: Option<Point>, turn: RateOfTurn) {
        if let Some(velocity) = over_ground {
            self.velocity = (velocity.north, velocity.east);
        }
        self.turn = turn;
    }

    /// What the fixes of the receiver in use make of her way over ground, metres a second, and since when; absent where it is
    /// not believed, or 5 s after its last fix (AP-9).
    pub(crate) fn made_good(&self, now: Stamp) -> Option<(Point, Stamp)> {
        let receiver = self.find(self.in_use.as_ref()?)?;
        let believed = receiver.suspect.is_none();
        receiver.way.velocity(now).filter(|_| believed)
    }

    /// Judges what is new of the fixes that are fresh, and chooses; `step` is the largest distance off the dead reckoning
    /// that is used, metres. `free`: nothing is steered, the best is taken at once.
    pub(crate) fn judge(&mut self, now: Stamp, said: &[Said<'_>], step: f64, free: bool) -> Judged {
        let mut jumped = false;
        self.list
            .retain(|receiver| said.iter().any(|said| *said.source == receiver.source));
        for said in said {
            let plane = *self.plane.get_or_insert_with(|| Plane::at(said.position));
            let point = plane.point(said.position);
            let known = self
                .list
                .iter_mut()
                .find(|receiver| receiver.source == *said.source);
            match known {
                Some(receiver) if receiver.judged < said.at => {
                    let taken = receiver.judge(said.at, point, step, (self.velocity, self.turn));
                    jumped |= taken == Verdict::Jumped && self.in_use.as_ref() == Some(said.source);
                }
                Some(_) => {}
                None => {
                    let mut way = Way::default();
                    way.take(point, said.at, self.turn);
                    self.list.push(Receiver {
                        source: said.source.clone(),
                        rank: said.rank,
                        fix: (point, said.at),
                        judged: said.at,
                        rejects: 0,
                        suspect: None,
                        way,
                    });
                }
            }
        }
        Judged {
            jumped,
            moved: self.choose(now, step, free),
        }
    }

    fn find(&self, source: &Source) -> Option<&Receiver> {
        self.list.iter().find(|receiver| receiver.source == *source)
    }

    /// Chooses a receiver and takes its fix; gives by how much the plane has moved.
    fn choose(&mut self, now: Stamp, step: f64, free: bool) -> Option<Point> {
        let good = self
            .list
            .iter()
            .filter(|receiver| receiver.suspect.is_none());
        let best = good.min_by_key(|receiver| receiver.rank)?.clone();
        let used = self.in_use.as_ref().and_then(|source| self.find(source));
        let next = match used.filter(|used| used.suspect.is_none()) {
            Some(used) if used.source == best.source => best,
            Some(used) if !free => {
                let apart = self
                    .carried(used.fix, now)
                    .distance(self.carried(best.fix, now));
                let better = best.rank < used.rank && apart <= step;
                let since = better.then(|| self.agrees_since.unwrap_or(now));
                let trusted = since.is_some_and(|since| now.since(since) >= TRUST_MS);
                let next = if trusted { best } else { used.clone() };
                self.agrees_since = since;
                next
            }
            _ => best,
        };
        let before = self.dead_reckoning(next.fix.1);
        let changed = self.in_use.as_ref() != Some(&next.source);
        let mut fix = next.fix;
        let mut moved = None;
        if let (true, Some(before), Some(plane)) =
            (changed && self.in_use.is_some(), before, self.plane)
        {
            // AP-9: another receiver is no way made by the ship.
            let by = Point {
                north: fix.0.north - before.north,
                east: fix.0.east - before.east,
            };
            self.lay(plane, Plane::at(plane.position(by)));
            moved = Some(by);
            fix = self.find(&next.source).map_or(fix, |receiver| receiver.fix);
        }
        if changed {
            self.agrees_since = None;
            self.in_use = Some(next.source);
        }
        self.fix = Some(fix);
        moved
    }

    /// Lays another plane under everything that is remembered in it.
    fn lay(&mut self, old: Plane, new: Plane) {
        let carry = |point: &mut Point| *point = new.point(old.position(*point));
        self.fix.iter_mut().for_each(|(fix, _)| carry(fix));
        for receiver in &mut self.list {
            carry(&mut receiver.fix.0);
            receiver.way.carry(&carry);
            receiver
                .suspect
                .iter_mut()
                .for_each(|(point, ..)| carry(point));
        }
        self.plane = Some(new);
    }

    /// Where the ship is at `now`: the last fix carried on by the ground velocity, for at most 5 s.
    #[must_use]
    pub(crate) fn dead_reckoning(&self, now: Stamp) -> Option<Point> {
        let fix = self.fix?;
        (now.since(fix.1) <= BRIDGE_MS).then(|| self.carried(fix, now))
    }

    /// The same on the earth.
    #[must_use]
    pub(crate) fn position(&self, now: Stamp) -> Option<Position> {
        Some(self.plane?.position(self.dead_reckoning(now)?))
    }

    /// As `dead_reckoning`, for as long as a lost turn needs it (TCS-8).
    #[must_use]
    pub(crate) fn long_dead_reckoning(&self, now: Stamp) -> Option<Point> {
        Some(self.carried(self.fix?, now))
    }

    fn carried(&self, fix: (Point, Stamp), now: Stamp) -> Point {
        carried(fix, now, self.velocity)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verdict {
    Taken,
    Rejected,
    Jumped,
}

impl Receiver {
    fn judge(
        &mut self,
        at: Stamp,
        point: Point,
        step: f64,
        (velocity, turn): ((f64, f64), RateOfTurn),
    ) -> Verdict {
        self.judged = at;
        if let Some((last, heard, since)) = self.suspect {
            let off = carried((last, heard), at, velocity).distance(point);
            let steady = off <= step && at.since(heard) <= BRIDGE_MS;
            self.suspect = Some((point, at, if steady { since } else { at }));
            if !steady || at.since(since) < TRUST_MS {
                return Verdict::Rejected;
            }
        } else if at.since(self.fix.1) <= BRIDGE_MS {
            let off = carried(self.fix, at, velocity).distance(point);
            if off > step {
                self.rejects += 1;
                if off <= JUMP_M && self.rejects < REJECTS {
                    return Verdict::Rejected;
                }
                self.suspect = Some((point, at, at));
                self.way = Way::default();
                return Verdict::Jumped;
            }
        }
        (self.fix, self.rejects, self.suspect) = ((point, at), 0, None);
        self.way.take(point, at, turn);
        Verdict::Taken
    }
}

fn carried((fix, at): (Point, Stamp), now: Stamp, velocity: (f64, f64)) -> Point {
    let seconds = now.since(at) as f64 / 1000.0;
    Point {
        north: fix.north + velocity.0 * seconds,
        east: fix.east + velocity.1 * seconds,
    }
}

#[cfg(test)]
mod tests;
