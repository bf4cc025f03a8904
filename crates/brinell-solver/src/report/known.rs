//! Figures of a load step of which its rows and its verdict are made, in N–mm–MPa. The engine of
//! the step fills them; the document has rows alone.

use std::sync::Arc;

use super::fatigue::BodyFatigue;
use super::rolling::Rolled;
use crate::contact::ContactLoad;
use crate::solver::method::figures::{Figures, Values};
use crate::solver::{Energy, SolveStatus};

/// Estimated bounds of the relative discretization errors. They hold in at least 95 of 100 cases
/// and say nothing about the theory: for that see `validity`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ErrorEstimate {
    /// Of each figure \[1 >= 0\].
    pub figures: Values,
    /// Of the contact stiffness, where there is one \[1 >= 0\].
    pub contact_stiffness: Option<f64>,
}

/// What is known of a step.
#[derive(Debug, Clone)]
pub(super) struct Known {
    pub load: ContactLoad,
    pub status: SolveStatus,
    pub figures: Figures,
    /// x of the largest pressure, and y in three dimensions.
    pub peak_place: [f64; 2],
    pub mean_pressure: f64,
    /// Angle over which a pin touches its hole \[degrees\].
    pub half_angle: Option<f64>,
    /// Number of connected parts of the contact.
    pub parts: usize,
    /// dP/dα, where it is known.
    pub stiffness: Option<f64>,
    pub flow: Option<FlowFigures>,
    pub zones: [Option<Zone>; 2],
    pub hertz: Option<Hertz>,
    pub onset: Option<Onset>,
    pub bars: Option<ErrorEstimate>,
    pub whole: Option<Whole>,
    pub rolled: Option<Rolled>,
    /// Of bodies with limits; that of a static load is filled in with its arrays.
    pub fatigue: Vec<BodyFatigue>,
    /// Whether both bodies have the same figures.
    pub is_alike: bool,
    /// Whether the strength of a body varies over its depth.
    pub is_graded: bool,
}

/// Returns whether both bodies are one solution.
pub(super) fn is_shared<B>(bodies: &[Option<Arc<B>>; 2]) -> bool {
    matches!(bodies, [Some(upper), Some(lower)] if Arc::ptr_eq(upper, lower))
}

/// Hertz's contact under the same force.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hertz {
    /// Half-width, in three dimensions the semi-axis along x.
    pub half_width: f64,
    /// Semi-axis along y.
    pub longer: Option<f64>,
    pub peak_pressure: f64,
    /// Approach of points far from the contact, of an ellipse.
    pub approach: Option<f64>,
    /// Force and depth of first yield.
    pub first_yield: Option<[f64; 2]>,
    /// Peak pressure up to which the contact shakes down in free rolling, and the depth that
    /// decides.
    pub shakedown: Option<[f64; 2]>,
}

/// The onset of yield that was sought.
#[derive(Debug, Clone, Copy)]
pub(super) struct Onset {
    pub force: f64,
    /// Peak pressure in closed form, of an edge that elements leave out.
    pub closed_peak: Option<f64>,
    /// 0 for the upper body, 1 for the lower body.
    pub side: usize,
    pub position: f64,
    pub depth: f64,
}

/// The plastic zone of a body.
#[derive(Debug, Clone, Copy)]
pub(super) struct Zone {
    pub yielded: bool,
    /// Largest plastic strain; `None` where it has no limit on finer meshes.
    pub largest: Option<f64>,
    /// Mean over the area that has yielded.
    pub mean: f64,
    /// `[x, y, depth]` of the largest.
    pub place: [f64; 3],
    pub area: f64,
    /// Volume of the cells, in three dimensions.
    pub volume: Option<f64>,
    /// Depth at which the zone begins.
    pub cover: Option<f64>,
}

/// What flow theory knows.
#[derive(Debug, Clone)]
pub(super) struct FlowFigures {
    pub unloading_stiffness: f64,
    pub energy: Energy,
    pub surfaces: [Option<SurfaceFigures>; 2],
}

/// The surface of a body near the contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct SurfaceFigures {
    /// Depth of the deepest point below the undeformed surface.
    pub depth: f64,
    /// Height of the highest point above it, and its `[x, y]`; of two alike that at positive x.
    pub pile_up: f64,
    pub pile_up_at: [f64; 2],
    /// Largest plastic strain since the load last began to fall, and the area of the section that
    /// has any; `None` without.
    pub reverse: Option<[f64; 2]>,
}

/// What a contact in three dimensions has.
#[derive(Debug, Clone)]
pub(super) struct Whole {
    /// Angle from the x of the job to that of the figures \[degrees\].
    pub orientation: f64,
    /// Shorter and longer semi-axis.
    pub semi_axes: [f64; 2],
    pub area: f64,
    pub largest_cell_pressure: f64,
    pub roller: Option<RollerFigures>,
    pub rough: Option<Rough>,
}

/// The contact of a roller.
#[derive(Debug, Clone, Copy)]
pub(super) struct RollerFigures {
    /// Largest pressure in the outermost rows at negative and at positive y, and their y.
    pub end_pressure: [f64; 2],
    pub ends: [f64; 2],
    /// Largest pressure beside the middle.
    pub middle_pressure: f64,
    /// Moment of the pressure about the middle.
    pub moment: f64,
    /// Tilt of one body against the other \[mrad\].
    pub tilt: f64,
}

/// The contact of heights.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rough {
    pub contact_ratio: f64,
    pub nominal_pressure: f64,
    /// Part of the contact below which a body has yielded.
    pub yielded_part: Option<f64>,
}
