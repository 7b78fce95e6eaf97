//! The way to the dictionary's own module: fetched once, as soon as the page is alive or something is to be explained.

use js_sys::{Array, Function, Promise, Reflect, Uint8Array};
use leptos::prelude::*;
use std::cell::RefCell;
use std::time::Duration;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};

/// After a failure it is asked for again after this time at the earliest.
const AGAIN: Duration = Duration::from_secs(5);

thread_local! {
    static MODULE: RefCell<Option<JsValue>> = const { RefCell::new(None) };
}

/// Whether the dictionary is there. A copy is a handle.
#[derive(Clone, Copy)]
pub(crate) struct Dictionary {
    asked: StoredValue<bool>,
    ready: RwSignal<bool>,
}

impl Dictionary {
    /// A dictionary that is not there yet; made once, at the root of the page.
    pub(crate) fn new() -> Self {
        Self {
            asked: StoredValue::new(false),
            ready: RwSignal::new(false),
        }
    }

    /// The page's dictionary; from now on it is fetched.
    pub(crate) fn here() -> Self {
        let dictionary: Self = expect_context();
        dictionary.fetch();
        dictionary
    }

    /// Fetches the module unless it is there or under way; after a failure it may be asked for again.
    pub(crate) fn fetch(self) {
        if self.asked.get_value() {
            return;
        }
        self.asked.set_value(true);
        spawn_local(async move {
            match module().await {
                Ok(module) => {
                    MODULE.set(Some(module));
                    self.ready.set(true);
                }
                Err(_) => set_timeout(move || self.asked.set_value(false), AGAIN),
            }
        });
    }

    /// Whether the dictionary is there.
    pub(crate) fn is_ready(self) -> bool {
        self.ready.get()
    }

    /// A line as chips; nothing while the dictionary is under way.
    pub(crate) fn chips(self, text: &str, chosen: Option<usize>) -> Option<String> {
        self.line("chips", text, chosen)
    }

    /// A line as a table.
    pub(crate) fn table(self, text: &str, chosen: Option<usize>) -> Option<String> {
        self.line("table", text, chosen)
    }

    /// Checks the next lines of a running dialogue, or the first of another (CON-2); nothing while the dictionary is under way.
    pub(crate) fn follow(self, lines: &str, anew: bool) -> Option<String> {
        let lines = JsValue::from_str(lines);
        self.call("follow", &[&lines, &JsValue::from_bool(anew)])?
            .as_string()
    }

    /// Begins to read a text of many lines; nothing while the dictionary is under way.
    pub(crate) fn begin(self) -> Option<()> {
        self.call("begin", &[]).map(drop)
    }

    /// Reads its next part.
    pub(crate) fn take(self, bytes: &Uint8Array) {
        self.call("take", &[bytes]);
    }

    /// Ends it; gives what it holds as tables.
    pub(crate) fn end(self) -> String {
        self.call("end", &[]);
        self.text("tables")
    }

    /// What it holds so far, in words.
    pub(crate) fn words(self) -> String {
        self.text("words")
    }

    fn text(self, name: &str) -> String {
        self.call(name, &[])
            .and_then(|text| text.as_string())
            .unwrap_or_default()
    }

    fn line(self, name: &str, text: &str, chosen: Option<usize>) -> Option<String> {
        let chosen = JsValue::from_f64(chosen.map_or(-1.0, |n| n as f64));
        self.call(name, &[&JsValue::from_str(text), &chosen])?
            .as_string()
    }

    fn call(self, name: &str, arguments: &[&JsValue]) -> Option<JsValue> {
        if self.ready.try_get() != Some(true) {
            return None;
        }
        MODULE.with_borrow(|module| {
            let module = module.as_ref()?;
            let function = Reflect::get(module, &JsValue::from_str(name)).ok()?;
            let function: Function = function.dyn_into().ok()?;
            let list: Array = arguments.iter().copied().collect();
            function.apply(module, &list).ok()
        })
    }
}

/// `start.js` knows where the module is; in `decoder.html` it stands inline.
async fn module() -> Result<JsValue, JsValue> {
    let name = JsValue::from_str("wheeloverDictionary");
    let load: Function = Reflect::get(&js_sys::global(), &name)?.dyn_into()?;
    let promise: Promise = load.call0(&JsValue::NULL)?.dyn_into()?;
    JsFuture::from(promise).await
}
