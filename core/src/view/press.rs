//! What a press was shown for: an order that was pressed beside another mode or set value than now is refused (AP-26).
//!
//! In: each snapshot that pages are told, and the frame number that an order carries. Out: whether the order may be done.

use super::message::{Own, Snapshot};
use super::own::own;
use crate::autopilot::{Autopilot, ModeName, title_of};
use crate::command::{ModeRequest, Order};
use crate::time::Stamp;
use alloc::collections::VecDeque;
use alloc::format;
use alloc::string::String;

/// Changes that are remembered; a page shows what is at most a few frames old.
const REMEMBERED: usize = 64;
/// A picture that was shown more frames ago than this is too old to press beside: 15 s at ten a second.
const LONGEST: u64 = 150;

/// What an officer sees when he presses: what his order stands beside.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Beside {
    mode: ModeName,
    selected: Option<ModeName>,
    set_heading: Option<f64>,
    set_value: Option<f64>,
    set_rate: f64,
    set_radius: f64,
    by_radius: bool,
}

impl Beside {
    fn of(own: &Own) -> Self {
        Self {
            mode: own.mode,
            selected: own.pending.as_ref().map(|pending| pending.request),
            set_heading: own.set_heading,
            set_value: own.set_value,
            set_rate: own.set_rate,
            set_radius: own.set_radius,
            by_radius: own.by_radius,
        }
    }

    /// What has changed since, in an officer's words.
    fn changed(&self, now: &Self) -> String {
        let degrees = |heading: Option<f64>| heading.map_or("none".into(), |h| format!("{h:05.1}"));
        if self.mode != now.mode {
            let (was, is) = (title_of(self.mode), title_of(now.mode));
            return format!("the mode is {is} now, it was {was} when this was pressed: not done");
        }
        if self.set_heading != now.set_heading {
            let (was, is) = (degrees(self.set_heading), degrees(now.set_heading));
            return format!(
                "the set heading is {is} now, it was {was} when this was pressed: not done"
            );
        }
        if self.set_value != now.set_value {
            return "what is set has changed since this was pressed: not done".into();
        }
        if self.selected != now.selected {
            return "the selection of AutoNAV has changed since this was pressed: not done".into();
        }
        "the set rate or radius has changed since this was pressed: not done".into()
    }
}

/// What the last frames showed.
#[derive(Clone, Debug, Default)]
pub struct Presses {
    /// Each change, with the first frame that showed it.
    shown: VecDeque<(u64, Beside)>,
    /// The last frame.
    last: u64,
}

impl Presses {
    /// A frame is told to the pages.
    pub fn show(&mut self, snapshot: &Snapshot) {
        self.last = snapshot.frame;
        let Some(own) = &snapshot.own else {
            return;
        };
        let beside = Beside::of(own);
        if self.shown.back().is_none_or(|(_, last)| *last != beside) {
            self.shown.push_back((snapshot.frame, beside));
        }
        while self.shown.len() > REMEMBERED {
            self.shown.pop_front();
        }
    }

    /// Whether an order that was pressed beside `frame` may be done; one without a frame, and STANDBY, always.
    ///
    /// # Errors
    /// What has changed since, in an officer's words.
    pub fn allow(
        &self,
        frame: Option<u64>,
        order: &Order,
        autopilot: &Autopilot,
        now: Stamp,
    ) -> Result<(), String> {
        let Some(frame) = frame.filter(|_| is_held_against_the_picture(order)) else {
            return Ok(());
        };
        let old = "this was pressed for a picture that is no longer known: not done";
        if frame > self.last || self.last - frame > LONGEST {
            return Err(old.into());
        }
        let found = self.shown.iter().rev().find(|(first, _)| *first <= frame);
        let (_, was) = found.ok_or(old)?;
        let is = Beside::of(&own(autopilot, now));
        if *was == is {
            Ok(())
        } else {
            Err(was.changed(&is))
        }
    }
}

/// Whether an order changes how the ship is steered; STANDBY is exempt, whatever else was shown.
fn is_held_against_the_picture(order: &Order) -> bool {
    order.steers() && !matches!(order, Order::Mode(ModeRequest::Standby))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::snapshot;
    use crate::voyage::{Event, Voyage};
    use alloc::vec::Vec;

    struct Page {
        voyage: Voyage,
        presses: Presses,
        frame: u64,
    }

    impl Page {
        fn new() -> Self {
            let mut page = Self {
                voyage: Voyage::embedded(3),
                presses: Presses::default(),
                frame: 0,
            };
            page.order(Order::Officer(false));
            page.order(Order::Mode(ModeRequest::Standby));
            page.sail(5);
            page
        }

        fn order(&mut self, order: Order) {
            let (now, mut out) = (self.voyage.now(), Vec::new());
            let by = crate::command::Origin::Officer;
            let event = Event::Order { id: 1, by, order };
            self.voyage.handle(now, event, &mut out);
        }

        /// So many frames later.
        fn sail(&mut self, frames: u64) {
            for _ in 0..frames {
                let now = self.voyage.now() + 100;
                self.voyage.handle(now, Event::Tick, &mut Vec::new());
                self.frame += 1;
                let mut shown = snapshot(&self.voyage);
                shown.frame = self.frame;
                self.presses.show(&shown);
            }
        }

        fn press(&self, frame: u64, order: &Order) -> Result<(), String> {
            let autopilot = self.voyage.autopilot().expect("the voyage has one");
            (self.presses).allow(Some(frame), order, autopilot, self.voyage.now())
        }
    }

    // AP-26
    #[test]
    fn a_press_for_another_mode_or_set_value_is_refused_and_standby_never() {
        let mut page = Page::new();
        let turn = Order::AdjustHeading(10.0);
        let auto = Order::Mode(ModeRequest::Auto);
        let standby = Order::Mode(ModeRequest::Standby);
        assert_eq!(page.press(page.frame, &auto), Ok(()));
        let beside_standby = page.frame;
        page.order(auto.clone());
        // Refused at once, before any frame has shown the change.
        let refused = page.press(beside_standby, &turn).unwrap_err();
        assert!(refused.contains("AUTO now"), "{refused}");
        page.sail(1);
        assert_eq!(page.press(page.frame, &turn), Ok(()));
        let beside_heading = page.frame;
        page.order(Order::SetHeading(123.0));
        let refused = page.press(beside_heading, &turn).unwrap_err();
        assert!(refused.contains("123.0 now"), "{refused}");
        for frame in [0, beside_standby, beside_heading, page.frame + 9] {
            assert_eq!(page.press(frame, &standby), Ok(()));
            assert!(page.press(frame, &auto).is_err());
        }
    }

    // AP-26
    #[test]
    fn a_picture_that_is_long_gone_is_not_pressed_beside() {
        let mut page = Page::new();
        let auto = Order::Mode(ModeRequest::Auto);
        let frame = page.frame;
        page.sail(LONGEST);
        assert_eq!(page.press(frame, &auto), Ok(()));
        page.sail(1);
        assert!(page.press(frame, &auto).is_err());
    }
}
