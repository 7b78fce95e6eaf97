//! Ports to the outside that are gone, silent or noisy are said, each by its name, and it is over when they speak again (AP-11,
//! FB8, FB10).

use crate::rig::{Rig, outside};
use wheelover_core::alerts::{Alert, Past};
use wheelover_core::station::{Profile, Role};
use wheelover_core::view::{PortView, ports_document};

/// Two compasses and a hand unit behind ports of the autopilot, beside what is cabled inside.
fn rig() -> Rig {
    Rig::tracking_with(vec![
        outside(Role::Autopilot, "bow", Profile::Gyro2),
        outside(Role::Autopilot, "mast", Profile::Thd),
        outside(Role::Autopilot, "hand", Profile::Hmi),
        outside(Role::Autopilot, "log book", Profile::Monitor),
    ])
}

/// What comes on each of the first three ports, once a second.
type Says<'a> = [&'a dyn Fn(&mut Rig, usize); 3];

fn heading(rig: &mut Rig, port: usize) {
    let heading = rig.heading().deg();
    rig.sentence(port, &format!("HEHDT,{heading:.1},T"));
}

fn nothing(_: &mut Rig, _: usize) {}

fn garbage(rig: &mut Rig, port: usize) {
    rig.bytes(port, b"\xf3\x8a}z\x01\xb2qq\xff\r\n\xc4k");
}

/// A second at a time until the alert stands as `holds` says; seconds it took.
fn until(rig: &mut Rig, says: &Says<'_>, alert: Alert, holds: bool) -> f64 {
    let begun = rig.now;
    let mut tenths = 0;
    while rig.raised(alert) != holds {
        assert!(tenths < 100, "{alert:?} is not {holds}");
        if tenths % 10 == 0 {
            for (port, say) in says.iter().enumerate() {
                say(rig, port);
            }
        }
        rig.step();
        tenths += 1;
    }
    rig.now.since(begun) as f64 / 1_000.0
}

fn run(rig: &mut Rig, says: &Says<'_>, seconds: u32) {
    for _ in 0..seconds {
        for (port, say) in says.iter().enumerate() {
            say(rig, port);
        }
        rig.run(1.0);
    }
}

// FB8, FD9
#[test]
fn a_port_that_is_gone_is_said_within_a_second_until_it_speaks_again() {
    let mut rig = rig();
    assert!(!rig.raised(Alert::PortFail), "nothing was tried yet");
    for port in [0, 1, 3] {
        rig.plug(port, false);
    }
    let fine: Says<'_> = [&heading, &heading, &nothing];
    let took = until(&mut rig, &[&nothing; 3], Alert::PortFail, true);
    assert!(took <= 1.0, "{took}");
    // Of the port that nobody listens to nothing is said.
    assert_eq!(
        rig.text(Alert::PortFail),
        "bow, mast: gone. Check plug and device"
    );
    rig.plug(0, true);
    run(&mut rig, &[&heading, &nothing, &nothing], 2);
    assert_eq!(
        rig.text(Alert::PortFail),
        "mast: gone. Check plug and device"
    );
    let past: Vec<&Past> = rig.autopilot().alerts().history().collect();
    assert_eq!(past[0].detail, "mast: gone. Check plug and device");
    rig.plug(1, true);
    let took = until(&mut rig, &fine, Alert::PortFail, false);
    assert!(took <= 1.0, "{took}");
    run(&mut rig, &fine, 8);
    assert!(
        !rig.raised(Alert::NoSentence),
        "{}",
        rig.text(Alert::NoSentence)
    );
}

// FB10
#[test]
fn silence_and_noise_are_said_within_five_seconds_with_each_port_and_its_cause() {
    let mut rig = rig();
    for port in 0..4 {
        rig.plug(port, true);
    }
    let fine: Says<'_> = [&heading, &heading, &nothing];
    run(&mut rig, &fine, 10);
    assert!(
        !rig.raised(Alert::NoSentence),
        "{}",
        rig.text(Alert::NoSentence)
    );
    // The monitor's noise is nobody's.
    let noise: Says<'_> = [
        &heading,
        &|rig, port| {
            garbage(rig, port);
            garbage(rig, 3);
        },
        &nothing,
    ];
    let took = until(&mut rig, &noise, Alert::NoSentence, true);
    assert!((2.0..=5.0).contains(&took), "{took}");
    let said = rig.text(Alert::NoSentence);
    assert!(said.starts_with("mast: noise. Check line"), "{said}");
    // The second joins the first, in the same alert; the hand unit's silence is none.
    let both: Says<'_> = [&nothing, &garbage, &nothing];
    run(&mut rig, &both, 6);
    let said = rig.text(Alert::NoSentence);
    assert!(
        said.starts_with("bow: nothing is heard; mast: noise. "),
        "{said}"
    );
    // Its noise is a fault.
    let all: Says<'_> = [&nothing, &garbage, &garbage];
    run(&mut rig, &all, 6);
    let said = rig.text(Alert::NoSentence);
    assert!(said.contains("; mast: noise; hand: noise. "), "{said}");
    let ports = rig.ports();
    let [bow, mast, hand, book] = &ports[..4] else {
        panic!("{ports:?}")
    };
    assert_eq!(bow.trouble, "no valid sentence: nothing is heard");
    assert_eq!(mast.trouble, "no valid sentence: noise");
    assert!(
        mast.garbage > 10 && hand.garbage > 4 && book.garbage > 1,
        "{ports:?}"
    );
    assert_eq!(book.trouble, "");
    // Quiet again is enough for the hand unit, which speaks when it has something to say.
    let healed: Says<'_> = [&heading, &heading, &nothing];
    run(&mut rig, &healed, 1);
    assert!(rig.text(Alert::NoSentence).starts_with("hand: noise. "));
    let took = until(&mut rig, &healed, Alert::NoSentence, false);
    assert!(took <= 5.0, "{took}");
    assert_eq!(rig.ports()[1].trouble, "");
}

// FB10: checksums, unknown sentences and those of another device are causes of their own, counted each.
#[test]
fn each_cause_has_its_words_and_its_counter() {
    let bad = |rig: &mut Rig, port: usize| rig.bytes(port, b"$HEHDT,100.0,T*00\r\n");
    let unknown = |rig: &mut Rig, port: usize| rig.sentence(port, "HEZZX,1");
    let other = |rig: &mut Rig, port: usize| rig.sentence(port, "VWMTW,12.5,C");
    for (say, words, counters) in [
        (
            &bad as &dyn Fn(&mut Rig, usize),
            "wrong or missing checksums",
            [8, 0, 0, 0],
        ),
        (&unknown, "unknown sentences", [0, 0, 8, 0]),
        (
            &other,
            "sentences that are not used from here",
            [0, 0, 0, 8],
        ),
    ] {
        let mut rig = rig();
        rig.plug(0, true);
        run(&mut rig, &[say, &nothing, &nothing], 8);
        let said = rig.text(Alert::NoSentence);
        assert!(said.starts_with(&format!("bow: {words}. ")), "{said}");
        let port = &rig.ports()[0];
        let is = [port.bad_checksum, port.garbage, port.unknown, port.unused];
        assert_eq!(is, counters, "{port:?}");
        let fine: Says<'_> = [&heading, &nothing, &nothing];
        let took = until(&mut rig, &fine, Alert::NoSentence, false);
        assert!(took <= 1.0, "{took}");
    }
}

// AP-11: the chart system's ports likewise.
#[test]
fn the_chart_system_says_the_same_of_its_ports() {
    let mut rig = Rig::tracking_with(vec![outside(Role::ChartSystem, "aft", Profile::Gps2)]);
    let stands = |rig: &Rig, alert| {
        let mut alerts = rig.chart().alerts().iter();
        alerts.any(|standing| standing.alert == alert)
    };
    rig.plug(0, false);
    rig.run(0.1);
    assert!(stands(&rig, Alert::ChartPortFail));
    rig.plug(0, true);
    rig.until("the end of PORT FAIL", 2.5, |rig| {
        !stands(rig, Alert::ChartPortFail)
    });
    rig.until("NO VALID SENTENCE", 5.0, |rig| {
        stands(rig, Alert::ChartNoSentence)
    });
    rig.sentence(0, "GPVTG,245.0,T,,M,15.0,N,27.8,K,A");
    rig.until("its end", 1.1, |rig| !stands(rig, Alert::ChartNoSentence));
}

// The stations of the embedded voyage are cabled inside: nothing is said of ports there, whatever they say or not.
#[test]
fn nothing_is_said_of_cables_inside() {
    let mut rig = Rig::tracking();
    rig.silence(Profile::Gyro1, "");
    rig.run(30.0);
    assert!(rig.raised(Alert::HeadingLost));
    assert!(!rig.raised(Alert::NoSentence) && !rig.raised(Alert::PortFail));
    rig.filter(|_, _, line| Some(line.into()));
    rig.run(600.0);
    let mut past = rig.autopilot().alerts().history();
    assert!(past.all(|past| ![Alert::NoSentence, Alert::PortFail].contains(&past.alert)));
}

impl Rig {
    fn ports(&self) -> Vec<PortView> {
        ports_document(self.voyage()).ports
    }
}
