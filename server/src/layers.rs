//! No room of the server needs one that needs it: what imports what is a tree of layers, read from the files.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|end| end == "rs") {
            found.push(path);
        }
    }
}

/// `config/read.rs` is `config::read`, `config/mod.rs` is `config`.
fn module(root: &Path, file: &Path) -> String {
    let name = file.strip_prefix(root).unwrap().with_extension("");
    let parts: Vec<_> = name.iter().map(|part| part.to_str().unwrap()).collect();
    parts.join("::").trim_end_matches("::mod").to_owned()
}

/// The names after each `start` in the code, tests left out; of `{a, b::c}` all.
fn after(code: &str, start: &str) -> Vec<String> {
    let mut names = Vec::new();
    for rest in code.split(start).skip(1) {
        let all = match rest.strip_prefix('{') {
            Some(list) => list.split('}').next().unwrap_or_default(),
            None => rest
                .split([';', ',', '(', '{', '<', ' '])
                .next()
                .unwrap_or_default(),
        };
        names.extend(all.split(',').map(|name| name.trim().to_owned()));
    }
    names
}

/// What each module imports, by its longest name that is a module.
fn imports() -> BTreeMap<String, BTreeSet<String>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut all = Vec::new();
    files(&root, &mut all);
    let named: BTreeMap<String, PathBuf> = all
        .into_iter()
        .map(|file| (module(&root, &file), file))
        .collect();
    let mut imports = BTreeMap::new();
    for (name, file) in &named {
        if ["lib", "main", "layers"].contains(&name.as_str()) || name.ends_with("tests") {
            continue;
        }
        let text = std::fs::read_to_string(file).unwrap();
        let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
        let above = name.rsplit_once("::").map_or("", |(above, _)| above);
        let mut wanted: Vec<String> = after(code, "crate::");
        wanted.extend(
            after(code, "super::")
                .iter()
                .map(|name| format!("{above}::{name}")),
        );
        // A module needs its parts where it uses them.
        let parts = named
            .keys()
            .filter(|part| part.starts_with(&format!("{name}::")));
        for part in parts {
            let own = &part[name.len() + 2..];
            if code.contains(&format!("{own}::")) {
                wanted.push(part.clone());
            }
        }
        let mut found = BTreeSet::new();
        for want in wanted {
            let mut want = want.as_str();
            while !named.contains_key(want) {
                match want.rsplit_once("::") {
                    Some((shorter, _)) => want = shorter,
                    None => break,
                }
            }
            if named.contains_key(want) && want != name {
                found.insert(want.to_owned());
            }
        }
        imports.insert(name.clone(), found);
    }
    imports
}

#[test]
fn no_room_needs_one_that_needs_it() {
    let mut left = imports();
    assert!(left.len() > 25 && left["ws"].contains("bus"), "{left:?}");
    loop {
        let free: Vec<String> = left
            .iter()
            .filter(|(_, needs)| needs.iter().all(|need| !left.contains_key(need)))
            .map(|(name, _)| name.clone())
            .collect();
        if free.is_empty() {
            break;
        }
        for name in free {
            left.remove(&name);
        }
    }
    assert!(
        left.is_empty(),
        "these need each other, or one that does: {left:#?}"
    );
}

#[test]
fn the_bus_knows_no_room() {
    let bus = &imports()["bus"];
    assert_eq!(bus.iter().collect::<Vec<_>>(), ["outbox"]);
}
