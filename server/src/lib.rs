//! Wheelover's server: ports, the control thread with the one clock, HTTP and WebSocket.
//!
//! Bytes from ports and commands from pages go in; sentences, lines and snapshots come out. What to
//! do with them is the core's affair: nothing here decides anything about steering.

pub mod args;
pub mod check;
pub mod clock;
pub mod config;
pub mod control;
pub mod decode;
pub mod error;
pub mod feed;
pub mod guard;
pub mod http;
pub mod page;
pub mod persist;
pub mod ports;
pub mod program;
pub mod realtime;
pub mod recorder;
pub mod simulate;
pub mod window;
pub mod ws;

pub use config::Config;
pub use error::Error;

use control::{Input, Parts};
use persist::Keeper;
use ports::{Link, Ready};
use recorder::Recorder;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::thread::JoinHandle;
use tokio::net::TcpListener;
use tokio::sync::{oneshot, watch};
use wheelover_core::time::Stamp;
use wheelover_core::view::{Order, Origin, Outline};
use wheelover_core::voyage::{Event, Voyage};

/// Seed of the embedded voyage: every start sails the same.
const SEED: u64 = 1;

/// What `serve` is asked for.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Stations and ports; none: the embedded voyage.
    pub config: Option<Config>,
    /// Where to listen; none: as configured, else 127.0.0.1:8080.
    pub listen: Option<SocketAddr>,
    /// Listen on all addresses, there for reading only.
    pub lan: bool,
    /// Pace of the embedded voyage, 1 to 60.
    pub speed: Option<f64>,
    /// Where everything is recorded.
    pub record: Option<PathBuf>,
    /// Where settings are kept over a restart.
    pub settings: Option<PathBuf>,
    /// The files of the page; none: a page that says that there is none.
    pub page: Option<page::Bundle>,
}

/// A server that runs.
#[derive(Debug)]
pub struct Running {
    /// The real address, also where port 0 was asked for.
    pub addr: SocketAddr,
    /// What the officer should know at the start.
    pub cautions: Vec<String>,
    stop: watch::Sender<bool>,
    control: control::Control,
    accepting: tokio::task::JoinHandle<()>,
    thread: JoinHandle<()>,
}

impl Running {
    /// Stops everything and waits until the last line is on disk.
    pub async fn shutdown(self) {
        self.stop.send_replace(true);
        let _ = self.accepting.await;
        while !self.control.offer(Input::Stop) {
            tokio::task::yield_now().await;
        }
        let _ = tokio::task::spawn_blocking(move || self.thread.join()).await;
    }
}

/// Starts the server on the caller's runtime; ready when this returns.
///
/// # Errors
/// The address or a port is taken, or a file cannot be written; nothing is left running.
pub async fn serve(mut options: Options) -> Result<Running, Error> {
    let mut cautions = Vec::new();
    if let (Some(config), Some(path)) = (&mut options.config, &options.settings) {
        cautions = persist::restore(path, &mut config.settings);
    }
    let (listener, addr) = listen(&options).await?;
    let ready = match &options.config {
        Some(config) => Some(Ready::open(config).await?),
        None => None,
    };
    let mut voyage = match &options.config {
        Some(config) => config.voyage(),
        None => Voyage::embedded(SEED),
    };
    if let Some(speed) = options.speed {
        set_pace(&mut voyage, speed)?;
    }
    let recorder = match &options.record {
        Some(path) => Some(Recorder::begin(path, &voyage)?),
        None => None,
    };
    let keeper = match (&options.config, options.settings) {
        (Some(_), Some(path)) => Some(Keeper::begin(path)?),
        _ => None,
    };
    let ports = options
        .config
        .as_ref()
        .map_or(&[][..], |config| &config.ports);
    let link = |(index, port): (usize, &config::Port)| Link::new(index, &port.setup.name);
    let links: Vec<Link> = ports.iter().enumerate().map(link).collect();
    let may_send = (0..ports.len())
        .map(|port| {
            options
                .config
                .as_ref()
                .is_some_and(|config| config.may_send(port))
        })
        .collect();

    let simulated = voyage.is_embedded();
    let (feed, news, told) = feed::Feed::new();
    let (control, inputs) = control::channel();
    let (grant, granted) = oneshot::channel();
    let ship = options.config.as_ref().map(|config| Outline {
        length_m: config.ship.length_m,
        beam_m: config.ship.beam_m,
    });
    let parts = Parts {
        voyage,
        ship: ship.unwrap_or_default(),
        links: links.clone(),
        may_send,
        news,
        recorder,
        keeper,
    };
    let thread = control::start(parts, inputs, grant)
        .map_err(|error| Error::Other(format!("cannot start the control thread: {error}")))?;
    if !granted.await.unwrap_or(false) {
        let text = "no real-time priority: under load the control loop may be late";
        cautions.push(text.to_owned());
    }
    let (stop, stopped) = watch::channel(false);
    tokio::spawn(feed.clone().run(told, links.clone()));
    if let Some(ready) = ready {
        ready.start(&links, &control, &stopped);
    }
    let site = Arc::new(http::Site {
        hosts: guard::Hosts::of_this_machine(),
        control: control.clone(),
        feed,
        stop: stopped.clone(),
        simulated,
        lan: options.lan,
        page: options.page.unwrap_or(page::no_bundle),
    });
    let accepting = tokio::spawn(http::accept(listener, http::router(site), stopped));
    Ok(Running {
        addr,
        cautions,
        stop,
        control,
        accepting,
        thread,
    })
}

async fn listen(options: &Options) -> Result<(TcpListener, SocketAddr), Error> {
    let configured = options.config.as_ref().map(|config| config.listen);
    let mut address = options
        .listen
        .or(configured)
        .unwrap_or_else(|| ([127, 0, 0, 1], 8080).into());
    if options.lan {
        address.set_ip(std::net::Ipv4Addr::UNSPECIFIED.into());
    }
    let refused = |source| Error::Listen { address, source };
    let listener = TcpListener::bind(address).await.map_err(refused)?;
    let addr = listener.local_addr().map_err(refused)?;
    Ok((listener, addr))
}

fn set_pace(voyage: &mut Voyage, speed: f64) -> Result<(), Error> {
    if !voyage.is_embedded() {
        let text = "--speed is for the embedded voyage; with a configuration time is as it is";
        return Err(Error::Other(text.to_owned()));
    }
    let mut out = Vec::new();
    let action = Order::Speed(speed);
    voyage.handle(
        Stamp(0),
        Event::Order {
            id: 0,
            by: Origin::Officer,
            order: action,
        },
        &mut out,
    );
    Ok(())
}
