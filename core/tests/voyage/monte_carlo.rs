//! Random fault scripts in fast time; what must hold in all of them (FA17, small form).

use crate::random::Random;
use crate::rig::{Rig, edited, route};
use std::sync::{Arc, Mutex};
use wheelover_core::alerts::Alert;
use wheelover_core::nmea;
use wheelover_core::station::Profile;
use wheelover_core::view::{ChartRequest, FaultKind, ModeName, ModeRequest, Order, Side};

/// What the cables do at the moment.
#[derive(Default)]
struct Damage {
    silent: Option<(Profile, &'static str)>,
    checksum: Option<&'static str>,
    not_valid: bool,
    override_in_use: bool,
    status: Option<&'static str>,
}

const SILENT: [(Profile, &str); 10] = [
    (Profile::Ecdis, ""),
    (Profile::Ecdis, "HTC,"),
    (Profile::Ecdis, "XTE,"),
    (Profile::Ecdis, "PNEY,001"),
    (Profile::Ecdis, "PNEY,002"),
    (Profile::Gyro1, ""),
    (Profile::Gps, ""),
    (Profile::Log, ""),
    (Profile::Gear, ""),
    (Profile::Wind, ""),
];

/// The operator's modes besides AUTO and AutoNAV.
const MODES: [ModeRequest; 6] = [
    ModeRequest::FfuOverride,
    ModeRequest::RiverPilot,
    ModeRequest::WindVane,
    ModeRequest::Dodge,
    ModeRequest::Installation,
    ModeRequest::Autotuning,
];

fn damaged(damage: &Damage, from: Profile, line: &str) -> Option<String> {
    if let Some((profile, formatter)) = damage.silent
        && from == profile
        && line.contains(formatter)
    {
        return None;
    }
    if damage
        .checksum
        .is_some_and(|formatter| line.contains(formatter))
    {
        return Some(format!("{}Z", &line[..line.len() - 1]));
    }
    let mut line = line.to_string();
    if line.contains("HTC,") {
        if damage.override_in_use {
            line = edited(&line, &[(1, "A")]);
        }
        if let Some(status) = damage.status {
            line = edited(&line, &[(14, status)]);
        }
    }
    if damage.not_valid && line.contains("XTE,") {
        line = edited(&line, &[(1, "V")]);
    }
    Some(line)
}

/// What the operator does on purpose counts as a reason.
fn act(rig: &mut Rig, random: &mut Random, damage: &Mutex<Damage>) -> bool {
    let mut damage = damage.lock().unwrap();
    match random.below(24) {
        0..=3 => damage.silent = Some(SILENT[random.below(10) as usize]),
        4 => damage.checksum = Some(["HTC,", "XTE,", "PNEY,001", "HDT"][random.below(4) as usize]),
        5 => damage.not_valid = !damage.not_valid,
        6 => damage.override_in_use = !damage.override_in_use,
        7 => damage.status = [Some("R"), None, Some("")][random.below(3) as usize],
        8 => {
            let on = random.below(2) == 0;
            rig.injure(Profile::Gyro1, FaultKind::Jump, on);
        }
        9 => {
            let on = random.below(2) == 0;
            rig.injure(Profile::Gps, FaultKind::Jump, on);
        }
        10 => {
            rig.stall(300);
        }
        11 => {
            let _ = rig.ask(ChartRequest::Stop);
        }
        12 => {
            let _ = rig.ask(ChartRequest::Heading);
        }
        13 => {
            drop(damage);
            let _ = rig.command(Order::Mode(ModeRequest::Standby));
            return true;
        }
        14 => {
            drop(damage);
            let _ = rig.command(Order::AdjustHeading(random.below(60) as f64 - 30.0));
            return true;
        }
        15..=17 => {
            drop(damage);
            let mode = MODES[random.below(6) as usize];
            if mode == ModeRequest::Installation {
                let _ = rig.command(Order::Mode(ModeRequest::Standby));
            }
            let _ = rig.command(Order::Mode(mode));
            if mode == ModeRequest::Autotuning {
                let _ = rig.command(Order::Mode(mode));
            }
            return true;
        }
        18..=20 => {
            drop(damage);
            let value = random.below(80) as f64 - 40.0;
            let side = if value < 0.0 {
                Side::Port
            } else {
                Side::Starboard
            };
            for order in [
                Order::SetRate(value),
                Order::SetRudder(value),
                Order::SetDodge(value),
                Order::SetWindAngle(value),
                Order::Tack(side),
            ] {
                let _ = rig.command(order);
            }
            return true;
        }
        _ => {
            // All is healed, and the officer brings the ship back under track control.
            *damage = Damage::default();
            drop(damage);
            rig.injure(Profile::Gyro1, FaultKind::Jump, false);
            rig.injure(Profile::Gps, FaultKind::Jump, false);
            if rig.mode() == ModeName::Installation {
                let _ = rig.command(Order::Mode(ModeRequest::Standby));
            }
            let _ = rig.command(Order::Mode(ModeRequest::Auto));
            let _ = rig.ask(ChartRequest::Track);
            let _ = rig.command(Order::Mode(ModeRequest::Autonav));
            return true;
        }
    }
    false
}

fn script(seed: u64) {
    let mut random = Random(seed);
    let mut rig = Rig::windy(route(&[(245.0, 1.6), (305.0, 2.0)], 0.5), seed);
    let damage = Arc::new(Mutex::new(Damage::default()));
    let on_cable = damage.clone();
    rig.filter(move |_, from, line| damaged(&on_cable.lock().unwrap(), from, line));
    rig.run(4.0);
    let _ = rig.command(Order::Mode(ModeRequest::Auto));
    rig.run(4.0);
    let _ = rig.ask(ChartRequest::Track);
    let _ = rig.command(Order::Mode(ModeRequest::Autonav));
    let mut next = rig.now + 5_000 + random.below(60_000);
    for _ in 0..2_400 {
        let before = rig.mode();
        let mut wanted = false;
        if rig.now >= next {
            next = rig.now + 2_000 + random.below(25_000);
            wanted = act(&mut rig, &mut random, &damage);
        }
        rig.step();
        let (now, raised) = (rig.mode(), |alert| rig.raised(alert));
        if wanted || before == now {
            continue;
        }
        // Every fallback has its alarm, at once.
        let at = rig.now.seconds();
        match now {
            // It ends by itself, on the heading before.
            ModeName::Auto if before == ModeName::Autotuning => {}
            ModeName::Auto if before == ModeName::WindVane => {
                assert!(raised(Alert::WindLost), "seed {seed} at {at} s");
            }
            ModeName::Auto => assert!(
                raised(Alert::TrackFail),
                "seed {seed} at {at} s: {before:?}"
            ),
            ModeName::RudderHold => assert!(raised(Alert::HeadingLost), "seed {seed} at {at} s"),
            ModeName::Standby => assert!(raised(Alert::Override), "seed {seed} at {at} s"),
            _ => {}
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

fn scripts(from: u64, count: u64) {
    for seed in from..from + count {
        script(seed);
    }
}

// FA17: a thousand, so many that they run within a minute; seeds are fixed and told.
#[test]
fn a_quarter_of_a_thousand_scripts() {
    scripts(1_000, 250);
}

#[test]
fn a_second_quarter() {
    scripts(2_000, 250);
}

#[test]
fn a_third_quarter() {
    scripts(3_000, 250);
}

#[test]
fn a_fourth_quarter() {
    scripts(4_000, 250);
}
