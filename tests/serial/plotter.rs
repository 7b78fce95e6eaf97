//! A plotter on a serial line speaks APB, RMB and BWC; TRACK follows it, and it is told heading and rudder (AP-14, EMC-3, EMC-5).

use crate::autopilot;
use crate::ship::{gear, gyro};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use wheelover_core::view::{ModeName, ModeRequest, Order};
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::{Line, Talker};
use wheelover_tests::{folder, with_checksum};

const HEADING: f64 = 80.0;

/// Once a second a leg of 090 to DEST, the ship 0.10 miles left of it, by its sentences.
pub(crate) fn plotter(line: &Line, valid: Arc<AtomicBool>) -> Talker {
    line.talk(move |tick| {
        if tick % 10 != 0 {
            return Vec::new();
        }
        let status = if valid.load(Ordering::Relaxed) {
            'A'
        } else {
            'V'
        };
        [
            format!("GPRMB,{status},0.10,R,FROM,DEST,,,,,5.00,091.1,10.0,V,A"),
            "GPBWC,120000.00,,,,,091.1,T,,M,5.00,N,DEST,A".into(),
            format!("GPAPB,{status},A,0.10,R,N,V,V,090.0,T,DEST,091.1,T,,,A"),
        ]
        .map(|body| with_checksum(&body))
        .to_vec()
    })
}

pub(crate) fn mode(page: &Page) -> Option<ModeName> {
    let own = page.snapshot.as_ref()?.own.as_ref()?;
    Some(own.mode)
}

#[tokio::test]
async fn a_plotter_is_followed_told_and_left_when_it_has_no_position() {
    let folder = folder("plotter");
    let mut line = Line::new(&folder.join("plotter"));
    let compass = Line::new(&folder.join("gyro1"));
    let rudder = Line::new(&folder.join("gear"));
    let config = autopilot(&folder, &["plotter", "gyro1", "gear"], true);
    let program = Program::start(&["--config", &config]);
    let orders = gear(rudder);
    let _compass = gyro(&compass, HEADING);
    let valid = Arc::new(AtomicBool::new(true));
    let _plotter = plotter(&line, valid.clone());
    let mut page = Page::open(program.address).await;
    page.insist(Order::Mode(ModeRequest::Auto), SOON).await;
    page.insist(Order::Mode(ModeRequest::Track), SOON).await;
    page.until("TRACK", SOON, |page| mode(page) == Some(ModeName::Track))
        .await;
    // Left of the leg she is steered to starboard of its course, and the compass says 080.
    page.until("rudder to starboard", SOON, |_| {
        let orders = orders.lock().unwrap();
        orders.last().is_some_and(|(_, order)| *order > 3.0)
    })
    .await;
    let own = page.snapshot.as_ref().unwrap().own.clone().unwrap();
    let hts = own.hts.unwrap();
    assert!((95.0..130.0).contains(&hts), "{hts}");
    assert!((own.cross_track.unwrap() + 185.2).abs() < 0.1, "{own:?}");

    drop(line.listen(Duration::from_millis(100))); // what it was told until now
    let told = line.listen(Duration::from_secs(5));
    let count = |start: &str| {
        told.iter()
            .filter(|(_, line)| line.starts_with(start))
            .count()
    };
    assert!((4..=6).contains(&count("$HEHDT,080.0,T")), "{told:?}");
    assert!((4..=6).contains(&count("$AGRSA,")), "{told:?}");
    assert_eq!(count("$HEHDT,") + count("$AGRSA,"), told.len(), "{told:?}");

    valid.store(false, Ordering::Relaxed);
    page.until("AUTO", SOON, |page| mode(page) == Some(ModeName::Auto))
        .await;
    let own = page.snapshot.as_ref().unwrap().own.clone().unwrap();
    assert!((own.set_heading.unwrap() - HEADING).abs() < 0.2, "{own:?}");
    let alerts = &page.snapshot.as_ref().unwrap().alerts;
    let failed = alerts.iter().find(|alert| alert.title == "TRACK FAIL");
    let text = &failed.expect("TRACK FAIL").text;
    assert!(text.starts_with("APB: its status says not valid"), "{text}");
}
