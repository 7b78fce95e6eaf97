//! Explanation: the table walked beside the raw fields, each with name, value, unit, meaning and use.

pub use super::explained::{Explanation, Field, FieldValue, Name};
pub use super::value::latin1;

use super::explain_text::{compass, side_meaning, unit_meaning};
use super::explain_units::name_units;
use super::explained::Facet;
use super::read::read;
use super::sentence::{Item, Sentence};
use super::table::{Kind, MemberText, SentenceText};
use super::tables::text;
use super::value::{Date, Value};
use alloc::vec::Vec;

const NOTHING: MemberText = MemberText {
    name: "field",
    note: "",
    meanings: &[],
};

/// Explains a sentence field by field; an unknown one gives its raw fields.
///
/// ```
/// use wheelover_core::nmea::{decode, explain};
/// let sentence = decode(b"$EIXTE,A,A,0.015,R,N,A*32");
/// let explanation = explain(&sentence);
/// let side = &explanation.fields[3];
/// assert_eq!(side.name.to_string(), "cross_track_side");
/// assert_eq!(side.meaning, Some("steer to starboard: the ship is left of the track"));
/// // Left of the track is negative.
/// assert_eq!(explanation.fields[2].value.to_string(), "-0.015");
/// assert_eq!(explanation.fields[2].unit, Some("nm"));
/// ```
#[must_use]
pub fn explain<'a>(sentence: &Sentence<'a>) -> Explanation<'a> {
    let texts = sentence.known.and_then(text);
    let mut faults = Vec::new();
    sentence.frame_faults(&mut faults);
    let mut fields = Vec::with_capacity(sentence.fields.len());
    if let Some(definition) = sentence.known
        && definition.first() == 1
    {
        fields.push(plain(
            sentence,
            1,
            "sub_address",
            "Which sentence of this maker it is.",
        ));
    }
    if let Some(texts) = texts {
        sentence.visit(
            &mut |item| member(sentence, texts, &item, &mut fields),
            &mut faults,
        );
    }
    let (name, note) = match texts {
        Some(_) => ("extra", "More fields than any known edition has."),
        None => ("field", ""),
    };
    while fields.len() < sentence.fields.len() {
        fields.push(plain(sentence, fields.len() + 1, name, note));
    }
    fields.truncate(sentence.fields.len());
    name_units(sentence, &mut fields);
    for fault in &faults {
        if let Some(n) = fault.field
            && let Some(field) = fields.get_mut(usize::from(n) - 1)
        {
            field.fault.get_or_insert(fault.kind);
            field.meaning = None;
        }
    }
    Explanation {
        title: texts.map(|t| t.title),
        source: texts.map(|t| t.source),
        fields,
        faults,
    }
}

fn plain<'a>(
    sentence: &Sentence<'a>,
    n: usize,
    name: &'static str,
    note: &'static str,
) -> Field<'a> {
    let raw = sentence.fields.get(n);
    Field {
        n,
        name: Name {
            member: name,
            facet: Facet::Whole,
            entry: 0,
        },
        raw,
        value: if raw.is_empty() {
            FieldValue::None
        } else {
            FieldValue::Text(raw)
        },
        unit: None,
        meaning: None,
        note,
        fault: None,
    }
}

fn member<'a>(
    sentence: &Sentence<'a>,
    texts: &'static SentenceText,
    item: &Item<'a>,
    fields: &mut Vec<Field<'a>>,
) {
    let list = match (item.entry, item.in_tail) {
        (_, true) => texts.tail,
        (0, _) => texts.members,
        _ => texts.group,
    };
    let words = list.get(item.index).unwrap_or(&NOTHING);
    let mut push = |offset: usize, facet, value, unit, meaning| {
        let n = item.field + offset;
        if n <= sentence.fields.len() {
            let name = Name {
                member: words.name,
                facet,
                entry: item.entry,
            };
            let raw = sentence.fields.get(n);
            fields.push(Field {
                n,
                name,
                raw,
                value,
                unit,
                meaning,
                note: words.note,
                fault: None,
            });
        }
    };
    let number = match item.value {
        Value::Number(number) => FieldValue::Number(number.value()),
        _ => FieldValue::None,
    };
    let letter = |offset: usize| match sentence.fields.get(item.field + offset) {
        [letter] => (FieldValue::Letter(*letter), *letter),
        _ => (FieldValue::None, 0),
    };
    match item.kind {
        Kind::Number(format) => push(0, Facet::Whole, number, format.unit.name(), None),
        Kind::Integer(format) => push(
            0,
            Facet::Whole,
            integer(item.value),
            format.unit.name(),
            None,
        ),
        Kind::Lettered(format, _) => {
            push(0, Facet::Whole, number, format.unit.name(), None);
            let (value, letter) = letter(1);
            push(
                1,
                Facet::Unit,
                value,
                None,
                unit_meaning(letter, format.unit.name()),
            );
        }
        Kind::Sided(format, sides) => {
            push(0, Facet::Whole, number, format.unit.name(), None);
            let (value, letter) = letter(1);
            push(1, Facet::Side, value, None, side_meaning(letter, *sides));
        }
        Kind::Crossed(format, sides, _) => {
            push(0, Facet::Whole, number, format.unit.name(), None);
            let (value, side) = letter(1);
            push(1, Facet::Side, value, None, side_meaning(side, *sides));
            let (value, unit) = letter(2);
            push(
                2,
                Facet::Unit,
                value,
                None,
                unit_meaning(unit, format.unit.name()),
            );
        }
        Kind::Code(letters) => {
            let (value, meaning) = match item.value {
                Value::Code(letter) => {
                    let at = letters.iter().position(|&l| l == letter);
                    (
                        FieldValue::Letter(letter),
                        at.and_then(|at| words.meanings.get(at).copied()),
                    )
                }
                _ => (FieldValue::None, None),
            };
            push(0, Facet::Whole, value, None, meaning);
        }
        Kind::Position(_) => {
            // Each half for itself: one may be right although the position is not.
            let half = |offset, degrees| {
                let kind = Kind::Angle {
                    degrees,
                    decimals: 0,
                };
                let mut cursor = sentence.fields.cursor_at(item.field - 1 + offset);
                let value = read(&kind, &mut cursor, &mut Vec::new());
                let number = value.and_then(|value| value.number());
                number.map_or(FieldValue::None, FieldValue::Degrees)
            };
            let (lat, lon) = (half(0, 2), half(2, 3));
            let unit = Some("deg");
            push(0, Facet::Latitude, lat, unit, None);
            let (value, side) = letter(1);
            push(1, Facet::LatitudeSide, value, None, compass(side));
            push(2, Facet::Longitude, lon, unit, None);
            let (value, side) = letter(3);
            push(3, Facet::LongitudeSide, value, None, compass(side));
        }
        Kind::Angle { .. } => {
            let value = item
                .value
                .number()
                .map_or(FieldValue::None, FieldValue::Degrees);
            push(0, Facet::Whole, value, Some("deg"), None);
            let (value, side) = letter(1);
            push(1, Facet::Side, value, None, compass(side));
        }
        Kind::Words(list) => {
            let at = list
                .iter()
                .position(|word| item.value == Value::Text(word.as_bytes()));
            let meaning = at.and_then(|at| words.meanings.get(at).copied());
            push(0, Facet::Whole, typed(item.value), None, meaning);
        }
        Kind::Hex(_) => push(0, Facet::Whole, integer(item.value), None, None),
        Kind::Time | Kind::Date | Kind::Text(_) | Kind::Letters(..) | Kind::Payload | Kind::Any => {
            push(0, Facet::Whole, typed(item.value), None, None);
        }
    }
}

fn integer(value: Value<'_>) -> FieldValue<'_> {
    match value {
        Value::Number(number) => {
            let size = i64::try_from(number.mantissa()).unwrap_or(i64::MAX);
            FieldValue::Integer(if number.negative() { -size } else { size })
        }
        _ => FieldValue::None,
    }
}

fn typed(value: Value<'_>) -> FieldValue<'_> {
    match value {
        Value::Text(text) => FieldValue::Text(text),
        Value::Time(time) => FieldValue::Time(time),
        Value::Date(date) => FieldValue::Date(Date::from_wire(date)),
        _ => FieldValue::None,
    }
}

impl<'a> Sentence<'a> {
    /// The value of the member with that name, such as `heading_to_steer`; null where there is none.
    #[must_use]
    pub fn member(&self, name: &str) -> Value<'a> {
        let mut found = Value::Null;
        if let Some(texts) = self.known.and_then(text) {
            self.visit(
                &mut |item| {
                    let list = if item.in_tail {
                        texts.tail
                    } else {
                        texts.members
                    };
                    if item.entry == 0 && list.get(item.index).is_some_and(|t| t.name == name) {
                        found = item.value;
                    }
                },
                &mut Vec::new(),
            );
        }
        found
    }
}
