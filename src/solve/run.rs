//! From a job to its solution: three meshes, each sized by the one before.

use std::ops::ControlFlow;
use std::time::Duration;

use super::body::PlasticReach;
use super::pass::{self, PassRequest};
use super::phases::PhaseTimes;
use super::problem::Problem;
use super::solution::{self, Solution, StepSolution};
use super::{Interrupt, Observer, SolveError};
use crate::contact::{ActiveSetSolver, ContactLoad, ContactSolver, SimplexSolver};
use crate::mesh::Refinement;
use crate::model::{ContactMethod, Coupling, Job, Load, PositiveF64, SolverSettings};

/// Largest half-width of a contact as a part of the surface's half-span that is solved at all.
const MAX_HALF_WIDTH: f64 = 0.5;
/// Half-width of the candidate zone over the expected one of the contact.
const ZONE: f64 = 1.6;
/// Elements over a half-width in the first mesh.
const SIZING_ELEMENTS: usize = 6;
/// Distance up to which the plastic region is prepared, over the distance that plastic flow reached on the
/// coarser mesh.
const PLASTIC_MARGIN: f64 = 1.15;
/// Growth of the rings at 20 elements per half-width, less one. It leaves the approach low by 0.03 %.
const RING_GROWTH: f64 = 0.065;

/// What the wire format does not offer: for verification, and for trying out methods.
#[derive(Clone, Copy)]
pub struct Options<'a> {
    /// Whether a symmetric problem is solved on one half. Default true.
    pub use_symmetry: bool,
    /// Contact method of the final mesh in place of the one that the job names.
    pub contact_solver: Option<&'a dyn ContactSolver>,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self { use_symmetry: true, contact_solver: None }
    }
}

/// Solves a job.
///
/// Three meshes: a small one that finds out how wide the contact is, one of half the requested density for error
/// estimates, and the one that was asked for. Only the last is shown to the observer iteration by iteration; the
/// others can be stopped.
///
/// # Errors
/// [`SolveError`]. An iteration that does not converge is no error: see [`super::SolveStatus`].
pub fn run(job: &Job, observer: &mut dyn Observer) -> Result<Solution, SolveError> {
    run_with(job, Options::default(), observer)
}

/// [`run`] with options.
///
/// # Errors
/// As [`run`].
pub fn run_with(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
) -> Result<Solution, SolveError> {
    let mut problem = Problem::of(job);
    problem.use_symmetry = options.use_symmetry;
    let Load::Forces(forces) = &job.load else {
        return Err(SolveError::Unsupported("a prescribed approach"));
    };
    let contact = options.contact_solver.unwrap_or(match job.solver.contact {
        ContactMethod::ActiveSet => &ActiveSetSolver,
        ContactMethod::Simplex => &SimplexSolver,
    });
    let mut solution = Solution { steps: Vec::new(), phases: PhaseTimes::default(), passes: 0 };
    for force in forces.iter() {
        let mut run =
            Run { problem: &problem, job, contact, force: force.get(), solution: &mut solution, observer };
        let step = run.step()?;
        solution.steps.push(step);
    }
    Ok(solution)
}

/// What a job will cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Estimate {
    /// Equations of both bodies together.
    pub equations: usize,
    /// Peak memory \[bytes\].
    pub bytes: u64,
}

/// Estimates the cost of a job without meshing it.
///
/// # Errors
/// [`SolveError::Conforming`] or [`SolveError::TooWide`] for contacts that are not solved.
pub fn estimate(job: &Job) -> Result<Estimate, SolveError> {
    let problem = Problem::of(job);
    let Load::Forces(forces) = &job.load else {
        return Err(SolveError::Unsupported("a prescribed approach"));
    };
    let elements = job.mesh.elements_per_half_width as usize;
    let mut worst = Estimate { equations: 0, bytes: 0 };
    for force in forces.iter() {
        let half_width = ZONE * expected_half_width(&problem, force.get())?;
        let columns = (ZONE * elements as f64).round() as usize;
        let models = if problem.bodies_are_equal() { 1 } else { problem.deformable_count() };
        let nodes: usize = problem
            .deformable_outlines()
            .map(|outline| {
                crate::mesh::estimated_nodes(
                    outline,
                    half_width,
                    columns,
                    problem.is_symmetric(),
                    refinement(elements),
                )
            })
            .sum();
        let equations = 2 * nodes;
        worst.equations = worst.equations.max(equations);
        worst.bytes = worst.bytes.max(estimated_bytes(equations / problem.deformable_count().max(1), models));
    }
    Ok(worst)
}

/// Peak memory of `models` bodies of so many equations each: the factor of nested dissection grows as
/// `n log₂ n`, everything else as n. The constants were measured.
fn estimated_bytes(equations: usize, models: usize) -> u64 {
    let n = equations as f64;
    let per_model = FACTOR_BYTES * n * n.max(2.0).log2() + OTHER_BYTES * n;
    (per_model * models as f64) as u64
}

/// The half-width that a job's contact is expected to have \[mm\].
///
/// # Errors
/// [`SolveError::Conforming`] or [`SolveError::TooWide`] for contacts that are not solved.
fn expected_half_width(problem: &Problem, force: f64) -> Result<f64, SolveError> {
    let half_width = problem.first_half_width(force).ok_or(SolveError::Conforming)?;
    let available = problem.half_span();
    if half_width > MAX_HALF_WIDTH * available {
        return Err(SolveError::TooWide { half_width, available });
    }
    Ok(half_width)
}

/// Bytes of factor for each equation and binary digit of their number.
const FACTOR_BYTES: f64 = 40.0;
/// Bytes of everything else for each equation.
const OTHER_BYTES: f64 = 2000.0;

struct Run<'a> {
    problem: &'a Problem,
    job: &'a Job,
    contact: &'a dyn ContactSolver,
    force: f64,
    solution: &'a mut Solution,
    observer: &'a mut dyn Observer,
}

/// What a mesh is sized by.
#[derive(Clone, Copy)]
struct Extent {
    half_width: f64,
    plastic_radius: f64,
}

impl<'a> Run<'a> {
    fn step(&mut self) -> Result<StepSolution, SolveError> {
        let elements = self.job.mesh.elements_per_half_width as usize;
        let sized = self.sizing_pass()?;
        let coarse = self.quietly(&self.request(sized, (elements / 2).max(2), self.auxiliary(1e-5)))?;
        let extent = Extent {
            half_width: coarse.patch.map_or(sized.half_width, |patch| patch.half_width()),
            plastic_radius: coarse.plastic_radius(),
        };
        let figures = coarse.figures();
        drop(coarse);

        let mut request = self.request(extent, elements, self.job.solver);
        request.contact = self.contact;
        let mut finished = self.fine_pass(&request)?;
        if finished.left_region {
            request.plastic_reach = PlasticReach::WholeBody;
            finished = self.fine_pass(&request)?;
        }
        finished.step.coarse = figures;
        Ok(finished.step)
    }

    /// A small mesh around the closed-form estimate, with a loose tolerance.
    fn sizing_pass(&mut self) -> Result<Extent, SolveError> {
        let guess = expected_half_width(self.problem, self.force)?;
        let mut request = self.request(
            Extent { half_width: guess, plastic_radius: 0.0 },
            SIZING_ELEMENTS,
            self.auxiliary(1e-3),
        );
        request.plastic_reach = PlasticReach::WholeBody;
        let pass = self.quietly(&request)?;
        Ok(Extent {
            half_width: pass.patch.map_or(guess, |patch| patch.half_width()),
            plastic_radius: pass.plastic_radius(),
        })
    }

    fn fine_pass(&mut self, request: &PassRequest<'_>) -> Result<solution::Finished, SolveError> {
        let phases = &mut self.solution.phases;
        let pass = pass::run(self.problem, request, phases, self.observer)?;
        self.solution.passes += 1 + pass.enlargements;
        let tolerance = self.job.solver.tolerance.get();
        Ok(solution::finish(&pass, request.load, tolerance, phases, self.observer))
    }

    fn quietly(&mut self, request: &PassRequest<'_>) -> Result<pass::Pass, SolveError> {
        let mut quiet = Quiet { inner: self.observer };
        let pass = pass::run(self.problem, request, &mut self.solution.phases, &mut quiet)?;
        self.solution.passes += 1 + pass.enlargements;
        Ok(pass)
    }

    fn request(&self, extent: Extent, elements: usize, solver: SolverSettings) -> PassRequest<'a> {
        PassRequest {
            contact: &ActiveSetSolver,
            zone_half_width: ZONE * extent.half_width,
            columns: (ZONE * elements as f64).round() as usize,
            refinement: refinement(elements),
            plastic_reach: PlasticReach::Within(PLASTIC_MARGIN * extent.plastic_radius),
            load: ContactLoad::Force(self.force),
            solver,
        }
    }

    /// How the auxiliary passes are iterated, whatever the job asks for.
    fn auxiliary(&self, tolerance: f64) -> SolverSettings {
        SolverSettings {
            coupling: Coupling::Accelerated,
            contact: ContactMethod::ActiveSet,
            tolerance: PositiveF64::new(tolerance).unwrap_or(self.job.solver.tolerance),
            max_iterations: 200,
        }
    }
}

/// Rings become thinner together with the block's elements, so that both errors fall at the same rate.
fn refinement(elements_per_half_width: usize) -> Refinement {
    Refinement { growth: 1.0 + RING_GROWTH * 20.0 / elements_per_half_width as f64 }
}

/// Lets the auxiliary passes be stopped but not seen.
struct Quiet<'a> {
    inner: &'a mut dyn Observer,
}

impl Observer for Quiet<'_> {
    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        self.inner.on_checkpoint()
    }

    fn elapsed(&self) -> Duration {
        self.inner.elapsed()
    }
}
