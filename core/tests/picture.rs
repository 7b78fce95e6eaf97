//! The picture is the same whether a line was decoded by the whole dictionary or by the part that a picture needs.

use std::fs;
use wheelover_core::nmea::{decode, with_checksum};
use wheelover_core::picture::{self, Picture};
use wheelover_core::station::{ChecksumPolicy, Direction, PortSetup, Profile, Role};
use wheelover_core::time::Stamp;

/// Every sentence line that stands in the samples and the printed examples, right and wrong ones.
fn lines() -> Vec<Vec<u8>> {
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data");
    let mut lines = Vec::new();
    for folder in ["samples", "seeds", "dialogues"] {
        for entry in fs::read_dir(format!("{data}/{folder}"))
            .expect("the folder")
            .flatten()
        {
            let content = fs::read(entry.path()).expect("the file");
            for line in content.split(|&byte| byte == b'\n') {
                if let Some(start) = line.iter().position(|byte| matches!(byte, b'$' | b'!')) {
                    let line = line[start..].trim_ascii_end();
                    lines.push(match line.strip_suffix(b"*hh") {
                        // A placeholder of the documents.
                        Some(body) => {
                            let body = String::from_utf8_lossy(&body[1..]);
                            with_checksum(&body).into_bytes()
                        }
                        None => line.to_vec(),
                    });
                }
            }
        }
    }
    lines
}

#[test]
fn the_part_of_the_dictionary_is_enough_for_the_picture() {
    let port = |profile| PortSetup {
        name: format!("{profile:?}"),
        profile,
        checksum: ChecksumPolicy::Optional,
        talkers: Vec::new(),
        baud: 4800,
        output: true,
    };
    let mut whole = Picture::new(Role::Autopilot, Profile::ALL.map(port).to_vec());
    let mut part = whole.clone();
    let lines = lines();
    assert!(lines.len() > 200, "{} lines", lines.len());
    let (mut changes, mut ever) = (0, [false; 3]);
    for (index, line) in lines.iter().enumerate() {
        for (port, profile) in Profile::ALL.into_iter().enumerate() {
            for dir in [Direction::In, Direction::Out] {
                let (at, before) = (Stamp(index as u64 * 100), whole.digest());
                whole.fold_sentence(at, port, dir, &decode(line));
                part.fold_sentence(at, port, dir, &picture::decode(line));
                let shown = String::from_utf8_lossy(line);
                assert_eq!(whole, part, "{shown} on {profile:?}, {dir:?}");
                changes += usize::from(whole.digest() != before);
                let now = [
                    whole.htc.is_some(),
                    whole.htd.is_some(),
                    whole.pney2.is_some(),
                ];
                ever = [0, 1, 2].map(|n| ever[n] || now[n]);
            }
        }
    }
    assert!(changes > 1_000, "{changes} changes");
    assert_eq!(whole.digest(), part.digest());
    assert_eq!(ever, [true; 3], "HTC, HTD and PNEY,002 were heard");
    assert!(!whole.headings.is_empty() && !whole.fixes.is_empty() && !whole.rates.is_empty());
}

/// What a picture is after these lines on one port.
fn heard(profile: Profile, lines: &[&str]) -> Picture {
    heard_from(&[], profile, lines)
}

/// As [`heard`], on a port that believes these talkers only.
fn heard_from(talkers: &[&str], profile: Profile, lines: &[&str]) -> Picture {
    let port = PortSetup {
        name: "port".into(),
        profile,
        checksum: ChecksumPolicy::Required,
        talkers: talkers.iter().map(ToString::to_string).collect(),
        baud: 4800,
        output: false,
    };
    let mut picture = Picture::new(Role::Autopilot, vec![port]);
    for line in lines {
        picture.fold(
            Stamp(1_000),
            0,
            Direction::In,
            with_checksum(line).as_bytes(),
        );
    }
    picture
}

// SEN-3
#[test]
fn a_port_that_names_its_talkers_believes_no_other_and_proprietary_sentences() {
    let command = "HTC,V,,,T,R,,,,,,,245.0,T,C";
    let lines = ["EI", "RA"].map(|talker| format!("{talker}{command}"));
    for (talkers, believed) in [(&[][..], 2), (&["EI"], 1), (&["RA", "EI"], 2), (&["GP"], 0)] {
        let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
        let picture = heard_from(talkers, Profile::Ecdis, &lines);
        let count = &picture.counts[0];
        assert_eq!(
            (count.heard, count.unused),
            (2, 2 - believed),
            "{talkers:?}"
        );
        assert_eq!(picture.htc.is_some(), believed > 0, "{talkers:?}");
    }
    let proprietary = heard_from(&["EI"], Profile::Ecdis, &["PNEY,001,A,A,0.012,R,N,D"]);
    assert!(proprietary.pney1.is_some());
}

// AP-9: every sentence that tells a position, with each mode indicator or quality that counts and each that does not.
#[test]
fn a_position_is_taken_from_every_sentence_in_every_valid_mode_and_in_no_other() {
    let place = "5959.000,N,02455.000,E";
    let check = |body: &str, corrected: Option<bool>| {
        for profile in [Profile::Gps, Profile::Gps2] {
            let picture = heard(profile, &[body]);
            let fix = picture.fixes.first().map(|heard| heard.value.corrected());
            assert_eq!(fix, corrected, "{body} on {profile:?}");
        }
        assert!(heard(Profile::Log, &[body]).fixes.is_empty(), "{body}");
    };
    for (mode, valid) in "ADPFRESMN"
        .chars()
        .zip([true; 5].into_iter().chain([false; 4]))
    {
        let expect = valid.then_some(mode != 'A');
        check(&format!("GPGLL,{place},120000.00,A,{mode}"), expect);
        check(
            &format!("GPRMC,120000.00,A,{place},9.5,245.0,281126,7.5,E,{mode},S"),
            expect,
        );
        check(
            &format!("GNGNS,120000.00,{place},{mode}N,08,1.0,5.0,20.0,,,S"),
            expect,
        );
        check(
            &format!("GNGNS,120000.00,{place},N{mode},08,1.0,5.0,20.0,,,S"),
            expect,
        );
    }
    check(
        &format!("GNGNS,120000.00,{place},AD,08,1.0,5.0,20.0,,,S"),
        Some(true),
    );
    check(&format!("GPGLL,{place},120000.00,V,A"), None);
    for quality in 0..=8 {
        let expect = (1..=5).contains(&quality).then_some(quality > 1);
        check(
            &format!("GPGGA,120000.00,{place},{quality},08,1.0,5.0,M,20.0,M,,"),
            expect,
        );
    }
}

// AP-9: HDT, THS in mode A only, HDG and HDM; each on its own ports.
#[test]
fn a_heading_is_taken_from_every_compass_on_its_own_port_only() {
    let check = |body: &str, ports: &[Profile], degrees: Option<f64>| {
        for profile in Profile::ALL {
            let picture = heard(profile, &[body]);
            let said = picture.headings.first();
            let said = said.map(|heard| heard.value.true_heading(None).map(|h| h.deg()));
            let expect = ports.contains(&profile).then_some(degrees);
            assert_eq!(said, expect, "{body} on {profile:?}");
        }
    };
    let true_ports = [Profile::Gyro1, Profile::Gyro2, Profile::Thd];
    let with_imu = [true_ports.as_slice(), &[Profile::Imu]].concat();
    check("HEHDT,100.5,T", &with_imu, Some(100.5));
    check("HETHS,100.5,A", &true_ports, Some(100.5));
    for mode in ["E", "M", "S", "V"] {
        check(&format!("HETHS,100.5,{mode}"), &[], None);
    }
    let magnetic = [Profile::Magn, Profile::Imu];
    check("HCHDG,100.5,1.5,W,3.0,E", &magnetic, Some(102.0));
    check("HCHDG,100.5,1.5,W,,", &magnetic, None);
    // Whether a plotter's is used, the setting `external_compass` says (EMC-5).
    let with_plotter = [magnetic.as_slice(), &[Profile::Plotter]].concat();
    check("HCHDM,100.5,M", &with_plotter, None);
    let varied = heard(Profile::Magn, &["HCHDG,100.5,1.5,W,3.0,E", "HCHDM,99.0,M"]);
    assert_eq!(varied.variation(Stamp(2_000)), Some(3.0));
}
