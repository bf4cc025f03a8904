//! Text of the document as HTML.

use std::fmt::Write as _;

/// A text that means nothing to HTML.
pub(super) fn escaped(text: &str) -> String {
    let mut written = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => written.push_str("&amp;"),
            '<' => written.push_str("&lt;"),
            '>' => written.push_str("&gt;"),
            '"' => written.push_str("&quot;"),
            '\'' => written.push_str("&#39;"),
            other => written.push(other),
        }
    }
    written
}

/// A text whose words between backticks are code.
pub(super) fn inline(text: &str) -> String {
    let mut written = String::new();
    for (k, part) in text.split('`').enumerate() {
        let part = escaped(part);
        let _ = if k % 2 == 1 {
            write!(written, "<code>{part}</code>")
        } else {
            write!(written, "{part}")
        };
    }
    written
}

/// A text of several paragraphs.
pub(super) fn paragraphs(text: &str) -> String {
    let parts = text.split("\n\n").map(str::trim).filter(|part| !part.is_empty());
    parts.fold(String::new(), |written, part| written + "<p>" + &inline(part) + "</p>\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_stays_text() {
        assert_eq!(
            inline("a <b> `x < y` & \"c\""),
            "a &lt;b&gt; <code>x &lt; y</code> &amp; &quot;c&quot;"
        );
        assert_eq!(paragraphs("one\n\n two \n\n"), "<p>one</p>\n<p>two</p>\n");
    }
}
