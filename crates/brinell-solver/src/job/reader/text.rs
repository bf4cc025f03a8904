//! Figures and quotations of the user's text in messages: readable, and shorter than a line.

use std::fmt;

use super::tree::Node;

/// Most characters of a quotation.
const LONGEST_QUOTE: usize = 40;

/// A figure without trailing zeros: `0.3`, `210000`, `2.1e11`.
pub struct Figure(pub f64);

impl fmt::Display for Figure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plain = self.0 == 0.0 || (1e-4..1e7).contains(&self.0.abs());
        if plain { write!(f, "{}", self.0) } else { write!(f, "{:e}", self.0) }
    }
}

/// Returns a computed figure, rounded to five digits.
pub fn five_digits(value: f64) -> Figure {
    Figure(format!("{value:.4e}").parse().unwrap_or(value))
}

/// A string in quotation marks with escaped control characters, shortened with `…` if long.
pub struct Quoted<'a>(pub &'a str);

impl fmt::Display for Quoted<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.char_indices().nth(LONGEST_QUOTE) {
            None => write!(f, "{:?}", self.0),
            Some((end, _)) => write!(f, "{:?}…", self.0.get(..end).unwrap_or_default()),
        }
    }
}

/// A value after the word "got" of a message.
pub struct Got<'a>(pub &'a Node);

impl fmt::Display for Got<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Node::Bool(value) => write!(f, "{value}"),
            Node::Number(value) => Figure(*value).fmt(f),
            Node::Text(text) => Quoted(text).fmt(f),
            Node::Array(items) => write!(f, "an array of {}", items.len()),
            other => f.write_str(other.kind()),
        }
    }
}

/// A list of words: `type, radius`.
pub struct List<'a>(pub &'a [&'a str]);

impl fmt::Display for List<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, word) in self.0.iter().enumerate() {
            write!(f, "{}{word}", if index == 0 { "" } else { ", " })?;
        }
        Ok(())
    }
}

/// What others ask for and this solver does not have, and what it has in its place.
const NOT_THERE: [(&[&str], &str); 6] = [
    (
        &["layer", "layers", "coating", "coatings"],
        "layers of other moduli are not solved; strength over depth is `over_depth` of a law",
    ),
    (
        &["slip", "creepage", "stick"],
        "there is no partial slip; where there is friction, the whole contact slides",
    ),
    (&["friction", "friction_coefficient"], "friction is that of `load.rolling` alone"),
    (&["adhesion", "work_of_adhesion", "surface_energy"], "adhesion is not solved"),
    (&["torque", "moment", "tangential_force"], "bodies are pressed along the normal alone"),
    (&["HRA", "HK", "HBS", "HR15N", "HR30N", "HR45N"], "tests by this scale are not there"),
];

/// The end of a message that says what is not there, or suggests the most similar known word.
pub struct Guess<'a> {
    /// The word in the document.
    pub written: &'a str,
    /// The known words.
    pub known: &'a [&'a str],
}

impl fmt::Display for Guess<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let written = bare(self.written);
        let is_written = |word: &&str| bare(word) == written;
        let absent = NOT_THERE.iter().find(|(words, _)| words.iter().any(is_written));
        match (absent, self.nearest()) {
            (Some((_, instead)), _) => write!(f, "; {instead}"),
            (None, Some(word)) => write!(f, "; did you mean `{word}`?"),
            (None, None) => Ok(()),
        }
    }
}

impl Guess<'_> {
    /// Returns the known word at the smallest edit distance, up to a third of its length. Case,
    /// hyphens and underscores are ignored, so that `youngModulus` finds `young_modulus`.
    fn nearest(&self) -> Option<&str> {
        let written = bare(self.written);
        if written.len() > 2 * LONGEST_QUOTE {
            return None;
        }
        self.known
            .iter()
            .map(|word| (edit_distance(&written, &bare(word)), *word))
            .filter(|(distance, word)| *distance <= word.len() / 3)
            .min_by_key(|(distance, _)| *distance)
            .map(|(_, word)| word)
    }
}

fn bare(word: &str) -> Vec<char> {
    let significant = word.chars().filter(|c| !matches!(c, '_' | '-' | ' '));
    significant.map(|c| c.to_ascii_lowercase()).take(2 * LONGEST_QUOTE + 1).collect()
}

/// Returns the Levenshtein distance, with a swap of neighbours as one edit (optimal string
/// alignment).
fn edit_distance(left: &[char], right: &[char]) -> usize {
    let mut before_last: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=right.len()).collect();
    for (i, a) in left.iter().enumerate() {
        let mut row = vec![i + 1];
        for (j, b) in right.iter().enumerate() {
            let substituted = last[j] + usize::from(a != b);
            let mut best = substituted.min(last[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && *a == right[j - 1] && left[i - 1] == *b {
                best = best.min(before_last[j - 1] + 1);
            }
            row.push(best);
        }
        before_last = std::mem::replace(&mut last, row);
    }
    last[right.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHAPE_KEYS: &[&str] = &["type", "radius", "width", "depth"];

    #[test]
    fn figures_are_short() {
        let shown = [0.3, 210_000.0, 2.1e11, 1e300, -1e-9, 0.0].map(|v| Figure(v).to_string());
        assert_eq!(shown, ["0.3", "210000", "2.1e11", "1e300", "-1e-9", "0"]);
    }

    #[test]
    fn computed_figures_have_five_digits() {
        let shown =
            [0.0, 1e7 / 3.0, 0.1 + 0.2, 1e7, -1.0 / 3e6].map(|v| five_digits(v).to_string());
        assert_eq!(shown, ["0", "3333300", "0.3", "1e7", "-3.3333e-7"]);
    }

    #[test]
    fn long_text_is_cut_between_characters() {
        assert_eq!(Quoted(&"é".repeat(1_000_000)).to_string(), format!("\"{}\"…", "é".repeat(40)));
        assert_eq!(Quoted("a\n\"b").to_string(), r#""a\n\"b""#);
    }

    #[test]
    fn guesses_the_word_that_was_meant() {
        let guess = |written| Guess { written, known: SHAPE_KEYS }.nearest().map(str::to_owned);
        assert_eq!(guess("raduis").as_deref(), Some("radius"));
        assert_eq!(guess("Radius").as_deref(), Some("radius"));
        assert_eq!(guess("with").as_deref(), Some("width"));
        assert_eq!(guess("colour"), None);
        assert_eq!(guess(""), None);
        let keys = Guess { written: "youngModulus", known: &["young_modulus"] };
        assert_eq!(keys.nearest(), Some("young_modulus"));
        assert_eq!(guess(&"radius".repeat(100_000)), None);
    }

    #[test]
    fn what_is_not_there_is_named() {
        let said = |written: &str| Guess { written, known: SHAPE_KEYS }.to_string();
        for (words, instead) in NOT_THERE {
            for word in words {
                assert_eq!(said(word), format!("; {instead}"));
                assert_eq!(said(&word.to_uppercase()), said(&word.to_lowercase()));
            }
        }
    }

    #[test]
    fn swapped_neighbours_are_one_edit() {
        let distance = |a: &str, b: &str| edit_distance(&bare(a), &bare(b));
        assert_eq!(distance("raduis", "radius"), 1);
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("kitten", "sitting"), 3);
    }
}
