//! Who is asked to steer: off, track control ("Ti") or remote heading control ("Tn"), and what each needs.

use super::control::{Commanding, Followed};
use super::state::ChartSystem;
use crate::alerts::Alert;
use crate::command::{ChartRequest, Order, Refusal};
use crate::nmea::SteeringMode;
use crate::route::{Phase, Progress};
use crate::time::Stamp;
use crate::units::{Course, SignedAngle};
use alloc::format;
use alloc::string::String;

/// Nearer than this to the wheel-over line, track control does not begin, seconds.
const TOO_CLOSE_S: f64 = 15.0;

fn refuse<T>(reason: impl Into<String>) -> Result<T, Refusal> {
    Err(Refusal::because(reason.into()))
}

impl ChartSystem {
    /// Does what is asked, or says in an officer's words why not.
    pub(super) fn obey(&mut self, now: Stamp, order: &Order) -> Result<String, Refusal> {
        self.now = self.now.max(now);
        match order {
            Order::Chart(request) => self.control(now, *request),
            Order::LoadRoute(number) => self.load_offer(*number),
            Order::Acknowledge(number) if self.watch.acknowledge(now, *number) => {
                Ok(format!("alert {number} acknowledged"))
            }
            Order::Acknowledge(number) if self.acknowledge_there(*number) => Ok(format!(
                "alert {number}: acknowledgement sent to the autopilot"
            )),
            Order::Acknowledge(number) => {
                refuse(format!("alert {number} waits for no acknowledgement"))
            }
            Order::Silence(on) => {
                self.watch.silence(now, *on);
                Ok(if *on {
                    "silenced for 30 s"
                } else {
                    "alerts sound again"
                }
                .into())
            }
            _ => refuse("not a command to the chart system"),
        }
    }

    /// Begins, changes or ends control.
    fn control(&mut self, now: Stamp, request: ChartRequest) -> Result<String, Refusal> {
        let answer = match request {
            ChartRequest::Track => self.begin_track(now),
            ChartRequest::Heading => self.begin_heading(now),
            ChartRequest::Stop => Ok(self.stop()),
        };
        if let Err(refusal) = &answer {
            self.why = format!("refused: {refusal}");
        }
        answer
    }

    fn begin_track(&mut self, now: Stamp) -> Result<String, Refusal> {
        if matches!(self.control, Commanding::Track { .. }) {
            return Ok("track control is commanded already".into());
        }
        if self.route.is_none() {
            return refuse("no route");
        }
        let place = self.place_on_route(now)?;
        match place.phase() {
            Phase::Past => return refuse("the last waypoint is passed"),
            Phase::Forwarding(_) | Phase::Arc(_) => {
                return refuse("not in the middle of a turn"); // AP-6
            }
            Phase::Leg(_) => {}
        }
        if self.heading_at(now).is_none() {
            return refuse("no heading");
        }
        if self.ground_at(now).is_none() {
            return refuse("no course and speed over ground");
        }
        self.progress = Some(place);
        self.safe_approach(now)?;
        self.begin(now, Commanding::Track { turned: false });
        self.why = String::from("track control commanded");
        Ok("track control commanded, waiting for the autopilot".into())
    }

    fn begin_heading(&mut self, now: Stamp) -> Result<String, Refusal> {
        if matches!(self.control, Commanding::Heading { .. }) {
            return Ok("heading control is commanded already".into());
        }
        let Some(heading) = self.heading_at(now) else {
            return refuse("no heading");
        };
        let sailing = self.route.is_some()
            && !matches!(
                self.progress.map(|progress| progress.phase()),
                Some(Phase::Past)
            );
        let leg = if !sailing {
            // TCS-12: a virtual leg on the present heading.
            Some(Course::from_deg(libm::round(heading.deg() * 10.0) / 10.0))
        } else if matches!(self.control, Commanding::Track { .. }) {
            None // TCS-6: at any time, without leaving AutoNAV
        } else {
            let place = self.place_on_route(now)?;
            if place.phase().turning() {
                return refuse("not in the middle of a turn");
            }
            if self.ground_at(now).is_none() {
                return refuse("no course and speed over ground");
            }
            self.progress = Some(place);
            self.safe_approach(now)?;
            None
        };
        self.begin(now, Commanding::Heading { leg });
        self.why = String::from("heading control commanded");
        Ok("heading control commanded, waiting for the autopilot".into())
    }

    /// Control begins, or changes its kind, which does not end what the autopilot follows.
    fn begin(&mut self, now: Stamp, control: Commanding) {
        if self.control == Commanding::Off {
            self.followed = Followed::begin(now);
        }
        self.control = control;
        self.watch.rectify(now, Alert::AutopilotLeft);
    }

    fn stop(&mut self) -> String {
        if self.control == Commanding::Off {
            return "control was off".into();
        }
        self.end_control("stopped by the officer");
        "control stopped".into()
    }

    /// Where on the route control would begin.
    fn place_on_route(&self, now: Stamp) -> Result<Progress, Refusal> {
        let Some(here) = self.here(now) else {
            return refuse("no position");
        };
        match (&self.route, self.control, self.progress) {
            (None, ..) => refuse("no route"),
            // A ship under control is where its control has brought it.
            (Some(_), Commanding::Heading { leg: None }, Some(progress)) => Ok(progress),
            (Some(route), ..) => Ok(Progress::locate(route, here.position, self.forwarding)),
        }
    }

    /// MSC.74(69) 5.1.2: begins only where a safe approach is possible.
    fn safe_approach(&self, now: Stamp) -> Result<(), Refusal> {
        let (Some(route), Some(progress), Some(here)) =
            (&self.route, self.progress, self.here(now))
        else {
            return refuse("no position");
        };
        let leg = route.leg(progress.leg().unwrap_or(0));
        let off = leg.cross_track(here.position);
        if off.abs() > self.config.begin_cross_track {
            return refuse(format!("too far from the track: {:.2} nm", off.abs().nm()));
        }
        if let Some(heading) = self.heading_at(now) {
            let angle: SignedAngle = heading.as_course() - leg.course();
            if angle.abs().deg() > self.config.begin_angle_deg {
                return refuse(format!(
                    "the heading is {:.0} degrees off the track",
                    angle.abs().deg()
                ));
            }
        }
        if self
            .wheel_over_s(now)
            .is_some_and(|seconds| seconds < TOO_CLOSE_S)
        {
            return refuse("too close to the wheel-over line");
        }
        Ok(())
    }

    /// Why things are as they are: who follows, or the last refusal or end.
    #[must_use]
    pub fn reason(&self) -> String {
        let wanted = match self.control {
            Commanding::Off => return self.why.clone(),
            Commanding::Track { .. } => (SteeringMode::TrackControl, "track control"),
            Commanding::Heading { .. } => (SteeringMode::HeadingControl, "heading control"),
        };
        match self.steering_at(self.now) {
            Some(Some(mode)) if mode == wanted.0 => {
                format!("the autopilot follows in {}", wanted.1)
            }
            Some(Some(mode)) => format!(
                "{} commanded; the autopilot is in {}",
                wanted.1,
                match mode {
                    SteeringMode::Manual => "stand-by",
                    SteeringMode::StandAlone => "AUTO",
                    SteeringMode::HeadingControl => "heading control",
                    SteeringMode::TrackControl => "track control",
                    SteeringMode::RudderControl => "rudder control",
                }
            ),
            Some(None) => format!("{} commanded; the autopilot is being set up", wanted.1),
            None => format!("{} commanded; the autopilot is not heard", wanted.1),
        }
    }
}
