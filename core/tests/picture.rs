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
