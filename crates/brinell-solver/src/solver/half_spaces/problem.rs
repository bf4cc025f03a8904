//! What a job of three dimensions asks.

use brinell_halfspace::EllipticContact;

use crate::contact::ContactLoad;
use crate::job::{Deformable, Load, SolverSettings};

/// Curvatures closer than this part of their sum are those of a circle, whose axes have no direction.
const CIRCLE: f64 = 1e-12;

/// Two bodies, the curvature of the gap between them, and what presses them together.
#[derive(Debug, Clone)]
pub struct HalfSpaceProblem {
    /// Upper and lower body; `None` for a rigid one. One of them deforms.
    ///
    /// A `sigma_x` of an initial stress acts along the job's x, a `sigma_z` along its y.
    pub materials: [Option<Deformable>; 2],
    /// `[k_xx, k_yy, k_xy]` of the gap `(k_xx x² + k_yy y²)/2 + k_xy x y`, the sum over both surfaces \[1/mm\]; positive
    /// definite.
    pub curvature: [f64; 3],
    /// Loads \[N, mm\].
    pub load: Load,
    /// Cells over each semi-axis of the contact.
    pub cells_per_semi_axis: u32,
    /// Theory, coupling, tolerance, increments, iteration limit.
    pub solver: SolverSettings,
}

impl HalfSpaceProblem {
    /// Largest and smallest curvature of the gap \[1/mm\], along x and y of the fields.
    pub fn principal_curvatures(&self) -> [f64; 2] {
        let [xx, yy, xy] = self.curvature;
        let (mean, radius) = (0.5 * (xx + yy), f64::hypot(0.5 * (xx - yy), xy));
        // The product of both is the determinant; the difference would cancel.
        [mean + radius, (xx * yy - xy * xy) / (mean + radius)]
    }

    /// Angle from the job's x to the x of the fields, towards the job's y \[rad\], in `(-π/2, π/2]`; 0 of a circle.
    pub fn orientation(&self) -> f64 {
        let [xx, yy, xy] = self.curvature;
        if f64::hypot(0.5 * (xx - yy), xy) <= CIRCLE * (xx + yy) {
            return 0.0;
        }
        0.5 * (2.0 * xy).atan2(xx - yy)
    }

    /// `1/E* = Σ (1 - ν²)/E` over the bodies that deform, as E\* \[MPa\].
    pub fn effective_modulus(&self) -> f64 {
        1.0 / self.materials.iter().flatten().map(plane_compliance).sum::<f64>()
    }

    /// Whether a body has a hardening curve.
    pub(super) fn can_yield(&self) -> bool {
        self.materials.iter().flatten().any(|material| material.plasticity().is_some())
    }

    /// Lowest nominal yield stress of all depths \[MPa\].
    pub(super) fn weakest(&self) -> Option<f64> {
        let weakest = |material: &Deformable| {
            let factor = material.strength().map_or(1.0, |strength| strength.range().0);
            material.hardening_law().map(|law| factor * law.nominal_yield_stress())
        };
        self.materials.iter().flatten().filter_map(weakest).reduce(f64::min)
    }

    /// Cells over each semi-axis.
    pub(super) fn cells(&self) -> f64 {
        f64::from(self.cells_per_semi_axis)
    }

    /// The contact of elastic bodies under a force above zero \[N\].
    pub fn hertz(&self, force: f64) -> EllipticContact {
        let [kx, ky] = self.principal_curvatures();
        EllipticContact::new(kx.recip(), ky.recip(), self.effective_modulus(), force)
    }

    /// The contact of elastic bodies under a load; `None` where they do not touch.
    pub fn elastic_contact(&self, load: ContactLoad) -> Option<EllipticContact> {
        let force = match load {
            ContactLoad::Force(force) => force,
            // α grows with the power 2/3 of the force.
            ContactLoad::Approach(approach) => (approach / self.hertz(1.0).approach).max(0.0).powf(1.5),
        };
        (force > 0.0).then(|| self.hertz(force))
    }
}

/// `(1 - ν²)/E` \[1/MPa\].
pub(super) fn plane_compliance(material: &Deformable) -> f64 {
    let (young, poisson) = (material.elastic().young_modulus.get(), material.elastic().poisson_ratio.get());
    (1.0 - poisson * poisson) / young
}
