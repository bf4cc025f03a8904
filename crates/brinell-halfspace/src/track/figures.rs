//! What a pass leaves, and what it costs.

use super::grid::TrackGrid;

/// What a body has at the back of a pass that it did not have at the front.
#[derive(Debug, Clone, PartialEq)]
pub struct Outlet {
    /// Middle of each layer \[mm\].
    pub depths: Vec<f64>,
    /// Change of the plastic strain of each layer: xx, zz, xz; yy is `-xx - zz`.
    pub change: Vec<[f64; 3]>,
    /// Plastic strain that each layer has accumulated in this pass.
    pub accumulated: Vec<f64>,
    /// How far this pass has moved the surface in the direction of travel, against the depth:
    /// `-2 ∫Δε_xz dz` \[mm\].
    pub forward: f64,
    /// How far the surface has sunk in all passes \[mm\].
    pub groove_depth: f64,
    /// Residual stress σxx, σyy of each layer \[MPa\].
    pub residual: Vec<[f64; 2]>,
    /// `∫∫σ:dε_p` of this pass, per length of travel and of contact \[N/mm\].
    pub plastic_work: f64,
    /// Change of the elastic energy of the residual stress, per length of travel and of contact
    /// \[N/mm\].
    pub stored_energy: f64,
}

/// A figure and the depth where it is largest.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct AtDepth {
    /// The figure.
    pub value: f64,
    /// Depth \[mm\].
    pub depth: f64,
    /// Layer.
    pub layer: usize,
}

/// Plastic strain of a pass, or of a pair of passes: what a verdict judges.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PassStrain {
    /// Largest accumulated plastic strain over the section.
    pub largest: AtDepth,
    /// Largest `√(2/3 Δε:Δε)` of the change of the plastic strain.
    pub net: AtDepth,
}

impl PassStrain {
    /// The strains of one pass.
    pub fn of(pass: &Outlet) -> Self {
        Self::of_layers(&pass.depths, &pass.accumulated, pass.change.iter().copied())
    }

    /// The strains of a pass and of the next one, which went the other way. What one moves
    /// forward, the other may take back.
    pub fn of_pair(there: &Outlet, back: &Outlet) -> Self {
        let both = there.accumulated.iter().zip(&back.accumulated).map(|(a, b)| a + b);
        let changes = there.change.iter().zip(&back.change);
        // x is the direction of travel in both.
        let change = changes.map(|(a, b)| [a[0] + b[0], a[1] + b[1], a[2] - b[2]]);
        Self::of_layers(&there.depths, &both.collect::<Vec<_>>(), change)
    }

    fn of_layers(
        depths: &[f64],
        accumulated: &[f64],
        change: impl Iterator<Item = [f64; 3]>,
    ) -> Self {
        let net: Vec<f64> = change
            .map(|[xx, zz, xz]| (4.0 / 3.0 * (xx * xx + zz * zz + xx * zz + xz * xz)).sqrt())
            .collect();
        let largest = |values: &[f64]| {
            let places = values.iter().zip(depths).enumerate();
            places.fold(AtDepth::default(), |most, (layer, (value, depth))| {
                let here = AtDepth { value: *value, depth: *depth, layer };
                if here.value > most.value { here } else { most }
            })
        };
        Self { largest: largest(accumulated), net: largest(&net) }
    }
}

/// The force per length against which a roller is pushed, `F = Σ p ∂δ0/∂x h` \[N/mm\], of a
/// pressure and the gap of the undeformed bodies in the window.
///
/// Of free rolling it is the plastic work and the change of the stored energy of all bodies, per
/// length of travel.
pub fn rolling_force(grid: &TrackGrid, gap: &[f64], pressure: &[f64]) -> f64 {
    debug_assert_eq!(gap.len(), grid.window().len());
    work_along(pressure, gap)
}

/// `Σ p ∂u/∂x h` by central differences, which is what the discrete energy is made of; pressures
/// at both ends do not count.
pub(super) fn work_along(pressure: &[f64], u: &[f64]) -> f64 {
    let slopes = u.windows(3).map(|u| 0.5 * (u[2] - u[0]));
    pressure.iter().skip(1).zip(slopes).map(|(p, slope)| p * slope).sum()
}
