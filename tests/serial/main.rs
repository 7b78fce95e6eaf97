//! The real binary on serial lines: dialogues, pulled plugs, hostile input, two programs joined by null modems.
#![allow(clippy::unwrap_used)]

mod at_another_pace;
mod both_programs;
mod dialogue;
mod examples;
mod foreign;
mod golden;
mod hand_unit;
mod hostile;
mod management;
mod no_route;
mod offered_route;
mod pair;
mod plotter;
mod ports;
mod scan;
mod ship;
mod stopped;

use std::path::Path;
use wheelover_core::view::{Answer, Order};
use wheelover_tests::page::Page;
use wheelover_tests::program::Program;

/// A configuration of the autopilot with these ports in a folder; gives the file's name.
fn autopilot(folder: &Path, ports: &[&str], allow_output: bool) -> String {
    let mut text = format!(
        "roles = [\"autopilot\"]\nallow_output = {allow_output}\n[ship]\nmodel = \"mariner\"\n[autopilot]\nrudder_slew = 5.0\nexternal_tcs = true\n"
    );
    for port in ports {
        text += &format!(
            "[[port]]\nname = \"{port}\"\nkind = \"serial\"\npath = \"{}\"\nbaud = 38400\n\
             profile = \"{port}\"\noutput = {}\n",
            folder.join(port).display(),
            matches!(*port, "bams" | "ecdis" | "gear" | "hmi" | "plotter")
        );
    }
    let file = folder.join("wheelover.toml");
    std::fs::write(&file, text).unwrap();
    file.display().to_string()
}

/// Commands once on a connection of its own.
async fn command(program: &Program, action: Order) -> Answer {
    let mut page = Page::open(program.address).await;
    let answer = page.command(action).await;
    page.leave().await;
    answer
}

/// Fields of a sentence without its checksum, the address first.
fn fields(line: &str) -> Vec<&str> {
    line.split('*').next().unwrap().split(',').collect()
}
