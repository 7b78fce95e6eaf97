//! The page's files, embedded: the table that the bundler wrote.

/// Every file of the page. Which table, the build task says; without it the empty one (`.cargo/config.toml`).
pub(crate) const PAGE: wheelover::page::Bundle = include!(env!("WHEELOVER_PAGE"));
