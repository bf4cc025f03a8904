//! Error bars: what the mesh may have done to the headline figures.
//!
//! ```text
//! peak pressure   max(|Δ|, 0.2 (h/a)²)
//! half-width      max(|Δ|, 0.5 h/a)
//! approach        max(|Δ|, 0.25 (h/a)²)
//! ```
//!
//! with `Δ` the relative difference to a mesh of half the density, `h` the element size and `a` the half-width. For
//! errors that fall with h or faster, |Δ| is at least the error of the finer mesh. But the errors also scatter with
//! where the edge of the contact happens to fall between two nodes, so that now and then Δ is far below the error.
//! The second terms are floors for that: half an element for the half-width, second order for the rest (the rings grow
//! by `g - 1 = 1.3 h/a`, so their error is of that order too).
//!
//! The constants are measured: twelve problems (elastic, bilinear, perfectly plastic and Ramberg–Osgood cylinders,
//! plane stress, cylinder on block, elastic and plastic spheres, ball on flat) on ten meshes of 8 to 40 elements, each
//! against the same problem with 80. `tests/verification/error_bars.rs` holds a part of that set to them.

use serde::{Deserialize, Serialize};

use crate::solve::StepSolution;

/// Floor of the error of the peak pressure over (h/a)².
const PEAK_FLOOR: f64 = 0.3;
/// Floor of the error of the half-width over h/a.
const HALF_WIDTH_FLOOR: f64 = 0.5;
/// Floor of the error of the approach over (h/a)².
const APPROACH_FLOOR: f64 = 0.25;

/// Estimated bounds of the relative discretization errors. They hold in at least 95 of 100 cases and say nothing about
/// the theory: for that see `validity`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ErrorEstimate {
    /// Of the peak pressure.
    pub peak_pressure: f64,
    /// Of the half-width.
    pub half_width: f64,
    /// Of the approach.
    pub approach: f64,
}

/// The bars of a step; `None` where nothing touches or the coarser mesh is missing.
pub(super) fn estimate(step: &StepSolution) -> Option<ErrorEstimate> {
    let coarse = step.coarse?;
    let half_width = step.patch?.half_width();
    if half_width <= 0.0 {
        return None;
    }
    let size = step.spacing / half_width;
    let relative = |fine: f64, coarse: f64| if fine == 0.0 { 0.0 } else { ((fine - coarse) / fine).abs() };
    Some(ErrorEstimate {
        peak_pressure: relative(step.peak_pressure, coarse.peak_pressure).max(PEAK_FLOOR * size * size),
        half_width: relative(half_width, coarse.half_width).max(HALF_WIDTH_FLOOR * size),
        approach: relative(step.approach, coarse.approach).max(APPROACH_FLOOR * size * size),
    })
}
