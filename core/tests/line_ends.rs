//! SEN-1: a line ends with CR LF, LF or CR, with the next `$`, or after half a second without a byte.

use wheelover_core::autopilot::Autopilot;
use wheelover_core::autopilot::steering::SteeringSettings;
use wheelover_core::settings::Settings;
use wheelover_core::station::{ChecksumPolicy, Direction, Input, Output, PortSetup, Profile};
use wheelover_core::time::Stamp;

/// What an autopilot hears of bytes that come at 1.0 s, until that time, milliseconds.
fn heard(bytes: &[u8], until: u64) -> Vec<String> {
    let ports = vec![PortSetup {
        name: "gyro1".into(),
        profile: Profile::Gyro1,
        checksum: ChecksumPolicy::Required,
        talkers: Vec::new(),
        baud: 4_800,
        output: false,
    }];
    let mut autopilot = Autopilot::new(
        ports,
        Settings::default(),
        Some(SteeringSettings::default()),
        Stamp(0),
    );
    let mut out = Vec::new();
    autopilot.handle(Stamp(1_000), Input::Bytes { port: 0, bytes }, &mut out);
    autopilot.handle(Stamp(until), Input::Tick, &mut out);
    let line = |output| match output {
        Output::Line {
            dir: Direction::In,
            text,
            ..
        } => Some(String::from_utf8_lossy(&text).into_owned()),
        _ => None,
    };
    out.into_iter().filter_map(line).collect()
}

#[test]
fn a_line_without_an_end_is_taken_after_half_a_second() {
    let line = "$HEHDT,216.8,T*22";
    for end in ["\r\n", "\n", "\r", "$"] {
        let found = heard(format!("{line}{end}").as_bytes(), 1_000);
        assert_eq!(found, [line], "{end:?}");
    }
    assert!(heard(line.as_bytes(), 1_400).is_empty());
    assert_eq!(heard(line.as_bytes(), 1_700), [line]);
}
