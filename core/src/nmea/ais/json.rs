//! The JSON object of a message (CLI-2).

use super::entry::Entry;
use super::fault::MessageFault;
use super::gather::Gathered;
use super::message::RadioMessage;
use super::value::Value;
use crate::nmea::JsonLine;
use crate::nmea::explain::latin1;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::ser::{SerializeMap, SerializeSeq};
use serde::{Serialize, Serializer};

impl Serialize for Gathered<'_> {
    /// One object: the fields of the message by their names, or a list of targets; payload and faults behind them.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (messages, mut faults) = self.messages();
        let mut map = serializer.serialize_map(None)?;
        match (self, messages.first()) {
            (Self::Targets { .. }, _) => {
                let targets: Vec<_> = messages.iter().map(Fields).collect();
                map.serialize_entry("targets", &targets)?;
            }
            (_, Some(message)) => {
                if message.title().is_none() || matches!(self, Self::ToSend { .. }) {
                    map.serialize_entry("type", &message.kind())?;
                }
                if let Self::ToSend {
                    destination: Some(destination),
                    ..
                } = self
                {
                    map.serialize_entry("destination_mmsi", destination)?;
                }
                fields(message, &mut map)?;
                map.serialize_entry("title", &message.title())?;
            }
            _ => {}
        }
        messages
            .iter()
            .for_each(|message| faults.extend(message.faults()));
        let (payload, fill_bits) = self.payload();
        map.serialize_entry("payload", &latin1(payload))?;
        map.serialize_entry("fill_bits", &fill_bits)?;
        map.serialize_entry("faults", &faults)?;
        map.end()
    }
}

impl Serialize for MessageFault {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(3))?;
        map.serialize_entry("field", &self.field)?;
        map.serialize_entry("kind", self.kind.name())?;
        map.serialize_entry("text", &self.kind.to_string())?;
        map.end()
    }
}

impl Serialize for Value<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Null => serializer.serialize_none(),
            Self::Integer(value) => serializer.serialize_i64(*value),
            Self::Number(value) | Self::AtLeast(value) => serializer.serialize_f64(*value),
            Self::Flag(flag) => serializer.serialize_bool(*flag),
            Self::Text(text) => serializer.collect_str(text),
            Self::Binary(binary) => serializer.collect_str(binary),
        }
    }
}

struct Fields<'m>(&'m RadioMessage<'m>);

impl Serialize for Fields<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        fields(self.0, &mut map)?;
        if let Some(source) = self.0.source() {
            map.serialize_entry("source", source)?;
        }
        map.end()
    }
}

/// The entries of a list, one object each.
struct Group<'m>(&'m [Entry<'m>]);

impl Serialize for Group<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut list = serializer.serialize_seq(None)?;
        for entries in self.0.chunk_by(|one, next| one.entry == next.entry) {
            list.serialize_element(&GroupEntry(entries))?;
        }
        list.end()
    }
}

struct GroupEntry<'m>(&'m [Entry<'m>]);

impl Serialize for GroupEntry<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for entry in self.0 {
            field(entry, &mut map)?;
        }
        map.end()
    }
}

fn fields<M: SerializeMap>(message: &RadioMessage<'_>, map: &mut M) -> Result<(), M::Error> {
    for entries in message
        .entries()
        .chunk_by(|one, next| one.group == next.group)
    {
        match entries.first().and_then(|entry| entry.group) {
            Some(name) => map.serialize_entry(name, &Group(entries))?,
            None => {
                for entry in entries {
                    field(entry, map)?;
                }
            }
        }
    }
    Ok(())
}

fn field<M: SerializeMap>(entry: &Entry<'_>, map: &mut M) -> Result<(), M::Error> {
    let name = entry.name();
    map.serialize_entry(name, &entry.value)?;
    if let Some(meaning) = entry.meaning() {
        map.serialize_entry(&alloc::format!("{name}_meaning"), meaning)?;
    }
    if let Value::Binary(binary) = &entry.value {
        map.serialize_entry(&alloc::format!("{name}_bits"), &binary.len())?;
    }
    Ok(())
}

impl JsonLine {
    /// As text without a line end, with the message that the line completes.
    #[must_use]
    pub fn text_with(&self, message: &Gathered<'_>) -> String {
        let mut text = self.text();
        if text.pop().is_some() {
            text.push_str(",\"message\":");
            text.push_str(&serde_json::to_string(message).unwrap_or_default());
            text.push('}');
        }
        text
    }
}
