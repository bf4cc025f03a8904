//! Histories of loads on finite elements.
//!
//! The mesh is sized by deformation theory under the largest load. Moduli are those after the
//! change that the coarse history has found; plastic flow is looked for outside of the plastic
//! region as for any other load.

use std::sync::Arc;

use super::growth::growth;
use super::load_stepper::{LoadStepper, auxiliary};
use super::path::Path;
use crate::assembly::{Extent, GaussPoint};
use crate::engine::body_system::system::System;
use crate::engine::body_system::transfer::NodalField;
use crate::engine::error::MeshedError;
use crate::engine::final_check;
use crate::engine::finite_elements::{FiniteElements, MeshDesign};
use crate::engine::mesh_sizing::contact_size::ContactSizeEstimate;
use crate::engine::mesh_solve::{MeshSolve, MeshSolveRequest, fields};
use crate::engine::meshed_contact::Asked;
use crate::engine::problem::Problem;
use crate::engine::solution::{SectionField, StepSolution};
use crate::mesh::ContactZone;
use brinell_contact::{ContactLoad, ContactSolver};
use brinell_material::{ReferenceModuli, body_flows, flows};
use brinell_method::contact_system::{BlockVector, ContactSystem as _, Linearize as _};
use brinell_method::couplings::Coupling;
use brinell_method::couplings::iteration::{Controls, Outcome};
use brinell_method::figures::Figures;
use brinell_method::final_check::LeastScales;
use brinell_method::history::{Memory, NextIncrement};
use brinell_method::increments::Growth;
use brinell_method::phases::Phase;
use brinell_method::progress::Progress;
use brinell_method::run::Run;
use brinell_method::sought::largest_loads;

/// Input of the solution of a history.
#[derive(Clone, Copy)]
pub(super) struct MeshedHistory<'a> {
    /// Bodies with the models of the history.
    pub problem: &'a Problem,
    /// The bodies under deformation theory, and the sizing of their meshes.
    pub sizing: &'a LoadStepper<'a>,
    pub asked: Asked,
    pub contact: &'a dyn ContactSolver,
    /// The loads in order, at least one of them above zero.
    pub loads: &'a [ContactLoad],
}

impl<'a> MeshedHistory<'a> {
    /// The engine on coarse meshes, sized for the largest loads, and its first mesh.
    pub fn coarse(
        self,
        run: &mut Run<'_>,
    ) -> Result<(HistoryOnMesh<'a>, MeshDesign), MeshedError> {
        let largest = self.largest()?;
        let mut widest: Option<ContactSizeEstimate> = None;
        for load in largest_loads(self.loads) {
            let (size, _) = self.sizing.size(load, run)?;
            if widest.is_none_or(|widest| size.half_width > widest.half_width) {
                widest = Some(size);
            }
        }
        let size = widest.ok_or(MeshedError::Method(brinell_method::Error::NoLoad))?;
        let elements = (self.asked.elements as usize / 2).max(2);
        let request = self.sizing.request(largest, size, elements, 1.0, auxiliary());
        Ok(Density { history: self, size, keeps_path: true }.engine(request))
    }

    /// The load that meshes are made for.
    fn largest(&self) -> Result<ContactLoad, MeshedError> {
        largest_loads(self.loads)
            .first()
            .copied()
            .ok_or(MeshedError::Method(brinell_method::Error::NoLoad))
    }
}

/// A history on meshes of one density.
type HistoryOnMesh<'a> = FiniteElements<'a, Density<'a>>;

/// The meshes of a history.
pub(super) struct Density<'a> {
    history: MeshedHistory<'a>,
    size: ContactSizeEstimate,
    /// Whether displacements are kept, for a finer history to go by.
    keeps_path: bool,
}

impl<'a> Density<'a> {
    /// The engine on these meshes, and the first of them.
    fn engine(self, request: MeshSolveRequest<'a>) -> (HistoryOnMesh<'a>, MeshDesign) {
        let design = MeshDesign::of(&request);
        let problem = self.history.problem;
        (FiniteElements { problem, request, is_history: true, of_history: self }, design)
    }
}

/// Memory of a history on a mesh.
pub(super) struct MeshMemory {
    zone: ContactZone,
    /// The contact at its widest.
    size: ContactSizeEstimate,
    /// Largest half-width so far \[mm\].
    widest: f64,
    path: Path,
    /// Largest peak pressure so far, its x, and that of the middle of its contact.
    peak: [f64; 3],
    /// Whether the load falls.
    is_falling: bool,
    /// Whether a point flowed in the last increment.
    flows: bool,
    /// Histories of the points of each model.
    points: Vec<Vec<PointHistory>>,
}

impl Memory for HistoryOnMesh<'_> {
    type Field = SectionField;
    type Record = MeshMemory;

    fn coupling(&self) -> &dyn Coupling {
        self.request.solver.coupling
    }

    fn controls(&self) -> Controls<'_> {
        self.request.controls()
    }

    fn begin(&self, system: &System) -> MeshMemory {
        MeshMemory {
            zone: system.zone.clone(),
            size: self.of_history.size,
            widest: 0.0,
            path: Path {
                meshes: system.bodies.iter().map(|body| Arc::clone(&body.elastic.mesh)).collect(),
                points: Vec::new(),
            },
            peak: [0.0; 3],
            is_falling: false,
            flows: false,
            points: Vec::new(),
        }
    }

    fn parts(answer: &MeshSolve) -> (&System, &Outcome) {
        (&answer.system, &answer.outcome)
    }

    fn outcome_mut(answer: &mut MeshSolve) -> &mut Outcome {
        &mut answer.outcome
    }

    fn into_parts(answer: MeshSolve) -> (System, Outcome) {
        (answer.system, answer.outcome)
    }

    fn figures(answer: &MeshSolve) -> Figures {
        answer.figures()
    }

    fn has_collapsed(answer: &MeshSolve) -> bool {
        answer.has_collapsed()
    }

    fn measure(&self, answer: &MeshSolve, _: &MeshMemory) -> Figures {
        answer.measure()
    }

    fn bytes(memory: &MeshMemory) -> usize {
        memory.path.bytes()
    }

    fn design_after(&self, memory: &MeshMemory) -> MeshDesign {
        MeshDesign::new(memory.zone.clone(), self.request.search_region)
    }

    fn at_rest(&self, mut system: System) -> Option<System> {
        system.rest(self.request.search_region);
        Some(system)
    }

    fn finer(&self, found: &MeshMemory) -> (Self, MeshDesign) {
        let (history, size) = (self.of_history.history, found.size);
        let MeshedHistory { sizing, asked, contact, .. } = history;
        let elements = asked.elements as usize;
        let request = sizing.request(self.request.load, size, elements, 1.0, asked.solver);
        let request = MeshSolveRequest { contact, ..request };
        Density { history, size, keeps_path: false }.engine(request)
    }

    fn follows_path(&self) -> bool {
        self.coupling().uses_tangent_moduli()
    }

    fn growth(&self, load: ContactLoad) -> Growth {
        growth(self.problem, load)
    }

    /// Nothing of the system but its stiffness is changed, and the states that follow a path.
    fn prepare(
        &self,
        system: &mut System,
        increment: &NextIncrement<'_, MeshMemory>,
        run: &mut Run<'_>,
    ) -> Result<BlockVector, MeshedError> {
        let &NextIncrement { target, time, leg, progress, guide, follows } = increment;
        let start = system.accepted().clone();
        if !self.coupling().uses_tangent_moduli() {
            return Ok(start);
        }
        if leg.falls() {
            system.linearize(None, run)?;
            return Ok(start);
        }
        if let Some(MeshMemory { path, .. }) = guide {
            let changes = path.changes(progress.time, time, follows);
            let meshes = path.meshes.iter().enumerate();
            let fields: Vec<Vec<_>> = meshes
                .map(|(k, mesh)| {
                    let fields = changes.iter().map(|change| change[k].as_slice());
                    fields.map(|displacement| NodalField { mesh, displacement }).collect()
                })
                .collect();
            return Ok(system.linearize_after(&start, &fields, run)?);
        }
        let start = progress.extrapolated(start, target.magnitude(), leg);
        system.linearize(Some((&start, ReferenceModuli::Tangent)), run)?;
        Ok(start)
    }

    fn remember(&self, solve: &mut MeshSolve, memory: &mut MeshMemory, time: f64, falls: bool) {
        memory.turn(falls);
        let plastic = solve.system.accepted.plastic.joined(&solve.yielded_envelope());
        let whole = solve.fields.iter().map(|field| field.displacement.clone()).collect();
        let half_width = solve.widest();
        let accepted = &mut solve.system.accepted;
        (accepted.plastic, accepted.whole, accepted.half_width) = (plastic, whole, half_width);
        memory.points.resize_with(solve.fields.len(), Vec::new);
        memory.flows = false;
        for (field, histories) in solve.fields.iter_mut().zip(&mut memory.points) {
            let points = field.stress.points.as_flattened_mut();
            histories.resize(points.len(), PointHistory::default());
            let [mut flowing, mut plastic] = [0.0; 2];
            for (point, history) in points.iter_mut().zip(histories) {
                if history.take(point, memory.is_falling) {
                    flowing += point.area;
                }
                if point.equivalent_plastic_strain > 0.0 {
                    plastic += point.area;
                }
            }
            memory.flows |= body_flows(flowing, plastic);
        }
        let half_width = solve.sizing_patch.map_or(0.0, |patch| patch.half_width());
        if solve.has_collapsed() {
            // It tells neither the width under the whole load nor where the bodies flow.
            memory.size = self.of_history.size;
        } else {
            if half_width > memory.widest {
                memory.widest = half_width;
                memory.size = self.of_history.size.found_by(solve);
            }
            memory.size.plastic = plastic;
        }
        if self.of_history.keeps_path {
            memory
                .path
                .points
                .push((time, solve.fields.iter().map(|field| field.nodal.clone()).collect()));
        }
    }

    fn step(
        &self,
        solve: &mut MeshSolve,
        load: ContactLoad,
        memory: &mut MeshMemory,
        progress: &Progress,
        run: &mut Run<'_>,
    ) -> StepSolution {
        let tolerance = self.request.solver.tolerance;
        // The last increment before a body collapses is one on the way.
        if progress.number.is_on_way() {
            solve.fields = run.time_observed(Phase::Output, |observer| {
                fields(&solve.system, &mut solve.outcome, Extent::Body, observer)
            });
        }
        let least =
            LeastScales { residual: progress.scales.force, contact: progress.contact_scales };
        let [largest_pressure, at, middle] = memory.peak;
        let least = (least, Some([at, middle]));
        let mut step = final_check::finish(self.problem, solve, load, tolerance, least, run);
        if step.field.patch.is_some() && step.figures.peak_pressure > largest_pressure {
            memory.peak =
                [step.figures.peak_pressure, step.field.peak_position, step.field.middle];
        }
        let unloading = final_check::unloading_stiffness(solve, run);
        step.field.unloading_stiffness = unloading.unwrap_or(0.0);
        // Ends that go back, or forth again, without flow leave the bodies elastic.
        step.path.flows = memory.flows;
        if progress.is_below_largest_load() && !memory.flows {
            step.contact_stiffness = step.contact_stiffness.or(unloading);
        }
        step
    }

    fn step_as_iterated(&self, solve: &MeshSolve, load: ContactLoad) -> StepSolution {
        final_check::as_iterated(solve, load, self.request.solver.tolerance)
    }
}

impl MeshMemory {
    /// Resets the reverse strains of the points where the load begins to fall.
    fn turn(&mut self, falls: bool) {
        if falls && !self.is_falling {
            self.points.iter_mut().flatten().for_each(|point| point.reverse = 0.0);
        }
        self.is_falling = falls;
    }
}

/// Stress over the largest von Mises stress of a point that counts as none: what unloading leaves
/// of elastic bodies.
const ROUNDING: f64 = 1e-12;

/// History of a point, beyond the state of its law.
#[derive(Debug, Clone, Copy, Default)]
struct PointHistory {
    /// Equivalent plastic strain.
    accumulated: f64,
    /// Part of it that came while the load last fell.
    reverse: f64,
    /// Largest von Mises stress \[MPa\].
    von_mises: f64,
}

impl PointHistory {
    /// Goes on to the end of an increment, and tells the point what it has been through. Returns
    /// whether the point flowed.
    fn take(&mut self, point: &mut GaussPoint, is_falling: bool) -> bool {
        let gained = point.equivalent_plastic_strain - self.accumulated;
        if is_falling {
            self.reverse += gained;
        }
        self.accumulated = point.equivalent_plastic_strain;
        self.von_mises = self.von_mises.max(point.largest_von_mises);
        let is_rounding = |stress: &f64| stress.abs() <= ROUNDING * self.von_mises;
        if point.stress.iter().all(is_rounding) {
            point.stress = Default::default();
        }
        point.reverse_plastic_strain = self.reverse;
        point.largest_von_mises = self.von_mises;
        flows(gained, self.von_mises, 3.0 * point.secant_shear)
    }
}
