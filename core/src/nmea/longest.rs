//! How long a sentence can be on the wire, by its table (SEN-1).

use super::table::{Definition, Format, Kind};

/// Characters of a line at most, with CR LF (SEN-1).
pub(super) const LONGEST: usize = 82;
/// Digits before the point where the standard sets no limit; from pole to pole it is 10,800 miles.
const UNLIMITED: usize = 5;
/// `*hh`, CR and LF.
const END: usize = 5;

impl Definition {
    /// Bytes of its longest form as it is sent, with checksum, CR and LF; one with repeated fields fills the line.
    #[must_use]
    pub const fn longest(&self) -> usize {
        if self.group.is_some() {
            return LONGEST;
        }
        let talker = if self.first() == 0 { 2 } else { 0 };
        let mut sum = 1 + talker + self.formatter.len() + END;
        let (mut i, mut fields) = (0, self.first());
        // Members of later editions are not sent.
        while i < self.members.len() && fields < self.sent() {
            fields += self.members[i].width();
            // A comma before each field.
            sum += self.members[i].width() + contents(&self.members[i]);
            i += 1;
        }
        if sum < LONGEST { sum } else { LONGEST }
    }
}

/// Characters of a member without its commas.
const fn contents(kind: &Kind) -> usize {
    match kind {
        Kind::Number(format) | Kind::Integer(format) => sign(format) + digits(format),
        Kind::Lettered(format, _) => sign(format) + digits(format) + 1,
        Kind::Sided(format, _) => digits(format) + 1,
        Kind::Crossed(format, _, _) => digits(format) + 2,
        Kind::Code(_) => 1,
        Kind::Text(most) | Kind::Letters(_, most) => *most as usize,
        // ddmm.mmm, N, dddmm.mmm, E
        Kind::Position(decimals) => 13 + 2 * *decimals as usize,
        Kind::Angle { degrees, decimals } => *degrees as usize + 4 + *decimals as usize,
        Kind::Time => 9, // hhmmss.ss
        Kind::Date => 6,
        Kind::Hex(digits) => *digits as usize,
        Kind::Words(_) | Kind::Payload | Kind::Any => LONGEST,
    }
}

const fn sign(format: &Format) -> usize {
    (format.low < 0) as usize
}

/// Digits and point of a number.
const fn digits(format: &Format) -> usize {
    let mut whole = 1;
    if format.high == i32::MAX {
        whole = UNLIMITED;
    } else {
        let (low, high) = (format.low.unsigned_abs(), format.high.unsigned_abs());
        let mut rest = if low > high { low } else { high } / 10;
        while rest > 0 {
            whole += 1;
            rest /= 10;
        }
    }
    if whole < format.whole as usize {
        whole = format.whole as usize;
    }
    let decimals = format.decimals as usize;
    whole + decimals + (decimals > 0) as usize
}

#[cfg(test)]
mod tests {
    use super::super::tables::{gll, hdt, pney2, ror, rot, vdm};
    use super::*;

    #[test]
    fn the_longest_form_is_counted_with_its_line_end() {
        let check = |definition: &Definition, line: &str| {
            assert_eq!(definition.longest(), line.len() + 2, "{line}");
        };
        check(&hdt::DEFINITION, "$HEHDT,360.0,T*hh");
        check(&rot::DEFINITION, "$HEROT,-9999.9,A*hh");
        check(&ror::DEFINITION, "$AGROR,-180.0,A,-180.0,A,B*hh");
        check(
            &pney2::DEFINITION,
            "$PNEY,002,8959.9999,N,17959.9999,E,ABCDEFGHIJKLMNOPQRST*hh",
        );
        assert!(gll::DEFINITION.longest() < LONGEST);
        assert_eq!(vdm::DEFINITION.longest(), LONGEST);
    }
}
