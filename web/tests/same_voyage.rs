//! One voyage with faults, run natively and in wasm: it replays, the page's fold agrees, and both give the same bytes.
#![allow(clippy::unwrap_used)]

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use wheelover_core::recording;
use wheelover_core::time::Stamp;
use wheelover_core::view::{Down, FaultKind, Line, Lines, Order, Origin, hello, snapshot};
use wheelover_core::voyage::{Event, Voyage, VoyageConfig, VoyageOutput};
use wheelover_web::heard::{Agreement, Fold};

/// Seconds of the voyage: past its first turn.
const SECONDS: u64 = 240;

fn fault(cable: &str, kind: FaultKind, on: bool) -> Order {
    Order::Fault {
        cable: cable.to_owned(),
        kind,
        on,
    }
}

/// What happens, and when.
fn script() -> Vec<(u64, Order)> {
    vec![
        (100_000, fault("gyro1", FaultKind::Jump, true)),
        (104_000, fault("gyro1", FaultKind::Jump, false)),
        (140_000, fault("ecdis", FaultKind::Corrupt, true)),
        (142_000, fault("ecdis", FaultKind::Corrupt, false)),
        (180_000, fault("ecdis", FaultKind::Silent, true)),
        (195_000, fault("ecdis", FaultKind::Silent, false)),
        (
            200_000,
            Order::Current {
                set: 90.0,
                drift: 1.0,
            },
        ),
    ]
}

/// A voyage, its recording and the page's fold of it.
struct Sailed {
    recording: Vec<String>,
    fold: Fold,
    disagreed: usize,
    agreed: usize,
}

fn sail() -> Sailed {
    let config = VoyageConfig::embedded(7);
    let mut sailed = Sailed {
        recording: vec![recording::beginning(&config, "test")],
        fold: Fold::default(),
        disagreed: 0,
        agreed: 0,
    };
    let mut voyage = Voyage::configured(config);
    sailed.fold.greet(&hello(&voyage, "test"));
    let mut script = script().into_iter().peekable();
    let mut out = Vec::new();
    for step in 1..=SECONDS * 10 {
        let now = Stamp(step * 100);
        let event = match script.next_if(|(at, _)| *at <= now.0) {
            Some((at, action)) => {
                let event = Event::Order {
                    id: at,
                    by: Origin::Officer,
                    order: action,
                };
                sailed.recording.push(recording::event(now, &event));
                event
            }
            None => Event::Tick,
        };
        voyage.handle(now, event, &mut out);
        let mut lines: Vec<Line> = Vec::new();
        for output in out.drain(..) {
            sailed.recording.push(recording::output(now, &output));
            if let VoyageOutput::Line(line) = output {
                lines.push(line);
            }
        }
        if let Some(first) = lines.first() {
            // Through JSON, as it crosses to the browser.
            let down = Down::Lines(Lines {
                from: first.seq,
                lines,
            });
            let text = serde_json::to_string(&down).expect("every frame has a text");
            let Ok(Down::Lines(lines)) = serde_json::from_str(&text) else {
                panic!("lines come back as lines");
            };
            assert!(sailed.fold.lines(&lines), "no line is missing");
        }
        sailed.fold.snapshot(&snapshot(&voyage));
        match sailed.fold.agreement {
            Agreement::Agree => sailed.agreed += 1,
            Agreement::Disagree => sailed.disagreed += 1,
            Agreement::Unknown => {}
        }
    }
    sailed
}

fn digest(lines: &[String]) -> String {
    let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
    for byte in lines.iter().flat_map(|line| line.bytes()) {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
    format!("{hash:016x}")
}

#[test]
fn a_voyage_with_faults_replays_and_the_page_agrees_in_every_world() {
    let sailed = sail();
    assert_eq!(sailed.disagreed, 0, "{} snapshots agreed", sailed.agreed);
    assert!(
        sailed.agreed as u64 > SECONDS * 9,
        "only {} snapshots agreed",
        sailed.agreed
    );
    let replayed = recording::replay(sailed.recording.iter().map(String::as_str));
    assert_eq!(replayed.map(|replayed| replayed.difference), Ok(None));
    // `cargo xtask test` reads this natively and gives it to the build for wasm.
    // The first line says how they are made; what follows is what they did, however they are built.
    println!("OUTPUTS {}", digest(&sailed.recording[1..]));
    let digest = digest(&sailed.recording);
    println!("VOYAGE {digest}");
    if let Some(native) = option_env!("WHEELOVER_NATIVE_VOYAGE") {
        assert_eq!(digest, native, "wasm and native differ");
    }
}
