//! Ports: bytes in and out of serial lines, TCP, UDP and files. What the bytes mean is the core's affair.
//!
//! **Invariant:** a port that goes away comes back by itself (FB8, FB9), and one that does not take its
//! output holds the newest sentence of each kind, never a backlog (FB11).

pub mod list;
mod open;
mod outbox;
mod playback;
mod task;
mod wire;

pub use outbox::Outbox;

use crate::config::{Config, Port};
use crate::control::Control;
use crate::error::Error;
use std::sync::{Arc, Mutex, PoisonError};
use tokio::sync::watch;

/// One port as the rest of the server sees it.
#[derive(Clone, Debug)]
pub struct Link {
    /// Its number among the ports of the configuration.
    pub index: usize,
    /// Its name.
    pub name: String,
    /// What is to be sent.
    pub outbox: Arc<Outbox>,
    trouble: Arc<Mutex<String>>,
}

impl Link {
    /// A port of which nothing is known yet.
    #[must_use]
    pub fn new(index: usize, name: &str) -> Self {
        Self {
            index,
            name: name.to_owned(),
            outbox: Arc::default(),
            trouble: Arc::default(),
        }
    }

    /// What is wrong with it; empty where nothing is.
    #[must_use]
    pub fn trouble(&self) -> String {
        self.trouble
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .clone()
    }

    fn set_trouble(&self, text: &str) {
        let mut trouble = self.trouble.lock().unwrap_or_else(PoisonError::into_inner);
        if *trouble != text {
            text.clone_into(&mut trouble);
        }
    }
}

/// Ports that are open, or whose device is not there yet; nothing runs on them before [`Ready::start`].
#[derive(Debug)]
pub struct Ready {
    opened: Vec<(Port, Option<open::Opened>)>,
}

impl Ready {
    /// Opens what is there.
    ///
    /// # Errors
    /// A device or an address is taken by another program; one that is absent is no error.
    pub async fn open(config: &Config) -> Result<Self, Error> {
        let mut opened = Vec::with_capacity(config.ports.len());
        for port in &config.ports {
            let found = match open::open(&port.place).await {
                Ok(found) => Some(found),
                Err(failure) if failure.taken => {
                    return Err(Error::Port {
                        name: port.setup.name.clone(),
                        text: failure.text,
                    });
                }
                Err(_) => None,
            };
            opened.push((port.clone(), found));
        }
        Ok(Self { opened })
    }

    /// Runs the ports until `stop` is raised.
    pub fn start(self, links: &[Link], control: &Control, stop: &watch::Receiver<bool>) {
        for ((port, opened), link) in self.opened.into_iter().zip(links) {
            let (link, control, stop) = (link.clone(), control.clone(), stop.clone());
            tokio::spawn(task::run(port, opened, link, control, stop));
        }
    }
}
