//! AutoNAV Ti: the track comes from the chart system, and is steered here (AP-2, AP-7, TCS-4, TCS-8).
//!
//! `followed` is what is sailed, `lay` how a command becomes a path.

mod followed;
mod lay;

use super::former::Former;
use super::need::{ENTRY, Need};
use super::state::{Listed, State, Told};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::autopilot::facts::{Facts, Outlook};
use crate::autopilot::steering::Demand;
use crate::command::Remote;
use crate::geo::Point;
use crate::nmea::{Htd, SteeringMode, TurnMode};
use crate::path::Path;
use crate::settings::Role;
use crate::time::Stamp;
use crate::units::{Course, Heading, Radius};
use alloc::string::String;
use alloc::vec::Vec;
pub use followed::AutonavTi;

/// Said while a turn is made without its centre.
const NO_CENTRE: &str = "PNEY,002 has no centre: the turn is made by leg, radius and place";

impl Listed for AutonavTi {
    const ROW: Row = Row {
        name: ModeName::AutonavTi,
        title: "AutoNAV Ti",
        what: "Track control: leg and arc of HTC mode T, XTE and PNEY are sailed along, corrected for current and offset.",
        role: Role::Operator,
        entry: ENTRY,
        needs: &[
            Need::Heading,
            Need::MeasuredSpeed,
            Need::Command,
            Need::ShipConstants,
            Need::Position,
            Need::Differential,
            Need::CrossTrack,
            Need::ControlDistance,
            Need::Leg,
            Need::Centre,
            Need::OnePosition,
            Need::Agreement,
        ],
        on_loss: OnLoss::TrackFail,
        limit: Limit::Max,
        htd: Some(SteeringMode::TrackControl),
        commanded: Some("track controlled by the chart system"),
        steers: "",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        let (north, east) = (Course::from_deg(0.0), Course::from_deg(90.0));
        let radius = Radius::from_nm(1.0);
        let turn = |ahead: f64| {
            let centre = Point {
                north: ahead,
                east: radius.m(),
            };
            Path::turn(north, centre, radius, east)
        };
        let on = |path| Self::on(Stamp(0), path, None);
        alloc::vec![
            (
                "AutoNAV Ti on a leg",
                on(Path::leg(Point::default(), north))
            ),
            ("AutoNAV Ti before the arc", on(turn(3_000.0))),
            ("AutoNAV Ti in the arc", on(turn(-500.0))),
        ]
    }
}

impl State for AutonavTi {
    fn demand(&mut self, _: &Facts<'_>) -> Option<Demand> {
        Some(Demand::Track(self.path))
    }

    fn hts(&self, facts: &Facts<'_>) -> Option<Heading> {
        Some(match &facts.steered {
            Some(steered) => steered.hts,
            None => self.path.course_in.as_heading(),
        })
    }

    fn former(&self) -> Option<Former> {
        Some(Former::Autonav)
    }

    fn htd(&self, facts: &Facts<'_>, htd: &mut Htd) {
        if self.path.turn.is_some() {
            htd.turn_mode = Some(TurnMode::Radius);
            let steered = facts.steered.as_ref();
            htd.rate_of_turn = steered.map(|steered| steered.rate_reference.abs().deg_per_min());
        }
        htd.radius = self.radius.map(Radius::nm);
        htd.heading_to_steer = self.hts(facts).map(Heading::deg);
        htd.track = Some(self.track.deg());
    }

    fn path(&self) -> Option<&Path> {
        Some(&self.path)
    }

    fn plane_m(&self) -> Option<f64> {
        // On very long legs only, and never in a turn.
        self.path.turn.is_none().then_some(60_000.0)
    }

    fn carry(&mut self, carry: &dyn Fn(Point) -> Point) {
        self.path.point = carry(self.path.point);
        self.leg.1 = carry(self.leg.1);
        if let Some((point, _)) = &mut self.wheel_over {
            *point = carry(*point);
        }
    }

    fn follow(&mut self, _: Stamp, command: Remote) {
        if let Remote::Track { radius, .. } = command {
            self.straight = match radius {
                Some(_) => 0,
                None => self.straight.saturating_add(1),
            };
        }
    }

    fn agree(&mut self, outlook: &Outlook<'_>, told: Told<'_>) -> Result<(), String> {
        match told.command {
            Some(Remote::Track { track, radius, .. }) => {
                self.lay(outlook, told.charted, (track, radius))
            }
            _ => Ok(()), // its age is watched
        }
    }

    fn agreed(&self) -> Option<Stamp> {
        Some(self.agreed)
    }

    fn makeshift(&self) -> Option<&'static str> {
        self.without_centre.then_some(NO_CENTRE)
    }

    /// A turn that was commanded but never laid is finished from leg, radius and the time of wheel-over (TCS-8).
    fn losing(&mut self, outlook: &Outlook<'_>, command: Option<Remote>) {
        if let Some(Remote::Track {
            track,
            radius: Some(radius),
            ..
        }) = command
        {
            self.lay_what_was_commanded(outlook, track, radius);
        }
    }

    fn has_left_the_track(&mut self, now: Stamp, off: Option<f64>, limit: f64) -> bool {
        self.off_track.watch(now, off, limit)
    }
}
