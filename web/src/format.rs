//! Every number on the page is written here: declared decimals, sides as letters, unknown as dashes.

use core::fmt::{self, Display, Formatter};
use wheelover_core::geo::Position;
use wheelover_core::units::METRES_PER_NAUTICAL_MILE;

/// What stands for an unknown angle.
pub const NO_ANGLE: &str = "---.-";
/// What stands for an unknown number with a side.
pub const NO_SIDED: &str = "- --";
/// What stands for an unknown speed.
pub const NO_SPEED: &str = "--.-";
/// What stands for an unknown time.
pub const NO_TIME: &str = "--:--";
/// What stands for an unknown text.
pub const NO_TEXT: &str = "---";

/// A number with a fixed count of decimals, rounded (a tie away from zero), never `-0`; written without any float formatting,
/// which is a good part of what a page would weigh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fixed {
    negative: bool,
    scaled: u64,
    whole: usize,
    decimals: usize,
}

/// `value` with `decimals`, 0 to 6.
#[must_use]
pub fn fixed(value: f64, decimals: usize) -> Fixed {
    padded(value, 1, decimals)
}

/// `value` with at least `whole` digits before the point and `decimals` behind it.
#[must_use]
pub fn padded(value: f64, whole: usize, decimals: usize) -> Fixed {
    const TENS: [f64; 7] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6];
    let decimals = decimals.min(6);
    let scaled = libm::round(libm::fabs(value) * TENS[decimals]) as u64;
    Fixed {
        negative: value < 0.0 && scaled != 0,
        scaled,
        whole,
        decimals,
    }
}

/// `value` with two decimals at most, without zeros behind the last digit that counts: `0.75`, `1.5`, `6`.
#[must_use]
pub fn short(value: f64) -> String {
    let text = fixed(value, 2).to_string();
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

impl Fixed {
    /// Whether it reads as zero.
    #[must_use]
    pub const fn is_zero(self) -> bool {
        self.scaled == 0
    }
}

impl Display for Fixed {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let one = 10_u64.pow(self.decimals as u32);
        let (whole, part) = (self.scaled / one, self.scaled % one);
        let (digits, decimals) = (self.whole, self.decimals);
        if self.negative {
            f.write_str("-")?;
        }
        write!(f, "{whole:0digits$}")?;
        if decimals > 0 {
            write!(f, ".{part:0decimals$}")?;
        }
        Ok(())
    }
}

/// A direction with one decimal, three digits before it: `009.5`; never `360.0`.
#[must_use]
pub fn direction(degrees: Option<f64>) -> String {
    match degrees {
        Some(degrees) => {
            let tenths = libm::round(degrees * 10.0);
            let wrapped = tenths - 3600.0 * libm::floor(tenths / 3600.0);
            padded(wrapped / 10.0, 3, 1).to_string()
        }
        None => NO_ANGLE.to_owned(),
    }
}

/// A speed in knots with one decimal.
#[must_use]
pub fn speed(knots: Option<f64>) -> String {
    knots.map_or_else(|| NO_SPEED.to_owned(), |knots| fixed(knots, 1).to_string())
}

/// A signed value with its side as a letter: `S 8.2`, `P 0.4`; zero has no side.
#[must_use]
pub fn sided(value: Option<f64>, decimals: usize) -> String {
    let Some(value) = value else {
        return NO_SIDED.to_owned();
    };
    let number = fixed(libm::fabs(value), decimals);
    if number.is_zero() {
        number.to_string()
    } else if value > 0.0 {
        format!("S {number}")
    } else {
        format!("P {number}")
    }
}

/// A distance: miles with two decimals, from ten miles with one.
#[must_use]
pub fn miles(metres: Option<f64>) -> String {
    match metres.map(|metres| metres / METRES_PER_NAUTICAL_MILE) {
        Some(miles) if miles < 9.995 => fixed(miles, 2).to_string(),
        Some(miles) => fixed(miles, 1).to_string(),
        None => "-.--".to_owned(),
    }
}

/// A radius in nautical miles with two decimals; `- -` on a straight leg (DSP-1).
#[must_use]
pub fn radius(miles: Option<f64>) -> String {
    miles.map_or_else(|| "- -".to_owned(), |miles| fixed(miles, 2).to_string())
}

/// Latitude and longitude in degrees and minutes with three decimals.
#[must_use]
pub fn position(position: Option<Position>) -> (String, String) {
    match position {
        Some(Position { lat, lon }) => (
            angle(lat, 2, if lat < 0.0 { 'S' } else { 'N' }),
            angle(lon, 3, if lon < 0.0 { 'W' } else { 'E' }),
        ),
        None => ("--°--.---′".to_owned(), "---°--.---′".to_owned()),
    }
}

fn angle(degrees: f64, digits: usize, side: char) -> String {
    let thousandths = libm::round(libm::fabs(degrees) * 60_000.0) as u64;
    let (whole, minutes) = (thousandths / 60_000, thousandths % 60_000);
    let minutes = padded(minutes as f64 / 1000.0, 2, 3);
    format!("{whole:0digits$}°{minutes}′{side}")
}

/// A span of time as minutes and seconds, or hours, minutes and seconds.
#[must_use]
pub fn span(seconds: Option<f64>) -> String {
    let Some(seconds) = seconds.filter(|seconds| seconds.is_finite()) else {
        return NO_TIME.to_owned();
    };
    let whole = libm::round(libm::fabs(seconds)) as u64;
    let (hours, minutes, seconds) = (whole / 3600, whole / 60 % 60, whole % 60);
    if hours > 0 {
        format!("{hours}:{minutes:02}:{seconds:02}")
    } else {
        format!("{minutes}:{seconds:02}")
    }
}

/// A time of day from its seconds since midnight.
#[must_use]
pub fn clock(seconds_of_day: Option<f64>) -> String {
    match seconds_of_day {
        Some(seconds) => {
            let day = seconds - 86_400.0 * libm::floor(seconds / 86_400.0);
            let whole = libm::floor(day) as u64;
            format!(
                "{:02}:{:02}:{:02}",
                whole / 3600,
                whole / 60 % 60,
                whole % 60
            )
        }
        None => "--:--:--".to_owned(),
    }
}

/// A time of day without its seconds.
#[must_use]
pub fn clock_minutes(seconds_of_day: Option<f64>) -> String {
    let mut text = clock(seconds_of_day);
    text.truncate(5);
    text
}

/// An age: tenths below ten seconds, then seconds, then minutes.
#[must_use]
pub fn age(milliseconds: u64) -> String {
    match milliseconds {
        0..10_000 => format!("{} s", fixed(milliseconds as f64 / 1000.0, 1)),
        10_000..120_000 => format!("{} s", milliseconds / 1000),
        _ => format!("{} min", milliseconds / 60_000),
    }
}

/// A whole number of seconds, for badges.
#[must_use]
pub fn seconds(milliseconds: u64) -> String {
    match milliseconds {
        0..120_000 => format!("{} s", milliseconds / 1000),
        _ => format!("{} min", milliseconds / 60_000),
    }
}

/// The first three characters of a waypoint's identifier (TCS-5).
#[must_use]
pub fn waypoint(identifier: Option<&str>) -> String {
    match identifier {
        Some(text) if !text.is_empty() => text.chars().take(3).collect(),
        _ => NO_TEXT.to_owned(),
    }
}

/// Heading of the cross-track panel and of its second distance: only on the radius does XTE refer to the arc and PNEY,001
/// to the next leg; on the forwarding distance both still refer to the leg (interface.md 4, situations 3 and 4).
#[must_use]
pub const fn cross_track_words(situation: Option<u8>) -> (&'static str, &'static str) {
    match situation {
        Some(4) => ("XTD m (to radius)", "next leg "),
        _ => ("XTD m", "control "),
    }
}

/// What the top bar says under track control and under remote heading control, which has courses and no legs (DSP-1, DSP-2).
#[must_use]
pub fn headline(remote: bool, turn: Option<&str>, track: f64, waypoint: &str) -> (String, String) {
    let track = direction(Some(track));
    match (turn, remote) {
        (Some(side), true) => (format!("TURN {side}"), format!("to course {track}°")),
        (Some(side), false) => (
            format!("TURN {side}"),
            format!("at WP {waypoint} → {track}°"),
        ),
        (None, true) => (format!("COURSE {track}°"), String::new()),
        (None, false) => (format!("LEG {track}°"), format!("to WP {waypoint}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_round_and_lose_their_sign_with_their_digits() {
        assert_eq!(fixed(-0.04, 1).to_string(), "0.0");
        assert_eq!(fixed(-0.25, 1).to_string(), "-0.3");
        assert_eq!(fixed(1234.5678, 3).to_string(), "1234.568");
        assert_eq!(padded(9.5, 3, 1).to_string(), "009.5");
        assert_eq!(
            [0.75, 1.5, 6.0, 10.0].map(short),
            ["0.75", "1.5", "6", "10"]
        );
    }

    #[test]
    fn a_direction_never_reads_360() {
        let check = |degrees, expect: &str| assert_eq!(direction(degrees), expect);
        check(Some(9.5), "009.5");
        check(Some(359.96), "000.0");
        check(Some(0.0), "000.0");
        check(Some(-0.01), "000.0");
        check(None, "---.-");
    }

    #[test]
    fn a_side_is_a_letter_and_zero_has_none() {
        let check = |value, decimals, expect: &str| assert_eq!(sided(value, decimals), expect);
        check(Some(8.24), 1, "S 8.2");
        check(Some(-8.26), 1, "P 8.3");
        check(Some(-0.04), 1, "0.0");
        check(Some(37.4), 0, "S 37");
        check(None, 1, "- --");
    }

    #[test]
    fn minutes_of_a_position_stay_below_sixty() {
        let (lat, lon) = position(Some(Position {
            lat: 53.999_999_9,
            lon: -12.760_583,
        }));
        assert_eq!(lat, "54°00.000′N");
        assert_eq!(lon, "012°45.635′W");
        assert_eq!(position(None).0, "--°--.---′");
    }

    #[test]
    fn spans_and_ages() {
        assert_eq!(span(Some(42.4)), "0:42");
        assert_eq!(span(Some(3_725.0)), "1:02:05");
        assert_eq!(span(Some(f64::INFINITY)), "--:--");
        assert_eq!(age(400), "0.4 s");
        assert_eq!(age(14_200), "14 s");
        assert_eq!(clock(Some(86_399.9)), "23:59:59");
        assert_eq!(clock_minutes(None), "--:--");
    }

    #[test]
    fn unknown_is_dashes_never_zero() {
        assert_eq!(speed(None), "--.-");
        assert_eq!(miles(None), "-.--");
        assert_eq!(radius(None), "- -");
        assert_eq!(waypoint(Some("")), "---");
        assert_eq!(waypoint(Some("HAMBURG")), "HAM");
    }

    #[test]
    fn words_say_what_a_distance_and_a_turn_refer_to() {
        for straight in [None, Some(1), Some(2), Some(3), Some(5), Some(6)] {
            assert_eq!(cross_track_words(straight).0, "XTD m", "{straight:?}");
        }
        assert_eq!(
            cross_track_words(Some(4)),
            ("XTD m (to radius)", "next leg ")
        );
        let check = |remote, turn, expect: (&str, &str)| {
            let (headline, detail) = headline(remote, turn, 330.0, "HAM");
            assert_eq!((headline.as_str(), detail.as_str()), expect);
        };
        check(true, Some("PORT"), ("TURN PORT", "to course 330.0°"));
        check(true, None, ("COURSE 330.0°", ""));
        check(false, Some("STBD"), ("TURN STBD", "at WP HAM → 330.0°"));
        check(false, None, ("LEG 330.0°", "to WP HAM"));
    }
}
