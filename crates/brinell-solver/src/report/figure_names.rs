//! Names of figures in sentences and in `docs/validity.md`.

use crate::solver::method::figures::Figure;

/// Returns the name in `docs/validity.md` of a figure that has a bar.
pub const fn name_of(figure: Figure) -> Option<&'static str> {
    Some(match figure {
        Figure::PeakPressure => "peak pressure",
        Figure::MiddlePressure => "middle pressure",
        Figure::HalfWidth => "half-width",
        Figure::SemiAxisY => "semi-axis along y",
        Figure::ContactArea => "contact area",
        Figure::Approach => "approach",
        Figure::Force => "force",
        Figure::MaxPlasticStrain => "largest plastic strain",
        Figure::MeanPlasticStrain => "mean plastic strain",
        Figure::PlasticArea => "plastic area",
        Figure::Dent => "dent",
        Figure::PileUp => "pile-up",
        Figure::LeastStress => "residual stress",
        Figure::LargestVonMises => "utilization",
        Figure::ContactRatio | Figure::PlasticDepth => return None,
    })
}
