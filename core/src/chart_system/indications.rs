//! The indications before and after wheel-over (TCS-11, MSC.74(69) 5.1.5 and 5.1.6).

use super::control::Commanding;
use super::state::ChartSystem;
use crate::alerts::Alert;
use crate::route::Phase;
use crate::time::Stamp;
use alloc::format;

/// The early indication is never given later than this before wheel-over, seconds.
const EARLY_LEAST_S: f64 = 60.0;

impl ChartSystem {
    /// One second of the watch. Gives whether the contact of the back-up navigator is to be closed, where that changes
    /// (TCS-11, FA15).
    pub(super) fn watch_over(&mut self, now: Stamp) -> Option<bool> {
        self.indicate(now);
        let alerts = &mut self.watch.alerts;
        alerts.tick(now);
        alerts.call_backup(now, Alert::BackupNavigator)
    }

    /// What there is to indicate: one alert a situation, a later one takes the place of an earlier one.
    fn indicate(&mut self, now: Stamp) {
        let seconds = self.wheel_over_s(now);
        let phase = self.progress.map(|progress| progress.phase());
        let leg = self.progress.and_then(|progress| progress.leg());
        let controls = self.control != Commanding::Off
            && !matches!(self.control, Commanding::Heading { leg: Some(_) });
        let lost =
            self.here(now).is_none() && self.progress.is_none() && self.shown.display.is_some();
        let outside = controls && self.outside();
        let id =
            leg.and_then(|leg| Some(self.route.as_ref()?.waypoints().get(leg + 1)?.id.clone()));
        let id = id.unwrap_or_default();
        let last = matches!((phase, &self.route), (Some(Phase::Leg(leg)), Some(route))
            if route.turn_after(leg).is_none());
        let course = leg
            .and_then(|leg| Some(self.route.as_ref()?.turn_after(leg)?.course_out().deg()))
            .unwrap_or_default();
        let early_s = self.config.early_s.max(EARLY_LEAST_S);
        let soon_s = self.config.soon_s;

        let watch = &mut self.watch;
        watch.alerts.set(now, Alert::ChartPositionLost, lost, "");
        watch.alerts.set(now, Alert::CrossTrack, outside, "");
        if !controls || watch.leg != leg {
            watch.turn_over(now);
            watch.leg = leg;
        }
        let near = |limit: f64| seconds.is_some_and(|seconds| seconds <= limit);
        let ending = controls && last && near(early_s);
        watch.alerts.set(
            now,
            Alert::LastWaypoint,
            ending,
            &format!("Last waypoint {id} comes near: track control will end"),
        );
        if !controls || last {
            return;
        }
        match phase {
            Some(Phase::Leg(_)) if near(soon_s) => {
                watch.alerts.end(now, Alert::CourseChange);
                if !watch.confirmed {
                    let text = format!(
                        "Waypoint {id}: wheel over in {soon_s:.0} s, new course {course:.1}"
                    );
                    watch.alerts.raise(now, Alert::CourseChangeSoon, &text);
                }
            }
            Some(Phase::Leg(_)) => {
                if near(early_s) {
                    let text = format!("Waypoint {id}: course change to {course:.1} comes near");
                    watch.alerts.raise(now, Alert::CourseChange, &text);
                }
            }
            Some(Phase::Forwarding(_) | Phase::Arc(_)) => {
                watch.alerts.end(now, Alert::CourseChange);
                watch.alerts.end(now, Alert::CourseChangeSoon);
                if !watch.confirmed {
                    let text = format!("Waypoint {id}: the ship turns to {course:.1}");
                    watch.alerts.raise(now, Alert::WheelOver, &text);
                }
            }
            Some(Phase::Past) | None => {}
        }
    }

    /// Whether the ship is outside the corridor of the leg that she is on or turns to.
    fn outside(&self) -> bool {
        let (Some(route), Some(phase)) =
            (&self.route, self.progress.map(|progress| progress.phase()))
        else {
            return false;
        };
        let leg = match phase {
            Phase::Leg(leg) | Phase::Forwarding(leg) => leg,
            Phase::Arc(leg) => leg + 1,
            Phase::Past => return false,
        };
        self.shown
            .display
            .is_some_and(|off| route.leg(leg).outside(off))
    }
}
