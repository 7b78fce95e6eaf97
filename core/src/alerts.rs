//! Alerts by IEC 62923: one table of numbers and texts, one state machine (AP-11, FA15, DSP-5).

use crate::time::Stamp;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::cmp::Reverse;
use serde::{Deserialize, Serialize};

/// Priority, highest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Priority {
    /// Needs immediate attention and action.
    Alarm,
    /// Needs immediate attention, not yet action.
    Warning,
    /// Needs attention out of the ordinary.
    Caution,
}

/// State of an alert (IEC 62923-1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// Raised, nobody has taken it: flashing and sounding.
    Unacknowledged,
    /// Raised, silent for 30 s.
    Silenced,
    /// Raised and taken.
    Acknowledged,
    /// Raised, answered for by another system.
    Transferred,
    /// Over, but nobody has taken it.
    RectifiedUnacknowledged,
    /// Not raised.
    Normal,
}

/// Where an alert may be acknowledged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Category {
    /// Only where its reason is shown.
    A,
    /// Anywhere.
    B,
}

/// One line of the alert table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Definition {
    /// Priority.
    pub priority: Priority,
    /// Where it may be acknowledged.
    pub category: Category,
    /// Title, at most 18 characters.
    pub title: &'static str,
    /// What happened and what to do.
    pub text: &'static str,
}

/// How long a silenced alert stays silent (MSC.302(87) 7.3.5).
pub const SILENCE_MS: u64 = 30_000;

macro_rules! alerts {
    ($($(#[$doc:meta])* $name:ident = $number:literal, $priority:ident, $category:ident, $title:literal, $text:literal;)*) => {
        /// Every alert this project raises.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        #[serde(rename_all = "snake_case")]
        pub enum Alert {
            $($(#[$doc])* $name = $number,)*
        }
        impl Alert {
            /// All alerts, in the order of their numbers.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];
            /// Its line of the table.
            #[must_use]
            pub const fn definition(self) -> Definition {
                match self {
                    $(Self::$name => Definition {
                        priority: Priority::$priority, category: Category::$category, title: $title, text: $text,
                    },)*
                }
            }
        }
    };
}

alerts! {
    /// TCS-8: the chart system's control is lost.
    TrackFail = 101, Alarm, B, "TRACK FAIL", "Track control lost";
    /// TCS-8: the chart system's sentences are late.
    TrackDataLate = 102, Caution, B, "TRACK DATA LATE", "The chart system's sentences are late. Check the chart system";
    /// FB13: two sources command.
    HtcConflict = 103, Alarm, B, "HTC CONFLICT", "HTC SOURCE CONFLICT: two sources command. Silence one of them";
    /// SEN-5, TCS-4: what the chart system says is refused.
    TrackDataRefused = 104, Caution, B, "TRACK DATA REFUSED", "The chart system's command is refused. Check the chart system";
    /// FA7: no usable heading.
    HeadingLost = 110, Alarm, B, "HEADING LOST", "No usable heading. Rudder held: steer by hand";
    /// FA8: a heading jumped and was rejected.
    HeadingJump = 111, Caution, B, "HEADING JUMP", "The heading jumped and is not used. Check the gyro";
    /// AP-5: off the set heading.
    OffHeading = 112, Warning, B, "OFF HEADING", "The ship is off the set heading. Check speed, rudder and limits";
    /// FA8: a heading stands still while the ship turns.
    HeadingStuck = 113, Caution, B, "HEADING STUCK", "The heading stands still while the ship turns. Check the compass";
    /// AP-9: another compass is in use.
    HeadingSource = 114, Caution, B, "HEADING SOURCE", "Another compass is in use. Check the compasses";
    /// MSC.74(69) A2 5.3.6: off the track.
    OffTrack = 115, Alarm, B, "OFF TRACK", "The ship is off the track. Check track, speed and rudder";
    /// AP-10: two compasses are farther apart than is set.
    HeadingDifference = 116, Warning, B, "HDG DIFF", "Two compasses are apart. Find out which is right";
    /// FA9: a position jumped and was rejected.
    PositionJump = 120, Caution, B, "POSITION JUMP", "A position is off the dead reckoning and is not used. Check the receiver";
    /// AP-7: the position is not corrected.
    NoDifferential = 121, Caution, B, "NO DGPS", "The position is without differential correction";
    /// AP-9: no measured speed; the cruise speed is used.
    SpeedLost = 122, Caution, B, "SPEED LOST", "No measured speed. The set cruise speed is used for the gains";
    /// AP-9: another position source is in use.
    PositionSource = 123, Caution, B, "POSITION SOURCE", "Another position source is in use. Check the receivers";
    /// AP-9: another speed source is in use.
    SpeedSource = 124, Caution, B, "SPEED SOURCE", "Another speed source is in use. Check log and receivers";
    /// AP-9: the rate of turn is calculated, though a sensor says one.
    RateOfTurn = 125, Caution, B, "RATE OF TURN", "The measured rate of turn is not used. Check its sensor";
    /// FA10: too slow to answer the rudder.
    LowSpeed = 126, Alarm, B, "LOW SPEED", "The speed is below the minimum: the ship hardly answers her rudder";
    /// AP-20: nobody gave the ship's constants.
    ShipUnknown = 131, Caution, B, "SHIP CONSTANTS", "The ship's constants were not given: cautious steering, no track control";
    /// AP-4, FA11: feedback invalid or off the order.
    Rudder = 130, Alarm, B, "RUDDER", "The rudder does not follow its order or has no feedback. Steer by hand";
    /// HTC-1: override reported by the chart system.
    Override = 140, Alarm, B, "OVERRIDE", "Override is in use. STANDBY: select a mode when it has ended";
    /// FA16: the control loop stalled.
    Stalled = 150, Warning, B, "CONTROL STALLED", "The control loop was late. All inputs wait to be heard again";
    /// TCS-11: a course change comes.
    CourseChange = 201, Caution, B, "COURSE CHANGE", "Early course change indication: the wheel-over line comes near";
    /// TCS-11: a course change is imminent.
    CourseChangeSoon = 202, Warning, B, "WHEEL OVER SOON", "The wheel-over line is 30 s ahead";
    /// TCS-11: wheel over.
    WheelOver = 203, Alarm, B, "WHEEL OVER", "Wheel-over line passed: the ship turns. Acknowledge";
    /// TCS-11: nobody confirmed the course change.
    BackupNavigator = 204, Alarm, B, "BACKUP NAVIGATOR", "The course change was not confirmed within 30 s";
    /// TCS-11: the last waypoint comes.
    LastWaypoint = 205, Warning, B, "LAST WAYPOINT", "The end of the route comes near: track control will end";
    /// TCS-11: outside the corridor.
    CrossTrack = 206, Alarm, B, "CROSS TRACK", "The ship is outside the limits of the leg";
    /// TCS-3: the chart system has no position.
    ChartPositionLost = 207, Alarm, B, "NO POSITION", "The chart system has no valid position. Track control is refused or ended";
    /// TCS-13: the autopilot has left the chart system's control or is silent.
    AutopilotLeft = 208, Alarm, B, "AUTOPILOT LEFT", "The autopilot has left the chart system's control. Check who steers";
}

impl Alert {
    /// Its number in ALR and in the page.
    #[must_use]
    pub const fn number(self) -> u16 {
        self as u16
    }

    /// The alert of a number.
    #[must_use]
    pub fn of_number(number: u16) -> Option<Self> {
        Self::ALL
            .iter()
            .copied()
            .find(|alert| alert.number() == number)
    }
}

/// An alert that is not normal.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Standing {
    /// Which.
    pub alert: Alert,
    /// Its state by IEC 62923.
    pub state: State,
    /// What happened this time; empty where the table's text says it.
    pub detail: String,
    /// When the state last changed.
    pub at: Stamp,
    silent_until: Stamp,
}

impl Standing {
    /// What happened and what to do.
    #[must_use]
    pub fn text(&self) -> &str {
        if self.detail.is_empty() {
            self.alert.definition().text
        } else {
            &self.detail
        }
    }

    /// Where it stands in a list, lowest first (DSP-5): seven levels, what nobody has taken before what was taken and
    /// within that by priority, cautions last; within a level the newest first.
    #[must_use]
    pub const fn rank(&self) -> (u8, Reverse<Stamp>) {
        let level = match (self.alert.definition().priority, self.state) {
            (Priority::Alarm, State::Unacknowledged | State::Silenced) => 1,
            (Priority::Alarm, State::RectifiedUnacknowledged) => 2,
            (Priority::Warning, State::Unacknowledged | State::Silenced) => 3,
            (Priority::Warning, State::RectifiedUnacknowledged) => 4,
            (Priority::Alarm, State::Acknowledged | State::Transferred | State::Normal) => 5,
            (Priority::Warning, State::Acknowledged | State::Transferred | State::Normal) => 6,
            (Priority::Caution, _) => 7,
        };
        (level, Reverse(self.at))
    }
}

/// The alerts of one station.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Alerts {
    active: Vec<Standing>,
    changed: Vec<Alert>,
}

impl Alerts {
    /// Raises an alert, or gives a raised one a new detail. Nothing else changes while it lasts.
    pub fn raise(&mut self, now: Stamp, alert: Alert, detail: &str) {
        let caution = alert.definition().priority == Priority::Caution;
        let state = if caution {
            State::Acknowledged
        } else {
            State::Unacknowledged
        };
        match self.active.iter_mut().find(|active| active.alert == alert) {
            Some(active) if active.state != State::RectifiedUnacknowledged => {
                if active.detail != detail {
                    active.detail = detail.to_string();
                }
            }
            Some(active) => {
                *active = Standing {
                    alert,
                    state,
                    detail: detail.to_string(),
                    at: now,
                    silent_until: now,
                };
                self.note(alert);
            }
            None => {
                self.active.push(Standing {
                    alert,
                    state,
                    detail: detail.to_string(),
                    at: now,
                    silent_until: now,
                });
                self.active
                    .sort_by_key(|active| (active.alert.definition().priority, active.alert));
                self.note(alert);
            }
        }
    }

    /// Gives a raised alert a better text.
    pub fn retext(&mut self, alert: Alert, detail: &str) {
        if let Some(active) = self.active.iter_mut().find(|active| active.alert == alert) {
            active.detail = detail.to_string();
        }
    }

    /// Raises or rectifies an alert as `condition` says.
    pub fn set(&mut self, now: Stamp, alert: Alert, condition: bool, detail: &str) {
        if condition {
            self.raise(now, alert, detail);
        } else {
            self.rectify(now, alert);
        }
    }

    /// Raises an alert with what happened, or rectifies it where nothing did.
    pub fn tell(&mut self, now: Stamp, alert: Alert, happened: Option<String>) {
        match happened {
            Some(detail) => self.raise(now, alert, &detail),
            None => self.rectify(now, alert),
        }
    }

    /// The condition is over: gone if it was taken, else kept until it is.
    pub fn rectify(&mut self, now: Stamp, alert: Alert) {
        let Some(index) = self.active.iter().position(|active| active.alert == alert) else {
            return;
        };
        match self.active[index].state {
            State::Unacknowledged | State::Silenced => {
                self.active[index].state = State::RectifiedUnacknowledged;
                self.active[index].at = now;
                self.note(alert);
            }
            State::Acknowledged | State::Transferred => {
                self.active.remove(index);
                self.note(alert);
            }
            State::RectifiedUnacknowledged | State::Normal => {}
        }
    }

    /// Acknowledges by number. False where there is nothing to acknowledge.
    pub fn acknowledge(&mut self, now: Stamp, number: u16) -> bool {
        let Some(index) = self
            .active
            .iter()
            .position(|active| active.alert.number() == number)
        else {
            return false;
        };
        let alert = self.active[index].alert;
        match self.active[index].state {
            State::Unacknowledged | State::Silenced => {
                self.active[index].state = State::Acknowledged;
                self.active[index].at = now;
            }
            State::RectifiedUnacknowledged => {
                self.active.remove(index);
            }
            State::Acknowledged | State::Transferred | State::Normal => return false,
        }
        self.note(alert);
        true
    }

    /// Silences everything that sounds, for 30 s.
    pub fn silence(&mut self, now: Stamp) {
        for index in 0..self.active.len() {
            if self.active[index].state == State::Unacknowledged {
                self.active[index].state = State::Silenced;
                self.active[index].silent_until = now + SILENCE_MS;
            }
        }
    }

    /// Lets everything that was silenced sound again at once.
    pub fn sound_again(&mut self) {
        for active in &mut self.active {
            if active.state == State::Silenced {
                active.state = State::Unacknowledged;
            }
        }
    }

    /// Lets what was silenced sound again after 30 s (FA15).
    pub fn tick(&mut self, now: Stamp) {
        for active in &mut self.active {
            if active.state == State::Silenced && now >= active.silent_until {
                active.state = State::Unacknowledged;
            }
        }
    }

    /// State of an alert.
    #[must_use]
    pub fn state(&self, alert: Alert) -> State {
        self.active
            .iter()
            .find(|active| active.alert == alert)
            .map_or(State::Normal, |active| active.state)
    }

    /// Whether the alert's condition holds.
    #[must_use]
    pub fn raised(&self, alert: Alert) -> bool {
        !matches!(
            self.state(alert),
            State::Normal | State::RectifiedUnacknowledged
        )
    }

    /// When the alert last changed.
    #[must_use]
    pub fn changed_at(&self, alert: Alert) -> Option<Stamp> {
        self.active
            .iter()
            .find(|active| active.alert == alert)
            .map(|active| active.at)
    }

    /// Alerts whose state changed since the last call, for ALR.
    pub fn take_changed(&mut self) -> Vec<Alert> {
        core::mem::take(&mut self.changed)
    }

    /// All alerts that are not normal, highest first.
    #[must_use]
    pub fn standing(&self) -> &[Standing] {
        &self.active
    }

    fn note(&mut self, alert: Alert) {
        if !self.changed.contains(&alert) {
            self.changed.push(alert);
        }
    }
}

#[cfg(test)]
mod tests;
