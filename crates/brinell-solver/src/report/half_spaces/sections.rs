//! Rows of cells through the middle of a surface.

use crate::solver::half_spaces::SurfaceMap;

/// Returns the row of cells at y = 0, or the mean of the two rows beside y = 0.
pub(super) fn section_along_x(map: &SurfaceMap, values: &[f64]) -> Vec<f64> {
    let (nx, ny) = (map.grid.nx(), map.grid.ny());
    let [low, high] = middle(ny);
    (0..nx).map(|i| 0.5 * (values[i * ny + low] + values[i * ny + high])).collect()
}

/// Returns the row of cells at x = 0, or the mean of the two rows beside x = 0.
pub(super) fn section_along_y(map: &SurfaceMap, values: &[f64]) -> Vec<f64> {
    let (nx, ny) = (map.grid.nx(), map.grid.ny());
    let [low, high] = middle(nx);
    (0..ny).map(|j| 0.5 * (values[low * ny + j] + values[high * ny + j])).collect()
}

/// Returns the places of the two rows beside the middle, of an odd number twice the same.
pub(super) const fn middle(count: usize) -> [usize; 2] {
    [(count - 1) / 2, count / 2]
}
