//! A configuration as the rest of the server sees it.
//!
//! **Invariant:** a [`Config`] has been checked; nothing starts on one that has not (FD9).

use super::chart::Chart;
use super::ship::Ship;
use serde::Deserialize;
use std::net::SocketAddr;
use std::path::PathBuf;
use wheelover_core::route::Route;
use wheelover_core::settings::Settings;
use wheelover_core::station::{ChecksumPolicy, PortSetup, Profile, Switch};
use wheelover_core::voyage::Role;

/// What stands behind a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Kind {
    /// A recording, read once at its line rate.
    File,
    /// A serial device.
    Serial,
    /// A server that we call.
    TcpClient,
    /// A client that calls us.
    TcpServer,
    /// Datagrams.
    Udp,
}

impl Kind {
    /// Its name in the configuration.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::File => "file",
            Self::Serial => "serial",
            Self::TcpClient => "tcp-client",
            Self::TcpServer => "tcp-server",
            Self::Udp => "udp",
        }
    }
}

/// Where a port leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// A file to be read.
    File(PathBuf),
    /// A serial device, with its rate.
    Serial(PathBuf, u32),
    /// A server to be called: host and port.
    TcpClient(String),
    /// An address to listen on.
    TcpServer(SocketAddr),
    /// An address to hear on, or to talk with.
    Udp(SocketAddr),
}

/// A port as configured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Port {
    /// Its station.
    pub(crate) station: Role,
    /// What the core knows of it.
    pub(crate) setup: PortSetup,
    /// Where it leads.
    pub(crate) place: Place,
}

/// A control line of a serial device that comes in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum ControlLine {
    /// Clear to send.
    Cts,
    /// Data set ready.
    Dsr,
    /// Data carrier detect.
    Dcd,
    /// Ring indicator.
    Ri,
}

impl ControlLine {
    /// Its name in the configuration.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Cts => "cts",
            Self::Dsr => "dsr",
            Self::Dcd => "dcd",
            Self::Ri => "ri",
        }
    }
}

/// What holds a GPIO line while nothing does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Bias {
    /// As it was set by others.
    #[default]
    AsIs,
    /// Nothing.
    Disabled,
    /// It is on.
    PullUp,
    /// It is off.
    PullDown,
}

impl Bias {
    /// Its name in the configuration.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::AsIs => "as_is",
            Self::Disabled => "disabled",
            Self::PullUp => "pull_up",
            Self::PullDown => "pull_down",
        }
    }
}

/// A line that a contact is wired to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wire {
    /// A control line of a serial device.
    Control(ControlLine),
    /// A line of a GPIO chip, by its number.
    Gpio(u32, Bias),
}

/// Where a contact is read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum At {
    /// At a port that is open, by its number.
    Port(usize),
    /// At a serial device of its own.
    Device(PathBuf),
    /// At a GPIO chip.
    Chip(PathBuf),
}

/// A contact that is wired.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Contact {
    /// What it says.
    pub(crate) switch: Switch,
    /// Where it is read.
    pub(crate) at: At,
    /// By which line.
    pub(crate) line: Wire,
    /// It is closed while the line is off.
    pub(crate) inverted: bool,
}

/// A checked configuration.
#[derive(Clone, Debug)]
pub(crate) struct Config {
    /// Which stations run here.
    pub(crate) roles: Vec<Role>,
    /// Where pages are served.
    pub(crate) listen: SocketAddr,
    /// Whether anything may leave a port.
    pub(crate) allow_output: bool,
    /// The ports.
    pub(crate) ports: Vec<Port>,
    /// Contacts that are wired to the autopilot.
    pub(crate) contacts: Vec<Contact>,
    /// The ship.
    pub(crate) ship: Ship,
    /// Parameters of the autopilot.
    pub(crate) settings: Settings,
    /// Times and reports of the chart-system side.
    pub(crate) chart: Chart,
    /// The route of the chart-system side; none: it monitors none (TCS-2).
    pub(crate) route: Option<Route>,
}

impl Config {
    /// Whether bytes may leave a port.
    pub(crate) fn may_send(&self, port: usize) -> bool {
        self.allow_output && self.ports.get(port).is_some_and(|port| port.setup.output)
    }
}

/// Whether what is heard on a port can change what the ship does by itself.
pub(crate) const fn commands(profile: Profile) -> bool {
    matches!(
        profile,
        Profile::Ecdis | Profile::Stand | Profile::Plotter | Profile::Hmi | Profile::Bams
    )
}

pub(super) const fn policy_name(policy: ChecksumPolicy) -> &'static str {
    match policy {
        ChecksumPolicy::Required => "required",
        ChecksumPolicy::Learned => "learned",
        ChecksumPolicy::Optional => "optional",
    }
}
