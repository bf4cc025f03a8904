//! Discretization of pressures and plastic strains: cells of the surface, layers below them.

use thiserror::Error;

/// Why a discretization was refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum GridError {
    /// Fewer than two cells along a side.
    #[error("a surface grid needs two cells along each side, got {0} × {1}")]
    TooFewCells(usize, usize),
    /// More columns than anybody can wait for.
    #[error(
        "a track of {0} columns is too long: take fewer over a half-width, or a shorter track"
    )]
    TooManyColumns(usize),
    /// A cell without a size.
    #[error("the cells' sides have to be positive, got {0} × {1} mm")]
    CellSize(f64, f64),
    /// Layers that do not lie one below the other, from the surface down.
    #[error("the faces of the layers have to begin at the surface and descend (face {0})")]
    Faces(usize),
}

/// Cells of one size on the surface z = 0, in rows along y: cell `(i, j)` has the index `i ny +
/// j`.
///
/// The middle of the grid is the origin. Cells may be elongated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceGrid {
    nx: usize,
    ny: usize,
    hx: f64,
    hy: f64,
}

impl SurfaceGrid {
    /// A grid of `nx × ny` cells of `hx × hy` \[mm\].
    ///
    /// # Errors
    /// [`GridError`]: fewer than two cells along a side, or sides that are not positive.
    pub fn new(nx: usize, ny: usize, hx: f64, hy: f64) -> Result<Self, GridError> {
        if nx < 2 || ny < 2 {
            return Err(GridError::TooFewCells(nx, ny));
        }
        if !(hx > 0.0 && hy > 0.0 && hx.is_finite() && hy.is_finite()) {
            return Err(GridError::CellSize(hx, hy));
        }
        Ok(Self { nx, ny, hx, hy })
    }

    /// Cells along x.
    pub const fn nx(&self) -> usize {
        self.nx
    }

    /// Cells along y.
    pub const fn ny(&self) -> usize {
        self.ny
    }

    /// Side of a cell along x \[mm\].
    pub const fn hx(&self) -> f64 {
        self.hx
    }

    /// Side of a cell along y \[mm\].
    pub const fn hy(&self) -> f64 {
        self.hy
    }

    /// Number of cells.
    pub const fn n_cells(&self) -> usize {
        self.nx * self.ny
    }

    /// Area of a cell \[mm²\].
    pub fn cell_area(&self) -> f64 {
        self.hx * self.hy
    }

    /// x of the centre of the cells `(i, ·)` \[mm\].
    pub fn x(&self, i: usize) -> f64 {
        (i as f64 - 0.5 * (self.nx - 1) as f64) * self.hx
    }

    /// y of the centre of the cells `(·, j)` \[mm\].
    pub fn y(&self, j: usize) -> f64 {
        (j as f64 - 0.5 * (self.ny - 1) as f64) * self.hy
    }

    /// A value at the centre of each cell.
    pub fn sample(&self, value: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let value = &value;
        (0..self.nx).flat_map(|i| (0..self.ny).map(move |j| value(self.x(i), self.y(j)))).collect()
    }
}

/// Layers of a body, from the surface down; plastic strain is constant in each cell of each layer.
#[derive(Debug, Clone, PartialEq)]
pub struct Layers {
    faces: Vec<f64>,
}

impl Layers {
    /// Layers between consecutive faces \[mm\], the first of which is the surface z = 0.
    ///
    /// # Errors
    /// [`GridError::Faces`]: no layer, a first face that is not 0, or faces that do not descend.
    pub fn new(faces: Vec<f64>) -> Result<Self, GridError> {
        if faces.len() < 2 || faces[0] != 0.0 {
            return Err(GridError::Faces(0));
        }
        match faces.windows(2).position(|pair| !(pair[1] > pair[0] && pair[1].is_finite())) {
            Some(k) => Err(GridError::Faces(k + 1)),
            None => Ok(Self { faces }),
        }
    }

    /// Layers that grow by a constant factor from `first` \[mm\] until they reach `depth` \[mm\].
    ///
    /// # Errors
    /// [`GridError::Faces`]: a first layer that is not positive, or a factor that never reaches the depth.
    pub fn graded(first: f64, growth: f64, depth: f64) -> Result<Self, GridError> {
        if !(first > 0.0 && growth >= 1.0 && depth > 0.0 && depth.is_finite()) {
            return Err(GridError::Faces(1));
        }
        let (mut faces, mut face, mut thickness) = (vec![0.0], 0.0, first);
        while face < depth {
            face += thickness;
            faces.push(face);
            thickness *= growth;
        }
        Self::new(faces)
    }

    /// Number of layers.
    pub const fn len(&self) -> usize {
        self.faces.len() - 1
    }

    /// Always false: there is at least one layer.
    pub const fn is_empty(&self) -> bool {
        false
    }

    /// Depths of the faces \[mm\], one more than there are layers.
    pub fn faces(&self) -> &[f64] {
        &self.faces
    }

    /// Thickness of a layer \[mm\].
    pub fn thickness(&self, layer: usize) -> f64 {
        self.faces[layer + 1] - self.faces[layer]
    }

    /// Depth of the middle of a layer \[mm\].
    pub fn middle(&self, layer: usize) -> f64 {
        0.5 * (self.faces[layer + 1] + self.faces[layer])
    }

    /// The surface, and middle and lower face of each layer \[mm\].
    pub fn faces_and_middles(&self) -> Vec<f64> {
        let below = |layer: usize| [self.middle(layer), self.faces[layer + 1]];
        std::iter::once(0.0).chain((0..self.len()).flat_map(below)).collect()
    }

    /// The layer at a depth \[mm\], of two that meet there the lower one; the last one below all.
    pub fn at(&self, depth: f64) -> usize {
        let above = self.faces.partition_point(|face| *face <= depth);
        above.saturating_sub(1).min(self.len() - 1)
    }

    /// Layers merged in groups of `count`, the last group possibly smaller.
    #[must_use]
    pub fn merged(&self, count: usize) -> Self {
        let n = self.len();
        let faces = (0..n).step_by(count.max(1)).chain([n]).map(|face| self.faces[face]).collect();
        Self { faces }
    }
}
