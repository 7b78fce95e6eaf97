//! The serial ports of this machine, by the names under which a configuration finds them again.

use std::fs;
use std::path::{Path, PathBuf};

/// A serial port.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Found {
    /// The name to be written into a configuration: one that stays with the device, where there is one.
    pub(crate) path: PathBuf,
    /// The device behind it.
    pub(crate) device: PathBuf,
}

/// Lists the serial ports: those with lasting names first.
#[must_use]
pub(crate) fn list() -> Vec<Found> {
    within(Path::new("/dev"), Path::new("/sys/class/tty"))
}

fn within(dev: &Path, sys: &Path) -> Vec<Found> {
    let mut found: Vec<Found> = Vec::new();
    for path in sorted(&dev.join("serial/by-id")) {
        if let Ok(device) = fs::canonicalize(&path) {
            found.push(Found { path, device });
        }
    }
    for path in sorted(dev) {
        let name = path
            .file_name()
            .map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let plugged = name.starts_with("ttyUSB") || name.starts_with("ttyACM");
        if !(plugged || name.starts_with("ttyS") && is_fitted(&sys.join(&name))) {
            continue;
        }
        if !found.iter().any(|other| other.device == path) {
            found.push(Found {
                device: path.clone(),
                path,
            });
        }
    }
    found
}

/// The system names more built-in ports than are fitted; those that are not have the type 0.
fn is_fitted(class: &Path) -> bool {
    fs::read_to_string(class.join("type")).is_ok_and(|kind| kind.trim() != "0")
}

fn sorted(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else {
        return Vec::new();
    };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    paths
}
