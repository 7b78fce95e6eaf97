//! An order that asks something of the modes, brought to where it is done.

use super::part::Modes;
use super::set_value::SetValue;
use crate::autopilot::facts::Outlook;
use crate::autopilot::notices::Notices;
use crate::command::{Order, Refusal};
use alloc::string::String;

impl Modes {
    /// Does what an order asks of the modes, or says why not; absent where it asks for something else.
    pub(in super::super) fn carry_out(
        &mut self,
        outlook: &Outlook<'_>,
        order: &Order,
        notices: &mut Notices,
    ) -> Option<Result<String, Refusal>> {
        if let Err(refusal) = self.interrupt(outlook, order) {
            return Some(Err(refusal));
        }
        if let Some(set) = SetValue::of(order) {
            return Some(self.set(outlook, set));
        }
        Some(match order {
            Order::Mode(request) => self.request(outlook, *request, notices),
            Order::SetHeading(degrees) => self.request_heading(outlook, *degrees),
            Order::AdjustHeading(degrees) => self.request_change(outlook, *degrees),
            _ => return None,
        })
    }
}
