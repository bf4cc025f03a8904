//! Displacements of the surface of a track that is uniform along the travel.
//!
//! By reciprocity they are the works of stresses under line loads along x on a strip of width `hy`
//! \[1, section 2.5\]: under a pressure those of plane strain across the travel, under a traction
//! along the line those of antiplane shear,
//! ```text
//! σxz = -(1/π) [atan(a/z) - atan(b/z)]    σxy = -(1/2π) ln(r_a/r_b)
//! a = y + hy/2,  b = y - hy/2,  r_a = a² + z²,  r_b = b² + z²
//! ```
//! A ring ends half a period away from a load, and its own sum would miss 1.7 % of the groove of a
//! ball.
//!
//! # Reference
//! 1. K. L. Johnson, *Contact Mechanics* (1985).

use std::f64::consts::PI;

use crate::Layers;
use crate::line::strip;
use crate::tensors::DEVIATOR_COMPONENTS;
use crate::track::TrackGrid;

/// The kernels of uniform tracks.
pub struct UniformTrack {
    rows: usize,
    /// Layer, row of the load, row of the strain: work of the load on `xx yy xy xz yz` of both
    /// sides of the axis, over polarization times 2μ; the first three of a pressure, two of a
    /// traction.
    normal: Vec<[f64; 3]>,
    tangential: Vec<[f64; 2]>,
}

impl UniformTrack {
    pub(super) fn new(grid: &TrackGrid, layers: &Layers, poisson: f64) -> Self {
        let rows = grid.n_rows();
        let (mut normal, mut tangential) = (Vec::new(), Vec::new());
        for layer in 0..layers.len() {
            let faces = [layers.faces()[layer], layers.faces()[layer + 1]];
            let h = layers.thickness(layer);
            for at in 0..rows {
                for of in 0..rows {
                    // yz and xy of the other side have the other sign.
                    let sides = [(1.0, grid.y(of) - grid.y(at)), (-1.0, -grid.y(of) - grid.y(at))];
                    let (mut by_pressure, mut by_traction) = ([0.0; 3], [0.0; 2]);
                    for (sign, y) in sides {
                        let [[yy, zz, yz], _] = strip::average(y, faces, grid.sides()[1]);
                        let xx = poisson * (yy + zz);
                        by_pressure[0] += h * (xx - zz);
                        by_pressure[1] += h * (yy - zz);
                        by_pressure[2] += sign * h * 2.0 * yz;
                        let [xz, xy] = antiplane(y, faces, grid.sides()[1]);
                        by_traction[0] += sign * h * 2.0 * xy;
                        by_traction[1] += h * 2.0 * xz;
                    }
                    normal.push(by_pressure);
                    tangential.push(by_traction);
                }
            }
        }
        Self { rows, normal, tangential }
    }

    /// Returns the depth of the groove at the rows of the surface, of plastic strains
    /// `xx yy xy xz yz` in the rows of the layers; in the unit of the layers' depths.
    pub fn groove(&self, strain: &[[f64; DEVIATOR_COMPONENTS]]) -> Vec<f64> {
        self.sum(strain, &self.normal, |[xx, yy, yz], strain| {
            xx * strain[0] + yy * strain[1] + yz * strain[4]
        })
    }

    /// Returns the displacement of the rows of the surface in +x, against the depth.
    pub fn forward(&self, strain: &[[f64; DEVIATOR_COMPONENTS]]) -> Vec<f64> {
        self.sum(strain, &self.tangential, |[xy, xz], strain| xy * strain[2] + xz * strain[3])
    }

    fn sum<K: Copy>(
        &self,
        strain: &[[f64; DEVIATOR_COMPONENTS]],
        kernels: &[K],
        work: impl Fn(K, &[f64; DEVIATOR_COMPONENTS]) -> f64,
    ) -> Vec<f64> {
        let rows = self.rows;
        let mut displacement = vec![0.0; rows];
        let layers = strain.chunks_exact(rows).zip(kernels.chunks_exact(rows * rows));
        for (strain, kernels) in layers {
            for (u, kernels) in displacement.iter_mut().zip(kernels.chunks_exact(rows)) {
                *u += kernels.iter().zip(strain).map(|(k, strain)| work(*k, strain)).sum::<f64>();
            }
        }
        displacement
    }
}

/// σxz and σxy under a unit traction along x on a strip, averaged over a layer.
fn antiplane(y: f64, [top, bottom]: [f64; 2], h: f64) -> [f64; 2] {
    let (a, b) = (y + 0.5 * h, y - 0.5 * h);
    let reach = 0.5 / 3.0_f64.sqrt();
    let depths = [0.5 - reach, 0.5 + reach].map(|part| top + part * (bottom - top));
    let of = |z: f64| {
        let (ra, rb) = (a * a + z * z, b * b + z * z);
        [-(a.atan2(z) - b.atan2(z)) / PI, -(ra / rb).ln() / (2.0 * PI)]
    };
    let [upper, lower] = depths.map(of);
    std::array::from_fn(|k| 0.5 * (upper[k] + lower[k]))
}
