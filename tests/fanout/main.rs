//! What clients cost the server: its share of a core with 0, 200 and 1,000 pages at 10 Hz.
//!
//! `cargo run --release -p wheelover-tests --bin fanout [-- OTHER_PROGRAM]`. The pages run in a process of their
//! own, so that only the server's time is counted. With another program both take turns, and the ratio is told.
#![allow(clippy::unwrap_used)]

mod load;

use std::io::{BufRead, BufReader};
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::time::{Duration, Instant};
use wheelover_tests::program::built;

/// Pages, and the most that they may cost, parts of a core.
const LIMITS: [(usize, f64); 3] = [(0, 1.0), (200, 0.08), (1_000, 0.30)];
/// Rounds; the median counts.
const ROUNDS: usize = 3;
/// How long is measured in each.
const TIME: Duration = Duration::from_secs(10);
/// A page that got fewer snapshots a second than this was not served at 10 Hz.
const SERVED: f64 = 9.5;

/// A child that ends with this value.
struct Ended(Child);

impl Drop for Ended {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [load, address, pages] = arguments.as_slice()
        && load == "load"
    {
        load::run(address.parse().unwrap(), pages.parse().unwrap());
        return ExitCode::SUCCESS;
    }
    let programs: Vec<PathBuf> = std::iter::once(built("release", "release"))
        .chain(arguments.iter().map(PathBuf::from))
        .collect();
    let mut kept = true;
    for (pages, limit) in LIMITS {
        let mut costs = vec![Vec::new(); programs.len()];
        let mut served = f64::MAX;
        for _ in 0..ROUNDS {
            for (program, costs) in programs.iter().zip(&mut costs) {
                let (cost, rate) = measure(program, pages);
                costs.push(cost);
                served = served.min(rate);
            }
        }
        let medians: Vec<f64> = costs.iter_mut().map(|costs| median(costs)).collect();
        print!("{pages:>5} pages: {:>5.1} % of a core", medians[0] * 100.0);
        if pages > 0 {
            print!(
                ", limit {:.0} %, {served:.1} snapshots a second for each",
                limit * 100.0
            );
            kept &= medians[0] <= limit && served >= SERVED;
        }
        for other in &medians[1..] {
            print!(
                "; the other {:.1} %, ratio {:.2}",
                other * 100.0,
                other / medians[0]
            );
        }
        println!();
    }
    ExitCode::from(u8::from(!kept))
}

/// The server's share of a core, and the snapshots a second that the worst served page got.
fn measure(program: &Path, pages: usize) -> (f64, f64) {
    let (server, said) = start(Command::new(program).args(["serve", "--listen", "127.0.0.1:0"]));
    let address: SocketAddr = said
        .split("http://")
        .nth(1)
        .unwrap()
        .trim()
        .parse()
        .unwrap();
    let load = (pages > 0).then(|| {
        let me = std::env::current_exe().unwrap();
        let arguments = ["load".to_owned(), address.to_string(), pages.to_string()];
        start(Command::new(me).args(arguments).stdin(Stdio::piped()))
    });
    // What a start costs is not what pages cost.
    std::thread::sleep(Duration::from_secs(3));
    let (began, before) = (Instant::now(), processor_time(server.0.id()));
    std::thread::sleep(TIME);
    let cost = (processor_time(server.0.id()) - before) / began.elapsed().as_secs_f64();
    let rate = load.map_or(f64::MAX, |(mut load, _)| {
        drop(load.0.stdin.take());
        let mut out = String::new();
        let mut lines = BufReader::new(load.0.stdout.take().unwrap());
        lines.read_line(&mut out).unwrap();
        out.trim().parse().unwrap()
    });
    (cost, rate)
}

/// Starts a program and gives its first line.
fn start(command: &mut Command) -> (Ended, String) {
    let child = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn();
    let mut child = Ended(child.unwrap());
    let mut line = Vec::new();
    // Byte by byte, so that nothing of what follows is taken.
    let out = child.0.stdout.as_mut().unwrap();
    let mut byte = [0];
    while std::io::Read::read(out, &mut byte).unwrap() == 1 && byte[0] != b'\n' {
        line.push(byte[0]);
    }
    (child, String::from_utf8(line).unwrap())
}

/// Seconds of processor that a process has used, its own and the system's for it.
fn processor_time(id: u32) -> f64 {
    let text = std::fs::read_to_string(format!("/proc/{id}/stat")).unwrap();
    let after = text.rsplit(')').next().unwrap();
    let fields: Vec<&str> = after.split_whitespace().collect();
    let ticks: f64 = [11, 12]
        .map(|field: usize| fields[field].parse::<f64>().unwrap())
        .iter()
        .sum();
    // Linux tells a hundred ticks a second, whatever its own are.
    ticks / 100.0
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
