//! How a voyage is put together: roles, ports, cables.

use super::cable::Cables;
use super::officer::Officer;
use super::tap::Slot;
use super::wiring::Voyage;
use crate::autopilot::Autopilot;
use crate::autopilot::steering::SteeringSettings;
use crate::chart_system::{ChartConfig, ChartSystem};
use crate::facts::ports::believes;
use crate::route;
use crate::settings::Settings;
use crate::station::{ChecksumPolicy, PortIndex, PortSetup, Profile, Role};
use crate::talk;
use crate::time::Stamp;
use crate::units::{Course, Speed};
use crate::world::{World, WorldConfig};
use alloc::collections::VecDeque;
use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;

/// What a voyage is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct VoyageConfig {
    /// The embedded voyage: the scripted officer sails the route of `chart` round and round.
    pub embedded: bool,
    /// Stations that run here; the rest is real equipment behind the ports.
    pub roles: Vec<Role>,
    /// Ports to the outside: whose, and what.
    pub ports: Vec<(Role, PortSetup)>,
    /// Settings of the autopilot.
    pub settings: Settings,
    /// The ship that is named, as the steering sees her; none where only the settings know her (AP-20).
    pub ship: Option<SteeringSettings>,
    /// The chart system; its ports are made here.
    pub chart: ChartConfig,
    /// The simulated ship; its ports are made here.
    pub world: WorldConfig,
}

impl VoyageConfig {
    /// The embedded voyage: all stations, no ports (CLI-1).
    #[must_use]
    pub fn embedded(seed: u64) -> Self {
        let (start, heading) = route::embedded_start();
        Self {
            embedded: true,
            roles: Role::ALL.to_vec(),
            ports: Vec::new(),
            settings: Settings {
                rudder_slew: 5.0, // the Mariner's gear
                external_tcs: true,
                ..Settings::default()
            },
            ship: Some(SteeringSettings::default()),
            chart: ChartConfig {
                route: Some(route::embedded()),
                ..ChartConfig::default()
            },
            world: WorldConfig {
                start,
                heading,
                seed,
                current_set: Course::from_deg(100.0),
                current_drift: Speed::from_knots(1.0),
                ..WorldConfig::default()
            },
        }
    }
}

impl Voyage {
    /// The embedded voyage, the scripted officer on watch.
    #[must_use]
    pub fn embedded(seed: u64) -> Self {
        Self::configured(VoyageConfig::embedded(seed))
    }

    /// The stations named in the roles; everything else is behind the ports.
    #[must_use]
    pub fn configured(config: VoyageConfig) -> Self {
        let mut ports: [Vec<PortSetup>; 3] = [Vec::new(), Vec::new(), Vec::new()];
        let mut outside = Vec::new();
        for (role, setup) in &config.ports {
            outside.push((*role, ports[*role as usize].len()));
            ports[*role as usize].push(setup.clone());
        }
        let windy = config.world.wind_speed.mps() > 0.0;
        let cables = lay_cables(&config.roles, windy, &mut ports);
        let runs = |role| config.roles.contains(&role);
        let [world_ports, chart_ports, autopilot_ports] = ports;
        let shown = [Role::Autopilot, Role::ChartSystem, Role::World]
            .into_iter()
            .find(|role| runs(*role))
            .unwrap_or(Role::Autopilot);
        let now = Stamp(0);
        let embedded = config.chart.route.clone().filter(|_| config.embedded);
        let up = vec![false; outside.len()];
        Self {
            autopilot: runs(Role::Autopilot)
                .then(|| Autopilot::new(autopilot_ports, config.settings, config.ship, now)),
            chart: runs(Role::ChartSystem).then(|| {
                ChartSystem::new(ChartConfig {
                    ports: chart_ports,
                    ..config.chart
                })
            }),
            world: runs(Role::World).then(|| {
                World::new(WorldConfig {
                    ports: world_ports,
                    ..config.world
                })
            }),
            cables,
            outside,
            up,
            shown,
            line: 0,
            officer: Officer::new(now, embedded.is_some()),
            embedded,
            round: 1,
            speed: 1.0,
            route_revision: 0,
            settings_revision: 0,
            now,
            officer_due: now + 1_000,
            scratch: Vec::new(),
            deliveries: VecDeque::new(),
            tap: Slot::default(),
        }
    }
}

/// What can be cabled inside, by the table of who says what: of each profile the first of the stations that speak there, and
/// those that believe something of what it says and do not say the same there, as two who face the same third do.
fn inside() -> impl Iterator<Item = (Profile, Role, Vec<Role>)> {
    Profile::ALL.into_iter().filter_map(|profile| {
        let speaks = |role: &Role| !talk::told(*role, profile).is_empty();
        let source = Role::ALL.into_iter().find(speaks)?;
        let listens = |role: &Role| {
            let mut said = talk::told(source, profile).iter();
            let own = talk::told(*role, profile);
            let faces = |saying| !own.iter().any(|row| row.saying == saying);
            *role != source
                && said.any(|row| faces(row.saying) && believes(*role, profile, row.formatter()))
        };
        let listeners = Role::ALL.into_iter().rev().filter(listens);
        Some((profile, source, listeners.collect()))
    })
}

/// Lays a cable wherever both stations run here and the hearing one has no real port for it; that of the wind sensor where
/// there is wind.
fn lay_cables(roles: &[Role], windy: bool, ports: &mut [Vec<PortSetup>; 3]) -> Cables {
    let mut cables = Cables::default();
    for (profile, source, listeners) in inside() {
        if !roles.contains(&source) || profile == Profile::Wind && !windy {
            continue;
        }
        let has = |ports: &[PortSetup]| ports.iter().any(|port| port.profile == profile);
        let listeners = listeners
            .into_iter()
            .filter(|role| roles.contains(role) && !has(&ports[*role as usize]))
            .collect::<Vec<_>>();
        if listeners.is_empty() {
            continue;
        }
        let mut ends = vec![(source, end_of(&mut ports[source as usize], profile))];
        for role in listeners {
            ends.push((role, end_of(&mut ports[role as usize], profile)));
        }
        cables.lay(profile.name(), profile, ends);
    }
    cables
}

/// The station's port of that profile; made where there is none.
fn end_of(ports: &mut Vec<PortSetup>, profile: Profile) -> PortIndex {
    if let Some(index) = ports.iter().position(|port| port.profile == profile) {
        return index;
    }
    ports.push(PortSetup {
        name: profile.name().to_string(),
        profile,
        checksum: ChecksumPolicy::Required,
        talkers: Vec::new(),
        baud: 38_400,
        output: true,
    });
    ports.len() - 1
}
