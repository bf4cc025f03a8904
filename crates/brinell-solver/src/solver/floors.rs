//! Floors of the error bars. `error_bars fit` of the package `brinell-tools` writes this file.

use super::method::figures::Figure;

/// Returns the floors of a figure over element size by half-width: in plane analyses, of bodies of
/// revolution, of half-spaces. `None` where the figure has no bar.
#[rustfmt::skip]
#[allow(clippy::match_same_arms, reason = "one row for each figure")]
pub const fn floors(figure: Figure) -> [Option<f64>; 3] {
    match figure {
        Figure::PeakPressure => [Some(0.03), Some(0.1), Some(0.1)],
        Figure::HalfWidth => [Some(0.3), Some(0.3), Some(0.2)],
        Figure::SemiAxisY => [None, None, Some(0.2)],
        Figure::ContactArea => [None, None, Some(0.2)],
        Figure::Approach => [Some(0.03), Some(0.03), Some(0.015)],
        Figure::Force => [Some(0.03), Some(0.03), Some(0.023)],
        Figure::MaxPlasticStrain => [Some(2.0), Some(0.5), Some(0.3)],
        Figure::MeanPlasticStrain => [Some(0.5), Some(0.1), None],
        Figure::PlasticArea => [Some(1.0), Some(0.5), None],
        Figure::PlasticDepth => [None, None, None],
        Figure::Dent => [Some(0.01), Some(0.02), Some(0.1)],
        Figure::PileUp => [Some(0.03), Some(0.03), Some(0.1)],
        Figure::LeastStress => [Some(0.25), Some(0.25), Some(0.1)],
        Figure::LargestVonMises => [Some(0.05), Some(0.05), None],
    }
}
