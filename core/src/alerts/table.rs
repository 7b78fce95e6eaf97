//! The table of alerts: number, priority, category, title, what happened and what to do (AP-11).

use crate::station::Role;
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

/// Where an alert may be acknowledged (IEC 62923-1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Category {
    /// Only where its reason is shown: at the station itself, or at a chart system; never at a bridge alert management.
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
    /// FB13: two sources say where TRACK should go.
    ApbConflict = 105, Alarm, B, "APB CONFLICT", "APB SOURCE CONFLICT: two sources say APB. Silence one of them";
    /// AP-14: the waypoint of TRACK is reached.
    Arrival = 106, Caution, B, "WAYPOINT ARRIVAL", "The waypoint is reached. Check that the plotter goes on to the next";
    /// FB13: two sources command by HSC.
    HscConflict = 107, Alarm, B, "HSC CONFLICT", "HSC SOURCE CONFLICT: two sources command. Silence one of them";
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
    OffTrack = 115, Alarm, A, "OFF TRACK", "The ship is off the track. Check track, speed and rudder";
    /// AP-10: two compasses are farther apart than is set.
    HeadingDifference = 116, Warning, B, "HDG DIFF", "Two compasses are apart. Find out which is right";
    /// AP-21: RIVER PILOT without a heading.
    NoHeading = 117, Caution, B, "NO HEADING", "No usable heading: RIVER PILOT goes on by the measured rate of turn. Check the compasses";
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
    /// AP-21: the wind of WIND VANE is lost.
    WindLost = 127, Alarm, B, "WIND LOST", "No wind is heard: AUTO holds the present heading. Check the wind sensor";
    /// AP-7: AutoNAV was selected with a speed entered by hand.
    ChangeSpeedSource = 128, Warning, B, "CHANGE SPEED SRC", "CHANGE SPEED SOURCE: no AutoNAV by a speed entered by hand. Select STANDBY and set speed_source to automatic";
    /// AP-20: nobody gave the ship's constants.
    ShipUnknown = 131, Caution, B, "SHIP CONSTANTS", "The ship's constants were not given: cautious steering, no track control";
    /// AP-4, FA11: feedback invalid or off the order.
    Rudder = 130, Alarm, B, "RUDDER", "The rudder does not follow its order or has no feedback. Steer by hand";
    /// AP-4, FA11: the same of the port rudder of an independent pair.
    RudderPort = 132, Alarm, B, "RUDDER PORT", "The port rudder does not follow its order or has no feedback";
    /// FA11: the motor that turns the rudder stands, and why.
    Motor = 133, Alarm, B, "RUDDER MOTOR", "The motor does not turn the rudder. Steer by hand";
    /// HTC-1: override reported by the chart system.
    Override = 140, Alarm, B, "OVERRIDE", "Override is in use. STANDBY: select a mode when it has ended";
    /// AP-22: what the steering stand says cannot be read.
    Stand = 141, Warning, B, "STEERING STAND", "The steering stand cannot be read. Check stand and line";
    /// FA16: the control loop stalled.
    Stalled = 150, Warning, B, "CONTROL STALLED", "The control loop was late. All inputs wait to be heard again";
    /// FB8, FD9: a port's device is gone.
    PortFail = 151, Caution, B, "PORT FAIL", "A port is gone. Check plug and device";
    /// FB10: nothing valid comes on a port.
    NoSentence = 152, Caution, B, "NO VALID SENTENCE", "No valid sentence comes on a port. Check line, baud rate and device";
    /// FA15: an alarm that nobody took.
    BackupCalled = 160, Alarm, B, "BACKUP NAVIGATOR", "An alarm was not acknowledged within 30 s. Acknowledge it";
    /// AP-11: the other side's heartbeat is not heard any more.
    HeartbeatLost = 161, Warning, B, "HEARTBEAT LOST", "No heartbeat is heard any more. Check alert management and line";
    /// TCS-11: a course change comes.
    CourseChange = 201, Caution, B, "COURSE CHANGE", "Early course change indication: the wheel-over line comes near";
    /// TCS-11: a course change is imminent.
    CourseChangeSoon = 202, Warning, B, "WHEEL OVER SOON", "The wheel-over line is 30 s ahead";
    /// TCS-11: wheel over.
    WheelOver = 203, Alarm, B, "WHEEL OVER", "Wheel-over line passed: the ship turns. Acknowledge";
    /// TCS-11, FA15: nobody confirmed the course change, or took an alarm.
    BackupNavigator = 204, Alarm, B, "BACKUP NAVIGATOR", "An alarm or the course change was not confirmed within 30 s";
    /// TCS-11: the last waypoint comes.
    LastWaypoint = 205, Warning, B, "LAST WAYPOINT", "The end of the route comes near: track control will end";
    /// TCS-11: outside the corridor.
    CrossTrack = 206, Alarm, A, "CROSS TRACK", "The ship is outside the limits of the leg";
    /// TCS-3: the chart system has no position.
    ChartPositionLost = 207, Alarm, B, "NO POSITION", "The chart system has no valid position. Track control is refused or ended";
    /// TCS-13: the autopilot has left the chart system's control or is silent.
    AutopilotLeft = 208, Alarm, B, "AUTOPILOT LEFT", "The autopilot has left the chart system's control. Check who steers";
    /// TCS-13: the other side's heartbeat is not heard any more.
    ChartHeartbeatLost = 209, Warning, B, "HEARTBEAT LOST", "No heartbeat is heard any more. Check alert management and line";
    /// TCS-14: control goes on by dead reckoning; said anew each two minutes.
    ManualSteering = 210, Alarm, B, "MANUAL STEERING", "Control goes on by dead reckoning. Use manual steering";
    /// FB8, FD9: a port's device is gone.
    ChartPortFail = 211, Caution, B, "PORT FAIL", "A port is gone. Check plug and device";
    /// FB10: nothing valid comes on a port.
    ChartNoSentence = 212, Caution, B, "NO VALID SENTENCE", "No valid sentence comes on a port. Check line, baud rate and device";
}

/// Proprietary alerts have identifiers from here on (IEC 61162-1 ALF; F2: 10001 to 10999).
const PROPRIETARY: u32 = 10_000;
/// Alerts from this number on are the chart system's.
const CHART_SYSTEM: u16 = 200;

impl Alert {
    /// Its number in ALR, ALA and the page.
    #[must_use]
    pub const fn number(self) -> u16 {
        self as u16
    }

    /// The alert of a number.
    #[must_use]
    pub fn of_number(number: u16) -> Option<Self> {
        let mut all = Self::ALL.iter().copied();
        all.find(|alert| alert.number() == number)
    }

    /// Its identifier in ALF, ALC, ARC and ACN: ten thousand more than its number, as a proprietary alert has it.
    #[must_use]
    pub const fn identifier(self) -> u32 {
        PROPRIETARY + self.number() as u32
    }

    /// The alert of an identifier.
    #[must_use]
    pub fn of_identifier(identifier: u32) -> Option<Self> {
        let number = identifier.checked_sub(PROPRIETARY)?;
        Self::of_number(u16::try_from(number).ok()?)
    }

    /// The station that raises it.
    #[must_use]
    pub const fn station(self) -> Role {
        if self.number() < CHART_SYSTEM {
            Role::Autopilot
        } else {
            Role::ChartSystem
        }
    }

    /// All alerts of a station, in the order of their numbers.
    pub fn of(station: Role) -> impl Iterator<Item = Self> {
        let all = Self::ALL.iter().copied();
        all.filter(move |alert| alert.station() == station)
    }

    /// Whether it calls the back-up navigator, and so calls for nobody else.
    #[must_use]
    pub const fn calls_backup(self) -> bool {
        matches!(self, Self::BackupCalled | Self::BackupNavigator)
    }
}
