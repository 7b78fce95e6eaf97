//! What the program does with its command line: one function a command.
//!
//! It stands in the library so that all of it is compiled beside the page, which only `main.rs` waits for.

use crate::args::{self, Cli, Command, ConfigCommand, Ports};
use crate::error::Error;
use crate::log::{self, Log};
use crate::serve::{Options, Running, serve};
use crate::{check, config, decode, page, persist, ports, recorder, simulate};
use std::io::{ErrorKind, IsTerminal, Write, stderr};
use std::net::{IpAddr, SocketAddr};
use std::path::Path;
use std::process::ExitCode;
use std::time::Duration;

/// The control loop failed, or does not end: whoever watches over the program starts it again, in STANDBY.
const FAILED: i32 = 3;

/// Reads the command line and does what it asks for; `page` gives the files of the page.
///
/// The exit code is 0 where all is well, 1 where something was found, 2 where it could not be done, and 3 where
/// the control loop failed.
pub fn run(page: page::Bundle) -> ExitCode {
    let code = match args::read() {
        Ok(cli) => obey(cli, page).unwrap_or_else(|error| {
            eprintln!("{}", log::escaped(&error.to_string()));
            2
        }),
        Err(code) => code,
    };
    ExitCode::from(u8::try_from(code).unwrap_or(2))
}

fn obey(cli: Cli, page: page::Bundle) -> Result<i32, Error> {
    match cli.command {
        None => main_job(cli.serve, page),
        Some(Command::Serve(options)) => main_job(options, page),
        Some(Command::Decode { file, json, quiet }) => explain(file.as_deref(), json, quiet),
        Some(Command::Check { file, json, quiet }) => {
            check::check(&file, json, quiet).map_err(Error::Other)
        }
        Some(Command::Simulate {
            scenario,
            only,
            csv,
            json,
            quiet,
        }) => simulate::simulate(&scenario, only.as_deref(), csv.as_deref(), json, quiet)
            .map_err(Error::Other),
        Some(Command::Replay { file, quiet }) => recorder::replay(&file, quiet),
        Some(Command::Ports(options)) if options.scan => scan(&options),
        Some(Command::Ports(_)) => {
            for port in ports::list::list() {
                if port.path == port.device {
                    say(&port.path.display().to_string());
                } else {
                    let (path, device) = (port.path.display(), port.device.display());
                    say(&format!("{path} -> {device}"));
                }
            }
            Ok(0)
        }
        Some(Command::Config(ConfigCommand::Check { file })) => {
            say(config::in_force(&config::read(&file)?).trim_end());
            Ok(0)
        }
    }
}

/// `ports --scan`: 0 where there is nothing to change, 1 with findings.
fn scan(options: &Ports) -> Result<i32, Error> {
    let config = options.config.as_deref().map(config::read).transpose()?;
    let asked = ports::scan::asked(&options.paths, config.as_ref());
    if asked.is_empty() {
        return Err(Error::Other("there is no serial port to listen to".into()));
    }
    if stderr().is_terminal() {
        eprintln!("listening to {} ports for up to 10 s", asked.len());
    }
    let found = ports::scan::scan(asked);
    for port in &found {
        say(&if options.json {
            port.json().to_string()
        } else {
            port.text()
        });
    }
    Ok(i32::from(!found.iter().all(ports::scan::Found::is_good)))
}

/// `decode`; a reader that has seen enough is no failure.
fn explain(file: Option<&Path>, json: bool, quiet: bool) -> Result<i32, Error> {
    match decode::decode(file, json, quiet) {
        Err(source) if source.kind() == ErrorKind::BrokenPipe => Ok(0),
        done => done.map_err(|source| Error::File {
            path: file.map_or_else(
                || "standard input".to_owned(),
                |file| file.display().to_string(),
            ),
            source,
        }),
    }
}

/// `serve`: the main job.
fn main_job(options: args::Serve, page: page::Bundle) -> Result<i32, Error> {
    let config = options.config.as_deref().map(config::read).transpose()?;
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(2)
        .enable_all()
        .build()
        .map_err(|error| Error::Other(format!("cannot start: {error}")))?;
    let lan = options.lan;
    let asked = Options {
        config,
        listen: options.listen,
        lan,
        speed: options.speed,
        record: options.record,
        settings: options.config.as_deref().map(persist::beside),
        page,
    };
    let log = Log::begin(options.quiet)
        .map_err(|error| Error::Other(format!("cannot start: {error}")))?;
    let done = runtime.block_on(async {
        let running = serve(asked).await?;
        if !options.quiet {
            announce(running.addr, lan);
        }
        for caution in &running.cautions {
            tracing::warn!("{caution}");
        }
        Ok(until_the_end(running).await)
    });
    log.end(Duration::from_secs(1));
    // Whatever still runs then is stuck, and holds the end of the program up no longer.
    runtime.shutdown_background();
    done
}

/// Runs until the program is asked to stop, or the control thread ends by itself; gives the exit code.
async fn until_the_end(mut running: Running) -> i32 {
    let failure = tokio::select! {
        () = asked_to_stop() => None,
        why = running.failed() => Some(why),
    };
    if let Some(why) = &failure {
        tracing::error!("the control loop has failed, nothing is steered: {why}");
    }
    let ended = running.shutdown().await;
    if let Err(why) = &ended {
        tracing::error!("{why}");
    }
    match (failure, ended) {
        (None, Ok(())) => 0,
        _ => FAILED,
    }
}

/// Says where the page is; with `--lan` also for a tablet.
fn announce(addr: SocketAddr, lan: bool) {
    let here = if addr.ip().is_unspecified() {
        SocketAddr::from(([127, 0, 0, 1], addr.port()))
    } else {
        addr
    };
    say(&format!("listening on http://{here}"));
    if lan {
        for ip in own_addresses() {
            say(&format!(
                "for tablets, reading only: http://{}",
                SocketAddr::new(ip, addr.port())
            ));
        }
    }
}

/// IPv4 addresses by which others reach this machine.
fn own_addresses() -> Vec<IpAddr> {
    let Ok(interfaces) = nix::ifaddrs::getifaddrs() else {
        return Vec::new();
    };
    interfaces
        .filter_map(|interface| Some(interface.address?.as_sockaddr_in()?.ip()))
        .filter(|ip| !ip.is_loopback() && !ip.is_unspecified())
        .map(IpAddr::V4)
        .collect()
}

/// Writes a line at once; a reader that is gone is no reason to stop steering.
fn say(line: &str) {
    let mut out = std::io::stdout().lock();
    let _ = writeln!(out, "{line}").and_then(|()| out.flush());
}

/// Returns on Ctrl-C, or when the service manager asks.
async fn asked_to_stop() {
    use tokio::signal::unix::{SignalKind, signal};
    match signal(SignalKind::terminate()) {
        Ok(mut terminate) => tokio::select! {
            _ = tokio::signal::ctrl_c() => {}
            _ = terminate.recv() => {}
        },
        Err(_) => {
            let _ = tokio::signal::ctrl_c().await;
        }
    }
}
