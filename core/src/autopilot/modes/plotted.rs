//! Following a plotter: each APB is taken or refused, TRACK begins on one that is proven, and its waypoints are said (AP-14).

use super::event::{Cause, Event};
use super::mode::Mode;
use super::need::Need;
use super::part::Modes;
use super::table::ModeName;
use super::track::Track;
use crate::alerts::Alert;
use crate::autopilot::facts::Outlook;
use crate::autopilot::notices::Notices;
use crate::autopilot::plotter::{Leg, Unfollowed};
use crate::command::Refusal;
use crate::nmea::Sentence;
use crate::picture::Source;
use crate::station::PortIndex;
use alloc::format;
use alloc::string::String;

impl Modes {
    /// An APB was heard on a port that may say it.
    pub(in super::super) fn on_apb(
        &mut self,
        outlook: &Outlook<'_>,
        port: PortIndex,
        sentence: &Sentence<'_>,
        notices: &mut Notices,
    ) {
        let (now, picture) = (outlook.facts.now, outlook.seen.picture);
        let source = Source {
            port,
            talker: sentence.talker().into(),
            formatter: "APB".into(),
        };
        let fresh = outlook.facts.settings.track_fail_ms();
        // FB13: the first keeps the authority while it is fresh; the other is shown and never followed.
        if let Some(holder) = self.plotter.apb.other_holder(now, &source, fresh) {
            let text = format!(
                "APB SOURCE CONFLICT: {} is followed, {} says another and is not",
                picture.source_name(holder),
                picture.source_name(&source)
            );
            notices.raise(Alert::ApbConflict, text);
            return;
        }
        let heard = self.plotter.on_apb(outlook, source, sentence);
        if let (Err(Unfollowed::NotValid(why)), Mode::Track(_)) = (heard, &self.mode) {
            let text = format!("APB: {why}");
            self.track_fail(outlook, Cause::Missing, &text, notices);
        }
    }

    /// Another sentence of the leg was heard, which APB is held against.
    pub(in super::super) fn on_plotted(
        &mut self,
        outlook: &Outlook<'_>,
        port: PortIndex,
        sentence: &Sentence<'_>,
    ) {
        self.plotter.on_other(outlook.facts.now, port, sentence);
    }

    /// An APB that the port's policy does not accept breaks the row (FA14, SEN-2).
    pub(in super::super) fn on_broken_apb(&mut self, outlook: &Outlook<'_>) {
        self.plotter.apb.disprove();
        let why = "APB refused: checksum missing or wrong";
        self.plotter.apb.refuse(outlook.facts.now, why.into());
    }

    /// The leg in force, after several valid ones in a row (FA14).
    pub(super) fn proven_leg<'a>(&'a self, outlook: &Outlook<'_>) -> Option<&'a Leg> {
        let proven = self.plotter.apb.is_proven(outlook.facts.now);
        self.plotter.in_force(outlook).filter(|_| proven)
    }

    /// Whether TRACK may be asked for; where an APB is refused, why it is.
    pub(super) fn may_follow_the_plotter(&self, outlook: &Outlook<'_>) -> Result<(), Refusal> {
        if matches!(self.mode, Mode::Track(_)) {
            return Err(Refusal::because("TRACK is active already"));
        }
        let refused = self.plotter.apb.refused();
        self.can_enter(outlook, ModeName::Track)
            .map_err(|missing| match refused {
                Some(refused) if missing.text == Need::Plotted.missing() => {
                    Refusal::because(refused)
                }
                _ => missing,
            })
    }

    /// The operator selects TRACK.
    pub(super) fn follow_the_plotter(
        &mut self,
        outlook: &Outlook<'_>,
        notices: &mut Notices,
    ) -> Result<String, Refusal> {
        self.may_follow_the_plotter(outlook)?;
        let Some(leg) = self.proven_leg(outlook) else {
            return Err(Refusal::because(Need::Plotted.missing()));
        };
        let to = match leg.waypoint.as_str() {
            "" => String::new(),
            waypoint => format!(" to {waypoint}"),
        };
        let text = format!("TRACK{to} on {:05.1}", leg.course.deg());
        let event = Event::EngageTrack(Track::on(leg, outlook.facts.heading));
        notices.rectify(Alert::TrackFail);
        self.apply(&outlook.facts, &event, "operator selected TRACK");
        Ok(text)
    }

    /// AP-14: a waypoint that is reached is said until another one is followed.
    pub(super) fn watch_waypoints(&self, outlook: &Outlook<'_>, notices: &mut Notices) {
        let followed = matches!(self.mode, Mode::Track(_));
        let leg = self.plotter.in_force(outlook).filter(|_| followed);
        let reached = leg.filter(|leg| leg.arrived).map(|leg| {
            format!(
                "Waypoint {} is reached: check that the plotter goes on to the next",
                leg.waypoint
            )
        });
        notices.tell(Alert::Arrival, reached);
        let ms = outlook.facts.settings.track_fail_ms();
        if !self.plotter.apb.in_conflict(outlook.facts.now, ms) {
            notices.rectify(Alert::ApbConflict);
        }
    }
}
