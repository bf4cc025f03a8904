//! The report of a solution: its figures, their validity and their error bars.

mod accuracy;
mod answers;
mod contact;
mod cost;
mod datum;
mod document;
mod error_bars;
pub mod export;
mod fatigue;
mod field_arrays;
mod fields;
mod figure_names;
mod find;
mod findings;
mod flow;
mod half_spaces;
mod hardness;
mod hertz;
mod known;
mod layer_fields;
mod load_approach;
mod measured;
mod mesh_effects;
mod meshed;
mod onset;
mod plastic_strain;
mod plastic_zone;
mod rolling;
mod run;
mod run_error;
mod shown;
mod solve_error;
mod step;
mod strength;
mod subsurface;
mod surface_stress;
mod target;
mod validity;
mod verdict;

pub use crate::job::{Quantity, Side};
pub use answers::{
    Answer, AnswerAt, AnswerBody, AnswerPlace, BarKind, ErrorBar, ErrorWord, Name, table_of_names,
};
pub use contact::{ContactNodes, ContactReport, Patch};
pub use cost::JobEstimate;
pub use document::*;
pub use error_bars::estimate_error;
pub use fatigue::{FatigueCriterion, FatigueReport};
pub use field_arrays::{
    FIELD_NAMES, FieldArraysError, FieldLayout, FieldPiece, NpyFile, NumbersPiece, encode_fields,
    encode_layers,
};
pub use fields::FieldsReport;
pub use figure_names::name_of;
pub use find::{FoundReport, Looks, TolerancesReport};
pub use findings::{validity_codes, validity_tables};
pub use flow::{IncrementsReport, SurfaceReport};
pub use half_spaces::{
    MapsReport, PressureQuantiles, RollerReport, SectionReport, unknown_figures,
};
pub use known::ErrorEstimate;
pub use layer_fields::{LAYER_NAMES, LayersReport};
pub use load_approach::LoadApproach;
pub use rolling::{
    Course, PassesReport, RuleVerdict, ShakedownMap, SolvedHardening, TrackVerdict,
};
pub use run::{preflight, run, run_each, run_with};
pub use run_error::RunError;
pub use validity::ValidityNote;
pub use verdict::{Mark, Verdict, VerdictLevel};
