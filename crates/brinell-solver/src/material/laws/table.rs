//! A measured curve.

use crate::material::HardeningLaw;

/// Piecewise linear through points of plastic strain and stress; constant beyond the last.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// `[ε_q, q]` at each point: the equivalent strain `q/(3G) + ε_p` and the stress \[MPa\].
    points: Vec<[f64; 2]>,
}

impl Table {
    /// Takes points `[ε_p, q]`, the first at zero plastic strain, strains rising and stresses not falling.
    pub(in crate::material) fn new(points: &[[f64; 2]], triple_shear: f64) -> Self {
        Self {
            points: points.iter().map(|&[strain, stress]| [stress / triple_shear + strain, stress]).collect(),
        }
    }
}

impl HardeningLaw for Table {
    fn yield_stress(&self) -> f64 {
        self.points.first().map_or(f64::INFINITY, |point| point[1])
    }

    /// Closed form on the segment in which the equivalent strain lies, found by bisection of the table.
    fn equivalent_stress(&self, equivalent_strain: f64) -> f64 {
        let beyond = self.points.partition_point(|point| point[0] <= equivalent_strain);
        let from = beyond.checked_sub(1).map_or([0.0, 0.0], |k| self.points[k]);
        match self.points.get(beyond) {
            Some(to) => from[1] + (equivalent_strain - from[0]) * (to[1] - from[1]) / (to[0] - from[0]),
            None => from[1],
        }
    }
}
