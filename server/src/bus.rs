//! What passes between the rooms of the server: types and channels, nothing else.
//!
//! Orders and bytes have a queue each, so that STANDBY never waits behind what a line says (AP-25). Neither
//! queue has an end of its own: every port and every client has a number of places, and what finds none is
//! refused to that one alone.

use crate::outbox::Outbox;
use crossbeam_channel::{Receiver, Sender, unbounded};
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, mpsc, oneshot};
use wheelover_core::station::Switch;
use wheelover_core::view::{
    AlertsDocument, Answer, Down, Hello, Line, OfferedRoute, Order, Snapshot,
};

/// Reads of one port that may wait; each is at most 1 KiB.
const READS: usize = 64;

/// A place in a queue; it is free again when this value is gone.
pub(crate) type Place = OwnedSemaphorePermit;

/// What the control thread is asked; taken before anything that was heard.
#[derive(Debug)]
pub(crate) enum Asked {
    /// Somebody commands.
    Order {
        /// The client's number for it.
        id: u64,
        /// The snapshot that it was pressed beside (AP-26).
        frame: Option<u64>,
        /// What.
        action: Order,
        /// Where the answer goes.
        answer: mpsc::UnboundedSender<Answer>,
        /// The client's place for it; STANDBY needs none.
        place: Option<Place>,
    },
    /// A contact is so now; it goes before what a line says.
    Contact {
        /// Which.
        switch: Switch,
        /// It is closed; absent where it cannot be read.
        closed: Option<bool>,
    },
    /// A client wants to begin.
    Hello(oneshot::Sender<Hello>),
    /// Somebody wants the alerts with their history.
    Alerts(oneshot::Sender<AlertsDocument>),
    /// Somebody looks at the route that is offered (TCS-13).
    Offered(oneshot::Sender<Option<OfferedRoute>>),
    /// The server ends.
    Stop,
}

/// What was heard.
#[derive(Debug)]
pub(crate) enum FromPort {
    /// Bytes.
    Bytes {
        /// Number of the port in the configuration.
        port: usize,
        /// The bytes.
        bytes: Vec<u8>,
        /// The port's place for them.
        place: Place,
    },
    /// A port came or went; never refused.
    PortUp {
        /// Number of the port in the configuration.
        port: usize,
        /// Whether it is there.
        up: bool,
    },
}

/// The way to the control thread.
#[derive(Clone, Debug)]
pub(crate) struct Inlet {
    asked: Sender<Asked>,
    heard: Sender<FromPort>,
}

/// The control thread's end of it.
#[derive(Debug)]
pub(crate) struct Queues {
    /// First.
    pub(crate) asked: Receiver<Asked>,
    /// While nothing is asked.
    pub(crate) heard: Receiver<FromPort>,
}

/// The control thread has ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Ended;

impl Inlet {
    /// The way, and its end.
    pub(crate) fn new() -> (Self, Queues) {
        let (ask, asked) = unbounded();
        let (hear, heard) = unbounded();
        let inlet = Self {
            asked: ask,
            heard: hear,
        };
        (inlet, Queues { asked, heard })
    }

    /// Asks; never waits.
    ///
    /// # Errors
    /// The control thread has ended.
    pub(crate) fn ask(&self, asked: Asked) -> Result<(), Ended> {
        self.asked.send(asked).map_err(|_| Ended)
    }

    /// The first frame for a client, as of now; none where the control thread has ended.
    pub(crate) async fn hello(&self) -> Option<Hello> {
        let (sender, receiver) = oneshot::channel();
        self.ask(Asked::Hello(sender)).ok()?;
        receiver.await.ok()
    }

    /// The alerts with their history, as of now; none where the control thread has ended.
    pub(crate) async fn alerts(&self) -> Option<AlertsDocument> {
        let (sender, receiver) = oneshot::channel();
        self.ask(Asked::Alerts(sender)).ok()?;
        receiver.await.ok()
    }

    /// The route that is offered, as of now; the outer none where the control thread has ended.
    pub(crate) async fn offered(&self) -> Option<Option<OfferedRoute>> {
        let (sender, receiver) = oneshot::channel();
        self.ask(Asked::Offered(sender)).ok()?;
        receiver.await.ok()
    }

    /// Gives bytes where their port has a place left; whether it had.
    #[must_use]
    pub(crate) fn hear(&self, link: &Link, bytes: Vec<u8>) -> bool {
        let Ok(place) = link.places.clone().try_acquire_owned() else {
            return false;
        };
        let port = link.index;
        self.heard
            .send(FromPort::Bytes { port, bytes, place })
            .is_ok()
    }

    /// Says how a contact is now.
    pub(crate) fn contact(&self, switch: Switch, closed: Option<bool>) {
        // Where nobody hears it any more, the server ends.
        let _ = self.ask(Asked::Contact { switch, closed });
    }

    /// Says that a port came or went.
    pub(crate) fn port_up(&self, link: &Link, up: bool) {
        let port = link.index;
        // Where nobody hears it any more, the server ends.
        let _ = self.heard.send(FromPort::PortUp { port, up });
    }
}

/// A document of which a client has the newest, whole. A new one is a row here, and whoever makes it tells it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Document {
    /// The route.
    Route,
    /// The settings.
    Settings,
    /// State of the ports.
    Ports,
}

impl Document {
    /// All, in the order in which a client gets them.
    pub(crate) const ALL: [Self; 3] = [Self::Route, Self::Settings, Self::Ports];
}

/// What the control thread tells.
#[derive(Debug)]
pub(crate) enum News {
    /// Own facts, ten times a second.
    Snapshot(Box<Snapshot>),
    /// Lines heard and sent.
    Lines(Vec<Line>),
    /// A document has changed.
    Document(Document, Box<Down>),
}

/// What is wrong with a port, in an officer's words.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) enum Trouble {
    /// Nothing.
    #[default]
    None,
    /// It brings more than can be taken.
    Flooded,
    /// It does not take its output (FB11).
    Blocked,
    /// It is not there, for this reason.
    Away(String),
}

impl fmt::Display for Trouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::None => "",
            Self::Flooded => "too much heard at once: it is held back, and some may be lost",
            Self::Blocked => "output blocked: the other side does not read",
            Self::Away(reason) => reason,
        })
    }
}

/// One port as the rest of the server sees it.
#[derive(Clone, Debug)]
pub(crate) struct Link {
    /// Its number among the ports of the configuration.
    pub(crate) index: usize,
    /// Its name.
    pub(crate) name: String,
    /// What is to be sent; none where nothing may leave it.
    pub(crate) outbox: Option<Arc<Outbox>>,
    places: Arc<Semaphore>,
    trouble: Arc<Mutex<Trouble>>,
}

impl Link {
    /// A port of which nothing is known yet.
    pub(crate) fn new(index: usize, name: &str, may_send: bool) -> Self {
        Self {
            index,
            name: name.to_owned(),
            outbox: may_send.then(Arc::default),
            places: Arc::new(Semaphore::new(READS)),
            trouble: Arc::default(),
        }
    }

    /// What is wrong with it.
    pub(crate) fn trouble(&self) -> Trouble {
        let trouble = self.trouble.lock();
        trouble.unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Notes what is wrong with it; whether that is new.
    pub(crate) fn set_trouble(&self, now: Trouble) -> bool {
        let mut trouble = self.trouble.lock().unwrap_or_else(PoisonError::into_inner);
        let new = *trouble != now;
        *trouble = now;
        new
    }

    /// Notes that this is wrong no longer, whatever else may be.
    pub(crate) fn end_trouble(&self, over: &Trouble) {
        let mut trouble = self.trouble.lock().unwrap_or_else(PoisonError::into_inner);
        if *trouble == *over {
            *trouble = Trouble::None;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_port_that_floods_takes_no_place_from_another_and_none_from_orders() {
        let (inlet, queues) = Inlet::new();
        let (loud, quiet) = (Link::new(0, "loud", false), Link::new(1, "quiet", false));
        let taken = (0..1_000).filter(|_| inlet.hear(&loud, vec![b'A'; 1_024]));
        assert_eq!(taken.count(), READS);
        assert!(inlet.hear(&quiet, b"$HEHDT,1.0,T\r\n".to_vec()));
        assert_eq!(inlet.ask(Asked::Stop), Ok(()));
        drop(queues.heard.try_recv());
        assert!(inlet.hear(&loud, Vec::new()), "a place is free again");
        drop(queues);
        assert_eq!(inlet.ask(Asked::Stop), Err(Ended));
    }

    #[test]
    fn trouble_that_is_over_hides_no_other() {
        let link = Link::new(0, "gear", true);
        assert!(link.set_trouble(Trouble::Blocked));
        link.end_trouble(&Trouble::Flooded);
        assert_eq!(link.trouble(), Trouble::Blocked);
        link.end_trouble(&Trouble::Blocked);
        assert_eq!(link.trouble().to_string(), "");
    }
}
