//! What the integration tests share: the real binary, pseudo-terminals, a WebSocket client, a browser.
//!
//! Nothing here sleeps where an event can be waited for; deadlines are generous, since machines are busy.

pub mod browser;
pub mod foreign;
pub mod http;
pub mod page;
pub mod program;
pub mod serial;

pub use wheelover_core::nmea::with_checksum;

use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Held while a program begins and while a pseudo-terminal is made, so that no child inherits an open end:
/// a plug would then never be pulled.
fn alone() -> MutexGuard<'static, ()> {
    static ALONE: Mutex<()> = Mutex::new(());
    ALONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A folder of its own for a test, empty.
///
/// # Panics
/// It cannot be made.
#[must_use]
#[allow(clippy::unwrap_used)]
pub fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wheelover-{}-{name}", std::process::id()));
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// A file of the tests' data.
#[must_use]
pub fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("data")
        .join(name)
}
