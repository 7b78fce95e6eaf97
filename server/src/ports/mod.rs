//! Ports: bytes in and out of serial lines, TCP, UDP and files. What the bytes mean is the core's affair.
//!
//! **Invariant:** a port that goes away comes back by itself (FB8, FB9), and one that does not take its
//! output holds the newest sentence of each kind, never a backlog (FB11).

mod contacts;
mod gpio;
pub(crate) mod list;
mod open;
mod playback;
pub(crate) mod scan;
mod stood;
mod task;
mod wire;

use crate::bus::{Inlet, Link};
use crate::clock::Tempo;
use crate::config::{At, Config, Contact, Port};
use crate::error::Error;
use crate::realtime;
use std::path::PathBuf;
use tokio::runtime::{Builder, Handle};
use tokio_util::sync::CancellationToken;
use tokio_util::task::TaskTracker;

/// The thread that all ports are worked by: pages and whatever else the machine does never keep a line waiting (FC9).
#[derive(Debug)]
pub(crate) struct PortThread {
    handle: Handle,
}

impl PortThread {
    /// Begins; it ends with `stop`, and what it works at with it.
    ///
    /// # Errors
    /// The system gives no thread.
    pub(crate) fn begin(stop: CancellationToken) -> std::io::Result<Self> {
        let runtime = Builder::new_current_thread().enable_all().build()?;
        let handle = runtime.handle().clone();
        std::thread::Builder::new()
            .name("ports".to_owned())
            .spawn(move || {
                realtime::ask(realtime::PORTS);
                runtime.block_on(stop.cancelled());
            })?;
        Ok(Self { handle })
    }
}

/// Ports that are open, or whose device is not there yet; nothing runs on them before [`Ready::start`].
#[derive(Debug)]
pub(crate) struct Ready {
    opened: Vec<(Port, Option<open::Opened>)>,
    tempo: Tempo,
    contacts: Vec<Contact>,
}

impl Ready {
    /// Opens what is there.
    ///
    /// # Errors
    /// A device or an address is taken by another program; one that is absent is no error.
    pub(crate) async fn open(
        config: Config,
        tempo: Tempo,
        thread: &PortThread,
    ) -> Result<Self, Error> {
        // Where a port is opened, it is worked.
        let opening = thread.handle.spawn(Self::open_here(config, tempo));
        let ended = |error| Error::Other(format!("cannot open the ports: {error}"));
        opening.await.map_err(ended)?
    }

    async fn open_here(config: Config, tempo: Tempo) -> Result<Self, Error> {
        let mut opened = Vec::with_capacity(config.ports.len());
        for port in &config.ports {
            let found = match open::open(&port.place, tempo).await {
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
            tempo,
            contacts: config.contacts,
        })
    }

    /// Runs the ports, as tasks of the server, until it ends.
    pub(crate) fn start(
        self,
        links: &[Link],
        inlet: &Inlet,
        tasks: &TaskTracker,
        stop: &CancellationToken,
        thread: &PortThread,
    ) {
        let at = |place: &At| {
            let here = self.contacts.iter().filter(|contact| contact.at == *place);
            here.cloned().collect::<Vec<_>>()
        };
        for (index, ((port, opened), link)) in self.opened.into_iter().zip(links).enumerate() {
            let contacts = contacts::Contacts::new(at(&At::Port(index)));
            let end = task::End {
                port,
                contacts,
                link: link.clone(),
                inlet: inlet.clone(),
                tempo: self.tempo,
            };
            let running = task::run(end, opened);
            tasks.spawn_on(
                stop.clone().run_until_cancelled_owned(running),
                &thread.handle,
            );
        }
        let mut devices: Vec<PathBuf> = Vec::new();
        for contact in &self.contacts {
            let inlet = inlet.clone();
            match &contact.at {
                At::Device(path) if !devices.contains(path) => {
                    devices.push(path.clone());
                    let watching = contacts::watch(path.clone(), at(&contact.at), inlet);
                    let watching = stop.clone().run_until_cancelled_owned(watching);
                    tasks.spawn_on(watching, &thread.handle);
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
