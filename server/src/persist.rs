//! Settings kept over a restart, in a file beside the configuration.
//!
//! **Invariant:** the file is the whole of what was kept or the whole of what was kept before, whatever
//! happens while it is written; and a file that this program cannot read is kept aside, never written over.

use crate::error::{Error, reason};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::JoinHandle;
use wheelover_core::settings::Value;

/// Raised whenever a file of before has to be read in another way.
const VERSION: u32 = 1;
/// First line of the file.
const TITLE: &str = "# Settings changed on board; the program writes this file.\n";

/// Where the settings of a configuration are kept: `wheelover.toml` has `wheelover.settings.toml`.
pub(crate) fn beside(config: &Path) -> PathBuf {
    config.with_extension("settings.toml")
}

/// The file as written.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Form {
    version: u32,
    settings: BTreeMap<String, Value>,
}

/// What is kept.
#[derive(Debug)]
pub(crate) struct Store {
    path: PathBuf,
    values: BTreeMap<String, Value>,
}

impl Store {
    /// Reads what is kept. A file that cannot be read, or is of another version, is given another name, and
    /// that is said.
    ///
    /// # Errors
    /// Such a file cannot be kept aside: it would be lost with the first change.
    pub(crate) fn open(path: PathBuf) -> Result<(Self, Vec<String>), Error> {
        let mut cautions = Vec::new();
        let values = match read(&path) {
            Ok(values) => values,
            Err(why) => {
                let failed = |source| Error::File {
                    path: path.display().to_string(),
                    source,
                };
                let aside = keep_aside(&path).map_err(failed)?;
                cautions.push(format!(
                    "{}: {why}: the settings changed on board are not in force; the file is kept as {}",
                    path.display(),
                    aside.display()
                ));
                BTreeMap::new()
            }
        };
        Ok((Self { path, values }, cautions))
    }

    /// Brings what is kept into force by `set`; what does not fit any more is left out, said, and still kept.
    pub(crate) fn restore(
        &self,
        mut set: impl FnMut(&str, &Value) -> Result<(), String>,
    ) -> Vec<String> {
        let mut left: Vec<_> = self.values.iter().collect();
        loop {
            let mut refused = Vec::new();
            let mut cautions = Vec::new();
            for (key, value) in &left {
                if let Err(text) = set(key, value) {
                    refused.push((*key, *value));
                    cautions.push(format!("{}: {text}: not in force", self.path.display()));
                }
            }
            // Two that agree with each other may not agree one by one.
            if refused.is_empty() || refused.len() == left.len() {
                return cautions;
            }
            left = refused;
        }
    }
}

/// Writes settings as they change, in a thread of its own; the last one is on the disk when this value is gone.
#[derive(Debug)]
pub(crate) struct Keeper {
    sender: Option<Sender<(String, Value)>>,
    writer: Option<JoinHandle<()>>,
}

impl Keeper {
    /// Begins to keep.
    ///
    /// # Errors
    /// The system gives no thread.
    pub(crate) fn begin(store: Store) -> Result<Self, Error> {
        let (sender, receiver) = channel();
        let writer = std::thread::Builder::new()
            .name("settings".to_owned())
            .spawn(move || run(store, &receiver))
            .map_err(|error| Error::Other(format!("cannot start: {error}")))?;
        Ok(Self {
            sender: Some(sender),
            writer: Some(writer),
        })
    }

    /// Keeps one; never waits.
    pub(crate) fn keep(&self, key: String, value: Value) {
        // TOML has no null.
        let value = match value {
            Value::Absent => Value::Choice(String::new()),
            value => value,
        };
        if let Some(sender) = &self.sender {
            let _ = sender.send((key, value));
        }
    }
}

impl Drop for Keeper {
    fn drop(&mut self) {
        self.sender = None;
        if let Some(writer) = self.writer.take() {
            let _ = writer.join();
        }
    }
}

fn run(mut store: Store, changes: &Receiver<(String, Value)>) {
    while let Ok((key, value)) = changes.recv() {
        store.values.insert(key, value);
        store.values.extend(changes.try_iter());
        if let Err(error) = write(&store.path, &store.values) {
            let path = store.path.display();
            tracing::warn!("{path}: settings are not kept: {}", reason(&error));
        }
    }
}

/// What is kept; nothing where there is no file.
fn read(path: &Path) -> Result<BTreeMap<String, Value>, String> {
    let bytes = match fs::read(path) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(BTreeMap::new()),
        Err(error) => return Err(reason(&error)),
    };
    let text = String::from_utf8(bytes).map_err(|_| "not text".to_owned())?;
    let table: toml::Table = toml::from_str(&text).map_err(|error| one_line(&error))?;
    match table.get("version").and_then(toml::Value::as_integer) {
        Some(version) if version == i64::from(VERSION) => {}
        Some(version) => return Err(format!("version {version}, this program knows {VERSION}")),
        None => return Err("without a version".to_owned()),
    }
    let form: Form = toml::from_str(&text).map_err(|error| one_line(&error))?;
    Ok(form.settings)
}

fn one_line(error: &toml::de::Error) -> String {
    error.message().lines().collect::<Vec<_>>().join("; ")
}

/// Gives a file a name that nothing has; gives that name.
fn keep_aside(path: &Path) -> io::Result<PathBuf> {
    for number in 1..=9_999 {
        let aside = path.with_extension(format!("toml.aside-{number}"));
        // A link is never made over a file that is there.
        match fs::hard_link(path, &aside) {
            Ok(()) => {}
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => continue,
            // A file system without links: nobody else gives names here.
            Err(_) if !aside.try_exists()? => {
                fs::rename(path, &aside)?;
                sync_folder(path)?;
                return Ok(aside);
            }
            Err(_) => continue,
        }
        fs::remove_file(path)?;
        sync_folder(path)?;
        return Ok(aside);
    }
    Err(io::ErrorKind::AlreadyExists.into())
}

/// The whole file or nothing: written beside, brought to disk, put in place, and its place brought to disk.
fn write(path: &Path, values: &BTreeMap<String, Value>) -> io::Result<()> {
    let form = Form {
        version: VERSION,
        settings: values.clone(),
    };
    let text = toml::to_string(&form).map_err(io::Error::other)?;
    let beside = path.with_extension("toml.new");
    let mut file = File::create(&beside)?;
    file.write_all(TITLE.as_bytes())?;
    file.write_all(text.as_bytes())?;
    file.sync_all()?;
    drop(file);
    fs::rename(&beside, path)?;
    sync_folder(path)
}

/// Brings the names in a file's folder to disk.
fn sync_folder(path: &Path) -> io::Result<()> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    File::open(folder)?.sync_all()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder of its own, and the name of a settings file in it.
    fn place(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("wheelover-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        beside(&folder.join("w.toml"))
    }

    fn restored(store: &Store) -> BTreeMap<String, Value> {
        let mut values = BTreeMap::new();
        let cautions = store.restore(|key, value| {
            values.insert(key.to_owned(), value.clone());
            Ok(())
        });
        assert!(cautions.is_empty(), "{cautions:?}");
        values
    }

    #[test]
    fn the_last_change_is_on_the_disk_when_the_keeper_is_gone() {
        let path = place("kept");
        assert!(path.ends_with("w.settings.toml"));
        for round in 1..=50 {
            let keeper = Keeper::begin(Store::open(path.clone()).unwrap().0).unwrap();
            keeper.keep(
                "rudder_limit".to_owned(),
                Value::Number(2.0 + f64::from(round) / 8.0),
            );
            keeper.keep(format!("key_{round}"), Value::Switch(true));
            drop(keeper);
            let (store, cautions) = Store::open(path.clone()).unwrap();
            assert!(cautions.is_empty(), "{cautions:?}");
            let values = restored(&store);
            assert_eq!(
                values["rudder_limit"],
                Value::Number(2.0 + f64::from(round) / 8.0)
            );
            assert_eq!(values.len(), 1 + round as usize);
        }
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.contains("version = 1\n"), "{text}");
    }

    #[test]
    fn what_does_not_fit_is_said_and_still_kept() {
        let path = place("unfit");
        let mut values = BTreeMap::new();
        values.insert("no_such".to_owned(), Value::Number(1.0));
        values.insert("rudder_limit".to_owned(), Value::Number(12.0));
        write(&path, &values).unwrap();
        let (store, _) = Store::open(path.clone()).unwrap();
        let cautions = store.restore(|key, _| match key {
            "no_such" => Err("no setting is named no_such".to_owned()),
            _ => Ok(()),
        });
        assert_eq!(cautions.len(), 1, "{cautions:?}");
        let keeper = Keeper::begin(store).unwrap();
        keeper.keep("rudder_limit".to_owned(), Value::Number(13.0));
        drop(keeper);
        let kept = read(&path).unwrap();
        assert_eq!(kept["no_such"], Value::Number(1.0));
        assert_eq!(kept["rudder_limit"], Value::Number(13.0));
    }

    #[test]
    fn a_file_that_is_not_ours_is_kept_aside_and_never_written_over() {
        let path = place("aside");
        let foreign: [&[u8]; 8] = [
            b"",
            b"\0\0\0\0",
            b"\xff\xfe",
            b"rudder_limit = 12.0\n",
            b"version = 2\n[settings]\nrudder_limit = { degrees = 12 }\n",
            b"version = \"1\"\n[settings]\n",
            b"version = 1\n[settings]\nrudder_limit = ",
            b"version = 1\n[settings]\nrudder_limit = 12.0\n[more]\n",
        ];
        for (number, bytes) in foreign.iter().enumerate() {
            fs::write(&path, bytes).unwrap();
            let (store, cautions) = Store::open(path.clone()).unwrap();
            assert_eq!(cautions.len(), 1, "{bytes:?}");
            let aside = path.with_extension(format!("toml.aside-{}", number + 1));
            let name = aside.display().to_string();
            assert!(cautions[0].contains(&name), "{cautions:?}");
            assert!(!cautions[0].contains('\n'), "{cautions:?}");
            let keeper = Keeper::begin(store).unwrap();
            keeper.keep("set_rate".to_owned(), Value::Number(30.0));
            drop(keeper);
            assert_eq!(&fs::read(&aside).unwrap(), bytes, "{name}");
            assert_eq!(read(&path).unwrap().len(), 1);
        }
    }

    // FD1, FD2: whatever part of a change reached the disk, the file is one that was kept.
    #[test]
    fn a_write_that_was_cut_off_leaves_what_was_kept_before() {
        let path = place("cut");
        let mut values = BTreeMap::new();
        values.insert("rudder_limit".to_owned(), Value::Number(12.0));
        write(&path, &values).unwrap();
        let whole = fs::read(&path).unwrap();
        for length in 0..=whole.len() {
            fs::write(path.with_extension("toml.new"), &whole[..length]).unwrap();
            let (store, cautions) = Store::open(path.clone()).unwrap();
            assert_eq!((restored(&store), cautions.len()), (values.clone(), 0));
        }
        write(&path, &values).unwrap();
        assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
    }
}
