//! The mode that is on, and every transition to another.

use super::auto::Auto;
use super::autonav_ti::AutonavTi;
use super::autonav_tn::AutonavTn;
use super::autotuning::Autotuning;
use super::dodge::Dodge;
use super::event::{Cause, Event};
use super::ffu_override::FfuOverride;
use super::installation::Installation;
use super::nfu_override::NfuOverride;
use super::river_pilot::RiverPilot;
use super::rudder_hold::RudderHold;
use super::standby::Standby;
use super::state::{Listed, State};
use super::table::{ModeName, Row};
use super::track::Track;
use super::wind_vane::WindVane;
use crate::autopilot::facts::Facts;
use crate::time::Stamp;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// A stop is the end of the route if the cross-track distances vanish within this time (TCS-10).
const STOP_CAUSE_MS: u64 = 1_500;

macro_rules! modes {
    ($($name:ident: $what:literal;)*) => {
        /// What the autopilot does; each variant owns what it needs.
        #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
        pub enum Mode {
            $(#[doc = $what] $name($name),)*
        }

        /// The rows of all modes.
        pub(in super::super) const TABLE: &[Row] = &[$($name::ROW,)*];

        impl Mode {
            /// Its row in the table.
            pub(in super::super) const fn row(&self) -> &'static Row {
                match self { $(Self::$name(_) => &const { $name::ROW },)* }
            }

            /// What it does.
            pub(in super::super) const fn state(&self) -> &dyn State {
                match self { $(Self::$name(state) => state,)* }
            }

            /// What it does, and what it changes of itself.
            pub(in super::super) const fn state_mut(&mut self) -> &mut dyn State {
                match self { $(Self::$name(state) => state,)* }
            }

            /// One state for each way in which a mode can go on, by its name in the document.
            pub(super) fn examples() -> Vec<(&'static str, Self)> {
                let mut all = Vec::new();
                $(all.extend($name::examples().into_iter().map(|(name, state)| (name, Self::$name(state))));)*
                all
            }
        }
    };
}

modes! {
    Standby: "No orders are given.";
    NfuOverride: "The hardware override steers.";
    Auto: "Heading control.";
    AutonavTn: "Remote heading control by HTC.";
    AutonavTi: "Track control by HTC, XTE and PNEY.";
    Track: "A plotter's route by APB.";
    RudderHold: "Rudder frozen after a critical failure.";
    WindVane: "The angle to the wind is held.";
    RiverPilot: "The rate of turn is held.";
    Dodge: "Round something, and back.";
    FfuOverride: "The rudder is ordered.";
    Installation: "No orders: the engineer sets the autopilot up.";
    Autotuning: "A bounded zigzag.";
}

impl Mode {
    /// No orders.
    pub(in super::super) const STANDBY: Self = Self::Standby(Standby);

    /// Every transition.
    pub(in super::super) fn next(self, event: &Event, facts: &Facts<'_>) -> Self {
        match (self, event) {
            (_, Event::NfuLine(true)) => Self::NfuOverride(NfuOverride { line: true }),
            (Self::NfuOverride(_), Event::NfuLine(line)) => {
                Self::NfuOverride(NfuOverride { line: *line })
            }
            (mode, Event::NfuLine(false)) => mode,
            (mode @ Self::NfuOverride(_), Event::Override) => mode,
            (_, Event::Standby | Event::Override) => Self::STANDBY,
            // AP-18: left to STANDBY only.
            (mode @ Self::Installation(_), _) => mode,
            (Self::Standby(_), Event::Installation) => Self::Installation(Installation),
            (
                mode @ (Self::Standby(_)
                | Self::NfuOverride(_)
                | Self::RudderHold(_)
                | Self::FfuOverride(_)),
                Event::HeadingLost,
            ) => mode,
            (
                mode @ (Self::Standby(_) | Self::NfuOverride(_) | Self::RudderHold(_)),
                Event::RudderLost,
            ) => mode,
            (_, Event::HeadingLost | Event::RudderLost) => {
                Self::RudderHold(RudderHold { order: facts.order })
            }
            (_, Event::Auto) => Self::Auto(Auto::on(facts.heading)),
            (Self::Auto(auto), Event::SetHeading(set)) => Self::Auto(Auto {
                set: *set,
                finish: None,
                ..auto
            }),
            (
                Self::Auto(_) | Self::AutonavTn(_) | Self::AutonavTi(_) | Self::Dodge(_),
                Event::EngageTn { hts, track, rate },
            ) => Self::AutonavTn(AutonavTn::on(facts.now, *hts, *track, *rate)),
            (
                Self::Auto(_) | Self::AutonavTn(_) | Self::Dodge(_),
                Event::EngageTi { path, radius },
            ) => Self::AutonavTi(AutonavTi::on(facts.now, *path, Some(*radius))),
            (_, Event::RiverPilot) => Self::RiverPilot(RiverPilot::default()),
            (_, Event::FfuOverride(rudder)) => Self::FfuOverride(FfuOverride::on(*rudder)),
            (Self::Standby(_) | Self::FfuOverride(_), Event::Jog { rudder, until }) => {
                Self::FfuOverride(FfuOverride {
                    rudder: *rudder,
                    until: Some(*until),
                })
            }
            (
                _,
                Event::WindVane {
                    angle,
                    apparent,
                    direction,
                },
            ) => Self::WindVane(WindVane {
                angle: *angle,
                apparent: *apparent,
                direction: *direction,
            }),
            (
                Self::Auto(_)
                | Self::AutonavTn(_)
                | Self::AutonavTi(_)
                | Self::Track(_)
                | Self::WindVane(_),
                Event::Dodge { base, former },
            ) => Self::Dodge(Dodge::on(*base, *former)),
            (Self::Auto(auto), Event::Autotuning) => {
                Self::Autotuning(Autotuning::on(facts.now, auto.set))
            }
            (Self::WindVane(_) | Self::Dodge(_) | Self::Autotuning(_), Event::AutoOn(set)) => {
                Self::Auto(Auto::on(*set))
            }
            (Self::Auto(_) | Self::Dodge(_), Event::EngageTrack(track)) => Self::Track(*track),
            (
                mode @ (Self::AutonavTi(_) | Self::AutonavTn(_) | Self::Track(_)),
                Event::TrackFail(cause),
            ) => Self::Auto(mode.fall_back(cause, facts)),
            // Nothing else changes a mode: a heading is set in AUTO only, a track fails in AutoNAV and TRACK only.
            (mode, Event::SetHeading(_) | Event::TrackFail(_) | Event::EngageTrack(_)) => mode,
            (mode, Event::EngageTn { .. } | Event::EngageTi { .. }) => mode,
            // The operator's modes are entered and left from where the table says.
            (mode, Event::Dodge { .. } | Event::AutoOn(_) | Event::Jog { .. }) => mode,
            (mode, Event::Installation | Event::Autotuning) => mode,
        }
    }

    /// TCS-8, TCS-10: on a leg the heading is held, on a curve the turn is finished.
    fn fall_back(self, cause: &Cause, facts: &Facts<'_>) -> Auto {
        let stopped = *cause == Cause::StandAlone;
        // Note 8.1: after a stop the latest set heading.
        let set = self.state().hts(facts).filter(|_| stopped);
        let held = set.unwrap_or(facts.heading);
        let auto = match self {
            Self::AutonavTi(ti) => ti.lost(held, facts),
            Self::AutonavTn(tn) => tn.lost(held),
            _ => Auto::on(held),
        };
        Auto {
            stop_cause_until: stopped.then(|| facts.now + STOP_CAUSE_MS),
            ..auto
        }
    }

    /// Name for frames and files.
    #[must_use]
    pub const fn name(&self) -> ModeName {
        self.row().name
    }

    /// Name for people.
    #[must_use]
    pub const fn title(&self) -> &'static str {
        self.row().title
    }

    /// What is set in it by a number, in the unit of its order; absent in a mode where a heading or nothing is set.
    #[must_use]
    pub fn set_value(&self) -> Option<f64> {
        self.state().set_value()
    }

    /// Whether the chart system controls.
    #[must_use]
    pub const fn is_autonav(&self) -> bool {
        self.row().commanded.is_some()
    }

    /// Until when a selection of AutoNAV stands.
    #[must_use]
    pub const fn selected_until(&self) -> Option<Stamp> {
        match self {
            Self::Auto(auto) => auto.selected_until,
            _ => None,
        }
    }

    /// Selects AutoNAV until then, or withdraws the selection.
    pub(in super::super) const fn select(&mut self, until: Option<Stamp>) {
        if let Self::Auto(auto) = self {
            auto.selected_until = until;
        }
    }
}

/// The row of a mode; none of one that does not exist yet.
pub(in super::super) fn row(name: ModeName) -> Option<&'static Row> {
    TABLE.iter().find(|row| row.name == name)
}

/// The name of a mode for people.
#[must_use]
pub fn title_of(name: ModeName) -> &'static str {
    row(name).map_or("", |row| row.title)
}
