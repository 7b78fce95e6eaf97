//! Cables between stations in one process, and what can be done to them.

use crate::command::FaultKind;
use crate::station::{PortIndex, Profile, Role};
use crate::time::Stamp;
use alloc::collections::VecDeque;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// How late a delayed cable is, milliseconds.
const DELAY_MS: u64 = 3_000;

/// One end of a cable.
pub(super) type End = (Role, PortIndex);

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Cable {
    name: String,
    profile: Profile,
    ends: Vec<End>,
    faults: Vec<FaultKind>,
}

/// All cables, and what is on its way on a delayed one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Cables {
    cables: Vec<Cable>,
    late: VecDeque<(Stamp, Role, PortIndex, Vec<u8>)>,
}

impl Cables {
    /// Lays a cable; what one end sends, all others hear.
    pub(super) fn lay(&mut self, name: &str, profile: Profile, ends: Vec<End>) {
        self.cables.push(Cable {
            name: name.to_string(),
            profile,
            ends,
            faults: Vec::new(),
        });
    }

    /// Profile of the named cable.
    pub(super) fn profile(&self, name: &str) -> Option<Profile> {
        self.cables
            .iter()
            .find(|cable| cable.name == name)
            .map(|cable| cable.profile)
    }

    /// Notes a fault as begun or ended.
    pub(super) fn injure(&mut self, name: &str, kind: FaultKind, on: bool) {
        for cable in self.cables.iter_mut().filter(|cable| cable.name == name) {
            cable.faults.retain(|fault| *fault != kind);
            if on {
                cable.faults.push(kind);
            }
        }
    }

    /// Faults in force.
    pub(super) fn faults(&self) -> Vec<(String, FaultKind)> {
        let faults = |cable: &Cable| {
            let name = cable.name.clone();
            cable
                .faults
                .clone()
                .into_iter()
                .map(move |kind| (name.clone(), kind))
        };
        self.cables.iter().flat_map(faults).collect()
    }

    /// Whether the cable at this end is cut.
    pub(super) fn cut(&self, end: End) -> bool {
        let here = |cable: &&Cable| cable.ends.contains(&end);
        self.cables
            .iter()
            .filter(here)
            .any(|cable| cable.faults.contains(&FaultKind::Cut))
    }

    /// Takes bytes from one end to the others.
    pub(super) fn carry(
        &mut self,
        now: Stamp,
        from: End,
        bytes: &[u8],
        deliveries: &mut VecDeque<(Role, PortIndex, Vec<u8>)>,
    ) {
        for cable in self
            .cables
            .iter()
            .filter(|cable| cable.ends.contains(&from))
        {
            let has = |kind| cable.faults.contains(&kind);
            if has(FaultKind::Cut) {
                continue;
            }
            for (role, port) in cable.ends.iter().copied().filter(|end| *end != from) {
                // A cable is silent towards the autopilot: its own reports still go out.
                if has(FaultKind::Silent) && role == Role::Autopilot {
                    continue;
                }
                let mut bytes = bytes.to_vec();
                if has(FaultKind::Corrupt) {
                    damage(&mut bytes);
                }
                if has(FaultKind::Delayed) {
                    self.late.push_back((now + DELAY_MS, role, port, bytes));
                } else {
                    deliveries.push_back((role, port, bytes));
                }
            }
        }
    }

    /// When the next late bytes arrive.
    pub(super) fn due(&self) -> Option<Stamp> {
        self.late.front().map(|late| late.0)
    }

    /// Takes bytes that arrive by `at`.
    pub(super) fn take_due(&mut self, at: Stamp) -> Option<(Role, PortIndex, Vec<u8>)> {
        if self.due()? > at {
            return None;
        }
        self.late
            .pop_front()
            .map(|(_, role, port, bytes)| (role, port, bytes))
    }
}

/// Damages one character of every line.
fn damage(bytes: &mut [u8]) {
    for line in bytes.split_mut(|byte| *byte == b'\n') {
        let middle = line.len() / 2;
        if let Some(byte) = line.get_mut(middle) {
            *byte ^= 1;
        }
    }
}
