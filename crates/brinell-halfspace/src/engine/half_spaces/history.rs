//! Histories of loads on half-spaces: each increment starts from the accepted state, first on a
//! grid of half the cells, then on the grid of all cells.

use super::design::GridDesign;
use super::engine::{Answer, HalfSpaceEngine};
use super::error::HalfSpaceError;
use super::measure::{measure, place, stresses};
use super::problem::HalfSpaceProblem;
use super::sizing::size;
use super::step::{HalfSpaceField, HalfSpaceStep};
use super::system::HalfSpaces;
use crate::engine::watch::never;
use brinell_contact::ContactLoad;
use brinell_method::contact_system::{BlockVector, ContactSystem as _};
use brinell_method::couplings::Coupling;
use brinell_method::couplings::iteration::{Controls, Outcome};
use brinell_method::figures::Figures;
use brinell_method::final_check::LeastScales;
use brinell_method::history::{Memory, NextIncrement};
use brinell_method::increments::Growth;
use brinell_method::progress::Progress;
use brinell_method::run::Run;
use brinell_method::settings::Theory;
use brinell_method::sought::largest_loads;

/// Exponents of the growth of force and approach with the semi-axes, between the elastic and the
/// fully plastic contact of a ball.
const FORCE_EXPONENT: f64 = 2.4;
const APPROACH_EXPONENT: f64 = 2.0;

/// State of a history beside the accepted state of the system.
pub(super) struct GridMemory {
    design: GridDesign,
    /// A design that fits the contact of every increment so far.
    fitted: Option<GridDesign>,
    /// Position of the largest pressure under the last load above zero.
    peak: [f64; 2],
}

impl Memory for HalfSpaceEngine<'_> {
    type Field = HalfSpaceField;
    type Record = GridMemory;

    fn coupling(&self) -> &dyn Coupling {
        self.coupling
    }

    fn controls(&self) -> Controls<'_> {
        HalfSpaceEngine::controls(self)
    }

    fn begin(&self, system: &HalfSpaces) -> GridMemory {
        GridMemory { design: system.design, fitted: None, peak: [0.0; 2] }
    }

    fn bytes(_: &GridMemory) -> usize {
        0
    }

    fn parts(answer: &Answer) -> (&HalfSpaces, &Outcome) {
        (&answer.system, &answer.outcome)
    }

    fn outcome_mut(answer: &mut Answer) -> &mut Outcome {
        &mut answer.outcome
    }

    fn into_parts(answer: Answer) -> (HalfSpaces, Outcome) {
        (answer.system, answer.outcome)
    }

    fn figures(answer: &Answer) -> Figures {
        answer.figures()
    }

    fn has_collapsed(answer: &Answer) -> bool {
        answer.has_collapsed()
    }

    fn measure(&self, Answer { system, outcome }: &Answer, memory: &GridMemory) -> Figures {
        let stresses = stresses(system, outcome, &mut never).ok();
        measure(system, outcome, memory.peak, stresses).figures
    }

    fn design_after(&self, memory: &GridMemory) -> GridDesign {
        memory.design
    }

    fn finer(&self, found: &GridMemory) -> (Self, GridDesign) {
        let problem = self.problem;
        let engine = Self::new(problem, Theory::Flow);
        (engine, found.fitted.unwrap_or(found.design).with_cells(problem.cells()))
    }

    fn growth(&self, load: ContactLoad) -> Growth {
        // At the ends of a roller, yield begins below the force that this estimate gives.
        let onset = self.problem.yield_force().filter(|_| self.problem.rollers.is_empty());
        match load {
            ContactLoad::Force(_) => Growth { onset, exponent: FORCE_EXPONENT },
            ContactLoad::Approach(_) => {
                let onset = onset.map(|force| self.problem.hertz(force).approach);
                Growth { onset, exponent: APPROACH_EXPONENT }
            }
        }
    }

    /// Each increment starts from the accepted state without plastic flow. An extrapolation of the
    /// last increments saves no iterations.
    fn prepare(
        &self,
        system: &mut HalfSpaces,
        _: &NextIncrement<'_, GridMemory>,
        _: &mut Run<'_>,
    ) -> Result<BlockVector, HalfSpaceError> {
        Ok(system.accepted().clone())
    }

    fn remember(&self, answer: &mut Answer, memory: &mut GridMemory, _: f64, _: bool) {
        let Answer { system, outcome } = answer;
        let contact = &outcome.state.response.contact;
        if contact.total_force > 0.0 {
            let fitted = system.fitted(&contact.force);
            memory.fitted = Some(memory.fitted.map_or(fitted, |before| before.union(fitted)));
            memory.peak = place(system.grid(), system.peak(&contact.force).1);
        }
    }

    fn step(
        &self,
        answer: &mut Answer,
        load: ContactLoad,
        memory: &mut GridMemory,
        progress: &Progress,
        run: &mut Run<'_>,
    ) -> HalfSpaceStep {
        let least =
            LeastScales { residual: progress.scales.force, contact: progress.contact_scales };
        answer.step(self, load, memory.peak, least, run)
    }

    fn step_as_iterated(&self, answer: &Answer, load: ContactLoad) -> HalfSpaceStep {
        answer.step_as_iterated(self, load, [0.0; 2])
    }
}

/// Returns the size of the contact under a load over that under a smaller one, of bodies that
/// yield.
pub(super) fn contact_growth(from: ContactLoad, to: ContactLoad) -> f64 {
    let exponent = match to {
        ContactLoad::Force(_) => FORCE_EXPONENT,
        ContactLoad::Approach(_) => APPROACH_EXPONENT,
    };
    (to.magnitude() / from.magnitude()).powf(exponent.recip())
}

/// Returns the engine of a history on a grid of half the cells, and the design of its grid.
pub(super) fn coarse<'a>(
    problem: &'a HalfSpaceProblem,
    loads: &[ContactLoad],
    run: &mut Run<'_>,
) -> Result<(HalfSpaceEngine<'a>, GridDesign), HalfSpaceError> {
    let mut design: Option<GridDesign> = None;
    for load in largest_loads(loads) {
        let next = size(problem, load, run)?;
        design = Some(design.map_or(next, |design| design.union(next)));
    }
    let design = design.ok_or(HalfSpaceError::Method(brinell_method::Error::NoLoad))?;
    let engine = HalfSpaceEngine::auxiliary(problem, Theory::Flow, problem.solver.tolerance);
    Ok((engine, design.with_cells(0.5 * problem.cells())))
}
