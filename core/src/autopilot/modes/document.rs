//! `docs/modes.md`: modes, needs, losses and transitions, made from the code that decides them.

use super::auto::{Auto, Finish};
use super::event::{Cause, Event};
use super::former::Former;
use super::mode::{Mode, TABLE};
use super::need::{Lost, Need};
use super::state::Listed as _;
use super::table::{Limit, OnLoss, Row};
use super::track::Track;
use crate::autopilot::facts::Facts;
use crate::command::{Origin, STANDBY_RANK};
use crate::geo::Point;
use crate::path::Path;
use crate::settings::Settings;
use crate::time::Stamp;
use crate::units::{Course, Heading, Radius, RudderAngle, SignedAngle};
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// The document of the modes.
#[must_use]
pub fn document() -> String {
    [
        "# The modes\n\nMade from the tables and the transitions in `core/src/autopilot/modes`; a test compares.\n".into(),
        modes(),
        needs(),
        transitions(),
        ranks(),
    ]
    .join("\n")
}

fn table(head: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let head: Vec<String> = head.iter().map(|cell| (*cell).to_string()).collect();
    let mut text = line(&head) + &format!("|{}\n", "---|".repeat(head.len()));
    for row in rows {
        text += &line(&row);
    }
    text
}

fn list(needs: &[Need]) -> String {
    let names: Vec<String> = needs.iter().map(|need| format!("{need:?}")).collect();
    if names.is_empty() {
        "–".into()
    } else {
        names.join(", ")
    }
}

fn modes() -> String {
    let head = [
        "mode",
        "what it does",
        "selected by",
        "refused at once without",
        "needs",
        "a watched need is lost",
        "rudder limit",
        "HTD mode",
    ];
    let row = |row: &Row| {
        let lost = match row.on_loss {
            OnLoss::Nothing => "–",
            OnLoss::RudderHold => "RUDDER HOLD",
            OnLoss::Auto => "AUTO, alarm",
            OnLoss::TrackFail => "TRACK FAIL, AUTO",
        };
        let limit = match row.limit {
            Limit::NoOrders => "no orders",
            Limit::Set => "`rudder_limit`",
            Limit::Max => "`rudder_max`",
        };
        alloc::vec![
            row.title.to_string(),
            row.what.to_string(),
            format!("{:?}", row.role).to_lowercase(),
            list(row.entry),
            list(row.needs),
            lost.to_string(),
            limit.to_string(),
            row.htd.map_or("null".into(), |mode| format!("{mode:?}")),
        ]
    };
    let text = "## Modes\n\nA selection waits for what a mode needs, for 20 s; then it lapses.\n\n";
    text.to_string() + &table(&head, TABLE.iter().map(row))
}

fn needs() -> String {
    let head = [
        "need",
        "what it is",
        "an officer is told",
        "lost in the mode",
    ];
    let row = |need: &Need| {
        let lost = match need.lost() {
            Lost::AtEntry => "asked for at the selection only".to_string(),
            Lost::RudderHold => "the rudder is held, alarm".to_string(),
            Lost::Auto => "AUTO holds the present heading after its age limit, alarm".to_string(),
            Lost::NotFollowed => "the next command is not followed, caution".to_string(),
            Lost::Watched(_) if *need == Need::Agreement => {
                "what does not agree is said at once, TRACK FAIL with it after `track_fail`"
                    .to_string()
            }
            Lost::Watched(name) => format!(
                "“{name} late” after `track_caution`, TRACK FAIL “{name} missing” after `track_fail`"
            ),
        };
        alloc::vec![
            format!("{need:?}"),
            need.what().to_string(),
            need.missing().to_string(),
            lost,
        ]
    };
    "## Needs\n\n".to_string() + &table(&head, Need::ALL.iter().map(row))
}

fn events() -> Vec<(&'static str, Event)> {
    let north = Course::from_deg(0.0);
    alloc::vec![
        ("STANDBY", Event::Standby),
        ("override", Event::Override),
        ("NFU line in use", Event::NfuLine(true)),
        ("NFU line released", Event::NfuLine(false)),
        ("AUTO", Event::Auto),
        ("heading set", Event::SetHeading(Heading::from_deg(30.0))),
        (
            "Tn agreed",
            Event::EngageTn {
                hts: Heading::from_deg(0.0),
                track: north,
                rate: None,
            },
        ),
        (
            "Ti agreed",
            Event::EngageTi {
                path: Path::leg(Point::default(), north),
                radius: Radius::from_nm(1.0),
            },
        ),
        ("TRACK", Event::EngageTrack(followed())),
        ("something missing", Event::TrackFail(Cause::Missing),),
        ("HTC says S", Event::TrackFail(Cause::StandAlone)),
        ("heading lost", Event::HeadingLost),
        ("RIVER PILOT", Event::RiverPilot),
        (
            "WIND VANE",
            Event::WindVane {
                angle: SignedAngle::from_deg(30.0),
                apparent: true,
                direction: Heading::from_deg(30.0),
            },
        ),
        (
            "DODGE",
            Event::Dodge {
                base: Heading::from_deg(0.0),
                former: Former::Autonav,
            },
        ),
        (
            "FFU OVERRIDE",
            Event::FfuOverride(RudderAngle::from_deg(0.0)),
        ),
        (
            "tiller moved by the hand unit",
            Event::Jog {
                rudder: RudderAngle::from_deg(1.0),
                until: Stamp(0),
            },
        ),
        (
            "over, or DODGE released",
            Event::AutoOn(Heading::from_deg(30.0))
        ),
        ("INSTALLATION", Event::Installation),
        ("AUTOTUNING", Event::Autotuning),
    ]
}

/// A plotter's leg.
fn followed() -> Track {
    let mut examples = Track::examples();
    examples.remove(0).1
}

fn transitions() -> String {
    let settings = Settings::default();
    let facts = Facts {
        now: Stamp(0),
        heading: Heading::from_deg(10.0),
        order: RudderAngle::from_deg(0.0),
        place: Some(Point::default()),
        steered: None,
        settings: &settings,
    };
    let events = events();
    let mut head = alloc::vec!["in"];
    head.extend(events.iter().map(|(name, _)| *name));
    let rows = Mode::examples().into_iter().map(|(name, state)| {
        let mut row = alloc::vec![name.to_string()];
        row.extend(events.iter().map(|(_, event)| {
            let next = state.next(event, &facts);
            if next == state {
                "–".to_string()
            } else {
                described(&next, &facts)
            }
        }));
        row
    });
    let text = "## Transitions\n\nWhat each event makes of a mode; – is no change. “Agreed”: the operator has selected AutoNAV, or the chart\nsystem switches between Tn and Ti, and everything that is needed is there. A lost turn is finished by its last commanded radius or rate.\nDODGE that was selected in AutoNAV or WIND VANE goes back there when it is released, where the needs still hold. In RIVER PILOT the heading is lost\nwhere no rate of turn is measured either.\n\n";
    text.to_string() + &table(&head, rows)
}

/// HTC-4: who goes before whom.
fn ranks() -> String {
    let mut rows: Vec<(u8, &str)> = Origin::ALL
        .iter()
        .map(|origin| (origin.rank(), origin.title()))
        .collect();
    rows.push((STANDBY_RANK, "operator's STANDBY"));
    rows.sort_by_key(|(rank, _)| *rank);
    let text = "## Who goes before whom\n\nOf two that command the one with the lower number is obeyed, and the other is refused by its name (HTC-4). HTC, HSC and APB\ncommand only in the modes that the operator has selected for them.\n\n";
    let rows = rows
        .into_iter()
        .map(|(rank, title)| alloc::vec![rank.to_string(), title.to_string()]);
    text.to_string() + &table(&["rank", "who"], rows)
}

fn described(mode: &Mode, facts: &Facts<'_>) -> String {
    let how = match mode {
        Mode::Auto(Auto {
            finish: Some(Finish { wait: Some(_), .. }),
            ..
        }) => ": the leg up to the arc, then the turn is finished",
        Mode::Auto(Auto {
            finish: Some(_), ..
        }) => ": the turn is finished",
        Mode::Auto(auto) if auto.set == facts.heading => " on the actual heading",
        Mode::Auto(auto) if auto.stop_cause_until.is_some() => " on the last heading to steer",
        Mode::Auto(_) => " on the set heading",
        Mode::FfuOverride(ffu) if ffu.until.is_some() => ", then STANDBY again",
        _ => "",
    };
    format!("{}{how}", mode.title())
}
