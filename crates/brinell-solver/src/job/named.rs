//! Words of the wire format.

use brinell_method::observer::SolveStatus;
use brinell_method::settings::Theory;
use brinell_method::sought::TargetFigure;
use brinell_method::words::Quantity;
use strum::VariantArray;

/// An enumeration that the wire format writes as a word. `strum` derives the words and the list.
pub trait Named: Copy + VariantArray + Into<&'static str> {
    /// All values, in the order in which messages list them.
    const ALL: &'static [Self] = Self::VARIANTS;

    /// Returns the word of this value.
    fn name(self) -> &'static str {
        self.into()
    }
}

impl Named for Quantity {}
impl Named for SolveStatus {}
impl Named for TargetFigure {}
impl Named for Theory {}
