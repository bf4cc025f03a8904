//! Load after load, each on small meshes, a coarse and a fine one, each sized by the one before.

use std::sync::Arc;

use crate::element::StressState;
use crate::engine::body_system::factor_cache::FactorCache;
use crate::engine::body_system::plastic_search_region::PlasticSearchRegion;
use crate::engine::body_system::system::System;
use crate::engine::error::MeshedError;
use crate::engine::loads::resolution_reserve;
use crate::engine::mesh_sizing::contact_size::{ContactSizeEstimate, refinement};
use crate::engine::mesh_sizing::end_of_contact::EndSearch;
use crate::engine::mesh_sizing::trace;
use crate::engine::mesh_solve::{self, MeshSolve, MeshSolveRequest};
use crate::engine::meshed_contact::Asked;
use crate::engine::problem::Problem;
use crate::engine::solution::StepSolution;
use crate::engine::{final_check, finite_elements};
use crate::mesh::ContactZone;
use brinell_contact::{ActiveSetSolver, ContactLoad, ContactSolver};
use brinell_method::couplings::Accelerated;
use brinell_method::couplings::iteration::Scales;
use brinell_method::final_check::LeastScales;
use brinell_method::increments::Increments;
use brinell_method::observer::{Interrupt, SolveStatus};
use brinell_method::phases::Phase;
use brinell_method::run::Run;
use brinell_method::settings::{Settings, Theory};

/// Elements over a half-width in the first mesh.
const SIZING_ELEMENTS: usize = 6;
/// Tolerance of the auxiliary passes. It leaves their figures wrong by a few hundredths of the
/// mesh's own error.
const AUXILIARY_TOLERANCE: f64 = 1e-4;
/// Sizing passes at most; each is made on the answer of the one before.
const SIZING_PASSES: usize = 5;
/// Further ones at most that move the end of the contact between two nodes.
const SETTLING_PASSES: usize = 5;
/// Part of the expected half-width that a sizing pass must find in contact to be trusted.
const SIZING_TRUST: f64 = 0.4;
/// Reach of the search for plastic flow over the reach of the flow on the coarser mesh.
const PLASTIC_MARGIN: f64 = 1.15;
/// Least width of the zone over that of the contact for which a mesh is used again.
const ZONE_MARGIN: f64 = 1.12;
/// Elements that a mesh used again may be short of those asked for, and how much smaller or larger
/// a contact is expected to be than the one for which its mesh was made, to be left on it whatever
/// was found of its extent.
const RESOLUTION_SLACK: f64 = 1.05;

/// Factor by which a zone that does not fit on the surfaces is narrowed, again and again.
const NARROWING: f64 = 0.95;
const MAX_NARROWINGS: usize = 60;

/// Solves load after load.
pub(crate) struct LoadStepper<'a> {
    problem: &'a Problem,
    asked: Asked,
    contact: &'a dyn ContactSolver,
    cache: Option<&'a Arc<FactorCache>>,
    last: Option<LastStep>,
}

/// State of the last load of a sweep, on which the next load can build.
struct LastStep {
    load: ContactLoad,
    /// The load for which the meshes were made.
    made_for: ContactLoad,
    extent: ContactSizeEstimate,
    coarse: System,
    fine: System,
}

impl<'a> LoadStepper<'a> {
    pub fn new(
        problem: &'a Problem,
        asked: Asked,
        contact: &'a dyn ContactSolver,
        cache: Option<&'a Arc<FactorCache>>,
    ) -> Self {
        Self { problem, asked, contact, cache, last: None }
    }

    /// One load; `next` is the one after it, for which the mesh may be made to serve as well.
    pub fn step(
        &mut self,
        load: ContactLoad,
        next: Option<ContactLoad>,
        run: &mut Run<'_>,
    ) -> Result<StepSolution, MeshedError> {
        let reserve = resolution_reserve(load, next);
        let last = self.last.take();
        let predicted = last.as_ref().map(|last| last.extent.scaled(self.growth(last.load, load)));
        let serves = matches!((&last, predicted), (Some(last), Some(extent)) if self.serves(last, load, extent));
        let made_for = last.as_ref().filter(|_| serves).map_or(load, |last| last.made_for);
        // A smaller contact lies within what is known already; a larger one is looked for as that
        // of a job of its own is.
        let falls = last.as_ref().is_some_and(|last| load.magnitude() < last.load.magnitude());
        let (extent, sizing) = match predicted.filter(|_| serves || falls) {
            Some(extent) => (extent, None),
            None => self.size(load, run).map(|(extent, pass)| (extent, Some(pass)))?,
        };
        let (coarse, fine) = last.filter(|_| serves).map(|last| (last.coarse, last.fine)).unzip();
        let previous = sizing.as_ref().map(MeshSolve::nodal_fields).unwrap_or_default();
        let elements = self.asked.elements as usize;
        let mut request = self.request(load, extent, (elements / 2).max(2), reserve, auxiliary());
        request.previous = (!previous.is_empty()).then_some(&previous);
        let coarse = self.solve_auxiliary(&request, coarse, run)?;
        let found = || self.found(extent, &coarse);
        let extent = run.time(Phase::Output, found);
        let figures = coarse.patch.map(|_| coarse.measure());

        let previous = coarse.nodal_fields();
        let mut request = self.request(load, extent, elements, reserve, self.asked.solver);
        request.contact = self.contact;
        request.previous = request.solver.coupling.uses_tangent_moduli().then_some(&previous);
        let mut pass = finite_elements::run(self.problem, &request, fine, run)?;
        // Before the stresses are handed over.
        let found = run.time(Phase::Output, || extent.found_by(&pass));
        let (tolerance, yields) = (request.solver.tolerance, pass.yields());
        let mut step = final_check::finish(
            self.problem,
            &mut pass,
            load,
            tolerance,
            (LeastScales::default(), None),
            run,
        );
        step.coarse = figures;
        let elastic_force = (!yields).then_some(step.figures.force);
        // One step of the search for it needs no remark.
        step.field.unresolved = found.unresolved(
            self.problem,
            trace::STEP * pass.system.zone.spacing(),
            elastic_force,
        );
        let is_converged = step.status == SolveStatus::Converged;
        // Memory is freed here, where the time it takes is measured.
        self.last = run.time(Phase::Output, move || {
            drop(sizing);
            // Only converged solutions seed the next load.
            (next.is_some() && is_converged).then(|| LastStep {
                load,
                made_for,
                extent: found,
                coarse: coarse.into_system(load),
                fine: pass.into_system(load),
            })
        });
        Ok(step)
    }

    /// Returns the contact size of an elastic body under the load `to` over that under `from`.
    pub fn growth(&self, from: ContactLoad, to: ContactLoad) -> f64 {
        let exponent = match (self.problem.stress_state, to) {
            (StressState::Axisymmetric, ContactLoad::Force(_)) => 0.4,
            (_, ContactLoad::Force(_)) => 0.6,
            (_, ContactLoad::Approach(_)) => 0.5,
        };
        (to.magnitude() / from.magnitude()).powf(exponent)
    }

    /// Whether the meshes of the last load serve for a load whose contact is expected to have this
    /// extent.
    fn serves(&self, last: &LastStep, load: ContactLoad, extent: ContactSizeEstimate) -> bool {
        let elements = self.asked.elements as usize;
        let zone = &last.fine.zone;
        // The contact size that a mesh finds jumps by an element: a search would go from mesh to
        // mesh and never settle.
        let is_near = || self.growth(last.made_for, load).ln().abs() <= RESOLUTION_SLACK.ln();
        zone.half_width() >= ZONE_MARGIN * extent.half_width
            && (zone.spacing() <= RESOLUTION_SLACK * extent.spacing(elements) || is_near())
    }

    /// Small meshes with a loose tolerance, from the closed-form estimate until one finds its own
    /// size confirmed.
    pub(super) fn size(
        &self,
        load: ContactLoad,
        run: &mut Run<'_>,
    ) -> Result<(ContactSizeEstimate, MeshSolve), MeshedError> {
        let elements = self.asked.elements as usize;
        let expect = || {
            ContactSizeEstimate::expected(self.problem, load)?.resolved(
                self.problem,
                load,
                elements,
            )
        };
        let mut extent = run.time(Phase::Mesh, expect)?;
        let (mut found, mut pass) = self.small_mesh(load, extent, None, run)?;
        for _ in 1..SIZING_PASSES {
            if !has_answer(&pass) {
                // Near a limit load a mesh now and then has none, and another one has.
                let wider = extent.scaled(mesh_solve::ENLARGEMENT);
                let next = self.small_mesh(load, wider, None, run)?;
                if !has_answer(&next.1) {
                    return Ok((found, pass));
                }
                extent = wider;
                (found, pass) = next;
            }
            if found.half_width >= SIZING_TRUST * extent.half_width {
                break;
            }
            // A contact of one or two elements is not yet known to be that small.
            let smallest_part = found.half_width;
            extent = ContactSizeEstimate {
                half_width: mesh_solve::ENLARGEMENT * found.half_width,
                smallest_part,
                ..found
            };
            (found, pass) = self.small_mesh(load, extent, None, run)?;
        }
        self.settle(load, found, pass, run)
    }

    /// Small meshes until the contact of bodies that yield ends between two nodes as it does at
    /// any other load.
    fn settle(
        &self,
        load: ContactLoad,
        mut found: ContactSizeEstimate,
        mut pass: MeshSolve,
        run: &mut Run<'_>,
    ) -> Result<(ContactSizeEstimate, MeshSolve), MeshedError> {
        let mut search = EndSearch::default();
        for _ in 0..SETTLING_PASSES {
            // Elements that are small for the sake of a trace are not sized by the contact.
            let is_sized = pass.yields() && found.refinement <= 1.0;
            let spacing = is_sized.then(|| search.next(&pass, found.half_width, SIZING_ELEMENTS));
            let Some(spacing) = spacing.flatten() else { break };
            let extent = found.with_spacing(spacing, SIZING_ELEMENTS);
            let next = self.small_mesh(load, extent, Some(&pass), run)?;
            if !has_answer(&next.1) {
                break;
            }
            (found, pass) = next;
        }
        Ok((found, pass))
    }

    /// A small mesh for a contact of this extent, from an answer on another one, and what it finds
    /// of the contact.
    fn small_mesh(
        &self,
        load: ContactLoad,
        extent: ContactSizeEstimate,
        previous: Option<&MeshSolve>,
        run: &mut Run<'_>,
    ) -> Result<(ContactSizeEstimate, MeshSolve), MeshedError> {
        let previous = previous.map(MeshSolve::nodal_fields);
        let mut request = self.request(load, extent, SIZING_ELEMENTS, 1.0, auxiliary());
        request.search_region = PlasticSearchRegion::WholeBody;
        request.previous = previous.as_deref();
        let pass = self.solve_auxiliary(&request, None, run)?;
        let found = run.time(Phase::Output, || self.found(extent, &pass));
        Ok((found, pass))
    }

    /// Returns the contact size that a mesh has found, with elements as small as the surfaces need
    /// them. Where a body has collapsed the surfaces are in contact wherever they happen to be, and
    /// no finer mesh helps.
    fn found(&self, extent: ContactSizeEstimate, pass: &MeshSolve) -> ContactSizeEstimate {
        let found = extent.found_by(pass);
        if pass.has_collapsed() {
            return found;
        }
        let found = found.refined(self.problem, self.asked.elements as usize);
        // Where summits yield they grow together.
        if pass.yields() { found } else { found.with_parts(self.problem, pass.figures().force) }
    }

    fn solve_auxiliary(
        &self,
        request: &MeshSolveRequest<'_>,
        known: Option<System>,
        run: &mut Run<'_>,
    ) -> Result<MeshSolve, MeshedError> {
        let pass =
            run.preliminarily(|run| finite_elements::run(self.problem, request, known, run))?;
        // One that was stopped has no fields that the next mesh could start from.
        match pass.outcome.status {
            SolveStatus::Cancelled => {
                Err(MeshedError::Method(brinell_method::Error::Interrupted(Interrupt::Cancelled)))
            }
            SolveStatus::TimedOut => {
                Err(MeshedError::Method(brinell_method::Error::Interrupted(Interrupt::TimedOut)))
            }
            SolveStatus::Converged | SolveStatus::NotConverged => Ok(pass),
        }
    }

    /// A zone for a contact of this size, or as much of it as the surfaces have room for.
    fn zone(&self, mut extent: ContactSizeEstimate, spacing: f64) -> ContactZone {
        for _ in 0..MAX_NARROWINGS {
            let zone = extent.zone(self.problem, spacing);
            if mesh_solve::fits(self.problem, &zone) {
                return zone;
            }
            extent.half_width *= NARROWING;
        }
        extent.zone(self.problem, spacing)
    }

    pub(super) fn request(
        &self,
        load: ContactLoad,
        extent: ContactSizeEstimate,
        elements: usize,
        reserve: f64,
        solver: Settings,
    ) -> MeshSolveRequest<'a> {
        let spacing = extent.spacing(elements) / reserve;
        // An envelope of distances from the middle of the contact does not follow a surface that
        // bends round.
        let is_whole = solver.coupling.needs_whole_body() || self.problem.conforming.is_some();
        let search_region = if is_whole {
            PlasticSearchRegion::WholeBody
        } else {
            PlasticSearchRegion::Within(extent.plastic.scaled(PLASTIC_MARGIN))
        };
        let zone = self.zone(extent, spacing);
        MeshSolveRequest {
            contact: &ActiveSetSolver,
            refinement: refinement(&zone),
            zone,
            search_region,
            load,
            solver,
            previous: None,
            cache: self.cache,
            scales: Scales::default(),
            increment: None,
        }
    }
}

/// Whether a mesh has found an answer of small strains.
fn has_answer(pass: &MeshSolve) -> bool {
    pass.outcome.status == SolveStatus::Converged && !pass.has_collapsed()
}

/// Returns the settings of the auxiliary meshes, whatever is asked for.
pub(super) fn auxiliary() -> Settings {
    Settings {
        theory: Theory::Deformation,
        increments: Increments::default(),
        coupling: &Accelerated,
        contact: &ActiveSetSolver,
        tolerance: AUXILIARY_TOLERANCE,
        max_iterations: 200,
    }
}
