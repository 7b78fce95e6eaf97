//! The post of a station: it hears its ports, keeps the picture of what they said, and speaks.
//!
//! In: bytes of a port, and that one came or went. Out: a [`Output::Line`] for each line heard or said, and [`Output::Send`] for what is said.
//! Every line is folded into the picture, so that a page that folds the same lines has the same picture.

mod watch;

use crate::limits::Quantity;
use crate::nmea::{self, Ear, Frame, Sentence};
use crate::picture::{Ground, Heard, Picture};
use crate::station::{Direction, Output, PortIndex, PortSetup, Role};
use crate::time::Stamp;
use crate::units::{RudderAngle, Speed};
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};
use watch::PortWatch;

/// Ports, ears, picture and voice of a station.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Post {
    /// What was heard and said, and on which ports.
    pub(crate) picture: Picture,
    ears: Vec<Ear>,
    watch: PortWatch,
    /// Nothing heard up to then counts (FA16).
    fresh_after: Option<Stamp>,
}

impl Post {
    /// A post that has heard nothing.
    pub(crate) fn new(station: Role, ports: Vec<PortSetup>) -> Self {
        Self {
            ears: ports.iter().map(|_| Ear::default()).collect(),
            watch: PortWatch::new(ports.len()),
            picture: Picture::new(station, ports),
            fresh_after: None,
        }
    }

    /// Its ports.
    pub(crate) fn ports(&self) -> &[PortSetup] {
        &self.picture.ports
    }

    /// FA16: the station stood still; everything must be heard again.
    pub(crate) fn stalled(&mut self, now: Stamp) {
        self.fresh_after = Some(now);
        self.watch.stalled(now);
    }

    /// A port to real equipment came or went (FB8).
    pub(crate) fn port_up(&mut self, now: Stamp, port: PortIndex, up: bool) {
        self.watch.set(now, port, up, &self.picture);
    }

    /// What is said of the ports whose device is gone; absent where there is none (FB8, FD9).
    pub(crate) fn gone(&self, now: Stamp) -> Option<String> {
        self.watch.gone(now, &self.picture)
    }

    /// What is said of the ports on which nothing valid comes; absent where there is none (FB10).
    pub(crate) fn no_sentence(&self, now: Stamp) -> Option<String> {
        self.watch.no_sentence(now, &self.picture)
    }

    /// Why nothing valid comes on a port, where nothing does, in an officer's words; and how many valid sentences came there
    /// that the dictionary does not know.
    pub(crate) fn port_state(&self, now: Stamp, port: PortIndex) -> (Option<String>, u64) {
        let quiet = self.watch.quiet(now, port, &self.picture);
        (quiet, self.watch.unknown(port))
    }

    /// A heard value that is usable and was heard since the last stall.
    pub(crate) fn fresh<T: Clone>(
        &self,
        heard: Option<&Heard<T>>,
        quantity: Quantity,
        now: Stamp,
    ) -> Option<T> {
        self.seen(now).fresh(heard, quantity)
    }

    /// What is seen at `now`.
    pub(crate) const fn seen(&self, now: Stamp) -> Seen<'_> {
        Seen {
            picture: &self.picture,
            now,
            fresh_after: self.fresh_after,
        }
    }

    /// Says a sentence on a port, where the port may speak.
    pub(crate) fn say(&mut self, now: Stamp, port: PortIndex, line: &str, out: &mut Vec<Output>) {
        self.say_together(now, port, &[line], out);
    }

    /// Says sentences that leave together.
    pub(crate) fn say_together(
        &mut self,
        now: Stamp,
        port: PortIndex,
        lines: &[&str],
        out: &mut Vec<Output>,
    ) {
        if !self.ports().get(port).is_some_and(|port| port.output) {
            return;
        }
        let length = lines.iter().map(|line| line.len() + 2).sum();
        let mut bytes = Vec::with_capacity(length);
        for line in lines {
            let text = line.as_bytes();
            self.picture.fold(now, port, Direction::Out, text);
            out.push(Output::Line {
                port,
                dir: Direction::Out,
                text: text.to_vec(),
            });
            bytes.extend_from_slice(text);
            bytes.extend_from_slice(b"\r\n");
        }
        out.push(Output::Send { port, bytes });
    }
}

/// The picture at one time, and what of it counts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen<'a> {
    /// What was heard and said.
    pub(crate) picture: &'a Picture,
    /// The time.
    pub(crate) now: Stamp,
    fresh_after: Option<Stamp>,
}

impl Seen<'_> {
    /// A heard value that is usable and was heard since the last stall.
    pub(crate) fn fresh<T: Clone>(self, heard: Option<&Heard<T>>, quantity: Quantity) -> Option<T> {
        let heard = heard?;
        if self.fresh_after.is_some_and(|after| heard.at <= after) {
            return None;
        }
        heard.usable(quantity, self.now).cloned()
    }

    /// Rudder angles as fed back: of the single rudder or the starboard one of a pair, and of the port one.
    pub(crate) fn rudders(self) -> [Option<RudderAngle>; 2] {
        let sides = [&self.picture.rudder, &self.picture.rudder_port];
        sides.map(|side| self.fresh(side.as_ref(), Quantity::Rudder))
    }

    /// Course and speed over ground.
    pub(crate) fn ground(self) -> Option<Ground> {
        self.fresh(self.picture.ground(self.now), Quantity::Ground)
    }

    /// Speed through the water.
    pub(crate) fn water_speed(self) -> Option<Speed> {
        self.fresh(self.picture.water_speed(self.now), Quantity::WaterSpeed)
    }

    /// When the station last stood still (FA16).
    pub(crate) const fn stalled_at(self) -> Option<Stamp> {
        self.fresh_after
    }
}

/// A station at its post.
pub(crate) trait Station {
    /// Its post.
    fn post(&mut self) -> &mut Post;

    /// Acts on a sentence that the port may say; it stands in the picture already.
    fn heard(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>);

    /// Says what a sentence that was just heard asks for.
    fn answer(&mut self, _now: Stamp, _out: &mut Vec<Output>) {}

    /// Notes a sentence that the port's policy does not accept.
    fn refused(&mut self, _now: Stamp, _port: PortIndex, _sentence: &Sentence<'_>) {}
}

/// Takes bytes of a port.
pub(crate) fn hear(
    station: &mut impl Station,
    now: Stamp,
    port: PortIndex,
    bytes: &[u8],
    out: &mut Vec<Output>,
) {
    let Some(mut ear) = station.post().ears.get_mut(port).map(core::mem::take) else {
        return;
    };
    let valid = |post: &Post| post.picture.counts.get(port).map(|count| count.heard);
    let before = valid(station.post());
    ear.hear(now, bytes, &mut |frame| {
        take(station, now, port, frame, out)
    });
    let post = station.post();
    post.ears[port] = ear;
    if valid(post) == before {
        post.watch.noise(now, port);
    }
}

/// SEN-1: takes lines whose end has not come.
pub(crate) fn time_out(station: &mut impl Station, now: Stamp, out: &mut Vec<Output>) {
    for port in 0..station.post().ears.len() {
        if station.post().ears[port].is_late(now) {
            let mut ear = core::mem::take(&mut station.post().ears[port]);
            ear.time_out(now, &mut |frame| take(station, now, port, frame, out));
            station.post().ears[port] = ear;
        }
    }
}

fn take(
    station: &mut impl Station,
    now: Stamp,
    port: PortIndex,
    frame: Frame<'_>,
    out: &mut Vec<Output>,
) {
    let sentence = nmea::decode(frame.text);
    let Post { picture, watch, .. } = station.post();
    let before = picture.counts.get(port).map(|count| count.heard);
    let accepted = picture.fold_sentence(now, port, Direction::In, &sentence);
    if picture.counts.get(port).map(|count| count.heard) != before {
        let known = sentence.known.is_some();
        watch.valid(now, port, (accepted, known), picture);
    }
    out.push(Output::Line {
        port,
        dir: Direction::In,
        text: frame.text.to_vec(),
    });
    if accepted {
        station.heard(now, port, &sentence);
    } else {
        station.refused(now, port, &sentence);
    }
    station.answer(now, out);
}
