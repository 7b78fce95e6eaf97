//! `docs/alerts.md`, made from the table of alerts.

use super::machine::{REPEAT_MS, SILENCE_MS, UNANSWERED_MS};
use super::table::{Alert, Category, Priority};
use crate::station::Role;
use alloc::string::String;
use core::fmt::Write as _;

/// The whole of `docs/alerts.md`.
#[must_use]
pub fn document() -> String {
    let seconds = |ms: u64| ms / 1_000;
    let mut out = alloc::format!(
        "# Alerts\n\nMade from the table of `core/src/alerts/table.rs`; a test compares. The number stands in ALR, ALA, ACK and on \
         the page, the identifier in ALF, ALC, ARC and ACN.\n\n\
         An alarm or a warning that is raised flashes and sounds until it is acknowledged; silenced, it sounds again after \
         {silence} s. An alarm that nobody acknowledges within {unanswered} s calls the back-up navigator, by an alert of its own and by a contact; a \
         warning is repeated every {repeat} s with a higher escalation counter. One whose condition ends before it was acknowledged stays until it is. A \
         caution needs no acknowledgement.\n\n\
         Category A is acknowledged only where its reason is shown: on the page or at the chart system, never at a bridge \
         alert management, which is answered with ARC. Category B is acknowledged anywhere. Responsibility is transferred (ACN, O) only \
         while the heartbeat of who asks is heard, and comes back when it is not.\n",
        silence = seconds(SILENCE_MS),
        unanswered = seconds(UNANSWERED_MS),
        repeat = seconds(REPEAT_MS),
    );
    for station in [Role::Autopilot, Role::ChartSystem] {
        let _ = write!(
            out,
            "\n## {}\n\n| number | identifier | priority | category | title | what happened and what to do |\n|---|---|---|---|---|---|\n",
            station.name()
        );
        for alert in Alert::of(station) {
            let row = alert.definition();
            let priority = match row.priority {
                Priority::Alarm => "alarm",
                Priority::Warning => "warning",
                Priority::Caution => "caution",
            };
            let category = match row.category {
                Category::A => "A",
                Category::B => "B",
            };
            let _ = writeln!(
                out,
                "| {} | {} | {priority} | {category} | {} | {} |",
                alert.number(),
                alert.identifier(),
                row.title,
                row.text
            );
        }
    }
    out
}
