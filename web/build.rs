//! A page whose views are cut out needs the linker's relocations to be cut by, and its table of functions to be entered again.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var_os("CARGO_FEATURE_SPLIT").is_some() {
        for argument in ["--emit-relocs", "--export-table"] {
            println!("cargo::rustc-link-arg-bin=wheelover-web={argument}");
        }
    }
}
