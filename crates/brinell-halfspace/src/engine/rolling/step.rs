//! The passes of a load that rolls, as one step of the method.

use std::f64::consts::PI;

use crate::Fatigue;
use crate::track::SteadyState;

use super::errors::PassErrors;
use super::pass::Pass;
use super::problem::Limit;
use brinell_contact::ContactLoad;
use brinell_method::figures::{BodyFigures, Figures};
use brinell_method::observer::IterationRecord;
use brinell_method::steps::{Checks, Path, Search, Step};

/// The answer to a load that rolls. Its figures are those of the last pass, the strains of its
/// bodies those of all passes; its history has the iterations of the last pass.
pub type TrackStep = Step<TrackField>;

/// The passes of a load and what becomes of the track.
#[derive(Debug, Clone)]
pub struct TrackField {
    /// The passes that have converged.
    pub passes: Vec<Pass>,
    /// The last pass, converged or not.
    pub last: Pass,
    /// Estimated errors of the passes; `None` where the coarse track has no such pass.
    pub errors: Vec<Option<PassErrors>>,
    /// Verdict on each body; `None` for one that cannot yield.
    pub verdicts: [Option<SteadyState>; 2],
    /// Verdict by as many passes on half the columns.
    pub coarse_verdicts: [Option<SteadyState>; 2],
    /// Fatigue of each body after the last pass; `None` of a body without limits, or not known to
    /// have shaken down.
    pub fatigue: [Option<Fatigue>; 2],
    /// The same load on bodies that harden kinematically, where both rules are asked for and
    /// differ.
    pub kinematic: Option<KinematicPasses>,
    /// Limit of shakedown of perfectly plastic bodies, and of bodies with kinematic hardening
    /// without bound on these layers.
    pub limits: [Option<Limit>; 2],
    /// Middle of the columns of the window, in the direction of travel \[mm\].
    pub x: Vec<f64>,
    /// Their width \[mm\].
    pub column: f64,
    /// Area of a cell \[mm²\]; of a line the width of a column.
    pub cell: f64,
    /// Columns of the track, layers of each body, rows of cells in a layer.
    pub grid: [usize; 3],
    /// Pressure of the last pass, on the axis of the track \[MPa\].
    pub pressure: Vec<f64>,
    /// Gap of the last pass \[mm\].
    pub gap: Vec<f64>,
}

/// Passes over bodies with kinematic hardening of the same uniaxial curves.
#[derive(Debug, Clone)]
pub struct KinematicPasses {
    /// The passes that have converged.
    pub passes: Vec<Pass>,
    /// The last pass, converged or not.
    pub last: Pass,
    /// Estimated errors of the last converged pass, without that of the length of the track.
    pub errors: Option<PassErrors>,
    /// Verdict on each body; `None` for one that cannot yield.
    pub verdicts: [Option<SteadyState>; 2],
    /// Fatigue of each body after the last pass, as of [`TrackField`].
    pub fatigue: [Option<Fatigue>; 2],
}

impl TrackField {
    /// Returns the largest plastic strain that so many passes have accumulated in a body.
    pub fn accumulated(&self, side: usize, passes: usize) -> f64 {
        let passes = || self.passes[..passes].iter().filter_map(|p| p.bodies[side].as_ref());
        let rows = 0..passes().next().map_or(0, |body| body.outlet.accumulated.len());
        let of_row = |row: usize| passes().map(|body| body.outlet.accumulated[row]).sum();
        rows.map(of_row).fold(0.0, f64::max)
    }

    /// Returns the step of a force, of which these are the passes.
    pub(super) fn step(
        self,
        force: f64,
        history: Vec<IterationRecord>,
        enlargements: usize,
    ) -> TrackStep {
        Step {
            status: self.last.status,
            load: ContactLoad::Force(force),
            figures: self.figures(force),
            coarse: None,
            increment_error: None,
            checks: Checks { residual: self.last.residual, ..Checks::default() },
            history,
            path: Path::default(),
            search: Search::default(),
            contact_stiffness: None,
            enlargements,
            is_preliminary: false,
            field: self,
        }
    }

    fn figures(&self, force: f64) -> Figures {
        let last = &self.last;
        let across = last.half_width_across;
        Figures {
            peak_pressure: last.peak_pressure,
            middle_pressure: self.middle_pressure(),
            half_width: last.half_width(),
            semi_axis_y: across,
            contact_area: across.map(|across| PI * across * last.half_width()),
            contact_ratio: None,
            approach: last.approach.unwrap_or(0.0),
            // The pressure of a line is that of its columns; the axis of an ellipse is a part.
            force: match across {
                Some(_) => force,
                None => self.pressure.iter().map(|p| p * self.column).sum(),
            },
            bodies: [self.body_figures(0), self.body_figures(1)],
        }
    }

    fn body_figures(&self, side: usize) -> Option<BodyFigures> {
        let outlet = &self.passes.last()?.bodies[side].as_ref()?.outlet;
        Some(BodyFigures {
            max_plastic_strain: self.accumulated(side, self.passes.len()),
            mean_plastic_strain: None,
            plastic_area: None,
            plastic_depth: self.plastic_depth(side),
            dent: outlet.groove_depth,
            pile_up: outlet.pile_up,
            least_stress: None,
            largest_von_mises: None,
        })
    }

    /// Returns the pressure of the column nearest to the middle of the contact.
    fn middle_pressure(&self) -> Option<f64> {
        let [left, right] = self.last.ends;
        let from_middle = |x: f64| (x - 0.5 * (left + right)).abs();
        let columns = self.x.iter().zip(&self.pressure);
        let nearest = columns.min_by(|a, b| from_middle(*a.0).total_cmp(&from_middle(*b.0)));
        nearest.map(|(_, pressure)| *pressure)
    }

    /// Returns the depth of the lowest layer that has yielded in a pass \[mm\].
    fn plastic_depth(&self, side: usize) -> Option<f64> {
        let outlets =
            self.passes.iter().filter_map(|pass| Some(&pass.bodies[side].as_ref()?.outlet));
        let rows = outlets.flat_map(|outlet| {
            let of_row = move |row: usize| outlet.depths[row / outlet.across.len().max(1)];
            let yielded =
                outlet.accumulated.iter().enumerate().filter(|(_, strain)| **strain > 0.0);
            yielded.map(move |(row, _)| of_row(row))
        });
        rows.reduce(f64::max)
    }
}
