//! The window of a client: at most three snapshots on their way, at most ten a second, always the newest.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

/// Snapshots that may be unacknowledged (FC4).
pub(crate) const LARGEST: usize = 3;
/// Snapshots a second at most.
pub(crate) const FASTEST: f64 = 10.0;
/// Snapshots come on a grid of their own: this much before its time one is taken all the same.
const SLACK: Duration = Duration::from_millis(40);

/// What is on its way to one client.
#[derive(Debug)]
pub(crate) struct Window {
    on_the_way: VecDeque<u64>,
    rate: f64,
    last: Option<Instant>,
}

impl Default for Window {
    fn default() -> Self {
        Self {
            on_the_way: VecDeque::new(),
            rate: FASTEST,
            last: None,
        }
    }
}

impl Window {
    /// When the next snapshot may go; none while the window is closed or none are wanted.
    pub(crate) fn opens(&self, now: Instant) -> Option<Instant> {
        if self.on_the_way.len() >= LARGEST || self.rate <= 0.0 {
            return None;
        }
        let pause = Duration::from_secs_f64(1.0 / self.rate).saturating_sub(SLACK);
        Some(self.last.map_or(now, |last| last + pause))
    }

    /// A snapshot has gone.
    pub(crate) fn sent(&mut self, frame: u64, now: Instant) {
        self.on_the_way.push_back(frame);
        self.last = Some(now);
    }

    /// The client has taken this one, and so all before it.
    pub(crate) fn acknowledge(&mut self, frame: u64) {
        self.on_the_way.retain(|sent| *sent > frame);
    }

    /// The client wants so many a second.
    pub(crate) fn set_rate(&mut self, rate: f64) {
        self.rate = if rate.is_finite() {
            rate.clamp(0.0, FASTEST)
        } else {
            FASTEST
        };
        // Slower than once an hour is never.
        if self.rate < 1.0 / 3600.0 {
            self.rate = 0.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_frames_are_on_the_way_and_no_more() {
        let mut window = Window::default();
        let now = Instant::now();
        for frame in 1..=3 {
            assert!(window.opens(now).is_some());
            window.sent(frame, now);
        }
        assert_eq!(window.opens(now + Duration::from_secs(90)), None);
        window.acknowledge(1);
        assert!(window.opens(now).is_some());
        window.sent(900, now);
        assert_eq!(window.opens(now), None);
        window.acknowledge(900);
        assert!(window.opens(now).is_some());
    }

    #[test]
    fn acknowledging_what_was_never_sent_opens_nothing_more() {
        let mut window = Window::default();
        let now = Instant::now();
        for frame in 5..=7 {
            window.sent(frame, now);
        }
        window.acknowledge(4);
        assert_eq!(window.opens(now), None);
    }

    #[test]
    fn the_client_says_how_often() {
        let mut window = Window::default();
        let now = Instant::now();
        window.set_rate(1.0);
        window.sent(1, now);
        let next = window.opens(now).unwrap();
        assert!(next > now + Duration::from_millis(900));
        window.set_rate(0.0);
        assert_eq!(window.opens(now), None);
        window.set_rate(1e9);
        assert!(window.opens(now).unwrap() <= now + Duration::from_millis(100));
        window.set_rate(f64::MIN_POSITIVE);
        assert_eq!(window.opens(now), None);
        window.set_rate(-1.0);
        assert_eq!(window.opens(now), None);
    }
}
