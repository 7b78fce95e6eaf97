//! A line explained: its fields as chips to tap, or as a table with names, values, units, meanings, faults and hints.

use leptos::prelude::*;
use wheelover_core::nmea::{JsonField, JsonLine, JsonValue, decode, json_line};

use crate::format;
use crate::heard::latin1;

/// Explains one line by the core's dictionary.
#[must_use]
pub(crate) fn explain(number: u64, text: &str) -> JsonLine {
    json_line(number, None, &decode(&latin1(text)))
}

/// A line as chips: the address and each field can be tapped.
#[component]
pub(crate) fn Chips(
    text: String,
    #[prop(into)] chosen: Signal<Option<usize>>,
    choose: Callback<usize>,
) -> impl IntoView {
    let line = explain(0, &text);
    if line.address.is_empty() {
        return view! { <span class="chip fault">{text}</span> }.into_any();
    }
    let start = if line.raw.contains('!') { '!' } else { '$' };
    let chip = move |n: usize, class: &'static str, text: String| {
        view! {
            <button
                type="button"
                class=class
                data-field=n.to_string()
                aria-pressed=move || if chosen.get() == Some(n) { "true" } else { "false" }
                on:click=move |_| choose.run(n)
            >
                {text}
            </button>
        }
    };
    let address = chip(0, "chip address", format!("{start}{}", short(&line)));
    let fields: Vec<_> = line
        .fields
        .iter()
        .map(|field| {
            let class = match (&field.fault, field.raw.is_empty()) {
                (Some(_), _) => "chip fault",
                (None, true) => "chip null",
                (None, false) => "chip",
            };
            let text = if field.raw.is_empty() {
                "·".to_owned()
            } else {
                field.raw.clone()
            };
            view! { <span>","</span>{chip(field.n, class, text)} }
        })
        .collect();
    let sum = line
        .checksum
        .given
        .clone()
        .map_or_else(|| " no checksum".to_owned(), |given| format!("*{given}"));
    view! {
        {address}
        {fields}
        <span>{sum}</span>
    }
    .into_any()
}

/// The address as it stands before the first comma.
fn short(line: &JsonLine) -> String {
    line.address
        .split(',')
        .next()
        .unwrap_or_default()
        .to_owned()
}

/// The value as a person reads it.
fn value(field: &JsonField) -> String {
    match &field.value {
        JsonValue::Null => format::NO_TEXT.to_owned(),
        JsonValue::Number(number) => format!("{number}"),
        JsonValue::Integer(number) => format!("{number}"),
        JsonValue::Text(text) => text.clone(),
    }
}

/// What its code means, and what the field is for.
fn words(field: &JsonField) -> String {
    let parts = [field.meaning.unwrap_or_default(), field.note];
    let said: Vec<_> = parts.into_iter().filter(|text| !text.is_empty()).collect();
    said.join(". ")
}

/// A line as a table: every field with name, value, unit, meaning, fault and use.
#[component]
pub(crate) fn Explained(
    line: JsonLine,
    #[prop(into)] chosen: Signal<Option<usize>>,
) -> impl IntoView {
    let faults = line.faults.clone();
    let hints = line.hints.clone();
    let title = line.title.unwrap_or("unknown sentence");
    let name = if line.sentence.is_empty() {
        "no sentence".to_owned()
    } else {
        line.sentence.clone()
    };
    let (fault_count, hint_count) = (faults.len().to_string(), hints.len().to_string());
    let key = name.clone();
    let checksum = match &line.checksum.given {
        Some(given) if *given == line.checksum.computed => format!("checksum {given}: right"),
        Some(given) => format!("checksum {given}: should be {}", line.checksum.computed),
        None => format!("no checksum: should be {}", line.checksum.computed),
    };
    let fields = line.fields.clone();
    let looked = move || {
        let n = chosen.get().filter(|n| *n > 0)?;
        let field = fields.iter().find(|field| field.n == n)?;
        let words = words(field);
        Some(view! {
            <p class="looked-at" data-explained=n.to_string()>
                <b>{n}" "{field.name.replace('_', " ")}": "{value(field)}" "{field.unit.unwrap_or_default()}</b>
                " "
                {words}
            </p>
        })
    };
    let rows: Vec<_> = line
        .fields
        .iter()
        .map(|field| {
            let n = field.n;
            let class = match (&field.fault, field.raw.is_empty()) {
                (Some(_), _) => "fault",
                (None, true) => "null",
                (None, false) => "",
            };
            let words = words(field);
            view! {
                <tr class=class class:chosen=move || chosen.get() == Some(n) data-field=n.to_string()>
                    <td class="mono">{n}</td>
                    <td>{field.name.replace('_', " ")}</td>
                    <td class="mono">{field.raw.clone()}</td>
                    <td class="mono">{value(field)}" "{field.unit.unwrap_or_default()}</td>
                    <td>
                        {words}
                        {field.fault.clone().map(|fault| view! { <b class="field-fault">" "{fault.replace('_', " ")}</b> })}
                    </td>
                </tr>
            }
        })
        .collect();
    view! {
        <article class="explained" data-sentence=key>
            <h2>{name}" · "{title}</h2>
            <p class="raw">{line.raw.clone()}</p>
            <p class="small" data-checksum=line.checksum.computed.clone()>{checksum}</p>
            {looked}
            {(!faults.is_empty())
                .then(|| {
                    view! {
                        <ul class="faults" data-faults=fault_count>
                            {faults
                                .into_iter()
                                .map(|fault| {
                                    let place = fault.n.map_or_else(String::new, |n| format!("field {n}: "));
                                    view! { <li>{place}{fault.text}</li> }
                                })
                                .collect_view()}
                        </ul>
                    }
                })}
            {(!hints.is_empty())
                .then(|| {
                    view! {
                        <ul class="hints" data-hints=hint_count>
                            {hints.into_iter().map(|hint| view! { <li>{hint}</li> }).collect_view()}
                        </ul>
                    }
                })}
            <table>
                <thead>
                    <tr>
                        <th>"#"</th>
                        <th>"name"</th>
                        <th>"raw"</th>
                        <th>"value"</th>
                        <th>"meaning and use"</th>
                    </tr>
                </thead>
                <tbody>{rows}</tbody>
            </table>
        </article>
    }
}
