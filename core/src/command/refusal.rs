//! What is answered where something is not done.

use alloc::string::String;
use serde::{Deserialize, Serialize};

/// A command that was not done, with the reason an officer would give.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Refusal {
    /// The field of the sentence that is at fault, from 1; none where it is no single field.
    pub field: Option<u8>,
    /// The reason.
    pub text: String,
}

impl Refusal {
    /// A refusal that is about no field.
    #[must_use]
    pub fn because(text: impl Into<String>) -> Self {
        Self {
            field: None,
            text: text.into(),
        }
    }
}

impl core::fmt::Display for Refusal {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self.field {
            Some(field) => write!(f, "field {field}: {}", self.text),
            None => f.write_str(&self.text),
        }
    }
}
