//! Lines explained, as markup: chips to tap, a table with names, values, units, meanings, faults and hints.
//!
//! This belongs to the dictionary's module, which holds the texts; the page only shows it.

use crate::drawing::Drawing;
use crate::format;
use crate::heard::latin1;
use wheelover_core::geo::to_millimetre;
use wheelover_core::nmea::{JsonField, JsonLine, JsonValue, decode, json_line};

fn explain(number: u64, text: &str) -> JsonLine {
    json_line(number, None, &decode(&latin1(text)))
}

/// A line as chips: the address (0) and each field can be tapped.
#[must_use]
pub fn chips(text: &str, chosen: Option<usize>) -> String {
    let line = explain(0, text);
    let mut drawing = Drawing::new();
    if line.address.is_empty() {
        drawing.element("span", "chip fault", text);
        return drawing.markup();
    }
    let start = if line.raw.contains('!') { '!' } else { '$' };
    let address = line.address.split(',').next().unwrap_or_default();
    chip(
        &mut drawing,
        0,
        chosen,
        "chip address",
        &format!("{start}{address}"),
    );
    for field in &line.fields {
        let class = match (&field.fault, field.raw.is_empty()) {
            (Some(_), _) => "chip fault",
            (None, true) => "chip null",
            (None, false) => "chip",
        };
        let raw = if field.raw.is_empty() {
            "·"
        } else {
            &field.raw
        };
        drawing.plain("<span>,</span>");
        chip(&mut drawing, field.n, chosen, class, raw);
    }
    let sum = match &line.checksum.given {
        Some(given) => format!("*{given}"),
        None => " no checksum".to_owned(),
    };
    drawing.element("span", "", sum);
    drawing.markup()
}

fn chip(drawing: &mut Drawing, n: usize, chosen: Option<usize>, class: &str, text: &str) {
    drawing
        .open("button")
        .attribute("type", "button")
        .attribute("class", class)
        .attribute("data-field", n)
        .attribute("aria-pressed", chosen == Some(n));
    drawing.inside().say(text).close("button");
}

/// A line as a table; the field that was tapped stands above it in words.
#[must_use]
pub fn table(text: &str, chosen: Option<usize>) -> String {
    let mut drawing = Drawing::new();
    article(&mut drawing, &explain(0, text), chosen);
    drawing.markup()
}

/// A sentence with all its fields.
pub(crate) fn article(drawing: &mut Drawing, line: &JsonLine, chosen: Option<usize>) {
    let name = match line.sentence.as_str() {
        "" => "no sentence",
        name => name,
    };
    let computed = &line.checksum.computed;
    drawing
        .open("article")
        .attribute("class", "explained")
        .attribute("data-sentence", name)
        .inside();
    let title = line.title.unwrap_or("unknown sentence");
    drawing.element("h2", "", format_args!("{name} · {title}"));
    drawing.element("p", "raw", &line.raw);
    drawing
        .open("p")
        .attribute("class", "small")
        .attribute("data-checksum", computed)
        .inside();
    match &line.checksum.given {
        Some(given) if given == computed => drawing.say(format_args!("checksum {given}: right")),
        Some(given) => drawing.say(format_args!("checksum {given}: should be {computed}")),
        None => drawing.say(format_args!("no checksum: should be {computed}")),
    };
    drawing.close("p");
    if let Some(field) = line.fields.iter().find(|field| chosen == Some(field.n)) {
        looked_at(drawing, field);
    }
    let faults = line.faults.iter().map(|fault| match fault.n {
        Some(n) => format!("field {n}: {}", fault.text),
        None => fault.text.clone(),
    });
    list(drawing, "faults", faults);
    list(drawing, "hints", line.hints.iter().cloned());
    drawing.plain(
        "<table><thead><tr><th>#</th><th>name</th><th>raw</th><th>value</th><th>meaning and use</th></tr></thead><tbody>",
    );
    for field in &line.fields {
        row(drawing, field, chosen == Some(field.n));
    }
    drawing.plain("</tbody></table></article>");
}

/// The field that was tapped, in words.
fn looked_at(drawing: &mut Drawing, field: &JsonField) {
    drawing
        .open("p")
        .attribute("class", "looked-at")
        .attribute("data-explained", field.n)
        .inside();
    let name = field.name.replace('_', " ");
    let (value, unit) = (value(field), field.unit.unwrap_or_default());
    let said = format!("{} {name}: {value} {unit}", field.n);
    drawing.element("b", "", said);
    drawing.say(' ').say(words(field)).close("p");
}

fn list(drawing: &mut Drawing, class: &str, entries: impl ExactSizeIterator<Item = String>) {
    let count = entries.len();
    if count == 0 {
        return;
    }
    drawing
        .open("ul")
        .attribute("class", class)
        .attribute(&format!("data-{class}"), count)
        .inside();
    for entry in entries {
        drawing.element("li", "", entry);
    }
    drawing.close("ul");
}

fn row(drawing: &mut Drawing, field: &JsonField, chosen: bool) {
    let class = match (&field.fault, field.raw.is_empty(), chosen) {
        (Some(_), _, _) => "fault",
        (None, _, true) => "chosen",
        (None, true, false) => "null",
        (None, false, false) => "",
    };
    drawing
        .open("tr")
        .attribute("class", class)
        .attribute("data-field", field.n)
        .inside();
    drawing.element("td", "mono", field.n);
    drawing.element("td", "", field.name.replace('_', " "));
    drawing.element("td", "mono", &field.raw);
    let unit = field.unit.unwrap_or_default();
    drawing.element("td", "mono", format_args!("{} {unit}", value(field)));
    drawing.plain("<td>").say(words(field));
    if let Some(fault) = &field.fault {
        drawing.element(
            "b",
            "field-fault",
            format_args!(" {}", fault.replace('_', " ")),
        );
    }
    drawing.plain("</td></tr>");
}

/// The value as a person reads it.
fn value(field: &JsonField) -> String {
    match &field.value {
        JsonValue::Null => format::NO_TEXT.to_owned(),
        JsonValue::Number(number) if field.unit == Some("deg") => {
            format!("{}", to_millimetre(*number))
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_is_a_chip_and_the_wrong_one_is_marked() {
        let text = "$EIGLL,5345.345,N,12365.635,E,152829.96,A,A*7E";
        let chips = chips(text, Some(3));
        assert_eq!(chips.matches("data-field").count(), 8);
        assert!(
            chips
                .contains("class=\"chip fault\" data-field=\"3\" aria-pressed=\"true\">12365.635<")
        );
        let table = table(text, Some(3));
        assert!(table.contains("data-explained=\"3\""));
        assert!(table.contains("data-faults=\"1\""), "{table}");
    }

    // A coordinate has no more decimals than a millimetre needs.
    #[test]
    fn a_longitude_has_no_fifteen_decimals() {
        let table = table("$EIGLL,5947.727320,N,02458.842400,E,152829.96,A,A*7E", None);
        assert!(
            table.contains("24.98070667") && table.contains("59.79545533"),
            "{table}"
        );
        assert!(!table.contains("24.980706666"), "{table}");
    }
}
