//! What a station says of its alerts and hears of them, port by port (AP-11, F2).
//!
//! In: changes of alerts; ACK, ACN and HBT of the other side. Out: ALR and ALA, or ALF, for each change within the share of
//! the line; ALC and HBT by their periods; ARC for a command that is refused. Which of them a port is told stands in
//! the table of `talk`.

use super::elsewhere::{CommandRefused, Elsewhere};
use super::machine::Alerts;
use super::peer::Peer;
use super::sentences::{INSTANCE, ala, alc, alf, alr, arc};
use super::table::Alert;
use crate::nmea::{
    Ack, Acn, AlertCommand, CommandStatus, EquipmentStatus, Eve, Hbt, Sentence, UtcTime,
};
use crate::post::Post;
use crate::station::{Output, PortIndex, PortSetup, Profile, Role};
use crate::talk::{self, Row, Saying, Share, When};
use crate::time::Stamp;
use alloc::collections::VecDeque;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// The reports of a station, a queue for each of its ports.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Reports {
    station: Role,
    queues: Vec<Queue>,
}

/// What waits to be told on a port.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct Queue {
    /// Alerts that have changed, the newest first.
    waiting: VecDeque<Alert>,
    /// Lines that are made and wait for their share.
    lines: VecDeque<String>,
    share: Share,
    /// Numbers of the next ALF, ALC and HBT.
    next: [u32; 3],
    /// When the next of each period is due.
    due: Vec<(u64, Stamp)>,
    /// Whose heartbeat was heard.
    peer: Option<Peer>,
}

/// The next number of a kind, which goes on with 0 behind `most`.
fn number(next: &mut u32, most: u32) -> u32 {
    let now = *next;
    *next = if now >= most { 0 } else { now + 1 };
    now
}

impl Reports {
    /// AP-11: at start-up ALR and ALA tell every alert.
    pub(crate) fn new(station: Role, ports: &[PortSetup]) -> Self {
        let queue = |port: &PortSetup| {
            let rows = talk::told(station, port.profile);
            let told = port.output && rows.iter().any(|row| row.saying == Saying::Alr);
            Queue {
                waiting: Alert::of(station).filter(|_| told).collect(),
                ..Queue::default()
            }
        };
        Self {
            station,
            queues: ports.iter().map(queue).collect(),
        }
    }

    /// Says what is due, on each port within its share. It is called every `step_ms`; `unit` is the unit of the autopilot
    /// that reports (ALA 4: 00 standby, 01 autopilot, 03 installation).
    pub(crate) fn say(
        &mut self,
        now: Stamp,
        step_ms: u64,
        unit: u32,
        alerts: &mut Alerts,
        post: &mut Post,
        out: &mut Vec<Output>,
    ) {
        let (changed, revised) = (alerts.take_changed(), alerts.take_revised());
        for (port, queue) in self.queues.iter_mut().enumerate() {
            let Some(setup) = post.ports().get(port).filter(|port| port.output) else {
                continue;
            };
            let baud = setup.baud;
            let rows = talk::told(self.station, setup.profile);
            let full = rows.iter().any(|row| row.saying == Saying::Alf);
            let plain = rows.iter().any(|row| row.saying == Saying::Alr);
            let news: &[Alert] = match (full, plain) {
                (true, _) => &revised,
                (false, true) => &changed,
                (false, false) => &[],
            };
            for alert in news {
                queue.waiting.retain(|waiting| waiting != alert);
                queue.waiting.push_front(*alert);
            }
            for line in queue.periodic(now, rows, alerts) {
                post.say(now, port, &line, out);
            }
            loop {
                let Some(line) = queue.lines.front() else {
                    let Some(alert) = queue.waiting.pop_front() else {
                        break;
                    };
                    let at = alerts.changed_at(alert).unwrap_or(now);
                    let utc = utc(post, now, at);
                    for row in rows {
                        queue.make(row, alerts, alert, unit, utc);
                    }
                    continue;
                };
                if !queue.share.take(now, step_ms, baud, line) {
                    break;
                }
                post.say(now, port, line, out);
                queue.lines.pop_front();
            }
        }
    }

    /// Takes what the other side of a port says of alerts. What it may not ask, or asks in vain, is given in an officer's words.
    pub(crate) fn hear(
        &mut self,
        now: Stamp,
        port: PortIndex,
        profile: Profile,
        sentence: &Sentence<'_>,
        alerts: &mut Alerts,
    ) -> Option<String> {
        let queue = self.queues.get_mut(port)?;
        let by = Elsewhere {
            // A chart system shows the reasons of alerts; alert management and hand-held units show texts.
            shows_reason: profile == Profile::Ecdis,
            alive: queue.peer.is_some_and(|peer| peer.trouble(now).is_none()),
        };
        if let Some(heartbeat) = Hbt::from_sentence(sentence) {
            queue.peer = Some(Peer::heard(now, &heartbeat));
            return None;
        }
        if let Some(ack) = Ack::from_sentence(sentence) {
            let number = ack.number?;
            let alert = u16::try_from(number).ok().and_then(Alert::of_number);
            let done = match self.own(alert) {
                Some(alert) => alerts.obey(now, alert, AlertCommand::Acknowledge, by),
                None => Err(CommandRefused::Unknown),
            };
            return Some(format!("ACK of alert {number}: {}", done.err()?));
        }
        let asked = Acn::from_sentence(sentence)?;
        let whole = sentence.faults().is_empty() && asked.status == Some(CommandStatus::Command);
        let command = asked.command.filter(|_| whole)?;
        let refused = self.obey(now, port, &asked, command, by, alerts).err()?;
        let told = talk::told(self.station, profile);
        if let Some(row) = told.iter().find(|row| row.saying == Saying::Arc) {
            let line = arc(&asked).line(row.talker.unwrap_or_default());
            self.queues[port].lines.push_front(line);
        }
        let of = asked
            .alert
            .map_or(String::new(), |alert| format!(" of alert {alert}"));
        Some(format!("ACN{of}: {refused}"))
    }

    /// What an ACN asks; without an identifier it asks it of all.
    fn obey(
        &mut self,
        now: Stamp,
        port: PortIndex,
        asked: &Acn,
        command: AlertCommand,
        by: Elsewhere,
        alerts: &mut Alerts,
    ) -> Result<(), CommandRefused> {
        let ours = asked.manufacturer.as_ref().is_none_or(String::is_empty)
            && asked.instance.is_none_or(|instance| instance == INSTANCE);
        let queue = self.queues.get_mut(port);
        match (asked.alert, command, queue) {
            _ if !ours => Err(CommandRefused::Unknown),
            (None, AlertCommand::Silence, _) => {
                alerts.silence(now);
                Ok(())
            }
            (None, AlertCommand::Request, Some(queue)) => {
                let standing = alerts.standing().iter().map(|standing| standing.alert);
                queue.waiting = standing.collect();
                Ok(())
            }
            (None, ..) => Err(CommandRefused::Unknown),
            (Some(identifier), command, _) => {
                let alert = self.own(Alert::of_identifier(identifier));
                let alert = alert.ok_or(CommandRefused::Unknown)?;
                alerts.obey(now, alert, command, by)?;
                let queue = self.queues.get_mut(port);
                if let (AlertCommand::Request, Some(queue)) = (command, queue) {
                    queue.waiting.retain(|waiting| *waiting != alert);
                    queue.waiting.push_front(alert);
                }
                Ok(())
            }
        }
    }

    /// Gives a line of its own to a port, as soon as its share allows.
    pub(crate) fn add(&mut self, port: PortIndex, line: String) {
        if let Some(queue) = self.queues.get_mut(port) {
            queue.lines.push_back(line);
        }
    }

    /// Tells by EVE, where a port is told it, that somebody operates this station (TCS-13, F2).
    pub(crate) fn operated(&mut self, now: Stamp, tag: &str, talker: &str, post: &Post) {
        let eve = Eve {
            time: utc(post, now, now),
            tag: Some(tag.into()),
            text: Some("OPERATION".into()),
        };
        for (port, setup) in post.ports().iter().enumerate() {
            let rows = talk::told(self.station, setup.profile);
            if setup.output && rows.iter().any(|row| row.saying == Saying::Eve) {
                self.add(port, eve.line(talker));
            }
        }
    }

    /// An alert that this station may raise.
    fn own(&self, alert: Option<Alert>) -> Option<Alert> {
        alert.filter(|alert| alert.station() == self.station)
    }

    /// Heartbeats that are not heard any more, or say that their system has failed: raises `lost` with the ports, and takes
    /// back what they answered for.
    pub(crate) fn supervise(
        &self,
        now: Stamp,
        lost: Alert,
        ports: &[PortSetup],
        alerts: &mut Alerts,
    ) {
        let mut text = String::new();
        for (queue, port) in self.queues.iter().zip(ports) {
            if let Some(trouble) = queue.peer.and_then(|peer| peer.trouble(now)) {
                let comma = if text.is_empty() { "" } else { ", " };
                text += &format!("{comma}{}: {trouble}", port.name);
            }
        }
        if text.is_empty() {
            alerts.rectify(now, lost);
        } else {
            alerts.take_back(now);
            alerts.raise(now, lost, &text);
        }
    }
}

impl Queue {
    /// ALC and HBT, each by its period; the first at once.
    fn periodic(&mut self, now: Stamp, rows: &[Row], alerts: &Alerts) -> Vec<String> {
        let mut said = Vec::new();
        for row in rows {
            let (Some(talker), When::Every(period)) = (row.talker, row.when) else {
                continue;
            };
            let made = match row.saying {
                Saying::Alc => 1,
                Saying::Hbt => 2,
                _ => continue,
            };
            let due = self.due.iter_mut().find(|(kind, _)| *kind == made);
            match due {
                Some((_, at)) if now < *at => continue,
                Some((_, at)) => *at = now + period,
                None => self.due.push((made, now + period)),
            }
            if row.saying == Saying::Alc {
                let pages = alc(alerts, number(&mut self.next[1], 99));
                said.extend(pages.iter().map(|page| page.line(talker)));
            } else {
                let heartbeat = Hbt {
                    interval: Some(period as f64 / 1_000.0),
                    status: Some(EquipmentStatus::Normal),
                    sequence: Some(number(&mut self.next[2], 9)),
                };
                said.push(heartbeat.line(talker));
            }
        }
        said
    }

    /// Makes the lines of an alert that a row tells.
    fn make(&mut self, row: &Row, alerts: &Alerts, alert: Alert, unit: u32, utc: Option<UtcTime>) {
        let talker = row.talker.unwrap_or_default();
        match row.saying {
            Saying::Alr => self.lines.push_back(alr(alerts, alert).line(talker)),
            Saying::Ala => self.lines.push_back(ala(alerts, alert, unit).line(talker)),
            Saying::Alf => {
                let sequence = number(&mut self.next[0], 9);
                self.lines.extend(alf(alerts, alert, sequence, utc, talker));
            }
            _ => {}
        }
    }
}

/// The time of day at `at`, by what the position receiver says; absent where it says none (ALF 4).
fn utc(post: &Post, now: Stamp, at: Stamp) -> Option<UtcTime> {
    const DAY_MS: i64 = 86_400_000;
    let fix = post.picture.fix(now)?;
    let said = (fix.value.utc? * 1_000.0) as i64;
    let since = i64::try_from(at.0).ok()? - i64::try_from(fix.at.0).ok()?;
    let ms = (said + since).rem_euclid(DAY_MS) as u64;
    Some(UtcTime {
        hour: (ms / 3_600_000) as u8,
        minute: (ms / 60_000 % 60) as u8,
        centisecond: (ms % 60_000 / 10) as u16,
    })
}
