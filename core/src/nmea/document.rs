//! The document of all sentences, made from the tables.

use super::table::{Definition, Kind, MemberText, Repeat, Unit};
use super::tables::{dictionary, text};
use alloc::string::String;
use core::fmt::Write as _;

/// The whole of `docs/sentences.md`.
#[must_use]
pub fn document() -> String {
    let mut out = String::from(
        "# The sentences\n\nMade from the tables of `core/src/nmea/tables`; a test compares. Fields are counted from 1. \
         An empty field means \"not available\", never zero. Decimals are those that are sent.\n",
    );
    let mut all: alloc::vec::Vec<_> = dictionary().to_vec();
    all.sort_by_key(|d| d.formatter);
    let _ = write!(out, "\n{} sentences:", all.len());
    for definition in &all {
        let _ = write!(out, " {}", definition.formatter);
    }
    out.push_str(".\n");
    for definition in all {
        sentence(&mut out, definition);
    }
    super::ais::document(&mut out);
    out
}

fn sentence(out: &mut String, definition: &'static Definition) {
    let Some(texts) = text(definition) else {
        return;
    };
    let start = char::from(definition.delimiter);
    let talker = if definition.first() == 1 { "" } else { "--" };
    let _ = write!(
        out,
        "\n## {start}{talker}{} – {}\n\nSource: {}.",
        definition.formatter, texts.title, texts.source
    );
    if definition.lengths.len() > 1 {
        let list: alloc::vec::Vec<String> = definition
            .lengths
            .iter()
            .map(|n| alloc::format!("{n}"))
            .collect();
        let _ = write!(out, " Fields: {} (the first is sent).", list.join(", "));
    }
    out.push_str("\n\n| field | name | contents | meaning |\n|---|---|---|---|\n");
    let mut at = definition.first() + 1;
    if definition.first() == 1 {
        out.push_str("| 1 | sub_address | fixed | Which sentence of this maker it is. |\n");
    }
    rows(out, definition.members, texts.members, &mut at, "");
    if let Some(group) = &definition.group {
        let how = match group.repeat {
            Repeat::UpTo(most) => alloc::format!("up to {most} times"),
            Repeat::Counted(field) => alloc::format!("as often as field {} says", field + 1),
            Repeat::Open => String::from("to the end of the line"),
        };
        let _ = writeln!(out, "| … | | | Repeated {how}: |");
        rows(out, group.members, texts.group, &mut at, "+");
        rows(out, definition.tail, texts.tail, &mut at, "+");
    }
}

fn rows(out: &mut String, members: &[Kind], texts: &[MemberText], at: &mut usize, mark: &str) {
    for (kind, words) in members.iter().zip(texts) {
        let last = *at + kind.width() - 1;
        let _ = if last == *at {
            write!(
                out,
                "| {at}{mark} | {} | {} | {}",
                words.name,
                contents(kind),
                words.note
            )
        } else {
            write!(
                out,
                "| {at}–{last}{mark} | {} | {} | {}",
                words.name,
                contents(kind),
                words.note
            )
        };
        if let Kind::Code(letters) | Kind::Letters(letters, _) = kind {
            for (letter, meaning) in letters.iter().zip(words.meanings) {
                let _ = write!(out, " `{}` {meaning};", char::from(*letter));
            }
        }
        if let Kind::Words(list) = kind {
            for (word, meaning) in list.iter().zip(words.meanings) {
                let _ = write!(out, " `{word}` {meaning};");
            }
        }
        out.push_str(" |\n");
        *at = last + 1;
    }
}

fn contents(kind: &Kind) -> String {
    let number = |format: &super::Format| {
        let unit = match format.unit {
            Unit::None => String::from("number"),
            unit => unit.name().map_or_else(String::new, String::from),
        };
        let range = match (format.low, format.high) {
            (low, high) if low <= -i32::MAX && high == i32::MAX => String::new(),
            (low, i32::MAX) => alloc::format!(", from {low}"),
            (low, high) => alloc::format!(", {low} to {high}"),
        };
        alloc::format!("{unit}{range}, {} decimals", format.decimals)
    };
    let sides = |s: &super::Sides| {
        alloc::format!(
            "{} positive, {} negative",
            char::from(s.positive),
            char::from(s.negative)
        )
    };
    match kind {
        Kind::Number(format) => number(format),
        Kind::Integer(format) => number(format).replace(", 0 decimals", ", whole"),
        Kind::Lettered(format, letter) => {
            alloc::format!("{}; `{}`", number(format), char::from(*letter))
        }
        Kind::Sided(format, s) => alloc::format!("{}; {}", number(format), sides(s)),
        Kind::Crossed(format, s, letter) => {
            alloc::format!(
                "{}; {}; `{}`",
                number(format),
                sides(s),
                char::from(*letter)
            )
        }
        Kind::Code(_) => "code".into(),
        Kind::Letters(_, most) => alloc::format!("codes, at most {most}"),
        Kind::Words(_) => "code".into(),
        Kind::Text(limit) => alloc::format!("text, at most {limit}"),
        Kind::Position(decimals) => {
            alloc::format!("ddmm.mm, N/S, dddmm.mm, E/W, {decimals} decimals")
        }
        Kind::Angle { degrees: 2, .. } => "ddmm.mm, N/S".into(),
        Kind::Angle { .. } => "dddmm.mm, E/W".into(),
        Kind::Time => "hhmmss.ss".into(),
        Kind::Date => "ddmmyy".into(),
        Kind::Hex(_) => "hexadecimal".into(),
        Kind::Payload => "six-bit data".into(),
        Kind::Any => "free".into(),
    }
}
