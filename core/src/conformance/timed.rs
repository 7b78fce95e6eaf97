//! The time and direction that a recorded line may carry (CLI-3).

use crate::station::Direction;

/// A recorded line in its parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timed<'a> {
    /// Seconds, of the TAG block or before the line.
    pub at: Option<f64>,
    /// As the autopilot sees it: `<` to it, `>` from it.
    pub dir: Option<Direction>,
    /// The sentence, with its TAG block.
    pub text: &'a [u8],
}

/// Reads `12.250 < $EIHTC…`, `12.250 > $AGHTD…`, `\c:1700000000*hh\$EIHTC…`, or a bare line.
///
/// The time of a TAG block is in seconds, seconds with decimals, or milliseconds (from 10^11 on).
#[must_use]
pub fn timed(line: &[u8]) -> Timed<'_> {
    let line = line.trim_ascii();
    let mut parts = Timed {
        at: None,
        dir: None,
        text: line,
    };
    if let Some((at, dir, text)) = marked(line) {
        parts = Timed {
            at,
            dir: Some(dir),
            text,
        };
    }
    if let Some(at) = tag_time(parts.text) {
        parts.at = parts.at.or(Some(at));
    }
    parts
}

fn marked(line: &[u8]) -> Option<(Option<f64>, Direction, &[u8])> {
    let sign = line
        .iter()
        .position(|byte| matches!(byte, b'<' | b'>' | b'$' | b'!' | b'\\'))?;
    let dir = match line.get(sign)? {
        b'<' => Direction::In,
        b'>' => Direction::Out,
        _ => return None,
    };
    let before = line.get(..sign)?.trim_ascii();
    let at = if before.is_empty() {
        None
    } else {
        Some(number(before)?)
    };
    Some((at, dir, line.get(sign + 1..)?.trim_ascii()))
}

fn tag_time(text: &[u8]) -> Option<f64> {
    let block = text.strip_prefix(b"\\")?;
    let block = block.get(..block.iter().position(|byte| *byte == b'\\')?)?;
    let block = block.split(|byte| *byte == b'*').next()?;
    let field = block
        .split(|byte| *byte == b',')
        .find_map(|field| field.strip_prefix(b"c:"))?;
    let at = number(field)?;
    Some(if at >= 1e11 { at / 1000.0 } else { at })
}

fn number(text: &[u8]) -> Option<f64> {
    let value: f64 = core::str::from_utf8(text).ok()?.trim().parse().ok()?;
    (value.is_finite() && value >= 0.0).then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_form_of_a_recorded_line_is_read() {
        let check = |line: &str, at, dir, text: &str| {
            let expect = Timed {
                at,
                dir,
                text: text.as_bytes(),
            };
            assert_eq!(timed(line.as_bytes()), expect, "{line}");
        };
        let (to, from) = (Some(Direction::In), Some(Direction::Out));
        check("12.250 < $EIHTC,V", Some(12.25), to, "$EIHTC,V");
        check("12.250 > $AGHTD,V\r\n", Some(12.25), from, "$AGHTD,V");
        check("< $EIHTC,V", None, to, "$EIHTC,V");
        check("$EIHTC,V", None, None, "$EIHTC,V");
        let tagged = "\\c:1700000000*5E\\$EIHTC,V";
        check(tagged, Some(1_700_000_000.0), None, tagged);
        let tagged = "\\s:x,c:1700000000250*5E\\$EIHTC,V";
        check(tagged, Some(1_700_000_000.25), None, tagged);
        check("x < $EIHTC,V", None, None, "x < $EIHTC,V");
        check("", None, None, "");
    }
}
