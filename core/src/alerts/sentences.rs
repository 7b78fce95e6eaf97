//! The sentences of alerts, made from their states: ALR, ALA, ALF, ALC, ARC (AP-11; IEC 61162-1; Navis A.7, A.8; F2).

use super::machine::Alerts;
use super::standing::{Standing, State};
use super::table::{Alert, Category, Priority};
use crate::nmea::{
    AcknowledgeState, Acn, Ala, AlarmCondition, Alc, AlcEntry, AlertCategory, AlertPriority,
    AlertState, Alf, Alr, Arc, DetailedAcknowledge, DetailedCondition, UtcTime,
};
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;

/// Each alert stands once in a station (IEC 61162-1 ALF, alert instance).
pub(super) const INSTANCE: u32 = 1;
/// Entries of an ALC, of which none is split over two sentences (F2: 0 to 3).
const ENTRIES: usize = 3;
/// Characters of a line at most, without CR LF (SEN-1).
const LONGEST: usize = 80;

/// Whether nobody has to take it any more.
const fn taken(state: State) -> bool {
    matches!(
        state,
        State::Acknowledged | State::Transferred | State::Normal
    )
}

/// ALR: condition and acknowledgement; time and text are null.
pub(super) fn alr(alerts: &Alerts, alert: Alert) -> Alr {
    Alr {
        number: Some(u32::from(alert.number())),
        condition: Some(if alerts.raised(alert) {
            AlarmCondition::Raised
        } else {
            AlarmCondition::NotRaised
        }),
        acknowledged: Some(if taken(alerts.state(alert)) {
            AcknowledgeState::Acknowledged
        } else {
            AcknowledgeState::NotAcknowledged
        }),
        ..Alr::default()
    }
}

/// ALA of a unit of this autopilot: system OT, subsystem JP; time and text are null.
pub(super) fn ala(alerts: &Alerts, alert: Alert, unit: u32) -> Ala {
    Ala {
        system: Some("OT".to_string()),
        subsystem: Some("JP".to_string()),
        instance: Some(unit),
        number: Some(u32::from(alert.number())),
        condition: Some(if alerts.raised(alert) {
            DetailedCondition::High
        } else {
            DetailedCondition::Normal
        }),
        acknowledged: Some(if taken(alerts.state(alert)) {
            DetailedAcknowledge::Acknowledged
        } else {
            DetailedAcknowledge::NotAcknowledged
        }),
        ..Ala::default()
    }
}

/// ALF: the title, and what happened in a second sentence, which has neither category, priority nor state. What is longer
/// than a line is left out from its end, word by word.
pub(super) fn alf(
    alerts: &Alerts,
    alert: Alert,
    sequence: u32,
    time: Option<UtcTime>,
    talker: &str,
) -> [String; 2] {
    let row = alert.definition();
    let standing = alerts.standing_of(alert);
    let of = |number: u32, text: &str| Alf {
        total: Some(2),
        number: Some(number),
        sequence: Some(sequence),
        alert: Some(alert.identifier()),
        instance: Some(INSTANCE),
        revision: Some(u32::from(alerts.revision(alert))),
        escalation: Some(standing.map_or(0, |standing| u32::from(standing.escalation))),
        text: Some(text.to_string()),
        ..Alf::default()
    };
    let first = Alf {
        time,
        category: Some(match row.category {
            Category::A => AlertCategory::A,
            Category::B => AlertCategory::B,
        }),
        priority: Some(match row.priority {
            Priority::Alarm => AlertPriority::Alarm,
            Priority::Warning => AlertPriority::Warning,
            Priority::Caution => AlertPriority::Caution,
        }),
        state: Some(match alerts.state(alert) {
            State::Unacknowledged => AlertState::ActiveUnacknowledged,
            State::Silenced => AlertState::Silenced,
            State::Acknowledged => AlertState::Acknowledged,
            State::Transferred => AlertState::Transferred,
            State::RectifiedUnacknowledged => AlertState::RectifiedUnacknowledged,
            State::Normal => AlertState::Normal,
        }),
        ..of(1, row.title)
    };
    let description = standing.map_or(row.text, Standing::text);
    let second = fit(description, |text| of(2, text).line(talker));
    [first.line(talker), second]
}

/// The line with as many words of a text as it can carry.
fn fit(text: &str, line: impl Fn(&str) -> String) -> String {
    let mut words = text;
    loop {
        let made = line(words.trim_end_matches([' ', ',', '.', ':']));
        if made.len() <= LONGEST {
            return made;
        }
        let shorter = words.trim_end().rfind(' ').unwrap_or_default();
        words = &words[..shorter];
    }
}

/// ALC: all alerts that are not normal, as many sentences as they need.
pub(super) fn alc(alerts: &Alerts, sequence: u32) -> Vec<Alc> {
    let entry = |standing: &Standing| AlcEntry {
        alert: Some(standing.alert.identifier()),
        instance: Some(INSTANCE),
        revision: Some(u32::from(alerts.revision(standing.alert))),
        ..AlcEntry::default()
    };
    let entries: Vec<AlcEntry> = alerts.standing().iter().map(entry).collect();
    let mut pages: Vec<Vec<AlcEntry>> = entries.chunks(ENTRIES).map(<[_]>::to_vec).collect();
    if pages.is_empty() {
        pages = vec![Vec::new()];
    }
    let total = pages.len() as u32;
    let page = |(number, entries): (u32, Vec<AlcEntry>)| Alc {
        total: Some(total),
        number: Some(number),
        sequence: Some(sequence),
        count: Some(entries.len() as u32),
        entries,
    };
    (1..).zip(pages).map(page).collect()
}

/// ARC: that command is not obeyed, as it was asked.
pub(super) fn arc(asked: &Acn) -> Arc {
    Arc {
        time: asked.time,
        manufacturer: asked.manufacturer.clone(),
        alert: asked.alert,
        instance: asked.instance,
        command: asked.command,
    }
}
