//! Ships with ports where only the test speaks.

use super::{Rig, SLEW, route};
use wheelover_core::route::Route;
use wheelover_core::station::{ChecksumPolicy, PortSetup, Profile, Role};
use wheelover_core::units::{Course, Speed};
use wheelover_core::voyage::{Voyage, VoyageConfig};

/// A port of the autopilot where only the test speaks.
fn port(name: &str, profile: Profile) -> (Role, PortSetup) {
    let setup = PortSetup {
        name: name.into(),
        profile,
        checksum: ChecksumPolicy::Required,
        talkers: Vec::new(),
        baud: 4800,
        output: matches!(profile, Profile::Hmi | Profile::Plotter | Profile::Stand),
    };
    (Role::Autopilot, setup)
}

impl Rig {
    /// A ship on the first leg of `route` in a wind, with a plotter and a steering stand where only the test speaks.
    pub(crate) fn among_others(route: Route, seed: u64) -> Self {
        let ports = vec![
            port("plotter", Profile::Plotter),
            port("stand", Profile::Stand),
        ];
        Self::sailing_as(route.clone(), Some(route), seed, ports, |config| {
            config.world.wind_speed = Speed::from_knots(15.0);
        })
    }

    /// A ship heading 090 in still water, with a second compass of that profile on a port where only the test speaks.
    pub(crate) fn with_compass(profile: Option<Profile>) -> Self {
        let ports: Vec<_> = profile
            .map(|profile| ("second", profile))
            .into_iter()
            .collect();
        Self::heading_east(&ports, 0.0)
    }

    /// A ship heading 090, with ports of these names and profiles where only the test speaks, and a current to the north, knots.
    pub(crate) fn heading_east(ports: &[(&str, Profile)], current: f64) -> Self {
        let plan = route(&[(90.0, 2.5), (150.0, 2.5)], 0.5);
        let leg = plan.leg(0);
        let mut config = VoyageConfig::embedded(5);
        config.settings.rudder_slew = SLEW;
        config.chart.route = Some(plan.clone());
        config.world.start = leg.from();
        config.world.heading = leg.course().as_heading();
        config.world.current_set = Course::from_deg(0.0);
        config.world.current_drift = Speed::from_knots(current);
        let ports = ports.iter().map(|(name, profile)| port(name, *profile));
        config.ports.extend(ports);
        Self::of(Voyage::configured(config), plan)
    }
}
