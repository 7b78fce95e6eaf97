//! Wheelover's server: ports, the control thread with the one clock, HTTP and WebSocket.
//!
//! Bytes from ports and commands from pages go in; sentences, lines and snapshots come out. What to
//! do with them is the core's affair: nothing here decides anything about steering.

pub mod args;
pub mod check;
pub mod decode;
pub mod error;
pub mod guard;
pub mod http;
pub mod page;
pub mod simulate;

pub use error::Error;

use std::net::SocketAddr;
use std::sync::Arc;
use tokio::net::TcpListener;
use tokio::sync::watch;

/// What `serve` is asked for.
#[derive(Clone, Debug)]
pub struct Options {
    /// Where to listen.
    pub listen: SocketAddr,
}

/// A server that runs.
#[derive(Debug)]
pub struct Running {
    /// The real address, also where port 0 was asked for.
    pub addr: SocketAddr,
    stop: watch::Sender<bool>,
    task: tokio::task::JoinHandle<()>,
}

impl Running {
    /// Stops everything and waits for it.
    pub async fn shutdown(self) {
        self.stop.send_replace(true);
        let _ = self.task.await;
    }
}

/// Starts the server on the caller's runtime; ready when this returns.
///
/// # Errors
/// The address cannot be had; nothing is left running.
pub async fn serve(options: Options) -> Result<Running, Error> {
    let refused = |source| Error::Listen {
        address: options.listen,
        source,
    };
    let listener = TcpListener::bind(options.listen).await.map_err(refused)?;
    let addr = listener.local_addr().map_err(refused)?;
    let (stop, stopped) = watch::channel(false);
    let site = Arc::new(http::Site {
        hosts: guard::Hosts::of_this_machine(),
    });
    let task = tokio::spawn(http::accept(listener, http::router(site), stopped));
    Ok(Running { addr, stop, task })
}
