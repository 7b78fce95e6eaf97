//! Whether the position in use has a differential correction, and when it last had one (AP-7).

use crate::time::Stamp;
use serde::{Deserialize, Serialize};

/// The correction of the position in use.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Correction {
    /// The fix in use has none.
    plain: bool,
    last: Option<Stamp>,
}

impl Correction {
    /// Takes the fix in use: whether it is corrected, and when it was heard.
    pub(super) fn look(&mut self, used: Option<(bool, Stamp)>) {
        self.plain = used.is_some_and(|(corrected, _)| !corrected);
        if let Some((true, at)) = used {
            self.last = Some(at);
        }
    }

    /// Whether the fix in use is corrected; without a fix nothing says that it is not.
    pub(super) const fn is_there(&self) -> bool {
        !self.plain
    }

    /// When a fix in use last was.
    pub(super) const fn last(&self) -> Option<Stamp> {
        self.last
    }
}
