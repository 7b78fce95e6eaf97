//! Whether a quantity still comes from the source that is preferred, and which sources are not believed (AP-9, DSP-5).

use crate::facts::Quantity;
use crate::picture::Source;
use crate::time::Stamp;
use serde::{Deserialize, Serialize};

/// A source that is only used for so long has not been chosen: two receivers are not heard in the same instant.
const SETTLED_MS: u64 = 3_000;

/// A source that is heard and not believed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refused<'a> {
    /// What it says.
    pub quantity: Quantity,
    /// Who says it.
    pub source: &'a Source,
    /// Why it is not believed, in an officer's words.
    pub why: &'static str,
}

/// The preferred source of one quantity, and the one in use where that is another.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Preferred {
    best: Option<(Source, u8)>,
    since: Stamp,
    used: Option<Source>,
}

impl Preferred {
    /// Notes the source in use with its rank; `free`: nothing is steered, whatever is used is right.
    pub(crate) fn watch(&mut self, now: Stamp, used: Option<(Source, u8)>, free: bool) {
        let better = match (&self.best, &used) {
            (None, Some(_)) => true,
            (Some((best, _)), Some((used, _))) if best == used => false,
            (Some((_, best)), Some((_, used))) => used < best || now.since(self.since) < SETTLED_MS,
            (_, None) => false,
        };
        if better || free {
            self.best = used.clone();
            self.since = now;
        }
        self.used = used.map(|(source, _)| source);
    }

    /// The source that was left, and the one in use instead.
    pub(crate) fn fallen(&self) -> Option<(&Source, Option<&Source>)> {
        let (best, _) = self.best.as_ref()?;
        (self.used.as_ref() != Some(best)).then_some((best, self.used.as_ref()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // AP-9
    #[test]
    fn the_worse_source_is_said_until_the_better_one_is_back() {
        let source = |port: usize| Source {
            port,
            talker: "GP".into(),
            formatter: "GLL".into(),
        };
        let mut preferred = Preferred::default();
        let mut at = |seconds: u64, used: Option<u8>| {
            let used = used.map(|rank| (source(usize::from(rank)), rank));
            preferred.watch(Stamp(seconds * 1_000), used, false);
            preferred.fallen().is_some()
        };
        assert!(!at(1, Some(1)));
        assert!(!at(2, Some(0)), "the better one takes over");
        assert!(at(10, Some(1)));
        assert!(at(11, None));
        assert!(!at(12, Some(0)));
    }
}
