//! Which sentences a decoder knows: all of them, or the few that a reader asks for.

use super::table::{Definition, key};
use super::tables;

/// A choice of the dictionary. What is not chosen is not linked either, which keeps a page small.
pub(crate) trait Known {
    /// The sentence of a formatter of three letters.
    fn formatter(formatter: &str) -> Option<&'static Definition>;
    /// The proprietary sentence with that address and sub-address.
    fn proprietary(address: &str) -> Option<&'static Definition>;
    /// A query, `$--ccQ,FMT`.
    fn query() -> Option<&'static Definition>;
}

/// All sentences.
pub(crate) struct Whole;

impl Known for Whole {
    #[inline(always)]
    fn formatter(formatter: &str) -> Option<&'static Definition> {
        tables::find(formatter)
    }
    fn proprietary(address: &str) -> Option<&'static Definition> {
        tables::proprietary(address)
    }
    fn query() -> Option<&'static Definition> {
        Some(tables::query())
    }
}

/// The sentences that the picture is made of.
pub(crate) struct OfPicture;

static OF_PICTURE: [&Definition; 13] = [
    &tables::hdt::DEFINITION,
    &tables::ths::DEFINITION,
    &tables::rot::DEFINITION,
    &tables::gll::DEFINITION,
    &tables::vtg::DEFINITION,
    &tables::vhw::DEFINITION,
    &tables::rsa::DEFINITION,
    &tables::ror::DEFINITION,
    &tables::htd::DEFINITION,
    &tables::htc::DEFINITION,
    &tables::xte::DEFINITION,
    &tables::pney1::DEFINITION,
    &tables::pney2::DEFINITION,
];

impl Known for OfPicture {
    fn formatter(formatter: &str) -> Option<&'static Definition> {
        let key = key(formatter.as_bytes());
        OF_PICTURE.into_iter().find(|known| known.key == key)
    }
    fn proprietary(address: &str) -> Option<&'static Definition> {
        OF_PICTURE
            .into_iter()
            .find(|known| known.formatter == address)
    }
    fn query() -> Option<&'static Definition> {
        None
    }
}
