//! The command line: what can be asked for, and one clear line for what cannot.

use clap::{Args, Parser, Subcommand};
use std::net::SocketAddr;

const SAFETY: &str = "Wheelover is not an approved track-control system under SOLAS: it is for ships outside SOLAS and for \
leisure craft, for training and for test. The ship's own override and a look-out come first.";

/// A track-control autopilot: it faces a chart system over serial NMEA 0183, steers by it, and shows
/// every tablet on the bridge what it does.
#[derive(Debug, Parser)]
#[command(name = "wheelover", version, after_help = SAFETY, args_conflicts_with_subcommands = true)]
pub struct Cli {
    /// What to do; `serve` where nothing is named.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Options of `serve`.
    #[command(flatten)]
    pub serve: Serve,
}

/// What can be done.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run: the embedded voyage, or the stations and ports of a configuration
    #[command(after_help = SAFETY)]
    Serve(Serve),
}

/// Options of `serve`.
#[derive(Clone, Debug, Default, Args)]
pub struct Serve {
    /// Address to listen on [default: 127.0.0.1:8080]
    #[arg(long, value_name = "ADDR")]
    pub listen: Option<SocketAddr>,
    /// Say nothing but errors
    #[arg(short, long)]
    pub quiet: bool,
}

/// Reads the command line.
///
/// # Errors
/// The exit code, after what is to be said was said: 0 for help and version, 2 for a mistake.
pub fn read() -> Result<Cli, i32> {
    Cli::try_parse().map_err(|error| {
        if error.use_stderr() {
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
