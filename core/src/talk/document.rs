//! `docs/talk.md`, made from the tables of what is told and what is believed.

use super::load::load;
use super::table::{Row, When, told};
use crate::facts::ports::believed;
use crate::station::{Profile, Role};
use alloc::string::String;
use core::fmt::Write as _;

/// The whole of `docs/talk.md`.
#[must_use]
pub fn document() -> String {
    let mut out = String::from(
        "# What is told and what may be said on each port\n\nMade from the tables of `core/src/talk` and `core/src/facts`; a test compares. What a port says \
         beyond its row is shown, counted and never used. Lengths are those of the longest form with CR LF, in bytes; what each \
         field carries is in [sentences.md](sentences.md). The load is per cent of a line of 4800 baud at ten control steps a second; a \
         configuration over 80 % is refused.\n",
    );
    for station in [Role::Autopilot, Role::ChartSystem, Role::World] {
        let _ = write!(out, "\n## {}\n", station.name());
        for profile in Profile::ALL {
            port(&mut out, station, profile);
        }
    }
    out
}

fn port(out: &mut String, station: Role, profile: Profile) {
    let (told, believed) = (told(station, profile), believed(station, profile));
    if told.is_empty() && believed.is_empty() {
        return;
    }
    let _ = write!(out, "\n### {}: {}\n\n", station.name(), profile.name());
    let _ = match believed {
        [] => writeln!(out, "May say: nothing."),
        all => writeln!(out, "May say: {}.", all.join(", ")),
    };
    if told.is_empty() {
        return;
    }
    out.push_str("\n| told | talker | when | bytes |\n|---|---|---|---|\n");
    for row in told {
        let _ = writeln!(
            out,
            "| {} | {} | {} | {} |",
            row.formatter(),
            row.talker.unwrap_or("its source's"),
            when(row),
            row.saying.definition().longest(),
        );
    }
    let load = load(station, profile, 10.0, 4_800);
    let _ = write!(
        out,
        "\nLoad: {:.0} bytes a second, {:.0} %.\n",
        load.sum(),
        load.percent()
    );
}

fn when(row: &Row) -> String {
    match row.when {
        When::Every(ms) => alloc::format!("every {} s", ms as f64 / 1000.0),
        When::Renewed(ms) => alloc::format!("on each change and every {} s", ms as f64 / 1000.0),
        When::Step => String::from("each control step"),
        When::Change => String::from("on each change, together at most 27 % of the line"),
        When::Asked => String::from("when an officer acknowledges"),
        When::Requested => String::from("when the hand unit asks for it, or sets what it says"),
        When::Operated => String::from("when an officer operates it, where `eve` is set"),
    }
}
