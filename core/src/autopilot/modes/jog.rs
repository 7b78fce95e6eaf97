//! A hand unit moves the tiller from STANDBY: the order is given for as long as that takes, then STANDBY again (EMC-7).
//!
//! STANDBY itself gives no orders (AP-1). So the rudder is ordered in FFU OVERRIDE, which says so in HTD and ROR, until the gear
//! has had the time to follow.

use super::event::Event;
use super::mode::Mode;
use super::part::Modes;
use crate::autopilot::facts::Outlook;
use crate::command::Refusal;
use crate::units::RudderAngle;
use alloc::format;
use alloc::string::String;

/// The order stands so much longer than the gear needs at its slew.
const SETTLES_MS: u64 = 3_000;

impl Modes {
    /// The rudder by so many degrees, starboard positive: from STANDBY, or of the order in FFU OVERRIDE.
    pub(in super::super) fn jog(
        &mut self,
        outlook: &Outlook<'_>,
        degrees: f64,
    ) -> Result<String, Refusal> {
        let (facts, settings) = (&outlook.facts, outlook.facts.settings);
        let from = match &self.mode {
            Mode::Standby(_) => self.present_rudder(outlook),
            Mode::FfuOverride(ffu) => ffu.rudder,
            _ => {
                let text = "the rudder is moved by the hand unit in STANDBY and FFU OVERRIDE only";
                return Err(Refusal::because(text));
            }
        };
        let most = settings.rudder_max;
        let rudder = RudderAngle::from_deg((from.deg() + degrees).clamp(-most, most));
        let left = libm::fabs(rudder.deg() - facts.order.deg()) + libm::fabs(degrees);
        let until = facts.now + (left / settings.rudder_slew * 1000.0) as u64 + SETTLES_MS;
        let event = match &self.mode {
            Mode::FfuOverride(ffu) if ffu.until.is_none() => Event::FfuOverride(rudder),
            _ => Event::Jog { rudder, until },
        };
        let why = format!("the hand unit moves the rudder to {:.0} deg", rudder.deg());
        self.apply(facts, &event, &why);
        Ok(why)
    }

    /// Once a step: STANDBY again, where the gear has had its time.
    pub(super) fn end_the_jog(&mut self, outlook: &Outlook<'_>) {
        let over = match &self.mode {
            Mode::FfuOverride(ffu) => ffu.until.is_some_and(|until| outlook.facts.now >= until),
            _ => false,
        };
        if over {
            let why = "the hand unit has moved the rudder: STANDBY";
            self.apply(&outlook.facts, &Event::Standby, why);
        }
    }
}
