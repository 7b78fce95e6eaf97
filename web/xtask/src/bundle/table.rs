//! The table of the page's files, as the program embeds it: an expression of Rust.

use crate::files::fingerprint;
use std::fmt::Write;
use std::path::Path;
use xtask::shell::{Failure, Outcome};

/// One file of the page.
pub(crate) struct Row {
    /// Its name below the folder; also its address.
    pub(crate) name: String,
    /// Whether the packed forms lie beside it.
    pub(crate) packed: bool,
    /// Sources of a content security policy for the scripts and the styles that stand in it.
    pub(crate) inline: Option<[String; 2]>,
}

/// The packed forms, best first: the name of the coding, and the ending.
const CODINGS: [(&str, &str); 2] = [("br", "br"), ("gzip", "gz")];

/// Writes the table into the folder that holds the files.
///
/// # Errors
/// A file cannot be read, or is of a kind that has no media type here.
pub(crate) fn write(folder: &Path, rows: &[Row]) -> Outcome {
    let mut table = String::from("{\nuse wheelover::page::{File, Inline, Packed};\n&[\n");
    for row in rows {
        let path = folder.join(&row.name);
        let content = std::fs::read(&path).map_err(|error| Failure::file(&path, &error))?;
        table += &line(row, &fingerprint(&content))?;
    }
    table += "]\n}\n";
    crate::files::write(&folder.join("page.rs"), table.as_bytes())
}

fn line(row: &Row, hash: &str) -> Result<String, Failure> {
    let name = &row.name;
    let media =
        media_type(name).ok_or_else(|| Failure::new(format!("{name}: no media type is known")))?;
    let kept = name.starts_with("assets/");
    let inline = row.inline.as_ref().map_or_else(
        || "None".to_owned(),
        |[scripts, styles]| format!("Some(Inline {{ scripts: {scripts:?}, styles: {styles:?} }})"),
    );
    let mut packed = String::new();
    for (coding, end) in CODINGS.iter().filter(|_| row.packed) {
        let form = format!("{name}.{end}");
        let _written = write!(
            packed,
            "Packed {{ coding: {coding:?}, content: include_bytes!({form:?}) }}, "
        );
    }
    Ok(format!(
        "File {{ name: {name:?}, media: {media:?}, hash: {hash:?}, kept: {kept}, inline: {inline}, \
         plain: include_bytes!({name:?}), packed: &[{packed}] }},\n"
    ))
}

fn media_type(name: &str) -> Option<&'static str> {
    Some(match name.rsplit_once('.')?.1 {
        "css" => "text/css; charset=utf-8",
        "html" => "text/html; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "png" => "image/png",
        "svg" => "image/svg+xml",
        "txt" => "text/plain; charset=utf-8",
        "wasm" => "application/wasm",
        "webmanifest" => "application/manifest+json",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_the_whole_answer() {
        let mut row = Row {
            name: "assets/page-1a2b.wasm".to_owned(),
            packed: true,
            inline: None,
        };
        assert_eq!(
            line(&row, "1a2b").unwrap(),
            "File { name: \"assets/page-1a2b.wasm\", media: \"application/wasm\", hash: \"1a2b\", kept: true, \
             inline: None, plain: include_bytes!(\"assets/page-1a2b.wasm\"), packed: &[\
             Packed { coding: \"br\", content: include_bytes!(\"assets/page-1a2b.wasm.br\") }, \
             Packed { coding: \"gzip\", content: include_bytes!(\"assets/page-1a2b.wasm.gz\") }, ] },\n"
        );
        row.name = "map.pmtiles".to_owned();
        assert!(line(&row, "1a2b").is_err());
    }
}
