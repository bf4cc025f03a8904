//! Finite elements as an engine of the method: builds the meshes and judges the outcomes on them.

use crate::assembly::Extent;
use crate::engine::body_system::plastic_search_region::PlasticSearchRegion;
use crate::engine::body_system::system::{Design, System};
use crate::engine::error::MeshedError;
use crate::engine::mesh_solve::{
    MeshSolve, MeshSolveRequest, enlarged, fields, most_columns, narrow,
};
use crate::engine::problem::Problem;
use crate::mesh::{ContactZone, MeshError};
use brinell_material::ReferenceModuli;
use brinell_method::contact_system::{BlockVector, Linearize as _};
use brinell_method::couplings::iteration::Outcome;
use brinell_method::phases::Phase;
use brinell_method::run::Run;
use brinell_method::solve::{Engine, Round, Verdict, VerdictOf, solve};

/// Narrowings of a zone that cannot be meshed, at most.
const MAX_NARROWINGS: usize = 12;
/// Enlargements of a zone after which the contact counts as wider than the body.
const MAX_ENLARGEMENTS: usize = 12;
/// Growth of the plastic region, over the extent of plastic flow, where plastic flow has left it.
const WIDENING: f64 = 1.3;

/// Two bodies and the request for their meshes.
pub(crate) struct FiniteElements<'a, H = ()> {
    pub problem: &'a Problem,
    pub request: MeshSolveRequest<'a>,
    /// Whether loads are increments of a history, with states of the material.
    pub is_history: bool,
    /// What a history needs beside bodies and request.
    pub of_history: H,
}

/// A mesh.
#[derive(Clone)]
pub(crate) struct MeshDesign {
    zone: ContactZone,
    search_region: PlasticSearchRegion,
    /// Columns of a widened zone, at most.
    most_columns: usize,
    enlargements: usize,
    narrowings: usize,
    /// Number of enlargements of the plastic region.
    widenings: usize,
}

impl MeshDesign {
    /// The first mesh of a request.
    pub fn of(request: &MeshSolveRequest<'_>) -> Self {
        Self::new(request.zone.clone(), request.search_region)
    }

    pub fn new(zone: ContactZone, search_region: PlasticSearchRegion) -> Self {
        let most_columns = most_columns(&zone);
        Self { zone, search_region, most_columns, enlargements: 0, narrowings: 0, widenings: 0 }
    }
}

impl<H> FiniteElements<'_, H> {
    /// Factorizes with the tangent moduli of a state, or the elastic moduli without one, if the
    /// coupling uses tangent moduli.
    fn linearize(
        &self,
        system: &mut System,
        at: Option<&BlockVector>,
        run: &mut Run<'_>,
    ) -> Result<(), MeshedError> {
        if self.request.solver.coupling.uses_tangent_moduli() {
            system.linearize(at.map(|at| (at, ReferenceModuli::Tangent)), run)?;
        }
        Ok(())
    }

    /// Enlarges the plastic region and continues from the same state.
    fn widen(
        &self,
        mut solve: MeshSolve,
        is_first: bool,
        under: Round,
        run: &mut Run<'_>,
    ) -> Result<VerdictOf<Self>, MeshedError> {
        let search_region = if is_first {
            let envelope = solve.yielded_envelope().joined(&solve.system.accepted.plastic);
            PlasticSearchRegion::Within(envelope.scaled(WIDENING))
        } else {
            PlasticSearchRegion::WholeBody
        };
        let history = std::mem::take(&mut solve.outcome.history);
        let mut system = solve.into_system(under.load);
        let start = system.last_state().cloned();
        if self.is_history {
            system.extend_plastic_region(search_region);
        } else {
            run.time(Phase::Plasticity, || system.set_plastic_region(search_region));
            self.linearize(&mut system, start.as_ref(), run)?;
        }
        Ok(Verdict::Continue { system, start, history })
    }

    /// Returns the design with a wider zone, if the contact reaches the edge of the present zone
    /// and the bodies have room.
    fn wider(&self, design: &MeshDesign, solve: &MeshSolve, under: Round) -> Option<MeshDesign> {
        // A contact that reaches the edge of a narrowed zone is reported.
        let may_enlarge = design.enlargements < MAX_ENLARGEMENTS && design.narrowings == 0;
        if !(solve.reaches_edge && may_enlarge) {
            return None;
        }
        let zone = enlarged(self.problem, &solve.system.zone, solve.meets, design.most_columns)?;
        let enlargements = design.enlargements + 1;
        // A history begins again at rest, where nothing has yielded.
        if self.is_history {
            return Some(MeshDesign { zone, enlargements, ..design.clone() });
        }
        let (search_region, widenings) =
            (solve.system.search_region, design.widenings + under.number);
        Some(MeshDesign { zone, search_region, enlargements, widenings, ..design.clone() })
    }
}

impl<H> Engine for FiniteElements<'_, H> {
    type System = System;
    type Design = MeshDesign;
    type Answer = MeshSolve;
    type Error = MeshedError;

    fn build(
        &self,
        design: &mut MeshDesign,
        run: &mut Run<'_>,
    ) -> Result<(System, Option<BlockVector>), MeshedError> {
        let MeshSolveRequest { refinement, cache, previous, .. } = self.request;
        loop {
            let MeshDesign { zone, search_region, .. } = &*design;
            let plan = Design {
                zone,
                refinement,
                search_region: *search_region,
                cache,
                is_linearized_later: self.is_history
                    && self.request.solver.coupling.uses_tangent_moduli(),
            };
            match System::build(self.problem, plan, previous, run) {
                Err(MeshedError::Mesh(MeshError::Inverted { .. }))
                    if design.narrowings < MAX_NARROWINGS =>
                {
                    design.narrowings += 1;
                    design.zone = narrow(self.problem, &design.zone);
                }
                built => return built,
            }
        }
    }

    /// Starts from the straight line through the last two states, or from an answer on another
    /// mesh if the request has one. A history prepares each increment itself.
    fn resume(
        &self,
        design: &MeshDesign,
        mut system: System,
        run: &mut Run<'_>,
    ) -> Result<(System, Option<BlockVector>), MeshedError> {
        if self.is_history {
            return Ok((system, None));
        }
        let start = system.extrapolated(self.request.load.magnitude());
        run.time(Phase::Plasticity, || system.set_plastic_region(design.search_region));
        if let Some(previous) = self.request.previous {
            let transferred = system.linearize_by(previous, run)?;
            return Ok((system, Some(transferred)));
        }
        self.linearize(&mut system, start.as_ref(), run)?;
        Ok((system, start))
    }

    fn verdict(
        &self,
        design: &MeshDesign,
        system: System,
        mut outcome: Outcome,
        under: Round,
        run: &mut Run<'_>,
    ) -> Result<VerdictOf<Self>, MeshedError> {
        let extent = if under.is_on_way { Extent::Region } else { Extent::Body };
        let fields = run.time_observed(Phase::Output, |observer| {
            fields(&system, &mut outcome, extent, observer)
        });
        let mut solve =
            run.time(Phase::Output, || MeshSolve::of(self.problem, system, outcome, fields));
        solve.enlargements = design.enlargements;
        if solve.outcome.status.is_stopped() {
            return Ok(Verdict::Accept(solve));
        }
        if !under.is_on_way && run.time(Phase::Output, || solve.yields_outside_region()) {
            return self.widen(solve, design.widenings + under.number == 0, under, run);
        }
        Ok(match self.wider(design, &solve, under) {
            Some(wider) => Verdict::Again(wider),
            None => Verdict::Accept(solve),
        })
    }
}

/// Solves one load, on `known` bodies if there are any.
///
/// # Errors
/// Those of a mesh, a factorization or a contact solve.
pub(crate) fn run(
    problem: &Problem,
    request: &MeshSolveRequest<'_>,
    known: Option<System>,
    run: &mut Run<'_>,
) -> Result<MeshSolve, MeshedError> {
    let request = request.clone();
    let engine = FiniteElements { problem, request, is_history: false, of_history: () };
    let design = MeshDesign::of(&engine.request);
    solve(&engine, design, known, run, |mesh, system, start, run| {
        let request = &engine.request;
        mesh.solve(system, start, request.solver.coupling, request.controls(), run)
    })
}
