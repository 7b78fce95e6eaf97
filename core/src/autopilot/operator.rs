//! What the operator asks for, and the answer (AP-6, HTC-4).

use super::modes::Event;
use super::{Autopilot, Mode, Timer};
use crate::alerts::Alert;
use crate::command::{ModeRequest, Order, Refusal};
use crate::station::Output;
use crate::time::Stamp;
use crate::units::{Heading, SignedAngle};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::ops::RangeInclusive;

impl Autopilot {
    /// Does what is asked, or says why not; the operator's STANDBY is always granted.
    pub(super) fn obey(&mut self, now: Stamp, order: &Order, out: &mut Vec<Output>) {
        let answer = self.carry_out(now, order);
        match (&answer, order) {
            (Err(refusal), _) => self.why = refusal.text.clone(),
            (Ok(_), Order::Setting { key, value }) => out.push(Output::Persist {
                key: key.clone(),
                value: value.clone(),
            }),
            (Ok(_), _) => {}
        }
        out.push(Output::Answer(answer));
    }

    fn carry_out(&mut self, now: Stamp, order: &Order) -> Result<String, Refusal> {
        match order {
            Order::Mode(ModeRequest::Standby) => {
                self.alerts.machine.rectify(now, Alert::HeadingLost);
                self.alerts.machine.rectify(now, Alert::Override);
                self.apply(now, &Event::Standby, "operator selected STANDBY");
                Ok("STANDBY".into())
            }
            Order::Mode(ModeRequest::Auto) => self.select_auto(now),
            Order::Mode(ModeRequest::Autonav) => self.request_autonav(now),
            Order::Mode(ModeRequest::Cancel) => {
                self.mode.select(None);
                Ok("AutoNAV selection withdrawn".into())
            }
            Order::Mode(ModeRequest::Track) => self
                .may_select(now, ModeRequest::Track)
                .map(|()| "TRACK".into()),
            Order::SetHeading(degrees) => within("set heading", *degrees, 0.0..=360.0)
                .and_then(|degrees| self.set_heading(now, Heading::from_deg(degrees))),
            Order::AdjustHeading(degrees) => match &self.mode {
                Mode::Auto(auto) => {
                    let set = auto.set;
                    within("change of the set heading", *degrees, -180.0..=180.0).and_then(
                        |degrees| self.set_heading(now, set + SignedAngle::from_deg(degrees)),
                    )
                }
                _ => Err(Refusal::because("the heading is set in AUTO only")),
            },
            Order::Acknowledge(number) if self.alerts.acknowledge(now, *number) => {
                Ok(format!("alert {number} acknowledged"))
            }
            Order::Acknowledge(number) => Err(Refusal::because(format!(
                "alert {number} waits for no acknowledgement"
            ))),
            Order::Silence(silent) => {
                self.alerts.silence(now, *silent);
                let answer = if *silent {
                    "silenced for 30 s"
                } else {
                    "alerts sound again"
                };
                Ok(answer.into())
            }
            Order::Setting { key, value } => {
                self.settings.set(key, value).map_err(Refusal::because)?;
                self.steering.change(&self.settings);
                Ok(format!("{key} is {value}"))
            }
            _ => Err(Refusal::because("not a command to the autopilot")),
        }
    }

    fn select_auto(&mut self, now: Stamp) -> Result<String, Refusal> {
        self.may_select(now, ModeRequest::Auto)?;
        self.alerts.machine.rectify(now, Alert::HeadingLost);
        self.alerts.machine.rectify(now, Alert::TrackFail);
        self.alerts.machine.rectify(now, Alert::Override);
        self.apply(now, &Event::Auto, "operator selected AUTO");
        let heading = self.hts().map_or(0.0, Heading::deg);
        Ok(format!("AUTO on {heading:05.1}"))
    }

    fn set_heading(&mut self, now: Stamp, set: Heading) -> Result<String, Refusal> {
        if !matches!(self.mode, Mode::Auto(_)) {
            return Err(Refusal::because("the heading is set in AUTO only"));
        }
        self.timers.stop(Timer::OffHeading);
        self.apply(now, &Event::SetHeading(set), "operator set the heading");
        Ok(format!("set heading {:05.1}", set.deg()))
    }
}

/// A number within its range, in degrees.
fn within(what: &str, value: f64, range: RangeInclusive<f64>) -> Result<f64, Refusal> {
    if range.contains(&value) {
        return Ok(value);
    }
    let (low, high) = (range.start(), range.end());
    Err(Refusal::because(format!(
        "{what} is {value}, allowed are {low} to {high} deg"
    )))
}
