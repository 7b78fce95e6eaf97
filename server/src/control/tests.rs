//! What the control thread takes first.

use super::*;
use crate::bus::Inlet;
use wheelover_core::view::ModeRequest;

// AP-25
#[test]
fn what_is_asked_last_is_taken_before_all_that_was_heard() {
    let (inlet, queues) = Inlet::new();
    let links: Vec<Link> = (0..8)
        .map(|index| Link::new(index, "port", false))
        .collect();
    for link in &links {
        while inlet.hear(link, vec![b'A'; 1_024]) {}
    }
    let full = queues.heard.len();
    assert!(full > 4 * BUDGET, "{full}");
    let (answer, mut answers) = mpsc::unbounded_channel();
    let action = Order::Mode(ModeRequest::Standby);
    let (id, place) = (7, None);
    let order = Asked::Order {
        id,
        frame: None,
        action,
        answer,
        place,
    };
    assert_eq!(inlet.ask(order), Ok(()));
    let (news, _told) = mpsc::channel(64);
    let mut thread = Thread::new(Parts {
        voyage: Voyage::embedded(1),
        ship: Outline::default(),
        rules: Rules::default(),
        links,
        news,
        recorder: None,
        keeper: None,
        lines: None,
    });
    thread.listen(&queues, Duration::ZERO);
    let answer = answers.try_recv().unwrap();
    assert_eq!((answer.id, answer.ok), (7, true), "{answer:?}");
    assert!(queues.heard.len() >= full - BUDGET);
}
