//! Which settings the hand unit saves by which letter of 11, and what it restores (EMC-2, EMC-7).

use crate::settings::{Settings, Value};
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Settings by their names.
pub(in super::super) type Changes = Vec<(&'static str, Value)>;

/// Settings that are kept together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(in super::super) enum Kept {
    /// I: installation and feedback.
    Installation,
    /// G: gains.
    Gains,
    /// C: offsets of the IMU.
    Offsets,
}

impl Kept {
    const fn names(self) -> &'static [&'static str] {
        match self {
            Self::Installation => &[
                "tiller_centre",
                "rudder_max",
                "rudder_limit",
                "cruise_speed",
                "tiller_side",
                "rudder_damping",
                "variation",
                "heading_alignment",
                "off_heading_limit",
            ],
            Self::Gains => &[
                "heading_law",
                "pid_kp",
                "pid_ki",
                "pid_kd",
                "sample_time",
                "dead_band",
            ],
            Self::Offsets => &["heel_offset", "rate_offset"],
        }
    }

    /// What they are.
    pub(in super::super) fn values(self, settings: &Settings) -> Vec<(String, Value)> {
        let mut values = settings.values();
        values.retain(|(name, _)| self.names().contains(&name.as_str()));
        values
    }
}

/// The defaults of installation and gains; the law that steers stays.
pub(in super::super) fn defaults() -> Changes {
    let defaults = Settings::default().values();
    let names = [Kept::Installation, Kept::Gains].map(Kept::names);
    let names = names
        .into_iter()
        .flatten()
        .filter(|name| **name != "heading_law");
    names
        .filter_map(|name| {
            let (_, value) = defaults.iter().find(|(known, _)| known == name)?;
            Some((*name, value.clone()))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_a_setting() {
        let settings = Settings::default();
        for kept in [Kept::Installation, Kept::Gains, Kept::Offsets] {
            assert_eq!(kept.values(&settings).len(), kept.names().len(), "{kept:?}");
        }
        assert_eq!(defaults().len(), 14);
    }
}
