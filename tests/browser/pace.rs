//! How soon a heading that was written to the serial line stands on the screen.

use crate::fed::Fed;
use std::time::Duration;

/// From the last byte on the line to the painted value, milliseconds, 99 of 100.
const LIMIT: f64 = 250.0;

/// So long it is measured.
const TIME: Duration = Duration::from_secs(30);

#[tokio::test]
async fn a_heading_is_painted_soon_after_its_last_byte() {
    let fed = Fed::start("pace").await;
    tokio::time::sleep(TIME).await;
    let mut waits = Vec::new();
    let mut last = None;
    for picture in fed.pictures().await {
        // The first picture of each value, but not of that which stood there when the watch began.
        if picture.said != last {
            if let (Some(said), Some(_)) = (picture.said, last) {
                waits.push(picture.at - said);
            }
            last = picture.said;
        }
    }
    waits.sort_by(f64::total_cmp);
    let of = |part: f64| waits[((waits.len() - 1) as f64 * part).round() as usize];
    println!(
        "serial byte to painted value: median {:.0} ms, p99 {:.0} ms, worst {:.0} ms, of {} headings at 10 Hz",
        of(0.5),
        of(0.99),
        of(1.0),
        waits.len()
    );
    assert!(
        waits.len() > 200,
        "{} of 300 headings were painted",
        waits.len()
    );
    assert!(of(0.99) <= LIMIT, "p99 is {:.0} ms", of(0.99));
    assert_eq!(fed.browser.errors(), [] as [String; 0]);
    fed.browser.close().await;
}
