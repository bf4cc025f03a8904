//! The search for the force of a sought figure of a contact in three dimensions: the onset of
//! yield, or a target.

use super::error::HalfSpaceError;
use super::errors::{errors, target_error, target_figure};
use super::estimate::first_force;
use super::given::given;
use super::problem::HalfSpaceProblem;
use super::sizing::interrupted;
use super::step::{HalfSpaceField, HalfSpaceStep};
use brinell_contact::ContactLoad;
use brinell_material::Solid;
use brinell_method::Limit;
use brinell_method::force_search::{Density, Search, Trials, find};
use brinell_method::observer::Interrupt;
use brinell_method::run::Run;
use brinell_method::sought::{Sought, TargetFigure};

/// Factor by which the coarse grids of the search have fewer cells than the job asks for, and
/// their least number of cells over a semi-axis.
const COARSER: u32 = 2;
const FEWEST_CELLS: u32 = 4;
/// Growth of the stress at the onset of yield with the force.
const ONSET_SLOPE: f64 = 1.0 / 3.0;

/// Searches for the force. Returns the steps at this force, the unloading included, and the
/// relative change of the figure over the relative change of the force.
///
/// # Errors
/// [`HalfSpaceError::NoYieldPoint`], [`brinell_method::Error::Unreachable`], and the errors of a
/// solve.
pub(super) fn run(
    problem: &HalfSpaceProblem,
    sought: Sought,
    run: &mut Run<'_>,
) -> Result<(Vec<HalfSpaceStep>, f64), HalfSpaceError> {
    let mut solved = problem.clone();
    if sought == Sought::Onset {
        let elastic = |material: &Option<Solid>| material.as_ref().map(Solid::without_plasticity);
        solved.materials = problem.materials.each_ref().map(elastic);
    }
    if let (Sought::Onset, Some(force)) = (sought, problem.onset) {
        let mut steps: Vec<HalfSpaceStep> = Vec::new();
        given(&solved, &[ContactLoad::Force(force)], run, &mut steps)?;
        steps.iter().try_for_each(|step| interrupted(step.status))?;
        return Ok((steps, ONSET_SLOPE));
    }
    let first_force = first_force(problem, sought)?;
    let search = Search { sought, first_force, scatter_of_width: 0.0 };
    let found = find(search, &ForceSearch { problem, solved }, run)?;
    Ok((found.trial.steps, found.sensitivity))
}

/// The solves of a search.
struct ForceSearch<'a> {
    /// The problem as it is given.
    problem: &'a HalfSpaceProblem,
    /// The problem that the trials solve: without plasticity if the onset of yield is sought.
    solved: HalfSpaceProblem,
}

impl Trials for ForceSearch<'_> {
    type Field = HalfSpaceField;
    type Error = HalfSpaceError;

    fn solve(
        &self,
        density: Density,
        loads: &[ContactLoad],
        run: &mut Run<'_>,
        steps: &mut Vec<HalfSpaceStep>,
    ) -> Result<Option<Interrupt>, HalfSpaceError> {
        let mut problem = self.solved.clone();
        if density != Density::Asked {
            let cells = problem.cells_per_semi_axis;
            problem.cells_per_semi_axis = (cells / COARSER).max(FEWEST_CELLS).min(cells);
        }
        given(&problem, loads, run, steps)
    }

    fn too_large(error: HalfSpaceError) -> Result<Limit, HalfSpaceError> {
        match error {
            HalfSpaceError::Overloaded { .. } => Ok(Limit::Other(error.to_string())),
            error => Err(error),
        }
    }

    fn utilization(&self, step: &HalfSpaceStep) -> f64 {
        self.problem.highest_utilization(step).map_or(0.0, |highest| highest.ratio)
    }

    fn figure(&self, step: &HalfSpaceStep, target: TargetFigure) -> f64 {
        target_figure(&step.figures, target)
    }

    fn error(&self, step: &HalfSpaceStep, target: TargetFigure) -> Option<f64> {
        target_error(step, &errors(step, None)?, target)
    }
}
