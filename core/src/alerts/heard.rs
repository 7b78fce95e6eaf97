//! Alerts of another system as they are heard: ALR, ALA, ALF and ALC (TCS-13; F2).
//!
//! In: sentences. Out: what stands there, the questions that its list raises (ACN, Q), and how one is acknowledged.

use super::standing::State;
use super::table::Priority;
use crate::nmea::{
    Ack, AcknowledgeState, Acn, Ala, AlarmCondition, Alc, AlertCategory, AlertCommand,
    AlertPriority, AlertState, Alf, Alr, CommandStatus, DetailedAcknowledge, DetailedCondition,
    Sentence,
};
use crate::time::Stamp;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// At most so many are kept; a further one is not taken.
const MOST: usize = 64;

/// An alert of another system that is not normal.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct HeardAlert {
    /// Number (ALR, ALA) or identifier (ALF).
    pub number: u32,
    /// Its instance, where it has one.
    pub instance: Option<u32>,
    /// Manufacturer of a proprietary alert.
    pub manufacturer: Option<String>,
    /// Known by ALF: it is acknowledged by ACN, else by ACK.
    pub detailed: bool,
    /// Priority; what only ALR or ALA tells is an alarm.
    pub priority: Priority,
    /// It may be acknowledged there only (category A), or nowhere (C).
    pub there_only: bool,
    /// State.
    pub state: State,
    /// Revision counter; 0 where ALR or ALA told it.
    pub revision: u32,
    /// Title.
    pub title: String,
    /// What happened.
    pub text: String,
    /// When the state last changed.
    pub at: Stamp,
}

/// The alerts of another system.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct HeardAlerts {
    list: Vec<HeardAlert>,
    /// The ALF whose second sentence may follow: its sequence and identifier.
    first: Option<(Option<u32>, u32)>,
    listing: Listing,
}

/// The list (ALC) that is being read.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Listing {
    sequence: Option<u32>,
    /// Number of its next sentence; 0 where one is missing.
    next: u32,
    /// What it has named so far.
    named: Vec<u32>,
}

impl HeardAlerts {
    /// What stands there.
    pub(crate) fn standing(&self) -> &[HeardAlert] {
        &self.list
    }

    /// Takes a sentence; gives what is to be asked.
    pub(crate) fn hear(&mut self, now: Stamp, sentence: &Sentence<'_>) -> Vec<Acn> {
        if !sentence.faults().is_empty() {
            return Vec::new();
        }
        if let Some(alr) = Alr::from_sentence(sentence) {
            let raised = alr.condition.map(|is| is == AlarmCondition::Raised);
            let taken = alr
                .acknowledged
                .map(|is| is == AcknowledgeState::Acknowledged);
            self.plain(now, alr.number, raised, taken, alr.text);
        } else if let Some(ala) = Ala::from_sentence(sentence) {
            let raised = ala.condition.map(|is| is != DetailedCondition::Normal);
            let taken = ala
                .acknowledged
                .map(|is| is != DetailedAcknowledge::NotAcknowledged);
            self.plain(now, ala.number, raised, taken, ala.text);
        } else if let Some(alf) = Alf::from_sentence(sentence) {
            self.detailed(now, alf);
        } else if let Some(alc) = Alc::from_sentence(sentence) {
            return self.compare(&alc);
        }
        Vec::new()
    }

    /// How an alert is acknowledged there; none where it waits for none.
    pub(crate) fn acknowledgement(&self, number: u32, talker: &str) -> Option<String> {
        let alert = self.list.iter().find(|alert| alert.number == number)?;
        let waits = !matches!(alert.state, State::Acknowledged | State::Normal);
        if !waits || alert.there_only || alert.priority == Priority::Caution {
            return None;
        }
        Some(if alert.detailed {
            let command = Some(AlertCommand::Acknowledge);
            of(alert.manufacturer.clone(), number, alert.instance, command).line(talker)
        } else {
            let number = Some(number);
            Ack { number }.line(talker)
        })
    }

    /// ALR and ALA: condition and acknowledgement.
    fn plain(
        &mut self,
        now: Stamp,
        number: Option<u32>,
        raised: Option<bool>,
        taken: Option<bool>,
        text: Option<String>,
    ) {
        let (Some(number), Some(raised), Some(taken)) = (number, raised, taken) else {
            return;
        };
        let state = match (raised, taken) {
            (true, false) => State::Unacknowledged,
            (true, true) => State::Acknowledged,
            (false, false) => State::RectifiedUnacknowledged,
            (false, true) => State::Normal,
        };
        let said = text.filter(|text| !text.is_empty());
        self.take(
            now,
            HeardAlert {
                number,
                instance: None,
                manufacturer: None,
                detailed: false,
                priority: Priority::Alarm,
                there_only: false,
                state,
                revision: 0,
                title: format!("ALERT {number}"),
                text: said
                    .unwrap_or_else(|| format!("Alert {number} there: see its list of alerts")),
                at: now,
            },
        );
    }

    /// ALF: the first sentence says all but the description, which the second brings.
    fn detailed(&mut self, now: Stamp, alf: Alf) {
        let Some(number) = alf.alert else {
            return;
        };
        let text = alf.text.unwrap_or_default();
        if alf.number == Some(2) {
            if self.first.take() == Some((alf.sequence, number)) {
                let known = self
                    .list
                    .iter_mut()
                    .find(|one| one.number == number && one.detailed);
                known.into_iter().for_each(|one| one.text.clone_from(&text));
            }
            return;
        }
        self.first = (alf.total == Some(2)).then_some((alf.sequence, number));
        let (Some(state), Some(priority)) = (alf.state, alf.priority) else {
            return;
        };
        self.take(
            now,
            HeardAlert {
                number,
                instance: alf.instance,
                manufacturer: alf.manufacturer,
                detailed: true,
                priority: match priority {
                    AlertPriority::Emergency | AlertPriority::Alarm => Priority::Alarm,
                    AlertPriority::Warning => Priority::Warning,
                    AlertPriority::Caution => Priority::Caution,
                },
                there_only: alf
                    .category
                    .is_some_and(|category| category == AlertCategory::C),
                state: match state {
                    AlertState::ActiveUnacknowledged => State::Unacknowledged,
                    AlertState::Silenced => State::Silenced,
                    AlertState::Acknowledged => State::Acknowledged,
                    AlertState::Transferred => State::Transferred,
                    AlertState::RectifiedUnacknowledged => State::RectifiedUnacknowledged,
                    AlertState::Normal => State::Normal,
                },
                revision: alf.revision.unwrap_or_default(),
                title: text,
                text: String::new(),
                at: now,
            },
        );
    }

    fn take(&mut self, now: Stamp, mut new: HeardAlert) {
        let same = |old: &HeardAlert| old.number == new.number && old.detailed == new.detailed;
        let place = self.list.iter().position(same);
        match place {
            _ if new.state == State::Normal => {
                place.map(|place| self.list.remove(place));
            }
            Some(place) => {
                let old = &self.list[place];
                new.at = if old.state == new.state { old.at } else { now };
                if new.text.is_empty() {
                    new.text.clone_from(&old.text);
                }
                self.list[place] = new;
            }
            None if self.list.len() < MOST => self.list.push(new),
            None => {}
        }
    }

    /// ALC: what it names and is not known so is asked for; what a whole list does not name has ended.
    fn compare(&mut self, alc: &Alc) -> Vec<Acn> {
        let listing = &mut self.listing;
        if alc.number == Some(1) {
            *listing = Listing {
                sequence: alc.sequence,
                next: 1,
                named: Vec::new(),
            };
        }
        let follows = listing.sequence == alc.sequence && alc.number == Some(listing.next);
        listing.next = if follows { listing.next + 1 } else { 0 };
        let mut asked = Vec::new();
        for entry in &alc.entries {
            let Some(number) = entry.alert else {
                continue;
            };
            if follows {
                listing.named.push(number);
            }
            let known = self.list.iter().any(|one| {
                one.detailed && one.number == number && Some(one.revision) == entry.revision
            });
            if !known {
                let manufacturer = entry.manufacturer.clone();
                let command = Some(AlertCommand::Request);
                asked.push(of(manufacturer, number, entry.instance, command));
            }
        }
        if follows && alc.number == alc.total {
            let named = core::mem::take(&mut listing.named);
            self.list
                .retain(|one| !one.detailed || named.contains(&one.number));
        }
        asked
    }
}

/// A command to another system's alert.
fn of(
    manufacturer: Option<String>,
    number: u32,
    instance: Option<u32>,
    command: Option<AlertCommand>,
) -> Acn {
    Acn {
        time: None,
        manufacturer: manufacturer.filter(|name| !name.is_empty()),
        alert: Some(number),
        instance,
        command,
        status: Some(CommandStatus::Command),
    }
}

#[cfg(test)]
mod tests;
