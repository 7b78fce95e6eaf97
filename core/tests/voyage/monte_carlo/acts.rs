//! What happens in a random script: faults on the cables, a plotter and a steering stand that say something, an operator who does
//! something.

use crate::random::Random;
use crate::rig::{Rig, edited};
use crate::track::plotter::Plotter;
use std::sync::{Arc, Mutex};
use wheelover_core::alerts::Alert;
use wheelover_core::settings::Value;
use wheelover_core::station::{Profile, Switch};
use wheelover_core::time::Stamp;
use wheelover_core::view::{ChartRequest, FaultKind, ModeName, ModeRequest, Order, Side};

/// What the cables do at the moment.
#[derive(Default)]
pub(super) struct Damage {
    silent: Option<(Profile, &'static str)>,
    checksum: Option<&'static str>,
    not_valid: bool,
    override_in_use: bool,
    status: Option<&'static str>,
}

const SILENT: [(Profile, &str); 14] = [
    (Profile::Ecdis, ""),
    (Profile::Ecdis, "HTC,"),
    (Profile::Ecdis, "XTE,"),
    (Profile::Ecdis, "PNEY,001"),
    (Profile::Ecdis, "PNEY,002"),
    (Profile::Gyro1, ""),
    (Profile::Gyro1, "HDT,"),
    (Profile::Gyro1, "ROT,"),
    (Profile::Gps, ""),
    (Profile::Gps, "VTG,"),
    (Profile::Log, ""),
    (Profile::Gear, ""),
    (Profile::Wind, ""),
    (Profile::Wind, ",R,"),
];

/// The operator's modes besides AUTO, AutoNAV and TRACK.
const MODES: [ModeRequest; 6] = [
    ModeRequest::FfuOverride,
    ModeRequest::RiverPilot,
    ModeRequest::WindVane,
    ModeRequest::Dodge,
    ModeRequest::Installation,
    ModeRequest::Autotuning,
];

/// What the stand says: the autopilot's, by hand, its lever, the override, nonsense.
const STAND: [&str; 5] = ["V,,,S", "V,,,M", "V,12.0,L,R", "A,,,M", "X,,,M"];

/// What is done to APB: field and text; none as it is.
const APB: [Option<(usize, &str)>; 5] = [
    None,
    Some((1, "V")),
    Some((3, "0.900")),
    Some((8, "200.0")),
    Some((8, "")),
];

pub(super) fn damaged(damage: &Damage, from: Profile, line: &str) -> Option<String> {
    if let Some((profile, formatter)) = damage.silent
        && from == profile
        && line.contains(formatter)
    {
        return None;
    }
    if damage
        .checksum
        .is_some_and(|formatter| line.contains(formatter))
    {
        return Some(format!("{}Z", &line[..line.len() - 1]));
    }
    let mut line = line.to_string();
    if line.contains("HTC,") {
        if damage.override_in_use {
            line = edited(&line, &[(1, "A")]);
        }
        if let Some(status) = damage.status {
            line = edited(&line, &[(14, status)]);
        }
    }
    if damage.not_valid && line.contains("XTE,") {
        line = edited(&line, &[(1, "V")]);
    }
    Some(line)
}

/// Who acts beside the stations.
pub(super) struct Acts {
    pub(super) random: Random,
    damage: Arc<Mutex<Damage>>,
    plotter: Plotter,
    /// The plotter speaks, and this is done to its APB.
    speaks: Option<Option<(usize, &'static str)>>,
    stand: Option<&'static str>,
    contacts: bool,
    /// When TRACK is selected.
    track: Option<Stamp>,
}

impl Acts {
    pub(super) fn new(random: Random, rig: &Rig, damage: Arc<Mutex<Damage>>) -> Self {
        Self {
            random,
            damage,
            plotter: Plotter::new(&rig.route),
            speaks: None,
            stand: None,
            contacts: false,
            track: None,
        }
    }

    /// What is said once a second, and the selection that waited for it; whether that is a reason for another mode.
    pub(super) fn each_second(&mut self, rig: &mut Rig) -> bool {
        if let Some(spoilt) = self.speaks {
            for body in self.plotter.says(rig) {
                let mut fields: Vec<&str> = body.split(',').collect();
                if let Some((field, text)) = spoilt.filter(|_| body.contains("APB,")) {
                    fields[field] = text;
                }
                rig.say(Profile::Plotter, &fields.join(","));
            }
        }
        if let Some(start) = self.stand {
            let body = format!("IIHTD,{start},,,,,,,,,T,A,A,,90.0");
            rig.say(Profile::Stand, &body);
        }
        let due = self.track.is_some_and(|at| rig.now >= at);
        if due {
            self.track = None;
            let _ = rig.command(Order::Mode(ModeRequest::Track));
        }
        due
    }

    /// One act; what the operator or the stand does on purpose counts as a reason for another mode.
    pub(super) fn act(&mut self, rig: &mut Rig) -> bool {
        match self.random.below(32) {
            0..=12 => {
                self.hurt(rig);
                return false;
            }
            13 => {
                let _ = rig.command(Order::Mode(ModeRequest::Standby));
            }
            14 => {
                let by = self.random.below(60) as f64 - 30.0;
                let _ = rig.command(Order::AdjustHeading(by));
            }
            15..=17 => self.select(rig),
            18..=20 => self.set(rig),
            21 | 22 => self.speaks = Some(self.random.pick(&APB)),
            23 => self.speaks = None,
            24 | 25 => {
                // All is healed, and the officer follows the plotter.
                self.heal(rig);
                let _ = rig.command(Order::Mode(ModeRequest::Auto));
                self.speaks = Some(None);
                self.track = Some(rig.now + 4_000);
            }
            26 => self.stand = Some(self.random.pick(&STAND)).filter(|_| self.random.below(5) > 0),
            27 => {
                self.contacts = true;
                let switch = self.random.pick(&Switch::ALL);
                let closed = [Some(true), Some(false), None][self.random.below(3_usize)];
                rig.switch(switch, closed);
            }
            28 => {
                let source = self.random.pick(&["manual", "automatic"]);
                Self::source(rig, source);
            }
            _ => {
                // All is healed, and the officer brings the ship back under track control.
                self.heal(rig);
                let _ = rig.command(Order::Mode(ModeRequest::Auto));
                let _ = rig.ask(ChartRequest::Track);
                let _ = rig.command(Order::Mode(ModeRequest::Autonav));
            }
        }
        true
    }

    /// A fault.
    fn hurt(&mut self, rig: &mut Rig) {
        let random = &mut self.random;
        let mut damage = self.damage.lock().unwrap();
        match random.below(13) {
            0..=4 => damage.silent = Some(random.pick(&SILENT)),
            5 => damage.checksum = Some(random.pick(&["HTC,", "XTE,", "PNEY,001", "HDT"])),
            6 => damage.not_valid = !damage.not_valid,
            7 => damage.override_in_use = !damage.override_in_use,
            8 => damage.status = random.pick(&[Some("R"), None, Some("")]),
            9 => {
                let on = random.below(2) == 0;
                rig.injure(Profile::Gyro1, FaultKind::Jump, on);
            }
            10 => {
                let on = random.below(2) == 0;
                rig.injure(Profile::Gps, FaultKind::Jump, on);
            }
            11 => {
                rig.stall(300);
            }
            _ => {
                let request = random.pick(&[ChartRequest::Stop, ChartRequest::Heading]);
                let _ = rig.ask(request);
            }
        }
    }

    fn heal(&mut self, rig: &mut Rig) {
        *self.damage.lock().unwrap() = Damage::default();
        (self.speaks, self.stand, self.track) = (None, None, None);
        if self.contacts {
            rig.switch(Switch::Nfu, Some(false));
            rig.switch(Switch::Ffu, Some(false));
            rig.switch(Switch::Autopilot, Some(true));
        }
        rig.say(Profile::Stand, "IIHTD,V,,,S,,,,,,,,,T,A,A,,90.0");
        rig.injure(Profile::Gyro1, FaultKind::Jump, false);
        rig.injure(Profile::Gps, FaultKind::Jump, false);
        Self::source(rig, "automatic");
        if rig.mode() == ModeName::Installation || rig.raised(Alert::ChangeSpeedSource) {
            let _ = rig.command(Order::Mode(ModeRequest::Standby));
        }
    }

    fn source(rig: &mut Rig, source: &str) {
        let (key, value) = ("speed_source".into(), Value::Choice(source.into()));
        let _ = rig.command(Order::Setting { key, value });
    }

    fn select(&mut self, rig: &mut Rig) {
        let mode = self.random.pick(&MODES);
        let from = match mode {
            ModeRequest::Installation => Some(ModeRequest::Standby),
            ModeRequest::Autotuning => Some(ModeRequest::Auto),
            _ => None,
        };
        if let Some(from) = from {
            let _ = rig.command(Order::Mode(from));
        }
        let _ = rig.command(Order::Mode(mode));
        if mode == ModeRequest::Autotuning {
            let _ = rig.command(Order::Mode(mode));
        }
    }

    fn set(&mut self, rig: &mut Rig) {
        let value = self.random.below(80) as f64 - 40.0;
        let side = if value < 0.0 {
            Side::Port
        } else {
            Side::Starboard
        };
        for order in [
            Order::SetRate(value),
            Order::SetRudder(value),
            Order::SetDodge(value),
            Order::SetWindAngle(value),
            Order::Tack(side),
        ] {
            let _ = rig.command(order);
        }
    }
}
