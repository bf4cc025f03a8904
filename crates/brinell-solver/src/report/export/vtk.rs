//! Parts that VTK files share.

use super::ExportError;
use crate::report::FieldArraysError;

/// Number of the quadrilateral with 4 nodes in VTK.
pub(super) const QUAD: u8 = 9;

pub(super) const END: &str = "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";

pub(super) const TENSOR: &str = "NumberOfComponents=\"6\" ComponentName0=\"XX\" \
                                 ComponentName1=\"YY\" ComponentName2=\"ZZ\" \
                                 ComponentName3=\"XY\" ComponentName4=\"YZ\" \
                                 ComponentName5=\"XZ\"";

#[expect(clippy::needless_pass_by_value, reason = "for map_err")]
pub(super) fn unusable(error: FieldArraysError) -> ExportError {
    ExportError::Fields(error.to_string())
}

/// Returns the faces of cells of equal width with these middles.
pub(super) fn faces(middles: &[f64], across: &[f64]) -> Vec<f64> {
    let width = |places: &[f64]| Some(places.get(1)? - places.first()?);
    let width = width(middles).or_else(|| width(across)).unwrap_or(1.0);
    let first = middles.first().map(|first| first - 0.5 * width);
    first.into_iter().chain(middles.iter().map(|middle| middle + 0.5 * width)).collect()
}
