//! The `wheelover` program.
fn main() {}
