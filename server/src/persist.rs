//! Settings kept over a restart, in a file beside the configuration.

use crate::error::{Error, reason};
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use wheelover_core::settings::{Settings, Value};

/// Where the settings of a configuration are kept: `wheelover.toml` has `wheelover.settings.toml`.
#[must_use]
pub fn beside(config: &Path) -> PathBuf {
    config.with_extension("settings.toml")
}

/// Writes settings as they change, in a thread of its own.
#[derive(Debug)]
pub struct Keeper {
    sender: Sender<(String, Value)>,
}

impl Keeper {
    /// Begins to keep settings in `path`.
    ///
    /// # Errors
    /// The system gives no thread.
    pub fn begin(path: PathBuf) -> Result<Self, Error> {
        let (sender, receiver) = channel();
        std::thread::Builder::new()
            .name("settings".to_owned())
            .spawn(move || run(&path, &receiver))
            .map_err(|error| Error::Other(format!("cannot start: {error}")))?;
        Ok(Self { sender })
    }

    /// Keeps one; never waits.
    pub fn keep(&self, key: String, value: Value) {
        let _ = self.sender.send((key, value));
    }
}

fn run(path: &Path, changes: &Receiver<(String, Value)>) {
    let mut values = read(path).unwrap_or_default();
    while let Ok((key, value)) = changes.recv() {
        values.insert(key, value);
        values.extend(changes.try_iter());
        if let Err(error) = write(path, &values) {
            eprintln!("caution: {}: {}", path.display(), reason(&error));
        }
    }
}

/// Brings kept settings into force; what does not fit any more is left out, and said.
pub fn restore(path: &Path, settings: &mut Settings) -> Vec<String> {
    let values = match read(path) {
        Ok(values) => values,
        Err(text) => return vec![text],
    };
    let mut cautions = Vec::new();
    for (key, value) in values {
        if let Err(text) = settings.set(&key, &value) {
            cautions.push(format!("{}: {text}", path.display()));
        }
    }
    cautions
}

fn read(path: &Path) -> Result<BTreeMap<String, Value>, String> {
    match fs::read_to_string(path) {
        Ok(text) => toml::from_str(&text)
            .map_err(|error| format!("{}: {}", path.display(), error.message())),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(BTreeMap::new()),
        Err(error) => Err(format!("{}: {}", path.display(), reason(&error))),
    }
}

/// A value as TOML.
pub(crate) fn written(value: &Value) -> String {
    match value {
        Value::Switch(on) => on.to_string(),
        Value::Number(number) => format!("{number:?}"),
        Value::Choice(name) => format!("\"{name}\""),
        Value::Absent => "\"\"".to_owned(),
    }
}

/// The whole file or nothing: written beside, brought to disk, then put in place.
fn write(path: &Path, values: &BTreeMap<String, Value>) -> std::io::Result<()> {
    let beside = path.with_extension("tmp");
    let mut file = File::create(&beside)?;
    writeln!(
        file,
        "# Settings changed on board; the program writes this file."
    )?;
    for (key, value) in values {
        writeln!(file, "{key} = {}", written(value))?;
    }
    file.sync_all()?;
    fs::rename(&beside, path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_kept_is_in_force_again() {
        let folder =
            std::env::temp_dir().join(format!("wheelover-settings-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = beside(&folder.join("w.toml"));
        let mut values = BTreeMap::new();
        values.insert("rudder_limit".to_owned(), Value::Number(12.0));
        values.insert("no_such".to_owned(), Value::Number(1.0));
        write(&path, &values).unwrap();
        let mut settings = Settings::default();
        let cautions = restore(&path, &mut settings);
        assert_eq!(settings.rudder_limit, 12.0);
        assert_eq!(cautions.len(), 1, "{cautions:?}");
        assert!(path.ends_with("w.settings.toml"));
        fs::remove_dir_all(&folder).unwrap();
        assert!(restore(&path, &mut settings).is_empty());
    }
}
