//! HTC-2: the seven notes of the HTC and HTD definition stand in the explanations, field by field.

use wheelover_core::nmea::{decode, explain, with_checksum};

/// Note, field of HTC, field of HTD, and what the note says there, in our words.
type Note = (u8, Option<usize>, Option<usize>, &'static [&'static str]);

const NOTES: &[Note] = &[
    (
        1,
        Some(1),
        Some(1),
        &["special devices for a time", "both modes are", "ignored"],
    ),
    (1, Some(1), None, &["computes as in manual steering"]),
    (
        2,
        Some(4),
        None,
        &[
            "selector switch",
            "earlier HTC",
            "goes first",
            "each maker states",
        ],
    ),
    (2, Some(4), None, &["M: the main steering system"]),
    (
        2,
        Some(4),
        None,
        &[
            "S: works as a stand-alone heading controller",
            "no heading to steer from outside",
        ],
    ),
    (
        2,
        Some(4),
        None,
        &[
            "H (Tn): takes the heading to steer from an external device",
            "remotely controlled",
        ],
    ),
    (
        2,
        Some(4),
        None,
        &[
            "T (Ti): corrects the course of the commanded track by the track errors",
            "XTE or APB",
        ],
    ),
    (
        2,
        Some(4),
        None,
        &[
            "R: takes rudder angle and side from an external device",
            "the same electronic means as S, H and T",
        ],
    ),
    (
        3,
        Some(5),
        None,
        &[
            "modes S, H and T",
            "by the radius",
            "rate of turn",
            "not controlled",
            "manoeuvrability",
        ],
    ),
    (
        4,
        Some(12),
        Some(12),
        &[
            "the leg between two waypoints",
            "altered during a turn along a planned radius",
        ],
    ),
    (5, Some(11), None, &["belongs to mode T"]),
    (5, None, Some(16), &["only mode T can give"]),
    (6, Some(10), Some(10), &["in the heading reference in use"]),
    (6, Some(12), Some(12), &["in the heading reference in use"]),
    (
        7,
        Some(14),
        None,
        &[
            "only C is a command",
            "R reports present settings",
            "the answer to a query",
            "should not be null",
        ],
    ),
];

#[test]
fn the_notes_of_the_definition_are_explained_where_they_belong() {
    let check = |body: &str, note: u8, field: Option<usize>, words: &[&str]| {
        let line = with_checksum(body);
        let sentence = decode(line.as_bytes());
        let explanation = explain(&sentence);
        let Some(field) = field else { return };
        let text = explanation.fields[field - 1].note;
        for words in words {
            assert!(
                text.contains(words),
                "note {note}, field {field} of {body}: {words} is not in: {text}"
            );
        }
    };
    for (note, htc, htd, words) in NOTES {
        check("EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C", *note, *htc, words);
        check(
            "AGHTD,V,16.0,R,S,N,16.0,20.0,0.42,028,,,,T,A,A,,216.8",
            *note,
            *htd,
            words,
        );
    }
    for note in 1..=7 {
        assert!(NOTES.iter().any(|row| row.0 == note), "note {note}");
    }
}
