//! Rules for each file: its length, its first line, and citations that cannot be mistaken for requirements.

use crate::files::{below, root};
use std::path::Path;

/// A file of so many lines has two subjects.
const TOO_LONG: usize = 400;

/// How many requirements the autopilot has (AP-1 and on).
const REQUIREMENTS: u32 = 27;

fn faults(name: &str, text: &str) -> Vec<String> {
    let mut faults = Vec::new();
    let lines = text.lines().count();
    if lines >= TOO_LONG {
        faults.push(format!("{name}: {lines} lines"));
    }
    if name.ends_with(".rs") && !text.starts_with("//! ") {
        faults.push(format!("{name}: its first line does not say its subject"));
    }
    faults
}

/// Pages of a maker's manual that are numbered as the requirements are.
fn mistakable(name: &str, text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (number, line) in text.lines().enumerate() {
        for rest in line.split("AP-").skip(1) {
            let digits = rest.split(|c: char| !c.is_ascii_digit()).next();
            let Some(number_of) = digits.and_then(|digits| digits.parse::<u32>().ok()) else {
                continue;
            };
            let cites = ["Furuno", "appendix", "manual p"]
                .iter()
                .any(|word| line.contains(word));
            if cites || !(1..=REQUIREMENTS).contains(&number_of) {
                found.push(format!("{name}:{}: AP-{number_of}", number + 1));
            }
        }
    }
    found
}

fn each(endings: &[&str], check: impl Fn(&str, &str) -> Vec<String>) -> Vec<String> {
    let root = root();
    let files = below(&root, endings);
    assert!(files.len() > 10, "{}", files.len());
    let checked = |path: &std::path::PathBuf| {
        let name = path.strip_prefix(&root).unwrap_or(Path::new(""));
        check(
            &name.display().to_string(),
            &std::fs::read_to_string(path).unwrap(),
        )
    };
    files.iter().flat_map(checked).collect()
}

#[test]
fn a_file_has_one_subject_and_says_it_first() {
    assert_eq!(each(&["rs", "css", "js"], faults), [""; 0]);
    let long = "//! X.\n".repeat(TOO_LONG);
    assert_eq!(faults("a.rs", &long), ["a.rs: 400 lines"]);
    assert_eq!(faults("a.rs", "use std;").len(), 1);
    assert_eq!(faults("a.css", "/* Y */"), [""; 0]);
}

#[test]
fn no_page_of_a_maker_reads_like_a_requirement() {
    let all = each(&["rs", "md", "txt", "log", "toml"], |name, text| {
        if name.ends_with("house/rules.rs") {
            Vec::new()
        } else {
            mistakable(name, text)
        }
    });
    assert_eq!(all, [""; 0]);
    assert_eq!(
        mistakable("a", "Source: Furuno appendix AP-10."),
        ["a:1: AP-10"]
    );
    assert_eq!(mistakable("a", "// AP-10, and page AP-31"), ["a:1: AP-31"]);
    assert_eq!(mistakable("a", "// SEN-6, AP-9, AP-N\n"), [""; 0]);
}
