//! The job as a whole.

use std::collections::BTreeMap;

use serde::Serialize;

use super::{Body, MeshSettings, OutputSettings, PositiveF64, SolverSettings, Units};

/// A complete, valid request. All figures are in N–mm–MPa whatever [`Job::units`] says; `units` is how they
/// were written and how the result is to be written.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// Kinematics.
    pub analysis: Analysis,
    /// Units of the wire figures.
    pub units: Units,
    /// Body above the contact.
    pub upper: Body,
    /// Body below the contact.
    pub lower: Body,
    /// What presses them together.
    pub load: Load,
    /// Mesh request.
    pub mesh: MeshSettings,
    /// Iteration controls.
    pub solver: SolverSettings,
    /// What to report.
    pub output: OutputSettings,
    /// Free labels, echoed and searchable.
    pub tags: BTreeMap<String, String>,
}

/// Kinematic assumption.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Analysis {
    /// ε_zz = 0: long bodies.
    PlaneStrain,
    /// σ_zz = 0: thin discs.
    PlaneStress,
    /// Bodies of revolution about the line of approach.
    Axisymmetric,
}

/// What presses the bodies together. Several values are a sweep, one step each; never empty.
#[derive(Debug, Clone, PartialEq)]
pub enum Load {
    /// Forces for the whole contact, both sides of the axis: N per mm of thickness in plane analyses, N in
    /// axisymmetry.
    Forces(Vec<PositiveF64>),
    /// Approaches α of the supports \[mm\].
    Approaches(Vec<PositiveF64>),
}
