//! Two bodies seen as one: effective modulus and effective radius.

/// Young's modulus and Poisson's ratio of one body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticConstants {
    /// `E = young_modulus [MPa]`
    pub young_modulus: f64,
    /// `ν = poisson_ratio`
    pub poisson_ratio: f64,
}

impl ElasticConstants {
    /// Shear modulus `G = E / (2 (1 + ν))` \[MPa\].
    pub fn shear_modulus(&self) -> f64 {
        self.young_modulus / (2.0 * (1.0 + self.poisson_ratio))
    }

    /// Bulk modulus `K = E / (3 (1 - 2ν))` \[MPa\].
    pub fn bulk_modulus(&self) -> f64 {
        self.young_modulus / (3.0 * (1.0 - 2.0 * self.poisson_ratio))
    }

    /// Plane-strain modulus `E / (1 - ν²)` \[MPa\].
    pub fn plane_strain_modulus(&self) -> f64 {
        self.young_modulus / (1.0 - self.poisson_ratio.powi(2))
    }
}

/// Effective modulus `E* [MPa]` in plane strain and axisymmetry; `None` is a rigid body.
///
/// `1/E* = Σ (1 - ν²)/E`. Infinite if both are rigid.
///
/// # Reference
/// K. L. Johnson, *Contact Mechanics* (1985), section 4.2.
pub fn effective_modulus(bodies: [Option<ElasticConstants>; 2]) -> f64 {
    compliance(bodies, |body| (1.0 - body.poisson_ratio * body.poisson_ratio) / body.young_modulus)
}

/// Effective modulus `E* [MPa]` of thin discs in plane stress; `None` is a rigid body.
///
/// `1/E* = Σ 1/E`. Infinite if both are rigid.
pub fn effective_modulus_plane_stress(bodies: [Option<ElasticConstants>; 2]) -> f64 {
    compliance(bodies, |body| 1.0 / body.young_modulus)
}

fn compliance(bodies: [Option<ElasticConstants>; 2], of: impl Fn(ElasticConstants) -> f64) -> f64 {
    let total: f64 = bodies.into_iter().flatten().map(of).sum();
    1.0 / total
}

/// Effective radius `R [mm]` from the two curvatures `κ [1/mm]`.
///
/// `1/R = κ_1 + κ_2`; a convex surface has `κ > 0`, a block `κ = 0`, a groove `κ < 0`. Infinite
/// for surfaces that conform, negative for a groove tighter than what lies in it: Hertz's theory
/// covers neither.
pub fn effective_radius(curvatures: [f64; 2]) -> f64 {
    let [first, second] = curvatures;
    1.0 / (first + second)
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEEL: ElasticConstants =
        ElasticConstants { young_modulus: 210_000.0, poisson_ratio: 0.3 };

    #[test]
    fn two_equal_bodies_and_one_on_a_rigid_plane() {
        assert!((effective_modulus([Some(STEEL); 2]) - 210_000.0 / 1.82).abs() < 1e-9);
        assert!((effective_modulus([Some(STEEL), None]) - 210_000.0 / 0.91).abs() < 1e-9);
        assert!((effective_modulus_plane_stress([None, Some(STEEL)]) - 210_000.0).abs() < 1e-9);
        assert!(effective_modulus([None, None]).is_infinite());
    }

    #[test]
    fn convex_flat_and_concave() {
        assert!((effective_radius([1.0 / 20.0, 1.0 / 20.0]) - 10.0).abs() < 1e-14);
        assert!((effective_radius([1.0 / 20.0, 0.0]) - 20.0).abs() < 1e-14);
        assert!((effective_radius([1.0 / 20.0, -1.0 / 25.0]) - 100.0).abs() < 1e-10);
        assert!(effective_radius([0.05, -0.05]).is_infinite());
    }
}
