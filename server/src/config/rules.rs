//! What settings have to agree with, whichever way they come: from the configuration, from the file of kept
//! settings, or from a page while the ship sails.

use super::load;
use super::types::{Config, Port};
use wheelover_core::settings::{Settings, Value};

/// What settings of this configuration have to agree with.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rules {
    ports: Vec<Port>,
}

impl Rules {
    /// Settings that do not agree with the ports are refused, with what they do not agree with.
    pub(crate) fn check(&self, settings: &Settings) -> Result<(), String> {
        conflict(&self.ports, settings).map_or(Ok(()), |(_, text)| Err(text))
    }
}

impl Config {
    /// What settings have to agree with.
    pub(crate) fn rules(&self) -> Rules {
        Rules {
            ports: self.ports.clone(),
        }
    }

    /// Changes one setting, if it then still agrees with all else.
    pub(crate) fn set(&mut self, key: &str, value: &Value) -> Result<(), String> {
        let mut settings = self.settings.clone();
        settings.set(key, value)?;
        self.rules().check(&settings)?;
        self.settings = settings;
        Ok(())
    }
}

/// The first port that settings do not agree with, by its number, and why.
pub(super) fn conflict(ports: &[Port], settings: &Settings) -> Option<(usize, String)> {
    let mut loads = ports.iter().map(|port| load::complaint(port, settings));
    loads
        .by_ref()
        .enumerate()
        .find_map(|(number, load)| Some((number, load?)))
}
