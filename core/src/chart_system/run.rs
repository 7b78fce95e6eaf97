//! The course of the station: bytes and orders in, a burst of sentences each second.

use super::state::{ChartSystem, Timer};
use crate::alerts::Alert;
use crate::command::Origin;
use crate::nmea::Sentence;
use crate::post::{self, Post, Station};
use crate::station::{Input, Output, PortIndex};
use crate::talk::SECOND_MS;
use crate::time::Stamp;
use alloc::string::String;
use alloc::vec::Vec;

impl ChartSystem {
    /// Runs what is due at `now`, then takes the input.
    pub fn handle(&mut self, now: Stamp, input: Input<'_>, out: &mut Vec<Output>) {
        self.run(now, out);
        match input {
            Input::Bytes { port, bytes } => post::hear(self, now, port, bytes, out),
            Input::Stalled { .. } => {
                self.post.stalled(now);
                self.guard.forget();
                self.stop_reckoning(now);
                self.followed.stalled(now);
            }
            Input::Order { by, order } => {
                if by == Origin::Officer {
                    self.operated(now);
                }
                out.push(Output::Answer(self.obey(now, order)));
            }
            Input::Port { port, up } => {
                self.post.port_up(now, port, up);
                self.watch_ports(now);
            }
            Input::Contact { .. } | Input::Tick => {}
        }
    }

    /// When the next sentences are due, or a silent autopilot is to be noticed.
    #[must_use]
    pub fn due(&self) -> Stamp {
        let next = self.timers.at(Timer::Second).unwrap_or(self.now);
        self.silent_at().map_or(next, |silent| next.min(silent))
    }

    fn run(&mut self, now: Stamp, out: &mut Vec<Output>) {
        let mut next = self.timers.begin(Timer::Second, now);
        // Late by more than two periods: the missed sentences are not made up for.
        if now.since(next) > 2 * SECOND_MS {
            next = next + now.since(next) / SECOND_MS * SECOND_MS;
        }
        while next <= now {
            self.step(next, out);
            next = next + SECOND_MS;
        }
        self.timers.set(Timer::Second, next);
        self.now = self.now.max(now);
        self.supervise(now);
    }

    /// One second: where the ship is, what is indicated, what is said.
    fn step(&mut self, now: Stamp, out: &mut Vec<Output>) {
        self.now = now;
        post::time_out(self, now, out);
        self.monitor(now);
        self.watch_ports(now);
        let call = self.watch_over(now);
        out.extend(call.map(Output::backup_navigator));
        let (lost, ports) = (Alert::ChartHeartbeatLost, self.post.ports());
        self.reports
            .supervise(now, lost, ports, &mut self.watch.alerts);
        for port in 0..self.post.ports().len() {
            let profile = self.post.ports()[port].profile;
            let lines: Vec<String> = self.sentences(now, profile).collect();
            for line in &lines {
                self.post.say(now, port, line, out);
            }
        }
        let alerts = &mut self.watch.alerts;
        self.reports
            .say(now, SECOND_MS, 0, alerts, &mut self.post, out);
    }
}

impl Station for ChartSystem {
    fn post(&mut self) -> &mut Post {
        &mut self.post
    }

    fn heard(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        self.hear_of_alerts(now, port, sentence);
        self.hear_of_routes(now, port, sentence);
        self.judge_fix(now);
        self.supervise(now);
    }
}
