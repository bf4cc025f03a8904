//! Colours and characters that the terminal supports.

use std::env;
use std::io::{self, IsTerminal};

/// Capabilities of the output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    /// ANSI colours.
    pub colour: bool,
    /// Characters beyond ASCII.
    pub unicode: bool,
}

/// Characters beyond ASCII, and what stands for them.
const SPELLED: [(&str, &str); 12] = [
    ("σ", "s"),
    ("ν", "nu"),
    ("ε", "e"),
    ("Δ", "d"),
    ("θ", "t"),
    ("α", "a"),
    ("┤│╵", "|"),
    ("└┴", "+"),
    ("·—─", "-"),
    ("…", "."),
    ("±", "~"),
    ("²", "2"),
];

impl Style {
    /// Style of files: Unicode without colours.
    pub const PLAIN: Self = Self { colour: false, unicode: true };

    /// Returns the style of standard output.
    pub fn of_stdout() -> Self {
        Self::of(io::stdout().is_terminal())
    }

    /// Returns the style of standard error.
    pub fn of_stderr() -> Self {
        Self::of(io::stderr().is_terminal())
    }

    fn of(is_terminal: bool) -> Self {
        let no_colour = env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        let dumb = env::var_os("TERM").is_some_and(|value| value == "dumb");
        let locale = ["LC_ALL", "LC_CTYPE", "LANG"]
            .into_iter()
            .find_map(|name| env::var(name).ok().filter(|value| !value.is_empty()));
        Self {
            colour: is_terminal && !no_colour && !dumb,
            unicode: locale.is_none_or(|name| is_unicode(&name)),
        }
    }

    fn paint(self, code: &str, text: &str) -> String {
        if self.colour { format!("\x1b[{code}m{text}\x1b[0m") } else { text.to_owned() }
    }

    /// Important.
    #[must_use]
    pub fn bold(self, text: &str) -> String {
        self.paint("1", text)
    }

    /// In the background.
    #[must_use]
    pub fn dim(self, text: &str) -> String {
        self.paint("2", text)
    }

    /// Wrong.
    #[must_use]
    pub fn red(self, text: &str) -> String {
        self.paint("1;31", text)
    }

    /// Right.
    #[must_use]
    pub fn green(self, text: &str) -> String {
        self.paint("1;32", text)
    }

    /// To be careful with.
    #[must_use]
    pub fn yellow(self, text: &str) -> String {
        self.paint("33", text)
    }

    /// The curve that matters.
    #[must_use]
    pub fn cyan(self, text: &str) -> String {
        self.paint("36", text)
    }

    /// The text in the characters this terminal has.
    #[must_use]
    pub fn spell(self, text: String) -> String {
        if self.unicode || text.is_ascii() {
            return text;
        }
        let spelled = |symbol: char| match SPELLED.iter().find(|(of, _)| of.contains(symbol)) {
            Some((_, ascii)) => (*ascii).to_owned(),
            None if symbol.is_ascii() => symbol.to_string(),
            None => "?".to_owned(),
        };
        text.chars().map(spelled).collect()
    }
}

fn is_unicode(locale: &str) -> bool {
    let locale = locale.to_ascii_lowercase();
    locale.contains("utf-8") || locale.contains("utf8")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ascii_terminals_get_ascii() {
        let ascii = Style { colour: false, unicode: false };
        assert_eq!(ascii.spell("σ_y 500 MPa · ν 0.3 ┤".to_owned()), "s_y 500 MPa - nu 0.3 |");
        assert!(is_unicode("en_GB.UTF-8") && is_unicode("C.utf8") && !is_unicode("C"));
    }
}
