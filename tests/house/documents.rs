//! The source documents row by row: what each table row, note, clause and example became, and how far that is built.

use crate::coverage::Requirement;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use wheelover_core::nmea::dictionary;

/// A document: its letter, what it is, how many parts and rows it has.
struct Document(&'static str, &'static str, usize, usize);

const DOCUMENTS: [Document; 4] = [
    Document(
        "N",
        "Navis AP SYSTEM/NavAP, track control category C, revision 5.11",
        35,
        412,
    ),
    Document("F1", "Standard notes of HTC and HTD", 4, 47),
    Document("F2", "Digital interface list of a chart system", 27, 188),
    Document(
        "E",
        "EMACUA System Interfaces, a small craft's autopilot",
        15,
        113,
    ),
];

/// A line of `tests/data/documents.txt` that opens a part.
struct Part {
    document: String,
    name: String,
    title: String,
    count: usize,
    rows: Vec<Row>,
}

/// A row of a part.
struct Row {
    place: String,
    what: String,
    asked: Vec<Asked>,
    sentences: Vec<String>,
}

/// A requirement that a row became.
struct Asked {
    id: String,
    /// The row asks only for what is built of it.
    built_part: bool,
}

/// The parts, and what is wrong with their lines.
fn read(text: &str) -> (Vec<Part>, Vec<String>) {
    let (mut parts, mut wrong) = (Vec::<Part>::new(), Vec::new());
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [first, place, what, last] = cells[..] else {
            wrong.push(format!("not four cells: {line}"));
            continue;
        };
        if let Some(document) = first.strip_prefix("= ") {
            parts.push(Part {
                document: document.to_owned(),
                name: place.to_owned(),
                title: what.to_owned(),
                count: last.parse().unwrap_or(0),
                rows: Vec::new(),
            });
            continue;
        }
        let part = parts.last_mut().filter(|part| part.document == first);
        let row = part.and_then(|part| Some((place.split_once(" / ")?, part)));
        let Some(((_, row), part)) = row.filter(|((name, _), part)| *name == part.name) else {
            wrong.push(format!("stands in another part: {line}"));
            continue;
        };
        let (mut asked, mut sentences) = (Vec::new(), Vec::new());
        for word in last.split_whitespace() {
            let (id, mark) = word.split_once(':').unwrap_or((word, ""));
            if !["", "built"].contains(&mark) {
                wrong.push(format!("{word}: {line}"));
            }
            if crate::coverage::ids(id) == [id] {
                asked.push(Asked {
                    id: id.to_owned(),
                    built_part: mark == "built",
                });
            } else {
                sentences.push(word.to_owned());
            }
        }
        part.rows.push(Row {
            place: row.to_owned(),
            what: what.to_owned(),
            asked,
            sentences,
        });
    }
    (parts, wrong)
}

fn of<'a>(requirements: &'a [Requirement], id: &str) -> Option<&'a Requirement> {
    requirements.iter().find(|one| one.id == id)
}

/// What is wrong with parts and rows.
fn faults(parts: &[Part], requirements: &[Requirement]) -> Vec<String> {
    let mut wrong = Vec::new();
    let mut places = BTreeSet::new();
    for part in parts {
        let name = format!("{} {}", part.document, part.name);
        if part.rows.len() != part.count {
            wrong.push(format!(
                "{name}: {} rows, the document has {}",
                part.rows.len(),
                part.count
            ));
        }
        for row in &part.rows {
            let place = format!("{name} / {}", row.place);
            if row.place.is_empty() || row.what.is_empty() {
                wrong.push(format!("{place}: says nothing"));
            }
            for asked in &row.asked {
                match of(requirements, &asked.id) {
                    None => wrong.push(format!("{place}: {} is not asked", asked.id)),
                    Some(one) if asked.built_part && one.state == "open" => {
                        wrong.push(format!("{place}: nothing of {} is built", asked.id));
                    }
                    _ => {}
                }
            }
            let reads = row.asked.iter().any(|asked| asked.id == "SEN-7");
            if reads == row.sentences.is_empty() {
                wrong.push(format!("{place}: SEN-7 and a sentence go together"));
            }
            for sentence in &row.sentences {
                if !dictionary().iter().any(|one| one.formatter == sentence) {
                    wrong.push(format!("{place}: {sentence} is not in the dictionary"));
                }
            }
            if !places.insert(place.clone()) {
                wrong.push(format!("{place} stands twice"));
            }
        }
    }
    wrong
}

/// How far a row is built, and what is missing.
fn state(row: &Row, requirements: &[Requirement]) -> String {
    let (mut missing, mut open) = (Vec::new(), 0);
    for asked in &row.asked {
        let Some(one) = of(requirements, &asked.id) else {
            continue;
        };
        match one.state.as_str() {
            "part" if !asked.built_part => missing.push(format!("{} ({})", one.id, one.missing)),
            "open" => {
                open += 1;
                missing.push(one.id.clone());
            }
            _ => {}
        }
    }
    match (row.asked.is_empty(), missing.is_empty()) {
        (true, _) => "no rule".to_owned(),
        (_, true) => "built".to_owned(),
        _ if open == row.asked.len() => "not built".to_owned(),
        // Its sentence is decoded and explained, and nothing acts on it.
        _ if open + 1 == row.asked.len() && row.asked[0].id == "SEN-7" => {
            format!("read only; not built: {}", missing.join(", "))
        }
        _ => format!("in part; not built: {}", missing.join(", ")),
    }
}

/// The second part of the document: a table for each source, the rows of a part below its title.
pub(crate) fn tables(requirements: &[Requirement]) -> String {
    let (parts, _) = read(include_str!("../data/documents.txt"));
    let mut text = "\n# The source documents, row by row\n\nMade of `tests/data/documents.txt`: every table row, note, clause and printed example, in our own words, \
                    with what it became; code and proof stand above\nat the IDs. SEN-7 names the sentences. \"No rule\" is history, addresses, abbreviations and hardware.\n"
        .to_owned();
    for Document(document, title, ..) in DOCUMENTS {
        let mut body = String::new();
        let mut counts = [0; 5];
        for part in parts.iter().filter(|part| part.document == document) {
            let _ = writeln!(body, "| **{}** | **{}** | | |", part.name, part.title);
            for row in &part.rows {
                let state = state(row, requirements);
                let kinds = ["built", "in part", "read only", "not built", "no rule"];
                counts[kinds
                    .iter()
                    .position(|kind| state.starts_with(kind))
                    .unwrap()] += 1;
                let ids = row.asked.iter().map(|asked| match asked.id.as_str() {
                    "SEN-7" => format!("SEN-7 ({})", row.sentences.join(" ")),
                    id => id.to_owned(),
                });
                let ids = ids.collect::<Vec<_>>().join(", ");
                let _ = writeln!(body, "| {} | {} | {ids} | {state} |", row.place, row.what);
            }
        }
        let [built, part, read, open, none] = counts;
        let rows: usize = counts.iter().sum();
        let _ = write!(
            text,
            "\n## {document}: {title}\n\n{rows} rows: {built} built, {part} in part, {read} read only, {open} not built, {none} no rule.\n\n\
             | row | what it says | became | state |\n|---|---|---|---|\n{body}"
        );
    }
    text
}

#[test]
fn every_row_of_the_source_documents_became_something() {
    let requirements = crate::coverage::requirements();
    let (parts, mut wrong) = read(include_str!("../data/documents.txt"));
    wrong.extend(faults(&parts, &requirements));
    assert_eq!(wrong, [""; 0]);
    for Document(document, _, count, rows) in DOCUMENTS {
        let of = || parts.iter().filter(|part| part.document == document);
        let found: usize = of().map(|part| part.rows.len()).sum();
        assert_eq!((of().count(), found), (count, rows), "{document}");
    }
    let known = |part: &Part| DOCUMENTS.iter().any(|one| one.0 == part.document);
    assert!(parts.iter().all(known));
}

#[test]
fn wrong_rows_are_found() {
    let requirements = crate::coverage::requirements();
    let found = |text: &str| {
        let (parts, mut wrong) = read(text);
        wrong.extend(faults(&parts, &requirements));
        wrong
    };
    let right = "= N | A.4 | HTD | 1\nN | A.4 / 1 | override | SEN-7 HTD AP-1 AP-4:built\n";
    assert_eq!(found(right), [""; 0]);
    for (from, to, fault) in [
        ("AP-1 ", "TCS-99 ", "TCS-99 is not asked"),
        ("SEN-7 HTD", "SEN-7 HTZ", "HTZ is not in the dictionary"),
        ("SEN-7 HTD", "SEN-7", "go together"),
        ("SEN-7 HTD", "HTD", "go together"),
        ("HTD | 1", "HTD | 2", "the document has 2"),
        ("A.4 / 1", "A.5 / 1", "another part"),
        ("AP-4:built", "AP-4:all", "AP-4:all"),
        (" | override", "", "not four cells"),
        ("override", "", "says nothing"),
    ] {
        let wrong = found(&right.replace(from, to)).join("\n");
        assert!(wrong.contains(fault), "{from} {to}: {wrong}");
    }
    let twice = format!("{right}{}\n", right.lines().last().unwrap());
    assert!(found(&twice).join("\n").contains("stands twice"));
}

#[test]
fn a_row_is_as_far_built_as_what_it_became() {
    let requirement = |id: &str, state: &str, missing: &str| Requirement {
        id: id.to_owned(),
        state: state.to_owned(),
        what: String::new(),
        missing: missing.to_owned(),
    };
    let requirements = [
        requirement("AP-1", "built", ""),
        requirement("AP-2", "part", "a half"),
        requirement("AP-3", "open", "all of it"),
        requirement("SEN-7", "built", ""),
    ];
    for (ids, expect) in [
        ("", "no rule"),
        ("AP-1", "built"),
        ("AP-1 AP-2:built", "built"),
        ("AP-1 AP-2", "in part; not built: AP-2 (a half)"),
        ("AP-2 AP-3", "in part; not built: AP-2 (a half), AP-3"),
        ("AP-3", "not built"),
        ("SEN-7 HTD AP-3", "read only; not built: AP-3"),
    ] {
        let text = format!("= N | A | a | 1\nN | A / 1 | one | {ids}");
        let (parts, _) = read(&text);
        assert_eq!(state(&parts[0].rows[0], &requirements), expect, "{ids}");
    }
}
