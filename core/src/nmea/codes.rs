//! Codes: each letter of a coded field is a variant with its meaning.

use serde::{Deserialize, Serialize};

/// Makes an enum of letters from one list: letter and meaning of each variant.
macro_rules! codes {
    ($( $(#[$doc:meta])* $name:ident { $( $variant:ident = $letter:literal $meaning:literal ),+ $(,)? } )+) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
        #[serde(rename_all = "snake_case")]
        pub enum $name {
            $( #[doc = $meaning] $variant ),+
        }
        impl $name {
            /// Every variant, in the order of the source.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];
            #[allow(dead_code)]
            pub(crate) const LETTERS: &'static [u8] = &[$($letter),+];
            #[allow(dead_code)]
            pub(crate) const MEANINGS: &'static [&'static str] = &[$($meaning),+];
            /// Its letter on the wire.
            #[must_use]
            pub const fn letter(self) -> char {
                match self { $(Self::$variant => $letter as char),+ }
            }
            /// The variant of a letter.
            #[must_use]
            pub const fn from_letter(letter: u8) -> Option<Self> {
                match letter { $($letter => Some(Self::$variant),)+ _ => None }
            }
            /// What it means, in words.
            #[must_use]
            pub const fn meaning(self) -> &'static str {
                match self { $(Self::$variant => $meaning),+ }
            }
        }
        impl crate::nmea::view::FromValue for Option<$name> {
            fn from_value(value: crate::nmea::Value<'_>) -> Self {
                match value {
                    crate::nmea::Value::Code(letter) => $name::from_letter(letter),
                    _ => None,
                }
            }
        }
        impl crate::nmea::view::ToCell for Option<$name> {
            fn to_cell(&self) -> crate::nmea::encode::Cell<'_> {
                match self {
                    Some(code) => crate::nmea::encode::Cell::Letter(code.letter() as u8),
                    None => crate::nmea::encode::Cell::Null,
                }
            }
        }
    )+};
}
pub(crate) use codes;

/// Makes a list of codes of more than one character: word and meaning of each.
macro_rules! words {
    ($( $(#[$doc:meta])* $name:ident { $( $word:literal $meaning:literal ),+ $(,)? } )+) => {$(
        $(#[$doc])*
        pub(crate) enum $name {}
        impl $name {
            pub(crate) const WORDS: &'static [&'static str] = &[$($word),+];
            pub(crate) const MEANINGS: &'static [&'static str] = &[$($meaning),+];
        }
    )+};
}
pub(crate) use words;

codes! {
    /// Override of HTC and HTD (field 1).
    OverrideStatus { InUse = b'A' "in use", NotInUse = b'V' "not in use" }
    /// Selected steering mode of HTC and HTD (field 4).
    SteeringMode {
        Manual = b'M' "manual steering",
        StandAlone = b'S' "stand-alone heading control",
        HeadingControl = b'H' "heading control by an external device",
        TrackControl = b'T' "track control",
        RudderControl = b'R' "rudder control",
    }
    /// Turn mode of HTC and HTD (field 5).
    TurnMode {
        Radius = b'R' "radius controlled",
        Rate = b'T' "turn rate controlled",
        NotControlled = b'N' "turn is not controlled",
    }
    /// Heading reference.
    Reference { True = b'T' "true", Magnetic = b'M' "magnetic" }
    /// Bearing reference of a moving body.
    RelativeReference { True = b'T' "true", Relative = b'R' "relative" }
    /// Sentence status: whether a sentence commands or reports.
    CommandStatus { Command = b'C' "command to change settings", Report = b'R' "report of the present settings" }
    /// Whether a limit is reached.
    LimitStatus { Within = b'A' "within limits", Reached = b'V' "limit reached or exceeded" }
    /// Whether data are valid.
    DataStatus { Valid = b'A' "valid", Invalid = b'V' "invalid" }
    /// Mode indicator of a position fix and what is derived from it.
    ModeIndicator {
        Autonomous = b'A' "autonomous",
        Differential = b'D' "differential",
        Precise = b'P' "precise",
        FloatRtk = b'F' "float RTK",
        RealTimeKinematic = b'R' "real-time kinematic",
        Estimated = b'E' "estimated (dead reckoning)",
        Manual = b'M' "manual input",
        Simulator = b'S' "simulator",
        NotValid = b'N' "not valid",
    }
    /// Mode indicator of THS.
    ThsMode {
        Autonomous = b'A' "autonomous",
        Estimated = b'E' "estimated (dead reckoning)",
        Manual = b'M' "manual input",
        Simulator = b'S' "simulator",
        NotValid = b'V' "not valid",
    }
    /// Where a rudder order or an engine command comes from.
    CommandSource {
        Bridge = b'B' "bridge",
        PortWing = b'P' "port wing",
        StarboardWing = b'S' "starboard wing",
        EngineControlRoom = b'C' "engine control room",
        EngineSide = b'E' "engine side, local",
        Wing = b'W' "wing",
    }
    /// Condition of an ALR alarm.
    AlarmCondition { Raised = b'A' "threshold exceeded", NotRaised = b'V' "threshold not exceeded" }
    /// Acknowledge state of an ALR alarm.
    AcknowledgeState { Acknowledged = b'A' "acknowledged", NotAcknowledged = b'V' "not acknowledged" }
    /// Arrival or passing.
    Arrival { Entered = b'A' "entered or passed", Not = b'V' "not entered or passed" }
    /// Unit of a distance in APB and XTE.
    DistanceUnit { NauticalMiles = b'N' "nautical miles", Kilometres = b'K' "kilometres" }
    /// Category of an alert (IEC 62923).
    AlertCategory {
        A = b'A' "category A: acknowledged only where it is raised",
        B = b'B' "category B: acknowledged anywhere",
        C = b'C' "category C: not acknowledged on the bridge",
    }
    /// Priority of an alert.
    AlertPriority {
        Emergency = b'E' "emergency alarm",
        Alarm = b'A' "alarm",
        Warning = b'W' "warning",
        Caution = b'C' "caution",
    }
    /// State of an alert in ALF.
    AlertState {
        ActiveUnacknowledged = b'V' "active, not acknowledged",
        Silenced = b'S' "silenced",
        Acknowledged = b'A' "acknowledged",
        Transferred = b'O' "active, responsibility transferred",
        RectifiedUnacknowledged = b'U' "rectified, not acknowledged",
        Normal = b'N' "normal",
    }
    /// What is asked or refused of an alert (ACN, ARC).
    AlertCommand {
        Acknowledge = b'A' "acknowledge",
        Request = b'Q' "request or repeat information",
        Transfer = b'O' "transfer of responsibility",
        Silence = b'S' "silence",
    }
}

impl ModeIndicator {
    /// Whether what it marks may be used (AP-9).
    #[must_use]
    pub const fn valid(self) -> bool {
        matches!(
            self,
            Self::Autonomous
                | Self::Differential
                | Self::Precise
                | Self::FloatRtk
                | Self::RealTimeKinematic
        )
    }
}
