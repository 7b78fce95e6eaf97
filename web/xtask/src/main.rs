//! The project's build task: `cargo xtask build | serve | ship | watch | test`.

mod deny;
mod page;
mod serve;
mod test;
mod tools;
mod watch;

use std::process::ExitCode;
use xtask::shell::{Failure, Outcome};

const USAGE: &str = "usage: cargo xtask <task>
  build [--release]               the page, into web/dist
  serve [--release] [-- ARGS]     the page and the server, then runs `wheelover ARGS`; --release: the small page, and a
                                  server that is optimised where it computes, since the first command is a build
  ship                            what is shipped, into target/release/wheelover: fully optimised, the page inside
  watch [-- ARGS]                 as serve; an edit of the page is on the screen in seconds
  test                            installs what the tests need, then checks and tests everything";

/// What the command line asks for.
struct Request {
    task: String,
    release: bool,
    rest: Vec<String>,
}

fn request(mut arguments: impl Iterator<Item = String>) -> Result<Request, Failure> {
    let task = arguments.next().ok_or_else(|| Failure::new(USAGE))?;
    let mut request = Request {
        task,
        release: false,
        rest: Vec::new(),
    };
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--release" => request.release = true,
            "--" => request.rest.extend(arguments.by_ref()),
            other => return Err(Failure::new(format!("unknown argument `{other}`\n{USAGE}"))),
        }
    }
    if !request.rest.is_empty() && !matches!(request.task.as_str(), "serve" | "watch") {
        return Err(Failure::new(format!(
            "`{}` takes no arguments after `--`",
            request.task
        )));
    }
    Ok(request)
}

fn run(request: &Request) -> Outcome {
    match request.task.as_str() {
        "build" => page::build(request.release),
        "serve" => serve::serve(request.release, &request.rest),
        "ship" => serve::ship(),
        "watch" => watch::watch(&request.rest),
        "test" => test::test(),
        "help" | "--help" | "-h" => {
            println!("{USAGE}");
            Ok(())
        }
        other => Err(Failure::new(format!("unknown task `{other}`\n{USAGE}"))),
    }
}

fn main() -> ExitCode {
    match request(std::env::args().skip(1)).and_then(|request| run(&request)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("xtask: {failure}");
            ExitCode::from(2)
        }
    }
}
