//! Garbage, damaged and foreign commands on the chart system's line: counted, shown, without effect (SEN-2, SEN-5, FB5).

use crate::{autopilot, fields};
use std::time::Duration;
use wheelover_core::view::{ModeRequest, Order};
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::Line;
use wheelover_tests::{folder, with_checksum};

/// As the documents print them, with the commas that they lost, and as no document would.
const BODIES: [&str; 15] = [
    "EIHTC,V,,,S,N,,,,,,T,C",
    "EIHTC,V,,,H,N,,,028,345.4,,355.0,T,C",
    "EIHTC,V,,,H,T,,,028,345.4,,355.0,T,C",
    "EIHTC,V,,,T,R,,,,,245.0,T,C",
    "EIHTC,V,,,T,R,,,0.35,,,280.0,T,C",
    "EIHTC,V,,,T,R,,,,,280.0,T,C",
    "EIHTC,V,30.0,R,R,N,,,,,,,,T,C",
    "EIHTC,V,,,H,N,,,,,345.4,,400.0,T,C",
    "EIHTC,V,,,H,N,,,,,361.0,,355.0,T,C",
    "EIHTC,V,,,H,N,,,,,345.4,,355.0,M,C",
    "EIHTC,V,,,H,N,,,,,345.4,,355.0,T,R",
    "EIHTC,X,,,H,N,,,,,345.4,,355.0,T,C",
    "EIHTC,V,,,H,Q,,,,,345.4,,355.0,T,C",
    "EIHTC,V,,,H,N,,,,,NaN,,355.0,T,C",
    "EIHTC,V,,,H,N,,,,,345.4",
];

/// Rudder orders that come out of the gear's line.
fn orders(gear: &mut Line, time: Duration) -> Vec<f64> {
    let lines = gear.listen(time);
    let orders = lines.iter().filter(|line| line.1.starts_with("$AGROR"));
    orders
        .filter(|line| fields(&line.1)[2] == "A")
        .filter_map(|line| fields(&line.1)[1].parse().ok())
        .collect()
}

fn assert_still(orders: &[f64], after: &str) {
    assert!(!orders.is_empty(), "no orders after {after}");
    let largest = orders
        .iter()
        .fold(0.0_f64, |most, order| most.max(order.abs()));
    assert!(largest < 1.0, "order {largest} after {after}");
}

#[tokio::test]
async fn nothing_malformed_moves_the_rudder() {
    let folder = folder("hostile");
    let mut ecdis = Line::new(&folder.join("ecdis"));
    let compass = Line::new(&folder.join("gyro1"));
    let mut gear = Line::new(&folder.join("gear"));
    let speed = Line::new(&folder.join("gps"));
    let config = autopilot(&folder, &["ecdis", "gyro1", "gps", "gear"], true);
    let program = Program::start(&["--config", &config]);
    let _compass = compass.talk(|_| {
        vec![
            with_checksum("HEHDT,100.00,T"),
            with_checksum("HEROT,0.00,A"),
        ]
    });
    let _speed = speed.talk(|tick| {
        let vtg = with_checksum("GPVTG,100.0,T,,M,12.00,N,22.20,K,D");
        if tick % 10 == 0 { vec![vtg] } else { vec![] }
    });
    let mut page = Page::open(program.address).await;
    page.insist(Order::Mode(ModeRequest::Auto), SOON).await;
    page.insist(Order::Mode(ModeRequest::Autonav), SOON).await;
    page.leave().await;
    gear.listen(Duration::from_millis(300));

    // SEN-5, three in a row each, so that FA14 is not what refuses them.
    for body in BODIES {
        for _ in 0..3 {
            ecdis.say(body);
        }
        assert_still(&orders(&mut gear, Duration::from_millis(700)), body);
    }
    // SEN-2: a good command with a wrong checksum, and with none.
    let good = "EIHTC,V,,,H,N,,,,,345.4,,355.0,T,C";
    for line in [format!("${good}*00\r\n"), format!("${good}\r\n")] {
        for _ in 0..4 {
            ecdis.send(line.as_bytes());
        }
        assert_still(&orders(&mut gear, Duration::from_millis(700)), &line);
    }
    // Garbage, zeros, half sentences, high bits.
    ecdis.send(b"\0\0\xff\xfe$$$EIHTC,V,,,H,\r\n\r\n$*\r\n!\x80\x81,,,*7\r\n$EIHTC*56\r\n");
    assert_still(&orders(&mut gear, Duration::from_millis(700)), "garbage");

    // 10 MB without an end of line: memory stays, and the line is heard again afterwards.
    let before = program.memory_kb();
    let block = vec![b'A'; 64 * 1024];
    for _ in 0..160 {
        ecdis.send(&block);
    }
    let grown = program.memory_kb().saturating_sub(before);
    assert!(grown < 8 * 1024, "{grown} kB more");
    ecdis.send(b"\r\n");
    assert_still(&orders(&mut gear, Duration::from_secs(2)), "10 MB");

    // Counted and shown; the mode is still AUTO.
    let mut page = Page::open(program.address).await;
    page.until("the counts", SOON, |page| {
        let ports = page.ports.as_ref().map(|ports| &ports.ports);
        let port = ports.and_then(|ports| ports.iter().find(|port| port.name == "ecdis"));
        port.is_some_and(|port| port.bad_checksum >= 8 && port.garbage > 0)
    })
    .await;
    let last = ecdis.listen(Duration::from_millis(2_500));
    let htd = last.iter().rev().find(|line| line.1.starts_with("$AGHTD"));
    assert_eq!(fields(&htd.expect("HTD").1)[4], "S");
}
