//! The core as a module of wasm imports nothing: no clock, no randomness, no log.

use crate::files::root;
use std::path::PathBuf;
use std::process::Command;

const WASM: &str = "wasm32-unknown-unknown";

/// What a module imports, each as `module.name`; none where it is no module.
fn imports(module: &[u8]) -> Option<Vec<String>> {
    let mut rest = module.strip_prefix(b"\0asm\x01\0\0\0")?;
    while let Some((kind, after)) = rest.split_first() {
        rest = after;
        let length = number(&mut rest)?;
        let (mut section, after) = rest.split_at_checked(length)?;
        rest = after;
        if *kind != 2 {
            continue;
        }
        let mut found = Vec::new();
        for _ in 0..number(&mut section)? {
            let (module, name) = (text(&mut section)?, text(&mut section)?);
            found.push(format!("{module}.{name}"));
            // Only functions are told apart; one of another kind ends the list.
            if section.split_off_first()? != &0 {
                break;
            }
            number(&mut section)?;
        }
        return Some(found);
    }
    Some(Vec::new())
}

/// LEB128.
fn number(bytes: &mut &[u8]) -> Option<usize> {
    let (mut value, mut shift) = (0, 0);
    loop {
        let byte = usize::from(*bytes.split_off_first()?);
        value |= (byte & 0x7f) << shift;
        shift += 7;
        if byte < 0x80 {
            return Some(value);
        }
    }
}

fn text(bytes: &mut &[u8]) -> Option<String> {
    let length = number(bytes)?;
    let (text, rest) = bytes.split_at_checked(length)?;
    *bytes = rest;
    Some(String::from_utf8_lossy(text).into_owned())
}

#[test]
fn the_core_in_wasm_imports_nothing() {
    let mut build = Command::new(env!("CARGO"));
    build.args([
        "build",
        "--quiet",
        "-p",
        "wheelover-core",
        "--example",
        "module",
        "--target",
        WASM,
    ]);
    let done = build.current_dir(root()).status();
    assert!(done.is_ok_and(|status| status.success()), "{build:?}");
    let target =
        std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
    let module = std::fs::read(target.join(WASM).join("debug/examples/module.wasm")).unwrap();
    assert!(module.len() > 100_000, "the core is in it");
    assert_eq!(imports(&module), Some(Vec::new()));
}

#[test]
fn an_import_is_found() {
    let module = b"\0asm\x01\0\0\0\x01\x04\x01\x60\0\0\x02\x0b\x01\x03env\x03now\0\0";
    assert_eq!(imports(module), Some(vec!["env.now".to_owned()]));
    assert_eq!(imports(b"not a module"), None);
}
