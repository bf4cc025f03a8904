//! Cost of a contact, estimated without a mesh.

use crate::engine::body_system::plastic_search_region::RadialEnvelope;
use crate::engine::error::MeshedError;
use crate::engine::loads::resolution_reserve;
use crate::engine::mesh_sizing::contact_size::{ContactSizeEstimate, MAX_HALF_WIDTH, refinement};
use crate::engine::mesh_sizing::first_force::{first_force, weakest};
use crate::engine::meshed_contact::MeshedContact;
use crate::engine::problem::Problem;
use crate::mesh::{Mesh, MeshError, estimated_nodes};
use brinell_contact::ContactLoad;
use brinell_method::settings::Theory;
use brinell_method::sought::{Loads, Sought, Target, TargetFigure, largest_loads};

/// Bytes of factor for each equation and binary digit of their number.
const FACTOR_BYTES: f64 = 40.0;
/// A load under which any two bodies touch over a part of their surfaces, if they are to at all.
const LEAST_LOAD: ContactLoad = ContactLoad::Force(1e-9);
/// Bytes of everything else for each equation.
const OTHER_BYTES: f64 = 2000.0;

/// Estimated cost of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Estimate {
    /// Equations of both bodies together.
    pub equations: usize,
    /// Peak memory \[bytes\].
    pub bytes: u64,
}

/// Estimates the cost of a contact without meshing it, but for steep faces.
///
/// # Errors
/// [`MeshedError`] for contacts that are not solved: too wide, conforming, of traces too fine or
/// faces too steep, with a corner that may be none.
pub fn estimate(contact: &MeshedContact) -> Result<Estimate, MeshedError> {
    let MeshedContact { problem, loads, asked, .. } = contact;
    let elements = asked.elements as usize;
    let mut worst = Estimate { equations: 0, bytes: 0 };
    let is_history = asked.solver.theory == Theory::Flow;
    let loads = match loads {
        // One mesh for all of a history.
        Loads::History(loads) if is_history => largest_loads(loads),
        Loads::Each(loads) | Loads::History(loads) => loads.clone(),
        Loads::Sought(sought) => return nominal(problem, *sought, elements),
    };
    if is_history && loads.is_empty() {
        return Err(MeshedError::Method(brinell_method::Error::NoLoad));
    }
    for (k, &load) in loads.iter().enumerate() {
        let extent = ContactSizeEstimate::expected(problem, load)?
            .resolved(problem, load, elements)?
            .of_trace(problem, load, elements);
        let spacing = extent.spacing(elements)
            / resolution_reserve(load, loads.get(k + 1).filter(|_| !is_history).copied());
        let zone = extent.zone(problem, spacing);
        for outline in problem.deformable_outlines().filter(|outline| outline.is_steep()) {
            // Where there is no mesh for another reason, a narrower zone is tried.
            if let Err(error @ MeshError::TooSteep { .. }) =
                Mesh::generate(outline, &zone, refinement(&zone))
            {
                return Err(error.into());
            }
        }
        let nodes = |outline| estimated_nodes(outline, &zone, refinement(&zone));
        let found = cost(problem, &problem.deformable_outlines().map(nodes).collect::<Vec<_>>());
        worst.equations = worst.equations.max(found.equations);
        worst.bytes = worst.bytes.max(found.bytes);
    }
    Ok(worst)
}

/// Estimates the cost where the load is sought: of the contact under the force from which the
/// search begins. Without a closed form of that force, the contact has the half-width that is
/// sought or a hundredth of the surface.
fn nominal(problem: &Problem, sought: Sought, elements: usize) -> Result<Estimate, MeshedError> {
    if sought == Sought::Onset && problem.bodies.iter().all(|body| body.yield_stress().is_none()) {
        return Err(MeshedError::NoYieldPoint);
    }
    if let Err(error @ (MeshedError::Conforming { .. } | MeshedError::TouchesAtEnd { .. })) =
        ContactSizeEstimate::expected(problem, LEAST_LOAD)
    {
        return Err(error);
    }
    let available = problem.span().1;
    let half_width = match sought {
        Sought::Target(Target { figure: TargetFigure::HalfWidth, value }) => value,
        _ => 0.01 * available,
    };
    let limit = problem.conforming.map_or(MAX_HALF_WIDTH * available, |pair| pair.largest_arc());
    if half_width > limit {
        return Err(match &problem.conforming {
            Some(pair) => {
                MeshedError::TooFarRound { half_angle: pair.angle(half_width).to_degrees() }
            }
            None => MeshedError::TooWide { half_width, available },
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
    sought.first_mean_pressure(weakest(problem))?;
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
