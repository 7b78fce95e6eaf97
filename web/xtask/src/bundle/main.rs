//! Binds the compiled page and lays `web/dist`; prints the bytes of a first load.
//!
//! wasm-bindgen is used as a library, so nothing prebuilt is downloaded and its version cannot differ from the page's.
//! Layout: `index.html`, `decoder.html`, `sw.js`, `manifest.webmanifest`, `build.txt` and icons have fixed names; all
//! that stands under `assets/` is named by its content and may be cached for ever. Each has a `.br` and a `.gz` beside it.
//! `page.rs` is the table of all of them, which the program embeds.

mod cut;
mod files;
mod lean;
mod table;

use cut::Cut;
use files::{Compression, base64, fingerprint, pack, sha256, write};
use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use table::Row;
use wasm_bindgen_cli_support::Bindgen;
use xtask::shell::{Failure, Outcome, root, target, text};

fn main() -> ExitCode {
    let folder = std::env::args_os().nth(1).map(PathBuf::from);
    let release = std::env::args().any(|argument| argument == "--release");
    let Some(built) = folder else {
        eprintln!("usage: bundle FOLDER [--release], where FOLDER has the compiled page");
        return ExitCode::from(2);
    };
    match bundle(&built, release) {
        Ok(first_load) => {
            println!("{first_load}");
            ExitCode::SUCCESS
        }
        Err(failure) => {
            eprintln!("{failure}");
            ExitCode::FAILURE
        }
    }
}

fn bundle(built: &Path, release: bool) -> Result<u64, Failure> {
    let compiled = |name: &str| built.join(format!("{name}.wasm"));
    let dictionary = bind(&compiled("wheelover-dictionary"), "dictionary", release)?;
    let pages = if release {
        cut_page(&compiled("wheelover-web"))?
    } else {
        Pages {
            whole: bind(&compiled("wheelover-web"), "page", release)?,
            cut: None,
        }
    };
    let compression = if release {
        Compression::Small
    } else {
        Compression::Quick
    };
    lay(&pages, &dictionary, compression)
}

/// The page in one piece, for the file that works from a disk, and cut, for the server.
struct Pages {
    whole: Page,
    cut: Option<(Page, Cut)>,
}

fn cut_page(compiled: &Path) -> Result<Pages, Failure> {
    let folder = target().join("xtask-bindgen").join("cut");
    std::fs::create_dir_all(&folder).map_err(|error| Failure::file(&folder, &error))?;
    let cut = cut::cut(compiled, &folder)?;
    let mut page = bind(&cut.main, "page", true)?;
    page.script = cut.join(&page.script)?;
    let input = std::fs::read(compiled).map_err(|error| Failure::file(compiled, &error))?;
    let lean = cut::without_relocations(&input)
        .ok_or_else(|| Failure::new("the compiled page is no module of wasm"))?;
    let path = folder.join("whole.wasm");
    write(&path, &lean)?;
    let mut whole = bind(&path, "whole", true)?;
    whole.script = cut::join_whole(&whole.script)?;
    Ok(Pages {
        whole,
        cut: Some((page, cut)),
    })
}

/// The page after wasm-bindgen.
struct Page {
    script: String,
    wasm: Vec<u8>,
}

fn bind(compiled: &Path, name: &str, release: bool) -> Result<Page, Failure> {
    let folder = target().join("xtask-bindgen").join(name);
    let failed = |error: &dyn std::fmt::Display| Failure::new(format!("wasm-bindgen: {error}"));
    let mut bindgen = Bindgen::new();
    bindgen
        .input_path(compiled)
        .out_name("page")
        .typescript(false)
        .omit_default_module_path(true)
        // Parts that are cut out are entered through what the linker exported.
        .keep_lld_exports(release && name != "dictionary")
        .remove_name_section(release)
        .remove_producers_section(true);
    let mut output = bindgen
        .web(true)
        .and_then(Bindgen::generate_output)
        .map_err(|error| failed(&format!("{error:#}")))?;
    if !output.snippets().values().all(Vec::is_empty) || !output.local_modules().is_empty() {
        return Err(failed(&format!(
            "a dependency brings a script of its own, which the bundle does not carry: {:?} {:?}",
            output.snippets(),
            output.local_modules().keys(),
        )));
    }
    output
        .emit(&folder)
        .map_err(|error| failed(&format!("{error:#}")))?;
    let wasm = folder.join("page_bg.wasm");
    let script = text(&folder.join("page.js"))?;
    Ok(Page {
        script: if release {
            lean::script(&script)
        } else {
            script
        },
        wasm: std::fs::read(&wasm).map_err(|error| Failure::file(&wasm, &error))?,
    })
}

/// Writes the folder; gives back the bytes of a first load.
fn lay(pages: &Pages, dictionary: &Page, compression: Compression) -> Result<u64, Failure> {
    let (whole, page) = (
        &pages.whole,
        pages.cut.as_ref().map_or(&pages.whole, |(page, _)| page),
    );
    let dist = root().join("web/dist");
    let fixed = root().join("static");
    clear(&dist.join("assets"))?;
    let mut first_load = Vec::new();
    // The largest come first: what is packed last should be short.
    let rows = RefCell::new(Vec::<Row>::new());
    let add = |name: &str, content: &[u8], inline| -> Outcome {
        rows.borrow_mut().push(Row {
            name: name.to_owned(),
            // A picture is packed already.
            packed: !name.ends_with(".png"),
            inline,
        });
        write(&dist.join(name), content)
    };
    let put = |name: &str, content: &[u8]| add(name, content, None);
    let decoder = text(&fixed.join("decoder.html"))?
        .replace(
            "{{style}}",
            &style(&fixed, &["page.css", "sizes.css", "talk.css"])?,
        )
        .replace("{{palette}}", &text(&fixed.join("palette.js"))?)
        .replace("{{script}}", &whole.script)
        .replace("{{wasm}}", &base64(&whole.wasm))
        .replace("{{dictionary_script}}", &dictionary.script)
        .replace("{{dictionary_wasm}}", &base64(&dictionary.wasm));
    // What the server lets the file run that stands in it, and nothing else.
    let allowed = [("<script", "</script>"), ("<style", "</style>")]
        .map(|(open, close)| inline(&decoder, open, close).join(" "));
    add("decoder.html", decoder.as_bytes(), Some(allowed))?;
    let later = |stem: &str, ending: &str, content: &[u8]| -> Result<String, Failure> {
        let name = format!("assets/{stem}-{}.{ending}", fingerprint(content));
        put(&name, content)?;
        Ok(format!("/{name}"))
    };
    let mut asset = |stem: &str, ending: &str, content: &[u8]| -> Result<String, Failure> {
        let name = later(stem, ending, content)?;
        first_load.push(dist.join(format!("{}.br", name.trim_start_matches('/'))));
        Ok(name)
    };
    let wasm = asset("page", "wasm", &page.wasm)?;
    let script = asset("page", "js", page.script.as_bytes())?;
    // Fetched later, so not part of the first load.
    let dictionary_wasm = later("dictionary", "wasm", &dictionary.wasm)?;
    let dictionary_script = later("dictionary", "js", dictionary.script.as_bytes())?;
    let talk_style = later("talk", "css", style(&fixed, &["talk.css"])?.as_bytes())?;
    let mut parts = Vec::new();
    for (_, content) in pages.cut.iter().flat_map(|(_, cut)| &cut.parts) {
        let name = format!("assets/{}", Cut::laid(content));
        put(&name, content)?;
        parts.push(format!("/{name}"));
    }
    let start = text(&fixed.join("start.js"))?
        .replace("{{script}}", &script)
        .replace("{{wasm}}", &wasm)
        .replace("{{dictionary_script}}", &dictionary_script)
        .replace("{{dictionary_wasm}}", &dictionary_wasm)
        .replace("{{talk}}", &talk_style);
    let start = asset("start", "js", start.as_bytes())?;
    let style_name = asset(
        "page",
        "css",
        style(&fixed, &["page.css", "sizes.css"])?.as_bytes(),
    )?;
    let palette_name = asset("palette", "js", text(&fixed.join("palette.js"))?.as_bytes())?;
    let index = text(&fixed.join("index.html"))?
        .replace("{{style}}", &style_name)
        .replace("{{palette}}", &palette_name)
        .replace("{{start}}", &start)
        .replace("{{script}}", &script)
        .replace("{{wasm}}", &wasm);
    put("index.html", index.as_bytes())?;
    first_load.push(dist.join("index.html.br"));

    let build = fingerprint(index.as_bytes());
    let kept = [
        &wasm,
        &script,
        &start,
        &style_name,
        &palette_name,
        &dictionary_wasm,
        &dictionary_script,
        &talk_style,
    ]
    .into_iter()
    .chain(&parts)
    .map(|name| format!("\"{name}\""))
    .collect::<Vec<_>>();
    let worker = text(&fixed.join("sw.js"))?
        .replace("{{build}}", &build)
        .replace("\"{{assets}}\"", &kept.join(", "));
    put("sw.js", worker.as_bytes())?;
    put("build.txt", build.as_bytes())?;

    for name in [
        "icon-192.png",
        "icon-512.png",
        "icon.svg",
        "manifest.webmanifest",
    ] {
        let path = fixed.join(name);
        let content = std::fs::read(&path).map_err(|error| Failure::file(&path, &error))?;
        put(name, &content)?;
    }
    let rows = rows.into_inner();
    let packed = rows.iter().filter(|row| row.packed);
    let packed: Vec<PathBuf> = packed.map(|row| dist.join(&row.name)).collect();
    pack(&packed, compression)?;
    table::write(&dist, &rows)?;
    first_load.iter().map(|path| length(path)).sum()
}

/// Sources of a content security policy for what stands inline in elements that begin and end so.
fn inline(page: &str, open: &str, close: &str) -> Vec<String> {
    let source = |rest: &str| {
        let content = rest.split_once('>')?.1.split_once(close)?.0;
        Some(format!("'sha256-{}'", base64(&sha256(content.as_bytes()))))
    };
    page.split(open).skip(1).filter_map(source).collect()
}

fn style(fixed: &Path, names: &[&str]) -> Result<String, Failure> {
    names.iter().map(|name| text(&fixed.join(name))).collect()
}

fn length(path: &Path) -> Result<u64, Failure> {
    path.metadata()
        .map(|facts| facts.len())
        .map_err(|error| Failure::file(path, &error))
}

fn clear(folder: &Path) -> Outcome {
    match std::fs::remove_dir_all(folder) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
            Err(Failure::file(folder, &error))
        }
        _ => Ok(()),
    }
}
