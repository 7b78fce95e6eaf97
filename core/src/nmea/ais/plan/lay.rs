//! How a table becomes a plan; all of it when the program is built.

use super::step::{END, FIRST, Op, Plan, STEPS, Step};
use crate::nmea::ais::field::{Field, Item, Kind, NEVER, Place, Scale};

/// No place that is known.
const UNKNOWN: usize = usize::MAX;

impl Step {
    const fn scaled(mut self, scale: &Scale, width: usize) -> Self {
        if scale.signed {
            self.sign = 1 << (width - 1);
        }
        self.low = scale.low;
        self.span = scale.span;
        self.more = scale.plus;
        self
    }
}

/// Whether two items depend on the same field.
const fn same_choice(one: &Item, other: &Item) -> bool {
    match (one, other) {
        (Item::When(one, _), Item::When(other, _)) => {
            one.width == other.width
                && match (one.place, other.place) {
                    (Place::List(one), Place::List(other))
                    | (Place::Bit(one), Place::Bit(other)) => one == other,
                    _ => false,
                }
        }
        (Item::Auxiliary(..), Item::Auxiliary(..)) => true,
        _ => false,
    }
}

impl Plan {
    const fn unfit(mut self) -> (Self, usize) {
        self.fits = false;
        (self, UNKNOWN)
    }

    const fn push(mut self, mut step: Step) -> Self {
        if self.count + 1 < STEPS {
            step.next = self.count as u8 + 1;
            self.steps[self.count] = step;
            self.count += 1;
        } else {
            self.fits = false;
        }
        self
    }

    /// The items from a place on, and where they end.
    pub(super) const fn with(mut self, items: &'static [Item], begin: usize) -> (Self, usize) {
        let mut at = begin;
        let mut n = 0;
        while n < items.len() {
            match &items[n] {
                Item::Field(field) => {
                    if at == UNKNOWN {
                        return self.unfit();
                    }
                    (self, at) = self.field(field, at);
                }
                Item::Part(items) => {
                    if at == UNKNOWN {
                        return self.unfit();
                    }
                    (self, at) = self.with(items, at);
                }
                Item::When(..) | Item::Auxiliary(..) => {
                    let mut end = n + 1;
                    while end < items.len() && same_choice(&items[n], &items[end]) {
                        end += 1;
                    }
                    (self, at) = self.choice(items, n, end, begin, at);
                    n = end;
                    continue;
                }
                Item::Longer(..) | Item::Each(..) => return self.unfit(),
            }
            n += 1;
        }
        (self, at)
    }

    const fn field(mut self, field: &'static Field, at: usize) -> (Self, usize) {
        let width = field.width;
        let mut step = FIRST.placed(at);
        step.field = field;
        step.shift = if width < 64 {
            (64 - width) as u8 & 63
        } else {
            0
        };
        step.op = match &field.kind {
            Kind::Spare if width > 0 => {
                if self.bits < at + width {
                    self.bits = at + width;
                }
                return (self, at + width);
            }
            Kind::Text if width == 0 => {
                self = self.push(Step {
                    op: Op::Rest,
                    ..step
                });
                return (self, UNKNOWN);
            }
            _ if width == 0 => return self.unfit(),
            Kind::Spare | Kind::Binary(_) => return self.unfit(),
            Kind::Whole(scale) => {
                step = step.scaled(scale, width);
                Op::Whole
            }
            Kind::Number(scale) => {
                step = step.scaled(scale, width);
                match scale.divisor {
                    10 => Op::Tenths,
                    600_000 => Op::Fine,
                    600 => Op::Coarse,
                    _ => return self.unfit(),
                }
            }
            Kind::Code(none, _) => {
                step.span = u32::MAX;
                step.more = 0;
                match *none {
                    NEVER => Op::Whole,
                    0 => {
                        step.low = 1;
                        step.span = i32::MAX as u32;
                        Op::Whole
                    }
                    none => {
                        step.more = none;
                        Op::Code
                    }
                }
            }
            Kind::Flag => Op::Flag,
            Kind::Text => Op::Text,
            Kind::Turn => Op::Turn,
        };
        self = self.push(step);
        if self.bits < at + width {
            self.bits = at + width;
        }
        (self, at + width)
    }

    const fn redirected(mut self, switch: usize, from: usize, to: u8) -> Self {
        let mut value = 0;
        while value < 8 {
            if self.targets[switch][value] as usize == from {
                self.targets[switch][value] = to;
            }
            value += 1;
        }
        self
    }

    /// What leads behind the last step ends.
    pub(super) const fn closed(mut self) -> Self {
        let mut n = 0;
        while n < self.count {
            if self.steps[n].next as usize == self.count {
                self.steps[n].next = END;
            }
            n += 1;
        }
        let mut switch = 0;
        while switch < self.switches {
            self = self.redirected(switch, self.count, END);
            switch += 1;
        }
        self
    }

    /// Items of which one is there, from `from` to before `to` of a list that begins at `begin`.
    const fn choice(
        mut self,
        items: &'static [Item],
        from: usize,
        to: usize,
        begin: usize,
        at: usize,
    ) -> (Self, usize) {
        if at == UNKNOWN || self.switches == self.targets.len() {
            return self.unfit();
        }
        let mut step = FIRST;
        let width = match &items[from] {
            Item::When(when, _) => {
                let place = match when.place {
                    Place::List(bits) => begin + bits,
                    Place::Bit(at) => at,
                };
                step.op = Op::Switch;
                step = step.placed(place);
                step.shift = (64 - when.width) as u8 & 63;
                when.width
            }
            _ => {
                step.op = Op::Craft;
                1
            }
        };
        if width > 3 {
            return self.unfit();
        }
        let switch = self.switches;
        self.switches += 1;
        step.low = switch as i32;
        self = self.push(step);
        let first = self.count;
        // Where each way ends, and whether every value has one.
        let mut ends = [0; 8];
        let mut values = 0u32;
        let (mut behind, mut level) = (UNKNOWN, true);
        let mut n = from;
        while n < to && n - from < ends.len() {
            let (of, list) = match &items[n] {
                Item::When(when, list) => (when.values, *list),
                Item::Auxiliary(are, list) => (1 << *are as u32, *list),
                _ => return self.unfit(),
            };
            let mut value = 0;
            while value < 8 {
                if of >> value & 1 == 1 {
                    self.targets[switch][value] = self.count as u8;
                }
                value += 1;
            }
            level &= values & of == 0;
            values |= of;
            let end;
            (self, end) = self.with(list, at);
            level &= end != UNKNOWN && (n == from || end == behind);
            behind = end;
            ends[n - from] = self.count;
            n += 1;
        }
        // Every way goes on behind the last one; so does a value that has none.
        let last = self.count as u8;
        let mut value = 0;
        while value < 8 {
            if values >> value & 1 == 0 {
                self.targets[switch][value] = last;
            }
            value += 1;
        }
        let mut way = 0;
        while way < to - from {
            let end = ends[way];
            let mut n = first;
            while n < end {
                if self.steps[n].next as usize == end {
                    self.steps[n].next = last;
                }
                n += 1;
            }
            let mut inner = switch + 1;
            while inner < self.switches {
                self = self.redirected(inner, end, last);
                inner += 1;
            }
            way += 1;
        }
        let all = (1u32 << (1u32 << width)).wrapping_sub(1);
        if level && values & all == all {
            (self, behind)
        } else {
            (self, UNKNOWN)
        }
    }
}
