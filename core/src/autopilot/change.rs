//! Settings changed while the autopilot runs: what is then in force, or why it may not be.

use crate::command::Refusal;
use crate::settings::{Settings, SpeedSource, Value};
use alloc::format;
use alloc::vec::Vec;

/// What a change is judged by.
#[derive(Clone, Copy, Debug)]
pub(super) struct While {
    /// Orders are given.
    pub(super) steering: bool,
    /// The chart system commands, or AutoNAV is selected.
    pub(super) autonav: bool,
}

/// The settings with some changed, all or none. Rudders, gear, its mounting and the alignment of the compass change in
/// STANDBY only (AP-4, AP-18, EMC-7): an order or a heading would else
/// jump. AutoNAV is steered by a measured speed only (AP-7).
pub(super) fn changed<'a>(
    settings: &Settings,
    changes: impl IntoIterator<Item = (&'a str, &'a Value)>,
    now: While,
) -> Result<Settings, Refusal> {
    let mut changed = settings.clone();
    let mut left: Vec<_> = changes.into_iter().collect();
    // Two that agree with each other may not agree one by one.
    while !left.is_empty() {
        let (before, mut refused) = (left.len(), None);
        left.retain(|(key, value)| match changed.set(key, value) {
            Ok(()) => false,
            Err(text) => {
                refused.get_or_insert(text);
                true
            }
        });
        if let Some(text) = refused.filter(|_| left.len() == before) {
            return Err(Refusal::because(text));
        }
    }
    let source = changed.speed_source;
    if source == SpeedSource::Manual && source != settings.speed_source && now.autonav {
        let text = "no speed is entered by hand in AutoNAV: select another mode first";
        return Err(Refusal::because(text));
    }
    let differ = [
        ("rudders are", changed.rudders != settings.rudders),
        ("gear is", changed.gear != settings.gear),
        (
            "tiller_side is",
            changed.tiller_side != settings.tiller_side,
        ),
        (
            "tiller_centre is",
            changed.tiller_centre != settings.tiller_centre,
        ),
        (
            "heading_alignment is",
            changed.heading_alignment != settings.heading_alignment,
        ),
        (
            "external_compass is",
            changed.external_compass != settings.external_compass,
        ),
    ];
    match differ.iter().find(|(_, differs)| *differs && now.steering) {
        Some((what, _)) => Err(Refusal::because(format!("{what} changed in STANDBY only"))),
        None => Ok(changed),
    }
}
