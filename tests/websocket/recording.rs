//! `--record` and `replay`: a voyage with faults runs again to the same bytes, and a changed byte is found (CFG-1).

use std::process::Command;
use std::time::Duration;
use wheelover_core::view::{FaultKind, Order};
use wheelover_tests::folder;
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::{Program, binary};

#[tokio::test]
async fn a_recorded_voyage_with_faults_replays_with_identical_outputs() {
    let folder = folder("record");
    let file = folder.join("voyage.jsonl");
    let name = file.display().to_string();
    let mut program = Program::start(&["--speed", "20", "--record", &name]);
    let mut page = Page::open(program.address).await;
    page.until("half a minute of lines", SOON, |page| {
        page.lines.len() > 1_500
    })
    .await;
    for (cable, kind) in [
        ("ecdis", FaultKind::Silent),
        ("gyro1", FaultKind::Jump),
        ("gps", FaultKind::Jump),
        ("ecdis", FaultKind::Corrupt),
        ("log", FaultKind::Delayed),
    ] {
        for on in [true, false] {
            let cable = cable.to_string();
            assert!(page.command(Order::Fault { cable, kind, on }).await.ok);
            page.follow(Duration::from_millis(600)).await;
        }
    }
    page.leave().await;
    program.stop();
    let replay = |path: &str| {
        Command::new(binary())
            .args(["replay", path])
            .output()
            .unwrap()
    };
    let done = replay(&name);
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    assert_eq!(done.status.code(), Some(0), "{said}");

    // One order changed by a tenth of a degree is the first difference.
    let text = std::fs::read_to_string(&file).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let index = lines
        .iter()
        .rposition(|line| line.contains("AGROR"))
        .unwrap();
    let changed = lines[index].replacen("AGROR", "AGRO0", 1);
    let tampered = lines.iter().enumerate();
    let tampered: Vec<&str> = tampered
        .map(|(i, line)| if i == index { changed.as_str() } else { line })
        .collect();
    let other = folder.join("tampered.jsonl");
    std::fs::write(&other, tampered.join("\n")).unwrap();
    let done = replay(&other.display().to_string());
    assert_ne!(done.status.code(), Some(0));
    let mut said = String::from_utf8_lossy(&done.stderr).into_owned();
    said += &String::from_utf8_lossy(&done.stdout);
    assert!(said.contains(&format!("line {}", index + 1)), "{said}");
}
