//! A hardening curve given by points.

use super::{HardeningLaw, is_same};

/// Piecewise linear through points of plastic strain and stress; constant beyond the last.
#[derive(Debug, Clone, PartialEq)]
pub struct PolyLine {
    /// `[ε_p, q]` \[MPa\], the first at zero plastic strain, strains rising and stresses not
    /// falling.
    pub points: Vec<[f64; 2]>,
}

impl PolyLine {
    /// The points at both ends of the segment that holds a plastic strain; one beyond the last
    /// point.
    fn segment(&self, plastic_strain: f64) -> ([f64; 2], Option<[f64; 2]>) {
        let beyond = self.points.partition_point(|point| point[0] <= plastic_strain).max(1);
        let from = self.points.get(beyond - 1).copied().unwrap_or([0.0, f64::INFINITY]);
        (from, self.points.get(beyond).copied())
    }
}

impl HardeningLaw for PolyLine {
    fn yield_stress(&self) -> f64 {
        self.points.first().map_or(f64::INFINITY, |point| point[1])
    }

    /// The stress of the last point.
    fn flow_stress(&self) -> f64 {
        self.points.last().map_or(f64::INFINITY, |point| point[1])
    }

    fn largest_stress(&self) -> f64 {
        self.points.last().map_or(f64::INFINITY, |point| point[1])
    }

    fn stress(&self, plastic_strain: f64) -> f64 {
        let (from, _) = self.segment(plastic_strain);
        from[1] + (plastic_strain - from[0]) * self.slope(plastic_strain)
    }

    fn slope(&self, plastic_strain: f64) -> f64 {
        match self.segment(plastic_strain) {
            (from, Some(to)) => (to[1] - from[1]) / (to[0] - from[0]),
            (_, None) => 0.0,
        }
    }

    fn polyline(&self) -> Option<Vec<[f64; 2]>> {
        Some(self.points.clone())
    }

    fn is_like(&self, other: &(dyn HardeningLaw + 'static)) -> bool {
        is_same(self, other)
    }
}
