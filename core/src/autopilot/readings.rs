//! What can be read of the autopilot: its mode and why, what it steers, what it has heard.

use super::facts::Outlook;
use super::gear::Steered;
use super::sight::Refused;
use super::times::Timer;
use super::{Autopilot, Mode, ModeName};
use crate::alerts::{Alert, Alerts, Standing};
use crate::command::{ModeRequest, Refusal};
use crate::facts::Quantity;
use crate::geo::Position;
use crate::path::Part;
use crate::picture::{Picture, Source};
use crate::settings::Settings;
use crate::station::PortIndex;
use crate::time::Stamp;
use crate::units::{Course, Distance, Heading, RudderAngle, Speed};
use alloc::string::String;
use alloc::vec::Vec;

impl Autopilot {
    /// All that is known at `now`.
    fn outlook(&self, now: Stamp) -> Outlook<'_> {
        Outlook::at(
            now,
            &self.post,
            &self.sight,
            &self.steering,
            (&self.gear, self.turned.prevents()),
            &self.settings,
        )
    }

    /// How often the motor that turns the rudder has started; 0 where none does.
    #[must_use]
    pub const fn motor_starts(&self) -> u64 {
        self.turned.starts()
    }

    /// Heading to steer in force.
    #[must_use]
    pub fn hts(&self) -> Option<Heading> {
        self.modes.mode().state().hts(&self.outlook(self.now).facts)
    }

    /// Whether a mode may be asked for now, or why not; STANDBY always (AP-25). A press and the page's button ask this one.
    ///
    /// # Errors
    /// The first need that the selection is refused without, in an officer's words (AP-6).
    pub fn may_select(&self, now: Stamp, request: ModeRequest) -> Result<(), Refusal> {
        self.modes.may_select(&self.outlook(now), request)
    }

    /// What a pending selection still waits for, in an officer's words.
    #[must_use]
    pub fn waits_for(&self, now: Stamp) -> String {
        self.modes.waits_for(&self.outlook(now))
    }

    /// What a pending selection will be; Ti until the chart system has said.
    #[must_use]
    pub fn pending_mode(&self, now: Stamp) -> ModeName {
        self.modes.pending_mode(&self.outlook(now))
    }

    /// What an alert says. TRACK FAIL tells what steers now, so it changes with the mode.
    #[must_use]
    pub fn text_of(&self, standing: &Standing) -> String {
        self.modes.text_of(standing)
    }

    /// Farther off the track is an alarm, metres: by the corridor that HTC gives, else by the setting.
    #[must_use]
    pub fn off_track_limit(&self, now: Stamp) -> f64 {
        self.modes.off_track_limit(&self.outlook(now))
    }

    /// Cross-track distance from what is sailed, ship right of it positive: in track control and in TRACK.
    #[must_use]
    pub fn cross_track(&self) -> Option<Distance> {
        let facts = self.outlook(self.now).facts;
        self.modes.mode().state().cross_track(&facts)
    }

    /// Where the ship is on the commanded path.
    #[must_use]
    pub fn part(&self, now: Stamp) -> Option<Part> {
        let path = self.modes.mode().state().path()?;
        Some(path.progress(self.sight.place(now)?).part)
    }

    /// The picture of what is heard and sent.
    #[must_use]
    pub fn picture(&self) -> &Picture {
        &self.post.picture
    }

    /// Until when an AutoNAV selection waits for its confirmation.
    #[must_use]
    pub const fn pending(&self) -> Option<Stamp> {
        self.modes.pending()
    }

    /// Why the mode is what it is: last refusal or cause, in an officer's words.
    #[must_use]
    pub fn why(&self) -> &str {
        self.modes.why()
    }

    /// What the steering gave in the last step; absent where no order was computed.
    #[must_use]
    pub const fn steered(&self) -> Option<&Steered> {
        self.gear.steered()
    }

    /// Its alerts.
    #[must_use]
    pub fn alerts(&self) -> &Alerts {
        self.alerts.standing()
    }

    /// Why nothing valid comes on a port, where nothing does, in an officer's words; and how many valid sentences came there
    /// that the dictionary does not know (FB10).
    #[must_use]
    pub fn port_state(&self, now: Stamp, port: PortIndex) -> (Option<String>, u64) {
        self.post.port_state(now, port)
    }

    /// Its settings.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Its mode.
    #[must_use]
    pub fn mode(&self) -> &Mode {
        self.modes.mode()
    }

    /// The heading that is believed: of the compass in use, or its prediction while that stands in; absent where none is.
    #[must_use]
    pub const fn believed_heading(&self) -> Option<Heading> {
        self.sight.heading()
    }

    /// Whether that heading is of magnetic north: no variation is known (AP-10).
    #[must_use]
    pub fn heading_is_magnetic(&self) -> bool {
        self.sight.is_magnetic()
    }

    /// When the sources were judged last, at the control step before this: what was heard then or later waits for the next.
    #[must_use]
    pub fn judged_at(&self) -> Stamp {
        let next = self.timers.at(Timer::Step).unwrap_or(self.now);
        Stamp(next.0.saturating_sub(self.settings.step_ms()))
    }

    /// The position that is believed: of the receiver in use, carried on; absent 5 s after its last good fix.
    #[must_use]
    pub fn believed_position(&self, now: Stamp) -> Option<Position> {
        self.sight.believed_position(now)
    }

    /// The compass in use.
    #[must_use]
    pub const fn compass_in_use(&self) -> Option<&Source> {
        self.sight.compass()
    }

    /// The receiver in use.
    #[must_use]
    pub const fn receiver_in_use(&self) -> Option<&Source> {
        self.sight.receiver()
    }

    /// Who says course and speed over ground; where they are calculated from positions, its formatter is C (AP-9).
    #[must_use]
    pub fn over_ground_from(&self, now: Stamp) -> Option<Source> {
        self.sight.over_ground_from(self.post.seen(now))
    }

    /// Course, where there is one, and speed over ground that are calculated from positions, since nothing measures them (AP-9).
    #[must_use]
    pub fn calculated_over_ground(&self, now: Stamp) -> Option<(Option<Course>, Speed)> {
        let ground = self.sight.over_ground(self.post.seen(now))?;
        (ground.calculated).then_some((ground.course, ground.speed))
    }

    /// The speed that the gains are made of (AP-7, AP-9, FA10).
    #[must_use]
    pub fn speed(&self) -> Speed {
        self.sight.speed(&self.settings)
    }

    /// Every source that is heard and not believed (AP-9, FA8, FA9, TCS-8).
    #[must_use]
    pub fn refused(&self) -> Vec<Refused<'_>> {
        let mut refused = self.sight.refused_places();
        let commands = (self.post.picture.pney1.as_ref())
            .filter(|_| self.alerts.raised(Alert::TrackDataRefused))
            .map(|heard| Refused {
                quantity: Quantity::Control,
                source: &heard.source,
                why: "does not fit",
            });
        refused.extend(commands);
        refused.extend(self.sight.refused_motions(self.post.seen(self.now)));
        refused
    }

    /// Name of a source as `port/talker/formatter`.
    #[must_use]
    pub fn source_name(&self, source: &Source) -> String {
        self.post.picture.source_name(source)
    }

    /// Rudder order in force; absent where none is given. Of a pair: of the single rudder that it is as good as (AP-4).
    #[must_use]
    pub fn rudder_order(&self) -> Option<RudderAngle> {
        self.modes.order(self.gear.order())
    }

    /// Orders in force to the single rudder or the starboard one of a pair, and to the port one.
    #[must_use]
    pub fn rudder_orders(&self) -> [Option<RudderAngle>; 2] {
        let given = self.modes.gives_orders();
        self.gear.orders().map(|order| order.filter(|_| given))
    }

    /// Rudder limit in force, degrees; in STANDBY the one that AUTO will have.
    #[must_use]
    pub const fn rudder_limit(&self) -> f64 {
        self.modes.limit(&self.settings)
    }
}
