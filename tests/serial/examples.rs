//! Every printed example of document N on a serial line, and those of E that a chart system or a plotter says: as printed, and
//! mended as the dialogue that it belongs to (SEN-2, SEN-5, SEN-6, TCS-1 to TCS-4, AP-1 to AP-4). The table is `tests/data/examples.txt`.

mod sailed;
mod ship;

use crate::{autopilot, fields};
use serde_json::Value;
use std::collections::BTreeSet;
use std::sync::{Arc, Mutex};
use std::time::Duration;
use wheelover_core::nmea::decode;
use wheelover_core::view::{ModeRequest, Order};
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::Line;
use wheelover_tests::{data, folder, with_checksum};

/// Three in a row, so that the proof of life is not what refuses a command (FA14).
const TIMES: u64 = 3;

/// The lines of the table, without its explanation.
fn table() -> Vec<String> {
    let text = std::fs::read_to_string(data("examples.txt")).unwrap();
    let lines = text
        .lines()
        .filter(|line| !line.starts_with("# ") && !line.is_empty());
    lines.map(str::to_owned).collect()
}

fn cells(line: &str) -> Vec<&str> {
    line.split(" | ").map(str::trim).collect()
}

/// A printed sentence without the placeholder of its checksum.
fn body(printed: &str) -> &str {
    printed.split('*').next().unwrap()
}

/// A sentence as it is printed: who hears it, and what becomes of it.
struct Printed {
    sentence: String,
    effects: Vec<String>,
}

fn printed(station: &str) -> Vec<Printed> {
    let rows = table();
    let rows = rows.iter().filter(|line| line.starts_with("printed | "));
    let rows = rows.map(|line| {
        let [_, who, sentence, effects] = cells(line)[..] else {
            panic!("not four cells: {line}");
        };
        assert!(["autopilot", "chart", "plotter"].contains(&who), "{line}");
        let printed = Printed {
            sentence: sentence.to_owned(),
            effects: effects.split(" ; ").map(str::to_owned).collect(),
        };
        (who == station).then_some(printed)
    });
    rows.flatten().collect()
}

/// What stands in a picture below a path; nothing where the path ends.
fn stands(picture: &Value, path: &str) -> String {
    let found = picture.pointer(&format!("/{}", path.replace('.', "/")));
    match found {
        None | Some(Value::Null) => "none".to_owned(),
        Some(Value::String(text)) => text.clone(),
        Some(value) => value.to_string(),
    }
}

/// Numbers are equal as numbers, anything else as text.
fn equal(found: &str, expected: &str) -> bool {
    match (found.parse::<f64>(), expected.parse::<f64>()) {
        // A name of digits stays a name.
        (Ok(a), Ok(b)) if found.len() != 3 || expected.len() != 3 => (a - b).abs() < 1e-7,
        _ => found == expected,
    }
}

/// Whether an effect holds; `unused` is counted elsewhere.
fn holds(effect: &str, picture: &Value, sentence: &str) -> Result<(), String> {
    let (found, right) = if effect == "unused" {
        return Ok(());
    } else if effect == "clean" {
        let line = with_checksum(sentence);
        let sentence = decode(line.as_bytes());
        (format!("{:?}", sentence.faults()), sentence.is_clean())
    } else if let Some(text) = effect.strip_prefix("fault ") {
        let line = with_checksum(sentence);
        let faults: Vec<String> = decode(line.as_bytes())
            .faults()
            .iter()
            .map(ToString::to_string)
            .collect();
        let found = faults.join("; ");
        let right = found.contains(text);
        (found, right)
    } else if let Some((path, text)) = effect.split_once(" has ") {
        let found = stands(picture, path);
        // `has 0` of a time: it stands there at all.
        let right = found != "none" && (text == "0" || found.contains(text));
        (found, right)
    } else {
        let (path, text) = effect.split_once(" = ").expect("an effect");
        let found = stands(picture, path);
        let right = equal(&found, text);
        (found, right)
    };
    right
        .then_some(())
        .ok_or_else(|| format!("{sentence}: {effect}, but {found}"))
}

/// Plays sentences as they are printed on port 0; every effect is seen in the picture that the program sends.
async fn play(page: &mut Page, ecdis: &mut Line, station: &str) {
    let mut wrong = Vec::new();
    let (mut heard, mut bad, mut unused) = (0, 0, 0);
    for one in printed(station) {
        let line = body(&one.sentence).to_owned();
        // SEN-2: a placeholder is no checksum.
        for _ in 0..TIMES {
            ecdis.send(format!("{}\r\n", one.sentence).as_bytes());
        }
        if decode(one.sentence.as_bytes()).checksum.is_right() {
            heard += TIMES;
        } else {
            bad += TIMES;
        }
        for _ in 0..TIMES {
            ecdis.send(format!("{}\r\n", with_checksum(&line)).as_bytes());
        }
        heard += TIMES;
        if one.effects.iter().any(|effect| effect == "unused") {
            unused += TIMES;
        }
        page.until(&one.sentence, SOON, |page| {
            page.picture.counts[0].heard >= heard
        })
        .await;
        let counts = &page.picture.counts[0];
        if (counts.heard, counts.bad_checksum, counts.unused) != (heard, bad, unused) {
            wrong.push(format!(
                "{}: {counts:?}, not {heard} {bad} {unused}",
                one.sentence
            ));
            (heard, bad, unused) = (counts.heard, counts.bad_checksum, counts.unused);
        }
        let picture = serde_json::to_value(&page.picture).unwrap();
        let effects = one.effects.iter();
        wrong.extend(effects.filter_map(|effect| holds(effect, &picture, &line).err()));
    }
    assert_eq!(wrong, [""; 0]);
}

#[tokio::test]
async fn as_printed_the_autopilot_refuses_what_is_wrong_and_nothing_moves() {
    let folder = folder("examples-autopilot");
    let mut ecdis = Line::new(&folder.join("ecdis"));
    let compass = Line::new(&folder.join("gyro1"));
    let speed = Line::new(&folder.join("gps"));
    let mut gear = Line::new(&folder.join("gear"));
    let config = autopilot(&folder, &["ecdis", "gyro1", "gps", "gear"], true);
    let program = Program::start(&["--config", &config]);
    let _compass = compass.talk(|_| {
        vec![
            with_checksum("HEHDT,216.80,T"),
            with_checksum("HEROT,0.00,A"),
        ]
    });
    let _speed = speed.talk(|tick| {
        let vtg = with_checksum("GPVTG,216.8,T,,M,12.00,N,22.20,K,D");
        if tick % 10 == 0 { vec![vtg] } else { vec![] }
    });
    let orders = Arc::new(Mutex::new(Vec::new()));
    let noted = orders.clone();
    std::thread::spawn(move || {
        while let Some((_, line)) = gear.hear(SOON) {
            let order = fields(&line);
            if order[0] == "$AGROR" && order[2] == "A" {
                noted.lock().unwrap().push(order[1].parse::<f64>().unwrap());
            }
        }
    });
    let mut page = Page::open(program.address).await;
    page.insist(Order::Mode(ModeRequest::Auto), SOON).await;
    // It waits for any good command: none of these is one.
    page.insist(Order::Mode(ModeRequest::Autonav), SOON).await;
    play(&mut page, &mut ecdis, "autopilot").await;
    page.follow(Duration::from_millis(1_500)).await;
    let htd = serde_json::to_value(&page.picture.htd).unwrap();
    assert_eq!(stands(&htd, "value.steering_mode"), "stand_alone");
    let largest =
        (orders.lock().unwrap().iter()).fold(0.0_f64, |most, order| most.max(order.abs()));
    assert!(!orders.lock().unwrap().is_empty());
    assert!(largest < 1.0, "order {largest}");
    assert!(page.agreed > 0 && page.differed.is_empty());
}

// AP-14, EMC-6: RMC with status V is never used.
#[tokio::test]
async fn as_printed_a_plotter_is_read_and_nothing_moves() {
    let folder = folder("examples-plotter");
    let mut plotter = Line::new(&folder.join("plotter"));
    let compass = Line::new(&folder.join("gyro1"));
    let mut gear = Line::new(&folder.join("gear"));
    let config = autopilot(&folder, &["plotter", "gyro1", "gear"], true);
    let program = Program::start(&["--config", &config]);
    let _compass = compass.talk(|_| vec![with_checksum("HEHDT,100.00,T")]);
    let mut page = Page::open(program.address).await;
    page.insist(Order::Mode(ModeRequest::Auto), SOON).await;
    play(&mut page, &mut plotter, "plotter").await;
    let orders = gear.listen(Duration::from_millis(1_500));
    let orders = orders
        .iter()
        .map(|(_, line)| fields(line)[1].parse::<f64>());
    let orders: Vec<f64> = orders.flatten().collect();
    assert!(!orders.is_empty() && orders.iter().all(|order| order.abs() < 1.0));
}

#[tokio::test]
async fn as_printed_the_chart_system_reads_the_answers_and_commands_nothing() {
    let folder = folder("examples-chart");
    let mut ecdis = Line::new(&folder.join("ecdis"));
    let text = format!(
        "roles = [\"chart_system\"]\nallow_output = true\n[[port]]\nname = \"ecdis\"\nkind = \"serial\"\npath = \"{}\"\n\
         baud = 38400\nprofile = \"ecdis\"\noutput = true\n",
        folder.join("ecdis").display(),
    );
    let config = folder.join("wheelover.toml");
    std::fs::write(&config, text).unwrap();
    let program = Program::start(&["--config", config.to_str().unwrap()]);
    let mut page = Page::open(program.address).await;
    play(&mut page, &mut ecdis, "chart").await;
    let lines = ecdis.listen(Duration::from_millis(2_500));
    let htc = lines.iter().filter(|line| line.1.starts_with("$EIHTC"));
    let modes: BTreeSet<&str> = htc.map(|line| fields(&line.1)[4]).collect();
    assert_eq!(modes.into_iter().collect::<Vec<_>>(), ["S"]);
    assert!(page.agreed > 0 && page.differed.is_empty());
}

#[test]
fn every_printed_example_stands_in_the_table_as_printed_and_mended() {
    let log = std::fs::read_to_string(data("seeds/navis.log")).unwrap();
    let log: BTreeSet<&str> = log.lines().filter(|line| !line.starts_with('#')).collect();
    let rows = table();
    let (mut played, mut mended) = (BTreeSet::new(), BTreeSet::new());
    for row in &rows {
        let cells = cells(row);
        match cells[0] {
            "printed" => _ = played.insert(cells[2]),
            line if line.starts_with('$') => _ = mended.insert(line),
            line if line.starts_with("> $") => _ = mended.insert(&line[2..]),
            _ => {}
        }
    }
    assert_eq!(log.difference(&played).collect::<Vec<_>>(), [&""; 0]);
    assert_eq!(log.difference(&mended).collect::<Vec<_>>(), [&""; 0]);
    // And nothing in it that is not printed.
    let small = std::fs::read_to_string(data("seeds/emacua.log")).unwrap();
    let small: BTreeSet<&str> = small.lines().collect();
    let other = |line: &&str| !small.contains(*line);
    played.retain(other);
    mended.retain(other);
    assert_eq!(played.difference(&log).collect::<Vec<_>>(), [&""; 0]);
    assert_eq!(mended.difference(&log).collect::<Vec<_>>(), [&""; 0]);
}
