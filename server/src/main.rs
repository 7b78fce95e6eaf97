//! The `wheelover` program: reads the command line and calls the library.

use std::io::Write;
use std::process::ExitCode;
use wheelover::args::{self, Cli, Command};
use wheelover::{Error, Options, serve};

fn main() -> ExitCode {
    let code = match args::read() {
        Ok(cli) => run(cli).unwrap_or_else(|error| {
            eprintln!("{error}");
            2
        }),
        Err(code) => code,
    };
    ExitCode::from(u8::try_from(code).unwrap_or(2))
}

fn run(cli: Cli) -> Result<i32, Error> {
    let options = match cli.command {
        None => cli.serve,
        Some(Command::Serve(options)) => options,
    };
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(2)
        .enable_all()
        .build()
        .map_err(|e| Error::Other(format!("cannot start: {e}")))?;
    runtime.block_on(main_job(options))
}

async fn main_job(options: args::Serve) -> Result<i32, Error> {
    let listen = options
        .listen
        .unwrap_or_else(|| ([127, 0, 0, 1], 8080).into());
    let running = serve(Options { listen }).await?;
    if !options.quiet {
        say(&format!("listening on http://{}", running.addr));
    }
    asked_to_stop().await;
    running.shutdown().await;
    Ok(0)
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
