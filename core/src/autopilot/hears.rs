//! What the autopilot does with a sentence that a port may say, and with one that its policy does not accept (FE11, SEN-2).

use super::Autopilot;
use super::report;
use crate::nmea::Sentence;
use crate::post::{Post, Station};
use crate::station::{Output, PortIndex, Profile};
use crate::time::Stamp;
use alloc::vec::Vec;

impl Autopilot {
    fn profile(&self, port: PortIndex) -> Option<Profile> {
        self.post.ports().get(port).map(|port| port.profile)
    }
}

impl Station for Autopilot {
    fn post(&mut self) -> &mut Post {
        &mut self.post
    }

    fn heard(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        let from_chart = self.profile(port) == Some(Profile::Ecdis);
        match sentence.formatter {
            "ACK" | "ACN" | "HBT" => {
                (self.alerts).hear(now, port, sentence, &self.post, &mut self.modes);
            }
            "APB" => self.decide(now, |modes, outlook, notices| {
                modes.on_apb(outlook, port, sentence, notices);
            }),
            "HTD" if self.profile(port) == Some(Profile::Stand) => {
                self.decide(now, |modes, outlook, notices| {
                    modes.on_stand(outlook, sentence, notices);
                });
            }
            "HSC" => self.decide(now, |modes, outlook, notices| {
                modes.on_hsc(outlook, port, sentence, notices);
            }),
            "XDR" | "HRM" => self.sight.hear_heel(now, port, sentence),
            _ if self.profile(port) == Some(Profile::Hmi) => {
                self.hear_hand_unit(now, port, sentence);
            }
            "HTC" if from_chart => self.decide(now, |modes, outlook, notices| {
                modes.on_htc(outlook, port, sentence, notices);
            }),
            "PNEY,001" | "PNEY,002" if from_chart => self.decide(now, |modes, outlook, _| {
                modes.on_distance(outlook, sentence, true);
            }),
            "XTE" | "RMB" | "BWC" | "BWR" | "BOD" => self.decide(now, |modes, outlook, _| {
                if from_chart {
                    modes.on_distance(outlook, sentence, true);
                }
                modes.on_plotted(outlook, port, sentence);
            }),
            _ => {}
        }
    }

    /// What is owed to hand units: answers, and settings that they changed or keep (EMC-2).
    fn answer(&mut self, now: Stamp, out: &mut Vec<Output>) {
        let due = self.hand_unit.take_due();
        if due.is_empty() {
            return;
        }
        let (modes, outlook) = self.modes_and_outlook(now);
        let (lines, kept) = report::owed(due, modes, &outlook);
        for (port, line) in lines {
            self.post.say(now, port, &line, out);
        }
        out.extend(kept);
    }

    fn refused(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        match (self.profile(port), sentence.formatter) {
            (Some(Profile::Ecdis | Profile::Plotter), "APB") => {
                self.decide(now, |modes, outlook, _| modes.on_broken_apb(outlook));
            }
            (Some(Profile::Hmi), formatter) if formatter.starts_with("PEMC") => {
                self.refuse_the_hand_unit(sentence, "checksum missing or wrong");
            }
            (Some(Profile::Ecdis), "HTC") => self.modes.on_broken_htc(now),
            (Some(Profile::Ecdis), _) => self.decide(now, |modes, outlook, _| {
                modes.on_distance(outlook, sentence, false);
            }),
            _ => {}
        }
    }
}
