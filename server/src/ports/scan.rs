//! `ports --scan`: listens to each serial port at the usual rates and says what is wrong and what to change. Nothing is sent.
//!
//! The judgement is the core's ([`wheelover_core::doctor`]); here are devices, rates and time: ten seconds at most a port, all
//! ports at once.

use super::list;
use crate::config::{Config, Place};
use crate::error::reason;
use serde_json::{Value, json};
use std::io;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, Instant};
use tokio_serial::{DataBits, FlowControl, Parity, SerialPort, StopBits};
use wheelover_core::doctor::{Diagnosis, Finding, Heard, Sample, diagnose};

/// Rates that are tried, the usual ones first, baud.
const RATES: [u32; 6] = [4_800, 38_400, 9_600, 19_200, 115_200, 57_600];
/// A rate is listened to for so long; sentences come once a second.
const TRY: Duration = Duration::from_millis(1_150);
/// Then the best one for so long, for how much there is of each.
const LISTEN: Duration = Duration::from_millis(2_400);
/// Longest wait for a byte.
const WAIT: Duration = Duration::from_millis(50);

/// A port to be listened to, and the rate that is set for it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Asked {
    path: PathBuf,
    set: Option<u32>,
}

/// What is to be listened to: the ports that are named, else those of a configuration, else all that there are.
pub(crate) fn asked(named: &[PathBuf], config: Option<&Config>) -> Vec<Asked> {
    let configured = |path: &Path| {
        let ports = config.iter().flat_map(|config| &config.ports);
        ports.into_iter().find_map(|port| match &port.place {
            Place::Serial(of, baud) if of == path => Some(*baud),
            _ => None,
        })
    };
    let paths: Vec<PathBuf> = match config {
        _ if !named.is_empty() => named.to_vec(),
        Some(config) => (config.ports.iter())
            .filter_map(|port| match &port.place {
                Place::Serial(path, _) => Some(path.clone()),
                _ => None,
            })
            .collect(),
        None => list::list().into_iter().map(|found| found.path).collect(),
    };
    let asked = paths.into_iter().map(|path| Asked {
        set: configured(&path),
        path,
    });
    asked.collect()
}

/// What was found of a port.
#[derive(Debug)]
pub(crate) struct Found {
    port: Asked,
    diagnosis: Result<Diagnosis, String>,
}

/// Listens to all ports at once.
pub(crate) fn scan(ports: Vec<Asked>) -> Vec<Found> {
    let listening: Vec<_> = (ports.into_iter())
        .map(|port| {
            thread::spawn(move || Found {
                diagnosis: listen(&port).map_err(|error| reason(&error)),
                port,
            })
        })
        .collect();
    let found = listening.into_iter().map(thread::JoinHandle::join);
    found.flatten().collect()
}

fn listen(port: &Asked) -> io::Result<Diagnosis> {
    let first = port.set.unwrap_or(RATES[0]);
    let mut device = tokio_serial::new(port.path.to_string_lossy(), first)
        .data_bits(DataBits::Eight)
        .parity(Parity::None)
        .stop_bits(StopBits::One)
        .flow_control(FlowControl::None)
        .timeout(WAIT)
        .open_native()?;
    let mut heard: Vec<(u32, u32, u64, Vec<u8>)> = Vec::new();
    let others = RATES.into_iter().filter(|rate| *rate != first);
    for rate in core::iter::once(first).chain(others) {
        // An adapter that cannot do a rate says so or goes at another one.
        let goes = match device.set_baud_rate(rate) {
            Ok(()) => device.baud_rate()?,
            Err(_) => device.baud_rate()?,
        };
        let (ms, bytes) = take(&mut device, TRY)?;
        let understood = [
            Heard::of(goes, ms, &bytes),
            Heard::of_swapped(goes, ms, &bytes),
        ]
        .iter()
        .any(Heard::is_understood);
        heard.push((rate, goes, ms, bytes));
        if understood {
            let (ms, bytes) = take(&mut device, LISTEN)?;
            heard.push((rate, goes, ms, bytes));
            break;
        }
    }
    let samples: Vec<Sample<'_>> = (heard.iter())
        .map(|(baud, goes, ms, bytes)| Sample {
            baud: *baud,
            goes: *goes,
            ms: *ms,
            bytes,
        })
        .collect();
    Ok(diagnose(port.set, &samples, &[]))
}

/// All that comes for so long; what came before, at another rate, is thrown away.
fn take(device: &mut impl SerialPort, time: Duration) -> io::Result<(u64, Vec<u8>)> {
    device.clear(tokio_serial::ClearBuffer::Input)?;
    let began = Instant::now();
    let (mut bytes, mut part) = (Vec::new(), [0; 1024]);
    while began.elapsed() < time {
        match device.read(&mut part) {
            Ok(0) => return Err(io::ErrorKind::BrokenPipe.into()),
            Ok(length) => bytes.extend_from_slice(&part[..length]),
            Err(error) if error.kind() == io::ErrorKind::TimedOut => {}
            Err(error) => return Err(error),
        }
    }
    let ms = began.elapsed().as_millis() as u64;
    Ok((ms, bytes))
}

impl Found {
    /// Whether there is nothing to be changed.
    pub(crate) fn is_good(&self) -> bool {
        matches!(&self.diagnosis, Ok(found) if found.findings == [Finding::Good])
    }

    /// What was found, in lines for a person.
    pub(crate) fn text(&self) -> String {
        let path = self.port.path.display();
        let found = match &self.diagnosis {
            Err(reason) => return format!("{path}\n  not listened to: {reason}"),
            Ok(found) => found,
        };
        let heard = &found.heard;
        let mut lines = vec![path.to_string()];
        if heard.valid > 0 {
            let each = heard.sentences.iter().map(|(address, count)| {
                let rate = *count as f64 * 1000.0 / heard.ms.max(1) as f64;
                format!("{address} {rate:.1}/s")
            });
            let each: Vec<String> = each.collect();
            lines.push(format!(
                "  {} baud, {} % full, talkers {}: {}",
                heard.baud,
                heard.load_percent(),
                heard.talkers().join(" "),
                each.join(", ")
            ));
        }
        lines.extend(
            found
                .findings
                .iter()
                .map(|finding| format!("  {}", finding.text())),
        );
        lines.join("\n")
    }

    /// What was found, as one object.
    pub(crate) fn json(&self) -> Value {
        let path = self.port.path.to_string_lossy();
        match &self.diagnosis {
            Err(reason) => json!({"port": path, "set": self.port.set, "error": reason}),
            Ok(found) => {
                let texts: Vec<String> = found.findings.iter().map(|each| each.text()).collect();
                json!({
                    "port": path,
                    "set": self.port.set,
                    "findings": found.findings,
                    "text": texts,
                    "heard": found.heard,
                    "load_percent": found.heard.load_percent(),
                    "talkers": found.heard.talkers(),
                })
            }
        }
    }
}
