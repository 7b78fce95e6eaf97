//! The server as a whole: what runs, how it begins, and how it ends.

use crate::bus::{Asked, Inlet, Link};
use crate::clock::Tempo;
use crate::config::{Config, Rules};
use crate::control::{self, End, Parts};
use crate::dialogue::Dialogue;
use crate::error::Error;
use crate::feed::Feed;
use crate::guard::Hosts;
use crate::http::{self, Site};
use crate::lines::Lines;
use crate::page::Bundle;
use crate::persist::{Keeper, Store};
use crate::ports::{PortThread, Ready};
use crate::recorder::Recorder;
use std::any::Any;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpListener;
use tokio::sync::oneshot;
use tokio::task::JoinHandle;
use tokio_util::sync::CancellationToken;
use tokio_util::task::TaskTracker;
use wheelover_core::time::Stamp;
use wheelover_core::view::{Order, Origin, Outline};
use wheelover_core::voyage::{Event, Voyage, VoyageConfig};

/// Seed of the embedded voyage: every start sails the same.
const SEED: u64 = 1;
/// Everything has to end within this time, the disk included.
const PATIENCE: Duration = Duration::from_secs(8);

/// What `serve` is asked for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Options {
    /// Stations and ports; none: the embedded voyage.
    pub(crate) config: Option<Config>,
    /// Where to listen; none: as configured, else 127.0.0.1:8080.
    pub(crate) listen: Option<SocketAddr>,
    /// Listen on all addresses, there for reading only.
    pub(crate) lan: bool,
    /// Pace of ship's time, 1 to 60; with a configuration only where no port can lead to real equipment.
    pub(crate) speed: Option<f64>,
    /// Where everything is recorded.
    pub(crate) record: Option<PathBuf>,
    /// Where settings are kept over a restart.
    pub(crate) settings: Option<PathBuf>,
    /// The files of the page; none: a page that says that there is none.
    pub(crate) page: Bundle,
}

/// A server that runs.
#[derive(Debug)]
pub(crate) struct Running {
    /// The real address, also where port 0 was asked for.
    pub(crate) addr: SocketAddr,
    /// What the officer should know at the start.
    pub(crate) cautions: Vec<String>,
    stop: CancellationToken,
    tasks: TaskTracker,
    inlet: Inlet,
    control: JoinHandle<Result<(), String>>,
}

impl Running {
    /// Returns when the control thread has ended although nobody asked it to; says why.
    ///
    /// Nothing steers from then on: the program has to end, and to be started again in STANDBY.
    pub(crate) async fn failed(&mut self) -> String {
        match (&mut self.control).await {
            Ok(Ok(())) => "it ended".to_owned(),
            Ok(Err(why)) => why,
            Err(error) => error.to_string(),
        }
    }

    /// Stops everything and waits until the last line and the last setting are on the disk.
    ///
    /// # Errors
    /// What had not ended after eight seconds.
    pub(crate) async fn shutdown(self) -> Result<(), String> {
        self.stop.cancel();
        self.tasks.close();
        // Where it has ended already, there is nobody to be asked.
        let _ = self.inlet.ask(Asked::Stop);
        let everything = async {
            if !self.control.is_finished() {
                let _ = self.control.await;
            }
            self.tasks.wait().await;
        };
        let done = tokio::time::timeout(PATIENCE, everything).await;
        done.map_err(|_| format!("it does not end within {} s", PATIENCE.as_secs()))
    }
}

/// Starts the server on the caller's runtime; ready when this returns.
///
/// # Errors
/// The address or a port is taken, or a file cannot be written; nothing is left running.
pub(crate) async fn serve(mut options: Options) -> Result<Running, Error> {
    let mut cautions = Vec::new();
    let mut keeper = None;
    if let (Some(config), Some(path)) = (&mut options.config, options.settings.take()) {
        let (store, said) = Store::open(path)?;
        cautions.extend(said);
        cautions.extend(store.restore(|key, value| config.set(key, value)));
        cautions.extend(config.two_ships());
        keeper = Some(Keeper::begin(store)?);
    }
    let config = options.config.as_ref();
    let tempo = tempo(config, options.speed)?;
    let (listener, addr) = listen(&options).await?;
    let (stop, tasks) = (CancellationToken::new(), TaskTracker::new());
    // Nothing is left of the ports where the server does not begin.
    let unless_begun = stop.clone().drop_guard();
    let ready = match config {
        Some(config) => {
            let thread = PortThread::begin(stop.clone())
                .map_err(|error| Error::Other(format!("cannot start the ports: {error}")))?;
            let ready = Ready::open(config.clone(), tempo, &thread).await?;
            Some((ready, thread))
        }
        None => None,
    };
    let made = config.map_or_else(|| VoyageConfig::embedded(SEED), Config::voyage);
    let mut recorder = match &options.record {
        Some(path) => Some(Recorder::begin(path, &made)?),
        None => None,
    };
    let mut voyage = Voyage::configured(made);
    match options.speed {
        Some(speed) if voyage.is_embedded() => set_pace(&mut voyage, speed, recorder.as_mut()),
        _ => voyage.run_at(tempo.rate()),
    }
    if tempo.is_trial() {
        let rate = tempo.rate();
        cautions.push(format!(
            "a trial: ship's time runs {rate} times as fast as the clock"
        ));
    }
    let links = config.map_or_else(Vec::new, links);
    let simulated = voyage.is_embedded();
    let dialogue = Dialogue::on(&voyage.picture().ports);
    let (feed, news, told) = Feed::new(dialogue);
    let (inlet, queues) = Inlet::new();
    let (grant, granted) = oneshot::channel();
    let parts = Parts {
        voyage,
        ship: config.map_or_else(Outline::default, |config| Outline {
            length_m: config.ship.length(),
            beam_m: config.ship.beam_m,
        }),
        rules: config.map_or_else(Rules::default, Config::rules),
        links: links.clone(),
        news,
        recorder,
        keeper,
        lines: if tempo.is_trial() {
            Lines::begin().ok()
        } else {
            None
        },
    };
    let thread = control::start(parts, queues, grant)
        .map_err(|error| Error::Other(format!("cannot start the control thread: {error}")))?;
    let control = tokio::task::spawn_blocking(move || match thread.join() {
        Ok(End::Asked) => Ok(()),
        Ok(End::Deserted) => Err("nobody was left who could command it".to_owned()),
        Err(panic) => Err(words(panic.as_ref()).to_owned()),
    });
    if !granted.await.unwrap_or(false) {
        let text = "no real-time priority: under load the control loop may be late";
        cautions.push(text.to_owned());
    }
    tasks.spawn(feed.clone().run(told, links.clone()));
    if let Some((ready, thread)) = ready {
        ready.start(&links, &inlet, &tasks, &stop, &thread);
    }
    let site = Arc::new(Site {
        hosts: Hosts::of_this_machine(),
        inlet: inlet.clone(),
        feed,
        stop: stop.clone(),
        tasks: tasks.clone(),
        simulated,
        lan: options.lan,
        page: options.page,
    });
    tasks.spawn(http::accept(listener, site));
    unless_begun.disarm();
    Ok(Running {
        addr,
        cautions,
        stop,
        tasks,
        inlet,
        control,
    })
}

fn links(config: &Config) -> Vec<Link> {
    let ports = config.ports.iter().enumerate();
    ports
        .map(|(index, port)| Link::new(index, &port.setup.name, config.may_send(index)))
        .collect()
}

/// What a panic said.
fn words(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<&str>().copied();
    text.or_else(|| panic.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("a panic without words")
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

/// At which pace the ports work: another than the clock's only where no real equipment can be behind them.
fn tempo(config: Option<&Config>, speed: Option<f64>) -> Result<Tempo, Error> {
    let (Some(config), Some(speed)) = (config, speed) else {
        return Ok(Tempo::REAL);
    };
    config.may_run_at(speed).map_err(Error::Other)?;
    Ok(Tempo::new(speed))
}

fn set_pace(voyage: &mut Voyage, speed: f64, recorder: Option<&mut Recorder>) {
    let mut out = Vec::new();
    let event = Event::Order {
        id: 0,
        by: Origin::Officer,
        order: Order::Speed(speed),
    };
    if let Some(recorder) = recorder {
        recorder.event(Stamp(0), &event);
        voyage.handle(Stamp(0), event, &mut out);
        out.iter()
            .for_each(|output| recorder.output(Stamp(0), output));
    } else {
        voyage.handle(Stamp(0), event, &mut out);
    }
}
