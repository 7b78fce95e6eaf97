//! What a line has to carry, and how much of it may be used (FB12).

use super::share::{alert_share, line_rate};
use super::table::{Row, When, told};
use crate::station::{Profile, Role};
use alloc::vec::Vec;
use core::fmt;

/// Part of the line rate that may be used, per cent.
const HIGHEST: u64 = 80;
/// A person does not acknowledge more often in the long run, seconds.
const ASKED_S: f64 = 10.0;

/// The load of a line, each sentence in its longest form.
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    line: u64,
    terms: Vec<(&'static Row, f64)>,
}

/// What a station puts on a line of a port: its control steps a second, the rate in baud.
#[must_use]
pub fn load(station: Role, profile: Profile, step_hz: f64, baud: u32) -> Load {
    let mut share = alert_share(baud) as f64;
    let bytes = |row: &'static Row| {
        let longest = row.saying.definition().longest() as f64;
        let rate = match row.when {
            When::Every(period) | When::Renewed(period) => longest * 1000.0 / period as f64,
            When::Step => longest * step_hz,
            // Together: it stands at the first of them.
            When::Change => core::mem::take(&mut share),
            When::Asked | When::Requested | When::Operated => longest / ASKED_S,
        };
        (row, rate)
    };
    Load {
        line: line_rate(baud),
        terms: told(station, profile).iter().map(bytes).collect(),
    }
}

impl Load {
    /// Bytes a second.
    #[must_use]
    pub fn sum(&self) -> f64 {
        self.terms.iter().map(|(_, bytes)| bytes).sum()
    }

    /// Per cent of the line.
    #[must_use]
    pub fn percent(&self) -> f64 {
        100.0 * self.sum() / self.line.max(1) as f64
    }

    /// Whether it is more than a line may carry.
    #[must_use]
    pub fn is_too_much(&self) -> bool {
        self.percent() > HIGHEST as f64
    }
}

/// The sum with its terms, the rate of the line and how much is allowed.
impl fmt::Display for Load {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (row, bytes)) in self.terms.iter().enumerate() {
            let plus = if index == 0 { "" } else { " + " };
            let longest = row.saying.definition().longest();
            match row.when {
                When::Change if *bytes > 0.0 => write!(f, "{plus}{} {bytes}", row.formatter())?,
                When::Change => write!(f, "{plus}{} within it", row.formatter())?,
                When::Every(_)
                | When::Renewed(_)
                | When::Step
                | When::Asked
                | When::Requested
                | When::Operated => {
                    let times = libm::round(bytes / longest as f64 * 100.0) / 100.0;
                    write!(f, "{plus}{} {longest} x {times}", row.formatter())?;
                }
            }
        }
        write!(
            f,
            " = {} bytes a second, {:.0} % of the {} that {} baud carry; at most {HIGHEST} % are allowed",
            self.sum(),
            self.percent(),
            self.line,
            self.line * 10,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::ToString;

    #[test]
    fn alert_reports_are_in_the_sum_by_the_rate_of_the_line() {
        let check = |baud, text: &str| {
            let load = load(Role::Autopilot, Profile::Ecdis, 10.0, baud);
            assert!(load.to_string().contains(text), "{load}");
            assert!(!load.is_too_much(), "{load}");
        };
        check(4_800, "ALR 129 + ALA within it = ");
        check(38_400, "ALR 1036 + ALA within it = ");
    }

    #[test]
    fn what_is_said_each_step_follows_the_step() {
        let gear = |step_hz| load(Role::Autopilot, Profile::Gear, step_hz, 4_800);
        assert_eq!(gear(10.0).sum() * 2.0, gear(20.0).sum());
        assert!(!gear(10.0).is_too_much() && gear(20.0).is_too_much());
    }

    #[test]
    fn a_chart_system_fits_on_the_slow_line() {
        let load = load(Role::ChartSystem, Profile::Ecdis, 10.0, 4_800);
        assert!(!load.is_too_much(), "{load}");
    }
}
