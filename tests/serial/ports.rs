//! Ports that are absent, silent, noisy or unplugged are said by name, with each cause counted, until they speak again (AP-11, FB8,
//! FB10, FD9).

use crate::autopilot;
use crate::ship::gyro;
use std::time::{Duration, Instant};
use wheelover_core::view::{AlertView, PortView};
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::{Line, Talker};
use wheelover_tests::{folder, with_checksum};

const PORT_FAIL: u16 = 151;
const NO_SENTENCE: u16 = 152;

fn alert(page: &Page, number: u16) -> Option<AlertView> {
    let alerts = &page.snapshot.as_ref()?.alerts;
    alerts.iter().find(|alert| alert.number == number).cloned()
}

fn says(page: &Page, number: u16, part: &str) -> bool {
    alert(page, number).is_some_and(|alert| alert.text.contains(part))
}

fn port(page: &Page, name: &str) -> PortView {
    let ports = page
        .ports
        .as_ref()
        .map(|document| document.ports.as_slice());
    let mut ports = ports.unwrap_or_default().iter();
    ports
        .find(|port| port.name == name)
        .cloned()
        .unwrap_or_default()
}

/// A receiver that says where it is, once a second.
fn receiver(line: &Line) -> Talker {
    line.talk(|tick| {
        let due = tick % 10 == 0;
        let body = "GPGLL,5400.0000,N,00730.0000,E,120000.00,A,D";
        due.then(|| with_checksum(body)).into_iter().collect()
    })
}

/// What 4800 baud look like to a line that listens at 38400: every bit is eight, and few bytes are letters.
fn wrong_rate(text: &str) -> Vec<u8> {
    let mut levels = Vec::new();
    for byte in text.bytes() {
        let bits = (0..8).map(|bit| byte >> bit & 1 == 1);
        for level in std::iter::once(false).chain(bits).chain([true]) {
            levels.extend([level; 8]);
        }
    }
    let mut heard = Vec::new();
    let mut at = 0;
    while let Some(begin) = levels[at..].iter().position(|level| !level) {
        let data = at + begin + 1;
        let Some(bits) = levels.get(data..data + 8) else {
            break;
        };
        heard.push((0..8).fold(0, |byte, bit| byte | u8::from(bits[bit]) << bit));
        at = data + 9;
        if at >= levels.len() {
            break;
        }
    }
    heard
}

/// Says what another rate would make of a sentence, ten times a second, until it is over.
async fn noise(line: &mut Line, page: &mut Page, holds: impl Fn(&Page) -> bool) -> u64 {
    let bytes = wrong_rate("$GPGLL,5400.0000,N,00730.0000,E,120000.00,A,D*6F\r\n");
    assert!(bytes.len() > 40 && !bytes.contains(&b'$'), "{bytes:?}");
    let begun = page.snapshot.as_ref().unwrap().at;
    let end = Instant::now() + SOON;
    while !holds(page) {
        assert!(Instant::now() < end, "{:?}", page.snapshot);
        line.send(&bytes);
        page.follow(Duration::from_millis(100)).await;
    }
    begun
}

#[tokio::test]
async fn a_port_without_a_valid_sentence_is_said_by_its_cause_until_one_comes() {
    let folder = folder("silent_port");
    let mut gps = Line::new(&folder.join("gps"));
    let compass = Line::new(&folder.join("gyro1"));
    let config = autopilot(&folder, &["gps", "gyro1"], false);
    let program = Program::start(&["--config", &config]);
    let _gyro = gyro(&compass, 100.0);
    let mut page = Page::open(program.address).await;
    // Silence.
    page.until("silence", SOON, |page| {
        says(page, NO_SENTENCE, "gps: nothing is heard. ")
    })
    .await;
    let talks = receiver(&gps);
    page.until("its end", SOON, |page| alert(page, NO_SENTENCE).is_none())
        .await;
    page.follow(Duration::from_secs(1)).await;
    drop(talks);
    // Another rate: by the program's own clock within 5 s.
    let begun = noise(&mut gps, &mut page, |page| {
        says(page, NO_SENTENCE, "gps: noise. ")
    })
    .await;
    let at = alert(&page, NO_SENTENCE).unwrap().at;
    assert!(at >= begun && at - begun <= 5_000, "{begun} {at}");
    page.until("its count", SOON, |page| port(page, "gps").garbage > 0)
        .await;
    let shown = port(&page, "gps");
    assert_eq!(shown.trouble, "no valid sentence: noise", "{shown:?}");
    assert!(shown.up && shown.bad_checksum == 0, "{shown:?}");
    assert_eq!(port(&page, "gyro1").trouble, "");
    // Wrong checksums are another cause, and both ports stand in the one alert.
    for _ in 0..3 {
        gps.send(b"$GPGLL,5400.0000,N,00730.0000,E,120000.00,A,D*00\r\n");
    }
    page.until("checksums", SOON, |page| {
        says(
            page,
            NO_SENTENCE,
            "gps: wrong or missing checksums, noise. ",
        )
    })
    .await;
    page.until("their count", SOON, |page| {
        port(page, "gps").bad_checksum == 3
    })
    .await;
    let _talks = receiver(&gps);
    page.until("its end", SOON, |page| alert(page, NO_SENTENCE).is_none())
        .await;
    page.until("no trouble", SOON, |page| {
        port(page, "gps").trouble.is_empty()
    })
    .await;
    assert_eq!(page.differed, [] as [u64; 0]);
}

#[tokio::test]
async fn an_absent_and_an_unplugged_port_fail_until_they_are_back() {
    let folder = folder("absent_port");
    let mut gps = Line::new(&folder.join("gps"));
    let mut compass = Line::new(&folder.join("gyro1"));
    compass.unplug();
    let config = autopilot(&folder, &["gps", "gyro1"], false);
    let program = Program::start(&["--config", &config]);
    let talks = receiver(&gps);
    let mut page = Page::open(program.address).await;
    page.until("PORT FAIL", SOON, |page| {
        says(page, PORT_FAIL, "gyro1: gone. ")
    })
    .await;
    page.until("it on the ports", SOON, |page| {
        let shown = port(page, "gyro1");
        !shown.up && !shown.trouble.is_empty() && port(page, "gps").up
    })
    .await;
    page.follow(Duration::from_secs(2)).await;
    // Unplugged: both in one alert, a second after the last that it said at most.
    gps.unplug();
    drop(talks);
    page.until("both", SOON, |page| {
        says(page, PORT_FAIL, "gps, gyro1: gone. ")
    })
    .await;
    compass.plug();
    let _gyro = gyro(&compass, 100.0);
    page.until("one again", SOON, |page| {
        says(page, PORT_FAIL, "gps: gone. ")
    })
    .await;
    gps.plug();
    let _talks = receiver(&gps);
    page.until("none", SOON, |page| {
        alert(page, PORT_FAIL).is_none() && alert(page, NO_SENTENCE).is_none()
    })
    .await;
    // FB8: within a second of the last that it said, by the program's own clock.
    page.follow(Duration::from_millis(500)).await;
    compass.unplug();
    page.until("PORT FAIL again", SOON, |page| {
        alert(page, PORT_FAIL).is_some()
    })
    .await;
    let mut lines = page.lines.iter().rev();
    let last = lines.find(|line| line.text.contains("HDT")).unwrap().at;
    let at = alert(&page, PORT_FAIL).unwrap().at;
    assert!(at >= last && at - last <= 1_500, "{last} {at}");
}
