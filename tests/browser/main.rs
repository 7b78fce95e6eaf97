//! The page in Chromium: it moves, agrees with the lines, commands, explains, and never complains.
#![allow(clippy::unwrap_used)]

mod believed;
mod bridge;
mod checked;
mod decoder;
mod fed;
mod foreign;
mod layout;
mod modes;
mod outage;
mod pace;
mod sleep;
mod words;
