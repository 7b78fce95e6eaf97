//! Ports: bytes in and out of serial lines, TCP, UDP and files. What the bytes mean is the core's affair.
//!
//! **Invariant:** a port that goes away comes back by itself (FB8, FB9), and one that does not take its
//! output holds the newest sentence of each kind, never a backlog (FB11).

pub(crate) mod list;
mod open;
mod playback;
mod task;
mod wire;

use crate::bus::{Inlet, Link};
use crate::config::{Config, Port};
use crate::error::Error;
use tokio_util::sync::CancellationToken;
use tokio_util::task::TaskTracker;

/// Ports that are open, or whose device is not there yet; nothing runs on them before [`Ready::start`].
#[derive(Debug)]
pub(crate) struct Ready {
    opened: Vec<(Port, Option<open::Opened>)>,
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
        Ok(Self { opened })
    }

    /// Runs the ports, as tasks of the server, until it ends.
    pub(crate) fn start(
        self,
        links: &[Link],
        inlet: &Inlet,
        tasks: &TaskTracker,
        stop: &CancellationToken,
    ) {
        for ((port, opened), link) in self.opened.into_iter().zip(links) {
            let running = task::run(port, opened, link.clone(), inlet.clone());
            tasks.spawn(stop.clone().run_until_cancelled_owned(running));
        }
    }
}
