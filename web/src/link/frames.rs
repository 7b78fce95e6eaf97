//! Reads a frame from the browser's own objects: fields are asked for by name, in the order of the type.
//!
//! A type reads its fields as a list and its variants by number, and a fault has no words: that is a fifth of what a reader by
//! names with words would weigh, and the page shows no more of a fault than that there is one.

use core::fmt;
use js_sys::{Array, Reflect};
use serde::de::{
    self, DeserializeOwned, DeserializeSeed, Expected, IntoDeserializer, Unexpected, Visitor,
};
use wasm_bindgen::{JsCast, JsValue};
use wheelover_core::view::Down;

/// Whole numbers up to here are exact in JavaScript.
const EXACT: f64 = 9_007_199_254_740_992.0;

/// Reads a frame as it came; nothing where it cannot be read.
#[must_use]
pub fn read(text: &str) -> Option<Down> {
    let frame = js_sys::JSON::parse(text).ok()?;
    let kind = field(&frame, "type")?.as_string()?;
    Some(match kind.as_str() {
        "hello" => Down::Hello(body(frame)?),
        "snapshot" => Down::Snapshot(body(frame)?),
        "lines" => Down::Lines(body(frame)?),
        "route" => Down::Route(body(frame)?),
        "ports" => Down::Ports(body(frame)?),
        "answer" => Down::Answer(body(frame)?),
        // The page shows neither.
        "settings" | "gap" => Down::Gap { lost: 0 },
        _ => return None,
    })
}

fn body<T: DeserializeOwned>(frame: JsValue) -> Option<T> {
    T::deserialize(Node(frame)).ok()
}

fn field(object: &JsValue, name: &str) -> Option<JsValue> {
    Reflect::get(object, &JsValue::from_str(name)).ok()
}

/// A value of the frame.
struct Node(JsValue);

/// It is not what its type says.
#[derive(Debug)]
struct Unread;

impl fmt::Display for Unread {
    fn fmt(&self, _: &mut fmt::Formatter<'_>) -> fmt::Result {
        Ok(())
    }
}

impl core::error::Error for Unread {}

impl de::Error for Unread {
    fn custom<T: fmt::Display>(_: T) -> Self {
        Self
    }
    fn invalid_type(_: Unexpected<'_>, _: &dyn Expected) -> Self {
        Self
    }
    fn invalid_value(_: Unexpected<'_>, _: &dyn Expected) -> Self {
        Self
    }
    fn invalid_length(_: usize, _: &dyn Expected) -> Self {
        Self
    }
    fn unknown_variant(_: &str, _: &'static [&'static str]) -> Self {
        Self
    }
}

impl Node {
    fn whole(&self) -> Result<f64, Unread> {
        let number = self.0.as_f64().ok_or(Unread)?;
        if libm::fabs(number) <= EXACT && libm::trunc(number) == number {
            Ok(number)
        } else {
            Err(Unread)
        }
    }

    fn unsigned(&self) -> Result<u64, Unread> {
        let number = self.whole()?;
        if number >= 0.0 {
            Ok(number as u64)
        } else {
            Err(Unread)
        }
    }

    fn list(self) -> Result<List, Unread> {
        let array: Array = self.0.dyn_into().map_err(|_| Unread)?;
        Ok(List { array, next: 0 })
    }
}

macro_rules! numbers {
    ($read:ident $visit:ident: $($name:ident)*) => {
        $(fn $name<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unread> {
            visitor.$visit(self.$read()? as _)
        })*
    };
}

impl<'de> de::Deserializer<'de> for Node {
    type Error = Unread;

    numbers!(unsigned visit_u64: deserialize_u8 deserialize_u16 deserialize_u32 deserialize_u64);
    numbers!(whole visit_i64: deserialize_i8 deserialize_i16 deserialize_i32 deserialize_i64);

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unread> {
        visitor.visit_f64(self.0.as_f64().ok_or(Unread)?)
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unread> {
        visitor.visit_bool(self.0.as_bool().ok_or(Unread)?)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unread> {
        self.deserialize_string(visitor)
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unread> {
        visitor.visit_string(self.0.as_string().ok_or(Unread)?)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unread> {
        if self.0.is_null() || self.0.is_undefined() {
            visitor.visit_none()
        } else {
            visitor.visit_some(self)
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Unread> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unread> {
        visitor.visit_seq(self.list()?)
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, _: usize, visitor: V) -> Result<V::Value, Unread> {
        visitor.visit_seq(self.list()?)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Unread> {
        if self.0.is_object() && !Array::is_array(&self.0) {
            visitor.visit_seq(Fields {
                object: self.0,
                names: fields.iter(),
            })
        } else {
            Err(Unread)
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Unread> {
        let name = self.0.as_string().ok_or(Unread)?;
        let place = variants.iter().position(|variant| *variant == name);
        visitor.visit_enum(IntoDeserializer::<Unread>::into_deserializer(
            place.ok_or(Unread)? as u32,
        ))
    }

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Unread> {
        // No type that the page shows must be guessed.
        Err(Unread)
    }

    serde::forward_to_deserialize_any! {
        f32 char bytes byte_buf unit unit_struct tuple_struct map identifier ignored_any
    }
}

/// Elements of a list.
struct List {
    array: Array,
    next: u32,
}

impl<'de> de::SeqAccess<'de> for List {
    type Error = Unread;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Unread> {
        if self.next >= self.array.length() {
            return Ok(None);
        }
        let element = self.array.get(self.next);
        self.next += 1;
        seed.deserialize(Node(element)).map(Some)
    }

    fn size_hint(&self) -> Option<usize> {
        Some((self.array.length() - self.next) as usize)
    }
}

/// Fields of an object in the order of the type; one that is missing is none where the type allows that.
struct Fields {
    object: JsValue,
    names: core::slice::Iter<'static, &'static str>,
}

impl<'de> de::SeqAccess<'de> for Fields {
    type Error = Unread;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Unread> {
        let Some(name) = self.names.next() else {
            return Ok(None);
        };
        let value = field(&self.object, name).ok_or(Unread)?;
        seed.deserialize(Node(value)).map(Some)
    }
}
