//! The layers of core and server, and no circles.

use crate::files::root;
use crate::needs::{Crate, Needs, circles};
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// Circles that still stand, folder by folder: nothing may join them, and who opens one takes it off.
#[rustfmt::skip]
const OPEN: [(&str, &str); 0] = [];

fn core() -> &'static Needs {
    static CORE: OnceLock<Needs> = OnceLock::new();
    CORE.get_or_init(|| of("core", 120))
}

fn of(package: &str, at_least: usize) -> Needs {
    let files = Crate::open(&root().join(package).join("src"));
    assert!(files.len() >= at_least, "{package}: {} files", files.len());
    files.needs()
}

/// What breaks a rule: arrows from one room to another that it may not need.
fn breaches(needs: &Needs, from: &[&str], may: &dyn Fn(&str) -> bool) -> Vec<String> {
    let inside = |name: &str, room: &str| {
        name == room
            || name
                .strip_prefix(room)
                .is_some_and(|rest| rest.starts_with("::"))
    };
    let mut found = Vec::new();
    for (name, all) in needs
        .iter()
        .filter(|(name, _)| from.iter().any(|room| inside(name, room)))
    {
        for need in all
            .iter()
            .filter(|need| !from.iter().any(|room| inside(need, room)))
        {
            if !may(need.split("::").next().unwrap_or_default()) {
                found.push(format!("{name} needs {need}"));
            }
        }
    }
    found
}

#[test]
fn the_codec_knows_numbers_and_time_and_no_station() {
    let ground = |room: &str| ["geo", "time", "units"].contains(&room);
    assert_eq!(breaches(core(), &["nmea"], &ground), [""; 0]);
    assert_eq!(
        breaches(core(), &["geo", "time", "units"], &|_| false),
        [""; 0]
    );
}

#[test]
fn nothing_in_the_core_knows_what_crosses_to_the_browser() {
    let rooms: Vec<&str> = core()
        .keys()
        .filter_map(|name| name.split("::").next())
        .collect();
    let below: Vec<&str> = rooms
        .into_iter()
        .filter(|room| !["", "view"].contains(room))
        .collect();
    assert!(below.contains(&"autopilot") && below.contains(&"voyage"));
    assert_eq!(breaches(core(), &below, &|room| room != "view"), [""; 0]);
}

#[test]
fn stations_meet_in_sentences_only() {
    let stations = ["autopilot", "chart_system", "world"];
    for one in stations {
        let other = |room: &str| !stations.contains(&room) && room != "voyage";
        assert_eq!(breaches(core(), &[one], &other), [""; 0]);
    }
}

#[test]
fn the_bus_of_the_server_knows_no_room() {
    let bus = &of("server", 30)["bus"];
    assert_eq!(bus.iter().collect::<Vec<_>>(), ["outbox"]);
}

#[test]
fn no_file_and_no_folder_needs_one_that_needs_it() {
    let mut known: BTreeMap<&str, &str> = OPEN.into_iter().collect();
    let mut new = Vec::new();
    for package in ["core", "server", "web", "web/xtask"] {
        for (folder, round) in circles(&of(package, 10)) {
            let name = format!("{package} {folder}");
            let known = known.remove(name.as_str()).unwrap_or_default();
            let left: Vec<_> = round
                .iter()
                .filter(|one| !known.split(' ').any(|known| known == *one))
                .collect();
            if !left.is_empty() {
                new.push(format!("{name}: {left:?} of {round:?}"));
            }
        }
    }
    assert!(new.is_empty(), "these need each other:\n{}", new.join("\n"));
    // One that has been opened stays open.
    println!("opened: {known:?}");
}

/// A crate of these files.
fn sample(files: &[(&str, &str)]) -> Needs {
    let texts = files
        .iter()
        .map(|(name, text)| ((*name).to_owned(), (*text).to_owned()));
    Crate::of(&texts.collect::<Vec<_>>()).needs()
}

#[test]
fn a_room_that_looks_up_is_found() {
    let needs = sample(&[
        ("lib", "mod nmea; mod view; mod autopilot;"),
        ("nmea/mod", "mod read;"),
        ("nmea", "mod read; pub use read::Field;"),
        ("nmea::read", "use crate::view::Snapshot; pub struct Field;"),
        (
            "view",
            "pub struct Snapshot; fn f() { crate::autopilot::go() }",
        ),
        ("autopilot", "pub fn go() { crate::nmea::Field; }"),
    ]);
    assert_eq!(
        breaches(&needs, &["nmea"], &|room| room != "view"),
        ["nmea::read needs view"]
    );
    assert_eq!(
        needs["autopilot"].iter().collect::<Vec<_>>(),
        ["nmea::read"],
        "followed to where it is defined"
    );
    let round = &circles(&needs)[""];
    assert_eq!(
        round.iter().collect::<Vec<_>>(),
        ["autopilot", "nmea", "view"]
    );
}

#[test]
fn a_part_that_needs_its_whole_is_found() {
    let by_name = sample(&[
        ("lib", "mod a;"),
        ("a", "mod part; pub struct Whole; fn f() { part::g() }"),
        ("a::part", "use super::Whole; pub fn g() -> Whole { Whole }"),
    ]);
    assert_eq!(circles(&by_name)["a"].len(), 2);
    let by_method = sample(&[
        ("lib", "mod a;"),
        (
            "a",
            "mod part; pub struct Whole; impl Whole { fn f(&self) { self.g() } }",
        ),
        (
            "a::part",
            "use super::Whole; impl Whole { pub fn g(&self) {} }",
        ),
    ]);
    assert_eq!(circles(&by_method)["a"].len(), 2);
    let straight = sample(&[
        ("lib", "mod a;"),
        (
            "a",
            "mod part; mod other; pub use part::Part; fn f() { part::g() }",
        ),
        ("a::part", "pub fn g() {} pub struct Part;"),
        ("a::other", "use super::Part;"),
    ]);
    assert!(circles(&straight).is_empty(), "{straight:?}");
}
