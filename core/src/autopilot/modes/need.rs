//! What modes need: how each need is called where it is missing, and what follows where it is lost. One table.

/// What follows where a need is lost while the mode is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum Lost {
    /// It is asked for at the selection only.
    AtEntry,
    /// The rudder is held.
    RudderHold,
    /// AUTO holds the present heading, alarm.
    Auto,
    /// The next command of the chart system is not followed, and that is said.
    NotFollowed,
    /// What the mode's row says, as soon as it is older than `track_fail`; by this name.
    Watched(&'static str),
}

macro_rules! needs {
    ($($name:ident: $lost:expr, $missing:literal, $what:literal;)*) => {
        /// What a mode cannot do without.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(in super::super) enum Need {
            $(#[doc = $what] $name,)*
        }

        impl Need {
            /// Every need.
            pub(super) const ALL: &'static [Self] = &[$(Self::$name,)*];

            /// What an officer is told where it is missing.
            pub(in super::super) const fn missing(self) -> &'static str {
                match self { $(Self::$name => $missing,)* }
            }

            /// What it is.
            pub(super) const fn what(self) -> &'static str {
                match self { $(Self::$name => $what,)* }
            }

            /// What follows where it is lost.
            pub(in super::super) const fn lost(self) -> Lost {
                match self { $(Self::$name => $lost,)* }
            }
        }
    };
}

// AP-6, AP-7
needs! {
    Enabled: Lost::AtEntry, "AutoNAV is not enabled at installation", "The setting `external_tcs`.";
    InAuto: Lost::AtEntry, "AutoNAV is selected from AUTO only", "AUTO steers.";
    AutoFirst: Lost::AtEntry, "TRACK is selected from AUTO only", "AUTO steers, before TRACK does.";
    SpeedSource: Lost::AtEntry, "CHANGE SPEED SOURCE: the speed is entered by hand", "The setting `speed_source` is not `manual`; where it was when AutoNAV was selected, STANDBY since then (AP-7).";
    TrueHeading: Lost::AtEntry, "the heading is magnetic, and no variation is known", "A heading of true north (AP-10).";
    NoOverride: Lost::AtEntry, "override is in use", "The chart system reports no override (HTC-1).";
    LegKnown: Lost::AtEntry, "not in the middle of a turn: the leg before it is unknown", "No radius is commanded: situations 3 and 4 cannot be entered.";
    InStandby: Lost::AtEntry, "INSTALLATION is selected from STANDBY only", "STANDBY is on.";
    AutoSteers: Lost::AtEntry, "AUTOTUNING is selected from AUTO only", "AUTO holds its heading, and finishes no turn.";
    SteadySpeed: Lost::AtEntry, "the speed has not been steady for 30 s", "The measured speed was within half a knot for 30 s.";
    Dodgeable: Lost::AtEntry, "DODGE is selected from AUTO, AutoNAV, TRACK or WIND VANE only", "A mode to return to.";
    Heading: Lost::RudderHold, "no heading", "A heading that is believed.";
    HeadingOrRate: Lost::RudderHold, "neither a heading nor a measured rate of turn", "A heading that is believed, or a measured rate of turn that is: by the rate alone the mode goes on, with a caution (AP-21).";
    Wind: Lost::Auto, "no wind is heard", "MWV, VWR or VWT of the wind that is set: apparent or true.";
    MeasuredSpeed: Lost::NotFollowed, "no measured speed", "A speed through the water, or over ground, measured or calculated from positions; the set cruise speed where it is lost (FA10).";
    Command: Lost::Watched("HTC"), "no valid HTC", "An accepted HTC for this mode.";
    ShipConstants: Lost::NotFollowed, "the ship's constants are not given: no track control (AP-20)", "The ship's own constants.";
    Position: Lost::Watched("position"), "no position", "A position that is believed.";
    Differential: Lost::Watched("differential correction"), "no differential correction", "A position with differential correction, where the setting `differential` is `required` (AP-7).";
    CrossTrack: Lost::Watched("XTE"), "no valid XTE", "XTE with status A.";
    ControlDistance: Lost::Watched("PNEY,001"), "no valid PNEY,001", "PNEY,001 with status A.";
    Leg: Lost::NotFollowed, "PNEY,001 has no distance: no leg", "The distance in PNEY,001.";
    Centre: Lost::Watched("PNEY,002"), "no valid PNEY,002", "PNEY,002, with a centre or without.";
    OnePosition: Lost::NotFollowed, "own and the chart system's position are too far apart", "Own and the chart system's position are those of one ship.";
    Plotted: Lost::Watched("APB"), "no valid APB", "An accepted APB that contradicts nothing else that its port says.";
    Agreement: Lost::Watched("agreement"), "the chart system's sentences do not agree", "What is commanded agrees with everything else that is heard.";
}

/// What the selection of AutoNAV is refused without (AP-6).
pub(super) const ENTRY: &[Need] = &[
    Need::Enabled,
    Need::InAuto,
    Need::SpeedSource,
    Need::TrueHeading,
    Need::NoOverride,
    Need::LegKnown,
];
