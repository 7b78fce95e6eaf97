//! The messages in the document of all sentences, made from their tables.

use super::field::{Field, Item, Kind, Layout, NEVER};
use super::tables::{APPROACH, HEADER, TARGET, layouts};
use alloc::string::String;
use core::fmt::Write as _;

/// The part of `docs/sentences.md` on messages.
pub(in crate::nmea) fn document(out: &mut String) {
    out.push_str(
        "\n# AIS messages\n\nMessages of ITU-R M.1371-5 inside VDM and VDO; ABM and BBM carry what stands behind the addresses \
         of messages 6, 8, 12, 14, 25 and 26. What is \"not available\" is null; \
         north, east and starboard are positive. Spare bits are left out.\n\n## Every message\n",
    );
    rows(out, HEADER);
    for layout in layouts() {
        let _ = write!(out, "\n## Message {} – {}\n", layout.kind, layout.title);
        lengths(out, layout);
        rows(out, layout.items);
    }
    out.push_str("\n# Targets of TTD\n\nOne structure after the other, as their protocol version says (IEC 61162-1 TTD).\n");
    for layout in [&TARGET, &APPROACH] {
        let _ = write!(
            out,
            "\n## Protocol version {} – {}\n",
            layout.kind, layout.title
        );
        lengths(out, layout);
        rows(out, layout.items);
    }
}

fn lengths(out: &mut String, layout: &Layout) {
    let _ = match (layout.least, layout.most) {
        (least, most) if least == most => write!(out, "\n{least} bits.\n"),
        (least, most) => write!(out, "\n{least} to {most} bits.\n"),
    };
}

fn rows(out: &mut String, items: &[Item]) {
    out.push_str("\n| bits | name | contents | meaning |\n|---|---|---|---|\n");
    list(out, items, "");
}

fn list(out: &mut String, items: &[Item], mark: &str) {
    for item in items {
        match item {
            Item::Field(Field {
                kind: Kind::Spare, ..
            }) => {}
            Item::Field(field) => {
                match field.width {
                    0 => out.push_str("| rest"),
                    width => _ = write!(out, "| {width}"),
                }
                let _ = write!(
                    out,
                    "{mark} | {} | {} | {}",
                    field.name,
                    contents(field),
                    field.note
                );
                codes(out, field);
                out.push_str(" |\n");
            }
            Item::Part(items) => list(out, items, mark),
            Item::When(when, items) => {
                let values: alloc::vec::Vec<String> = (0..32)
                    .filter(|n| when.values >> n & 1 == 1)
                    .map(|n| alloc::format!("{n}"))
                    .collect();
                let _ = writeln!(
                    out,
                    "| … | | | Where {} is {}: |",
                    when.field,
                    values.join(", ")
                );
                list(out, items, "+");
            }
            Item::Longer(bits, items) => {
                let _ = writeln!(out, "| … | | | In messages of {bits} bits or more: |");
                list(out, items, "+");
            }
            Item::Auxiliary(are, items) => {
                let who = if *are {
                    "Auxiliary craft, whose MMSI begins with 98"
                } else {
                    "All others"
                };
                let _ = writeln!(out, "| … | | | {who}: |");
                list(out, items, "+");
            }
            Item::Each(name, most, _, items) => {
                let _ = writeln!(out, "| … | {name} | | Up to {most} times: |");
                list(out, items, "+");
            }
        }
    }
}

fn contents(field: &Field) -> String {
    match &field.kind {
        Kind::Whole(scale) | Kind::Number(scale) => {
            let mut text: String = scale.unit.name().unwrap_or("number").into();
            if scale.divisor > 1 {
                let _ = write!(text, ", 1/{}", scale.divisor);
            }
            if scale.none != NEVER {
                let _ = write!(text, "; {} is null", scale.none);
            }
            if scale.top != NEVER {
                let _ = write!(text, "; {} or more", scale.top);
            }
            text
        }
        Kind::Code(none, _) if *none == NEVER => "code".into(),
        Kind::Code(none, _) => alloc::format!("code; {none} is null"),
        Kind::Flag => "yes or no".into(),
        Kind::Text if field.width == 0 => "text".into(),
        Kind::Text => alloc::format!("text, at most {}", field.width / 6),
        Kind::Turn => "deg/min, root of it times 4.733; -128 is null".into(),
        Kind::Binary(_) => "data".into(),
        Kind::Spare => String::new(),
    }
}

fn codes(out: &mut String, field: &Field) {
    if let Kind::Code(_, meaning) = &field.kind
        && field.width < 8
    {
        for value in 0..1 << field.width {
            if let Some(meaning) = meaning(value) {
                let _ = write!(out, " `{value}` {meaning};");
            }
        }
    }
}
