//! What the chart system sees each second: the part of the route, cross-track distances, situation.

use super::control::{Commanding, CrossTracks};
use super::place::Here;
use super::state::ChartSystem;
use crate::route::{Phase, Progress};
use crate::time::Stamp;
use crate::units::Distance;

/// The forwarding distance follows the speed until so long before the wheel-over line, seconds.
const FORWARDING_FIXED_S: f64 = 60.0;

impl ChartSystem {
    /// Moves along the route with the position; ends control that is no longer possible.
    pub(super) fn monitor(&mut self, now: Stamp) {
        if self.guard.take_jump() && self.control != Commanding::Off {
            self.end_control("the position has jumped");
        }
        self.reckon(now);
        let here = self.here(now);
        match self.control {
            Commanding::Track { .. } | Commanding::Heading { leg: None } if here.is_none() => {
                self.end_control("no position"); // TCS-3
            }
            Commanding::Heading { .. } if self.heading_at(now).is_none() => {
                self.end_control("no heading");
            }
            _ => {}
        }
        let Some(here) = here else {
            // The ship is looked for anew when the position is back; the last distances stay, marked V (TCS-3).
            self.progress = None;
            return;
        };
        let Some(route) = self.route.take() else {
            self.shown = CrossTracks::default();
            return;
        };
        let before = self.progress;
        let mut progress =
            before.unwrap_or_else(|| Progress::locate(&route, here.position, self.forwarding));
        self.adapt_forwarding(now, &route, progress, here);
        progress.advance(&route, here.position, self.forwarding);
        self.progress = Some(progress);
        self.shown = cross_tracks(&route, progress, here);
        self.route = Some(route);
        self.follow(before.map(|progress| progress.phase()), progress.phase());
        self.learn_current(now);
    }

    /// What passing a line means for control.
    fn follow(&mut self, before: Option<Phase>, now: Phase) {
        if let (Some(Phase::Arc(_) | Phase::Forwarding(_)), Phase::Leg(_)) = (before, now)
            && let Commanding::Track { turned } = &mut self.control
        {
            *turned = true;
        }
        if now == Phase::Past && before.is_some_and(|before| before != now) {
            let virtual_leg = matches!(self.control, Commanding::Heading { leg: Some(_) });
            if self.control != Commanding::Off && !virtual_leg {
                self.end_control("end of route"); // situation 6
            } else {
                self.why = "the last waypoint is passed".into();
            }
        }
    }

    /// F = U t_F, as long as the wheel-over line is more than a minute ahead.
    fn adapt_forwarding(
        &mut self,
        now: Stamp,
        route: &crate::route::Route,
        progress: Progress,
        here: Here,
    ) {
        let (Phase::Leg(leg), Some(ground)) = (progress.phase(), self.ground_at(now)) else {
            return;
        };
        let room = route.room_for_forwarding(leg);
        let wanted = self
            .forwarding_at(ground.speed, route)
            .m()
            .min(room.m())
            .max(0.0);
        let ahead = progress.to_wheel_over(route, here.position, Distance::from_m(wanted));
        let far = ahead.is_some_and(|d| d.m() > FORWARDING_FIXED_S * ground.speed.mps());
        if far && libm::fabs(wanted - self.forwarding.m()) > 0.05 * wanted.max(20.0) {
            self.forwarding = Distance::from_m(wanted);
            self.revision += 1;
        }
    }

    fn learn_current(&mut self, now: Stamp) {
        let steady = self
            .progress
            .is_none_or(|progress| !progress.phase().turning());
        if let (true, Some(ground), Some(heading), Some(water)) = (
            steady && self.reckoning.is_none(),
            self.ground_at(now),
            self.heading_at(now),
            self.water_at(now),
        ) {
            self.current.learn(ground, heading, water);
        }
    }

    /// Situation 1 to 6 of the dialogue; 0 in heading control, which has none (CON-1).
    #[must_use]
    pub fn situation(&self) -> u8 {
        let phase = self.progress.map(|progress| progress.phase());
        match (self.control, phase) {
            (Commanding::Heading { .. }, _) => 0,
            (Commanding::Off, Some(Phase::Past)) => 6,
            (Commanding::Off, _) | (_, None | Some(Phase::Past)) => 1,
            (Commanding::Track { turned: false }, Some(Phase::Leg(_))) => 2,
            (Commanding::Track { turned: true }, Some(Phase::Leg(_))) => 5,
            (Commanding::Track { .. }, Some(Phase::Forwarding(_))) => 3,
            (Commanding::Track { .. }, Some(Phase::Arc(_))) => 4,
        }
    }

    /// Seconds to the wheel-over line, or to the last waypoint on the last leg.
    #[must_use]
    pub fn wheel_over_s(&self, now: Stamp) -> Option<f64> {
        let (route, progress) = (self.route.as_ref()?, self.progress?);
        let here = self.here(now)?;
        let distance = progress.to_wheel_over(route, here.position, self.forwarding)?;
        let speed = self.ground_at(now)?.speed.mps();
        (speed > 0.2).then(|| distance.m() / speed)
    }
}

fn cross_tracks(route: &crate::route::Route, progress: Progress, here: Here) -> CrossTracks {
    match progress.phase() {
        Phase::Leg(leg) | Phase::Forwarding(leg) => {
            let off = Some(route.leg(leg).cross_track(here.position));
            CrossTracks {
                display: off,
                control: off,
            }
        }
        Phase::Arc(leg) => CrossTracks {
            display: route
                .turn_after(leg)
                .map(|turn| turn.cross_track(here.position)),
            control: Some(route.leg(leg + 1).cross_track(here.position)),
        },
        Phase::Past => CrossTracks::default(), // TCS-2
    }
}
