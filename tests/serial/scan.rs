//! `ports --scan` listens to lines and says what to change (FB10, FB12). A pseudo-terminal has no rate: that a line speaks at another
//! one is proved in the core, bit by bit.

use serde_json::Value;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use wheelover_tests::program::binary;
use wheelover_tests::serial::Line;
use wheelover_tests::{folder, with_checksum};

/// What is played on a line, and what must be found of it.
struct Played {
    name: &'static str,
    /// The bytes of a second.
    bytes: Vec<u8>,
    found: &'static [&'static str],
    heard: &'static [&'static str],
}

fn sentences(bodies: &[&str]) -> Vec<u8> {
    let lines = bodies.iter().map(|body| with_checksum(body) + "\r\n");
    lines.collect::<String>().into_bytes()
}

#[test]
fn each_line_is_told_right_within_ten_seconds() {
    let folder = folder("scan");
    let gyro = sentences(&["HEHDT,216.8,T", "HEROT,-027.5,A"]);
    let gps = sentences(&[
        "GPGLL,5400.1234,N,00730.5678,E,120000.00,A,D",
        "GPVTG,216.8,T,,M,15.0,N,27.8,K,D",
    ]);
    let spoilt = {
        // One sentence of two is damaged.
        let mut spoilt = gyro.clone();
        spoilt[8] ^= 4;
        [spoilt, gyro.clone()].concat()
    };
    let inverted = gps.iter().map(|byte| !byte).collect();
    let crowded = gps.repeat(6);
    let lines = [
        Played {
            name: "good",
            bytes: gyro.clone(),
            found: &["good"],
            heard: &["HEHDT", "HEROT"],
        },
        Played {
            name: "swapped",
            bytes: inverted,
            found: &["swapped"],
            heard: &["GPGLL", "GPVTG"],
        },
        Played {
            name: "spoilt",
            bytes: spoilt,
            found: &["damaged"],
            heard: &["HEHDT", "HEROT"],
        },
        Played {
            name: "crowded",
            bytes: crowded,
            found: &["overloaded"],
            heard: &["GPGLL", "GPVTG"],
        },
        Played {
            name: "noise",
            bytes: (0..400_u32)
                .map(|at| ((at * at * 7 + at * 31) >> 2) as u8)
                .collect(),
            found: &["noise"],
            heard: &[],
        },
        Played {
            name: "silent",
            bytes: Vec::new(),
            found: &["silent"],
            heard: &[],
        },
    ];
    let mut ports: Vec<Line> = lines
        .iter()
        .map(|line| Line::new(&folder.join(line.name)))
        .collect();
    let mut config = String::from("roles = [\"autopilot\"]\n");
    for (line, profile) in lines
        .iter()
        .zip(["gyro1", "gps", "gyro2", "log", "rot", "wind"])
    {
        let path = folder.join(line.name);
        config += &format!(
            "[[port]]\nname = \"{}\"\nkind = \"serial\"\npath = \"{}\"\nbaud = 4800\nprofile = \"{profile}\"\n",
            line.name,
            path.display()
        );
    }
    let file = folder.join("wheelover.toml");
    std::fs::write(&file, config).unwrap();
    let began = Instant::now();
    let mut scan = Command::new(binary())
        .args(["ports", "--scan", "--json", "--config"])
        .arg(&file)
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    while scan.try_wait().unwrap().is_none() {
        assert!(began.elapsed() < Duration::from_secs(40), "it does not end");
        for (line, port) in lines.iter().zip(&mut ports) {
            if line.bytes.is_empty() {
                continue;
            }
            port.send(&line.bytes);
        }
        std::thread::sleep(Duration::from_millis(250));
    }
    let output = scan.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(1), "there are findings");
    let said = String::from_utf8(output.stdout).unwrap();
    let found: Vec<Value> = said
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(found.len(), lines.len(), "{said}");
    for (line, found) in lines.iter().zip(&found) {
        let named = found["findings"]
            .as_array()
            .unwrap()
            .iter()
            .map(|finding| match finding {
                Value::String(name) => name.clone(),
                other => {
                    let (name, of) = other.as_object().unwrap().iter().next().unwrap();
                    match of.get("baud") {
                        Some(baud) => format!("{name} {baud}"),
                        None => name.clone(),
                    }
                }
            });
        let named: Vec<String> = named.collect();
        assert_eq!(named, line.found, "{}: {found}", line.name);
        let heard: Vec<&String> = found["heard"]["sentences"]
            .as_object()
            .unwrap()
            .keys()
            .collect();
        assert_eq!(heard, line.heard, "{}", line.name);
        assert!(found["heard"]["ms"].as_u64().unwrap() < 10_000);
    }
    // The time that ten busy tests leave to a process is not the program's.
    eprintln!("scanned in {:.1} s", began.elapsed().as_secs_f64());
}
