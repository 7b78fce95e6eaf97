//! The ship as the program sees her on serial lines: a compass that stands still, and a gear that is at once where it is ordered.

use crate::fields;
use std::sync::{Arc, Mutex};
use std::time::Instant;
use wheelover_tests::page::SOON;
use wheelover_tests::serial::{Line, Talker};
use wheelover_tests::with_checksum;

/// The orders that a gear heard, and when.
pub(crate) type Orders = Arc<Mutex<Vec<(Instant, f64)>>>;

/// A gear whose rudder is at once where it was ordered.
pub(crate) fn gear(mut line: Line) -> Orders {
    let orders = Orders::default();
    let heard = orders.clone();
    std::thread::spawn(move || {
        while let Some((at, order)) = line.hear(SOON) {
            if order.starts_with("$AGROR") {
                let angle: f64 = fields(&order)[1].parse().unwrap_or(0.0);
                heard.lock().unwrap().push((at, angle));
                line.say(&format!("IIRSA,{angle:.2},A,,V"));
            }
        }
    });
    orders
}

/// Ten times a second this heading, and no rate of turn.
pub(crate) fn gyro(line: &Line, heading: f64) -> Talker {
    line.talk(move |_| {
        vec![
            with_checksum(&format!("HEHDT,{heading:06.2},T")),
            with_checksum("HEROT,0.00,A"),
        ]
    })
}
