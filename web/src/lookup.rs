//! The way to the dictionary's own module: fetched once, when something is first to be explained.

use js_sys::{Function, Promise, Reflect};
use leptos::prelude::*;
use serde::Deserialize;
use std::cell::RefCell;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};

/// A line explained (`wheelover decode --json`).
#[derive(Clone, Debug, Deserialize, PartialEq)]
pub(crate) struct Explanation {
    pub(crate) raw: String,
    pub(crate) address: String,
    pub(crate) sentence: String,
    pub(crate) title: Option<String>,
    pub(crate) checksum: Sum,
    pub(crate) fields: Vec<Field>,
    pub(crate) faults: Vec<Fault>,
    pub(crate) hints: Vec<String>,
}

/// Its checksum.
#[derive(Clone, Debug, Deserialize, PartialEq)]
pub(crate) struct Sum {
    pub(crate) given: Option<String>,
    pub(crate) computed: String,
}

/// One of its fields.
#[derive(Clone, Debug, Deserialize, PartialEq)]
pub(crate) struct Field {
    pub(crate) n: usize,
    pub(crate) name: String,
    pub(crate) raw: String,
    pub(crate) value: serde_json::Value,
    pub(crate) unit: Option<String>,
    pub(crate) meaning: Option<String>,
    pub(crate) note: String,
    pub(crate) fault: Option<String>,
}

/// Something that is wrong with it.
#[derive(Clone, Debug, Deserialize, PartialEq)]
pub(crate) struct Fault {
    pub(crate) n: Option<u8>,
    pub(crate) text: String,
}

thread_local! {
    static EXPLAIN: RefCell<Option<Function>> = const { RefCell::new(None) };
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
        if !dictionary.asked.get_value() {
            dictionary.asked.set_value(true);
            spawn_local(async move {
                match fetch().await {
                    Ok(explain) => {
                        EXPLAIN.set(Some(explain));
                        dictionary.ready.set(true);
                    }
                    // The next view that needs it asks again.
                    Err(_) => dictionary.asked.set_value(false),
                }
            });
        }
        dictionary
    }

    /// Explains a line; nothing while the dictionary is under way.
    pub(crate) fn explain(self, number: u64, text: &str) -> Option<Explanation> {
        if !self.ready.get() {
            return None;
        }
        let answer = EXPLAIN.with_borrow(|explain| {
            let number = JsValue::from_f64(number as f64);
            explain
                .as_ref()?
                .call2(&JsValue::NULL, &number, &JsValue::from_str(text))
                .ok()?
                .as_string()
        })?;
        serde_json::from_str(&answer).ok()
    }
}

/// `start.js` knows where the module is; in `decoder.html` it stands inline.
async fn fetch() -> Result<Function, JsValue> {
    let name = JsValue::from_str("wheeloverDictionary");
    let load: Function = Reflect::get(&js_sys::global(), &name)?.dyn_into()?;
    let promise: Promise = load.call0(&JsValue::NULL)?.dyn_into()?;
    JsFuture::from(promise).await?.dyn_into()
}
