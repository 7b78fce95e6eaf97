//! What is asked, where it is done and what proves it: `docs/coverage.md` is made of the files, and tells what is not built.

use crate::files::{below, root};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Groups of requirements (interface, command line, configuration) and of injected faults.
const GROUPS: [(&str, &str); 11] = [
    ("SEN", "Sentences on the line"),
    ("HTC", "What the chart system commands"),
    ("AP", "The autopilot"),
    ("TCS", "The chart system, track control"),
    ("CON", "The dialogue checker"),
    ("DSP", "What the operator sees"),
    ("EMC", "Small craft"),
    ("CLI", "Command line"),
    ("CFG", "Configuration"),
    ("FA", "Faults of steering and sensors"),
    ("FB", "Faults of the line"),
];
/// Faults of clients, storage and access are not in this list.
const ELSEWHERE: [&str; 3] = ["FC", "FD", "FE"];

/// A line of `tests/data/requirements.txt`.
pub(crate) struct Requirement {
    pub(crate) id: String,
    pub(crate) state: String,
    pub(crate) what: String,
    pub(crate) missing: String,
}

impl Requirement {
    /// Letters before the number.
    fn group(&self) -> &str {
        self.id
            .trim_end_matches(|c: char| c.is_ascii_digit())
            .trim_end_matches('-')
    }
}

pub(crate) fn requirements() -> Vec<Requirement> {
    let text = include_str!("../data/requirements.txt");
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let row = |line: &str| {
        let cells: Vec<String> = line.split('|').map(|cell| cell.trim().to_owned()).collect();
        let [id, state, what, missing] = cells.try_into().expect("four cells");
        Requirement {
            id,
            state,
            what,
            missing,
        }
    };
    lines.map(row).collect()
}

/// The identifiers in a text: letters, a hyphen where they have one, a number.
pub(crate) fn ids(text: &str) -> Vec<String> {
    let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '-' || c == '_'));
    let is_id = |word: &&str| {
        let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
        let group = letters.trim_end_matches('-');
        let faults = letters.len() == 2 && letters.starts_with('F');
        letters.len() < word.len()
            && (faults || letters.ends_with('-'))
            && (GROUPS.iter().any(|(name, _)| *name == group) || ELSEWHERE.contains(&group))
    };
    words.filter(is_id).map(str::to_owned).collect()
}

/// Where each identifier stands: files of code, files of tests.
fn found() -> BTreeMap<String, [Vec<String>; 2]> {
    let root = root();
    let mut found: BTreeMap<String, [Vec<String>; 2]> = BTreeMap::new();
    for folder in ["core", "server", "web", "static", "tests"] {
        for path in below(&root.join(folder), &["rs", "css", "js"]) {
            let name = path.strip_prefix(&root).unwrap().display().to_string();
            if name.starts_with("tests/house") {
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap();
            let is_code = !(name.starts_with("tests/") || name.contains("/tests"));
            // A file of code may carry its tests at its end.
            let tests = text.find("#[cfg(test)]\nmod tests {").unwrap_or(text.len());
            let (code, proof) = if is_code {
                text.split_at(tests)
            } else {
                ("", text.as_str())
            };
            for (part, place) in [(code, 0), (proof, 1)] {
                let mut ids = ids(part);
                ids.sort();
                ids.dedup();
                for id in ids {
                    found.entry(id).or_default()[place].push(name.clone());
                }
            }
        }
    }
    found
}

/// The document.
fn document(rows: &[Requirement], found: &BTreeMap<String, [Vec<String>; 2]>) -> String {
    let count = |state: &str| rows.iter().filter(|row| row.state == state).count();
    let mut text = format!(
        "# What is built, and what proves it\n\nMade of `tests/data/requirements.txt` and of the files; a test compares. {} of {} are built, {} in part, {} are open. Faults of\n\
         clients, storage and access are not listed here yet.\n",
        count("built"),
        rows.len(),
        count("part"),
        count("open"),
    );
    for (group, title) in GROUPS {
        let _ = write!(
            text,
            "\n## {title}\n\n| id | what | state | code | proof |\n|---|---|---|---|---|\n"
        );
        for row in rows.iter().filter(|row| row.group() == group) {
            let state = match row.state.as_str() {
                "built" => "built".to_owned(),
                "part" => format!("in part; not built: {}", row.missing),
                _ => "not built".to_owned(),
            };
            let places = |place: usize| {
                let files = found.get(&row.id).map_or(&[][..], |found| &found[place]);
                let names: Vec<String> = files.iter().map(|file| format!("`{file}`")).collect();
                names.join(" ")
            };
            let _ = writeln!(
                text,
                "| {} | {} | {state} | {} | {} |",
                row.id,
                row.what,
                places(0),
                places(1)
            );
        }
    }
    text + &crate::documents::tables(rows)
}

#[test]
fn what_is_called_built_has_code_and_proof_and_the_document_says_so() {
    let (rows, found) = (requirements(), found());
    let mut wrong = Vec::new();
    for row in &rows {
        let [code, proof] = found.get(&row.id).cloned().unwrap_or_default();
        let is_fault = !row.id.contains('-');
        let right = match (row.state.as_str(), row.missing.is_empty()) {
            ("built", true) => (is_fault || !code.is_empty()) && !proof.is_empty(),
            ("part", false) => !code.is_empty() || !proof.is_empty(),
            ("open", false) => true,
            _ => false,
        };
        if !right {
            wrong.push(format!(
                "{} is called {}: {code:?} {proof:?}",
                row.id, row.state
            ));
        }
    }
    for id in found.keys() {
        let elsewhere = ELSEWHERE.iter().any(|group| id.starts_with(group));
        if !elsewhere && !rows.iter().any(|row| row.id == *id) {
            wrong.push(format!("{id} stands in {:?} and is not asked", found[id]));
        }
    }
    assert_eq!(wrong, [""; 0]);
    let path = root().join("docs/coverage.md");
    let document = document(&rows, &found);
    if std::env::var_os("WHEELOVER_REWRITE").is_some() {
        std::fs::write(&path, &document).unwrap();
    }
    assert!(
        std::fs::read_to_string(&path).unwrap_or_default() == document,
        "docs/coverage.md is not what the files say; WHEELOVER_REWRITE=1 writes it"
    );
}

#[test]
fn identifiers_are_found_as_whole_words() {
    let found = ids("// AP-9, FA16 (TCS-8); AP-9x SEN_5 X-FA1 HTC-, FA, PNEY-001 AP-10.");
    assert_eq!(found, ["AP-9", "FA16", "TCS-8", "AP-10"]);
}
