//! Cuts the views that are fetched later out of the compiled page, and joins what is left with what fetches them.

use super::files::fingerprint;
use std::path::{Path, PathBuf};
use xtask::shell::{Failure, text};

/// The module that the page takes the fetching functions from: before the cut, and after it.
const WHOLE: &str = "__wasm_split_placeholder__";
const CUT: &str = "./__wasm_split.js";

/// A page without its later views.
pub(crate) struct Cut {
    /// What is left, still to be bound.
    pub(crate) main: PathBuf,
    /// What fetches the parts.
    fetching: String,
    /// Each part: the name that `fetching` calls it by, and its content.
    pub(crate) parts: Vec<(String, Vec<u8>)>,
}

/// Cuts a compiled page.
pub(crate) fn cut(wasm: &Path, folder: &Path) -> Result<Cut, Failure> {
    let input = std::fs::read(wasm).map_err(|error| Failure::file(wasm, &error))?;
    let main = folder.join("main.wasm");
    let mut options = wasm_split_cli_support::Options::new(&input);
    options.output_dir = folder;
    options.main_out_path = &main;
    options.link_name = CUT;
    let split = wasm_split_cli_support::transform(options)
        .map_err(|error| Failure::new(format!("the page cannot be cut: {error:#}")))?;
    let mut parts = Vec::new();
    for path in split.split_modules {
        let content = std::fs::read(&path).map_err(|error| Failure::file(&path, &error))?;
        let name = path.file_name().unwrap_or_default();
        parts.push((name.to_string_lossy().into_owned(), content));
    }
    Ok(Cut {
        fetching: text(&folder.join(CUT))?,
        main,
        parts,
    })
}

impl Cut {
    /// The name under which a part is laid, beside the page's script.
    pub(crate) fn laid(content: &[u8]) -> String {
        format!("part-{}.wasm", fingerprint(content))
    }

    /// One script of the page's and of what fetches its parts.
    pub(crate) fn join(&self, script: &str) -> Result<String, Failure> {
        let mut names = Vec::new();
        let mut fetching = String::new();
        for line in self.fetching.lines() {
            if line.starts_with("import ") {
                // Both stand in one script now.
                continue;
            }
            let line = match line.strip_prefix("export ") {
                Some(line) => {
                    names.extend(line.split_whitespace().nth(1));
                    line
                }
                None => line,
            };
            fetching += line;
            fetching += "\n";
        }
        for (name, content) in &self.parts {
            fetching =
                fetching.replace(&format!("./{name}"), &format!("./{}", Self::laid(content)));
        }
        let object = format!("{{ {} }}", names.join(", "));
        replace_import(script, CUT, &object).map(|script| fetching + &script)
    }
}

/// A script whose parts are still in its module: nothing is fetched, everything is there.
pub(crate) fn join_whole(script: &str) -> Result<String, Failure> {
    let object = "new Proxy({}, { get: (_, name) => name.startsWith(\"__wasm_split_load_\") \
        ? (callback, data) => wasm.__indirect_function_table.get(callback)(data, 1) \
        : (...given) => wasm[name.replace(\"00_import_\", \"00_export_\")](...given) })";
    replace_import(script, WHOLE, object)
}

/// Puts an object in the place of a module that a script imports, once for each function of it.
fn replace_import(script: &str, module: &str, object: &str) -> Result<String, Failure> {
    let from = format!(" from \"{module}\"");
    let is_import = |line: &&str| line.starts_with("import ") && line.contains(&from);
    if !script.lines().any(|line| is_import(&line)) {
        return Err(Failure::new(format!("the page does not import {module}")));
    }
    let mut replaced = format!("const later = {object};\n");
    for line in script.lines() {
        if is_import(&line) {
            let name = line.split_whitespace().nth(3).unwrap_or_default();
            replaced += &format!("const {name} = later;");
        } else {
            replaced += line;
        }
        replaced += "\n";
    }
    Ok(replaced)
}

/// A module without the sections that only a linker and a cutter read.
pub(crate) fn without_relocations(wasm: &[u8]) -> Option<Vec<u8>> {
    let mut kept = wasm.get(..8)?.to_vec();
    let mut at = 8;
    while at < wasm.len() {
        let (length, body) = number(wasm, at + 1)?;
        let end = body + length;
        let for_linkers = wasm[at] == 0 && {
            let (length, name) = number(wasm, body)?;
            let name = wasm.get(name..name + length)?;
            name.starts_with(b"reloc.") || name == b"linking"
        };
        if !for_linkers {
            kept.extend_from_slice(wasm.get(at..end)?);
        }
        at = end;
    }
    Some(kept)
}

/// A number of a module, and where it ends.
fn number(wasm: &[u8], mut at: usize) -> Option<(usize, usize)> {
    let (mut value, mut shift) = (0, 0);
    loop {
        let byte = *wasm.get(at)?;
        value |= usize::from(byte & 127) << shift;
        (at, shift) = (at + 1, shift + 7);
        if byte < 128 {
            return Some((value, at));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_imported_module_becomes_an_object() {
        let script = "import * as import1 from \"./a.js\"\nimport * as import2 from \"./a.js\"\nlet x = import1;\n";
        let joined = replace_import(script, "./a.js", "{ f }").unwrap();
        assert_eq!(
            joined,
            "const later = { f };\nconst import1 = later;\nconst import2 = later;\nlet x = import1;\n"
        );
        assert!(replace_import(script, "./b.js", "{}").is_err());
    }

    #[test]
    fn only_relocations_are_left_away() {
        let head = *b"\0asm\x01\0\0\0";
        let section = |id: u8, content: &[u8]| {
            let mut section = vec![id, content.len() as u8];
            section.extend_from_slice(content);
            section
        };
        let code = section(10, b"abc");
        let name = section(0, b"\x04namexy");
        let reloc = section(0, b"\x0areloc.CODE...");
        let whole = [&head[..], &code, &reloc, &name].concat();
        let expect = [&head[..], &code, &name].concat();
        assert_eq!(without_relocations(&whole), Some(expect));
        assert_eq!(without_relocations(b"\0asm"), None);
    }
}
