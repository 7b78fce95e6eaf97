//! The way to the dictionary's own module: fetched once, as soon as the page is alive or something is to be explained.

use js_sys::{Function, Promise, Reflect};
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

    /// A line as chips; nothing while the dictionary is under way.
    pub(crate) fn chips(self, text: &str, chosen: Option<usize>) -> Option<String> {
        self.call("chips", text, chosen)
    }

    /// A line as a table.
    pub(crate) fn table(self, text: &str, chosen: Option<usize>) -> Option<String> {
        self.call("table", text, chosen)
    }

    /// What a text holds in words, and its lines as tables.
    pub(crate) fn document(self, text: &str) -> Option<(String, String)> {
        let answer = self.call("whole", text, None)?;
        let (words, tables) = answer.split_once('\n')?;
        Some((words.to_owned(), tables.to_owned()))
    }

    fn call(self, name: &str, text: &str, chosen: Option<usize>) -> Option<String> {
        if !self.ready.get() {
            return None;
        }
        MODULE.with_borrow(|module| {
            let module = module.as_ref()?;
            let function = Reflect::get(module, &JsValue::from_str(name)).ok()?;
            let chosen = chosen.map_or(-1.0, |n| n as f64);
            let function: Function = function.dyn_into().ok()?;
            let (text, chosen) = (JsValue::from_str(text), JsValue::from_f64(chosen));
            function.call2(module, &text, &chosen).ok()?.as_string()
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
