//! The decoder: lines pasted or dropped, explained by the same core; needs no server.

use crate::format;
use crate::heard::latin1;
use crate::lookup::Dictionary;
use js_sys::Uint8Array;
use leptos::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Blob, DragEvent};

/// Lines to begin with: a turn commanded by a chart system, its answer, a position that cannot be, a short HTC.
const EXAMPLE: &str = "$EIHTC,V,,,T,R,,,0.500,,,,280.0,T,C*1B
$AGHTD,V,8.0,R,T,R,35.0,20.0,0.500,27.5,275.5,,280.0,T,A,A,,262.2*16
$EIXTE,A,A,0.020,L,N,D*2F
$PNEY,001,A,A,0.012,R,N,D*6A
$PNEY,002,5345.3450,N,01245.6350,W,001*2F
$EIGLL,5345.345,N,12365.635,E,152829.96,A,A*7E
$EIHTC,V,,,T,R,,0.50,,280.0,T,C*07";

/// So much is read before the page may do something else, bytes; of a larger file so much stands in the box.
const PART: f64 = 65_536.0;

/// What is read: the text in the box, or a file.
#[derive(Clone, Debug)]
struct Material {
    blob: Blob,
    /// Empty for the text in the box.
    name: String,
}

impl Material {
    fn text(text: &str) -> Option<Self> {
        let bytes = Uint8Array::from(latin1(text).as_slice());
        let parts = js_sys::Array::of1(&bytes);
        Some(Self {
            blob: Blob::new_with_u8_array_sequence(&parts).ok()?,
            name: String::new(),
        })
    }

    /// The part that begins there.
    async fn part(&self, from: f64) -> Option<Uint8Array> {
        let end = (from + PART).min(self.blob.size());
        let part = self.blob.slice_with_f64_and_f64(from, end).ok()?;
        let buffer = JsFuture::from(part.array_buffer()).await.ok()?;
        Some(Uint8Array::new(&buffer))
    }
}

/// The decoder's signals. A copy is a handle.
#[derive(Clone, Copy)]
struct Desk {
    dictionary: Dictionary,
    text: RwSignal<String>,
    words: RwSignal<String>,
    tables: RwSignal<String>,
    /// What is said about a file.
    file: RwSignal<String>,
    /// Number of the text that is read: what is read later ends what is read still.
    job: StoredValue<u64>,
}

impl Desk {
    /// Reads all of it, part by part: the page lives on, and shows how far it has come.
    async fn read(self, material: Material) {
        let job = self
            .job
            .try_update_value(|job| {
                *job += 1;
                *job
            })
            .unwrap_or_default();
        if self.dictionary.begin().is_none() {
            return;
        }
        let size = material.blob.size();
        let mut from = 0.0;
        while from < size {
            let part = material.part(from).await;
            if self.job.try_get_value() != Some(job) {
                return;
            }
            let Some(part) = part else {
                self.words.set("the file cannot be read".to_owned());
                return;
            };
            if from == 0.0 && !material.name.is_empty() {
                self.text
                    .set(part.to_vec().into_iter().map(char::from).collect());
            }
            self.dictionary.take(&part);
            from += PART;
            if from < size {
                let percent = format::fixed(100.0 * from / size, 0);
                let words = self.dictionary.words();
                self.words.set(format!("reading, {percent} %: {words}"));
            }
        }
        self.tables.set(self.dictionary.end());
        self.words.set(self.dictionary.words());
    }

    /// Reads the text in the box.
    fn write(self, text: String) {
        self.file.set(String::new());
        if let Some(material) = Material::text(&text) {
            spawn_local(self.read(material));
        }
        self.text.set(text);
    }

    /// Reads the first of the files that were dropped.
    fn drop_files(self, event: &DragEvent) -> Option<()> {
        let files = event.data_transfer()?.files()?;
        let file = files.get(0)?;
        if !self.dictionary.is_ready() {
            self.file
                .set("The dictionary is on its way: drop the file once more.".to_owned());
            return None;
        }
        let (name, size) = (file.name(), file.size());
        let mut said = format!(
            "{name}, {} kB, is read whole",
            format::fixed(size / 1_000.0, 0)
        );
        if size > PART {
            said += "; its beginning stands here";
        }
        if files.length() > 1 {
            said += "; of several files the first is read";
        }
        self.file.set(said);
        let blob = file.into();
        spawn_local(self.read(Material { blob, name }));
        Some(())
    }
}

/// The decoder page.
#[component]
pub(crate) fn Decoder() -> impl IntoView {
    let dictionary = Dictionary::here();
    let desk = Desk {
        dictionary,
        text: RwSignal::new(EXAMPLE.to_owned()),
        words: RwSignal::new("the dictionary is on its way".to_owned()),
        tables: RwSignal::default(),
        file: RwSignal::default(),
        job: StoredValue::new(0),
    };
    // What stands there already is read as soon as there is a dictionary.
    Effect::new(move |_| {
        if dictionary.is_ready() {
            desk.write(desk.text.get_untracked());
        }
    });
    let dropping = RwSignal::new(false);
    let drop_files = move |event: DragEvent| {
        event.prevent_default();
        dropping.set(false);
        desk.drop_files(&event);
    };
    let hold = move |event: DragEvent| {
        event.prevent_default();
        dropping.set(true);
    };
    view! {
        <main
            class="decoder"
            class:dropping=move || dropping.get()
            on:dragover=hold
            on:dragleave=move |_| dropping.set(false)
            on:drop=drop_files
        >
            <header>
                <b class="situation">"Decoder"</b>
                <span data-value="decoder-summary" data-state="valid" role="status">{move || desk.words.get()}</span>
                <span class="sources"></span>
                <button type="button" data-command="example" on:click=move |_| desk.write(EXAMPLE.to_owned())>
                    "EXAMPLE"
                </button>
                <button type="button" data-command="clear" on:click=move |_| desk.write(String::new())>
                    "CLEAR"
                </button>
            </header>
            <div class="input">
                <textarea
                    data-input="lines"
                    spellcheck="false"
                    placeholder="Paste NMEA 0183 lines here, or drop a file."
                    prop:value=move || desk.text.get()
                    on:input:target=move |event| desk.write(event.target().value())
                ></textarea>
                <p class="small" data-value="decoder-file">
                    {move || match desk.file.get() {
                        said if said.is_empty() => "Nothing leaves this page. Files can be dropped anywhere on it.".to_owned(),
                        said => said,
                    }}
                </p>
            </div>
            <div class="results" inner_html=move || desk.tables.get()></div>
        </main>
    }
}
