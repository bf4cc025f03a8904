//! VTK file of the surface of half-spaces: each cell is a rectangle in the plane z = 0.
//!
//! # Reference
//! *VTK XML file formats*, <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>.

use std::fmt::{Display, Write as _};
use std::iter::once;
use std::ops::Range;

use super::vtk::{END, QUAD, faces};
use crate::report::{MapsReport, Report};

/// The text before an array, its type, name and number of components, and a function that writes
/// its values at one x.
type Array = ([&'static str; 4], fn(&Surface, usize) -> String);

const ARRAYS: [Array; 6] = [
    (["", "Float64", "pressure", "1"], |surface, column| {
        spaced(&surface.maps.pressure[surface.cells(column)])
    }),
    (["", "Float64", "gap", "1"], |surface, column| {
        spaced(&surface.maps.gap[surface.cells(column)])
    }),
    (["</CellData>\n<Points>\n", "Float64", "Points", "3"], Surface::points),
    (["</Points>\n<Cells>\n", "Int64", "connectivity", "1"], Surface::corners),
    (["", "Int64", "offsets", "1"], |surface, column| {
        spaced(surface.cells(column).map(|cell| 4 * (cell + 1)))
    }),
    (["", "UInt8", "types", "1"], |surface, column| spaced(surface.cells(column).map(|_| QUAD))),
];

/// Returns the pieces of a file with `pressure` \[stress\] and `gap` \[length\] of each cell, in
/// the units of the job. A piece has the cells of one array at one x. `step` is counted from 0;
/// `steps` is the number of load steps.
pub fn surface_vtu(
    report: &Report,
    [step, steps]: [usize; 2],
    maps: MapsReport,
) -> impl Iterator<Item = String> + Send + use<> {
    let surface = Surface { along_x: faces(&maps.x, &[]), along_y: faces(&maps.y, &[]), maps };
    let columns = surface.maps.x.len();
    let head = format!(
        "<?xml version=\"1.0\"?>\n<!-- brinell {}, {}, units {}, step {} of {steps} -->\n\
         <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n\
         <UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<CellData \
         Scalars=\"pressure\">\n",
        report.version,
        report.analysis,
        report.units,
        step + 1,
        surface.along_x.len() * surface.along_y.len(),
        columns * surface.maps.y.len(),
    );
    let pieces =
        ARRAYS.into_iter().flat_map(move |array| (0..columns).map(move |column| (array, column)));
    let pieces = pieces.map(move |(([before, kind, name, components], values), column)| {
        let values = values(&surface, column);
        let begin = format!(
            "{before}<DataArray type=\"{kind}\" Name=\"{name}\" \
             NumberOfComponents=\"{components}\" format=\"ascii\">"
        );
        let begin = if column == 0 { &begin } else { "" };
        let end = if column + 1 == columns { "</DataArray>\n" } else { "" };
        [begin, &values, end].concat()
    });
    once(head).chain(pieces).chain(once(END.to_owned()))
}

/// The cells of a surface and the coordinates of their faces.
struct Surface {
    maps: MapsReport,
    along_x: Vec<f64>,
    along_y: Vec<f64>,
}

impl Surface {
    fn cells(&self, column: usize) -> Range<usize> {
        let rows = self.maps.y.len();
        column * rows..(column + 1) * rows
    }

    /// Writes the points on the near faces of the cells at one x, and on the far faces of the last
    /// cells.
    fn points(&self, column: usize) -> String {
        let end = if column + 1 == self.maps.x.len() { column + 2 } else { column + 1 };
        let along_x = self.along_x[column..end].iter();
        spaced(along_x.flat_map(|x| self.along_y.iter().flat_map(|y| [*x, *y, 0.0])))
    }

    fn corners(&self, column: usize) -> String {
        let point = |i: usize, j: usize| i * self.along_y.len() + j;
        let (i, rows) = (column, self.maps.y.len());
        spaced(
            (0..rows).flat_map(|j| {
                [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)]
            }),
        )
    }
}

fn spaced(values: impl IntoIterator<Item: Display>) -> String {
    let mut text = String::new();
    for value in values {
        let _ = write!(text, "{value} ");
    }
    text
}
