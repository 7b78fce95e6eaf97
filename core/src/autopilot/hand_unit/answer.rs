//! What a hand unit is told when it asks (EMC-2).

use crate::talk::Saying;
use serde::{Deserialize, Serialize};

/// What a hand unit is told when it asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(in super::super) enum Answer {
    /// 03.
    Installation,
    /// 05.
    Gains,
    /// 07.
    Information,
}

impl Answer {
    /// Its sentence.
    pub(in super::super) const fn saying(self) -> Saying {
        match self {
            Self::Installation => Saying::Pemc03,
            Self::Gains => Saying::Pemc05,
            Self::Information => Saying::Pemc07,
        }
    }
}
