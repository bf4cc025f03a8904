//! Files of fields that are written piece by piece: nobody has to hold all of one, nor all of the
//! fields.

use std::ops::Range;

/// A file made of the arrays of a step ([`FieldLayout`](crate::report::FieldLayout)).
pub trait FieldsFile: Sized {
    /// A piece of it.
    type Piece: Clone;

    /// All pieces in order.
    fn pieces(&self) -> Vec<Self::Piece>;

    /// Where the numbers stand in the bytes of the step that a piece is made of.
    fn sources(piece: &Self::Piece) -> &[Range<usize>];

    /// Writes a piece of the bytes at its sources.
    fn write<B: AsRef<[u8]>>(&mut self, piece: &Self::Piece, sources: &[B]) -> String;

    /// The whole file of the bytes of the step.
    fn whole(mut self, bytes: &[u8]) -> String {
        let written = self.pieces().into_iter().map(|piece| {
            let sources: Vec<&[u8]> =
                Self::sources(&piece).iter().map(|source| &bytes[source.clone()]).collect();
            self.write(&piece, &sources)
        });
        written.collect()
    }
}
