//! Whether what a mode needs is there: at its selection, and at every command that is followed (AP-6, AP-7).

use super::mode::{Mode, row};
use super::need::Need;
use super::part::Modes;
use super::table::ModeName;
use crate::autopilot::facts::Outlook;
use crate::autopilot::remote::Charted;
use crate::command::{ModeRequest, Refusal, Remote};
use crate::limits::Quantity;
use crate::settings::{Differential, SpeedSource};
use crate::units::Radius;
use alloc::format;

/// The mode that a command asks for; absent where it asks for no control.
pub(super) const fn mode_of(command: Remote) -> Option<ModeName> {
    match command {
        Remote::Heading { .. } => Some(ModeName::AutonavTn),
        Remote::Track { .. } => Some(ModeName::AutonavTi),
        Remote::Override | Remote::Stop(_) => None,
    }
}

impl Modes {
    /// The command in force.
    pub(super) fn command(&self, outlook: &Outlook<'_>) -> Option<Remote> {
        let ms = outlook.facts.settings.track_fail_ms();
        let commands = self.commands(outlook);
        commands.command(outlook.facts.now, ms).copied()
    }

    /// What the chart system says, in the own plane.
    pub(super) const fn charted<'a>(&'a self, outlook: &'a Outlook<'a>) -> Charted<'a> {
        Charted::of(outlook, &self.positions)
    }

    /// The mode that the chart system commands.
    pub(super) fn wanted(&self, outlook: &Outlook<'_>) -> Option<ModeName> {
        mode_of(self.command(outlook)?)
    }

    /// The radius of a turn that is commanded.
    fn commanded_radius(&self, outlook: &Outlook<'_>) -> Option<Radius> {
        match self.command(outlook)? {
            Remote::Track { radius, .. } => radius,
            _ => None,
        }
    }

    /// Whether a mode may be asked for now, or why not; STANDBY always (AP-25). A press and the page's button ask this one.
    pub(in super::super) fn may_select(
        &self,
        outlook: &Outlook<'_>,
        request: ModeRequest,
    ) -> Result<(), Refusal> {
        let mode = match request {
            ModeRequest::Standby | ModeRequest::Cancel => return Ok(()),
            ModeRequest::Auto => ModeName::Auto,
            ModeRequest::Autonav if self.mode.is_autonav() => {
                return Err(Refusal::because("AutoNAV is active already"));
            }
            ModeRequest::Autonav => self.pending_mode(outlook),
            ModeRequest::Track => return self.may_follow_the_plotter(outlook),
            // Asked for again, it is released.
            ModeRequest::Dodge if matches!(self.mode, Mode::Dodge(_)) => return Ok(()),
            ModeRequest::Dodge => ModeName::Dodge,
            ModeRequest::WindVane => ModeName::WindVane,
            ModeRequest::RiverPilot => ModeName::RiverPilot,
            ModeRequest::FfuOverride => ModeName::FfuOverride,
            ModeRequest::Installation => ModeName::Installation,
            ModeRequest::Autotuning => ModeName::Autotuning,
        };
        if request != ModeRequest::Auto && self.mode.name() == mode {
            let text = format!("{} is on already", self.mode.title());
            return Err(Refusal::because(text));
        }
        self.can_enter(outlook, mode)
    }

    /// What a pending selection will be; Ti until the chart system has said.
    pub(in super::super) fn pending_mode(&self, outlook: &Outlook<'_>) -> ModeName {
        self.wanted(outlook).unwrap_or(ModeName::AutonavTi)
    }

    /// Whether a mode may be entered now, or why not.
    pub(super) fn can_enter(&self, outlook: &Outlook<'_>, mode: ModeName) -> Result<(), Refusal> {
        if matches!(self.mode, Mode::Installation(_)) {
            return Err(Refusal::because("INSTALLATION is ended by STANDBY only"));
        }
        if let Some(fault) = outlook.motor
            && !matches!(mode, ModeName::Installation)
        {
            return Err(Refusal::because(fault.text()));
        }
        let entry = row(mode).map_or(&[][..], |row| row.entry);
        let lacks = entry.iter().find(|need| !self.has(outlook, **need, mode));
        lacks.map_or(Ok(()), |need| Err(Refusal::because(need.missing())))
    }

    /// AP-7: the first thing that is missing.
    pub(super) fn missing(&self, outlook: &Outlook<'_>, mode: ModeName) -> Option<&'static str> {
        let needs = row(mode).map_or(&[][..], |row| row.needs);
        let lacks = needs.iter().find(|need| !self.has(outlook, **need, mode));
        lacks.map(|need| need.missing())
    }

    /// Whether a need of a mode is met.
    pub(super) fn has(&self, outlook: &Outlook<'_>, need: Need, mode: ModeName) -> bool {
        let (seen, sight) = (outlook.seen, outlook.sight);
        let charted = self.charted(outlook);
        match need {
            Need::Enabled => outlook.facts.settings.external_tcs,
            Need::InAuto | Need::AutoFirst => matches!(self.mode, Mode::Auto(_)),
            Need::SpeedSource => {
                !self.speed_by_hand && outlook.facts.settings.speed_source != SpeedSource::Manual
            }
            Need::TrueHeading => !sight.is_magnetic(),
            Need::NoOverride => self.command(outlook) != Some(Remote::Override),
            Need::LegKnown => self.commanded_radius(outlook).is_none(),
            Need::Heading => sight.heading().is_some(),
            Need::HeadingOrRate => sight.heading().is_some() || sight.has_rate(),
            Need::InStandby => matches!(self.mode, Mode::Standby(_)),
            Need::AutoSteers => matches!(self.mode, Mode::Auto(auto) if auto.finish.is_none()),
            Need::SteadySpeed => self.speed.lasts(seen.now),
            Need::Dodgeable => self.mode.state().former().is_some(),
            Need::Wind => sight.wind(!outlook.facts.settings.wind_true).is_some(),
            Need::MeasuredSpeed => {
                sight.over_ground(seen).is_some() || seen.water_speed().is_some()
            }
            Need::Command => self.wanted(outlook) == Some(mode),
            Need::ShipConstants => outlook.ship.known,
            Need::Position => {
                let fix = seen.picture.fix(seen.now);
                sight.place(seen.now).is_some() && seen.fresh(fix, Quantity::Position).is_some()
            }
            Need::Differential => {
                let required = outlook.facts.settings.differential == Differential::Required;
                !required || sight.is_corrected()
            }
            Need::CrossTrack => charted.has_xte(),
            Need::ControlDistance => charted.pney1().is_some(),
            Need::Leg => (charted.pney1()).is_some_and(|said| said.cross_track.is_some()),
            Need::Centre => charted.has_pney2(),
            Need::OnePosition => charted.positions_agree().is_ok(),
            Need::Plotted => self.proven_leg(outlook).is_some(),
            // Watched from when the mode is entered: what disagrees then is not followed.
            Need::Agreement => true,
        }
    }
}
