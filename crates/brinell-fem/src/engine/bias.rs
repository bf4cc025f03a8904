//! The difference of two theories of plasticity.

use brinell_method::figures::{Figure, Figures};

/// Uncertainty over the bias: of most figures, and of the force under an approach and the largest
/// plastic strain, which coarse meshes know least.
const UNCERTAINTY: f64 = 0.5;
const UNCERTAINTY_OF_MESH: f64 = 1.0;

/// The difference of both theories, over the figures of deformation theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TheoryBias {
    /// Figures of deformation theory less those of flow theory.
    pub bias: Figures,
    /// Bound of the error of the bias.
    pub error: Figures,
}

impl TheoryBias {
    pub(super) fn of(deformation: &Figures, flow: &Figures) -> Self {
        let bias = deformation.zip(flow, |d, f| if d == 0.0 { 0.0 } else { (d - f) / d.abs() });
        let part = |figure: Figure| match figure {
            Figure::Force | Figure::MaxPlasticStrain => UNCERTAINTY_OF_MESH,
            _ => UNCERTAINTY,
        };
        let error = Figures::by(|figure, side| part(figure) * bias.get(figure, side).abs());
        Self { bias, error }
    }
}
