//! The autopilot's own facts, for the page.

use super::{Autopilot, Mode};
use crate::station::Profile;
use crate::stream::{ModeName, Own, Pending};
use crate::time::Stamp;
use crate::units::{Distance, Heading, RudderAngle};
use alloc::string::{String, ToString};
use alloc::vec::Vec;

impl Autopilot {
    /// Own facts for the page.
    #[must_use]
    pub fn own(&self, now: Stamp) -> Own {
        let steered = self.steered.as_ref();
        Own {
            mode: self.mode.name(),
            why: self.why.clone(),
            pending: self.pending.map(|until| Pending {
                request: ModeName::AutonavTi,
                until: until.0,
                waits_for: self.waits_for(now),
            }),
            set_heading: match &self.mode {
                Mode::Auto { set, .. } => Some(set.deg()),
                _ => None,
            },
            hts: self.hts().map(Heading::deg),
            set_rate: self.settings.set_rate,
            set_radius: self.settings.set_radius,
            by_radius: self.settings.set_by_radius >= 0.5,
            rudder_limit: if self.mode.is_autonav() {
                self.settings.rudder_max
            } else {
                self.settings.rudder_limit
            },
            rudder_order: self.rudder_order().map(RudderAngle::deg),
            cross_track: steered
                .and_then(|steered| steered.cross_track)
                .map(Distance::m),
            sources: self.sources(now),
            terms: steered.map_or([0.0; 4], |steered| steered.terms),
            limited: steered.is_some_and(|steered| steered.limited),
            output: self
                .picture
                .ports
                .iter()
                .any(|port| port.profile == Profile::Gear && port.output),
        }
    }

    fn sources(&self, now: Stamp) -> Vec<(String, String)> {
        let picture = &self.picture;
        let list = [
            ("heading", picture.heading(now).map(|heard| &heard.source)),
            ("rate", picture.rate(now).map(|heard| &heard.source)),
            ("position", picture.fix(now).map(|heard| &heard.source)),
            ("ground", picture.ground(now).map(|heard| &heard.source)),
            ("water", picture.water_speed(now).map(|heard| &heard.source)),
        ];
        list.into_iter()
            .filter_map(|(name, source)| Some((name.to_string(), picture.source_name(source?))))
            .collect()
    }
}
