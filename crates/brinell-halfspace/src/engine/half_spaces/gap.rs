//! Ends, relief and tilt of rollers, and heights on top of the shapes.

use crate::SurfaceGrid;

/// The deviation of a roller's surface from an endless cylinder. Lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct RollerGap {
    /// Radius; the surface lies deeper by the radius beyond the ends.
    pub radius: f64,
    /// Length along the axis.
    pub length: f64,
    /// Angle from the job's x to the roller's x, towards the job's y \[rad\].
    pub rotation: f64,
    /// Slope by which the surface rises along the roller's y.
    pub tilt: f64,
    /// Moment about the middle of the roller, positive towards its y, if the tilt follows from it
    /// \[N mm\].
    pub moment: Option<f64>,
    /// Profile of the surface along the axis.
    pub relief: Relief,
}

/// The profile of a roller along its axis, apart from an arc, which is part of the curvature.
/// Lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub enum Relief {
    /// A straight profile.
    Straight,
    /// A profile that falls by `c ln(1/(1 - (2y/L)²))` with this c.
    Logarithmic(f64),
    /// Points `[y, height]` in the order of y, joined by straight lines, level beyond the last
    /// ones.
    Points(Vec<[f64; 2]>),
}

impl RollerGap {
    /// Returns the depth of the surface below the endless cylinder at a point in the job's axes.
    pub(in crate::engine) fn fall(&self, [x, y]: [f64; 2]) -> f64 {
        let (sine, cosine) = self.rotation.sin_cos();
        let along = cosine * y - sine * x;
        let part = (2.0 * along / self.length).abs();
        if part >= 1.0 {
            return self.radius;
        }
        let relief = match &self.relief {
            Relief::Straight => 0.0,
            Relief::Logarithmic(scale) => -scale * (-part * part).ln_1p(),
            Relief::Points(points) => -height(points, along),
        };
        relief - self.tilt * along
    }

    /// Whether curvature and length describe the roller completely.
    pub fn is_plain(&self) -> bool {
        matches!(self.relief, Relief::Straight) && !self.is_tilted()
    }

    fn is_tilted(&self) -> bool {
        self.tilt.abs() > 0.0 || self.moment.is_some()
    }

    /// Whether the two halves of the roller are mirror images.
    pub(in crate::engine) fn is_even(&self) -> bool {
        !self.is_tilted()
            && match &self.relief {
                Relief::Straight | Relief::Logarithmic(_) => true,
                Relief::Points(points) => {
                    let turned = points.iter().rev().map(|[y, height]| [-y, *height]);
                    points.iter().copied().eq(turned)
                }
            }
    }
}

/// Summed heights of both surfaces at the middles of equal cells around the origin. Lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightMap {
    /// Heights, `[i * cells[1] + j]`.
    pub heights: Vec<f64>,
    /// Number of cells along x and y.
    pub cells: [usize; 2],
    /// Sides of a cell along x and y.
    pub spacing: [f64; 2],
}

impl HeightMap {
    /// Returns half the extents of the map.
    pub fn half_sides(&self) -> [f64; 2] {
        [0, 1].map(|k| 0.5 * self.cells[k] as f64 * self.spacing[k])
    }

    /// Returns the mean heights in the cells of a grid of the same size with at most as many
    /// cells.
    pub(super) fn over(&self, grid: &SurfaceGrid) -> Vec<f64> {
        let (mut sums, mut counts) = (vec![0.0; grid.n_cells()], vec![0.0; grid.n_cells()]);
        let [nx, ny] = self.cells;
        for (k, height) in self.heights.iter().enumerate() {
            let cell = (k / ny) * grid.nx() / nx * grid.ny() + (k % ny) * grid.ny() / ny;
            sums[cell] += height;
            counts[cell] += 1.0;
        }
        sums.iter().zip(&counts).map(|(sum, count)| sum / count).collect()
    }
}

/// Interpolates linearly between points; level beyond the last ones.
fn height(points: &[[f64; 2]], at: f64) -> f64 {
    let after = points.partition_point(|[y, _]| *y < at);
    match (after.checked_sub(1).and_then(|before| points.get(before)), points.get(after)) {
        (Some([y0, h0]), Some([y1, h1])) => h0 + (h1 - h0) * (at - y0) / (y1 - y0),
        (Some([_, level]), None) | (None, Some([_, level])) => *level,
        (None, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roller(relief: Relief) -> RollerGap {
        RollerGap { radius: 5.0, length: 8.0, rotation: 0.0, tilt: 0.0, moment: None, relief }
    }

    #[test]
    fn heights_are_averaged_over_larger_cells() {
        let heights: Vec<f64> = (0..40).map(f64::from).collect();
        let map = HeightMap { heights, cells: [8, 5], spacing: [0.1, 0.2] };
        let grid = SurfaceGrid::new(8, 5, 0.1, 0.2).unwrap();
        assert_eq!(map.over(&grid), map.heights);
        let coarse = map.over(&SurfaceGrid::new(4, 2, 0.2, 0.5).unwrap());
        assert!((coarse[0] - 3.5).abs() < 1e-12 && (coarse[7] - 36.0).abs() < 1e-12, "{coarse:?}");
    }

    #[test]
    fn a_roller_falls_towards_its_ends() {
        assert_eq!(roller(Relief::Straight).fall([1.0, 3.9]).to_bits(), 0.0f64.to_bits());
        assert_eq!(roller(Relief::Straight).fall([1.0, -4.1]).to_bits(), 5.0f64.to_bits());
        let logarithmic = roller(Relief::Logarithmic(1e-3));
        assert!((logarithmic.fall([0.0, 2.0]) - 1e-3 * (4.0f64 / 3.0).ln()).abs() < 1e-15);
        let points =
            roller(Relief::Points(vec![[-3.0, -0.01], [0.0, 0.0], [2.0, 0.0], [3.0, -0.02]]));
        for (y, fall) in [(-3.5, 0.01), (-1.5, 0.005), (1.0, 0.0), (2.5, 0.01), (3.5, 0.02)] {
            assert!((points.fall([0.0, y]) - fall).abs() < 1e-15, "{y}");
        }
        assert!(logarithmic.is_even() && !points.is_even());
        let turned = RollerGap { rotation: std::f64::consts::FRAC_PI_2, ..points };
        assert!((turned.fall([1.5, 0.0]) - 0.005).abs() < 1e-15, "its y is the job's -x");
        let tilted = RollerGap { tilt: 1e-3, ..roller(Relief::Straight) };
        assert!(
            (tilted.fall([0.0, 3.0]) + 3e-3).abs() < 1e-15
                && !tilted.is_even()
                && !tilted.is_plain()
        );
    }
}
