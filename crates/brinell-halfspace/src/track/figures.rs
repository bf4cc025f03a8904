//! Residual state of a body after a pass, and the force that the pass takes.

/// State of a body at the back of a pass, and its changes from the front to the back.
///
/// Fields have values in the rows of all layers, those of the first layer first. A line has one row
/// in each layer; a track of finite width those at y > 0, from its axis outwards.
#[derive(Debug, Clone, PartialEq)]
pub struct Outlet {
    /// Middle of each layer \[mm\].
    pub depths: Vec<f64>,
    /// Faces of the layers, from the surface down \[mm\].
    pub faces: Vec<f64>,
    /// y of the rows of a layer \[mm\]; 0 of a line.
    pub across: Vec<f64>,
    /// Change of the plastic strain: xx, yy, xy, xz, yz; zz is `-xx - yy`.
    pub change: Vec<[f64; 5]>,
    /// Plastic strain that all passes have left: xx, yy, xy, xz, yz.
    pub strain: Vec<[f64; 5]>,
    /// Plastic strain that has been accumulated in this pass.
    pub accumulated: Vec<f64>,
    /// Displacement of the surface in the direction of travel by this pass, against the depth, on
    /// the axis: `-2 ∫Δε_xz dz` of a line \[mm\].
    pub forward: f64,
    /// Depth of the groove after all passes, on the axis \[mm\].
    pub groove_depth: f64,
    /// Pile-up beside the groove \[mm\]; 0 of a line.
    pub pile_up: f64,
    /// Residual stress `xx yy zz xy xz yz` \[MPa\]; σxx and σyy of a line.
    pub residual: Vec<[f64; 6]>,
    /// `∫∫σ:dε_p` of this pass, per length of travel \[N\]; of a line per length of contact too
    /// \[N/mm\].
    pub plastic_work: f64,
    /// Change of the elastic energy of the residual stress, per length as the plastic work.
    pub stored_energy: f64,
    /// By how much the residual stress lies beyond its yield surface, of the worst row, over the
    /// largest yield stress: 0 or less, but for the residual of the iteration.
    pub excess: f64,
}

impl Outlet {
    /// Largest equivalent of the plastic strain that all passes have left.
    pub fn strain_of_all(&self) -> f64 {
        self.strain.iter().copied().map(equivalent).fold(0.0, f64::max)
    }

    /// Values on the axis of a field, layer by layer.
    pub fn on_axis<'a, T>(
        &self,
        field: &'a [T],
    ) -> impl Iterator<Item = &'a T> + Clone + use<'a, T> {
        field.iter().step_by(self.across.len().max(1))
    }
}

/// Equivalent strain of a deviator: xx, yy, xy, xz, yz.
fn equivalent([xx, yy, xy, xz, yz]: [f64; 5]) -> f64 {
    let normal = xx * xx + yy * yy + xx * yy;
    (4.0 / 3.0 * (normal + xy * xy + xz * xz + yz * yz)).sqrt()
}

/// A figure and the place where it is largest.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct AtDepth {
    /// The figure.
    pub value: f64,
    /// Depth \[mm\].
    pub depth: f64,
    /// Distance from the axis \[mm\]; 0 of a line.
    pub across: f64,
    /// Layer.
    pub layer: usize,
    /// By how much the figure is larger at the surface, where the first layer decides; 0 elsewhere.
    ///
    /// Under friction a strain falls from the surface like the elastic stress there, whose slope
    /// along the surface is infinite at the ends of the contact: like √z. The middle of the first
    /// layer is a depth of the grid. `x(0) = x_1 + (x_1 - x_2) √z_1/(√z_2 - √z_1)`.
    pub to_surface: f64,
}

impl AtDepth {
    /// The figure at the surface where the first layer decides, and the figure elsewhere.
    pub fn limit(&self) -> f64 {
        self.value + self.to_surface
    }
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
        Self::of_rows(pass, &pass.accumulated, pass.change.iter().copied())
    }

    /// The strains of a pass and of the next one, which went the other way. The second pass may
    /// take back the forward displacement of the first.
    pub fn of_pair(there: &Outlet, back: &Outlet) -> Self {
        let both = there.accumulated.iter().zip(&back.accumulated).map(|(a, b)| a + b);
        // x is the direction of travel in both.
        let signs = [1.0, 1.0, -1.0, -1.0, 1.0];
        let changes = there.change.iter().zip(&back.change);
        let change = changes.map(|(a, b)| std::array::from_fn(|k| a[k] + signs[k] * b[k]));
        Self::of_rows(there, &both.collect::<Vec<_>>(), change)
    }

    fn of_rows(
        pass: &Outlet,
        accumulated: &[f64],
        change: impl Iterator<Item = [f64; 5]>,
    ) -> Self {
        let net: Vec<f64> = change.map(equivalent).collect();
        let rows = pass.across.len().max(1);
        let largest = |values: &[f64]| {
            let most = values.iter().enumerate().fold(AtDepth::default(), |most, (row, value)| {
                if *value <= most.value {
                    return most;
                }
                let layer = row / rows;
                let across = pass.across.get(row % rows).copied().unwrap_or(0.0);
                let depth = pass.depths[layer];
                AtDepth { value: *value, depth, across, layer, to_surface: 0.0 }
            });
            let row = pass.across.iter().position(|y| *y >= most.across).unwrap_or(0);
            let (Some(below), [first, second, ..], 0) =
                (values.get(rows + row), &*pass.depths, most.layer)
            else {
                return most;
            };
            let [first, second] = [first.sqrt(), second.sqrt()];
            let to_surface = (most.value - below).max(0.0) * first / (second - first);
            AtDepth { to_surface, ..most }
        };
        Self { largest: largest(accumulated), net: largest(&net) }
    }
}

/// `Σ p ∂u/∂x h` by central differences, which is what the discrete energy is made of; pressures
/// at both ends do not count.
pub(super) fn work_along(pressure: &[f64], u: &[f64]) -> f64 {
    let slopes = u.windows(3).map(|u| 0.5 * (u[2] - u[0]));
    pressure.iter().skip(1).zip(slopes).map(|(p, slope)| p * slope).sum()
}
