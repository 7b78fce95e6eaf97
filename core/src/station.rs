//! What every station (autopilot, chart system, world) shares: ports, what goes in, what comes out.
//!
//! **Invariant:** stations exchange bytes only, never state.

use crate::command::{Order, Origin, Refusal};
use crate::settings::Value;

use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Which station.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// The simulated ship with her sensors and steering gear.
    World,
    /// The chart-system side.
    ChartSystem,
    /// The autopilot.
    #[default]
    Autopilot,
}

impl Role {
    /// All, in the order in which they run.
    pub const ALL: [Self; 3] = [Self::World, Self::ChartSystem, Self::Autopilot];

    /// Name in the configuration and in the stream.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::World => "world",
            Self::ChartSystem => "chart_system",
            Self::Autopilot => "autopilot",
        }
    }
}

/// Number of a port within its station, from 0.
pub type PortIndex = usize;

/// What is connected to a port; decides what it may say, what is sent on it and how often.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Profile {
    /// A chart system (on the autopilot's side), or an autopilot (on the chart system's side).
    Ecdis,
    /// First gyro compass.
    Gyro1,
    /// Second gyro compass.
    Gyro2,
    /// Transmitting heading device.
    Thd,
    /// Magnetic compass.
    Magn,
    /// Position receiver.
    Gps,
    /// Second position receiver.
    Gps2,
    /// Speed log.
    Log,
    /// Rate of turn sensor.
    Rot,
    /// Steering gear: takes rudder orders, gives rudder angles.
    Gear,
    /// Steering stand: who steers, by its selector and levers.
    Stand,
    /// Plotter: the route that TRACK follows, and what it is told.
    Plotter,
    /// Wind sensor.
    Wind,
    /// Inertial sensor of a small craft: heading, rate of turn, heel.
    Imu,
    /// Hand-held control unit.
    Hmi,
    /// Bridge alert management.
    Bams,
    /// A listener: shown, never used.
    Monitor,
}

impl Profile {
    /// All, in the order of the interface (section 3a).
    pub const ALL: [Self; 17] = [
        Self::Ecdis,
        Self::Gyro1,
        Self::Gyro2,
        Self::Thd,
        Self::Magn,
        Self::Gps,
        Self::Gps2,
        Self::Log,
        Self::Rot,
        Self::Gear,
        Self::Stand,
        Self::Plotter,
        Self::Wind,
        Self::Imu,
        Self::Hmi,
        Self::Bams,
        Self::Monitor,
    ];

    /// Name in the configuration, and of a port that is cabled inside.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ecdis => "ecdis",
            Self::Gyro1 => "gyro1",
            Self::Gyro2 => "gyro2",
            Self::Thd => "thd",
            Self::Magn => "magn",
            Self::Gps => "gps",
            Self::Gps2 => "gps2",
            Self::Log => "log",
            Self::Rot => "rot",
            Self::Gear => "gear",
            Self::Stand => "stand",
            Self::Plotter => "plotter",
            Self::Wind => "wind",
            Self::Imu => "imu",
            Self::Hmi => "hmi",
            Self::Bams => "bams",
            Self::Monitor => "monitor",
        }
    }
}

/// Which sentences of a port are believed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ChecksumPolicy {
    /// Only sentences with a right checksum.
    Required,
    /// Once a right checksum was heard, only such sentences.
    Learned,
    /// A missing checksum is accepted, a wrong one is not. Never on a port that commands.
    Optional,
}

/// One port of a station, as configured.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct PortSetup {
    /// Unique name; sources are written `port/talker/formatter`.
    pub name: String,
    /// What is connected.
    pub profile: Profile,
    /// Which sentences are believed.
    pub checksum: ChecksumPolicy,
    /// Whose sentences alone are believed, by talker; anybody's where it is empty. Proprietary ones have none (SEN-3).
    pub talkers: Vec<String>,
    /// Line rate in baud, for the load on the line; 0 where there is none.
    pub baud: u32,
    /// Whether anything may leave by this port.
    pub output: bool,
}

impl PortSetup {
    /// Whether a talker may be believed here (SEN-3).
    #[must_use]
    pub fn listens_to(&self, talker: &str) -> bool {
        self.talkers.is_empty() || talker == "P" || self.talkers.iter().any(|t| t == talker)
    }
}

/// Direction of a line, as the station of the port sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Direction {
    /// Heard.
    In,
    /// Sent.
    Out,
}

/// What goes into a station.
#[derive(Clone, Debug, PartialEq)]
pub enum Input<'a> {
    /// Bytes heard on a port.
    Bytes {
        /// Where.
        port: PortIndex,
        /// What; any split of a stream is the same stream.
        bytes: &'a [u8],
    },
    /// A port to real equipment came or went; one that is cabled inside never does (FB8).
    Port {
        /// Which.
        port: PortIndex,
        /// Whether it is there.
        up: bool,
    },
    /// The caller was late by so many milliseconds: nothing heard before counts as fresh.
    Stalled {
        /// How late.
        ms: u64,
    },
    /// Somebody asks for something; [`Output::Answer`] is the answer (HTC-4).
    Order {
        /// Who.
        by: Origin,
        /// What.
        order: &'a Order,
    },
    /// A contact that is wired to the station is so now.
    Contact {
        /// Which.
        switch: Switch,
        /// It is closed; absent where it cannot be read.
        closed: Option<bool>,
    },
    /// Only time has passed.
    Tick,
}

/// A contact that a station reads (AP-22).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Switch {
    /// Closed while the hardware override steers.
    Nfu,
    /// Closed while the follow-up lever steers.
    Ffu,
    /// Closed while the mode switch stands at autopilot.
    Autopilot,
}

impl Switch {
    /// All.
    pub const ALL: [Self; 3] = [Self::Nfu, Self::Ffu, Self::Autopilot];

    /// Name in the configuration.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Nfu => "nfu",
            Self::Ffu => "ffu",
            Self::Autopilot => "autopilot",
        }
    }
}

/// A contact that a station closes and opens; open while it does not run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Contact {
    /// Closed while the back-up navigator is called (FA15, TCS-11).
    BackupNavigator,
}

/// What comes out of a station.
#[derive(Clone, Debug, PartialEq)]
pub enum Output {
    /// Bytes to send.
    Send {
        /// Where.
        port: PortIndex,
        /// What; whole sentences with CR LF.
        bytes: Vec<u8>,
    },
    /// A line was heard or sent, for the recorder, the page and the checker.
    Line {
        /// Where.
        port: PortIndex,
        /// Heard or sent.
        dir: Direction,
        /// The line without its end; a damaged one is cut at 256 bytes.
        text: Vec<u8>,
    },
    /// What became of an order: what followed, or why it was not done.
    Answer(Result<String, Refusal>),
    /// A contact closes or opens.
    Contact {
        /// Which.
        contact: Contact,
        /// It closes.
        closed: bool,
    },
    /// Settings in force have changed, and are not kept.
    Settings,
    /// A setting to be kept over a restart.
    Persist {
        /// Its name in the settings table.
        key: String,
        /// Its value.
        value: Value,
    },
}

impl Output {
    /// The contact of the back-up navigator.
    pub(crate) const fn backup_navigator(closed: bool) -> Self {
        Self::Contact {
            contact: Contact::BackupNavigator,
            closed,
        }
    }
}
