//! The whole voyage against its own clock, and one control step of the autopilot station.
//!
//! `cargo bench -p wheelover-core --bench voyage`
#![allow(clippy::disallowed_types, reason = "what is measured is time")]

use std::time::Instant;
use wheelover_core::station::Input;
use wheelover_core::time::Stamp;
use wheelover_core::voyage::{Event, Voyage};

fn main() {
    let mut voyage = Voyage::embedded(1);
    let mut out = Vec::new();
    let seconds = 3_900_u64;
    let started = Instant::now();
    let mut lines = 0_usize;
    for second in 1..=seconds {
        out.clear();
        voyage.handle(Stamp(second * 1_000), Event::Tick, &mut out);
        lines += out.len();
    }
    let took = started.elapsed().as_secs_f64();
    println!(
        "voyage: {seconds} s with {lines} lines in {took:.3} s, {:.0} times real time",
        seconds as f64 / took
    );
    println!("steps of a second each, median of 2000 after 130 s under track control:");
    let mut voyage = Voyage::embedded(1);
    voyage.handle(Stamp(130_000), Event::Tick, &mut out);
    let autopilot = voyage
        .autopilot()
        .expect("the embedded voyage has one")
        .clone();
    let mut times: Vec<f64> = (0..2_000)
        .map(|_| {
            let mut autopilot = autopilot.clone();
            let mut out = Vec::with_capacity(64);
            let started = Instant::now();
            for step in 1..=10_u64 {
                autopilot.handle(Stamp(130_000 + step * 100), Input::Tick, &mut out);
            }
            started.elapsed().as_secs_f64() / 10.0 * 1e6
        })
        .collect();
    times.sort_by(f64::total_cmp);
    println!(
        "autopilot: {:.2} us a control step (99 %: {:.2} us)",
        times[1_000], times[1_980]
    );
}
