//! Modes of the autopilot and every transition between them (AP-6, TCS-8 to TCS-10, HTC-1, FA7).

use super::steering::TurnBy;
use crate::path::Path;
use crate::units::{Course, Heading, Radius, RateOfTurn, RudderAngle};
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// The autopilot's mode as it is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ModeName {
    /// The autopilot gives no orders.
    Standby,
    /// The hardware override is in use.
    NfuOverride,
    /// Heading control.
    Auto,
    /// Remote heading control by a chart system.
    AutonavTn,
    /// Track control by a chart system.
    AutonavTi,
    /// Following APB.
    Track,
    /// Rudder frozen after a critical failure.
    RudderHold,
}

/// What the autopilot does; each variant owns what it needs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Mode {
    /// No orders are given.
    Standby,
    /// Heading control.
    Auto {
        /// Set heading.
        set: Heading,
        /// How a lost turn is finished; absent where AUTO's own settings hold.
        finish: Option<Finish>,
    },
    /// Remote heading control by HTC.
    AutonavTn {
        /// Heading to steer, as last commanded.
        hts: Heading,
        /// Commanded track.
        track: Course,
        /// Commanded rate while the chart system controls the turn.
        rate: Option<RateOfTurn>,
    },
    /// Track control by HTC, XTE and PNEY.
    AutonavTi {
        /// The leg, or the turn with both its legs.
        path: Path,
        /// The radius that HTD acknowledges: the last accepted one (AP-2).
        radius: Option<Radius>,
        /// The commanded track, as accepted.
        track: Course,
    },
    /// Rudder frozen after a critical failure.
    RudderHold {
        /// The frozen order.
        order: RudderAngle,
    },
}

/// How a turn is finished after TRACK FAIL on a curve (TCS-8).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finish {
    /// The last commanded rate or radius.
    pub by: TurnBy,
    /// Lost on the forwarding distance: the leg's course is kept until the arc begins.
    pub wait: Option<Path>,
}

/// Why control by the chart system ended.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Cause {
    /// A sentence is missing, late, malformed or has a wrong checksum (TCS-8).
    Missing(String),
    /// HTC says manual or rudder control (TCS-9).
    ModeRefused(String),
    /// HTC says stand-alone (TCS-10).
    StandAlone,
    /// The position jumped (FA9).
    PositionJump,
}

/// What changes a mode.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// The operator takes the ship.
    Standby,
    /// The operator selects heading control.
    Auto,
    /// The operator sets a heading.
    SetHeading(Heading),
    /// Both sides agree on Tn.
    EngageTn {
        /// Commanded heading.
        hts: Heading,
        /// Commanded track.
        track: Course,
        /// Commanded rate in a turn.
        rate: Option<RateOfTurn>,
    },
    /// Both sides agree on Ti.
    EngageTi {
        /// The leg.
        path: Path,
        /// AUTO's radius, reported before the first turn.
        radius: Radius,
    },
    /// Control by the chart system is lost.
    TrackFail(Cause),
    /// Override is reported.
    Override,
    /// No heading is usable.
    HeadingLost,
}

/// What a transition needs to know of the ship.
#[derive(Clone, Copy, Debug)]
pub struct Ship {
    /// Actual heading; the last usable one where it is lost.
    pub heading: Heading,
    /// Heading to steer in force, where there is one.
    pub hts: Option<Heading>,
    /// Rudder order in force.
    pub order: RudderAngle,
    /// Whether the ship is still before the arc of the commanded turn.
    pub before_arc: bool,
}

impl Mode {
    /// Every transition.
    #[must_use]
    pub fn next(self, event: &Event, ship: &Ship) -> Self {
        match (self, event) {
            (_, Event::Standby | Event::Override) => Self::Standby,
            (Self::Standby, Event::HeadingLost) => Self::Standby,
            (Self::RudderHold { order }, Event::HeadingLost) => Self::RudderHold { order },
            (_, Event::HeadingLost) => Self::RudderHold { order: ship.order },
            (_, Event::Auto) => Self::Auto {
                set: ship.heading,
                finish: None,
            },
            (Self::Auto { .. }, Event::SetHeading(set)) => Self::Auto {
                set: *set,
                finish: None,
            },
            (
                Self::Auto { .. } | Self::AutonavTn { .. } | Self::AutonavTi { .. },
                Event::EngageTn { hts, track, rate },
            ) => Self::AutonavTn {
                hts: *hts,
                track: *track,
                rate: *rate,
            },
            (Self::Auto { .. } | Self::AutonavTn { .. }, Event::EngageTi { path, radius }) => {
                Self::AutonavTi {
                    path: *path,
                    radius: Some(*radius),
                    track: path.course_in,
                }
            }
            (mode @ (Self::AutonavTi { .. } | Self::AutonavTn { .. }), Event::TrackFail(cause)) => {
                mode.fall_back(cause, ship)
            }
            // Nothing else changes a mode: a heading is set in AUTO only, a track fails in AutoNAV only.
            (mode, Event::SetHeading(_) | Event::TrackFail(_)) => mode,
            (mode, Event::EngageTn { .. } | Event::EngageTi { .. }) => mode,
        }
    }

    /// TCS-8, TCS-10: on a leg the heading is held, on a curve the turn is finished.
    fn fall_back(self, cause: &Cause, ship: &Ship) -> Self {
        let held = match cause {
            Cause::StandAlone => ship.hts.unwrap_or(ship.heading), // note 8.1: the latest set heading
            _ => ship.heading,
        };
        match self {
            Self::AutonavTi {
                path: path @ Path {
                    turn: Some(turn), ..
                },
                track,
                ..
            } => Self::Auto {
                set: track.as_heading(),
                finish: Some(Finish {
                    by: TurnBy::Radius(turn.radius),
                    wait: ship.before_arc.then_some(path),
                }),
            },
            Self::AutonavTn {
                track,
                rate: Some(rate),
                ..
            } => Self::Auto {
                set: track.as_heading(),
                finish: Some(Finish {
                    by: TurnBy::Rate(rate),
                    wait: None,
                }),
            },
            _ => Self::Auto {
                set: held,
                finish: None,
            },
        }
    }

    /// Name for the page.
    #[must_use]
    pub const fn name(&self) -> ModeName {
        match self {
            Self::Standby => ModeName::Standby,
            Self::Auto { .. } => ModeName::Auto,
            Self::AutonavTn { .. } => ModeName::AutonavTn,
            Self::AutonavTi { .. } => ModeName::AutonavTi,
            Self::RudderHold { .. } => ModeName::RudderHold,
        }
    }

    /// Whether the chart system controls.
    #[must_use]
    pub const fn is_autonav(&self) -> bool {
        matches!(self, Self::AutonavTn { .. } | Self::AutonavTi { .. })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::Point;

    fn ship() -> Ship {
        Ship {
            heading: Heading::from_deg(100.0),
            hts: Some(Heading::from_deg(103.0)),
            order: RudderAngle::from_deg(4.0),
            before_arc: false,
        }
    }

    fn turning() -> Mode {
        let path = Path::turn(
            Course::from_deg(100.0),
            Point::default(),
            Radius::from_nm(0.5),
            Course::from_deg(160.0),
        );
        Mode::AutonavTi {
            path,
            radius: None,
            track: Course::from_deg(160.0),
        }
    }

    // TCS-8, FA1
    #[test]
    fn lost_on_a_leg_holds_the_actual_heading() {
        let leg = Path::leg(Point::default(), Course::from_deg(100.0));
        let mode = Mode::AutonavTi {
            path: leg,
            radius: None,
            track: Course::from_deg(100.0),
        };
        let missing = Event::TrackFail(Cause::Missing("HTC".into()));
        let Mode::Auto { set, finish } = mode.clone().next(&missing, &ship()) else {
            panic!()
        };
        assert_eq!((set.deg(), finish), (100.0, None));
        // TCS-10, FA3
        let stopped = Event::TrackFail(Cause::StandAlone);
        let Mode::Auto { set, .. } = mode.next(&stopped, &ship()) else {
            panic!()
        };
        assert_eq!(set.deg(), 103.0);
    }

    // TCS-8, FA2
    #[test]
    fn lost_in_a_turn_finishes_the_turn() {
        let missing = Event::TrackFail(Cause::Missing("HTC".into()));
        let Mode::Auto { set, finish } = turning().next(&missing, &ship()) else {
            panic!()
        };
        assert_eq!(set.deg(), 160.0);
        assert_eq!(finish.unwrap().wait, None);
        let before = Ship {
            before_arc: true,
            ..ship()
        };
        let Mode::Auto { finish, .. } = turning().next(&missing, &before) else {
            panic!()
        };
        assert!(finish.unwrap().wait.is_some());
    }

    // HTC-1, FA12
    #[test]
    fn override_ends_every_mode_in_standby() {
        for mode in [
            turning(),
            Mode::Auto {
                set: ship().heading,
                finish: None,
            },
        ] {
            assert_eq!(mode.next(&Event::Override, &ship()), Mode::Standby);
        }
    }

    // FA7
    #[test]
    fn a_lost_heading_freezes_the_rudder_and_only_the_operator_ends_it() {
        let held = turning().next(&Event::HeadingLost, &ship());
        assert_eq!(
            held,
            Mode::RudderHold {
                order: ship().order
            }
        );
        let kept = held
            .clone()
            .next(&Event::SetHeading(ship().heading), &ship());
        assert_eq!(kept, held);
        assert!(matches!(
            held.next(&Event::Auto, &ship()),
            Mode::Auto { .. }
        ));
    }

    // AP-6
    #[test]
    fn track_control_is_entered_from_auto_only() {
        let path = Path::leg(Point::default(), Course::from_deg(100.0));
        let engage = Event::EngageTi {
            path,
            radius: Radius::from_nm(0.5),
        };
        assert_eq!(Mode::Standby.next(&engage, &ship()), Mode::Standby);
        let auto = Mode::Auto {
            set: ship().heading,
            finish: None,
        };
        assert!(auto.next(&engage, &ship()).is_autonav());
    }
}
