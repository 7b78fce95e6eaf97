//! What the page knows: signals for the heard, the own and the link, fed by [`crate::link`], read by every component.

use crate::clock::{Clock, Wakefulness};
use crate::heard::{Agreement, Fold};
use crate::readings::{LINK_LOST_MS, Readings};
use crate::steady::{steady, wall_clock};
use leptos::prelude::*;
use std::time::Duration;
use wheelover_core::view::{Answer, Hello, Lines, Outline, PortView, RouteDocument, Snapshot};

/// What came is drawn at once, but no two pictures closer than this, milliseconds.
const DRAW: f64 = 45.0;

/// Ages are drawn anew after this although nothing comes, milliseconds.
const AGES: f64 = 250.0;

/// A page that did not run for so long has slept: what waited for it is old, milliseconds (FC6).
const ASLEEP: f64 = 2_000.0;

/// So long a refusal is shown.
const REFUSAL: Duration = Duration::from_secs(20);

/// The button whose command is never refused quietly.
pub(crate) const STANDBY: &str = "standby";

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
    /// Milliseconds since the last frame that was believed; none before the first.
    pub(crate) age: Option<u64>,
    /// Believed frames so far: drives the heart-beat.
    pub(crate) frames: u64,
}

impl LinkAge {
    /// Whether there is no link: nothing on the page may look alive.
    #[must_use]
    pub(crate) fn lost(self) -> bool {
        self.age.is_none_or(|age| age > LINK_LOST_MS)
    }
}

/// A command that waits for its answer.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Asked {
    /// Its number.
    pub(crate) id: u64,
    /// Which button asked.
    pub(crate) button: String,
    /// When it was sent, steady milliseconds.
    pub(crate) at: f64,
}

/// The page's signals. A copy is a handle.
#[derive(Clone, Copy)]
pub(crate) struct Deck {
    /// Everything shown.
    pub(crate) readings: RwSignal<Readings>,
    /// The autopilot's own facts; none without a link.
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
    wakefulness: StoredValue<Wakefulness>,
    /// The last snapshot of this connection, and whether it waits to be drawn.
    latest: StoredValue<(Option<Snapshot>, bool)>,
    frames: StoredValue<u64>,
    /// Something came that is not drawn yet.
    waiting: StoredValue<bool>,
    /// When the last picture was made, steady milliseconds.
    drawn: StoredValue<f64>,
    /// The page is about to stand still: until it is looked at again it shows nothing as alive.
    leaving: StoredValue<bool>,
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
            wakefulness: StoredValue::new(Wakefulness::default()),
            latest: StoredValue::new((None, false)),
            frames: StoredValue::new(0),
            waiting: StoredValue::new(false),
            drawn: StoredValue::new(0.0),
            leaving: StoredValue::new(false),
        }
    }

    /// The deck of this page.
    #[must_use]
    pub(crate) fn here() -> Self {
        expect_context()
    }

    /// Milliseconds since the last believed frame; none before the first.
    #[must_use]
    pub(crate) fn silent(&self) -> Option<u64> {
        self.clock.with_value(|clock| clock.age(steady()))
    }

    /// Reads the fold: its log, its latest lines, its track made good.
    pub(crate) fn with_fold<T>(&self, read: impl FnOnce(&Fold) -> T) -> T {
        self.fold.with_value(read)
    }

    /// A frame came that this page cannot read.
    pub(crate) fn misunderstood(&self) {
        self.misread.update(|count| *count += 1);
    }

    /// Something came: it is drawn with the next picture. Frames that are not believed make nothing alive.
    fn came(&self, believed: bool) {
        self.frames
            .update_value(|frames| *frames += u64::from(believed));
        self.waiting.set_value(true);
    }

    /// Takes a hello; gives back the number of the first line wanted.
    pub(crate) fn greet(&self, hello: Hello, came: f64) -> u64 {
        self.unanswered();
        let wanted = self
            .fold
            .try_update_value(|fold| fold.greet(&hello))
            .unwrap_or(1);
        self.clock
            .update_value(|clock| clock.greet(came, hello.at, hello.rate));
        // Own facts of another connection are of another time.
        self.latest.set_value((None, false));
        self.came(true);
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
    pub(crate) fn snapshot(&self, snapshot: Snapshot, came: f64) {
        let believed = self
            .clock
            .try_update_value(|clock| clock.snapshot(came, snapshot.at, snapshot.rate));
        self.came(believed == Some(true));
        self.fold.update_value(|fold| fold.snapshot(&snapshot));
        if believed == Some(true) {
            self.latest.set_value((Some(snapshot), true));
        }
    }

    /// Folds lines. False where some are missing.
    pub(crate) fn lines(&self, lines: &Lines, came: f64) -> bool {
        let folded = self
            .fold
            .try_update_value(|fold| (fold.lines(lines), fold.line_at));
        let Some((whole, line_at)) = folded else {
            return false;
        };
        let believed = self
            .clock
            .try_update_value(|clock| clock.line(came, line_at));
        self.came(believed == Some(true));
        self.log.update(|count| *count += 1);
        whole
    }

    /// Looks at the clocks before each picture of the browser, and four times a second: draws what came, lets ages run on,
    /// and finds out
    /// whether the page or its computer has slept.
    pub(crate) fn look(&self) -> bool {
        let now = steady();
        let absence = self
            .wakefulness
            .try_update_value(|wakefulness| wakefulness.look(now, wall_clock()))
            .unwrap_or_default();
        self.clock.update_value(|clock| clock.slept(absence.slept));
        let slept = absence.stood.max(absence.slept) > ASLEEP;
        let since = now - self.drawn.get_value();
        if slept || since >= AGES || self.waiting.get_value() && since >= DRAW {
            self.show();
        }
        slept
    }

    /// The page is about to stand still, or is looked at again: what was drawn before must not be the first that is seen.
    pub(crate) fn leave(&self, leaving: bool) {
        self.leaving.set_value(leaving);
        self.show();
    }

    /// Takes an answer.
    pub(crate) fn answered(&self, answer: Answer) {
        self.asked
            .update(|asked| asked.retain(|asked| asked.id != answer.id));
        let shown = self.answer;
        let mine = answer.clone();
        self.answer.set(Some(answer));
        // A refusal need not stand beside a mode that has long changed.
        let fade = move || {
            if shown.with_untracked(|shown| shown.as_ref() == Some(&mine)) {
                shown.set(None);
            }
        };
        set_timeout(fade, REFUSAL);
    }

    /// The connection has ended, or nothing comes on it: what was asked and not answered is not waited for.
    pub(crate) fn unanswered(&self) {
        let asked = self.asked.get_untracked();
        if asked.is_empty() {
            return;
        }
        self.asked.set(Vec::new());
        let standby = asked.iter().any(|asked| asked.button == STANDBY);
        self.refuse(if standby {
            "NO ANSWER: STANDBY may not be done, use the ship's own override"
        } else {
            "NO ANSWER: look at the mode"
        });
    }

    /// Says on the page that something was not done.
    pub(crate) fn refuse(&self, text: &str) {
        self.answered(Answer {
            id: 0,
            ok: false,
            text: text.to_owned(),
        });
    }

    /// Makes everything shown anew.
    fn show(&self) {
        let now = steady();
        self.waiting.set_value(false);
        self.drawn.set_value(now);
        let clock = self.clock.get_value();
        let mut age = clock.age(now);
        if self.leaving.get_value() {
            age = age.map(|age| age.max(LINK_LOST_MS + 1));
        }
        let link = LinkAge {
            age,
            frames: self.frames.get_value(),
        };
        let stamp = clock.stamp(now);
        let readings = self.latest.with_value(|(own, _)| {
            self.with_fold(|fold| {
                Readings::of(&fold.picture, own.as_ref(), stamp, age.unwrap_or(u64::MAX))
            })
        });
        let readings = self.calm(readings);
        self.link.set(link);
        self.show_own(link);
        self.readings.set(readings);
        let utc = self.with_fold(|fold| fold.utc).filter(|_| !link.lost());
        self.utc
            .set(utc.map(|(seconds, at)| libm::floor(seconds + stamp.since(at) as f64 / 1000.0)));
        let agreement = self.with_fold(|fold| fold.agreement);
        if agreement != self.agreement.get_untracked() {
            self.agreement.set(agreement);
        }
    }

    /// Own facts live and die with the link, all together.
    fn show_own(&self, link: LinkAge) {
        if link.lost() {
            if self.own.with_untracked(Option::is_some) {
                self.own.set(None);
                // Alive again only with a snapshot that is still to come.
                self.latest.update_value(|latest| latest.1 = false);
            }
            return;
        }
        let fresh = self
            .latest
            .try_update_value(|(own, fresh)| std::mem::take(fresh).then(|| own.clone()));
        if let Some(Some(own)) = fresh {
            self.own.set(own);
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
}

impl Default for Deck {
    fn default() -> Self {
        Self::new()
    }
}
