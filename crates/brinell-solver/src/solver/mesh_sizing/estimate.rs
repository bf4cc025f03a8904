//! What a job will cost, without meshing it.

use crate::contact::ContactLoad;
use crate::fem::mesh::{Mesh, MeshError, estimated_nodes};
use crate::job::{Job, Target, TargetFigure, Theory};
use crate::solver::SolveError;
use crate::solver::body_system::plastic_search_region::RadialEnvelope;
use crate::solver::load_stepping::force_search::{first_force, starts_from_pressure};
use crate::solver::loads::{Loads, Sought, largest_loads, loads, resolution_reserve};
use crate::solver::mesh_sizing::contact_size::{ContactSizeEstimate, MAX_HALF_WIDTH, refinement};
use crate::solver::problem::Problem;

/// Bytes of factor for each equation and binary digit of their number.
const FACTOR_BYTES: f64 = 40.0;
/// A load under which any two bodies touch over a part of their surfaces, if they are to at all.
const LEAST_LOAD: ContactLoad = ContactLoad::Force(1e-9);
/// Bytes of everything else for each equation.
const OTHER_BYTES: f64 = 2000.0;

/// What a job will cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Estimate {
    /// Equations of both bodies together.
    pub equations: usize,
    /// Peak memory \[bytes\].
    pub bytes: u64,
}

/// Estimates the cost of a job without meshing it, but for steep faces.
///
/// # Errors
/// [`SolveError`] for contacts that are not solved: too wide, conforming, of traces too fine or
/// faces too steep, with a corner that may be none.
pub fn estimate(job: &Job) -> Result<Estimate, SolveError> {
    let problem = Problem::of(job);
    let elements = job.mesh.elements_per_half_width as usize;
    let mut worst = Estimate { equations: 0, bytes: 0 };
    let mut loads = match loads(&job.load) {
        Loads::Given(loads) => loads,
        Loads::Sought(sought) => return nominal(&problem, sought, elements),
    };
    let is_history = job.solver.theory == Theory::Flow;
    if is_history {
        // One mesh for all of a history.
        loads = largest_loads(&loads);
        if loads.is_empty() {
            return Err(SolveError::NoLoad);
        }
    }
    for (k, &load) in loads.iter().enumerate() {
        let extent = ContactSizeEstimate::expected(&problem, load)?
            .resolved(&problem, load, elements)?
            .of_trace(&problem, load, elements);
        let spacing = extent.spacing(elements)
            / resolution_reserve(load, loads.get(k + 1).filter(|_| !is_history).copied());
        let zone = extent.zone(&problem, spacing);
        for outline in problem.deformable_outlines().filter(|outline| outline.is_steep()) {
            // Where there is no mesh for another reason, a narrower zone is tried.
            if let Err(error @ MeshError::TooSteep { .. }) =
                Mesh::generate(outline, &zone, refinement(&zone))
            {
                return Err(error.into());
            }
        }
        let nodes = |outline| estimated_nodes(outline, &zone, refinement(&zone));
        let found = cost(&problem, &problem.deformable_outlines().map(nodes).collect::<Vec<_>>());
        worst.equations = worst.equations.max(found.equations);
        worst.bytes = worst.bytes.max(found.bytes);
    }
    Ok(worst)
}

/// Where the load is yet to be found: the contact under the force from which the search begins; of
/// bodies of which no closed form tells one, a contact of a hundredth of the surface.
fn nominal(problem: &Problem, sought: Sought, elements: usize) -> Result<Estimate, SolveError> {
    if sought == Sought::Onset && problem.bodies.iter().all(|body| body.yield_stress().is_none()) {
        return Err(SolveError::NoYieldPoint);
    }
    if let Err(error @ (SolveError::Conforming { .. } | SolveError::TouchesAtEnd { .. })) =
        ContactSizeEstimate::expected(problem, LEAST_LOAD)
    {
        return Err(error);
    }
    let available = problem.span().1;
    let half_width = match sought {
        Sought::Target(Target { figure: TargetFigure::HalfWidth, value }) => value.get(),
        _ => 0.01 * available,
    };
    let limit = problem.conforming.map_or(MAX_HALF_WIDTH * available, |pair| pair.largest_arc());
    if half_width > limit {
        return Err(match &problem.conforming {
            Some(pair) => {
                SolveError::TooFarRound { half_angle: pair.angle(half_width).to_degrees() }
            }
            None => SolveError::TooWide { half_width, available },
        });
    }
    // Of surfaces that touch at two places, as far apart as these are.
    let apart = if problem.is_symmetric() { problem.first_contact_x.abs() } else { 0.0 };
    let extent = starting_extent(problem, sought, elements).unwrap_or(ContactSizeEstimate {
        centre: 0.0,
        half_width: apart.max(half_width),
        smallest_part: half_width,
        plastic: RadialEnvelope::NONE,
        hertz_half_width: half_width,
        refinement: 1.0,
    });
    let spacing = extent.spacing(elements);
    let zone = extent.zone(problem, spacing);
    let nodes = |outline| estimated_nodes(outline, &zone, refinement(&zone));
    Ok(cost(problem, &problem.deformable_outlines().map(nodes).collect::<Vec<_>>()))
}

/// The contact under the force from which a search begins; `None` where a width is sought, or
/// closed forms tell no force.
fn starting_extent(
    problem: &Problem,
    sought: Sought,
    elements: usize,
) -> Option<ContactSizeEstimate> {
    if !starts_from_pressure(sought, problem) {
        return None;
    }
    let load = ContactLoad::Force(first_force(sought, problem).ok()?);
    let extent = ContactSizeEstimate::expected(problem, load).ok()?;
    Some(
        extent
            .resolved(problem, load, elements)
            .unwrap_or(extent)
            .of_trace(problem, load, elements),
    )
}

/// The factor of nested dissection grows as `n log₂ n`, everything else as n; the constants were
/// measured and doubled. Equal bodies are solved once.
fn cost(problem: &Problem, nodes: &[usize]) -> Estimate {
    let equations: usize = nodes.iter().map(|n| 2 * n).sum();
    let solved = if problem.bodies_are_equal() { 1 } else { nodes.len() };
    let bytes: f64 = nodes
        .iter()
        .take(solved)
        .map(|&nodes| {
            let n = 2.0 * nodes as f64;
            FACTOR_BYTES * n * n.max(2.0).log2() + OTHER_BYTES * n
        })
        .sum();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "positive and far below 2^64"
    )]
    let bytes = bytes as u64;
    Estimate { equations, bytes }
}
