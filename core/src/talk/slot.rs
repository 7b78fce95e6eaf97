//! Which sentence takes the place of one that still waits to be sent (FB11).

use super::table::{TABLE, When};

/// The place of a line among those that wait: the newest of a place is sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slot<'a> {
    /// Formatter; of a maker's sentence its address and sub-address.
    formatter: &'a [u8],
    /// What it reports, where each has a place of its own.
    of: [&'a [u8]; 2],
    /// It reports a change: it is never left out.
    pub event: bool,
}

/// The place of a line.
#[must_use]
pub fn slot(line: &[u8]) -> Slot<'_> {
    let end = line.iter().position(|byte| matches!(byte, b'*' | b'\r'));
    let line = &line[..end.unwrap_or(line.len())];
    let field = |number: usize| {
        let mut fields = line.split(|byte| *byte == b',');
        fields.nth(number).unwrap_or_default()
    };
    let address = field(0);
    let maker = address.get(1) == Some(&b'P');
    let formatter = if maker {
        // With the comma between.
        &line[1..(address.len() + 1 + field(1).len()).min(line.len())]
    } else {
        address.get(3..).unwrap_or(address)
    };
    let mut rows = TABLE.iter().flat_map(|told| told.rows);
    let row = rows.find(|row| row.formatter().as_bytes() == formatter);
    let of = row.map_or(&[][..], |row| row.of);
    let name = |place: usize| of.get(place).map_or(&[][..], |number| field(*number));
    Slot {
        formatter,
        of: [name(0), name(1)],
        event: row.is_some_and(|row| {
            matches!(
                row.when,
                When::Change | When::Asked | When::Requested | When::Operated
            )
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_newer_one_of_a_kind_replaces_and_a_report_has_a_place_for_each_thing_reported() {
        let same = |a: &str, b: &str| slot(a.as_bytes()) == slot(b.as_bytes());
        assert!(same("$AGROR,1.0,A*hh\r\n", "$AGROR,-2.0,A*hh\r\n"));
        assert!(!same("$AGROR,1.0,A*hh", "$AGRSA,1.0,A*hh"));
        assert!(same("$PNEY,001,A*hh", "$PNEY,001,V*hh"));
        assert!(!same("$PNEY,001,A*hh", "$PNEY,002,A*hh"));
        assert!(same("$AGALR,,012,A,V,*hh", "$AGALR,,012,V,V,*hh"));
        assert!(!same("$AGALR,,012,A,V,*hh", "$AGALR,,013,A,V,*hh"));
        // A part of an alert is replaced by the same part of the same alert only; pages of a list each have their place.
        assert!(same(
            "$AGALF,2,1,3,,B,A,V,,10101,1,1,0,T*hh",
            "$AGALF,2,1,4,,B,A,A,,10101,1,2,0,T*hh"
        ));
        assert!(!same(
            "$AGALF,2,1,3,,B,A,V,,10101,1,1,0,T*hh",
            "$AGALF,2,2,3,,,,,,10101,1,1,0,T*hh"
        ));
        assert!(!same(
            "$AGALF,2,1,3,,B,A,V,,10101,1,1,0,T*hh",
            "$AGALF,2,1,3,,B,A,V,,10103,1,1,0,T*hh"
        ));
        assert!(!same("$AGALC,02,01,03,0*hh", "$AGALC,02,02,03,0*hh"));
        assert!(same("$AGHBT,30.0,A,1*hh", "$AGHBT,30.0,A,2*hh"));
        assert!(!same("$AGARC,,,10115,1,A*hh", "$AGARC,,,10115,1,O*hh"));
        assert!(slot(b"$AGALR,,012,A,V,*hh").event);
        assert!(!slot(b"$PNEY,002,A*hh").event);
        for line in ["", "$", "$P", "$P,", "$AG", "x", ",,,", "*"] {
            assert!(!slot(line.as_bytes()).event, "{line}");
        }
    }
}
