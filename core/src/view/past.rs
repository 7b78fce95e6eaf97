//! The alerts of the stations that run here: those that stand, and what has been, with its times (DSP-5).

use super::message::AlertView;
use super::voyage::snapshot;
use crate::alerts::{Alerts, Category, Past, Priority, State};
use crate::station::Role;
use crate::time::Stamp;
use crate::voyage::Voyage;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// `/api/alerts`. All times are server time in milliseconds, the clock of every `at`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AlertsDocument {
    /// Now.
    pub at: u64,
    /// Alerts that are not normal, highest first; those of a foreign autopilot too, as they are heard.
    pub standing: Vec<AlertView>,
    /// What has been raised by the stations that run here, the newest first: the last hundred of each.
    pub history: Vec<PastView>,
}

/// An alert that was raised.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PastView {
    /// Which station raised it: `autopilot` or `chart_system`.
    pub station: String,
    /// Its number in the alert table.
    pub number: u16,
    /// Priority.
    pub priority: Priority,
    /// Category: `A` acknowledged only at the source, `B` anywhere.
    pub category: Category,
    /// Title, at most 18 characters.
    pub title: String,
    /// What happened and what to do, by the table.
    pub text: String,
    /// What happened that time; empty where the table's text says it.
    pub detail: String,
    /// Its state now; normal where it is over, or was raised again since.
    pub state: State,
    /// When it was raised.
    pub raised: u64,
    /// When somebody took it; null where nobody has, and for a caution.
    pub acknowledged: Option<u64>,
    /// When its condition ended; null while it lasts.
    pub back: Option<u64>,
}

/// What stands and what has been.
#[must_use]
pub fn alerts_document(voyage: &Voyage) -> AlertsDocument {
    let mut history = Vec::new();
    if let Some(autopilot) = voyage.autopilot() {
        add(&mut history, Role::Autopilot, autopilot.alerts());
    }
    if let Some(chart) = voyage.chart_system() {
        add(&mut history, Role::ChartSystem, chart.all_alerts());
    }
    history.sort_by_key(|past| core::cmp::Reverse(past.raised));
    AlertsDocument {
        at: voyage.now().0,
        standing: snapshot(voyage).alerts,
        history,
    }
}

fn add(history: &mut Vec<PastView>, station: Role, alerts: &Alerts) {
    let mut seen = Vec::new();
    for past in alerts.history() {
        // The newest of its kind is the one that may stand.
        let newest = !seen.contains(&past.alert);
        seen.push(past.alert);
        let state = newest.then(|| alerts.state(past.alert));
        history.push(view(station, past, state.unwrap_or(State::Normal)));
    }
}

fn view(station: Role, past: &Past, state: State) -> PastView {
    let definition = past.alert.definition();
    let at = |stamp: Stamp| stamp.0;
    PastView {
        station: station.name().to_string(),
        number: past.alert.number(),
        priority: definition.priority,
        category: definition.category,
        title: definition.title.to_string(),
        text: definition.text.to_string(),
        detail: past.detail.clone(),
        state,
        raised: past.raised.0,
        acknowledged: past.acknowledged.map(at),
        back: past.back.map(at),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::{FaultKind, Order, Origin};
    use crate::voyage::Event;

    // DSP-5
    #[test]
    fn what_was_raised_taken_and_over_stands_with_its_times_the_newest_first() {
        let mut voyage = Voyage::embedded(7);
        let order = |voyage: &mut Voyage, order| {
            let (id, by) = (1, Origin::Officer);
            let event = Event::Order { id, by, order };
            voyage.handle(voyage.now(), event, &mut Vec::new());
        };
        let silent = |on| Order::Fault {
            cable: "gyro1".into(),
            kind: FaultKind::Silent,
            on,
        };
        let run = |voyage: &mut Voyage, ms| {
            let now = voyage.now() + ms;
            voyage.handle(now, Event::Tick, &mut Vec::new());
        };
        order(&mut voyage, Order::Officer(false));
        assert_eq!(alerts_document(&voyage).history, []);
        run(&mut voyage, 5_000);
        order(&mut voyage, Order::Mode(crate::command::ModeRequest::Auto));
        run(&mut voyage, 1_000);
        order(&mut voyage, silent(true));
        run(&mut voyage, 4_000);
        let lost = |document: &AlertsDocument| {
            let found = document.history.iter().find(|past| past.number == 110);
            found.cloned().unwrap()
        };
        let first = alerts_document(&voyage);
        let waits = lost(&first);
        assert_eq!(waits.state, State::Unacknowledged);
        assert_eq!((waits.acknowledged, waits.back), (None, None));
        assert_eq!(
            (waits.station.as_str(), waits.title.as_str()),
            ("autopilot", "HEADING LOST")
        );
        assert!((6_000..10_001).contains(&waits.raised), "{}", waits.raised);
        let standing = |document: &AlertsDocument| {
            let mut standing = document.standing.iter();
            standing.any(|alert| alert.number == 110)
        };
        assert!(standing(&first));
        order(&mut voyage, Order::Acknowledge(110));
        let taken = voyage.now().0;
        order(&mut voyage, silent(false));
        run(&mut voyage, 2_000);
        order(
            &mut voyage,
            Order::Mode(crate::command::ModeRequest::Standby),
        );
        run(&mut voyage, 1_000);
        let document = alerts_document(&voyage);
        let over = lost(&document);
        assert_eq!(over.acknowledged, Some(taken));
        assert_eq!(over.state, State::Normal);
        assert!(over.back.is_some_and(|back| back > taken), "{over:?}");
        assert!(!standing(&document));
        let times: Vec<u64> = document.history.iter().map(|past| past.raised).collect();
        assert!(times.is_sorted_by(|a, b| a >= b), "{times:?}");
        let text = serde_json::to_string(&document).unwrap();
        assert_eq!(
            serde_json::from_str::<AlertsDocument>(&text).unwrap(),
            document
        );
    }
}
