//! Calibration by the hand unit: the IMU at rest, the feedback of the rudder from stop to stop (EMC-2).
//!
//! ```text
//! heel_offset = -mean of the heel that is heard,  rate_offset = -mean of the rate of turn       at least 3 s, the boat at rest
//! tiller_centre = (least + greatest)/2,  rudder_max <= (greatest - least)/2                     at least 20 deg of travel
//! ```

use super::kept::Changes;
use crate::command::Refusal;
use crate::settings::{Settings, Value};
use alloc::format;
use serde::{Deserialize, Serialize};

/// Readings of an IMU that make a mean.
const READINGS: f64 = 30.0;
/// The least travel of a rudder, degrees.
const TRAVEL_DEG: f64 = 20.0;

/// What is calibrated, and what was heard since.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(in super::super) enum Calibration {
    /// The IMU.
    Imu {
        /// Sum and number of the rates, degrees a minute; absent where the gyroscope is left alone.
        rate: Option<(f64, f64)>,
        /// Of the heels, degrees; absent where the accelerometer is left alone.
        heel: Option<(f64, f64)>,
    },
    /// The feedback: the least and the greatest position, degrees.
    Feedback(Option<(f64, f64)>),
}

impl Calibration {
    /// Of the IMU: gyroscope, accelerometer.
    pub(in super::super) fn of_imu(gyro: bool, accelerometer: bool) -> Self {
        Self::Imu {
            rate: gyro.then_some((0.0, 0.0)),
            heel: accelerometer.then_some((0.0, 0.0)),
        }
    }

    /// What it is called.
    pub(in super::super) const fn name(&self) -> &'static str {
        match self {
            Self::Imu { .. } => "calibration of the IMU",
            Self::Feedback(_) => "calibration of the rudder's feedback",
        }
    }

    /// One step: the position of the gear, the heel and the rate of turn as they are heard.
    pub(in super::super) fn look(
        &mut self,
        position: Option<f64>,
        heel_now: Option<f64>,
        rate_now: Option<f64>,
    ) {
        let add = |sum: &mut Option<(f64, f64)>, said: Option<f64>| {
            if let (Some((sum, number)), Some(said)) = (sum, said) {
                (*sum, *number) = (*sum + said, *number + 1.0);
            }
        };
        match (self, position) {
            (Self::Imu { rate, heel }, _) => {
                add(heel, heel_now);
                add(rate, rate_now);
            }
            (Self::Feedback(ends), Some(at)) => {
                let (least, greatest) = ends.unwrap_or((at, at));
                *ends = Some((least.min(at), greatest.max(at)));
            }
            (Self::Feedback(_), None) => {}
        }
    }

    /// What was found, as settings.
    ///
    /// # Errors
    /// Too little was heard.
    pub(in super::super) fn found(&self, settings: &Settings) -> Result<Changes, Refusal> {
        match *self {
            Self::Imu { rate, heel } => {
                let named = [("rate_offset", rate), ("heel_offset", heel)];
                let means = named.into_iter().filter_map(|(name, sum)| {
                    let (sum, number) = sum.filter(|(_, number)| *number >= READINGS)?;
                    Some((name, Value::Number(-sum / number)))
                });
                let means: Changes = means.collect();
                if means.is_empty() {
                    return Err(Refusal::because("no heel and no rate of turn for 3 s"));
                }
                Ok(means)
            }
            Self::Feedback(ends) => {
                let (least, greatest) = ends.unwrap_or_default();
                let travel = greatest - least;
                if travel < TRAVEL_DEG {
                    let text =
                        format!("the rudder travelled {travel:.1} deg, {TRAVEL_DEG} are needed");
                    return Err(Refusal::because(text));
                }
                let most = settings.rudder_max.min(libm::floor(travel / 2.0));
                let limit = settings.rudder_limit.min(most);
                let centre = libm::round((least + greatest) * 5.0) / 10.0;
                Ok(alloc::vec![
                    ("tiller_centre", Value::Number(centre)),
                    ("rudder_limit", Value::Number(limit)),
                    ("rudder_max", Value::Number(most)),
                ])
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_imu_at_rest_has_its_means_as_offsets() {
        let found = |gyro, accelerometer, readings| {
            let mut calibration = Calibration::of_imu(gyro, accelerometer);
            for step in 0..readings {
                let heel = if step % 2 == 0 { 3.0 } else { 5.0 };
                calibration.look(None, Some(heel), Some(-12.0));
            }
            calibration.found(&Settings::default())
        };
        let rate = ("rate_offset", Value::Number(12.0));
        let heel = ("heel_offset", Value::Number(-4.0));
        assert_eq!(
            found(true, true, 30),
            Ok(alloc::vec![rate.clone(), heel.clone()])
        );
        assert_eq!(found(true, false, 30), Ok(alloc::vec![rate]));
        assert_eq!(found(false, true, 30), Ok(alloc::vec![heel]));
        assert!(found(true, true, 29).is_err());
    }

    #[test]
    fn the_middle_of_the_travel_is_the_centre() {
        let found = |ends: &[f64]| {
            let mut calibration = Calibration::Feedback(None);
            for at in ends {
                calibration.look(Some(*at), None, None);
            }
            calibration.found(&Settings::default())
        };
        let numbers = |found: Changes| found.into_iter().map(|(_, value)| value);
        let all: alloc::vec::Vec<_> = numbers(found(&[0.0, -28.0, 3.0, 34.0]).unwrap()).collect();
        assert_eq!(all, [3.0, 20.0, 31.0].map(Value::Number));
        assert!(found(&[0.0, 19.0]).is_err() && found(&[]).is_err());
    }
}
