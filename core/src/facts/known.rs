//! The part of the dictionary that a picture needs, so that a page carries no other tables.

use super::facts;
use crate::nmea::{self, Definition, Known, key};

macro_rules! definitions {
    ($($(#[$doc:meta])* $field:ident: $kind:ident $type:ty { $($name:ident: $read:path),* } $(own { $($own:ident: $own_read:path),* })?;)*) => {
        static OF_PICTURE: &[&Definition] = &[$($(&nmea::$name::DEFINITION,)*)*];
    };
}
facts!(definitions);

/// The sentences of the facts.
pub(crate) struct OfPicture;

impl Known for OfPicture {
    fn formatter(formatter: [u8; 3]) -> Option<&'static Definition> {
        let key = key(&formatter);
        let mut known = OF_PICTURE.iter().copied();
        known.find(|known| known.key == key && key != 0)
    }
    fn proprietary(address: &str) -> Option<&'static Definition> {
        let mut known = OF_PICTURE.iter().copied();
        known.find(|known| known.formatter == address)
    }
    fn query() -> Option<&'static Definition> {
        None
    }
}
