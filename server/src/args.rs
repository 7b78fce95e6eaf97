//! The command line: what can be asked for, and one clear line for what cannot.

use clap::error::ErrorKind;
use clap::{Args, Parser, Subcommand};
use std::net::SocketAddr;
use std::path::PathBuf;

const SAFETY: &str = "\
Wheelover is not track control approved under SOLAS. It is for ships outside SOLAS, leisure craft, training and \
test. The ship's own override and a proper look-out come first.

Exit codes: 0 done; 1 done, with findings; 2 not done, with one line that says what and where; \
3 the control loop failed: start again, in STANDBY.";

/// A track-control autopilot: it faces a chart system over serial NMEA 0183, steers by it, and shows
/// every tablet on the bridge what it does.
#[derive(Debug, Parser)]
#[command(name = "wheelover", version, after_help = SAFETY, args_conflicts_with_subcommands = true)]
pub(crate) struct Cli {
    /// What to do; `serve` where nothing is named.
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
    /// Options of `serve`.
    #[command(flatten)]
    pub(crate) serve: Serve,
}

/// What can be done.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run: the embedded voyage, or the stations and ports of a configuration
    #[command(after_help = SAFETY)]
    Serve(Serve),
    /// Explain sentences, field by field
    Decode {
        /// A log of sentences, or - for standard input
        file: Option<PathBuf>,
        /// One JSON object a line
        #[arg(long)]
        json: bool,
        /// Say nothing but results
        #[arg(short, long)]
        quiet: bool,
    },
    /// List the breaches of the rules in a recorded dialogue
    Check {
        /// The dialogue, both directions, or - for standard input
        file: PathBuf,
        /// One JSON object a breach
        #[arg(long)]
        json: bool,
        /// Say nothing but results
        #[arg(short, long)]
        quiet: bool,
    },
    /// Run scenarios in closed loop or manoeuvres in open loop, as fast as it goes
    Simulate {
        /// The scenario file
        #[arg(long, value_name = "FILE")]
        scenario: PathBuf,
        /// Only the scenario of this name
        #[arg(long, value_name = "NAME")]
        only: Option<String>,
        /// Where the run is written
        #[arg(long, value_name = "OUT")]
        csv: Option<PathBuf>,
        /// One JSON object a scenario
        #[arg(long)]
        json: bool,
        /// Say nothing but results
        #[arg(short, long)]
        quiet: bool,
    },
    /// Run a recording again and report the first difference
    Replay {
        /// The recording, as written by `serve --record`
        file: PathBuf,
        /// Say nothing but a difference
        #[arg(short, long)]
        quiet: bool,
    },
    /// List the serial ports of this machine, or listen to them and say what is wrong
    Ports(Ports),
    /// Look at a configuration
    #[command(subcommand)]
    Config(ConfigCommand),
}

/// Options of `ports`.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct Ports {
    /// Ports to listen to [default: those of the configuration, or all]
    #[arg(requires = "scan")]
    pub(crate) paths: Vec<PathBuf>,
    /// Listen for up to 10 s at the usual rates, send nothing, and say what to change
    #[arg(long)]
    pub(crate) scan: bool,
    /// Take the ports and their rates from a configuration
    #[arg(long, value_name = "FILE", requires = "scan")]
    pub(crate) config: Option<PathBuf>,
    /// One JSON object a port
    #[arg(long, requires = "scan")]
    pub(crate) json: bool,
}

/// What can be done with a configuration.
#[derive(Debug, Subcommand)]
pub(crate) enum ConfigCommand {
    /// Say what is wrong with it, or print it as it is in force
    Check {
        /// The configuration
        file: PathBuf,
    },
}

/// Options of `serve`.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct Serve {
    /// Stations and ports; without it the embedded voyage runs
    #[arg(long, value_name = "FILE")]
    pub(crate) config: Option<PathBuf>,
    /// Address to listen on [default: 127.0.0.1:8080]
    #[arg(long, value_name = "ADDR")]
    pub(crate) listen: Option<SocketAddr>,
    /// Listen on all addresses; from other computers for reading only
    #[arg(long)]
    pub(crate) lan: bool,
    /// Pace of ship's time, 1 to 60: of the embedded voyage, or where every port leads to a pseudo-terminal, a file or loopback
    #[arg(long, value_name = "N", value_parser = pace)]
    pub(crate) speed: Option<f64>,
    /// Record everything, for `replay`
    #[arg(long, value_name = "FILE")]
    pub(crate) record: Option<PathBuf>,
    /// Say nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

fn pace(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(pace) if (1.0..=60.0).contains(&pace) => Ok(pace),
        _ => Err("allowed are 1 to 60".to_owned()),
    }
}

/// Reads the command line.
///
/// # Errors
/// The exit code, after what is to be said was said: 0 for help and version, 2 for a mistake.
pub(crate) fn read() -> Result<Cli, i32> {
    Cli::try_parse().map_err(|error| {
        if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
            eprintln!("a command is missing; see wheelover --help");
            2
        } else if error.use_stderr() {
            eprintln!("{}", one_line(&error.to_string()));
            2
        } else {
            let _ = error.print();
            0
        }
    })
}

/// The first paragraph of a complaint, as one line.
fn one_line(text: &str) -> String {
    let first = text.split("\n\n").next().unwrap_or_default();
    let words: Vec<&str> = first.split_whitespace().collect();
    let line = words.join(" ");
    format!(
        "{}; see wheelover --help",
        line.trim_start_matches("error: ")
    )
}
