//! What the page knows: signals for the heard, the own and the link, fed by [`crate::link`], read by every component.

use crate::heard::{Agreement, Fold};
use crate::link::{self, wall};
use crate::reading::Readings;
use leptos::prelude::*;
use std::time::Duration;
use wheelover_core::time::Stamp;
use wheelover_core::view::{
    Answer, Hello, Lines, Order, Outline, PortView, RouteDocument, Snapshot,
};

/// A frame may be so late before the page lets its own clock run on, milliseconds on the wall.
const BATCH: f64 = 300.0;

/// So long a refusal is shown.
const REFUSAL: Duration = Duration::from_secs(20);

/// What a hello says besides the picture.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Greeting {
    /// Version of the program.
    pub(crate) build: String,
    /// Number of sentences in the dictionary.
    pub(crate) dictionary: u32,
    /// Names of the ports.
    pub(crate) ports: Vec<String>,
    /// Which station is shown.
    pub(crate) station: String,
    /// Own ship's outline.
    pub(crate) ship: Outline,
    /// Whether the ship is simulated.
    pub(crate) simulated: bool,
    /// Whether this page may command.
    pub(crate) may_command: bool,
}

/// How the link is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct LinkAge {
    /// Milliseconds on the wall since the last frame; none before the first.
    pub(crate) age: Option<u64>,
    /// Frames so far: drives the heart-beat.
    pub(crate) frames: u64,
}

/// A command that waits for its answer.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Asked {
    id: u64,
    /// Which button asked.
    pub(crate) button: String,
}

/// The server's clock as the page knows it.
#[derive(Clone, Copy, Debug, Default)]
struct Clock {
    heard: f64,
    server: f64,
    rate: f64,
}

impl Clock {
    fn now(&self, wall: f64) -> Stamp {
        let beyond = (wall - self.heard - BATCH).max(0.0);
        Stamp((self.server + beyond * self.rate) as u64)
    }
}

/// The page's signals. A copy is a handle.
#[derive(Clone, Copy)]
pub(crate) struct Deck {
    /// Everything shown, four times a second.
    pub(crate) readings: RwSignal<Readings>,
    /// The autopilot's own facts.
    pub(crate) own: RwSignal<Option<Snapshot>>,
    /// Who is at the other end.
    pub(crate) greeting: RwSignal<Option<Greeting>>,
    /// The route.
    pub(crate) route: RwSignal<RouteDocument>,
    /// State of the ports.
    pub(crate) ports: RwSignal<Vec<PortView>>,
    /// How the link is.
    pub(crate) link: RwSignal<LinkAge>,
    /// Whether the server's picture is ours.
    pub(crate) agreement: RwSignal<Agreement>,
    /// The last answer to a command.
    pub(crate) answer: RwSignal<Option<Answer>>,
    /// Commands without an answer yet.
    pub(crate) asked: RwSignal<Vec<Asked>>,
    /// The one clock of everything that flashes, 1 Hz.
    pub(crate) flash: RwSignal<bool>,
    /// Seconds of the day.
    pub(crate) utc: RwSignal<Option<f64>>,
    /// Frames that this page could not read: another version of the program.
    pub(crate) misread: RwSignal<u64>,
    /// Changes whenever lines came; the log itself is read by [`Deck::with_fold`].
    pub(crate) log: RwSignal<u64>,
    fold: StoredValue<Fold>,
    clock: StoredValue<Clock>,
    frames: StoredValue<u64>,
}

impl Deck {
    /// An empty deck.
    #[must_use]
    pub(crate) fn new() -> Self {
        Self {
            readings: RwSignal::default(),
            own: RwSignal::new(None),
            greeting: RwSignal::new(None),
            route: RwSignal::default(),
            ports: RwSignal::default(),
            link: RwSignal::default(),
            agreement: RwSignal::default(),
            answer: RwSignal::new(None),
            asked: RwSignal::default(),
            flash: RwSignal::new(true),
            utc: RwSignal::new(None),
            misread: RwSignal::new(0),
            log: RwSignal::new(0),
            fold: StoredValue::new(Fold::default()),
            clock: StoredValue::new(Clock::default()),
            frames: StoredValue::new(0),
        }
    }

    /// The deck of this page.
    #[must_use]
    pub(crate) fn here() -> Self {
        expect_context()
    }

    /// When the last frame came, on the wall's clock.
    #[must_use]
    pub(crate) fn heard_at(&self) -> f64 {
        self.clock.with_value(|clock| clock.heard)
    }

    /// Reads the fold: its log, its latest lines, its track made good.
    pub(crate) fn with_fold<T>(&self, read: impl FnOnce(&Fold) -> T) -> T {
        self.fold.with_value(read)
    }

    /// A frame came.
    pub(crate) fn alive(&self) {
        self.clock.update_value(|clock| clock.heard = wall());
        self.frames.update_value(|frames| *frames += 1);
    }

    /// A frame came that this page cannot read.
    pub(crate) fn misunderstood(&self) {
        self.misread.update(|count| *count += 1);
    }

    /// Takes a hello; gives back the number of the first line wanted.
    pub(crate) fn greet(&self, hello: Hello) -> u64 {
        let wanted = self
            .fold
            .try_update_value(|fold| fold.greet(&hello))
            .unwrap_or(1);
        self.clock.update_value(|clock| {
            clock.server = hello.at as f64;
            clock.rate = hello.rate;
        });
        self.asked.set(Vec::new());
        self.greeting.set(Some(Greeting {
            build: hello.build,
            dictionary: hello.dictionary,
            ports: hello.ports.into_iter().map(|port| port.name).collect(),
            station: hello.station,
            ship: hello.ship,
            simulated: hello.simulated,
            may_command: hello.may_command,
        }));
        // The picture is live: it is shown before any line comes.
        self.show();
        wanted
    }

    /// Takes a snapshot.
    pub(crate) fn snapshot(&self, snapshot: Snapshot) {
        self.clock.update_value(|clock| {
            clock.rate = snapshot.rate;
            // Lines of the same moment may still be under way.
            let behind = snapshot.at as f64 - BATCH * snapshot.rate;
            clock.server = clock.server.max(behind);
        });
        let agreement = self.fold.try_update_value(|fold| {
            fold.snapshot(&snapshot);
            fold.agreement
        });
        if let Some(agreement) = agreement
            && agreement != self.agreement.get_untracked()
        {
            self.agreement.set(agreement);
        }
        let fast = snapshot.rate > 2.5;
        let first = self.own.with_untracked(Option::is_none);
        self.own.set(Some(snapshot));
        if fast || first {
            self.show();
        }
    }

    /// Folds lines. False where some are missing.
    pub(crate) fn lines(&self, lines: &Lines) -> bool {
        let folded = self
            .fold
            .try_update_value(|fold| (fold.lines(lines), fold.line_at, fold.utc));
        let Some((whole, line_at, utc)) = folded else {
            return false;
        };
        self.clock
            .update_value(|clock| clock.server = clock.server.max(line_at.0 as f64));
        if let Some((seconds, at)) = utc {
            let now = self.clock.with_value(|clock| clock.now(wall()));
            self.utc
                .set(Some(libm::floor(seconds + now.since(at) as f64 / 1000.0)));
        }
        self.log.update(|count| *count += 1);
        whole
    }

    /// Makes the readings anew: ages run on although nothing comes.
    pub(crate) fn show(&self) {
        let clock = self.clock.get_value();
        let wall = wall();
        let frames = self.frames.get_value();
        let age = (frames > 0).then_some((wall - clock.heard).max(0.0) as u64);
        let link = LinkAge { age, frames };
        let now = clock.now(wall);
        let readings = self.own.with_untracked(|own| {
            self.with_fold(|fold| {
                Readings::of(&fold.picture, own.as_ref(), now, age.unwrap_or(u64::MAX))
            })
        });
        let readings = self.calm(readings);
        self.link.set(link);
        self.readings.set(readings);
        if age.is_none_or(|age| age > crate::reading::LINK_LOST_MS) {
            self.utc.set(None);
        }
        let agreement = self.with_fold(|fold| fold.agreement);
        if agreement != self.agreement.get_untracked() {
            self.agreement.set(agreement);
        }
    }

    /// Smooths the shown rate of turn over two seconds: a gyro's noise must not dance in the digits.
    fn calm(&self, mut readings: Readings) -> Readings {
        let before = self
            .readings
            .with_untracked(|before| (before.now, before.rot.value));
        if let (Some(raw), (then, Some(old))) = (readings.rot.value, before) {
            let passed = readings.now.since(then) as f64 / 2_000.0;
            readings.rot.value = Some(old + (raw - old) * (1.0 - libm::exp(-passed)));
        }
        readings
    }

    /// Sends a command for a button.
    pub(crate) fn command(&self, button: &str, action: Order) {
        match link::command(action) {
            Some(id) => {
                self.asked.update(|asked| {
                    asked.push(Asked {
                        id,
                        button: button.to_owned(),
                    })
                });
            }
            None => self.answer.set(Some(Answer {
                id: 0,
                ok: false,
                text: "no link: nothing was sent".to_owned(),
            })),
        }
    }

    /// Takes an answer.
    pub(crate) fn answered(&self, answer: Answer) {
        self.asked
            .update(|asked| asked.retain(|asked| asked.id != answer.id));
        let (id, shown) = (answer.id, self.answer);
        self.answer.set(Some(answer));
        // A refusal need not stand beside a mode that has long changed.
        let fade = move || {
            if shown.with_untracked(|shown| shown.as_ref().is_some_and(|shown| shown.id == id)) {
                shown.set(None);
            }
        };
        set_timeout(fade, REFUSAL);
    }
}

impl Default for Deck {
    fn default() -> Self {
        Self::new()
    }
}
