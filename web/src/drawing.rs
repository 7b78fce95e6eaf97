//! A drawing as text: the elements of an SVG or a table written one behind the other, every foreign text escaped.

use crate::format::fixed;
use core::fmt::Display;

/// Markup that grows; nothing that was heard can become an element of it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Drawing {
    text: String,
}

impl Drawing {
    /// An empty drawing.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The markup.
    #[must_use]
    pub fn markup(self) -> String {
        self.text
    }

    /// Opens an element.
    pub fn open(&mut self, name: &str) -> &mut Self {
        self.text.push('<');
        self.plain(name)
    }

    /// An attribute of the element that was opened.
    pub fn attribute(&mut self, name: &str, value: impl Display) -> &mut Self {
        self.plain(" ").plain(name).plain("=\"");
        self.say(value).plain("\"")
    }

    /// A length or a place, to a tenth of a unit.
    pub fn number(&mut self, name: &str, value: f64) -> &mut Self {
        self.attribute(name, fixed(value, 1))
    }

    /// Ends the opening tag: what follows stands inside.
    pub fn inside(&mut self) -> &mut Self {
        self.plain(">")
    }

    /// Text, escaped.
    pub fn say(&mut self, text: impl Display) -> &mut Self {
        for letter in text.to_string().chars() {
            match letter {
                '<' => self.text.push_str("&lt;"),
                '>' => self.text.push_str("&gt;"),
                '&' => self.text.push_str("&amp;"),
                '"' => self.text.push_str("&quot;"),
                letter => self.text.push(letter),
            }
        }
        self
    }

    /// Closes an element.
    pub fn close(&mut self, name: &str) -> &mut Self {
        self.plain("</").plain(name).plain(">")
    }

    /// An element with text inside.
    pub fn element(&mut self, name: &str, class: &str, text: impl Display) -> &mut Self {
        self.open(name);
        if !class.is_empty() {
            self.attribute("class", class);
        }
        self.inside().say(text).close(name)
    }

    /// A path of the plan; `plan` is its name for tests and scripts, empty where it has none.
    pub fn path(&mut self, class: &str, plan: &str, d: &str) -> &mut Self {
        self.named("path", class, plan);
        self.attribute("d", d).plain("/>")
    }

    /// A circle.
    pub fn circle(&mut self, class: &str, at: (f64, f64), radius: f64) -> &mut Self {
        self.named_circle(class, "", at, radius)
    }

    /// A circle of the plan with a name for tests and scripts.
    pub fn named_circle(
        &mut self,
        class: &str,
        plan: &str,
        (x, y): (f64, f64),
        radius: f64,
    ) -> &mut Self {
        self.named("circle", class, plan);
        self.number("cx", x).number("cy", y).number("r", radius);
        self.plain("/>")
    }

    /// A rectangle.
    pub fn bar(&mut self, class: &str, x: f64, width: f64) -> &mut Self {
        self.named("rect", class, "");
        self.number("x", x).attribute("y", 13);
        self.number("width", width)
            .attribute("height", 26)
            .plain("/>")
    }

    /// A word on the drawing; `anchor` as in SVG.
    pub fn word(
        &mut self,
        class: &str,
        anchor: &str,
        (x, y): (f64, f64),
        text: impl Display,
    ) -> &mut Self {
        self.named("text", class, "");
        self.attribute("text-anchor", anchor)
            .number("x", x)
            .number("y", y);
        self.inside().say(text).close("text")
    }

    fn named(&mut self, name: &str, class: &str, plan: &str) {
        self.open(name).attribute("class", class);
        if !plan.is_empty() {
            self.attribute("data-plan", plan);
        }
    }

    /// Markup as it is.
    pub fn plain(&mut self, markup: &str) -> &mut Self {
        self.text.push_str(markup);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_heard_never_becomes_an_element() {
        let mut drawing = Drawing::new();
        drawing.word("wp", "middle", (1.0, 2.25), "<b onclick=\"x\">&");
        assert_eq!(
            drawing.markup(),
            "<text class=\"wp\" text-anchor=\"middle\" x=\"1.0\" y=\"2.3\">&lt;b onclick=&quot;x&quot;&gt;&amp;</text>"
        );
    }
}
