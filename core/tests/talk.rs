//! What the stations say is what the table of talk says; alert reports keep within their share of the line (AP-11).
#![allow(clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use wheelover_core::autopilot::Autopilot;
use wheelover_core::chart_system::{ChartConfig, ChartSystem};
use wheelover_core::nmea::decode;
use wheelover_core::settings::Settings;
use wheelover_core::station::{ChecksumPolicy, Input, Output, PortSetup, Profile, Role};
use wheelover_core::talk::{self, When};
use wheelover_core::time::Stamp;
use wheelover_core::units::Speed;
use wheelover_core::world::{World, WorldConfig};

fn ports(baud: u32) -> Vec<PortSetup> {
    let port = |profile: Profile| PortSetup {
        name: profile.name().to_string(),
        profile,
        checksum: ChecksumPolicy::Required,
        talkers: Vec::new(),
        baud,
        output: true,
    };
    assert_eq!(Profile::ALL[BAMS], Profile::Bams);
    Profile::ALL.map(port).to_vec()
}

/// Its place among the ports.
const BAMS: usize = 15;

/// What bridge alert management says at `now`: a heartbeat that is not repeated, and a command that is refused.
fn management(now: Stamp) -> &'static [u8] {
    match now.0 {
        50 => b"$BNHBT,1.0,A,0*20\r\n",
        1_000 => b"$BNACN,,,10999,,A,C*7A\r\n",
        _ => b"",
    }
}

/// What a station said: when, on which profile, which line.
type Said = Vec<(Stamp, Profile, String)>;

/// Runs a station for so many seconds, a step of 50 ms after the other.
fn said(ports: &[PortSetup], seconds: u64, mut step: impl FnMut(Stamp, &mut Vec<Output>)) -> Said {
    let mut said = Vec::new();
    for number in 1..=seconds * 20 {
        let now = Stamp(number * 50);
        let mut out = Vec::new();
        step(now, &mut out);
        for output in out {
            if let Output::Send { port, bytes } = output {
                let text = String::from_utf8(bytes).unwrap();
                let lines = text.split_inclusive("\r\n");
                said.extend(lines.map(|line| (now, ports[port].profile, line.to_string())));
            }
        }
    }
    said
}

fn autopilot(baud: u32, step_hz: f64, seconds: u64) -> Said {
    let ports = ports(baud);
    let settings = Settings {
        step_hz,
        ..Settings::default()
    };
    let mut autopilot = Autopilot::new(ports.clone(), settings, None, Stamp(0));
    said(&ports, seconds, |now, out| {
        let heading = wheelover_core::nmea::with_checksum("HEHDT,245.0,T") + "\r\n";
        let bytes = heading.as_bytes();
        autopilot.handle(now, Input::Bytes { port: 1, bytes }, out);
        let (port, bytes) = (BAMS, management(now));
        autopilot.handle(now, Input::Bytes { port, bytes }, out);
    })
}

#[test]
fn each_station_says_what_the_table_says_as_often_and_no_longer() {
    const SECONDS: u64 = 20;
    let all = ports(38_400);
    let mut chart = ChartSystem::new(ChartConfig {
        ports: all.clone(),
        ..ChartConfig::default()
    });
    let mut world = World::new(WorldConfig {
        ports: all.clone(),
        wind_speed: Speed::from_knots(12.0),
        ..WorldConfig::default()
    });
    let chart = said(&all, SECONDS, |now, out| {
        let (port, bytes) = (BAMS, management(now));
        chart.handle(now, Input::Bytes { port, bytes }, out);
    });
    let world = said(&all, SECONDS, |now, out| {
        world.handle(now, Input::Tick, out);
    });
    let autopilot = autopilot(38_400, 10.0, SECONDS);
    for (station, lines) in [
        (Role::Autopilot, autopilot),
        (Role::ChartSystem, chart),
        (Role::World, world),
    ] {
        let mut counts: BTreeMap<(&str, String), u64> = BTreeMap::new();
        for (_, profile, line) in &lines {
            let sentence = decode(line.trim_end().as_bytes());
            let rows = talk::told(station, *profile);
            let row = rows
                .iter()
                .find(|row| row.formatter() == sentence.formatter)
                .unwrap_or_else(|| panic!("{station:?} {profile:?} {line}"));
            let longest = row.saying.definition().longest();
            assert!(line.len() <= longest, "{longest}: {line}");
            let talker = row.talker.unwrap_or("HE");
            assert_eq!(sentence.talker(), talker, "{line}");
            let key = (profile.name(), row.formatter().to_string());
            *counts.entry(key).or_default() += 1;
        }
        for profile in Profile::ALL {
            for row in talk::told(station, profile) {
                let count = counts.get(&(profile.name(), row.formatter().to_string()));
                let count = count.copied().unwrap_or_default();
                let magnetic = ["HDG", "HDM", "XDR"].contains(&row.formatter());
                let expect = match row.when {
                    // Of a magnetic compass or an inclinometer, where here a gyro is.
                    _ if magnetic && station == Role::Autopilot => 0,
                    When::Every(period) => SECONDS * 1_000 / period,
                    When::Renewed(period) => (SECONDS * 1_000 / period).max(1),
                    When::Step => SECONDS * 10,
                    When::Change => count.max(1),
                    When::Asked | When::Requested => count,
                    When::Operated => 0,
                };
                assert!(
                    (expect..=expect + 1).contains(&count),
                    "{station:?} {profile:?} {}: {count} of {expect}",
                    row.formatter()
                );
            }
        }
    }
}

#[test]
fn alert_reports_take_their_share_of_the_line_whatever_the_step() {
    for (baud, share) in [(4_800, 129), (38_400, 1_036)] {
        for step_hz in [5.0, 10.0, 20.0] {
            let lines = autopilot(baud, step_hz, 24);
            let reports: Vec<(u64, usize)> = lines
                .iter()
                .filter(|(_, profile, _)| *profile == Profile::Ecdis)
                .filter(|(_, _, line)| line.contains("ALR,") || line.contains("ALA,"))
                .map(|(now, _, line)| (now.0, line.len()))
                .collect();
            for (from, _) in &reports {
                let second = reports
                    .iter()
                    .filter(|(at, _)| (*from..*from + 1_000).contains(at));
                let bytes: usize = second.map(|(_, length)| length).sum();
                assert!(
                    bytes <= share,
                    "{baud} baud at {step_hz} Hz: {bytes} bytes in a second, {share} allowed"
                );
            }
            // Each alert of the autopilot once, and a faster line is through sooner.
            let numbers: BTreeSet<&str> = lines
                .iter()
                .filter(|(_, _, line)| line.contains("ALR,"))
                .filter_map(|(_, _, line)| line.split(',').nth(2))
                .collect();
            assert!(numbers.len() > 15, "{numbers:?}");
            let mut told = BTreeMap::new();
            for (at, _, line) in lines.iter().filter(|(.., line)| line.contains("ALA,")) {
                told.entry(line.split(',').nth(5).unwrap()).or_insert(at.0);
            }
            let last = told.values().copied().max().unwrap();
            let each = if baud == 4_800 { 650 } else { 65 };
            let limit = each * numbers.len() as u64;
            assert!(last <= limit, "{baud} baud at {step_hz} Hz: {last} ms");
        }
    }
}

#[test]
fn the_document_of_the_talk_is_up_to_date() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs/talk.md");
    let document = talk::document();
    if std::env::var_os("WHEELOVER_REWRITE").is_some() {
        std::fs::write(&path, &document).expect("the document is written");
    }
    let written = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        written == document,
        "docs/talk.md is not what the tables say; WHEELOVER_REWRITE=1 writes it"
    );
}
