//! Who asks, and who goes before whom: one table (HTC-4).

use serde::{Deserialize, Serialize};

macro_rules! origins {
    ($($(#[$doc:meta])* $name:ident = $rank:literal, $title:literal;)*) => {
        /// Who asks. It stands in a recording beside each order.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
        #[serde(rename_all = "snake_case")]
        pub enum Origin {
            $($(#[$doc])* $name,)*
        }

        impl Origin {
            /// All, the highest first.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];

            /// Its name for people.
            #[must_use]
            pub const fn title(self) -> &'static str {
                match self { $(Self::$name => $title,)* }
            }

            /// Its place in the order; a lower number goes before a higher one.
            #[must_use]
            pub const fn rank(self) -> u8 {
                match self { $(Self::$name => $rank,)* }
            }
        }
    };
}

origins! {
    /// The line of the hardware override.
    NfuLine = 0, "NFU line";
    /// FFU and mode switch of the steering stand.
    Stand = 2, "steering stand";
    /// A hand-held control unit.
    HandUnit = 3, "hand unit";
    /// An officer at a page, or a program in his place.
    Officer = 3, "operator";
    /// The scripted officer of the embedded voyage.
    Script = 3, "scripted officer";
    /// The chart system by its HTC.
    Htc = 4, "HTC";
    /// The chart system or a plotter by its HSC.
    Hsc = 5, "HSC";
    /// The chart system or a plotter by its APB.
    Apb = 6, "APB";
}

/// Rank of an operator's STANDBY: behind the NFU line, before all else.
pub const STANDBY_RANK: u8 = 1;
