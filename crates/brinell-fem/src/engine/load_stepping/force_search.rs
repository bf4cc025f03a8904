//! The force under which a figure of a meshed contact has a value: the onset of yield, or a
//! target. Meshes on which the force is looked for have a third of the density.

use super::load_sequence::LoadSequence;
use super::utilization::highest_utilization;
use crate::engine::bars::Bars;
use crate::engine::error::MeshedError;
use crate::engine::mesh_sizing::first_force::{first_force, weakest};
use crate::engine::problem::Problem;
use crate::engine::solution::{SectionField, StepSolution, target_figure};
use brinell_contact::ContactLoad;
use brinell_method::Limit;
use brinell_method::force_search::{Density, Search, Trials, find};
use brinell_method::observer::Interrupt;
use brinell_method::run::Run;
use brinell_method::sought::{Sought, TargetFigure};

/// Factor by which the meshes on which the force is looked for are coarser than asked. Factor where
/// the figure follows the width of the contact, which a mesh knows to half an element. Fewest
/// elements of these meshes.
const COARSER: u32 = 3;
const COARSER_FOR_WIDTH: u32 = 2;
const FEWEST_ELEMENTS: u32 = 6;
/// Fewest elements of a mesh by which the error of the onset of yield is told.
const FEWEST_BESIDE: u32 = 4;

/// Solves for the force. Returns the steps of the last solve, of the force itself and, for a
/// figure that is permanent, of the contact after it is taken away; and the relative change of the
/// figure over that of the force.
///
/// # Errors
/// [`MeshedError::NoYieldPoint`], [`brinell_method::Error::Unreachable`], and those of a solve.
pub(super) fn run(
    sought: Sought,
    sequence: &LoadSequence<'_>,
    run: &mut Run<'_>,
) -> Result<(Vec<StepSolution>, f64), MeshedError> {
    let problem = sequence.problem;
    let elastic = problem.without_plasticity();
    let sequence = match sought {
        Sought::Onset if weakest(problem).is_none() => return Err(MeshedError::NoYieldPoint),
        Sought::Onset => LoadSequence { problem: &elastic, with_memory: None, ..*sequence },
        Sought::Target(_) => *sequence,
    };
    let trials = ForceSearch { sought, problem, sequence };
    let scatter_of_width = f64::from(sequence.asked.elements).recip();
    let search = Search { sought, first_force: first_force(sought, problem)?, scatter_of_width };
    let mut found = find(search, &trials, run)?;
    if sought == Sought::Onset {
        trials.tell_error_of_onset(&mut found, run)?;
    }
    Ok((found.trial.steps, found.sensitivity))
}

/// The solves of a search.
pub(super) struct ForceSearch<'a> {
    pub sought: Sought,
    /// The bodies with the plasticity that they are given.
    pub problem: &'a Problem,
    pub sequence: LoadSequence<'a>,
}

impl Trials for ForceSearch<'_> {
    type Field = SectionField;
    type Error = MeshedError;

    fn solve(
        &self,
        density: Density,
        loads: &[ContactLoad],
        run: &mut Run<'_>,
        steps: &mut Vec<StepSolution>,
    ) -> Result<Option<Interrupt>, MeshedError> {
        let elements = self.sequence.asked.elements;
        let coarser = if self.sought.follows_width() { COARSER_FOR_WIDTH } else { COARSER };
        let elements = match density {
            Density::Asked => return self.sequence.solve(loads, run, steps),
            Density::Half => elements.div_ceil(2).max(FEWEST_BESIDE),
            Density::Coarse => (elements / coarser).max(FEWEST_ELEMENTS),
        };
        self.sequence.auxiliary(elements).solve(loads, run, steps)
    }

    fn too_large(error: MeshedError) -> Result<Limit, MeshedError> {
        error.too_large()
    }

    fn utilization(&self, step: &StepSolution) -> f64 {
        highest_utilization(step, self.problem).map_or(0.0, |highest| highest.ratio)
    }

    fn figure(&self, step: &StepSolution, target: TargetFigure) -> f64 {
        target_figure(step, target)
    }

    fn error(&self, step: &StepSolution, target: TargetFigure) -> Option<f64> {
        Bars::of(step)?.of_target(target)
    }
}
