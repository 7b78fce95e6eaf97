//! The page's bundle, embedded in the program; a development build reads it from the folder.

use rust_embed::{EmbeddedFile, RustEmbed};

// The build task names the page that it has laid: another page, another program (the embedding alone sees changed files only).
const _: Option<&str> = option_env!("WHEELOVER_PAGE");

#[derive(RustEmbed)]
#[folder = "../web/dist"]
#[allow_missing = true]
struct Dist;

/// A file of the page; none where the program was built without it.
pub(crate) fn file(name: &str) -> Option<EmbeddedFile> {
    Dist::get(name)
}
