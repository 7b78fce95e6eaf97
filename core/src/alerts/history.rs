//! What has been: each alert with the times at which it came, was taken and went (DSP-5).

use super::table::Alert;
use crate::time::Stamp;
use alloc::collections::VecDeque;
use alloc::string::{String, ToString};
use serde::{Deserialize, Serialize};

/// So many of the newest are kept; an older one is forgotten.
const KEPT: usize = 100;

/// An alert that was raised.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Past {
    /// Which.
    pub alert: Alert,
    /// What happened then; empty where the table's text says it.
    pub detail: String,
    /// When it was raised.
    pub raised: Stamp,
    /// When somebody took it; absent where nobody has, and for a caution.
    pub acknowledged: Option<Stamp>,
    /// When its condition ended; absent while it lasts.
    pub back: Option<Stamp>,
}

/// The newest alerts of a station, the oldest first.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct History(VecDeque<Past>);

impl History {
    pub(super) fn raised(&mut self, now: Stamp, alert: Alert, detail: &str) {
        if self.0.len() >= KEPT {
            self.0.pop_front();
        }
        self.0.push_back(Past {
            alert,
            detail: detail.to_string(),
            raised: now,
            acknowledged: None,
            back: None,
        });
    }

    /// Somebody took it; the first time counts.
    pub(super) fn acknowledged(&mut self, now: Stamp, alert: Alert) {
        if let Some(past) = self.newest(alert) {
            past.acknowledged.get_or_insert(now);
        }
    }

    /// Its condition has ended.
    pub(super) fn back(&mut self, now: Stamp, alert: Alert) {
        if let Some(past) = self.newest(alert) {
            past.back.get_or_insert(now);
        }
    }

    /// What happened turned out to be something else.
    pub(super) fn retext(&mut self, alert: Alert, detail: &str) {
        if let Some(past) = self.newest(alert) {
            past.detail = detail.to_string();
        }
    }

    pub(super) fn iter(&self) -> impl DoubleEndedIterator<Item = &Past> {
        self.0.iter()
    }

    fn newest(&mut self, alert: Alert) -> Option<&mut Past> {
        self.0.iter_mut().rev().find(|past| past.alert == alert)
    }
}
