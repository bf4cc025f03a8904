//! Estimated errors of the figures of a pass.
//!
//! ```text
//! error = 0.7 |x(c) - x(c/2)| + |x(Λ) - x(2Λ)| + (0.5 |x| + 0.3 |x_1|)/c
//! ```
//! with c columns over a, a track of length Λ and the figure x_1 of the first pass. The second term
//! is that of the same pass on half the columns. The last one is that of strains, forward displacement and works, which in passes that die
//! out depend on what the first passes have left. Contact figures have neither.

use crate::track::AtDepth;

use super::pass::{BodyPass, Pass};

const OF_COLUMNS: f64 = 0.7;
const FLOOR: f64 = 0.5;
const FLOOR_OF_FIRST: f64 = 0.3;
/// Floor of the half-width over the width of a column, as in three dimensions.
const SCATTER_OF_WIDTH: f64 = 0.1;
/// Relative floor of an approach. A ring leaves out what lies beyond half its length.
const FLOOR_OF_APPROACH: f64 = 5e-3;

/// Estimated absolute errors, in the units of [`Pass`].
#[derive(Debug, Clone, PartialEq)]
pub struct PassErrors {
    /// Of the largest pressure.
    pub peak_pressure: f64,
    /// Of the half-width.
    pub half_width: f64,
    /// Of the approach; 0 where there is none.
    pub approach: f64,
    /// Of the plastic work, and of rolling force and loss: what is missing in the balance of
    /// energy counts too.
    pub work: f64,
    /// Of the figures of each body.
    pub bodies: [Option<BodyPassErrors>; 2],
}

/// Estimated absolute errors of what a pass leaves in a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyPassErrors {
    /// Of the depth of the groove.
    pub groove_depth: f64,
    /// Of the pile-up beside it.
    pub pile_up: f64,
    /// Of the forward displacement.
    pub forward: f64,
    /// Of the largest accumulated plastic strain of the pass; where the first layer decides, with
    /// its difference to the surface.
    pub largest_strain: f64,
    /// Of the largest net strain of the pass, likewise.
    pub net_strain: f64,
    /// Of the smallest and of the largest residual stress, along the travel and across it.
    pub residual: f64,
}

impl PassErrors {
    /// The errors of a pass beside the same pass on half the columns, on tracks of one and of two
    /// lengths. `first` is the first pass.
    pub fn of(
        [fine, first]: [&Pass; 2],
        [coarse, long]: [&Pass; 2],
        (h, columns): (f64, usize),
    ) -> Self {
        let [floor, floor_of_first] = [FLOOR, FLOOR_OF_FIRST].map(|floor| floor / columns as f64);
        let error = |of: &dyn Fn(&Pass) -> f64| error_of([fine, coarse, long].map(of), columns);
        let of_contact = |of: &dyn Fn(&Pass) -> f64| OF_COLUMNS * (of(fine) - of(coarse)).abs();
        let of_body = |side: usize| {
            fine.bodies[side].as_ref()?;
            let figure = |of: &dyn Fn(&BodyPass) -> f64| {
                error(&|pass: &Pass| pass.bodies[side].as_ref().map_or(0.0, of))
            };
            let residual = residuals(fine, side).into_iter().enumerate();
            let residual = residual.map(|(k, _)| error(&|pass: &Pass| residuals(pass, side)[k]));
            let of_pass = |of: &dyn Fn(&BodyPass) -> f64| {
                let first = first.bodies[side].as_ref().map_or(0.0, of);
                figure(of) + floor_of_first * first.abs()
            };
            let strain = |of: &dyn Fn(&BodyPass) -> AtDepth| {
                let here = fine.bodies[side].as_ref().map_or(0.0, |body| of(body).to_surface);
                of_pass(&|body| of(body).limit()) + here
            };
            Some(BodyPassErrors {
                groove_depth: figure(&|body| body.outlet.groove_depth),
                pile_up: figure(&|body| body.outlet.pile_up),
                forward: of_pass(&|body| body.outlet.forward),
                largest_strain: strain(&|body| body.strain.largest),
                net_strain: strain(&|body| body.strain.net),
                residual: residual.fold(0.0, f64::max),
            })
        };
        Self {
            peak_pressure: of_contact(&|pass| pass.peak_pressure) + floor * fine.peak_pressure,
            half_width: of_contact(&Pass::half_width) + SCATTER_OF_WIDTH * h,
            approach: fine.approach.map_or(0.0, |approach| {
                let of = |pass: &Pass| pass.approach.unwrap_or(0.0);
                of_contact(&of) + (of(coarse) - of(long)).abs() + FLOOR_OF_APPROACH * approach
            }),
            work: error(&Pass::plastic_work)
                + floor_of_first * first.plastic_work()
                + fine.energy_gap() * fine.plastic_work(),
            bodies: [of_body(0), of_body(1)],
        }
    }
}

/// The error of a figure on all columns, from its values on half of them, on tracks of one and of
/// two lengths.
pub(super) fn error_of([fine, coarse, long]: [f64; 3], columns: usize) -> f64 {
    let floor = FLOOR / columns as f64;
    OF_COLUMNS * (fine - coarse).abs() + (coarse - long).abs() + floor * fine.abs()
}

/// Smallest and largest residual stress of a body along the travel and across it \[MPa\].
fn residuals(pass: &Pass, side: usize) -> [f64; 4] {
    let Some(body) = &pass.bodies[side] else { return [0.0; 4] };
    let layers = || body.outlet.on_axis(&body.outlet.residual);
    let least = |k: usize| layers().map(|stress| stress[k]).fold(0.0, f64::min);
    let most = |k: usize| layers().map(|stress| stress[k]).fold(0.0, f64::max);
    [least(0), most(0), least(1), most(1)]
}
