//! The heading monitor: two compasses compared all the time, whatever steers (AP-10, N tables A.5 and A.6).

use super::mounted;
use crate::limits::Quantity;
use crate::nmea::{DataStatus, Hmr, Hms, LimitStatus, Reference};
use crate::picture::{Bearing, Source};
use crate::post::Seen;
use crate::settings::Settings;
use crate::station::{PortIndex, Profile};
use crate::time::Stamp;
use crate::units::Heading;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Within the limit for so long, the warning ends.
const BACK_MS: u64 = 3_000;

/// A heading sensor of the monitor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Sensor {
    port: PortIndex,
    profile: Profile,
    magnetic: bool,
    /// What it says, while it is valid.
    said: Option<Bearing>,
}

impl Sensor {
    /// As tables A.5 and A.6 call it: GYRO1, GYRO2, THD, MAGN.
    fn name(&self) -> String {
        self.profile.name().to_uppercase()
    }
}

/// Compares two compasses.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct HeadingMonitor {
    sensors: Vec<Sensor>,
    variation: Option<f64>,
    limit: f64,
    /// Until when a difference counts as beyond the limit.
    beyond_until: Option<Stamp>,
    beyond: bool,
    /// What HMS said last, and when.
    told: Option<(Stamp, Hms)>,
}

impl HeadingMonitor {
    /// Looks at the compasses in their order of preference, the one in use first; a difference beyond the limit that is set warns.
    pub(crate) fn look(
        &mut self,
        seen: Seen<'_>,
        in_use: Option<&Source>,
        variation: Option<f64>,
        settings: &Settings,
    ) {
        let (now, picture) = (seen.now, seen.picture);
        let limit = settings.heading_monitor_limit;
        let mut heard: Vec<_> = picture.headings.iter().collect();
        heard.sort_by_key(|heard| (in_use != Some(&heard.source), picture.rank(&heard.source)));
        self.sensors.clear();
        for heard in heard {
            let port = heard.source.port;
            if self.sensors.len() == 2 || self.sensors.iter().any(|known| known.port == port) {
                continue;
            }
            let mounted = |said| mounted::bearing(picture, settings, &heard.source, said);
            if mounted(heard.value).is_none() {
                continue;
            }
            self.sensors.push(Sensor {
                port,
                profile: picture.ports[port].profile,
                magnetic: heard.value.is_magnetic(),
                said: (seen.fresh(Some(heard), Quantity::Heading)).and_then(mounted),
            });
        }
        (self.variation, self.limit) = (variation, limit);
        let apart = self.difference().map(libm::fabs);
        if apart.is_some_and(|apart| apart > limit) {
            self.beyond_until = Some(now + BACK_MS);
        }
        self.beyond = apart.is_some() && self.beyond_until.is_some_and(|until| now < until);
    }

    /// Second less first, degrees; absent without two valid headings of one north.
    fn difference(&self) -> Option<f64> {
        let [first, second] = self.sensors.as_slice() else {
            return None;
        };
        let (first, second) = (first.said?, second.said?);
        let of =
            |of: &dyn Fn(&Bearing) -> Option<Heading>| Some((of(&second)? - of(&first)?).deg());
        let of_true = of(&|said| said.true_heading(self.variation));
        of_true.or_else(|| of(&Bearing::magnetic_heading))
    }

    /// HDG DIFF: the two compasses and how far they are apart, where that is beyond the limit.
    pub(crate) fn warning(&self) -> Option<String> {
        let [first, second] = self.sensors.as_slice() else {
            return None;
        };
        let apart = self.difference().filter(|_| self.beyond)?;
        Some(alloc::format!(
            "{} and {} are {:.1} deg apart, the limit is {:.1}: find out which is right",
            first.name(),
            second.name(),
            libm::fabs(apart),
            self.limit
        ))
    }

    /// What is set (table A.5).
    pub(crate) fn hms(&self) -> Hms {
        let name = |index: usize| self.sensors.get(index).map(Sensor::name);
        Hms {
            sensor_1: name(0),
            sensor_2: name(1),
            limit: Some(self.limit),
        }
    }

    /// Whether HMS is to be said: it has changed, or is `period` milliseconds old. It counts as said then.
    pub(crate) fn hms_is_due(&mut self, now: Stamp, period: u64) -> bool {
        let hms = self.hms();
        let told = self.told.as_ref();
        let due = told.is_none_or(|(at, told)| *told != hms || now.since(*at) >= period);
        if due {
            self.told = Some((now, hms));
        }
        due
    }

    /// What is measured (table A.6); the fields of a sensor that is not there are null.
    pub(crate) fn hmr(&self) -> Hmr {
        let sensor = |index: usize| self.sensors.get(index);
        let reading = |index: usize| Some(sensor(index)?.said?.reading().deg());
        let deviation = |index: usize| sensor(index)?.said?.deviation();
        let status = |index: usize| {
            sensor(index).map(|sensor| match sensor.said {
                Some(_) => DataStatus::Valid,
                None => DataStatus::Invalid,
            })
        };
        let kind = |index: usize| {
            sensor(index).map(|sensor| match sensor.magnetic {
                true => Reference::Magnetic,
                false => Reference::True,
            })
        };
        let Hms {
            sensor_1,
            sensor_2,
            limit,
        } = self.hms();
        Hmr {
            sensor_1,
            sensor_2,
            limit,
            difference: self.difference(),
            warning: Some(match self.beyond {
                true => LimitStatus::Reached,
                false => LimitStatus::Within,
            }),
            heading_1: reading(0),
            status_1: status(0),
            type_1: kind(0),
            deviation_1: deviation(0),
            heading_2: reading(1),
            status_2: status(1),
            type_2: kind(1),
            deviation_2: deviation(1),
            variation: self
                .variation
                .filter(|_| self.sensors.iter().any(|sensor| sensor.magnetic)),
        }
    }
}
