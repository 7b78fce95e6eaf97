//! The picture: each heard quantity with its value, source and the time it was heard.

use serde::{Deserialize, Serialize};

/// What a station has heard and sent, folded from its lines.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Picture {}
