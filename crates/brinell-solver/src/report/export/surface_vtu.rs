//! VTK file of the surface of half-spaces: each cell is a rectangle in the plane z = 0.

use std::ops::Range;

use super::vtk::Type::{Float64, Int64, UInt8};
use super::vtk::{Array, Encoding, QUAD, Sources, Values, VtkContents, VtkFile, faces};
use crate::report::{MapsReport, Report};

/// Returns the pieces of a file with `pressure` \[stress\] and `gap` \[length\] of each cell, in
/// the units of the job. A piece has the cells of one array at one x. `step` is counted from 0;
/// `steps` is the number of load steps.
pub fn surface_vtu(
    report: &Report,
    [step, steps]: [usize; 2],
    maps: MapsReport,
) -> impl Iterator<Item = String> + Send + use<> {
    let surface = Surface { along_x: faces(&maps.x, &[]), along_y: faces(&maps.y, &[]), maps };
    let mut file = VtkFile::of(report, [step, steps], surface);
    file.pieces().into_iter().map(move |piece| file.write(&piece, &[] as &[&[u8]]))
}

/// The cells at one x.
#[derive(Debug, Clone)]
struct Column(usize);

/// The cells of a surface and the coordinates of their faces.
struct Surface {
    maps: MapsReport,
    along_x: Vec<f64>,
    along_y: Vec<f64>,
}

impl Surface {
    fn n_cells(&self) -> usize {
        self.maps.x.len() * self.maps.y.len()
    }

    fn n_points(&self) -> usize {
        self.along_x.len() * self.along_y.len()
    }

    fn cells(&self, column: usize) -> Range<usize> {
        let rows = self.maps.y.len();
        column * rows..(column + 1) * rows
    }

    /// Writes the points on the near faces of the cells at one x, and on the far faces of the last
    /// cells.
    fn points(&self, &Column(column): &Column, _: Sources, values: &mut Values) {
        let end = if column + 1 == self.maps.x.len() { column + 2 } else { column + 1 };
        let along_x = self.along_x[column..end].iter();
        values.floats(along_x.flat_map(|x| self.along_y.iter().flat_map(|y| [*x, *y, 0.0])));
    }

    fn corners(&self, &Column(column): &Column, _: Sources, values: &mut Values) {
        let point = |i: usize, j: usize| i * self.along_y.len() + j;
        let i = column;
        let of_cell = |j| [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
        values.integers((0..self.maps.y.len()).flat_map(of_cell));
    }
}

const CELLS: &str = "CellData Scalars=\"pressure\"";

impl VtkContents for Surface {
    type Block = Column;

    const GRID: &'static str = "UnstructuredGrid";
    const ENCODING: Encoding = Encoding::Ascii;
    const ARRAYS: &'static [Array<Self>] = &[
        Array(CELLS, Float64, "pressure", 1, Self::n_cells, &[], |all, column, _, values| {
            values.floats(all.maps.pressure[all.cells(column.0)].iter().copied());
        }),
        Array(CELLS, Float64, "gap", 1, Self::n_cells, &[], |all, column, _, values| {
            values.floats(all.maps.gap[all.cells(column.0)].iter().copied());
        }),
        Array("Points", Float64, "Points", 3, Self::n_points, &[], Self::points),
        Array("Cells", Int64, "connectivity", 1, |all| 4 * all.n_cells(), &[], Self::corners),
        Array("Cells", Int64, "offsets", 1, Self::n_cells, &[], |all, column, _, values| {
            values.integers(all.cells(column.0).map(|cell| 4 * (cell + 1)));
        }),
        Array("Cells", UInt8, "types", 1, Self::n_cells, &[], |all, column, _, values| {
            values.repeated(QUAD, all.cells(column.0).len());
        }),
    ];

    fn size(&self) -> [String; 2] {
        let (points, cells) = (self.n_points(), self.n_cells());
        [String::new(), format!("NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\"")]
    }

    fn blocks(&self, _: &Array<Self>) -> Vec<(Column, Vec<Range<usize>>)> {
        (0..self.maps.x.len()).map(|column| (Column(column), Vec::new())).collect()
    }
}
