//! The decoder: lines pasted or dropped, explained by the same core; needs no server.

use crate::lookup::Dictionary;
use leptos::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{DragEvent, File};

/// Lines to begin with: a turn commanded by a chart system, its answer, a position that cannot be, a short HTC.
const EXAMPLE: &str = "$EIHTC,V,,,T,R,,,0.500,,,,280.0,T,C*1B
$AGHTD,V,8.0,R,T,R,35.0,20.0,0.500,27.5,275.5,,280.0,T,A,A,,262.2*16
$EIXTE,A,A,0.020,L,N,D*2F
$PNEY,001,A,A,0.012,R,N,D*6A
$PNEY,002,5345.3450,N,01245.6350,W,001*2F
$EIGLL,5345.345,N,12365.635,E,152829.96,A,A*7E
$EIHTC,V,,,T,R,,0.50,,280.0,T,C*07";

/// The decoder page.
#[component]
pub(crate) fn Decoder() -> impl IntoView {
    let dictionary = Dictionary::here();
    let text = RwSignal::new(EXAMPLE.to_owned());
    let dropping = RwSignal::new(false);
    let answer = Memo::new(move |_| text.with(|text| dictionary.document(text)));
    let summary = move || {
        answer.with(|answer| match answer {
            Some((words, _)) => words.clone(),
            None => "the dictionary is on its way".to_owned(),
        })
    };
    let tables = move || {
        answer.with(|answer| {
            answer
                .as_ref()
                .map_or_else(String::new, |(_, tables)| tables.clone())
        })
    };
    let drop_files = move |event: DragEvent| {
        event.prevent_default();
        dropping.set(false);
        let file = event
            .data_transfer()
            .and_then(|data| data.files())
            .and_then(|files| files.get(0));
        if let Some(file) = file {
            spawn_local(async move {
                if let Some(read) = read(file).await {
                    text.set(read);
                }
            });
        }
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
                <span data-value="decoder-summary" data-state="valid">{summary}</span>
                <span class="sources"></span>
                <button type="button" data-command="example" on:click=move |_| text.set(EXAMPLE.to_owned())>
                    "EXAMPLE"
                </button>
                <button type="button" data-command="clear" on:click=move |_| text.set(String::new())>
                    "CLEAR"
                </button>
            </header>
            <div class="input">
                <textarea
                    data-input="lines"
                    spellcheck="false"
                    placeholder="Paste NMEA 0183 lines here, or drop a file."
                    prop:value=move || text.get()
                    on:input:target=move |event| text.set(event.target().value())
                ></textarea>
                <p class="small">"Nothing leaves this page. Files can be dropped anywhere on it."</p>
            </div>
            <div class="results" inner_html=tables></div>
        </main>
    }
}

/// The first megabyte of a file, as Latin-1.
async fn read(file: File) -> Option<String> {
    let part = file.slice_with_i32_and_i32(0, 1 << 20).ok()?;
    let buffer = JsFuture::from(part.array_buffer()).await.ok()?;
    let bytes = js_sys::Uint8Array::new(&buffer).to_vec();
    Some(bytes.into_iter().map(char::from).collect())
}
