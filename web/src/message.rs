//! The message that a line completes (AIS, tracked targets), as a table under it.

use crate::drawing::Drawing;
use crate::format;
use wheelover_core::nmea::ais::{Entry, Gathered, Value};

/// Draws every field of the message with name, value, unit and meaning, and what is wrong with it.
pub(crate) fn draw(drawing: &mut Drawing, gathered: &Gathered<'_>) {
    let (messages, mut faults) = gathered.messages();
    for message in &messages {
        drawing
            .open("article")
            .attribute("class", "explained")
            .attribute("data-message", message.kind().unwrap_or_default())
            .inside();
        let title = message.title().unwrap_or("unknown message");
        match message.kind() {
            Some(kind) => {
                drawing.element("h2", "", format_args!("message {kind} · {title}"));
            }
            None => {
                drawing.element("h2", "", title);
            }
        }
        drawing.plain(
            "<table><thead><tr><th>name</th><th>value</th><th>meaning</th></tr></thead><tbody>",
        );
        for entry in message.entries() {
            row(drawing, &entry);
        }
        drawing.plain("</tbody></table></article>");
        faults.extend(message.faults());
    }
    if !faults.is_empty() {
        drawing.plain("<ul class=\"faults\">");
        for fault in faults {
            drawing.element("li", "", fault);
        }
        drawing.plain("</ul>");
    }
}

fn row(drawing: &mut Drawing, entry: &Entry<'_>) {
    let name = entry.name().replace('_', " ");
    drawing.plain("<tr>");
    match entry.entry {
        0 => drawing.element("td", "", name),
        n => drawing.element("td", "", format_args!("{name} {n}")),
    };
    match (&entry.value, entry.unit()) {
        (Value::Null, _) => drawing.element("td", "mono null", format::NO_TEXT),
        (value, Some(unit)) => drawing.element("td", "mono", format_args!("{value} {unit}")),
        (value, None) => drawing.element("td", "mono", value),
    };
    drawing.element("td", "", entry.meaning().unwrap_or(entry.note()));
    drawing.plain("</tr>");
}
