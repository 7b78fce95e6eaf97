//! A contact that is wired to a line of a GPIO chip: looked at whenever it changes, and each 20 ms besides (AP-22).
//!
//! The kernel says the edges of a line (character device, second version of its interface: Linux 5.10) once it has been steady
//! for the debounce period. What is told is how the line is then, never an edge, so that one that was missed harms nothing.

use super::contacts::{Contacts, Lines, RETRY};
use crate::bus::Inlet;
use crate::config::{Bias, Contact, Wire};
use gpiocdev::Request;
use gpiocdev::line::{self, EdgeDetection, Value};
use std::path::{Path, PathBuf};
use std::time::Duration;
use tokio::io::unix::AsyncFd;
use tokio::time::sleep;

/// A line that bounces for less has not changed.
const DEBOUNCE: Duration = Duration::from_millis(5);

/// A line that says when it changes.
trait Edges: Lines {
    /// Waits until it has changed since it was last waited for.
    async fn changed(&mut self);
}

/// A line of a chip that this program has asked for.
struct Line(AsyncFd<Request>);

impl Line {
    fn open(chip: &Path, wire: Wire) -> Result<Self, String> {
        let Wire::Gpio(number, bias) = wire else {
            return Err("not a line of a GPIO chip".to_owned());
        };
        let mut asked = Request::builder();
        asked
            .on_chip(chip)
            .with_consumer("wheelover")
            .with_line(number)
            .as_input()
            .with_edge_detection(EdgeDetection::BothEdges)
            .with_debounce_period(DEBOUNCE)
            .with_bias(match bias {
                Bias::AsIs => None,
                Bias::Disabled => Some(line::Bias::Disabled),
                Bias::PullUp => Some(line::Bias::PullUp),
                Bias::PullDown => Some(line::Bias::PullDown),
            });
        let request = asked.request().map_err(|error| error.to_string())?;
        #[expect(
            deprecated,
            reason = "what replaces it is unsafe code; a request owns its file and never changes it"
        )]
        let watched = AsyncFd::new(request);
        watched.map(Self).map_err(|error| error.to_string())
    }
}

impl Lines for Line {
    fn is_on(&mut self, wire: Wire) -> Option<bool> {
        let Wire::Gpio(number, _) = wire else {
            return None;
        };
        let value = self.0.get_ref().value(number);
        value.ok().map(|value| value == Value::Active)
    }
}

impl Edges for Line {
    async fn changed(&mut self) {
        match self.0.readable().await {
            Ok(mut ready) => {
                let request = ready.get_inner();
                while request.has_edge_event().is_ok_and(|has| has) {
                    if request.read_edge_event().is_err() {
                        break;
                    }
                }
                ready.clear_ready();
            }
            // The looks go on.
            Err(_) => std::future::pending().await,
        }
    }
}

/// Watches a contact at a chip, for ever.
pub(super) async fn watch(chip: PathBuf, contact: Contact, inlet: Inlet) {
    let open = |contact: &Contact| Line::open(&chip, contact.line);
    let say = |why: &str| {
        let name = contact.switch.name();
        tracing::warn!("contact {name} at {}: {why}", chip.display());
    };
    watch_by(&contact, &inlet, open, say).await;
}

/// The same by what opens the line; what hinders that is said once, until it is something else.
async fn watch_by<L: Edges>(
    contact: &Contact,
    inlet: &Inlet,
    mut open: impl FnMut(&Contact) -> Result<L, String>,
    mut say: impl FnMut(&str),
) {
    let mut contacts = Contacts::new(vec![contact.clone()]);
    let mut said = String::new();
    loop {
        let why = match open(contact) {
            Ok(mut line) => loop {
                contacts.look(Some(&mut line), inlet);
                if contacts.are_gone() {
                    break "it can be read no longer".to_owned();
                }
                tokio::select! {
                    () = contacts.due() => {}
                    () = line.changed() => {}
                }
            },
            Err(why) => {
                contacts.look(None, inlet);
                why
            }
        };
        if why != said {
            say(&why);
            said = why;
        }
        sleep(RETRY).await;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bus::{Asked, Queues};
    use crate::config::At;
    use std::sync::{Arc, Mutex};
    use wheelover_core::station::Switch;

    /// A line as a test sets it: on, off, or not to be read; and so many edges, at each of which it changes.
    #[derive(Clone, Default)]
    struct Wired {
        is: Arc<Mutex<Option<bool>>>,
        edges: Arc<Mutex<u32>>,
    }

    impl Lines for Wired {
        fn is_on(&mut self, _: Wire) -> Option<bool> {
            *self.is.lock().unwrap()
        }
    }

    impl Edges for Wired {
        async fn changed(&mut self) {
            let left = *self.edges.lock().unwrap();
            if left == 0 {
                std::future::pending::<()>().await;
            }
            *self.edges.lock().unwrap() -= 1;
            let mut is = self.is.lock().unwrap();
            *is = is.map(|on| !on);
        }
    }

    fn contact(inverted: bool) -> Contact {
        Contact {
            switch: Switch::Nfu,
            at: At::Chip("/dev/gpiochip0".into()),
            line: Wire::Gpio(17, Bias::PullUp),
            inverted,
        }
    }

    /// What is told next.
    async fn next(queues: &Queues) -> Option<bool> {
        for _ in 0..4_000 {
            match queues.asked.try_recv() {
                Ok(Asked::Contact { closed, .. }) => return closed,
                Ok(other) => panic!("{other:?}"),
                Err(_) => sleep(Duration::from_millis(5)).await,
            }
        }
        panic!("nothing is told");
    }

    // AP-22
    #[tokio::test]
    async fn a_line_is_told_at_its_edges_at_each_look_and_when_its_chip_comes_and_goes() {
        let (inlet, queues) = Inlet::new();
        let wired = Wired::default();
        let absent = || Err::<(), _>("no such device".to_owned());
        let there = Arc::new(Mutex::new(absent()));
        let said = Arc::new(Mutex::new(Vec::new()));
        let watching = {
            let (wired, there, said) = (wired.clone(), there.clone(), said.clone());
            tokio::spawn(async move {
                let open = move |_: &Contact| {
                    let there = there.lock().unwrap().clone();
                    there.map(|()| wired.clone())
                };
                let say = move |why: &str| said.lock().unwrap().push(why.to_owned());
                watch_by(&contact(true), &inlet, open, say).await;
            })
        };
        let set = |on| *wired.is.lock().unwrap() = on;
        assert_eq!(next(&queues).await, None, "no chip: not known");
        // It is tried again, and each edge is told in its order: a pulse that no look would have seen.
        set(Some(true));
        *wired.edges.lock().unwrap() = 6;
        *there.lock().unwrap() = Ok(());
        for closed in [false, true, false, true, false, true, false] {
            assert_eq!(next(&queues).await, Some(closed), "held up is open");
        }
        // Without an edge the next look sees it.
        set(Some(false));
        assert_eq!(next(&queues).await, Some(true));
        sleep(Duration::from_millis(100)).await;
        assert!(queues.asked.is_empty(), "nothing has changed");
        // The chip is taken away, and comes back.
        *there.lock().unwrap() = absent();
        set(None);
        assert_eq!(next(&queues).await, None);
        sleep(RETRY + Duration::from_millis(500)).await;
        assert!(queues.asked.is_empty(), "told once");
        set(Some(true));
        *there.lock().unwrap() = Ok(());
        assert_eq!(next(&queues).await, Some(false));
        let said = said.lock().unwrap().clone();
        let expect = [
            "no such device",
            "it can be read no longer",
            "no such device",
        ];
        assert_eq!(said, expect, "each reason once");
        watching.abort();
    }

    // FB8: what is absent is said in words, and nothing runs hot on it.
    #[tokio::test]
    async fn an_absent_chip_is_refused_in_words() {
        let absent = Path::new("/dev/gpiochip-none");
        let refused = Line::open(absent, Wire::Gpio(17, Bias::AsIs)).err();
        let text = refused.expect("it is not there");
        assert!(
            text.contains("gpiochip-none") || text.contains("No such file"),
            "{text}"
        );
        let no_chip = Line::open(Path::new("/dev/null"), Wire::Gpio(17, Bias::AsIs));
        assert!(no_chip.is_err(), "a device that is no chip");
    }
}
