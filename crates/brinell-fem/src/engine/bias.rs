//! The difference of two theories of plasticity.

use brinell_method::figures::Figures;

/// The difference of both theories, over the figures of deformation theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TheoryBias {
    /// Figures of deformation theory less those of flow theory.
    pub bias: Figures,
    /// Bound of the error of the bias: as large as the bias.
    pub error: Figures,
}

impl TheoryBias {
    pub(super) fn of(deformation: &Figures, flow: &Figures) -> Self {
        let bias = deformation.zip(flow, |d, f| if d == 0.0 { 0.0 } else { (d - f) / d.abs() });
        let error = bias.zip(&bias, |bias, _| bias.abs());
        Self { bias, error }
    }
}
