//! Stress over the depth of a body before any load.

use crate::interpolate;

/// Stress along the surface over depth: linear between points, constant above the first and below
/// the last.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InitialStressProfile {
    sigma_x: Vec<[f64; 2]>,
    sigma_z: Vec<[f64; 2]>,
}

impl InitialStressProfile {
    /// Builds the profile from rows `[depth, σ_x, σ_z]` in the order of depth \[mm, MPa\]: along
    /// the surface in the plane of the section, and out of it.
    pub fn new(rows: impl IntoIterator<Item = [f64; 3]>) -> Self {
        let rows = rows.into_iter();
        let (sigma_x, sigma_z) = rows.map(|[depth, x, z]| ([depth, x], [depth, z])).unzip();
        Self { sigma_x, sigma_z }
    }

    /// Whether there is no stress.
    pub const fn is_empty(&self) -> bool {
        self.sigma_x.is_empty()
    }

    /// Returns the depths of the rows \[mm\].
    pub fn depths(&self) -> impl Iterator<Item = f64> {
        self.sigma_x.iter().map(|[depth, _]| *depth)
    }

    /// Returns `[σ_x, σ_z]` at a depth \[MPa\].
    pub fn at(&self, depth: f64) -> [f64; 2] {
        [&self.sigma_x, &self.sigma_z].map(|points| interpolate(points, depth).unwrap_or(0.0))
    }
}
