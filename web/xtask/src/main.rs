//! The build task.
fn main() {}
