//! What the build task's programs share. It needs no other crate, so that the first command starts its work at once.

pub mod shell;
