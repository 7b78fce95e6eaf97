//! A table of a message laid out once: every field at its bit, what depends on others reached by one look.
//!
//! Made of the tables when the program is built, for messages whose fields stand at fixed places. The others, and
//! messages that end early, are walked by their tables (`walk`); both give the same.

use super::bits::Bits;
use super::entry::Entry;
use super::fault::MessageFault;
use super::field::{Field, Kind, degrees};
use super::tables::{HEADER, KINDS, LAYOUTS};
use super::value::{SixBitText, Value};
use super::walk::{self, auxiliary, turn};
use alloc::vec::Vec;

mod lay;
mod step;

use step::{Op, Plan};

static PLANS: [Option<Plan>; KINDS] = {
    let mut plans = [const { None }; KINDS];
    let mut kind = 0;
    while kind < KINDS {
        if let Some(layout) = LAYOUTS[kind] {
            let (plan, at) = Plan::EMPTY.with(HEADER, 0);
            let (plan, _) = plan.with(layout.items, at);
            if plan.fits {
                plans[kind] = Some(plan.closed());
            }
        }
        kind += 1;
    }
    plans
};

/// A coded value that does not mean itself.
#[inline(never)]
fn strange<'m>(field: &'static Field, raw: i32, faults: &mut Vec<MessageFault>) -> Value<'m> {
    let (Kind::Whole(scale) | Kind::Number(scale)) = &field.kind else {
        return Value::Null;
    };
    walk::strange(field, scale, raw, faults)
}

/// The plan of a message type, where it has one and the message goes so far.
#[inline(always)]
pub(super) fn plan(kind: u8, bits: &Bits) -> Option<&'static Plan> {
    let plan = PLANS.get(usize::from(kind))?.as_ref()?;
    (bits.len() >= plan.bits).then_some(plan)
}

impl Plan {
    /// Gives every field to `sink`, and what is wrong to `faults`.
    #[inline(always)]
    pub(super) fn walk<'m>(
        &'static self,
        bits: &'m Bits,
        sink: &mut impl FnMut(Entry<'m>),
        faults: &mut Vec<MessageFault>,
    ) {
        let mut next = 0;
        while let Some(step) = self.steps.get(next) {
            next = usize::from(step.next);
            let word = bits.word(usize::from(step.byte)) << (step.bit & 63);
            let raw = ((word >> (step.shift & 63)) as u32 ^ step.sign).wrapping_sub(step.sign);
            let raw = raw as i32;
            let holds = raw.wrapping_sub(step.low) as u32 <= step.span;
            // The value is written where it is given from, and not copied.
            let mut entry = Entry {
                group: None,
                entry: 0,
                value: Value::Null,
                field: step.field,
            };
            match step.op {
                Op::Whole if holds => {
                    entry.value = Value::Integer(i64::from(raw.wrapping_add(step.more)));
                }
                Op::Code if raw != step.more => entry.value = Value::Integer(i64::from(raw)),
                Op::Tenths if holds => entry.value = Value::Number(f64::from(raw) / 10.0),
                Op::Fine if holds => entry.value = Value::Number(degrees::<600_000>(raw)),
                Op::Coarse if holds => entry.value = Value::Number(degrees::<600>(raw)),
                Op::Whole | Op::Code | Op::Tenths | Op::Fine | Op::Coarse => {
                    entry.value = strange(step.field, raw, faults);
                }
                Op::Flag => entry.value = Value::Flag(raw != 0),
                Op::Text => {
                    let text = SixBitText::read(bits, step.at(), step.field.width / 6);
                    if let Some(text) = text {
                        entry.value = Value::Text(text);
                    }
                }
                Op::Rest => entry.value = step.field.read_rest(bits, step.at()),
                Op::Turn => entry.value = turn(i32::from(raw as i8)),
                Op::Switch => {
                    next = self.target(step, raw as usize);
                    continue;
                }
                Op::Craft => {
                    next = self.target(step, usize::from(auxiliary(bits.get(8, 30))));
                    continue;
                }
            }
            sink(entry);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_with_fixed_places_have_a_plan() {
        let planned = (0..KINDS).filter(|kind| PLANS[*kind].is_some());
        let planned: Vec<usize> = planned.collect();
        assert_eq!(
            planned,
            [1, 2, 3, 4, 5, 9, 10, 11, 12, 14, 18, 19, 21, 22, 23, 24, 27]
        );
    }
}
