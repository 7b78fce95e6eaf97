//! Times of a station, indexed by an enum of its own: when something is due, or since when it lasts.

use crate::time::Stamp;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// The timers that run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Timers<T> {
    running: Vec<(T, Stamp)>,
}

impl<T: Copy + PartialEq> Timers<T> {
    /// These run, the others do not.
    pub(crate) fn new(running: &[(T, Stamp)]) -> Self {
        Self {
            running: running.to_vec(),
        }
    }

    /// Sets a timer, whether it runs or not.
    pub(crate) fn set(&mut self, timer: T, at: Stamp) {
        match self.running.iter_mut().find(|(one, _)| *one == timer) {
            Some((_, time)) => *time = at,
            None => self.running.push((timer, at)),
        }
    }

    /// Sets a timer that does not run; the time that stands.
    pub(crate) fn begin(&mut self, timer: T, at: Stamp) -> Stamp {
        if let Some(at) = self.at(timer) {
            return at;
        }
        self.running.push((timer, at));
        at
    }

    /// Stops a timer.
    pub(crate) fn stop(&mut self, timer: T) {
        self.running.retain(|(running, _)| *running != timer);
    }

    /// The time of a timer that runs.
    pub(crate) fn at(&self, timer: T) -> Option<Stamp> {
        let found = self.running.iter().find(|(running, _)| *running == timer);
        found.map(|(_, at)| *at)
    }

    /// The earliest of some timers; of two at the same time the one that is named first.
    pub(crate) fn earliest(&self, of: &[T]) -> Option<(T, Stamp)> {
        let running = of
            .iter()
            .filter_map(|timer| Some((*timer, self.at(*timer)?)));
        running.min_by_key(|(_, at)| *at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_timer_that_runs_keeps_its_time_until_it_is_set_or_stopped() {
        let mut timers = Timers::new(&[('a', Stamp(5)), ('b', Stamp(5))]);
        assert_eq!(timers.begin('a', Stamp(9)), Stamp(5));
        assert_eq!(timers.earliest(&['b', 'a', 'c']), Some(('b', Stamp(5))));
        timers.set('b', Stamp(7));
        assert_eq!(timers.earliest(&['b', 'a']), Some(('a', Stamp(5))));
        timers.stop('a');
        assert_eq!((timers.at('a'), timers.at('b')), (None, Some(Stamp(7))));
        assert_eq!(timers.begin('a', Stamp(9)), Stamp(9));
    }
}
