//! Data of findings.

use brinell_halfspace::track::TrackFault;
use strum::{IntoStaticStr, VariantArray};

use crate::solver::method::figures::{Figure, FigureSet};

/// Number of meshes above which a search for a force is called long.
pub(in crate::report) const MANY_MESHES: usize = 40;

/// Why a load step has not converged.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::report) enum Unconverged {
    /// No force gives the figure that is sought; its ratio to the wanted value.
    Missed { ratio: f64 },
    /// The state violates the contact conditions by a part of their scale.
    Contact { violation: f64, is_slow: bool },
    /// No answer with small strains.
    Collapse,
    /// The contact is wider than the mesh.
    AtEdge,
    /// An earlier increment has not converged.
    Inherited { is_slow: bool },
    /// Forces are off balance over the whole bodies.
    Unbalanced { residual: f64 },
    /// The iteration has ended without an answer.
    Iteration { iterations: usize, residual: f64, advice: Advice },
    /// No tilt of the roller has its moment.
    Moment { missing: f64 },
    /// A check of a pass of a load that rolls fails.
    Pass(TrackFault),
}

/// Why an accuracy is not met: the number of elements that do not do, that have no answer, or before
/// whose answer the job was stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::report) enum Missed {
    Elements(u32),
    NoAnswer(u32),
    Stopped(u32),
}

/// A remedy for an iteration without an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::report) enum Advice {
    LargerLoad,
    AcceleratedCoupling,
    MoreIterations,
    SmallerLoad,
}

/// Work that a load took.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::report) enum Work {
    /// A slow coupling.
    Coupling { updates: usize, iterations: usize },
    /// Many evaluations of the plastic law.
    Load {
        updates: usize,
        iterations: usize,
        /// Number of increments, where they are the cause.
        increments: Option<usize>,
        /// Number of factorizations, where they are the cause.
        factorizations: Option<usize>,
    },
    /// A search over many meshes, in three dimensions grids.
    Search { meshes: usize, of_cells: bool, of_histories: bool, force: f64 },
    /// A mesh that details of the surfaces make much finer than requested.
    FineMesh { elements: f64, asked: f64, equations: usize },
}

/// Contacts that are too wide for the theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::report) enum Wide {
    /// Angle between the normals of pin and hole at the ends of the contact \[rad\].
    InHole { angle: f64 },
    /// Half-width over the smallest radius.
    OverRadius { ratio: f64, in_groove: bool },
    /// Slope of a surface within the contact.
    Slope { slope: f64 },
    /// Semi-axis over a radius of curvature, in three dimensions.
    OverCurvature { ratio: f64, radius: f64 },
    /// Inclination of the common normal at the end of a contact of half-spaces that conform \[rad\].
    Inclined { angle: f64 },
    /// Tilt of a roller under its moment, and the largest tilt that may be given \[mrad\].
    Tilt { tilt: f64, most: f64 },
}

/// A remedy for a coarse mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::report) enum FinerBy {
    Elements,
    Cells,
    Heights,
}

/// A contact that yields by deformation theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::report) enum Deformation {
    /// A line, and the elastic peak pressure over the least yield stress.
    Line(f64),
    /// A ball or an ellipse, and the elastic peak pressure over the least yield stress.
    Ball(f64),
    /// A cone or a wedge.
    Tip,
    /// A contact without published figures.
    Other,
}

/// Why the force at the onset of yield is not known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::report) enum OnsetUnknown {
    /// Elements leave out a rounded edge, where closed forms yield under `force`.
    AtEdge { width: f64, spacing: f64, force: f64 },
    /// The peak pressure is next to an end of the contact.
    NextToEnd { x: f64, spacing: f64 },
    /// A sharp corner carries pressure.
    AtCorner { x: f64 },
    /// The contact runs to an end of a roller.
    AtRollerEnd,
}

/// A place where strength changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::report) enum CasePlace {
    /// An element, by its middle.
    Element([f64; 2]),
    /// A layer of cells, by the depth of its middle.
    Layer(f64),
}

/// Error bars that a finding takes away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::report) enum Voids {
    /// The bars of a set of figures.
    Figures(FigureSet),
    /// The error estimate as a whole: the figures are no answer, or nothing bounds their errors.
    Estimate,
}

/// Error bars that a kind of finding takes away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Takes {
    Nothing,
    Figures(&'static [Figure]),
    AllButMiddlePressure,
    Estimate,
}

/// Figures below the surface and along it, which depend on the peak pressure.
pub(super) const BELOW: [Figure; 5] = [
    Figure::MaxPlasticStrain,
    Figure::MeanPlasticStrain,
    Figure::PlasticArea,
    Figure::LeastStress,
    Figure::LargestVonMises,
];
pub(super) const PEAK_AND_BELOW: [Figure; 6] = [
    Figure::PeakPressure,
    Figure::MaxPlasticStrain,
    Figure::MeanPlasticStrain,
    Figure::PlasticArea,
    Figure::LeastStress,
    Figure::LargestVonMises,
];

/// A part of the document on validity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "snake_case")]
pub(super) enum Section {
    State,
    Theory,
    Mesh,
    Hardness,
}

/// A row of `docs/validity.md`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    pub(super) code: &'static str,
    pub(super) section: Section,
    pub(super) condition: &'static str,
    pub(super) meaning: &'static str,
    pub(super) takes: Takes,
}
