//! Bridge alert management on a real line: alerts, list and heartbeat out, commands in, refusals out (AP-11, F2).

use crate::{autopilot, command, fields};
use std::time::{Duration, Instant};
use wheelover_core::view::Order;
use wheelover_tests::folder;
use wheelover_tests::page::SOON;
use wheelover_tests::program::Program;
use wheelover_tests::serial::Line;

/// The first line that fits, as its fields.
fn until(line: &mut Line, what: &str, fits: impl Fn(&[&str]) -> bool) -> Vec<String> {
    let end = Instant::now() + SOON;
    while Instant::now() < end {
        if let Some((_, text)) = line.hear(Duration::from_millis(500)) {
            let fields = fields(&text);
            if fits(&fields) {
                return fields.into_iter().map(String::from).collect();
            }
        }
    }
    panic!("no {what} was heard");
}

#[tokio::test]
async fn alerts_go_out_and_commands_come_in_on_a_serial_line() {
    let folder = folder("management");
    let mut bams = Line::new(&folder.join("bams"));
    let _ecdis = Line::new(&folder.join("ecdis"));
    let config = autopilot(&folder, &["bams", "ecdis"], true);
    let program = Program::start(&["--config", &config]);
    let list = until(&mut bams, "ALC", |fields| fields[0] == "$AGALC");
    assert_eq!(list[1..3], ["01", "01"]);
    let beat = until(&mut bams, "HBT", |fields| fields[0] == "$AGHBT");
    assert_eq!(beat[1..], ["30.0", "A", "0"]);
    // Two masters of one command: an alarm of category B that needs no ship.
    let htc = "HTC,V,,,S,N,,,,,,,,T,C";
    let mut ecdis = _ecdis;
    let alf = loop {
        ecdis.say(&format!("EI{htc}"));
        ecdis.say(&format!("II{htc}"));
        let heard = bams.hear(Duration::from_millis(200));
        let fields: Vec<String> = heard.map_or(Vec::new(), |(_, line)| {
            fields(&line).into_iter().map(String::from).collect()
        });
        if fields.first().is_some_and(|address| address == "$AGALF") && fields[9] == "10103" {
            break fields;
        }
    };
    assert_eq!(alf[5..9], ["B", "A", "V", ""]);
    assert_eq!(alf[13], "HTC CONFLICT");
    let text = until(&mut bams, "the text", |fields| {
        fields[0] == "$AGALF" && fields[2] == "2" && fields[9] == "10103"
    });
    assert!(text[13].starts_with("HTC SOURCE CONFLICT"), "{text:?}");
    assert_eq!(text[5..8], ["", "", ""]);
    bams.say("BNACN,,,10103,1,S,C");
    until(&mut bams, "silenced", |f| {
        f[0] == "$AGALF" && f[9] == "10103" && f[7] == "S"
    });
    bams.say("BNACN,,,10103,1,O,C");
    let refused = until(&mut bams, "ARC", |fields| fields[0] == "$AGARC");
    assert_eq!(refused[3..], ["10103", "1", "O"]);
    bams.say("BNHBT,30.0,A,0");
    bams.say("BNACN,,,10103,1,A,C");
    until(&mut bams, "taken", |f| {
        f[0] == "$AGALF" && f[9] == "10103" && (f[7] == "A" || f[7] == "N")
    });
    // It is taken: here there is nothing left to acknowledge.
    assert!(!command(&program, Order::Acknowledge(103)).await.ok);
}
