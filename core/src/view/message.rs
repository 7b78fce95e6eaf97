//! The messages: JSON text frames tagged by `type`.

use crate::autopilot::ModeName;
use crate::autopilot::steering::Terms;
use crate::command::{Answer, FaultKind, ModeRequest, Order};
use crate::facts::Quantity;
use crate::geo::Position;
use crate::picture::Picture;
use crate::settings::Value;
use crate::station::PortSetup;
use crate::voyage::Line;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Raised whenever the text of any message changes.
pub const PROTOCOL: u32 = 12;

/// A frame from the server.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case")]
#[expect(
    clippy::large_enum_variant,
    reason = "made and read once a frame, never kept"
)]
pub enum Down {
    /// First frame of a connection.
    Hello(Hello),
    /// The autopilot's own facts, ten times a second.
    Snapshot(Snapshot),
    /// The route with its geometry, on change.
    Route(RouteDocument),
    /// All settings, on change.
    Settings(SettingsDocument),
    /// State of the ports, on change and once a second.
    Ports(PortsDocument),
    /// Lines heard and sent, batched.
    Lines(Lines),
    /// Lines that are no longer held.
    Gap {
        /// How many are missing.
        lost: u64,
    },
    /// What became of a command.
    Answer(Answer),
}

/// A frame from the browser.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Up {
    /// A snapshot was taken; opens the window of three.
    Ack {
        /// Its number.
        frame: u64,
    },
    /// Send the lines from this number on.
    Resume {
        /// Number of the first line wanted.
        seq: u64,
    },
    /// What the client wants.
    Subscribe {
        /// Snapshots a second, 0 to 10.
        rate: f64,
        /// Whether lines are wanted.
        lines: bool,
    },
    /// Do something.
    Command {
        /// Chosen by the client; comes back in the answer.
        id: u64,
        /// The snapshot that it was pressed beside (AP-26); a program may leave it out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        frame: Option<u64>,
        /// What.
        #[serde(rename = "do")]
        action: Order,
    },
}

/// First frame of a connection: what the page needs to fold the lines itself.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hello {
    /// [`PROTOCOL`].
    pub protocol: u32,
    /// Version of the program.
    pub build: String,
    /// Number of sentences in the dictionary.
    pub dictionary: u32,
    /// The picture as it was after line `line`.
    pub picture: Picture,
    /// Number of the last line folded into `picture`; 0 before the first.
    pub line: u64,
    /// Server time in milliseconds, the clock of every `at`.
    pub at: u64,
    /// Ship's time for each second of the clock on the wall.
    pub rate: f64,
    /// Ports of the station that is shown.
    pub ports: Vec<PortSetup>,
    /// Which station is shown: `autopilot` or `chart_system`.
    pub station: String,
    /// Own ship's outline.
    pub ship: Outline,
    /// Whether this is the embedded voyage (a simulated ship).
    pub simulated: bool,
    /// Whether this client may command.
    pub may_command: bool,
}

/// Own ship's outline, for a plan that is true to scale.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outline {
    /// Length over all, metres.
    pub length_m: f64,
    /// Greatest beam, metres.
    pub beam_m: f64,
}

/// The built-in ship's.
impl Default for Outline {
    fn default() -> Self {
        Self {
            length_m: 160.93,
            beam_m: 23.17,
        }
    }
}

/// Own facts: what no sentence can say.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// Number of this frame, acknowledged by `ack`.
    pub frame: u64,
    /// Server time, milliseconds.
    pub at: u64,
    /// Ship's time for each second of the clock on the wall.
    pub rate: f64,
    /// Number of the last line folded into the server's picture.
    pub line: u64,
    /// Digest of the server's picture there, hexadecimal.
    pub digest: String,
    /// The autopilot; null where another station is shown.
    pub own: Option<Own>,
    /// The chart-system side; null where it is a foreign one.
    pub chart: Option<ChartOwn>,
    /// The embedded voyage; null with real equipment.
    pub voyage: Option<VoyageOwn>,
    /// Alerts that are not normal, highest first.
    pub alerts: Vec<AlertView>,
}

/// The autopilot's own facts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Own {
    /// Mode.
    pub mode: ModeName,
    /// Why the mode is what it is: last refusal or cause, in an officer's words.
    pub why: String,
    /// A selection that waits for its confirmation.
    pub pending: Option<Pending>,
    /// Modes that would be refused now, each with the reason in an officer's words; not the one that is on, and never
    /// STANDBY (AP-6, AP-25).
    pub closed: Vec<(ModeRequest, String)>,
    /// Set heading in AUTO, degrees.
    pub set_heading: Option<f64>,
    /// What is set in a mode by a number, in the unit of its order; absent where a heading or nothing is set.
    pub set_value: Option<f64>,
    /// Heading to steer in force, degrees (the set course calculated in track control).
    pub hts: Option<f64>,
    /// Set rate of turn of AUTO, degrees a minute.
    pub set_rate: f64,
    /// Set radius of AUTO, nautical miles.
    pub set_radius: f64,
    /// Whether AUTO turns by radius (else by rate).
    pub by_radius: bool,
    /// Rudder limit in force, degrees.
    pub rudder_limit: f64,
    /// Rudder order, degrees, starboard positive; of an independent pair the starboard one's.
    pub rudder_order: Option<f64>,
    /// Whether there is an independent pair of rudders (AP-4).
    pub pair: bool,
    /// Order to the port one of the pair, degrees.
    pub port_order: Option<f64>,
    /// Cross-track distance that the controller uses, metres, ship right of track positive.
    pub cross_track: Option<f64>,
    /// Farther off the track is an alarm, metres.
    pub cross_track_limit: f64,
    /// Chosen source of each quantity: quantity, `port/talker/formatter`; C for the formatter of what is calculated, and `manual` of a
    /// speed that is entered by hand.
    pub sources: Vec<(String, String)>,
    /// Heading that the autopilot believes, degrees; absent where it believes none.
    pub heading: Option<f64>,
    /// That heading, and every heading set, is of magnetic north.
    pub magnetic: bool,
    /// When it judged its sources last, milliseconds: what was heard then or later is not judged yet.
    pub judged: u64,
    /// Position that it believes, at the time of the snapshot; absent where it believes none.
    pub position: Option<Position>,
    /// Speed entered by hand, knots, where the gains are made of it (AP-7).
    pub manual_speed: Option<f64>,
    /// Course, degrees, and speed over ground, knots, where they are calculated from positions (AP-9).
    pub calculated: Option<(Option<f64>, f64)>,
    /// Sources that it hears and does not believe.
    pub refused: Vec<RefusedView>,
    /// What moves the rudder; absent where no order is computed.
    pub terms: Option<Terms>,
    /// The order is at its limit.
    pub limited: bool,
    /// Outputs to the steering gear are enabled.
    pub output: bool,
}

/// A source that is heard and not believed: what it says is never shown as the ship's.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RefusedView {
    /// What it says.
    pub quantity: Quantity,
    /// Who, as `port/talker/formatter`.
    pub source: String,
    /// Why, in an officer's words.
    pub why: String,
}

/// A mode that was asked for and waits for the other side.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pending {
    /// What was asked for.
    pub request: ModeName,
    /// Server time at which it lapses, milliseconds.
    pub until: u64,
    /// What it waits for, in an officer's words.
    pub waits_for: String,
}

/// The chart-system side's own facts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ChartOwn {
    /// Situation 1 to 6 of the dialogue.
    pub situation: u8,
    /// `off`, `heading` (Tn) or `track` (Ti).
    pub control: String,
    /// Index of the leg that is sailed, from 0.
    pub leg: usize,
    /// Seconds to the wheel-over line; negative after it.
    pub wheel_over_s: Option<f64>,
    /// Last refusal or indication.
    pub why: String,
    /// Where dead reckoning has her, and what that may be off, two sigma, metres; absent while the position is known (TCS-14).
    pub adrift: Option<(Position, f64)>,
}

/// The embedded voyage's own facts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VoyageOwn {
    /// The scripted officer has the watch.
    pub officer: bool,
    /// Which round is sailed, from 1.
    pub round: u32,
    /// Pace asked for.
    pub speed: f64,
    /// Faults in force: cable, kind.
    pub faults: Vec<(String, FaultKind)>,
    /// Current: set in degrees, drift in knots.
    pub current: [f64; 2],
}

/// An alert as it is shown.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AlertView {
    /// Its number in the alert table.
    pub number: u16,
    /// Priority.
    pub priority: crate::alerts::Priority,
    /// State by IEC 62923.
    pub state: crate::alerts::State,
    /// Category: `A` acknowledged only at the source, `B` anywhere.
    pub category: crate::alerts::Category,
    /// Title, at most 18 characters.
    pub title: String,
    /// What happened and what to do.
    pub text: String,
    /// Server time of the last change, milliseconds.
    pub at: u64,
}

/// Lines heard and sent: number, time, port, direction, text (Latin-1).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lines {
    /// Number of the first.
    pub from: u64,
    /// The lines.
    pub lines: Vec<Line>,
}

/// The route with its geometry.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RouteDocument {
    /// Raised on every change.
    pub revision: u64,
    /// Its name.
    pub name: String,
    /// Its waypoints.
    pub waypoints: Vec<WaypointView>,
    /// Its turns, one a waypoint between the first and the last.
    pub turns: Vec<TurnView>,
}

/// A waypoint as it is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WaypointView {
    /// Identifier.
    pub id: String,
    /// Place.
    pub position: Position,
    /// Radius of its turn, nautical miles.
    pub radius_nm: Option<f64>,
    /// Limits of the leg that leads to it, metres to port and to starboard.
    pub xtd_m: [f64; 2],
    /// Course of the leg that leads to it, degrees true.
    pub course: Option<f64>,
}

/// A turn as it is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TurnView {
    /// Index of its waypoint.
    pub waypoint: usize,
    /// Where the wheel-over line crosses the leg.
    pub wheel_over: Position,
    /// Where the arc begins.
    pub start: Position,
    /// Where it ends.
    pub end: Position,
    /// Its centre.
    pub centre: Position,
    /// Signed change of course, degrees, starboard positive.
    pub turn: f64,
    /// Forwarding distance, metres.
    pub forwarding_m: f64,
}

/// All settings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SettingsDocument {
    /// Raised on every change.
    pub revision: u64,
    /// Name and value, in the order of the settings table.
    pub values: Vec<(String, Value)>,
}

/// State of the ports.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PortsDocument {
    /// Raised on every change.
    pub revision: u64,
    /// One a port, in the order of [`Hello::ports`].
    pub ports: Vec<PortView>,
}

/// State of one port.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PortView {
    /// Its name.
    pub name: String,
    /// Whether the device is there.
    pub up: bool,
    /// What is wrong with it; empty where nothing is.
    pub trouble: String,
    /// Valid sentences heard.
    pub heard: u64,
    /// Sentences sent.
    pub sent: u64,
    /// Lines with a wrong or missing checksum.
    pub bad_checksum: u64,
    /// Lines that are no sentence.
    pub garbage: u64,
    /// Valid sentences that the dictionary does not know.
    pub unknown: u64,
    /// The other valid sentences that this port may not say: shown, never used.
    pub unused: u64,
}
