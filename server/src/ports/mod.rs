//! Ports: bytes in and out of serial lines, TCP, UDP and files. What the bytes mean is the core's affair.
//!
//! **Invariant:** a port that goes away comes back by itself (FB8, FB9), and one that does not take its
//! output holds the newest sentence of each kind, never a backlog (FB11).

mod contacts;
mod gpio;
pub(crate) mod list;
mod open;
mod playback;
mod stood;
mod task;
mod wire;

use crate::bus::{Inlet, Link};
use crate::config::{At, Config, Contact, Port};
use crate::error::Error;
use std::path::PathBuf;
use tokio_util::sync::CancellationToken;
use tokio_util::task::TaskTracker;

/// Ports that are open, or whose device is not there yet; nothing runs on them before [`Ready::start`].
#[derive(Debug)]
pub(crate) struct Ready {
    opened: Vec<(Port, Option<open::Opened>)>,
    contacts: Vec<Contact>,
}

impl Ready {
    /// Opens what is there.
    ///
    /// # Errors
    /// A device or an address is taken by another program; one that is absent is no error.
    pub(crate) async fn open(config: &Config) -> Result<Self, Error> {
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
        Ok(Self {
            opened,
            contacts: config.contacts.clone(),
        })
    }

    /// Runs the ports, as tasks of the server, until it ends.
    pub(crate) fn start(
        self,
        links: &[Link],
        inlet: &Inlet,
        tasks: &TaskTracker,
        stop: &CancellationToken,
    ) {
        let at = |place: &At| {
            let here = self.contacts.iter().filter(|contact| contact.at == *place);
            here.cloned().collect::<Vec<_>>()
        };
        for (index, ((port, opened), link)) in self.opened.into_iter().zip(links).enumerate() {
            let contacts = contacts::Contacts::new(at(&At::Port(index)));
            let running = task::run(port, opened, contacts, link.clone(), inlet.clone());
            tasks.spawn(stop.clone().run_until_cancelled_owned(running));
        }
        let mut devices: Vec<PathBuf> = Vec::new();
        for contact in &self.contacts {
            let inlet = inlet.clone();
            match &contact.at {
                At::Device(path) if !devices.contains(path) => {
                    devices.push(path.clone());
                    let watching = contacts::watch(path.clone(), at(&contact.at), inlet);
                    tasks.spawn(stop.clone().run_until_cancelled_owned(watching));
                }
                // Each line of a chip is asked for by itself.
                At::Chip(path) => {
                    let watching = gpio::watch(path.clone(), contact.clone(), inlet);
                    tasks.spawn(stop.clone().run_until_cancelled_owned(watching));
                }
                At::Device(_) | At::Port(_) => {}
            }
        }
    }
}
