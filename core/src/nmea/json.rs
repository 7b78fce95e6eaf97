//! The JSON object of a decoded line (CLI-2), the same from the command line and in the browser.

use super::explain::{Field, FieldValue, explain, latin1};
use super::{Checksum, Sentence, decode, hints, unescape};
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::{Serialize, Serializer};

/// One decoded line, as `wheelover decode --json` prints it.
#[derive(Clone, Debug, Serialize)]
pub struct JsonLine {
    /// Number of the line in its file, from 1.
    pub line: u64,
    /// When it was heard, seconds; null where the file does not say.
    pub at: Option<f64>,
    /// The line as it was, ISO 8859-1.
    pub raw: String,
    /// Talker and formatter.
    pub address: String,
    /// Talker; `P` for a proprietary sentence.
    pub talker: String,
    /// Formatter, with its sub-address.
    pub sentence: String,
    /// What it is; null where it is unknown.
    pub title: Option<&'static str>,
    /// Given and computed checksum.
    pub checksum: JsonChecksum,
    /// Its fields.
    pub fields: Vec<JsonField>,
    /// Everything that is wrong.
    pub faults: Vec<JsonFault>,
    /// What else is worth knowing.
    pub hints: Vec<String>,
}

/// Checksum of a line, two hexadecimal digits each.
#[derive(Clone, Debug, Serialize)]
pub struct JsonChecksum {
    /// What the line says; null where it has none.
    pub given: Option<String>,
    /// What it should be.
    pub computed: String,
}

/// A field of a line.
#[derive(Clone, Debug, Serialize)]
pub struct JsonField {
    /// Its number, from 1.
    pub n: usize,
    /// Its name.
    pub name: String,
    /// What stands there.
    pub raw: String,
    /// Its value.
    pub value: JsonValue,
    /// Its unit.
    pub unit: Option<&'static str>,
    /// What its code means.
    pub meaning: Option<&'static str>,
    /// What it is and what this interface does with it.
    pub note: &'static str,
    /// What is wrong with it.
    pub fault: Option<String>,
}

/// Value of a field.
#[derive(Clone, Debug, PartialEq)]
pub enum JsonValue {
    /// Not available.
    Null,
    /// A number.
    Number(f64),
    /// A whole number.
    Integer(i64),
    /// A letter, text, time or date.
    Text(String),
}

impl Serialize for JsonValue {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Null => serializer.serialize_none(),
            Self::Number(value) => serializer.serialize_f64(*value),
            Self::Integer(value) => serializer.serialize_i64(*value),
            Self::Text(text) => serializer.serialize_str(text),
        }
    }
}

/// A fault of a line.
#[derive(Clone, Debug, Serialize)]
pub struct JsonFault {
    /// The field; null where it is the whole line.
    pub n: Option<u8>,
    /// What is wrong, as a word.
    pub kind: &'static str,
    /// What is wrong, in words.
    pub text: String,
}

/// Explains a line that was already decoded.
///
/// ```
/// use wheelover_core::nmea::{decode, json_line, JsonValue};
/// let line = json_line(12, None, &decode(b"$HEHDT,361.0,T*2B"));
/// assert_eq!(line.sentence, "HDT");
/// assert_eq!(line.fields[0].value, JsonValue::Null);
/// assert_eq!((line.faults[0].n, line.faults[0].kind), (Some(1), "out_of_range"));
/// assert_eq!(line.faults[0].text, "not from 0 to 360");
/// assert!(line.text().starts_with(r#"{"line":12,"at":null,"raw":"$HEHDT,361.0,T*2B""#));
/// ```
#[must_use]
pub fn json_line(line: u64, at: Option<f64>, sentence: &Sentence<'_>) -> JsonLine {
    let explanation = explain(sentence);
    let given = match sentence.checksum {
        Checksum::Right(sum)
        | Checksum::Wrong {
            given: Some(sum), ..
        } => Some(hex(sum)),
        Checksum::Wrong { given: None, .. } => {
            let star = sentence.text.iter().position(|&b| b == b'*');
            star.map(|star| latin1(&sentence.text[star + 1..]))
        }
        Checksum::Missing { .. } => None,
    };
    JsonLine {
        line,
        at: at.or_else(|| sentence.tag.and_then(|tag| tag.time())),
        raw: latin1(sentence.raw),
        address: sentence.address().to_string(),
        talker: sentence.talker().to_string(),
        sentence: sentence.formatter.to_string(),
        title: explanation.title,
        checksum: JsonChecksum {
            given,
            computed: hex(sentence.checksum.computed()),
        },
        hints: hints(sentence),
        faults: explanation
            .faults
            .iter()
            .map(|f| JsonFault {
                n: f.field,
                kind: f.kind.name(),
                text: f.text(),
            })
            .collect(),
        fields: explanation.fields.iter().map(field).collect(),
    }
}

/// The JSON object of a line, as text without a line end.
#[must_use]
pub fn json(line: u64, at: Option<f64>, raw: &[u8]) -> String {
    json_line(line, at, &decode(raw)).text()
}

impl JsonLine {
    /// As text without a line end.
    #[must_use]
    pub fn text(&self) -> String {
        serde_json::to_string(self).unwrap_or_default()
    }
}

fn field(field: &Field<'_>) -> JsonField {
    JsonField {
        n: field.n,
        name: field.name.to_string(),
        raw: latin1(field.raw),
        value: match field.value {
            _ if field.fault.is_some() => JsonValue::Null,
            FieldValue::None => JsonValue::Null,
            FieldValue::Number(value) | FieldValue::Degrees(value) => JsonValue::Number(value),
            FieldValue::Integer(value) => JsonValue::Integer(value),
            FieldValue::Letter(letter) => JsonValue::Text(char::from(letter).to_string()),
            FieldValue::Text(text) => JsonValue::Text(unescape(text)),
            time @ FieldValue::Time(_) => JsonValue::Text(time.to_string()),
            FieldValue::Date(date) => JsonValue::Text(date.to_string()),
        },
        unit: field.unit,
        meaning: field.meaning,
        note: field.note,
        fault: field.fault.map(|fault| fault.to_string()),
    }
}

fn hex(byte: u8) -> String {
    alloc::format!("{byte:02X}")
}
