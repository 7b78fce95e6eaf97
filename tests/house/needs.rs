//! Which file of a crate needs which: a path is followed through what modules hand on, to the file that defines the item.

use crate::source::{Source, read};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The files of a crate, by the paths of their modules: `config::read`; the crate's root is empty.
#[derive(Debug)]
pub(crate) struct Crate {
    files: BTreeMap<String, Source>,
}

/// From a file to those that it needs.
pub(crate) type Needs = BTreeMap<String, BTreeSet<String>>;

impl Crate {
    /// Reads all files below a folder, tests left out.
    pub(crate) fn open(folder: &Path) -> Self {
        let mut texts = Vec::new();
        for path in crate::files::below(folder, &["rs"]) {
            let name = path.strip_prefix(folder).unwrap().with_extension("");
            let parts: Vec<_> = name.iter().map(|part| part.to_str().unwrap()).collect();
            if !parts.contains(&"tests") && !parts.contains(&"main") {
                texts.push((parts.join("::"), std::fs::read_to_string(&path).unwrap()));
            }
        }
        Self::of(&texts)
    }

    /// The same of texts.
    pub(crate) fn of(texts: &[(String, String)]) -> Self {
        let module = |name: &str| match name {
            "lib" => String::new(),
            name => name.trim_end_matches("::mod").to_owned(),
        };
        let files = texts.iter().map(|(name, text)| (module(name), read(text)));
        Self {
            files: files.collect(),
        }
    }

    /// How many files it has.
    pub(crate) fn len(&self) -> usize {
        self.files.len()
    }

    /// What each file needs.
    pub(crate) fn needs(&self) -> Needs {
        let mut needs = Needs::new();
        for (name, source) in &self.files {
            let imports = source.imports.iter().map(|import| &import.path);
            let found = imports
                .chain(&source.paths)
                .filter_map(|path| self.follow(name, path, 0));
            needs.insert(name.clone(), found.filter(|found| found != name).collect());
        }
        // Whoever calls a method that stands beside its type needs the file where it stands.
        for (name, source) in &self.files {
            for (of, method) in &source.methods {
                let path = [of.clone(), "self".to_owned()];
                let Some(home) = self.follow(name, &path, 0).filter(|home| home != name) else {
                    continue;
                };
                let own = &self.files[&home];
                let there = own.methods.iter().any(|(_, other)| other == method);
                if own.calls.contains(method) && !there {
                    needs.entry(home).or_default().insert(name.clone());
                }
            }
        }
        needs
    }

    /// The file that defines what `path` names in `file`; none for what other crates define.
    fn follow(&self, file: &str, path: &[String], depth: usize) -> Option<String> {
        let (first, rest) = path.split_first()?;
        let source = self.files.get(file)?;
        // A name that is handed round has no home here.
        if depth > 16 {
            return None;
        }
        match first.as_str() {
            "crate" => self.walk("", rest, depth),
            "self" => self.walk(file, rest, depth),
            "super" => self.walk(above(file), rest, depth),
            part if source.parts.contains(part) => self.walk(&join(file, part), rest, depth),
            name => {
                let import = source.imports.iter().find(|import| import.name == name);
                if let Some(import) = import {
                    let whole: Vec<String> = import.path.iter().chain(rest).cloned().collect();
                    return self.follow(file, &whole, depth + 1);
                }
                source.items.contains(name).then(|| file.to_owned())
            }
        }
    }

    /// What `path` names seen from the module `file`.
    fn walk(&self, file: &str, path: &[String], depth: usize) -> Option<String> {
        let source = self.files.get(file)?;
        let Some((first, rest)) = path.split_first() else {
            return Some(file.to_owned());
        };
        if first == "super" {
            return self.walk(above(file), rest, depth);
        }
        if source.parts.contains(first) && self.files.contains_key(&join(file, first)) {
            return self.walk(&join(file, first), rest, depth);
        }
        if source.items.contains(first) {
            return Some(file.to_owned());
        }
        let named = |import: &&crate::source::Import| import.name == *first;
        if let Some(import) = source.imports.iter().find(named) {
            let whole: Vec<String> = import.path.iter().chain(rest).cloned().collect();
            return self.follow(file, &whole, depth + 1);
        }
        for import in source.imports.iter().filter(|import| import.name == "*") {
            let Some(from) = self.follow(file, &import.path, depth + 1) else {
                continue;
            };
            if self.files[&from].items.contains(first) {
                return Some(from);
            }
        }
        Some(file.to_owned())
    }
}

fn above(file: &str) -> &str {
    file.rsplit_once("::").map_or("", |(above, _)| above)
}

fn join(file: &str, part: &str) -> String {
    if file.is_empty() {
        part.to_owned()
    } else {
        format!("{file}::{part}")
    }
}

/// The circles of each folder: which of its files, and of its folders taken as one, need each other; `.` is the file that opens it.
pub(crate) fn circles(needs: &Needs) -> BTreeMap<String, BTreeSet<String>> {
    let mut folders = BTreeSet::from([String::new()]);
    for name in needs.keys() {
        let ends = name
            .match_indices("::")
            .map(|(end, _)| name[..end].to_owned());
        folders.extend(ends);
    }
    let mut found = BTreeMap::new();
    for folder in folders {
        let round = in_circles(arrows(needs, &folder));
        if !round.is_empty() {
            found.insert(folder, round);
        }
    }
    found
}

/// What needs what in a folder.
fn arrows(needs: &Needs, folder: &str) -> Needs {
    let entry = |name: &str| -> Option<String> {
        let rest = match folder {
            "" => name,
            folder if name == folder => "",
            folder => name.strip_prefix(folder)?.strip_prefix("::")?,
        };
        let first = rest.split("::").next().filter(|first| !first.is_empty());
        Some(first.unwrap_or(".").to_owned())
    };
    let mut arrows = Needs::new();
    for (from, all) in needs {
        let Some(from) = entry(from) else { continue };
        let to = all
            .iter()
            .filter_map(|to| entry(to))
            .filter(|to| *to != from);
        arrows.entry(from.clone()).or_default().extend(to);
    }
    arrows
}

/// What can be reached from itself.
fn in_circles(arrows: Needs) -> BTreeSet<String> {
    let reaches_itself = |start: &String| {
        let (mut seen, mut next) = (BTreeSet::new(), vec![start]);
        while let Some(one) = next.pop() {
            for to in arrows.get(one).into_iter().flatten() {
                if to == start {
                    return true;
                }
                if seen.insert(to) {
                    next.push(to);
                }
            }
        }
        false
    };
    let all = arrows.keys().filter(|name| reaches_itself(name));
    all.cloned().collect()
}
