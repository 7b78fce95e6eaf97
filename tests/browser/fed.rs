//! A real autopilot whose gyro says another heading each time, so that every heading shown tells when it was said.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, SystemTime, UNIX_EPOCH};
use wheelover_tests::browser::Browser;
use wheelover_tests::program::Program;
use wheelover_tests::serial::{Line, Talker};
use wheelover_tests::with_checksum;

const LONG: Duration = Duration::from_secs(60);

/// Notes after each picture that was painted what stood in it.
const SAMPLER: &str = "window.pictures = []; \
    const part = (name) => document.querySelector(`[data-value=\"${name}\"]`); \
    const look = () => { \
        const [h, l] = [part('heading'), part('link-age')]; \
        if (h && l) window.pictures.push([performance.timeOrigin + performance.now(), \
            h.innerText.trim(), h.dataset.state, l.dataset.state]); \
    }; \
    const frame = () => { setTimeout(look); requestAnimationFrame(frame); }; \
    frame();";

/// One painted picture.
#[derive(Clone, Debug)]
pub(crate) struct Picture {
    /// When it stood on the screen, milliseconds of the epoch.
    pub(crate) at: f64,
    /// State of the heading.
    pub(crate) state: String,
    /// State of the link.
    pub(crate) link: String,
    /// When the shown heading was written to the line, milliseconds of the epoch; none where none is shown.
    pub(crate) said: Option<f64>,
}

/// An autopilot, its gyro, and a page that looks at it.
pub(crate) struct Fed {
    _program: Program,
    pub(crate) browser: Browser,
    _gyro: Line,
    _talker: Talker,
    said: Arc<Mutex<Vec<f64>>>,
}

/// Milliseconds of the epoch.
pub(crate) fn epoch() -> f64 {
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    now.unwrap().as_secs_f64() * 1_000.0
}

impl Fed {
    /// Starts all of it; gives it back when the page shows a live heading. `name` is that of its folder.
    pub(crate) async fn start(name: &str) -> Self {
        let (program, gyro) = Program::beside(name, "gyro1");
        let said = Arc::new(Mutex::new(Vec::new()));
        let noted = said.clone();
        let talker = gyro.talk(move |tick| {
            let mut noted = noted.lock().unwrap_or_else(PoisonError::into_inner);
            noted.push(epoch());
            vec![with_checksum(&format!("HEHDT,{:05.1},T", heading(tick)))]
        });
        let browser = Browser::open().await;
        browser.go(&format!("http://{}/", program.address)).await;
        let live =
            "return document.querySelector('[data-value=\"heading\"]')?.dataset.state === 'valid';";
        browser.until("a live heading", LONG, live).await;
        browser.run(SAMPLER).await;
        Self {
            _program: program,
            browser,
            _gyro: gyro,
            _talker: talker,
            said,
        }
    }

    /// All pictures since the page became live.
    pub(crate) async fn pictures(&self) -> Vec<Picture> {
        let said = self
            .said
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .clone();
        let found = self.browser.run("return window.pictures;").await;
        let read = |picture: &serde_json::Value| {
            let text = |index: usize| picture[index].as_str().unwrap_or_default().to_owned();
            let tick = text(1)
                .parse::<f64>()
                .ok()
                .map(|shown| (shown * 10.0).round() as usize);
            Picture {
                at: picture[0].as_f64().unwrap_or_default(),
                state: text(2),
                link: text(3),
                said: tick.and_then(|tick| said.get(tick).copied()),
            }
        };
        found.as_array().unwrap().iter().map(read).collect()
    }
}

/// The heading of a tick: a tenth of a degree further each time, none twice in six minutes.
fn heading(tick: u64) -> f64 {
    (tick % 3_600) as f64 / 10.0
}
