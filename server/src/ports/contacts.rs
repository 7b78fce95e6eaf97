//! Contacts that are wired to lines of devices: looked at, and told when they change; here those of serial devices (AP-22).

use crate::bus::Inlet;
use crate::config::{Contact, ControlLine, Wire};
use std::path::PathBuf;
use std::time::Duration;
use tokio::time::{Instant, sleep, sleep_until};
use tokio_serial::{SerialPort, SerialPortBuilderExt, SerialStream};

/// Between two looks.
const LOOK: Duration = Duration::from_millis(20);
/// A device that is not there is tried again so often.
pub(super) const RETRY: Duration = Duration::from_secs(1);
/// A device of its own carries no bytes.
const BAUD: u32 = 4_800;

/// The lines of a device, as they are now.
pub(super) trait Lines {
    /// Whether a line is on; absent where that cannot be read.
    fn is_on(&mut self, line: Wire) -> Option<bool>;
}

impl Lines for SerialStream {
    fn is_on(&mut self, line: Wire) -> Option<bool> {
        let read = match line {
            Wire::Control(ControlLine::Cts) => self.read_clear_to_send(),
            Wire::Control(ControlLine::Dsr) => self.read_data_set_ready(),
            Wire::Control(ControlLine::Dcd) => self.read_carrier_detect(),
            Wire::Control(ControlLine::Ri) => self.read_ring_indicator(),
            Wire::Gpio(..) => return None,
        };
        read.ok()
    }
}

/// Contacts of one device, and what was told of each last.
#[derive(Debug)]
pub(super) struct Contacts {
    told: Vec<(Contact, Option<Option<bool>>)>,
    next: Instant,
}

impl Contacts {
    /// Of which nothing has been told.
    pub(super) fn new(contacts: Vec<Contact>) -> Self {
        Self {
            told: contacts
                .into_iter()
                .map(|contact| (contact, None))
                .collect(),
            next: Instant::now(),
        }
    }

    /// Whether there is nothing to be looked at.
    pub(super) fn is_empty(&self) -> bool {
        self.told.is_empty()
    }

    /// Whether none could be read when it was last looked at: the device is gone.
    pub(super) fn are_gone(&self) -> bool {
        self.told.iter().all(|(_, told)| *told == Some(None))
    }

    /// Waits until the next look is due.
    pub(super) async fn due(&self) {
        sleep_until(self.next).await;
    }

    /// Looks, and tells what has changed; without lines nothing can be read.
    pub(super) fn look(&mut self, mut lines: Option<&mut dyn Lines>, inlet: &Inlet) {
        self.next = Instant::now() + LOOK;
        for (contact, told) in &mut self.told {
            let on = lines.as_mut().and_then(|lines| lines.is_on(contact.line));
            let closed = on.map(|on| on != contact.inverted);
            if *told != Some(closed) {
                *told = Some(closed);
                inlet.contact(contact.switch, closed);
            }
        }
    }
}

/// Watches the contacts at a device that is no port, for ever.
pub(super) async fn watch(path: PathBuf, contacts: Vec<Contact>, inlet: Inlet) {
    let mut contacts = Contacts::new(contacts);
    loop {
        let opened = tokio_serial::new(path.to_string_lossy(), BAUD).open_native_async();
        match opened {
            Ok(mut device) => loop {
                contacts.look(Some(&mut device), &inlet);
                if contacts.are_gone() {
                    break;
                }
                contacts.due().await;
            },
            Err(error) => {
                tracing::warn!("contacts at {}: {error}", path.display());
                contacts.look(None, &inlet);
            }
        }
        sleep(RETRY).await;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bus::Asked;
    use crate::config::At;
    use wheelover_core::station::Switch;

    /// Lines as a test sets them, in the order of the names.
    struct Set([Option<bool>; 4]);

    impl Lines for Set {
        fn is_on(&mut self, line: Wire) -> Option<bool> {
            match line {
                Wire::Control(line) => self.0[line as usize],
                Wire::Gpio(..) => None,
            }
        }
    }

    fn contact(switch: Switch, line: ControlLine, inverted: bool) -> Contact {
        Contact {
            switch,
            at: At::Port(0),
            line: Wire::Control(line),
            inverted,
        }
    }

    // AP-22
    #[tokio::test]
    async fn each_contact_is_told_by_its_line_when_it_changes() {
        let (inlet, queues) = Inlet::new();
        let mut contacts = Contacts::new(vec![
            contact(Switch::Nfu, ControlLine::Cts, false),
            contact(Switch::Ffu, ControlLine::Ri, false),
            contact(Switch::Autopilot, ControlLine::Dcd, true),
        ]);
        let told = || {
            let all = queues.asked.try_iter().map(|asked| match asked {
                Asked::Contact { switch, closed } => (switch, closed),
                other => panic!("{other:?}"),
            });
            all.collect::<Vec<_>>()
        };
        let mut lines = Set([Some(false), Some(true), Some(false), Some(false)]);
        contacts.look(Some(&mut lines), &inlet);
        let (nfu, ffu, autopilot) = (Switch::Nfu, Switch::Ffu, Switch::Autopilot);
        let at_first = [
            (nfu, Some(false)),
            (ffu, Some(false)),
            (autopilot, Some(true)),
        ];
        assert_eq!(told(), at_first);
        contacts.look(Some(&mut lines), &inlet);
        assert_eq!(told(), []);
        for (index, on, switch, closed) in [
            (0, Some(true), nfu, Some(true)),
            (3, Some(true), ffu, Some(true)),
            (2, Some(true), autopilot, Some(false)),
            (2, None, autopilot, None),
            (0, Some(false), nfu, Some(false)),
        ] {
            lines.0[index] = on;
            contacts.look(Some(&mut lines), &inlet);
            assert_eq!(told(), [(switch, closed)]);
        }
        lines.0[1] = None;
        contacts.look(Some(&mut lines), &inlet);
        assert_eq!(told(), [], "DSR is nobody's");
        contacts.look(None, &inlet);
        assert_eq!(told(), [(nfu, None), (ffu, None)], "the device is gone");
    }
}
