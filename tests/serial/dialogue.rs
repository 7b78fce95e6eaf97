//! A recorded chart-system dialogue goes in; HTD, RSA and ROR come out, also after the plug was pulled (FB8, FB9).

use crate::ship::{gear, gyro};
use crate::{autopilot, command, fields};
use std::time::{Duration, Instant};
use wheelover_core::view::{ModeRequest, Order};
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::{Line, Talker};
use wheelover_tests::{data, folder};

/// Lines to the autopilot of a dialogue, with the tenth of a second at which each is said.
fn recorded(name: &str) -> Vec<(u64, String)> {
    let text = std::fs::read_to_string(data(&format!("dialogues/{name}"))).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let lines = lines.filter_map(|line| line.split_once(" < "));
    lines
        .map(|(at, line)| {
            (
                (at.parse::<f64>().unwrap() * 10.0).round() as u64,
                line.to_string(),
            )
        })
        .collect()
}

fn play(line: &Line, dialogue: Vec<(u64, String)>) -> Talker {
    line.talk(move |tick| {
        let now = dialogue.iter().filter(|(at, _)| *at == tick);
        now.map(|(_, line)| line.clone()).collect()
    })
}

/// Seconds between sentences of one formatter.
fn periods(lines: &[(Instant, String)], formatter: &str) -> Vec<f64> {
    let of = |line: &&(Instant, String)| line.1.starts_with(formatter);
    let times: Vec<Instant> = lines.iter().filter(of).map(|line| line.0).collect();
    times
        .windows(2)
        .map(|pair| (pair[1] - pair[0]).as_secs_f64())
        .collect()
}

#[tokio::test]
async fn a_recorded_dialogue_is_followed_and_answered_each_second() {
    let folder = folder("dialogue");
    let mut ecdis = Line::new(&folder.join("ecdis"));
    let compass = Line::new(&folder.join("gyro1"));
    gear(Line::new(&folder.join("gear")));
    let config = autopilot(&folder, &["ecdis", "gyro1", "gear"], true);
    let program = Program::start(&["--config", &config]);
    let _compass = gyro(&compass, 245.0);
    let mut page = Page::open(program.address).await;
    page.insist(Order::Mode(ModeRequest::Auto), SOON).await;
    page.leave().await;
    let _chart = play(&ecdis, recorded("track_on_a_leg.txt"));
    let answer = command(&program, Order::Mode(ModeRequest::Autonav)).await;
    assert!(answer.ok, "{}", answer.text);

    let lines = ecdis.listen(Duration::from_secs(22));
    let htd: Vec<Vec<&str>> = lines
        .iter()
        .filter(|line| line.1.starts_with("$AGHTD"))
        .map(|line| fields(&line.1))
        .collect();
    assert!(htd.iter().all(|fields| fields.len() == 18), "{htd:?}");
    // The last HTD: track control on a leg (AP-2).
    let last = htd.last().unwrap();
    let shown: Vec<(usize, &str)> = [1, 4, 5, 6, 8, 9, 11, 12, 13, 16]
        .map(|index| (index, last[index]))
        .to_vec();
    let expect = [
        (1, "V"),
        (4, "T"),
        (5, "N"),
        (6, "35.0"),
        (8, "0.500"),
        (9, ""),
        (11, ""),
        (12, "245.0"),
        (13, "T"),
        (16, ""),
    ];
    assert_eq!(shown, expect, "{last:?}");
    assert_eq!(last[17], "245.0", "the gyro's heading");
    let hts: f64 = last[10].parse().unwrap();
    assert!((215.0..275.0).contains(&hts), "{hts}");
    let before = htd
        .iter()
        .find(|fields| fields[4] == "S")
        .expect("AUTO before");
    assert_eq!((before[5], before[10], before[12]), ("N", "", ""));
    let find = |formatter: &str| {
        let found = lines
            .iter()
            .rev()
            .find(|line| line.1.starts_with(formatter));
        found.unwrap_or_else(|| panic!("no {formatter}")).1.clone()
    };
    let (rsa, ror) = (find("$AGRSA"), find("$AGROR"));
    let rsa = fields(&rsa);
    assert_eq!((rsa[2], rsa[3], rsa[4]), ("A", "", "V"));
    let ror = fields(&ror);
    assert_eq!((ror[2], ror[3], ror[4], ror[5]), ("A", "", "V", "B"));
    for formatter in ["$AGHTD", "$AGRSA", "$AGROR", "$HEHDT"] {
        let periods = periods(&lines, formatter);
        assert!(periods.len() >= 15, "{formatter} {periods:?}");
        let mean = periods.iter().sum::<f64>() / periods.len() as f64;
        assert!((0.95..1.05).contains(&mean), "{formatter} {mean}");
        // CON-1; a busy machine may delay this reader, so one in ten may be outside.
        let outside = periods
            .iter()
            .filter(|period| !(0.8..=1.2).contains(*period));
        assert!(
            outside.count() <= periods.len() / 10,
            "{formatter} {periods:.2?}"
        );
    }
}

#[tokio::test]
async fn a_pulled_plug_is_shown_and_comes_back_by_itself() {
    let folder = folder("unplug");
    let mut ecdis = Line::new(&folder.join("ecdis"));
    let compass = Line::new(&folder.join("gyro1"));
    let config = autopilot(&folder, &["ecdis", "gyro1"], true);
    let program = Program::start(&["--config", &config]);
    let _compass = gyro(&compass, 100.0);
    assert!(ecdis.hear(SOON).is_some());
    let mut page = Page::open(program.address).await;
    page.until("the port up", SOON, |page| state(page) == Some(true))
        .await;
    for round in 0..3 {
        let pulled = Instant::now();
        ecdis.unplug();
        page.until("the port down", SOON, |page| state(page) == Some(false))
            .await;
        // FB8: 1 s, and the document goes out once a second.
        let took = pulled.elapsed();
        assert!(took < Duration::from_secs(3), "round {round}: {took:?}");
        let ports = &page.ports.as_ref().unwrap().ports;
        assert!(
            ports.iter().any(|port| !port.trouble.is_empty()),
            "{ports:?}"
        );
        // The heading still comes: the other port is not touched.
        let mut before = page.line;
        page.until("more lines", SOON, |page| page.line > before + 10)
            .await;
        before = page.line;
        ecdis.plug();
        let plugged = Instant::now();
        let heard = ecdis.hear(SOON);
        assert!(
            heard.is_some(),
            "round {round}: nothing after the plug is back"
        );
        assert!(
            plugged.elapsed() < Duration::from_secs(6),
            "{:?}",
            plugged.elapsed()
        );
        page.until("the port up again", SOON, |page| {
            state(page) == Some(true) && page.line > before
        })
        .await;
    }
    assert_eq!(page.gaps, [] as [u64; 0]);
}

fn state(page: &Page) -> Option<bool> {
    let ports = page.ports.as_ref()?;
    let port = ports.ports.iter().find(|port| port.name == "ecdis")?;
    Some(port.up)
}

// CFG-1: outputs are off until they are enabled.
#[tokio::test]
async fn nothing_leaves_a_port_until_output_is_allowed() {
    let folder = folder("silent");
    let mut ecdis = Line::new(&folder.join("ecdis"));
    let compass = Line::new(&folder.join("gyro1"));
    let mut rudder = Line::new(&folder.join("gear"));
    let config = autopilot(&folder, &["ecdis", "gyro1", "gear"], false);
    let program = Program::start(&["--config", &config]);
    let _compass = gyro(&compass, 100.0);
    let mut page = Page::open(program.address).await;
    page.insist(Order::Mode(ModeRequest::Auto), SOON).await;
    let lines = page.line;
    page.until("five seconds of lines", SOON, |page| page.line > lines + 80)
        .await;
    assert_eq!(ecdis.listen(Duration::from_millis(500)), []);
    assert_eq!(rudder.listen(Duration::from_millis(500)), []);
}
