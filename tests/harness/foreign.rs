//! A foreign ship on pseudo-terminals: a hull of first order, her sensors, her steering gear and her chart system, which
//! sails one leg, one turn and the next leg by the sentences of the manuals. None of it is the program's own.
//!
//! Everything that is said passes a tap, which a test sets; what the autopilot answers is noted as it comes over the line.

mod log;
mod speaker;

use crate::page::Page;
use crate::program::Program;
use crate::serial::Line;
pub use log::Log;
use speaker::Speaker;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};
use wheelover_core::view::{Answer, ModeRequest, Order};

/// How a foreign ship is made.
#[derive(Clone, Debug)]
pub struct Foreign {
    /// Nomoto gain, 1/s.
    pub gain: f64,
    /// Nomoto time constant, s.
    pub time_constant: f64,
    /// Speed through the water and over ground, knots.
    pub knots: f64,
    /// `[ship]` of the autopilot's configuration.
    pub ship: &'static str,
    /// Ports of the autopilot.
    pub ports: &'static [&'static str],
    /// Course of the first leg, degrees.
    pub course: f64,
    /// Change of course, degrees, positive to starboard.
    pub turn: f64,
    /// Radius, nautical miles.
    pub radius: f64,
    /// Seconds from the start to the wheel-over line.
    pub lead: f64,
    /// Seconds from the wheel-over line to the arc.
    pub forwarding: f64,
    /// Metres to starboard of the leg at the start.
    pub beside: f64,
    /// Metres by which the autopilot's own receiver is to starboard of the chart system's position.
    pub receiver: f64,
}

impl Default for Foreign {
    /// A coaster on 245 degrees, long before a turn of 40 degrees to starboard.
    fn default() -> Self {
        Self {
            gain: 0.5,
            time_constant: 31.0,
            knots: 9.7,
            ship: "length_m = 45\nspeed_kn = 9.7\ngain_per_s = 0.5\ntime_constant_s = 31\nforwarding_s = 26\n",
            ports: &["ecdis", "gyro1", "gps", "log", "gear"],
            course: 245.0,
            turn: 40.0,
            radius: 0.3,
            lead: 3_600.0,
            forwarding: 26.0,
            beside: 0.0,
            receiver: 0.0,
        }
    }
}

/// What is said on which port: a body without `$` and checksum, or what begins with `$` as it is.
pub type Said = (&'static str, String);

/// What becomes of a sentence: port and body in, what is said in its place out.
type Tap = Box<dyn FnMut(&'static str, &str) -> Vec<Said> + Send>;

/// What a test does to the ship.
struct Hands {
    tap: Tap,
    controls: bool,
    besides: Vec<Said>,
}

/// A foreign ship under way, and the autopilot that steers her.
pub struct Sailing {
    program: Program,
    log: Arc<Mutex<Log>>,
    hands: Arc<Mutex<Hands>>,
    stop: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

fn locked<T: ?Sized>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Hands {
    fn next(&mut self, speaker: &Speaker, tick: u64) -> Vec<Said> {
        let mut said = std::mem::take(&mut self.besides);
        for (port, body) in speaker.bodies(tick, self.controls) {
            said.extend((self.tap)(port, &body));
        }
        said
    }
}

/// A sentence as it is.
#[must_use]
pub fn whole(port: &'static str, body: &str) -> Vec<Said> {
    vec![(port, body.to_string())]
}

impl Foreign {
    /// Lets her sail, with an autopilot of her own in a folder.
    ///
    /// # Panics
    /// The autopilot does not start.
    #[must_use]
    #[allow(clippy::unwrap_used)]
    pub fn sail(&self, folder: &Path) -> Sailing {
        let mut text = format!(
            "roles = [\"autopilot\"]\nallow_output = true\n[ship]\n{}[autopilot]\nrudder_slew = 5.0\nexternal_tcs = true\n",
            self.ship
        );
        let mut lines = BTreeMap::new();
        for port in self.ports {
            lines.insert(*port, Line::new(&folder.join(port)));
            text += &format!(
                "[[port]]\nname = \"{port}\"\nkind = \"serial\"\npath = \"{}\"\nbaud = 38400\nprofile = \"{port}\"\noutput = {}\n",
                folder.join(port).display(),
                matches!(*port, "ecdis" | "gear")
            );
        }
        let file = folder.join("wheelover.toml");
        std::fs::write(&file, text).unwrap();
        let program = Program::start(&["--config", &file.display().to_string()]);
        let log = Arc::new(Mutex::new(Log::default()));
        let hands = Arc::new(Mutex::new(Hands {
            tap: Box::new(whole),
            controls: false,
            besides: Vec::new(),
        }));
        let stop = Arc::new(AtomicBool::new(false));
        let mut speaker = Speaker::new(self, lines);
        let (noted, done, stopped) = (log.clone(), hands.clone(), stop.clone());
        let thread = std::thread::spawn(move || {
            let begun = Instant::now();
            let mut sailed = 0.0;
            for tick in 0.. {
                let due = begun + Duration::from_millis(tick * 100);
                std::thread::sleep(due.saturating_duration_since(Instant::now()));
                if stopped.load(Ordering::Relaxed) {
                    return;
                }
                let now = begun.elapsed().as_secs_f64();
                let order = hear(&mut speaker.lines, &noted, now);
                speaker.sail(order, now - sailed);
                sailed = now;
                note(&speaker, &noted);
                for (port, said) in locked(&done).next(&speaker, tick) {
                    speaker.say(port, &said);
                }
            }
        });
        Sailing {
            program,
            log,
            hands,
            stop,
            thread: Some(thread),
        }
    }
}

/// Takes what the autopilot said; gives its last order.
fn hear(lines: &mut BTreeMap<&'static str, Line>, log: &Mutex<Log>, now: f64) -> f64 {
    locked(log).now = now;
    for port in ["ecdis", "gear"] {
        while let Some((_, line)) = lines
            .get_mut(port)
            .and_then(|line| line.hear(Duration::from_millis(1)))
        {
            // The gear's orders come each step; the same reports on the chart system's line count once.
            if port == "gear" || !line.starts_with("$AGROR") {
                locked(log).hear(&line);
            }
        }
    }
    let log = locked(log);
    log.orders.last().map_or(0.0, |(_, order)| *order)
}

fn note(speaker: &Speaker, log: &Mutex<Log>) {
    let mut log = locked(log);
    (log.situation, log.heading, log.off_path) = speaker.seen();
}

impl Sailing {
    /// Sets what becomes of what is said.
    pub fn tap(&self, tap: impl FnMut(&'static str, &str) -> Vec<Said> + Send + 'static) {
        locked(&self.hands).tap = Box::new(tap);
    }

    /// Everything is said as it is again.
    pub fn heal(&self) {
        self.tap(whole);
    }

    /// Says something beside what is said anyway.
    pub fn say(&self, port: &'static str, said: &str) {
        locked(&self.hands).besides.push((port, said.to_string()));
    }

    /// What is known now.
    pub fn log(&self) -> MutexGuard<'_, Log> {
        locked(&self.log)
    }

    /// Seconds since the start.
    #[must_use]
    pub fn now(&self) -> f64 {
        self.log().now
    }

    /// Gives an order at a page of its own.
    ///
    /// # Panics
    /// No answer comes.
    #[allow(clippy::unwrap_used)]
    pub fn order(&self, order: Order) -> Answer {
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_all()
            .build()
            .unwrap();
        runtime.block_on(async {
            let mut page = Page::open(self.program.address).await;
            let answer = page.command(order).await;
            page.leave().await;
            answer
        })
    }

    /// Lets the chart system command track control, or not.
    pub fn control(&self, on: bool) {
        locked(&self.hands).controls = on;
    }

    /// AUTO on the present heading.
    ///
    /// # Panics
    /// It is refused.
    pub fn auto(&self) {
        self.until("orders", 20.0, |log| log.now > 1.5 && log.htd(4) == "M");
        let answer = self.order(Order::Mode(ModeRequest::Auto));
        assert!(answer.ok, "{}", answer.text);
    }

    /// Brings her under track control.
    ///
    /// # Panics
    /// It is refused, or does not come.
    pub fn engage(&self) {
        self.auto();
        self.control(true);
        let asked = self.now();
        loop {
            let answer = self.order(Order::Mode(ModeRequest::Autonav));
            if answer.ok {
                break;
            }
            assert!(self.now() < asked + 20.0, "{}", answer.text);
            self.run(0.5);
        }
        self.until("track control", 20.0, |log| log.htd(4) == "T");
    }

    /// Lets her sail so many seconds.
    pub fn run(&self, seconds: f64) {
        std::thread::sleep(Duration::from_secs_f64(seconds));
    }

    /// Waits until something holds; gives the time.
    ///
    /// # Panics
    /// It does not hold within so many seconds.
    pub fn until(&self, name: &str, seconds: f64, holds: impl Fn(&Log) -> bool) -> f64 {
        let end = Instant::now() + Duration::from_secs_f64(seconds);
        loop {
            let log = self.log();
            if holds(&log) {
                return log.now;
            }
            assert!(
                Instant::now() < end,
                "{name} not within {seconds} s: at {:.1} s, situation {}, {:?}, alerts {:?}",
                log.now,
                log.situation,
                log.htd.last(),
                log.alerts.iter().filter(|(_, on)| **on).collect::<Vec<_>>()
            );
            drop(log);
            self.run(0.02);
        }
    }

    /// Watches that something holds for so many seconds.
    ///
    /// # Panics
    /// It does not.
    pub fn always(&self, name: &str, seconds: f64, holds: impl Fn(&Log) -> bool) {
        let end = Instant::now() + Duration::from_secs_f64(seconds);
        while Instant::now() < end {
            let log = self.log();
            assert!(
                holds(&log),
                "{name}: at {:.1} s, situation {}, {:?}, order {:?}, alerts {:?}",
                log.now,
                log.situation,
                log.htd.last(),
                log.orders.last(),
                log.alerts.iter().filter(|(_, on)| **on).collect::<Vec<_>>()
            );
            drop(log);
            self.run(0.02);
        }
    }
}

impl Drop for Sailing {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}
