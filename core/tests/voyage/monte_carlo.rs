//! Random fault scripts in fast time, in every mode; what must hold in all of them (FA17).
//!
//! `WHEELOVER_SCRIPTS=10000 cargo test -p wheelover-core --test voyage monte_carlo -- --nocapture` runs ten thousand.

mod acts;

use crate::random::Random;
use crate::rig::{Rig, route};
use acts::{Acts, Damage, damaged};
use std::sync::{Arc, Mutex};
use wheelover_core::alerts::Alert;
use wheelover_core::nmea;
use wheelover_core::settings::SpeedSource;
use wheelover_core::time::Stamp;
use wheelover_core::view::{ChartRequest, ModeName, ModeRequest, Order};

/// Scripts in CI, so many that they run within a minute.
const SCRIPTS: u64 = 1_000;
/// Steps of a script, a tenth of a second each.
const STEPS: u32 = 1_500;
/// What is followed in Ti is no older, milliseconds: `track_fail`, and a step or two.
const OLDEST_MS: u64 = 5_300;

/// Every mode that a script was in.
type Seen = Vec<ModeName>;

/// Every fallback has its alarm, at once.
fn check_change(rig: &Rig, before: ModeName, seed: u64) {
    let at = format!("seed {seed} at {} s", rig.now.seconds());
    let raised = |alert| rig.raised(alert);
    match rig.mode() {
        // It ends by itself, on the heading before.
        ModeName::Auto if before == ModeName::Autotuning => {}
        ModeName::Auto if before == ModeName::WindVane => assert!(raised(Alert::WindLost), "{at}"),
        ModeName::Auto => assert!(raised(Alert::TrackFail), "{at}: {before:?}"),
        ModeName::RudderHold => assert!(raised(Alert::HeadingLost), "{at}"),
        ModeName::Standby => assert!(raised(Alert::Override), "{at}: {before:?}"),
        _ => {}
    }
}

/// What holds in every step.
fn check_step(rig: &Rig, seed: u64) {
    let at = || format!("seed {seed} at {} s", rig.now.seconds());
    let (mode, autopilot) = (rig.mode(), rig.autopilot());
    let blind = autopilot.believed_heading().is_none();
    // AP-21: without a heading RIVER PILOT alone goes on, and says so.
    if mode == ModeName::RiverPilot && blind {
        assert!(rig.raised(Alert::NoHeading), "{}", at());
    }
    // AP-7
    if mode == ModeName::AutonavTi || mode == ModeName::AutonavTn {
        let source = autopilot.settings().speed_source;
        assert_eq!(source, SpeedSource::Automatic, "{}", at());
    }
    // FA5: what says V is not heard, and is not followed for longer than its age limit.
    if mode == ModeName::AutonavTi {
        let picture = autopilot.picture();
        let xte = picture.xte.as_ref().map(|heard| heard.at);
        let age = |at: Stamp| rig.now.since(at);
        assert!(xte.map(age) <= Some(OLDEST_MS), "{}: {xte:?}", at());
    }
}

fn script(seed: u64, seen: &mut Seen) {
    let mut random = Random(seed);
    let mut rig = Rig::among_others(route(&[(245.0, 1.6), (305.0, 2.0)], 0.5), seed);
    let damage = Arc::new(Mutex::new(Damage::default()));
    let on_cable = damage.clone();
    rig.filter(move |_, from, line| damaged(&on_cable.lock().unwrap(), from, line));
    rig.run(4.0);
    let _ = rig.command(Order::Mode(ModeRequest::Auto));
    rig.run(4.0);
    let _ = rig.ask(ChartRequest::Track);
    let _ = rig.command(Order::Mode(ModeRequest::Autonav));
    let mut next = rig.now + 5_000 + random.below(40_000_u64);
    let mut acts = Acts::new(random, &rig, damage);
    for step in 0..STEPS {
        let before = rig.mode();
        let mut wanted = false;
        if step.is_multiple_of(10) {
            wanted = acts.each_second(&mut rig);
        }
        if rig.now >= next {
            next = rig.now + 2_000 + acts.random.below(20_000_u64);
            wanted |= acts.act(&mut rig);
        }
        rig.step();
        check_step(&rig, seed);
        if before != rig.mode() {
            seen.push(rig.mode());
            if !wanted {
                check_change(&rig, before, seed);
            }
        }
    }
    // FA6; every HTD is a sentence without fault and names one mode.
    rig.check_orders();
    for (at, htd) in &rig.htd {
        let line = htd.line("AG");
        let sentence = nmea::decode(line.as_bytes());
        assert!(sentence.faults().is_empty(), "{line} at {}", at.seconds());
    }
}

/// A quarter of the scripts; seeds are fixed and told. Every mode is among them.
fn quarter(from: u64) {
    let asked = std::env::var("WHEELOVER_SCRIPTS").ok();
    let all = asked.map_or(SCRIPTS, |count| count.parse().unwrap());
    let mut seen = Seen::new();
    for seed in from..from + all / 4 {
        script(seed, &mut seen);
    }
    for mode in [
        ModeName::Standby,
        ModeName::NfuOverride,
        ModeName::Auto,
        ModeName::AutonavTn,
        ModeName::AutonavTi,
        ModeName::Track,
        ModeName::RudderHold,
        ModeName::WindVane,
        ModeName::RiverPilot,
        ModeName::Dodge,
        ModeName::FfuOverride,
        ModeName::Installation,
        ModeName::Autotuning,
    ] {
        let times = seen.iter().filter(|seen| **seen == mode).count();
        println!("{mode:?}: entered {times} times");
        let enough = all >= SCRIPTS;
        assert!(times > 0 || !enough, "{mode:?} in none of {}", all / 4);
    }
}

// FA17
#[test]
fn a_quarter_of_the_scripts() {
    quarter(1_000_000);
}

#[test]
fn a_second_quarter() {
    quarter(2_000_000);
}

#[test]
fn a_third_quarter() {
    quarter(3_000_000);
}

#[test]
fn a_fourth_quarter() {
    quarter(4_000_000);
}
