//! Words of the wire format.

use brinell_method::observer::SolveStatus;
use brinell_method::settings::Theory;
use brinell_method::sought::TargetFigure;
use brinell_method::words::{Quantity, Side};
use strum::VariantArray;

/// An enumeration that the wire format writes as a word. `strum` derives the words and the list.
pub trait Named: Copy + VariantArray + Into<&'static str> {
    /// All values, in the order in which messages list them.
    const ALL: &'static [Self] = Self::VARIANTS;
    /// Words of earlier versions, which are read and not written.
    const FORMER: &'static [(&'static str, Self)] = &[];

    /// Returns the word of this value.
    fn name(self) -> &'static str {
        self.into()
    }

    /// Returns the value that a word names, or named in an earlier version.
    fn of_word(word: &str) -> Option<Self> {
        let now = Self::ALL.iter().copied().find(|value| value.name() == word);
        now.or_else(|| {
            Self::FORMER.iter().find(|(former, _)| *former == word).map(|(_, now)| *now)
        })
    }
}

impl Named for Quantity {}
impl Named for Side {}
impl Named for SolveStatus {}
impl Named for TargetFigure {}
impl Named for Theory {}
