//! How an autopilot begins.

use super::Autopilot;
use super::alerting::Alerting;
use super::gear::Gear;
use super::hand_unit::HandUnit;
use super::modes::Modes;
use super::sight::Sight;
use super::steering::{Steering, SteeringSettings};
use super::times;
use super::turned::Turned;
use crate::post::Post;
use crate::settings::Settings;
use crate::station::{PortSetup, Role};
use crate::time::Stamp;
use alloc::vec::Vec;

impl Autopilot {
    /// An autopilot in STANDBY with these ports; `named_ship` is a ship whose constants are known by her name (AP-20).
    #[must_use]
    pub fn new(
        ports: Vec<PortSetup>,
        settings: Settings,
        named_ship: Option<SteeringSettings>,
        now: Stamp,
    ) -> Self {
        Self {
            alerts: Alerting::new(&ports),
            post: Post::new(Role::Autopilot, ports),
            sight: Sight::default(),
            modes: Modes::new(),
            steering: Steering::of(named_ship, &settings),
            gear: Gear::of(settings.rudders),
            turned: Turned::new(now),
            hand_unit: HandUnit::default(),
            settings,
            timers: times::begun(now),
            now,
        }
    }
}
