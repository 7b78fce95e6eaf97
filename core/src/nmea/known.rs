//! Which sentence a line is, and which ones a decoder knows: all of them, or the few that a reader asks for.

use super::scan::FieldList;
use super::table::Definition;

/// A choice of the dictionary. What is not chosen is not linked either, which keeps a page small.
pub(crate) trait Known {
    /// The sentence of a formatter of three letters.
    fn formatter(formatter: [u8; 3]) -> Option<&'static Definition>;
    /// The proprietary sentence with that address and sub-address.
    fn proprietary(address: &str) -> Option<&'static Definition>;
    /// A query, `$--ccQ,FMT`.
    fn query() -> Option<&'static Definition>;
}

/// Formatter and definition of a line.
pub(crate) type Identity<'a> = (&'a str, Option<&'static Definition>);

#[inline(always)]
pub(crate) fn identify<'a, K: Known>(fields: &FieldList<'a>) -> Identity<'a> {
    if let &[first, second, a, b, c] = fields.address()
        && first != b'P'
        && (first | second).is_ascii()
        && let Some(known) = K::formatter([a, b, c])
    {
        (known.formatter, Some(known))
    } else {
        identify_other::<K>(*fields)
    }
}

/// Proprietary sentences, queries, and what is unknown.
#[inline(never)]
fn identify_other<'a, K: Known>(fields: FieldList<'a>) -> Identity<'a> {
    let address = text_of(fields.address());
    if address.len() > 1 && address.starts_with('P') {
        // `PNEY,001` and its like stand in the dictionary with their sub-address.
        let whole = core::str::from_utf8(fields.cursor().part().head).unwrap_or(address);
        let known = K::proprietary(whole);
        return (if known.is_some() { whole } else { address }, known);
    }
    let formatter = match address.split_at_checked(2) {
        Some((_, formatter)) if formatter.len() == 3 => formatter,
        _ => return (address, None),
    };
    match formatter.as_bytes() {
        &[a, b, c] if let Some(known) = K::formatter([a, b, c]) => (formatter, Some(known)),
        [.., b'Q'] => (formatter, K::query()),
        _ => (formatter, None),
    }
}

/// An address as text; empty where it is none.
pub(crate) fn text_of(address: &[u8]) -> &str {
    core::str::from_utf8(address).unwrap_or("")
}
