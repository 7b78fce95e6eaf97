//! How far a heard value may be used by its age; the limits stand in the table of facts (AP-9).

pub use super::Quantity;
use crate::time::Stamp;
use serde::{Deserialize, Serialize};

/// How a heard value may be shown and used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Freshness {
    /// Heard in time.
    Valid,
    /// Later than twice its period: still used, shown with its age.
    Late,
    /// Of low integrity: shown as such.
    Low,
    /// Too old or flagged invalid: neither used nor shown.
    Lost,
    /// Never heard.
    Never,
}

/// Age limits of a quantity in milliseconds: late, lost.
#[must_use]
pub const fn limits(quantity: Quantity) -> (u64, u64) {
    quantity.limits()
}

/// How a value heard at `heard` may be used at `now`.
#[must_use]
pub const fn freshness(quantity: Quantity, heard: Stamp, now: Stamp) -> Freshness {
    let (late, lost) = limits(quantity);
    let age = now.since(heard);
    if age > lost {
        Freshness::Lost
    } else if age > late {
        Freshness::Late
    } else {
        Freshness::Valid
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_value_is_used_past_its_age_limit() {
        let heard = Stamp(10_000);
        let check = |quantity, age, expect| {
            assert_eq!(
                freshness(quantity, heard, heard + age),
                expect,
                "{quantity:?} {age}"
            );
        };
        check(Quantity::Heading, 2_000, Freshness::Late);
        check(Quantity::Heading, 2_001, Freshness::Lost);
        check(Quantity::Control, 3_000, Freshness::Valid);
        check(Quantity::Control, 3_001, Freshness::Late);
        check(Quantity::Control, 5_001, Freshness::Lost);
    }
}
