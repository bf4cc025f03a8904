//! The bias of deformation theory: its difference to flow theory on the coarse mesh, which is
//! solved anyway.
//!
//! ```text
//! coarse mesh:  deformation theory under the load                          D
//!               flow theory in 6 increments of equal growth of the contact  F
//! bias        = (D - F) / |D|
//! uncertainty = |bias|
//! ```
//! One increment from rest is deformation theory, so that the bias is also the change of the
//! figures from one increment to six. The error of the increments is of first order, a fifth of
//! that change; the rest of the uncertainty is for the coarse mesh.
//! `docs/notes/theory_in_the_error.md` counts how often flow theory on the fine mesh lies within.
//!
//! The bodies of the coarse mesh keep mesh, order and factor; their constitutive models change.

use crate::engine::bias::TheoryBias;
use crate::engine::body_system::system::System;
use crate::engine::error::MeshedError;
use crate::engine::finite_elements::{FiniteElements, MeshDesign};
use crate::engine::mesh_solve::{MeshSolve, MeshSolveRequest};
use crate::engine::problem::{Problem, flow_theory};
use brinell_contact::ContactLoad;
use brinell_material::ReferenceModuli;
use brinell_method::contact_system::{BlockVector, ContactSystem as _, Linearize as _};
use brinell_method::couplings::Accelerated;
use brinell_method::couplings::iteration::Controls;
use brinell_method::figures::Figures;
use brinell_method::increments::{Growth, Leg};
use brinell_method::observer::{IncrementNumber, SolveStatus};
use brinell_method::progress::Progress;
use brinell_method::run::Run;
use brinell_method::solve::{LeaveOf, OnSystem, solve};

/// Increments of flow theory.
const INCREMENTS: u32 = 6;
/// Elastic peak over yield stress below which the theories are not compared.
pub const LEAST_RATIO: f64 = 2.0;

/// Flow theory on the mesh that deformation theory was solved on.
pub(super) struct FlowOnMesh<'a> {
    /// The bodies under flow theory.
    problem: Problem,
    request: MeshSolveRequest<'a>,
    growth: Growth,
}

impl<'a> FlowOnMesh<'a> {
    pub fn new(problem: &Problem, growth: Growth, request: MeshSolveRequest<'a>) -> Self {
        Self { problem: problem.with_models(flow_theory), request, growth }
    }

    /// Compares the figures of deformation theory with those of flow theory. Returns the bias, if
    /// flow theory has an answer of small strains, and the system, unless the contact has outgrown
    /// it. The system is at rest, with the models of `problem`.
    pub fn compare(
        &self,
        problem: &Problem,
        deformation: &Figures,
        mut system: System,
        run: &mut Run<'_>,
    ) -> (Option<TheoryBias>, Option<System>) {
        let last = system.last_state().cloned();
        system.begin_with(&self.problem, self.request.search_region);
        let end = run.preliminarily(|run| self.history(system, last.as_ref(), run));
        // The step has its answer; what stopped this one stops the next as well.
        let Ok((flow, mut system)) = end else { return (None, None) };
        system.begin_with(problem, self.request.search_region);
        let is_same = system.zone == self.request.zone;
        let bias = flow.map(|flow| TheoryBias::of(deformation, &flow));
        (bias, Some(system).filter(|_| is_same))
    }

    /// Loads the bodies at rest in increments. Returns the figures at the end, `None` without an
    /// answer of small strains.
    fn history(
        &self,
        system: System,
        mut last: Option<&BlockVector>,
        run: &mut Run<'_>,
    ) -> Result<(Option<Figures>, System), MeshedError> {
        let Self { problem, request, .. } = self;
        let design = MeshDesign::of(request);
        let request = request.clone();
        let elements = FiniteElements { problem, request, is_history: true, of_history: () };
        solve(&elements, design, Some(system), run, |on, system, _, run| {
            // A wider mesh has other equations.
            self.increments(on, system, last.take(), run)
        })
    }

    fn increments(
        &self,
        on: &OnSystem<'_, FiniteElements<'_>>,
        mut system: System,
        last: Option<&BlockVector>,
        run: &mut Run<'_>,
    ) -> Result<(Option<Figures>, System), LeaveOf<FiniteElements<'_>>> {
        let load = self.request.load;
        let mut progress = Progress::at_rest();
        let mut figures = None;
        for k in 1..=INCREMENTS {
            let leg = self.leg(&progress);
            let Growth { onset, exponent } = leg.growth;
            // Contact size over that under the whole load: at the onset of yield, at this end.
            let first = (onset.unwrap_or(0.0) / load.magnitude()).min(1.0).powf(exponent.recip());
            let size = first + (1.0 - first) * f64::from(k) / f64::from(INCREMENTS);
            let part = size.powf(exponent);
            let target = leg.load(part * load.magnitude());
            let start = match last.filter(|last| k == 1 && last.len() == system.bodies.len()) {
                Some(last) => last.iter().map(|u| u.iter().map(|u| part * u).collect()).collect(),
                None => progress.extrapolated(system.accepted().clone(), target.magnitude(), &leg),
            };
            system.linearize(Some((&start, ReferenceModuli::Tangent)), run)?;
            let [number, count] = [k, INCREMENTS].map(|number| number as usize);
            let number = IncrementNumber { number, count, load: 1, loads: 1 };
            let controls = Controls {
                load: target,
                scales: progress.scales,
                increment: Some(number),
                ..self.request.controls()
            };
            let answer = on.solve(system, Some(start), &Accelerated, controls, run)?;
            if answer.outcome.status != SolveStatus::Converged || answer.has_collapsed() {
                return Ok((None, answer.system));
            }
            progress.accept(&answer.system, &answer.outcome, target, part, &leg);
            figures = answer.patch.filter(|_| k == INCREMENTS).map(|_| answer.measure());
            let plastic = answer.system.accepted.plastic.joined(&answer.yielded_envelope());
            let whole = answer.fields.iter().map(|field| field.displacement.clone()).collect();
            let MeshSolve { system: same, outcome, .. } = answer;
            system = same;
            (system.accepted.plastic, system.accepted.whole) = (plastic, whole);
            system.commit(outcome.state.response.displacement);
        }
        Ok((figures, system))
    }

    fn leg(&self, progress: &Progress) -> Leg {
        let (is_force, to) = match self.request.load {
            ContactLoad::Force(force) => (true, force),
            ContactLoad::Approach(approach) => (false, approach),
        };
        let from = if is_force { progress.force } else { progress.approach };
        Leg { is_force, from, to, reached: from, growth: self.growth }
    }
}
