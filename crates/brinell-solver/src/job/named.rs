//! Words of the wire format.

/// An enumeration that the wire format writes as a word.
pub trait Named: Copy + 'static {
    /// All values, in the order in which messages list them.
    const ALL: &'static [Self];

    /// Returns the word of this value.
    fn name(self) -> &'static str;
}
