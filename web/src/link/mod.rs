//! The link: whatever says the frames and takes the commands stands behind one `Source`.
//!
//! A live ship, a voyage that runs in the page and, later, a recording are so the same page: each gives
//! [`Down`](wheelover_core::view::Down) and takes [`Up`](wheelover_core::view::Up).
//!
//! **Invariant:** what cannot be sent at once is not sent later (AP-25): a command without a live link is answered here.

pub mod frames;
mod socket;
mod source;
mod voyage;

pub(crate) use socket::Socket;
pub(crate) use source::{command, open, renew, watch};
pub(crate) use voyage::InPage;
