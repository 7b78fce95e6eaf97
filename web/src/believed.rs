//! What the autopilot does not believe is not shown as the ship's: its own belief stands there, with the reason (AP-9, FA8, FA9).

use crate::reading::Reading;
use wheelover_core::facts::Quantity;
use wheelover_core::geo::Position;
use wheelover_core::limits::Freshness;
use wheelover_core::picture::{Heard, Picture};
use wheelover_core::time::Stamp;
use wheelover_core::units::wrap_180;
use wheelover_core::view::{Own, RefusedView};

/// A heading that was not judged yet is shown within so much of the believed one: degrees, and degrees a second.
const TURNS: (f64, f64) = (5.0, 1.5);
/// A position, likewise: metres, and metres a second.
const RUNS: (f64, f64) = (30.0, 15.0);

/// What is believed of a quantity.
struct Belief<'a, T> {
    own: &'a Own,
    quantity: Quantity,
    value: Option<T>,
}

/// The heading of the compass in use, degrees.
#[must_use]
pub fn heading(picture: &Picture, own: &Own, now: Stamp) -> Reading<f64> {
    let belief = Belief {
        own,
        quantity: Quantity::Heading,
        value: own.heading,
    };
    belief.read(
        picture,
        &picture.headings,
        picture.heading(now),
        now,
        |compass| {
            let as_read = !own.magnetic && !compass.is_magnetic();
            as_read.then(|| compass.reading().deg())
        },
        |heard, own, seconds| libm::fabs(wrap_180(heard - own)) > TURNS.0 + TURNS.1 * seconds,
    )
}

/// The position of the receiver in use.
#[must_use]
pub fn position(picture: &Picture, own: &Own, now: Stamp) -> Reading<Position> {
    let belief = Belief {
        own,
        quantity: Quantity::Position,
        value: own.position,
    };
    belief.read(
        picture,
        &picture.fixes,
        picture.fix(now),
        now,
        |fix| Some(fix.position),
        |heard, own, seconds| own.distance(*heard) > RUNS.0 + RUNS.1 * seconds,
    )
}

/// Marks a distance of the chart system's that the autopilot does not follow.
#[must_use]
pub fn distance(mut reading: Reading<f64>, own: Option<&Own>) -> Reading<f64> {
    let refused = own
        .map(|own| words(own, Quantity::Control))
        .unwrap_or_default();
    if reading.value.is_some() && !refused.is_empty() {
        reading.state = Freshness::Low;
        reading.why = refused;
    }
    reading
}

impl<T: Copy> Belief<'_, T> {
    /// What was heard of the source in use, where it is believed; else the belief, or nothing, and why.
    fn read<H>(
        self,
        picture: &Picture,
        list: &[Heard<H>],
        best: Option<&Heard<H>>,
        now: Stamp,
        value: impl Fn(&H) -> Option<T> + Copy,
        apart: impl Fn(&T, &T, f64) -> bool,
    ) -> Reading<T> {
        let used = self
            .own
            .sources
            .iter()
            .find(|(name, _)| name == self.quantity.name());
        let used = used.and_then(|(_, source)| {
            list.iter()
                .find(|heard| picture.source_name(&heard.source) == *source)
        });
        let used = used.or(best);
        let heard = Reading::heard(picture, used, self.quantity, now, value);
        let refused = |of: &RefusedView| of.source == heard.source;
        let words = words(self.own, self.quantity);
        let why = if of(self.own, self.quantity).any(refused) {
            words
        } else if used.is_some_and(|heard| self.early(heard, value, apart)) {
            "not judged yet".to_owned()
        } else {
            // Another one may be refused: a mark, and the value stands.
            // A magnetic heading is made true, or not, by the autopilot.
            return Reading {
                why: words,
                value: heard
                    .value
                    .or(self.value.filter(|_| heard.state != Freshness::Lost)),
                ..heard
            };
        };
        Reading {
            value: self.value,
            state: if self.value.is_some() {
                Freshness::Low
            } else {
                Freshness::Lost
            },
            why,
            ..heard
        }
    }

    /// The autopilot has not judged it yet, and it is elsewhere.
    fn early<H>(
        &self,
        heard: &Heard<H>,
        value: impl Fn(&H) -> Option<T>,
        apart: impl Fn(&T, &T, f64) -> bool,
    ) -> bool {
        let judged = Stamp(self.own.judged);
        let seconds = heard.at.since(judged) as f64 / 1_000.0;
        self.value
            .zip(value(&heard.value))
            .is_some_and(|(own, said)| heard.at >= judged && apart(&said, &own, seconds))
    }
}

fn of(own: &Own, quantity: Quantity) -> impl Iterator<Item = &RefusedView> {
    own.refused
        .iter()
        .filter(move |refused| refused.quantity == quantity)
}

/// Who is not believed of a quantity, and why: `GYRO1 jumped`, `GPS, ECDIS jumped`.
fn words(own: &Own, quantity: Quantity) -> String {
    let mut words = String::new();
    let mut refused = of(own, quantity).peekable();
    while let Some(one) = refused.next() {
        let port = one.source.split('/').next().unwrap_or_default();
        words += &port.to_ascii_uppercase();
        match refused.peek() {
            Some(next) if next.why == one.why => words += ", ",
            Some(_) => words += &format!(" {}, ", one.why),
            None => words += &format!(" {}", one.why),
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use wheelover_core::view::snapshot;
    use wheelover_core::voyage::{Event, Voyage};

    #[test]
    fn who_is_not_believed_is_named_with_the_reason() {
        let mut voyage = Voyage::embedded(7);
        voyage.handle(Stamp(1_000), Event::Tick, &mut Vec::new());
        let mut own = snapshot(&voyage).own.unwrap();
        let mut check = |refused: &[(&str, &str)], expect: &str| {
            let view = |(source, why): &(&str, &str)| RefusedView {
                quantity: Quantity::Position,
                source: (*source).to_owned(),
                why: (*why).to_owned(),
            };
            own.refused = refused.iter().map(view).collect();
            assert_eq!(words(&own, Quantity::Position), expect);
        };
        check(&[], "");
        check(&[("gps/GP/GLL", "jumped")], "GPS jumped");
        check(
            &[("gps/GP/GLL", "jumped"), ("ecdis/EI/GLL", "jumped")],
            "GPS, ECDIS jumped",
        );
        check(
            &[("a/GP/GLL", "jumped"), ("b/GP/GLL", "stuck")],
            "A jumped, B stuck",
        );
    }
}
