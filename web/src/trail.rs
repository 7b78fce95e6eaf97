//! The track made good: where the ship was, without a line to where she cannot have come from.

use std::collections::VecDeque;
use wheelover_core::geo::Position;
use wheelover_core::time::Stamp;

/// How many points are kept.
const KEPT: usize = 3_000;
/// Points closer than this to the last one are left out, metres.
const STEP_M: f64 = 8.0;
/// No ship goes farther: metres at once, and metres a second.
const REACH: (f64, f64) = (30.0, 25.0);

/// A point of the track.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dot {
    /// Where the ship was.
    pub place: Position,
    /// No line leads to it from the one before.
    pub begins: bool,
}

/// The track made good, oldest point first.
#[derive(Clone, Debug, Default)]
pub struct Trail {
    dots: VecDeque<Dot>,
    /// The last place that was believed, and when.
    seen: Option<(Position, Stamp)>,
    /// Since when places have been somewhere else.
    away: Option<Stamp>,
}

impl Trail {
    /// Takes a place. One that she cannot have reached is left out until the places there have lasted for `patience`
    /// milliseconds; then the track begins anew there.
    pub fn walk(&mut self, at: Stamp, place: Position, patience: u64) {
        let reached = self.seen.is_none_or(|(last, then)| {
            let seconds = at.since(then) as f64 / 1_000.0;
            last.distance(place) <= REACH.0 + REACH.1 * seconds.min(10.0)
        });
        if !reached && at.since(*self.away.get_or_insert(at)) < patience {
            return;
        }
        self.away = None;
        self.seen = Some((place, at));
        let begins = !reached || self.dots.is_empty();
        let near = |last: &Dot| last.place.distance(place) < STEP_M;
        if !begins && self.dots.back().is_some_and(near) {
            return;
        }
        if self.dots.len() >= KEPT {
            self.dots.pop_front();
        }
        self.dots.push_back(Dot { place, begins });
    }

    /// Its points.
    pub fn dots(&self) -> impl Iterator<Item = &Dot> {
        self.dots.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn north(metres: f64) -> Position {
        Position {
            lat: 54.0 + metres / 111_300.0,
            lon: 12.0,
        }
    }

    /// Walks a second for each place; gives for each point kept the metres north and whether it begins a line.
    fn walked(places: &[f64], patience: u64) -> Vec<(f64, bool)> {
        let mut trail = Trail::default();
        for (second, place) in places.iter().enumerate() {
            trail.walk(Stamp(second as u64 * 1_000), north(*place), patience);
        }
        let far = |dot: &Dot| ((dot.place.lat - 54.0) * 111_300.0).round();
        trail.dots().map(|dot| (far(dot), dot.begins)).collect()
    }

    #[test]
    fn a_ship_that_goes_on_leaves_one_line() {
        assert_eq!(
            walked(&[0.0, 7.0, 14.0, 21.0, 28.0], 0),
            [(0.0, true), (14.0, false), (28.0, false)]
        );
    }

    #[test]
    fn no_line_leads_to_where_she_cannot_have_come_from() {
        // What the autopilot believes is drawn at once, what is only heard when it lasts.
        let jump = [0.0, 400.0, 407.0, 20.0, 30.0];
        assert_eq!(
            walked(&jump, 10_000),
            [(0.0, true), (20.0, false), (30.0, false)]
        );
        assert_eq!(
            walked(&jump, 0),
            [(0.0, true), (400.0, true), (20.0, true), (30.0, false)]
        );
        let lasting: Vec<f64> = core::iter::once(0.0)
            .chain((0..13).map(|_| 400.0))
            .collect();
        assert_eq!(walked(&lasting, 10_000), [(0.0, true), (400.0, true)]);
    }
}
