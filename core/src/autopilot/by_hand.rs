//! What the autopilot does with a sentence of the hand unit: an order of its rank, settings, a calibration (EMC-2, EMC-7, HTC-4).

use super::Autopilot;
use super::hand_unit::Due;
use super::hand_unit::answer::Answer;
use super::hand_unit::asked::{Asked, TACK_DEG, asked};
use super::hand_unit::calibration::Calibration;
use super::hand_unit::kept::{Changes, Kept, defaults};
use super::modes::Mode;
use crate::command::{ModeRequest, Order, Origin, Refusal, Side};
use crate::nmea::Sentence;
use crate::station::PortIndex;
use crate::time::Stamp;
use alloc::format;

const BY: Origin = Origin::HandUnit;

impl Autopilot {
    /// Does what a sentence asks for, whole or not at all.
    pub(super) fn hear_hand_unit(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        let done = asked(sentence).and_then(|asked| self.do_by_hand(now, port, asked));
        if let Err(refusal) = done {
            self.refuse_the_hand_unit(sentence, &format!("{refusal}"));
            // The unit shows what is still in force.
            let answer = match sentence.formatter {
                "PEMC,04" => Answer::Installation,
                "PEMC,06" => Answer::Gains,
                _ => return,
            };
            self.hand_unit.owe(Due::Say(port, answer));
        }
    }

    /// A sentence is not followed; counted, and told to the officer.
    pub(super) fn refuse_the_hand_unit(&mut self, sentence: &Sentence<'_>, why: &str) {
        let text = self.hand_unit.refuse(sentence.formatter, why);
        self.modes.refuse(&text);
    }

    fn do_by_hand(&mut self, now: Stamp, port: PortIndex, asked: Asked) -> Result<(), Refusal> {
        match asked {
            Asked::Toggle => {
                let standby = self.modes.gives_orders();
                let request = if standby {
                    ModeRequest::Standby
                } else {
                    ModeRequest::Auto
                };
                self.carry_out(now, BY, &Order::Mode(request))?;
            }
            Asked::Rudder(by) => {
                // As an order of the rudder, for who goes before it.
                self.modes.yields(now, BY, &Order::SetRudder(by))?;
                self.decide(now, |modes, outlook, _| modes.jog(outlook, by))?;
            }
            Asked::Course(by) => self.change_course(now, by)?,
            Asked::Tack(side) => self.tack(now, side)?,
            Asked::Set(changes, answer) => {
                self.set_by_hand(&changes)?;
                self.hand_unit.owe(Due::Say(port, answer));
            }
            Asked::Tell(answer) => self.hand_unit.owe(Due::Say(port, answer)),
            Asked::CalibrateImu(gyro, accelerometer) => {
                self.calibrate(Calibration::of_imu(gyro, accelerometer))?;
            }
            Asked::CalibrateFeedback => self.calibrate(Calibration::Feedback(None))?,
            Asked::Keep(kept) => self.hand_unit.owe(Due::Keep(kept)),
            Asked::Restore => {
                self.set_by_hand(&defaults())?;
                self.hand_unit.owe(Due::Keep(Kept::Installation));
                self.hand_unit.owe(Due::Keep(Kept::Gains));
            }
            Asked::Nothing => {}
        }
        Ok(())
    }

    /// In TRACK the course is changed by DODGE, which is released where nothing is left of the change (EMC-7).
    fn change_course(&mut self, now: Stamp, by: f64) -> Result<(), Refusal> {
        let order = match self.modes.mode() {
            Mode::Track(_) => {
                self.carry_out(now, BY, &Order::Mode(ModeRequest::Dodge))?;
                Order::SetDodge(by)
            }
            Mode::Dodge(dodge) => {
                let offset = dodge.offset.deg() + by;
                match libm::fabs(offset) < 0.5 {
                    true => Order::Mode(ModeRequest::Cancel),
                    false => Order::SetDodge(offset),
                }
            }
            _ => Order::AdjustHeading(by),
        };
        self.carry_out(now, BY, &order).map(|_| ())
    }

    fn tack(&mut self, now: Stamp, side: Side) -> Result<(), Refusal> {
        let order = match (self.modes.mode(), side) {
            (Mode::WindVane(_), side) => Order::Tack(side),
            (_, Side::Port) => Order::AdjustHeading(-TACK_DEG),
            (_, Side::Starboard) => Order::AdjustHeading(TACK_DEG),
        };
        self.carry_out(now, BY, &order).map(|_| ())
    }

    /// Other settings are in force, and not kept until the unit saves them.
    fn set_by_hand(&mut self, changes: &Changes) -> Result<(), Refusal> {
        self.change(changes.iter().map(|(key, value)| (*key, value)))?;
        self.hand_unit.owe(Due::Changed);
        Ok(())
    }

    /// Begins a calibration, or ends the one that is on and takes what it found.
    fn calibrate(&mut self, wanted: Calibration) -> Result<(), Refusal> {
        let text = match self.hand_unit.calibration.take() {
            Some(on) if core::mem::discriminant(&on) == core::mem::discriminant(&wanted) => {
                let found = on.found(&self.settings)?;
                self.set_by_hand(&found)?;
                let all = found
                    .iter()
                    .map(|(key, value)| format!(", {key} is {value:.1}"));
                format!(
                    "{} ended{}",
                    on.name(),
                    all.collect::<alloc::string::String>()
                )
            }
            Some(on) => {
                self.hand_unit.calibration = Some(on);
                return Err(Refusal::because(format!("the {} is on", on.name())));
            }
            None if self.modes.gives_orders() => {
                return Err(Refusal::because("it is calibrated in STANDBY only"));
            }
            None => {
                self.hand_unit.calibration = Some(wanted);
                format!("{}: send it again to end it", wanted.name())
            }
        };
        self.modes.refuse(&text);
        Ok(())
    }
}
