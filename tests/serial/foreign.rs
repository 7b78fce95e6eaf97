//! The autopilot against a foreign ship and chart system, and the chart system against a foreign autopilot: every trial
//! sails in real time beside the others, so that all of them last as long as the longest.

mod chart;
mod leg;
mod turn;

use std::path::Path;
use wheelover_tests::folder;
use wheelover_tests::foreign::{Said, Sailing, whole};

/// A name, and what is tried in a folder of its own.
type Trial = (&'static str, fn(&Path));

#[test]
fn every_trial_of_the_foreign_ship() {
    let trials = leg::TRIALS.iter().chain(turn::TRIALS).chain(chart::TRIALS);
    let sailing: Vec<_> = trials
        .map(|(name, trial)| {
            let thread = std::thread::Builder::new().name((*name).to_string());
            let folder = folder(&format!("foreign-{}", name.replace(' ', "-")));
            (name, thread.spawn(move || trial(&folder)).unwrap())
        })
        .collect();
    let failed = sailing
        .into_iter()
        .filter_map(|(name, thread)| thread.join().is_err().then_some(name));
    assert_eq!(failed.collect::<Vec<_>>(), [] as [&&str; 0]);
}

/// Replaces fields of a body, counted from 1.
fn edited(body: &str, changes: &[(usize, &str)]) -> String {
    let mut fields: Vec<&str> = body.split(',').collect();
    for (index, text) in changes {
        fields[*index] = text;
    }
    fields.join(",")
}

/// Spoils the chart system's sentences that begin so, from now on.
fn spoil(ship: &Sailing, begin: &'static str, changes: &'static [(usize, &'static str)]) {
    ship.tap(move |port, body| -> Vec<Said> {
        if port == "ecdis" && body.starts_with(begin) {
            vec![(port, edited(body, changes))]
        } else {
            whole(port, body)
        }
    });
}
