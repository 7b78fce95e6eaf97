//! What an officer is told of a rudder that fails (FA11, AP-4): which side, why, and who steers now.

use super::response::{Fails, Follows};
use crate::alerts::Alert;
use crate::autopilot::notices::Notice;
use alloc::format;
use alloc::string::String;

/// What is said of the single rudder, or of linked ones.
pub(super) fn of_single(follows: Follows) -> [Option<Notice>; 2] {
    let why = |fails| match fails {
        Fails::NoFeedback => "no rudder feedback: steer by hand",
        Fails::OffOrder => "the rudder does not follow its order: steer by hand",
    };
    let said = notice(follows, Alert::Rudder, |fails| why(fails).into());
    [said, Some(Notice::Rectified(Alert::RudderPort))]
}

/// What is said of a pair, the starboard one first; `none_left`: both have failed.
pub(super) fn of_pair(follows: [Follows; 2], none_left: bool) -> [Option<Notice>; 2] {
    let [starboard, port] = follows;
    let text = |side: &str, other: &str, fails| {
        let why = match fails {
            Fails::NoFeedback => "has no feedback",
            Fails::OffOrder => "does not follow its order",
        };
        let then = if none_left {
            String::from("steer by hand")
        } else {
            format!("the {other} rudder steers")
        };
        format!("the {side} rudder {why}: {then}")
    };
    [
        notice(starboard, Alert::Rudder, |fails| {
            text("starboard", "port", fails)
        }),
        notice(port, Alert::RudderPort, |fails| {
            text("port", "starboard", fails)
        }),
    ]
}

/// Nothing is said while a rudder may still be on its way.
fn notice(follows: Follows, alert: Alert, text: impl Fn(Fails) -> String) -> Option<Notice> {
    match follows {
        Follows::Yes => Some(Notice::Rectified(alert)),
        Follows::NotYet => None,
        Follows::No(fails) => Some(Notice::Raised(alert, text(fails))),
    }
}
