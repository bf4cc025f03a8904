//! The surface of half-spaces as a VTK file: the cells as rectangles in the plane z = 0.
//!
//! # Reference
//! *VTK XML file formats*, <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>.

use std::fmt::Write as _;

use crate::report::{MapsReport, Report};

/// VTK's number for a quadrilateral with 4 nodes.
const QUAD: u8 = 9;

/// `pressure` \[stress\] and `gap` \[length\] of each cell, in the units of the job. The step is counted from 0, the last of so many.
pub(super) fn surface_vtu(report: &Report, [step, steps]: [usize; 2], maps: &MapsReport) -> String {
    let (along_x, along_y) = (faces(&maps.x), faces(&maps.y));
    let (columns, rows) = (maps.x.len(), maps.y.len());
    let mut text = String::with_capacity(120 * columns * rows + 2000);
    let _ = write!(
        text,
        "<?xml version=\"1.0\"?>\n<!-- brinell {}, {}, units {}, step {} of {steps} -->\n\
         <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n\
         <UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<CellData Scalars=\"pressure\">\n",
        report.version,
        report.analysis,
        report.units,
        step + 1,
        along_x.len() * along_y.len(),
        columns * rows,
    );
    array(&mut text, "Float64", "pressure", 1, &maps.pressure);
    array(&mut text, "Float64", "gap", 1, &maps.gap);
    text.push_str("</CellData>\n<Points>\n");
    let points: Vec<f64> = along_x.iter().flat_map(|x| along_y.iter().flat_map(|y| [*x, *y, 0.0])).collect();
    array(&mut text, "Float64", "Points", 3, &points);
    text.push_str("</Points>\n<Cells>\n");
    let point = |i: usize, j: usize| i * (rows + 1) + j;
    let square = |i: usize, j: usize| [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
    let corners: Vec<usize> = (0..columns).flat_map(|i| (0..rows).flat_map(move |j| square(i, j))).collect();
    array(&mut text, "Int64", "connectivity", 1, &corners);
    array(&mut text, "Int64", "offsets", 1, &(1..=columns * rows).map(|k| 4 * k).collect::<Vec<_>>());
    array(&mut text, "UInt8", "types", 1, &vec![QUAD; columns * rows]);
    text.push_str("</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    text
}

fn array<T: ToString>(text: &mut String, kind: &str, name: &str, components: usize, values: &[T]) {
    let _ = write!(
        text,
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"ascii\">"
    );
    for value in values {
        text.push_str(&value.to_string());
        text.push(' ');
    }
    text.push_str("</DataArray>\n");
}

/// Faces of cells of one width with these middles.
fn faces(middles: &[f64]) -> Vec<f64> {
    let width = if let [first, second, ..] = middles { second - first } else { 1.0 };
    let first = middles.first().map(|first| first - 0.5 * width);
    first.into_iter().chain(middles.iter().map(|middle| middle + 0.5 * width)).collect()
}
