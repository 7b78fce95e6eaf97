//! The chart system on real ports without a route monitors none: situation 1 with null fields (TCS-2).

use crate::fields;
use std::time::Duration;
use wheelover_tests::page::SOON;
use wheelover_tests::program::Program;
use wheelover_tests::serial::Line;
use wheelover_tests::{folder, with_checksum};

#[test]
fn without_a_route_it_says_so_and_sails_no_other() {
    let folder = folder("no_route");
    let mut autopilot = Line::new(&folder.join("ecdis"));
    let (gps, gyro) = (
        Line::new(&folder.join("gps")),
        Line::new(&folder.join("gyro1")),
    );
    let mut text = "roles = [\"chart_system\"]\nallow_output = true\n".to_string();
    for name in ["ecdis", "gps", "gyro1"] {
        text += &format!(
            "[[port]]\nname = \"{name}\"\nkind = \"serial\"\npath = \"{}\"\nbaud = 38400\nprofile = \"{name}\"\n\
             output = {}\n",
            folder.join(name).display(),
            name == "ecdis"
        );
    }
    let config = folder.join("wheelover.toml");
    std::fs::write(&config, text).unwrap();
    let _program = Program::start(&["--config", config.to_str().unwrap()]);
    // A good position in another sea than the embedded route's.
    let _gps = gps.talk(|tick| match tick % 10 {
        0 => vec![
            with_checksum("GPGLL,5400.000,N,01000.000,E,120000.00,A,A"),
            with_checksum("GPVTG,100.0,T,,M,12.00,N,22.20,K,A"),
        ],
        _ => vec![],
    });
    let _gyro = gyro.talk(|_| vec![with_checksum("HEHDT,100.00,T")]);
    // Until the position has come through.
    let end = std::time::Instant::now() + SOON;
    loop {
        let (_, line) = autopilot.hear(SOON).expect("the chart system speaks");
        if line.starts_with("$EIGLL") && line.contains(",A,A*") {
            break;
        }
        assert!(std::time::Instant::now() < end, "no position in {line}");
    }
    let lines = autopilot.listen(Duration::from_millis(3_500));
    for (address, seconds) in [
        ("$EIHTC", 3),
        ("$EIXTE", 3),
        ("$PNEY,001", 3),
        ("$PNEY,002", 3),
    ] {
        let said: Vec<_> = lines
            .iter()
            .filter(|line| line.1.starts_with(address))
            .collect();
        assert!(said.len() >= seconds, "{address}: {lines:?}");
        for (_, line) in said {
            let fields = fields(line);
            let null =
                |from: usize, to: usize| fields[from..=to].iter().all(|text| text.is_empty());
            match address {
                // No steering mode but standalone, nothing commanded.
                "$EIHTC" => assert!(fields[4] == "S" && null(6, 12), "{line}"),
                "$EIXTE" => assert!(null(3, 4), "{line}"),
                "$PNEY,001" => assert!(null(4, 5), "{line}"),
                _ => assert!(null(2, fields.len() - 1), "{line}"),
            }
        }
    }
}
