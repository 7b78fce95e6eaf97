//! What the dialogue checker has found, as markup: the situations on a line of time, and the breaches (CON-2).
//!
//! This belongs to the dictionary's module; the page only shows it.

use crate::drawing::Drawing;
use crate::format::fixed;
use crate::heard::latin1;
use wheelover_core::conformance::{Breach, Found, Live, Span};

/// A situation that lasted no time is drawn as long as this, seconds.
const SHORTEST: f64 = 1.0;

/// Takes lines of a running dialogue, each `number`, tab, milliseconds, tab, text; gives what was found until now.
pub fn follow(live: &mut Live, lines: &str) -> String {
    for line in lines.lines() {
        let mut parts = line.splitn(3, '\t');
        let mut number = || parts.next()?.parse::<u64>().ok();
        if let (Some(number), Some(at)) = (number(), number()) {
            let text = latin1(parts.next().unwrap_or_default());
            live.take(number, Some(at as f64 / 1_000.0), &text);
        }
    }
    let mut drawing = Drawing::new();
    draw(&mut drawing, &live.found());
    drawing.markup()
}

/// The time line, a sentence about all of it, and the last breaches, the newest first.
pub(crate) fn draw(drawing: &mut Drawing, found: &Found) {
    drawing.open("section").attribute("class", "checked");
    drawing.attribute("data-value", "dialogue-check").inside();
    drawing.open("p").attribute("class", "small").inside();
    drawing.say(words(found)).close("p");
    time_line(drawing, &found.situations);
    drawing.open("ol").inside();
    for breach in found.recent.iter().rev() {
        breach_row(drawing, breach);
    }
    drawing.close("ol").close("section");
}

fn words(found: &Found) -> String {
    let sentences = found.sentences;
    let shown = found.recent.len() as u64;
    match found.breaches {
        _ if sentences == 0 => {
            "No sentence of a dialogue between chart system and autopilot yet.".to_owned()
        }
        0 => format!("Dialogue of {sentences} sentences: no breach of the rules."),
        breaches if breaches > shown => format!(
            "Dialogue of {sentences} sentences, {breaches} breaches; the last {shown} stand here."
        ),
        1 => format!("Dialogue of {sentences} sentences, 1 breach."),
        breaches => format!("Dialogue of {sentences} sentences, {breaches} breaches."),
    }
}

/// Each situation as wide as it lasted, of a thousand units in all.
fn time_line(drawing: &mut Drawing, spans: &[Span]) {
    let lasted = |span: &Span| match (span.from, span.to) {
        (Some(from), Some(to)) => (to - from).max(SHORTEST),
        _ => SHORTEST,
    };
    let all: f64 = spans.iter().map(lasted).sum();
    let mut x = 0.0;
    drawing.open("svg").attribute("class", "spans");
    drawing.attribute("viewBox", "0 0 1000 30").inside();
    for span in spans {
        let seconds = lasted(span);
        let width = 1_000.0 * seconds / all;
        drawing
            .open("g")
            .attribute("data-situation", span.situation);
        drawing.inside();
        let words = format!("situation {}, {} s", span.situation, fixed(seconds, 0));
        drawing.element("title", "", words);
        drawing.open("rect").number("x", x).attribute("y", 1);
        drawing.number("width", (width - 2.0).max(1.0));
        drawing.attribute("height", 28).plain("/>");
        if width > 14.0 {
            drawing.word("", "middle", (x + width / 2.0, 21.0), span.situation);
        }
        drawing.close("g");
        x += width;
    }
    drawing.close("svg");
}

fn breach_row(drawing: &mut Drawing, breach: &Breach) {
    let when = breach
        .at
        .map_or(String::new(), |at| format!("{} s, ", fixed(at, 1)));
    let situation = breach.situation.map_or(String::new(), |situation| {
        format!(", situation {situation}")
    });
    drawing
        .open("li")
        .attribute("data-rule", &breach.rule)
        .inside();
    drawing.element(
        "span",
        "when",
        format_args!("{when}line {}{situation}", breach.line),
    );
    drawing.element("b", "", &breach.rule);
    drawing.element("span", "", &breach.text).close("li");
}

#[cfg(test)]
mod tests {
    use super::*;
    use wheelover_core::nmea::with_checksum;

    fn lines(bodies: &[&str]) -> String {
        let line = |(n, body): (usize, &&str)| {
            format!("{}\t{}\t{}\n", n + 1, n * 1_000, with_checksum(body))
        };
        bodies.iter().enumerate().map(line).collect()
    }

    // CON-2
    #[test]
    fn a_breach_stands_with_its_rule_line_and_situation_and_situations_on_a_line_of_time() {
        let mut live = Live::default();
        let off = "EIHTC,V,,,S,N,,,,,,,,T,C";
        let wrong = "EIHTC,V,,,T,N,,,,,,,245.0,T,C";
        let text = follow(&mut live, &lines(&[off, off, wrong, off]));
        assert!(text.contains("data-situation=\"1\"") && text.contains("data-situation=\"2\""));
        assert!(text.contains("data-rule=\"TCS-1\""), "{text}");
        assert!(text.contains("line 3, situation 2"), "{text}");
        // What comes later is added to it.
        let before = live.found().lines;
        follow(&mut live, "5\t4000\t$EIHTC,<b>");
        assert_eq!(live.found().lines, before + 1);
        assert!(!follow(&mut live, "").contains("<b>$"));
    }

    #[test]
    fn without_a_dialogue_it_says_so() {
        let text = follow(&mut Live::default(), "1\t0\t$HEHDT,216.8,T*22\nodd\n");
        assert!(text.contains("No sentence of a dialogue"), "{text}");
    }
}
