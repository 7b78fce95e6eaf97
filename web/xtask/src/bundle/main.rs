//! Binds the compiled page and lays `web/dist`; prints the bytes of a first load.
//!
//! wasm-bindgen is used as a library, so nothing prebuilt is downloaded and its version cannot differ from the page's.
//! Layout: `index.html`, `decoder.html`, `sw.js`, `manifest.webmanifest`, `build.txt` and icons have fixed names; all
//! that stands under `assets/` is named by its content and may be cached for ever. Each has a `.br` and a `.gz` beside it.

mod files;

use files::{Compression, base64, fingerprint, pack, write};
use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
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
    let page = bind(built, "wheelover-web", release)?;
    let dictionary = bind(built, "wheelover-dictionary", release)?;
    let compression = if release {
        Compression::Small
    } else {
        Compression::Quick
    };
    lay(&page, &dictionary, compression)
}

/// The page after wasm-bindgen.
struct Page {
    script: String,
    wasm: Vec<u8>,
}

fn bind(built: &Path, name: &str, release: bool) -> Result<Page, Failure> {
    let folder = target().join("xtask-bindgen").join(name);
    let failed = |error: &dyn std::fmt::Display| Failure::new(format!("wasm-bindgen: {error}"));
    let mut bindgen = Bindgen::new();
    bindgen
        .input_path(built.join(format!("{name}.wasm")))
        .out_name("page")
        .typescript(false)
        .omit_default_module_path(true)
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
    Ok(Page {
        script: text(&folder.join("page.js"))?,
        wasm: std::fs::read(&wasm).map_err(|error| Failure::file(&wasm, &error))?,
    })
}

/// Writes the folder; gives back the bytes of a first load.
fn lay(page: &Page, dictionary: &Page, compression: Compression) -> Result<u64, Failure> {
    let dist = root().join("web/dist");
    let fixed = root().join("static");
    clear(&dist.join("assets"))?;
    let mut first_load = Vec::new();
    // The largest come first: what is packed last should be short.
    let packed = RefCell::new(Vec::<PathBuf>::new());
    let put = |name: &str, content: &[u8]| -> Outcome {
        let path = dist.join(name);
        write(&path, content)?;
        packed.borrow_mut().push(path);
        Ok(())
    };
    let decoder = text(&fixed.join("decoder.html"))?
        .replace("{{style}}", &style(&fixed)?)
        .replace("{{palette}}", &text(&fixed.join("palette.js"))?)
        .replace("{{script}}", &page.script)
        .replace("{{wasm}}", &base64(&page.wasm))
        .replace("{{dictionary_script}}", &dictionary.script)
        .replace("{{dictionary_wasm}}", &base64(&dictionary.wasm));
    put("decoder.html", decoder.as_bytes())?;
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
    let start = text(&fixed.join("start.js"))?
        .replace("{{script}}", &script)
        .replace("{{wasm}}", &wasm)
        .replace("{{dictionary_script}}", &dictionary_script)
        .replace("{{dictionary_wasm}}", &dictionary_wasm);
    let start = asset("start", "js", start.as_bytes())?;
    let style_name = asset("page", "css", style(&fixed)?.as_bytes())?;
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
    ]
    .map(|name| format!("\"{name}\""));
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
        write(&dist.join(name), &content)?;
        if !name.ends_with(".png") {
            packed.borrow_mut().push(dist.join(name));
        }
    }
    pack(&packed.borrow(), compression)?;
    first_load.iter().map(|path| length(path)).sum()
}

fn style(fixed: &Path) -> Result<String, Failure> {
    Ok(text(&fixed.join("page.css"))? + &text(&fixed.join("talk.css"))?)
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
