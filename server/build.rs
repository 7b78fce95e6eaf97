//! Rebuilds the program when the page's bundle gains a file: the embedding alone sees changed files only.
fn main() {
    println!("cargo::rerun-if-changed=../web/dist");
}
