//! The mended examples, each dialogue by a program of its own: what the document prints as the answer comes back (AP-1 to
//! AP-4, TCS-2, TCS-3, TCS-10, the six situations of N 2.1).

use super::ship::{FORWARDING, Part, Ship};
use super::{body, cells, equal, table};
use crate::fields;
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use wheelover_core::conformance::{Breach, Checker};
use wheelover_core::view::{Answer, ModeRequest, Order, Up};
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::Line;
use wheelover_tests::{folder, with_checksum};

/// What was asked for is answered within so many seconds (CON-1: 2 s, and a period).
const SETTLES: f64 = 3.2;

struct Dialogue {
    name: String,
    ship: Vec<String>,
    /// Further settings of the autopilot.
    settings: String,
    /// Rules that it breaks.
    breaks: BTreeSet<String>,
    steps: Vec<Step>,
}

#[derive(Clone, Default)]
struct Step {
    name: String,
    until: String,
    officer: String,
    /// Port and body.
    says: Vec<(String, String)>,
    answers: Vec<String>,
}

fn dialogues() -> Vec<Dialogue> {
    let mut dialogues: Vec<Dialogue> = Vec::new();
    for line in table() {
        let cells = cells(&line);
        let text = |cell: usize| {
            (*cells.get(cell).unwrap_or(&""))
                .trim_matches('|')
                .trim()
                .to_owned()
        };
        if let Some(name) = line.strip_prefix("== ") {
            dialogues.push(Dialogue {
                name: name.split(" | ").next().unwrap().to_owned(),
                ship: cells[1..].iter().map(ToString::to_string).collect(),
                settings: String::new(),
                breaks: BTreeSet::new(),
                steps: Vec::new(),
            });
        } else if let Some(setting) = cells[0].strip_prefix("& ") {
            let dialogue = dialogues.last_mut().unwrap();
            dialogue.settings += &format!("{setting}\n");
        } else if let Some(rule) = cells[0].strip_prefix("! ") {
            let dialogue = dialogues.last_mut().unwrap();
            dialogue.breaks.insert(rule.to_owned());
        } else if line.starts_with("-- ") {
            dialogues.last_mut().unwrap().steps.push(Step {
                name: cells[0][3..].to_owned(),
                until: text(1),
                officer: text(2),
                ..Step::default()
            });
        } else if line.starts_with('$') || line.starts_with("> ") {
            assert_eq!(cells.len(), 3, "{line}");
            let dialogue = dialogues.last_mut().unwrap();
            let step = dialogue.steps.last_mut().unwrap();
            if line.starts_with('$') {
                let mended = if cells[1] == "=" { cells[0] } else { cells[1] };
                let (port, line) = mended.split_once(": ").unwrap_or(("ecdis", mended));
                let said = body(line).trim_start_matches('$').to_owned();
                step.says.push((port.to_owned(), said));
            } else {
                step.answers.push(cells[1].to_owned());
            }
        }
    }
    dialogues
}

#[test]
fn mended_the_six_situations_are_answered_as_the_document_prints() {
    let dialogues = dialogues();
    assert!(dialogues.len() >= 8, "{}", dialogues.len());
    let sailing: Vec<_> = dialogues
        .into_iter()
        .map(|dialogue| {
            let name = dialogue.name.clone();
            let folder = folder(&format!("examples-{}", name.replace(' ', "-")));
            (name, std::thread::spawn(move || sail(&folder, &dialogue)))
        })
        .collect();
    let mut wrong = Vec::new();
    for (name, thread) in sailing {
        match thread.join() {
            Ok(faults) => wrong.extend(faults),
            Err(_) => wrong.push(format!("{name} did not come to its end")),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn order(program: &Program, order: Order, insists: bool) -> Answer {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build();
    runtime.unwrap().block_on(async {
        let mut page = Page::open(program.address).await;
        let end = Instant::now() + SOON;
        loop {
            let answer = page.command(order.clone()).await;
            if answer.ok || !insists || Instant::now() > end {
                page.leave().await;
                return answer;
            }
            page.follow(Duration::from_millis(200)).await;
        }
    })
}

/// Sails a dialogue; gives what was answered otherwise.
fn sail(folder: &Path, dialogue: &Dialogue) -> Vec<String> {
    let mut ecdis = Line::new(&folder.join("ecdis"));
    let compass = Line::new(&folder.join("gyro1"));
    let mut gear = Line::new(&folder.join("gear"));
    let plotter = Line::new(&folder.join("plotter"));
    // The values that the document prints in AUTO.
    let mut text = format!(
        "roles = [\"autopilot\"]\nallow_output = true\n[ship]\nlength_m = 45\nspeed_kn = 20\ngain_per_s = 0.5\ntime_constant_s = 15\nforwarding_s = {FORWARDING}\n\
         [autopilot]\nrudder_slew = 5.0\nexternal_tcs = true\nset_radius = 0.42\nrudder_limit = 16.0\noff_heading_limit = 20.0\n{}",
        dialogue.settings
    );
    for port in ["ecdis", "gyro1", "gear", "plotter"] {
        text += &format!(
            "[[port]]\nname = \"{port}\"\nkind = \"serial\"\npath = \"{}\"\nbaud = 38400\nprofile = \"{port}\"\noutput = {}\n",
            folder.join(port).display(),
            matches!(port, "ecdis" | "gear")
        );
    }
    let config = folder.join("wheelover.toml");
    std::fs::write(&config, text).unwrap();
    let program = Program::start(&["--config", config.to_str().unwrap()]);
    let cells: Vec<&str> = dialogue.ship.iter().map(String::as_str).collect();
    let ship = Ship::new(&cells);
    let pair = dialogue.settings.contains("independent");
    std::thread::spawn(move || {
        while let Some((_, order)) = gear.hear(SOON) {
            // Each rudder is at once where it was ordered.
            if let ["$AGROR", starboard, _, port, _, _] = fields(&order)[..] {
                let angle = |order: &str| order.parse::<f64>().unwrap_or(0.0);
                let port = match pair {
                    true => format!("{:.2},A", angle(port)),
                    false => ",V".to_owned(),
                };
                gear.say(&format!("IIRSA,{:.2},A,{port}", angle(starboard)));
            }
        }
    });
    let own = ship.clone();
    let _compass = compass.talk(move |_| {
        let at = own.sailed();
        vec![
            with_checksum(&format!("HEHDT,{:.2},T", own.heading(at))),
            with_checksum(&format!("HEROT,{:05.1},A", own.rate(at))),
        ]
    });
    let said = Arc::new(Mutex::new(dialogue.steps[0].clone()));
    let talk = |name: &'static str, line: &Line| {
        let (saying, own) = (said.clone(), ship.clone());
        line.talk(move |tick| {
            if !tick.is_multiple_of(10) {
                return vec![];
            }
            let at = own.sailed();
            let says = saying.lock().unwrap().says.clone();
            let here = says.iter().filter(|(port, _)| port == name);
            here.map(|(_, line)| with_checksum(&own.fill(line, at)))
                .collect()
        })
    };
    let _chart = talk("ecdis", &ecdis);
    let _plotter = talk("plotter", &plotter);
    let answer = order(&program, Order::Mode(ModeRequest::Auto), true);
    assert!(answer.ok, "{}", answer.text);
    let mut wrong = Vec::new();
    for step in &dialogue.steps {
        *said.lock().unwrap() = step.clone();
        let begun = ship.sailed();
        if let Some(waits) = step.officer.strip_prefix("autonav waits: ") {
            super::ship::wait(&ship, begun + SETTLES + 1.0);
            let answer = order(&program, Order::Mode(ModeRequest::Autonav), false);
            if !answer.text.contains(waits) {
                wrong.push(format!("{}: {}, not {waits}", step.name, answer.text));
            }
        } else if !step.officer.is_empty() {
            let mode = match step.officer.as_str() {
                "track" => ModeRequest::Track,
                _ => ModeRequest::Autonav,
            };
            let answer = order(&program, Order::Mode(mode), true);
            assert!(answer.ok, "{}: {}", step.name, answer.text);
        }
        wrong.extend(
            step_answered(&mut ecdis, &ship, step, begun)
                .into_iter()
                .map(|fault| format!("{}, {}: {fault}", dialogue.name, step.name)),
        );
    }
    let (breaches, situations) = checked(&program);
    let rules: BTreeSet<String> = breaches.iter().map(|breach| breach.rule.clone()).collect();
    if rules != dialogue.breaks {
        let expected = &dialogue.breaks;
        wrong.push(format!("{}: {breaches:?}, not {expected:?}", dialogue.name));
    }
    if situations != dialogue.ship[5].trim_start_matches('-') {
        wrong.push(format!(
            "{}: situations {situations}, not {}",
            dialogue.name, dialogue.ship[5]
        ));
    }
    wrong
}

/// What the dialogue checker finds in all that was said on the chart system's line, with the program's own times (CON-1).
fn checked(program: &Program) -> (Vec<Breach>, String) {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build();
    let lines = runtime.unwrap().block_on(async {
        let mut page = Page::open(program.address).await;
        let last = page.line;
        page.line = 0;
        page.say(&Up::Resume { seq: 1 }).await;
        page.until("all lines", SOON, |page| page.line >= last)
            .await;
        page.leave().await.lines
    });
    let (mut checker, mut breaches) = (Checker::new(), Vec::new());
    // The first of the ports.
    for line in lines.iter().filter(|line| line.port == 0) {
        let at = line.at as f64 / 1000.0;
        checker.take(line.seq, Some(at), line.text.as_bytes(), &mut breaches);
    }
    checker.finish(&mut breaches);
    let named: Vec<String> = checker
        .spans()
        .iter()
        .map(|span| span.situation.to_string())
        .collect();
    (breaches, named.join(" "))
}

/// Listens to the end of a step; what was answered otherwise than it expects.
fn step_answered(ecdis: &mut Line, ship: &Ship, step: &Step, begun: f64) -> Vec<String> {
    let over = |at: f64| match step.until.as_str() {
        "wheel over" => ship.part(at) >= Part::WheelOver,
        "arc" => ship.part(at) >= Part::Arc,
        "leg" => ship.part(at) >= Part::Next,
        seconds => at >= begun + seconds.trim_end_matches(" s").parse::<f64>().unwrap(),
    };
    let settled = ship.sailed() + SETTLES;
    let mut lines = Vec::new();
    while !over(ship.sailed()) {
        if let Some((_, line)) = ecdis.hear(Duration::from_millis(50)) {
            lines.push((ship.sailed(), line));
        }
    }
    let mut wrong = Vec::new();
    for expected in &step.answers {
        let address = fields(expected)[0];
        let of = lines.iter().filter(|(_, line)| fields(line)[0] == address);
        if ["$AGALR", "$AGALA"].contains(&address) {
            // An event: once is enough.
            if !of
                .clone()
                .any(|(at, line)| differs(expected, line, ship.heading(*at)).is_none())
            {
                wrong.push(format!("no {expected} in {:?}", of.collect::<Vec<_>>()));
            }
            continue;
        }
        let late: Vec<_> = of.filter(|(at, _)| *at >= settled).collect();
        if late.is_empty() {
            wrong.push(format!("no {address} after {settled:.1} s"));
        }
        let differs = late.iter().filter_map(|(at, line)| {
            let fault = differs(expected, line, ship.heading(*at))?;
            Some(format!("at {at:.1} s {line}: {fault} of {expected}"))
        });
        wrong.extend(differs.take(2));
    }
    wrong
}

/// The first field that is not as expected.
fn differs(expected: &str, line: &str, heading: f64) -> Option<String> {
    let (expected, found) = (fields(expected), fields(line));
    if expected.len() != found.len() {
        return Some(format!("{} fields, not {}", found.len(), expected.len()));
    }
    let right = |(expected, found): (&&str, &&str)| match *expected {
        "~" => true,
        "?" => !found.is_empty(),
        // Less than a second of the fastest turn.
        "{heading}" => found
            .parse::<f64>()
            .is_ok_and(|found| (found - heading).abs() < 1.5),
        expected => equal(found, expected),
    };
    let wrong = expected.iter().zip(&found).position(|pair| !right(pair))?;
    Some(format!(
        "field {wrong} is {:?}, not {:?}",
        found[wrong], expected[wrong]
    ))
}
