//! Floors of the error bars. `error_bars fit` of the package `brinell-tools` writes this file.

use super::figures::Figure;

/// Returns the floors of a figure over element size by half-width: in plane strain, in plane
/// stress, of bodies of revolution, of half-spaces. `None` where the figure has no bar.
#[rustfmt::skip]
#[allow(clippy::match_same_arms, reason = "one row for each figure")]
pub const fn floors(figure: Figure) -> [Option<f64>; 4] {
    match figure {
        Figure::PeakPressure => [Some(0.047), Some(0.068), Some(0.041), Some(0.018)],
        Figure::MiddlePressure => [Some(0.014), Some(0.088), Some(0.076), Some(0.019)],
        Figure::HalfWidth => [Some(0.083), Some(0.053), Some(0.083), Some(0.21)],
        Figure::SemiAxisY => [None, None, None, Some(0.033)],
        Figure::ContactArea => [None, None, None, Some(0.065)],
        Figure::ContactRatio => [None, None, None, None],
        Figure::Approach => [Some(0.0012), Some(0.21), Some(0.0043), Some(0.0029)],
        Figure::Force => [Some(0.001), Some(0.029), Some(0.011), Some(0.011)],
        Figure::MaxPlasticStrain => [Some(3.8), Some(2.7), Some(0.12), Some(0.23)],
        Figure::MeanPlasticStrain => [Some(0.088), Some(0.72), Some(0.092), None],
        Figure::PlasticArea => [Some(0.29), Some(0.99), Some(0.73), None],
        Figure::PlasticDepth => [None, None, None, None],
        Figure::Dent => [Some(0.001), Some(0.092), Some(0.0043), Some(0.001)],
        Figure::PileUp => [Some(0.31), Some(0.03), Some(0.29), Some(0.13)],
        Figure::LeastStress => [Some(0.072), Some(0.027), Some(0.29), Some(0.054)],
        Figure::LargestVonMises => [Some(0.014), Some(0.028), Some(0.001), None],
    }
}
