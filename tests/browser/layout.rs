//! The bridge in many sizes, fonts and states: nothing is cut, covered or moved, STANDBY is on the screen, and a finger that
//! taps again where it tapped gives no order (AP-25, DSP-5).

use serde_json::{Value, json};
use std::time::Duration;
use wheelover_core::alerts::{Alert, Category, Priority, State};
use wheelover_core::facts::Quantity;
use wheelover_core::station::Direction;
use wheelover_core::view::{
    AlertView, Down, Hello, Line, Lines, ModeName, ModeRequest, Pending, PortsDocument,
    RefusedView, RouteDocument, Snapshot,
};
use wheelover_tests::browser::Browser;
use wheelover_tests::page::Page;
use wheelover_tests::program::Program;

/// Screens by width and height: a desk, tablets lying and upright, telephones upright and on their side.
const SIZES: [(u32, u32); 11] = [
    (1920, 1080),
    (1280, 800),
    (1280, 720),
    (1200, 800),
    (1024, 768),
    (960, 600),
    (800, 1280),
    (600, 960),
    (390, 844),
    (360, 640),
    (844, 390),
];

/// The fonts of Android, of many Linux tablets, and the widest that is common.
const FONTS: [&str; 3] = ["Roboto", "Noto Sans", "DejaVu Sans"];

const REASON: &str = "not in the middle of a turn: the leg before it is unknown; wait until the turn is finished, then select AutoNAV";

/// What the page is shown: frames of a real voyage, changed by the states.
#[derive(Clone)]
pub(crate) struct Frames {
    pub(crate) hello: Hello,
    route: RouteDocument,
    ports: PortsDocument,
    /// The line that tells the time of day.
    lines: Lines,
    pub(crate) snapshot: Snapshot,
}

impl Frames {
    /// From a voyage that is in a turn.
    pub(crate) async fn sail(program: &Program) -> Self {
        let mut page = Page::open(program.address).await;
        page.until("a turn", Duration::from_secs(120), |page| {
            let situation = page.snapshot.as_ref().and_then(|s| s.chart.as_ref());
            situation.is_some_and(|chart| chart.situation == 4)
        })
        .await;
        let mut page = Page::open(program.address).await;
        let timed = |line: &&Line| line.dir == Direction::In && line.text.contains("GLL,");
        page.until("all documents", Duration::from_secs(20), |page| {
            let said = page.snapshot.is_some() && page.route.is_some() && page.ports.is_some();
            said && page.lines.iter().any(|line| timed(&line))
        })
        .await;
        let mut hello = page.hello.clone();
        let mut snapshot = page.snapshot.clone().unwrap();
        // The clock stands: what is fresh stays fresh, and what is old stays as old as it is.
        (hello.rate, snapshot.rate) = (0.0, 0.0);
        (snapshot.at, snapshot.line) = (hello.at, hello.line);
        snapshot.digest = hello.picture.digest();
        snapshot.alerts.clear();
        hello.may_command = true;
        let mut line = page.lines.iter().rfind(timed).unwrap().clone();
        line.seq = hello.line;
        let lines = Lines {
            from: line.seq,
            lines: vec![line],
        };
        Self {
            lines,
            hello,
            route: page.route.clone().unwrap(),
            ports: page.ports.clone().unwrap(),
            snapshot,
        }
    }

    pub(crate) fn mode(mut self, mode: ModeName, why: &str) -> Self {
        if let Some(own) = &mut self.snapshot.own {
            (own.mode, own.why) = (mode, why.to_owned());
            own.set_heading = (mode == ModeName::Auto).then_some(289.5);
            own.pending = None;
            own.closed.clear();
        }
        self
    }

    fn alert(mut self, alert: Alert, state: State, text: &str) -> Self {
        let definition = alert.definition();
        self.snapshot.alerts.push(AlertView {
            number: alert.number(),
            priority: definition.priority,
            state,
            category: definition.category,
            title: definition.title.to_owned(),
            text: text.to_owned(),
            at: self.hello.at,
        });
        self
    }

    fn pending(mut self) -> Self {
        let until = self.hello.at + 19_500;
        if let Some(own) = &mut self.snapshot.own {
            own.pending = Some(Pending {
                request: ModeName::AutonavTi,
                until,
                waits_for: "waits for three commands in a row".to_owned(),
            });
        }
        self
    }

    /// AP-6: neither AUTO nor AutoNAV can be selected, with the longest reasons.
    fn closed(mut self) -> Self {
        if let Some(own) = &mut self.snapshot.own {
            own.closed = vec![
                (ModeRequest::Auto, "override is in use".to_owned()),
                (ModeRequest::Autonav, REASON[..57].to_owned()),
            ];
        }
        self
    }

    /// No compass and no receiver is believed.
    pub(crate) fn refused(mut self) -> Self {
        if let Some(own) = &mut self.snapshot.own {
            let refused = |quantity, source: &str, why: &str| RefusedView {
                quantity,
                source: source.to_owned(),
                why: why.to_owned(),
            };
            own.refused = vec![
                refused(Quantity::Heading, "gyro1/HE/HDT", "jumped"),
                refused(Quantity::Position, "gps/GP/GLL", "jumped"),
                refused(Quantity::Position, "ecdis/EI/GLL", "jumped"),
                refused(Quantity::Control, "ecdis/P/PNEY,001", "does not fit"),
            ];
            (own.heading, own.position) = (None, None);
        }
        self
    }

    /// Everything that was heard is so old.
    fn aged(mut self, seconds: u64) -> Self {
        self.hello.at += seconds * 1000;
        self.snapshot.at = self.hello.at;
        self
    }

    /// The state as the stage plays it.
    pub(crate) fn state(self, name: &str) -> Value {
        json!({
            "name": name,
            "hello": Down::Hello(self.hello),
            "route": Down::Route(self.route),
            "ports": Down::Ports(self.ports),
            "lines": Down::Lines(self.lines),
            "snapshot": Down::Snapshot(self.snapshot),
        })
    }
}

/// The longest text and title that the alert table holds.
fn longest() -> (&'static str, &'static str) {
    let of = |pick: fn(&Alert) -> &'static str| {
        let longest = Alert::ALL.iter().map(pick).max_by_key(|text| text.len());
        longest.unwrap()
    };
    (of(|a| a.definition().title), of(|a| a.definition().text))
}

fn states(turn: &Frames) -> Vec<Value> {
    let auto = turn.clone().mode(ModeName::Auto, "operator selected AUTO");
    let (title, text) = longest();
    let mut long = auto.clone();
    long.snapshot.alerts.push(AlertView {
        number: 206,
        priority: Priority::Alarm,
        state: State::Unacknowledged,
        category: Category::B,
        title: title.to_owned(),
        text: format!("{text}; {}", &REASON[..40]),
        at: turn.hello.at,
    });
    let with = |mut state: Value, key: &str, value: Value| {
        state[key] = value;
        state
    };
    let mut states = vec![
        auto.clone().state("calm"),
        turn.clone().state("turning"),
        long.state("a long alarm"),
        auto.clone()
            .alert(
                Alert::Rudder,
                State::Unacknowledged,
                "the rudder does not follow its order",
            )
            .alert(Alert::OffHeading, State::Silenced, "off the set heading")
            .alert(
                Alert::TrackFail,
                State::RectifiedUnacknowledged,
                "HTC missing",
            )
            .alert(
                Alert::CrossTrack,
                State::Acknowledged,
                "outside of the limits",
            )
            .alert(Alert::SpeedLost, State::Acknowledged, "no measured speed")
            .state("several alerts"),
        auto.clone().pending().state("a pending selection"),
        auto.clone()
            .mode(ModeName::Auto, "HTC missing")
            .alert(
                Alert::TrackFail,
                State::Unacknowledged,
                "HTC missing: AUTO steers, SWITCH TO AUTO",
            )
            .state("TRACK FAIL"),
        turn.clone()
            .mode(ModeName::RudderHold, "no heading for 2 s: rudder held")
            .alert(
                Alert::HeadingLost,
                State::Unacknowledged,
                Alert::HeadingLost.definition().text,
            )
            .alert(
                Alert::TrackFail,
                State::Acknowledged,
                "HTC missing: rudder held, steer by hand",
            )
            .closed()
            .state("RUDDER HOLD"),
        turn.clone()
            .mode(ModeName::Standby, "operator selected STANDBY")
            .closed()
            .state("closed modes"),
        turn.clone().refused().state("nothing believed"),
        turn.clone().aged(4).state("late"),
        turn.clone()
            .aged(77)
            .mode(ModeName::Standby, REASON)
            .state("lost"),
    ];
    for button in ["auto", "autonav", "adjust+10"] {
        let state = auto.clone().state(&format!("{button} armed"));
        states.push(with(state, "press", json!([button])));
    }
    states.push(with(auto.state("refused"), "refused", json!(REASON)));
    states
}

/// A page whose server is the stage.
pub(crate) async fn staged(program: &Program, first: &Value) -> Browser {
    let browser = Browser::open().await;
    for source in [
        include_str!("stage/stage.js"),
        include_str!("stage/eyes.js"),
    ] {
        browser.protocol(
            "Page.addScriptToEvaluateOnNewDocument",
            &json!({ "source": source }),
        );
    }
    let play = format!("stage.play = {first};");
    browser.protocol(
        "Page.addScriptToEvaluateOnNewDocument",
        &json!({ "source": play }),
    );
    browser.go(&format!("http://{}/", program.address)).await;
    let live =
        "return document.querySelector('[data-value=\"heading\"]')?.dataset.state === 'valid';";
    browser
        .until("a live heading", Duration::from_secs(60), live)
        .await;
    browser
}

fn resize(browser: &Browser, (width, height): (u32, u32)) {
    let size = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
    browser.protocol("Emulation.setDeviceMetricsOverride", &size);
}

/// Runs a script of the stage that gives back what it found wrong.
async fn found(browser: &Browser, script: &str, arguments: Vec<Value>) -> Vec<String> {
    let script = format!(
        "const done = arguments[arguments.length - 1]; ({script})(...arguments).then(done, (e) => done(['' + e + e.stack]));"
    );
    let found = browser
        .client
        .execute_async(&script, arguments)
        .await
        .unwrap();
    serde_json::from_value(found).unwrap()
}

/// Nothing is found wrong by a script of the stage at any size.
async fn sound_at_each_size(browser: &Browser, what: &str, script: &str, arguments: &[Value]) {
    let mut faults = Vec::new();
    for (width, height) in SIZES {
        resize(browser, (width, height));
        let wrong = found(browser, script, arguments.to_vec()).await;
        let named = wrong
            .iter()
            .map(|fault| format!("{width}x{height} {what}{fault}"));
        faults.extend(named);
    }
    let count = faults.len();
    assert!(faults.is_empty(), "{count} faults:\n{}", faults.join("\n"));
}

#[tokio::test]
async fn nothing_is_cut_covered_or_moved_in_any_size_font_and_state() {
    let program = Program::start(&["--speed", "60"]);
    let turn = Frames::sail(&program).await;
    let states = states(&turn);
    let browser = staged(&program, &states[1]).await;
    let fonts = json!(FONTS);
    let look = [json!(states), fonts.clone()];
    sound_at_each_size(&browser, "", "eyes.look", &look).await;
    // AP-25: two and three taps at one point of every button are no order.
    let tap = [states[3].clone(), fonts.clone()];
    sound_at_each_size(&browser, "", "eyes.tap", &tap).await;

    // Without a link the same holds.
    browser.run("stage.silence();").await;
    let banner = "return !document.querySelector('.veil').classList.contains('hidden');";
    browser
        .until("NO LINK", Duration::from_secs(10), banner)
        .await;
    let blind = "async (fonts) => fonts.flatMap((font) => { eyes.wear(font); return eyes.faults().map((f) => `${font}: ${f}`); })";
    sound_at_each_size(&browser, "no link, ", blind, &[fonts]).await;
    assert_eq!(browser.errors(), [] as [String; 0]);
    browser.close().await;
}
