//! A bar with zero in its middle: where a value stands, what is filled, how it is drawn.

use crate::drawing::Drawing;
use crate::format::fixed;

/// The bar's picture: left, top, width and height in its own units.
pub const VIEW: &str = "0 0 396 66";
/// That of two bars, one under the other.
const VIEW_OF_TWO: &str = "0 0 396 118";
/// Where the bar begins and ends.
pub const ENDS: (f64, f64) = (28.0, 368.0);

/// Where the letter of a bar's side stands, of two.
const LETTER: (f64, f64) = (6.0, 31.0);

/// Where `value` stands on a bar that ends at plus and minus `full`; beyond it, at the end.
#[must_use]
pub fn place(value: f64, full: f64) -> f64 {
    let part = libm::fmax(libm::fmin(value / full, 1.0), -1.0);
    (ENDS.0 + ENDS.1) / 2.0 + part * (ENDS.1 - ENDS.0) / 2.0
}

/// Left edge and width of the filled part.
#[must_use]
pub fn fill(value: f64, full: f64) -> (f64, f64) {
    let (zero, end) = (place(0.0, full), place(value, full));
    (libm::fmin(zero, end), libm::fabs(end - zero))
}

/// The scale that holds `value`: the first of the steps that is large enough.
#[must_use]
pub fn full_scale(value: f64, steps: &[f64]) -> f64 {
    let fits = steps
        .iter()
        .copied()
        .find(|step| libm::fabs(value) <= *step);
    fits.or_else(|| steps.last().copied()).unwrap_or(1.0)
}

/// Whether a cross-track distance is beyond its limits (metres to port and to starboard), and the words for them.
#[must_use]
pub fn corridor(value: Option<f64>, limits: Option<[f64; 2]>) -> (bool, String) {
    let Some([port, stbd]) = limits else {
        return (false, String::new());
    };
    let over = value.is_some_and(|value| value < -port || value > stbd);
    let mark = if over { "OVER " } else { "" };
    let words = if libm::fabs(port - stbd) < 0.5 {
        format!("{mark}limit {}", fixed(port, 0))
    } else {
        format!("{mark}limits P {} S {}", fixed(port, 0), fixed(stbd, 0))
    };
    (over, words)
}

/// Lines of the scale as one path, `count` to each side, under the bar.
#[must_use]
pub fn ticks(count: u32) -> String {
    let mut path = String::new();
    for index in 0..=2 * count {
        let x = ENDS.0 + (ENDS.1 - ENDS.0) * f64::from(index) / f64::from(2 * count);
        let x = fixed(x, 1);
        let long = if (index % 2) == (count % 2) { 10 } else { 6 };
        path.push_str(&format!("M{x} 40v{long}"));
    }
    path
}

/// What a bar shows. Without a value nothing is filled and no pointer rests at zero; the scale stays.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bar {
    /// What is, filled from zero.
    pub value: Option<f64>,
    /// What is ordered, a pointer.
    pub order: Option<f64>,
    /// The scale's end on both sides.
    pub full: f64,
    /// A limit on both sides.
    pub limit: Option<f64>,
    /// The value is beyond its limit: it has no side's colour.
    pub over: bool,
    /// Words under its middle.
    pub note: String,
    /// What is and what is ordered on a second bar, to port of this one (DSP-3).
    pub port: Option<[Option<f64>; 2]>,
}

impl Bar {
    /// The picture's edges in its own units.
    #[must_use]
    pub fn view(&self) -> &'static str {
        match self.port {
            None => VIEW,
            Some(_) => VIEW_OF_TWO,
        }
    }

    /// The bar as the inside of an SVG element, with `count` lines of its scale to each side.
    #[must_use]
    pub fn markup(&self, count: u32) -> String {
        let mut drawing = Drawing::new();
        self.draw(&mut drawing, [self.value, self.order], count);
        if let Some(port) = self.port {
            drawing.word("strong", "start", LETTER, "S");
            drawing.plain("<g transform=\"translate(0 52)\">");
            drawing.word("strong", "start", LETTER, "P");
            self.draw(&mut drawing, port, count);
        }
        let end = fixed(self.full, 0);
        drawing.word("strong", "start", (ENDS.0, 63.0), end);
        drawing.word("strong", "end", (ENDS.1, 63.0), end);
        drawing.word("note", "middle", (place(0.0, 1.0), 63.0), &self.note);
        if self.port.is_some() {
            drawing.plain("</g>");
        }
        drawing.markup()
    }

    fn draw(&self, drawing: &mut Drawing, [value, order]: [Option<f64>; 2], count: u32) {
        drawing.bar("rail", ENDS.0, ENDS.1 - ENDS.0);
        if let Some(value) = value {
            let (left, width) = fill(value, self.full);
            let class = match value >= 0.0 {
                _ if self.over => "over",
                true => "stbd",
                false => "port",
            };
            drawing.bar(class, left, width);
        }
        if let Some(limit) = self.limit {
            let (port, stbd) = (place(-limit, self.full), place(limit, self.full));
            let (port, stbd) = (fixed(port, 1), fixed(stbd, 1));
            drawing.path("limit", "", &format!("M{port} 9v34M{stbd} 9v34"));
        }
        let zero = place(0.0, 1.0);
        drawing.path("zero", "", &format!("M{} 8v36", fixed(zero, 1)));
        if let Some(order) = order {
            let left = fixed(place(order, self.full) - 9.0, 1);
            drawing.path("order", "", &format!("M{left} 0h18l-9 13z"));
        }
        drawing.path("tick", "", &ticks(count));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_value_the_scale_stays_and_nothing_rests_at_zero() {
        let bar = Bar {
            full: 35.0,
            ..Bar::default()
        };
        let empty = bar.markup(7);
        assert!(empty.contains("class=\"rail\"") && empty.contains(">35</text>"));
        assert!(
            !empty.contains("stbd") && !empty.contains("order"),
            "{empty}"
        );
        let port = Bar {
            value: Some(-3.0),
            order: Some(0.0),
            ..bar
        };
        let drawn = port.markup(7);
        assert!(drawn.contains("class=\"port\"") && drawn.contains("class=\"order\""));
        let over = Bar { over: true, ..port }.markup(7);
        assert!(over.contains("class=\"over\"") && !over.contains("class=\"port\""));
    }

    // DSP-3
    #[test]
    fn a_pair_of_rudders_has_two_scales_and_a_lost_one_stays_empty() {
        let single = Bar {
            value: Some(4.0),
            order: Some(5.0),
            full: 35.0,
            limit: Some(20.0),
            ..Bar::default()
        };
        let count = |bar: &Bar, what: &str| bar.markup(7).matches(what).count();
        let pair = |port| Bar {
            port: Some(port),
            ..single.clone()
        };
        let both = pair([Some(-3.0), Some(5.0)]);
        for (what, of_single, of_pair) in [
            ("class=\"rail\"", 1, 2),
            ("class=\"limit\"", 1, 2),
            ("class=\"order\"", 1, 2),
            ("class=\"stbd\"", 1, 1),
            ("class=\"port\"", 0, 1),
            (">S</text>", 0, 1),
            (">P</text>", 0, 1),
            (">35</text>", 2, 2),
        ] {
            assert_eq!(
                (count(&single, what), count(&both, what)),
                (of_single, of_pair),
                "{what}"
            );
        }
        let lost = pair([None, Some(5.0)]);
        assert_eq!(
            (
                count(&lost, "class=\"port\""),
                count(&lost, "class=\"order\"")
            ),
            (0, 2)
        );
        assert_ne!(single.view(), both.view());
    }

    #[test]
    fn beyond_its_limit_a_distance_says_so() {
        let check = |value, limits, expect: (bool, &str)| {
            let (over, words) = corridor(value, limits);
            assert_eq!((over, words.as_str()), expect);
        };
        check(Some(9.0), None, (false, ""));
        check(None, Some([185.2; 2]), (false, "limit 185"));
        check(Some(185.0), Some([185.2; 2]), (false, "limit 185"));
        check(Some(-186.0), Some([185.2; 2]), (true, "OVER limit 185"));
        check(
            Some(60.0),
            Some([100.0, 50.0]),
            (true, "OVER limits P 100 S 50"),
        );
        check(
            Some(-60.0),
            Some([100.0, 50.0]),
            (false, "limits P 100 S 50"),
        );
    }

    #[test]
    fn starboard_is_right_and_nothing_leaves_the_bar() {
        assert!((place(0.0, 35.0) - 198.0).abs() < 1e-9);
        assert!((place(35.0, 35.0) - 368.0).abs() < 1e-9);
        assert!((place(-90.0, 35.0) - 28.0).abs() < 1e-9);
        let (left, width) = fill(-35.0, 35.0);
        assert!((left - 28.0).abs() < 1e-9 && (width - 170.0).abs() < 1e-9);
    }

    #[test]
    fn the_scale_grows_with_the_value() {
        assert_eq!(full_scale(12.0, &[30.0, 60.0]), 30.0);
        assert_eq!(full_scale(-31.0, &[30.0, 60.0]), 60.0);
        assert_eq!(full_scale(400.0, &[30.0, 60.0]), 60.0);
    }
}
