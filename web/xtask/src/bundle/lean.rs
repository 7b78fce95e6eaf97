//! Leaves away what the page's script carries and never uses: classes that a dependency exports, and words for readers.

/// A dependency exports these for streams from Rust to JavaScript; the page has none.
const UNUSED: &str = "IntoUnderlying";

/// A script without the unused classes, without comments and indentation.
pub(crate) fn script(script: &str) -> String {
    let mut lean = String::with_capacity(script.len());
    let mut left_away = false;
    for line in script.lines() {
        let class = line.strip_prefix("export class ").unwrap_or_default();
        left_away |= class.starts_with(UNUSED);
        let whole = line.trim();
        let remark = ["//", "/**", "* ", "*/"]
            .iter()
            .any(|mark| whole.starts_with(mark))
            || whole == "*";
        let disposed = whole.starts_with(&format!("if (Symbol.dispose) {UNUSED}"));
        if !left_away && !remark && !disposed && !whole.is_empty() {
            lean += whole;
            lean += "\n";
        }
        // A class ends where a line is nothing but its brace.
        left_away &= line != "}";
    }
    lean
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_never_used_is_left_away() {
        let whole = "/** Says it. */\nexport class IntoUnderlyingSink {\n    free() {\n    }\n}\n\
            if (Symbol.dispose) IntoUnderlyingSink.prototype[Symbol.dispose] = 1;\n\n\
            function take() {\n    // why\n    return 2 * 3;\n}\n";
        assert_eq!(script(whole), "function take() {\nreturn 2 * 3;\n}\n");
    }
}
