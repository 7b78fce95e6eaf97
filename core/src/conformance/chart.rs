//! The chart system's side: the situation of each burst, and the rules of the situation table.

use super::fields;
use super::report::{Burst, Report};
use crate::geo::{Plane, Point, Position};
use crate::nmea::{DataStatus, Htc, SteeringMode};
use crate::path::Arc;
use crate::units::{Course, Distance, Radius};
use alloc::format;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// Cross-track distances may differ by this much on a leg, nautical miles.
const SAME_NM: f64 = 0.001;
/// The distance to the arc may differ from the one that the centre gives by this much, nautical miles.
const ARC_NM: f64 = 0.02;
/// Track control ends within this time after the position is lost, seconds.
const POSITION_S: f64 = 2.0;

/// What the chart system last commanded, for the rules on the autopilot.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct LastCommand {
    pub(super) htc: Htc,
    /// When this mode, this radius, this track began.
    pub(super) mode_since: f64,
    pub(super) radius_since: f64,
    pub(super) track_since: f64,
}

/// The rules on the chart system.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct ChartRules {
    situation: Option<u8>,
    commanded: Option<LastCommand>,
    was_active: bool,
    /// Track of the leg before the turn, degrees.
    leg_track: Option<f64>,
    turned: bool,
    /// The mode has changed with this burst.
    begun: bool,
    waypoint: Option<String>,
    /// Waypoint of the turn; changes where the radius ends, one burst sooner or later.
    turn: TurnEnd,
    had_radius: bool,
    invalid_since: Option<f64>,
}

/// The waypoint and the end of a turn must come together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
enum TurnEnd {
    #[default]
    None,
    /// The waypoint has changed; the radius must go in this burst.
    WaypointFirst,
    /// The radius has gone; the waypoint must change in this burst.
    RadiusFirst,
}

impl ChartRules {
    pub(super) const fn situation(&self) -> Option<u8> {
        self.situation
    }

    pub(super) const fn commanded(&self) -> Option<&LastCommand> {
        self.commanded.as_ref()
    }

    fn mode(&self) -> Option<SteeringMode> {
        self.commanded.as_ref()?.htc.steering_mode
    }

    pub(super) fn tracking(&self) -> bool {
        self.mode() == Some(SteeringMode::TrackControl)
    }

    pub(super) fn heading_control(&self) -> bool {
        self.mode() == Some(SteeringMode::HeadingControl)
    }

    /// Names the situation of a burst (CON-1).
    pub(super) fn name(&mut self, clock: f64, burst: &Burst) {
        let Some(htc) = burst.htc.clone() else { return };
        let before = self.commanded.take();
        let radius_before = before.as_ref().and_then(|c| c.htc.radius);
        let tracked = before
            .as_ref()
            .is_some_and(|c| c.htc.steering_mode == Some(SteeringMode::TrackControl));
        self.situation = match htc.steering_mode {
            Some(SteeringMode::TrackControl) => {
                if !tracked {
                    self.turned = false;
                }
                Some(if htc.radius.is_some() {
                    self.in_turn(burst)
                } else {
                    self.turned |= tracked && radius_before.is_some();
                    if self.turned { 5 } else { 2 }
                })
            }
            Some(SteeringMode::HeadingControl) => None,
            Some(SteeringMode::StandAlone) => Some(self.not_active(burst)),
            _ => Some(1),
        };
        self.was_active = !matches!(self.situation, Some(1));
        self.begun = before.as_ref().map(|c| c.htc.steering_mode) != Some(htc.steering_mode);
        let since = |same: fn(&Htc, &Htc) -> bool, at: fn(&LastCommand) -> f64| {
            before
                .as_ref()
                .filter(|c| same(&c.htc, &htc))
                .map_or(clock, at)
        };
        self.commanded = Some(LastCommand {
            mode_since: since(|a, b| a.steering_mode == b.steering_mode, |c| c.mode_since),
            radius_since: since(|a, b| a.radius == b.radius, |c| c.radius_since),
            track_since: since(|a, b| a.track == b.track, |c| c.track_since),
            htc,
        });
    }

    /// 4 once the two distances part, until the radius is null; 3 before.
    fn in_turn(&self, burst: &Burst) -> u8 {
        if self.situation == Some(4) {
            return 4;
        }
        let parted = match (distance(burst), control(burst)) {
            (Some(display), Some(control)) => libm::fabs(display - control) > SAME_NM,
            _ => false,
        };
        if parted && !self.before_arc(burst) {
            4
        } else {
            3
        }
    }

    /// Whether the position lies clearly before the beginning of the arc, on the leg before the turn.
    fn before_arc(&self, burst: &Burst) -> bool {
        let (Some(ship), Some(track)) = (about_centre(burst), self.leg_track) else {
            return false;
        };
        let (along, _) = ship.off_line(Point::default(), Course::from_deg(track));
        along < -50.0
    }

    /// 6 where control ended with the route, until distances or control come back; else 1.
    fn not_active(&self, burst: &Burst) -> u8 {
        let ended = burst
            .xte
            .as_ref()
            .is_some_and(|xte| xte.cross_track.is_none())
            && burst
                .pney1
                .as_ref()
                .is_some_and(|pney1| pney1.cross_track.is_none())
            && burst
                .pney2
                .as_ref()
                .is_none_or(|pney2| pney2.waypoint.is_none());
        if ended && self.was_active { 6 } else { 1 }
    }

    /// The rules on one burst, after it has been named.
    pub(super) fn judge(&mut self, burst: &Burst, report: &mut Report<'_>) {
        fields::status(burst, report);
        if let Some(htc) = &burst.htc {
            fields::header(htc, report);
            match htc.steering_mode {
                Some(SteeringMode::StandAlone) => fields::stand_alone(htc, burst, report),
                Some(SteeringMode::HeadingControl) => fields::heading_control(htc, report),
                Some(SteeringMode::TrackControl) => {
                    fields::track_control(htc, report);
                    self.on_track(htc, burst, report);
                }
                Some(mode) => {
                    report.breach("TCS-9", format!("HTC commands {}", mode.meaning()));
                }
                None => report.breach("SEN-4", "HTC without a steering mode"),
            }
            fields::centre(htc, burst, report);
            self.waypoint(htc, burst, report);
            self.position(htc, burst, report);
            if htc.steering_mode == Some(SteeringMode::TrackControl) && htc.radius.is_none() {
                self.leg_track = htc.track;
            }
        }
    }

    /// XTE and PNEY,001 by situation.
    fn on_track(&self, htc: &Htc, burst: &Burst, report: &mut Report<'_>) {
        let (Some(xte), Some(pney1)) = (&burst.xte, &burst.pney1) else {
            return;
        };
        if xte.cross_track.is_none() {
            report.breach("TCS-2", "XTE is null while track control is commanded");
        }
        if pney1.cross_track.is_none() {
            report.breach("TCS-2", "PNEY,001 is null while track control is commanded");
        }
        let (Some(display), Some(control)) = (xte.cross_track, pney1.cross_track) else {
            return;
        };
        if self.situation == Some(4) {
            if let (Some(radius), Some(track), Some(ship)) =
                (htc.radius, htc.track, about_centre(burst))
            {
                let arc = Arc {
                    centre: Point::default(),
                    radius: Radius::from_nm(radius),
                    course_out: Course::from_deg(track),
                };
                let off = Distance::from_m(arc.inside(ship)).abs().nm();
                if libm::fabs(off - libm::fabs(display)) > ARC_NM {
                    let text = format!(
                        "XTE {:.4} nm, but the ship is {off:.4} nm off the arc",
                        libm::fabs(display)
                    );
                    report.breach("TCS-1", text);
                }
            }
        } else if libm::fabs(display - control) > SAME_NM {
            let text = format!("XTE {display:.4} nm and PNEY,001 {control:.4} nm differ on a leg");
            report.breach("TCS-1", text);
        } else if display * control < 0.0 {
            report.breach("TCS-1", "XTE and PNEY,001 are on different sides on a leg");
        }
    }

    /// The identifier changes at activation and where the radius ends, nowhere else.
    fn waypoint(&mut self, htc: &Htc, burst: &Burst, report: &mut Report<'_>) {
        let Some(pney2) = &burst.pney2 else { return };
        let before = core::mem::replace(&mut self.waypoint, pney2.waypoint.clone());
        if htc.steering_mode != Some(SteeringMode::TrackControl) {
            self.turn = TurnEnd::None;
            return;
        }
        let Some(now) = &pney2.waypoint else {
            report.breach("TCS-1", "no waypoint while track control is commanded");
            return;
        };
        let changed = before.as_ref().is_some_and(|before| before != now) && !self.begun;
        let radius_went = htc.radius.is_none() && self.had_radius;
        self.had_radius = htc.radius.is_some();
        let text = |what: &str| {
            format!(
                "waypoint {what} ({} to {now})",
                before.as_deref().unwrap_or("none")
            )
        };
        self.turn = match (self.turn, changed, radius_went) {
            (TurnEnd::None, true, true) => TurnEnd::None,
            (TurnEnd::None, true, false) if htc.radius.is_some() => TurnEnd::WaypointFirst,
            (TurnEnd::None, false, true) => TurnEnd::RadiusFirst,
            (TurnEnd::None, true, false) => {
                report.breach("TCS-1", text("changes on a leg"));
                TurnEnd::None
            }
            (TurnEnd::None, false, false) => TurnEnd::None,
            (TurnEnd::WaypointFirst, _, true) => TurnEnd::None,
            (TurnEnd::WaypointFirst, _, false) => {
                report.breach("TCS-1", "the waypoint changed before the end of the turn");
                TurnEnd::None
            }
            (TurnEnd::RadiusFirst, true, _) => TurnEnd::None,
            (TurnEnd::RadiusFirst, false, _) => {
                report.breach(
                    "TCS-1",
                    "the waypoint does not change at the end of the turn",
                );
                TurnEnd::None
            }
        };
    }

    /// TCS-3: without a position the chart system ends track control itself.
    fn position(&mut self, htc: &Htc, burst: &Burst, report: &mut Report<'_>) {
        let invalid = burst
            .xte
            .as_ref()
            .is_some_and(|xte| xte.status == Some(DataStatus::Invalid));
        let tracking = htc.steering_mode == Some(SteeringMode::TrackControl);
        if !(invalid && tracking) {
            self.invalid_since = None;
            return;
        }
        let now = burst.at.unwrap_or(0.0);
        let since = *self.invalid_since.get_or_insert(now);
        if now - since > POSITION_S {
            self.invalid_since = Some(f64::MAX);
            report.breach(
                "TCS-3",
                "track control is commanded without a valid position",
            );
        }
    }
}

fn distance(burst: &Burst) -> Option<f64> {
    burst.xte.as_ref()?.cross_track
}

fn control(burst: &Burst) -> Option<f64> {
    burst.pney1.as_ref()?.cross_track
}

/// Where the ship is from the radius centre.
fn about_centre(burst: &Burst) -> Option<Point> {
    let centre: Position = burst.pney2.as_ref()?.centre?;
    let gll = burst.gll.as_ref()?;
    let position = gll
        .position
        .filter(|_| gll.status == Some(DataStatus::Valid))?;
    Some(Plane::at(centre).point(position))
}
