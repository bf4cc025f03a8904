//! Files of fields that are written piece by piece, so that neither the file nor the fields have
//! to be in memory as a whole.

use std::ops::Range;

/// A file that is written from the arrays of a load step
/// ([`FieldLayout`](crate::report::FieldLayout)).
pub trait FieldsFile: Sized {
    /// A piece of the file.
    type Piece: Clone;

    /// Returns all pieces of the file in order.
    fn pieces(&self) -> Vec<Self::Piece>;

    /// Returns the positions of the source numbers of a piece in the bytes of the load step.
    fn sources(piece: &Self::Piece) -> &[Range<usize>];

    /// Writes a piece from the bytes at its sources.
    fn write<B: AsRef<[u8]>>(&mut self, piece: &Self::Piece, sources: &[B]) -> String;

    /// Writes the whole file from the bytes of the load step.
    fn whole(mut self, bytes: &[u8]) -> String {
        let written = self.pieces().into_iter().map(|piece| {
            let sources: Vec<&[u8]> =
                Self::sources(&piece).iter().map(|source| &bytes[source.clone()]).collect();
            self.write(&piece, &sources)
        });
        written.collect()
    }
}
