//! Geometry of a bar with zero in its middle: where a value stands, what is filled.

/// Width of the bar's picture, its own units.
pub const WIDTH: f64 = 396.0;
/// Where the bar begins and ends.
pub const ENDS: (f64, f64) = (28.0, 368.0);

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

/// Lines of the scale as one path, `count` to each side, under the bar.
#[must_use]
pub fn ticks(count: u32) -> String {
    let mut path = String::new();
    for index in 0..=2 * count {
        let x = ENDS.0 + (ENDS.1 - ENDS.0) * f64::from(index) / f64::from(2 * count);
        let long = if (index % 2) == (count % 2) {
            10.0
        } else {
            6.0
        };
        path.push_str(&format!("M{x:.1} 40v{long}"));
    }
    path
}

#[cfg(test)]
mod tests {
    use super::*;

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
