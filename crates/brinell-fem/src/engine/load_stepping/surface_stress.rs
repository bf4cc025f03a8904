//! Stresses at the surface of a contact.
//!
//! Elements know stresses at their middles, half an element below. At the surface itself more is
//! known:
//! ```text
//! σ_n = -p                 contact pressure, 0 beside the contact
//! ε_t = Δu·t / Δs          strain along the surface, exact to second order half-way between two nodes
//! ε_θ = u_r / r            of a body of revolution; 0 in plane strain
//! ```
//! Hooke's law gives the other components of elastic bodies; `surface_recovery` has those of
//! bodies that yield. There is no friction and no shear stress. Stress that a body has before the
//! load is added as it is given, and what the body did to it where it relaxed as recovered at the
//! nodes.

use crate::element::StressState;
use crate::engine::body_solution::BodySolution;
use crate::engine::problem::{GivenStress, ProblemBody};
use crate::engine::recovery::Recovery;
use crate::engine::solution::{PairState, StepSolution};
use brinell_material::{ElasticModuli, von_mises};

/// A point of the surface half-way between two neighbouring pairs.
#[derive(Debug, Clone, Copy)]
pub(super) struct SurfacePoint {
    /// `[x, y]` \[mm\].
    pub position: [f64; 2],
    /// Stress `[σ_xx, σ_yy, σ_zz, τ_xy]` beyond the one that is given before the load \[MPa\].
    pub beyond_given: [f64; 4],
    /// Whether it lies beside the contact.
    is_free: bool,
}

/// The points of a body in order of x.
pub(super) fn surface_points(
    step: &StepSolution,
    body: &BodySolution,
    limits: &ProblemBody,
) -> Vec<SurfacePoint> {
    if body.displacement.is_empty() {
        return Vec::new();
    }
    let relaxed = relaxed_beyond_given(step, body, limits);
    let nodes = body.mesh.contact_nodes.windows(2).zip(relaxed.windows(2));
    let pairs = step.field.pairs.windows(2);
    let points = nodes.zip(pairs).filter_map(|((nodes, relaxed), pairs)| {
        let mut point = point(step.field.stress_state, body, nodes, pairs)?;
        for (k, stress) in point.beyond_given.iter_mut().enumerate() {
            *stress += relaxed.iter().map(|at_node| 0.5 * at_node[k]).sum::<f64>();
        }
        Some(point)
    });
    points.collect()
}

/// Returns the stress before the load less the given one, at the nodes of the surface \[MPa\].
fn relaxed_beyond_given(
    step: &StepSolution,
    body: &BodySolution,
    limits: &ProblemBody,
) -> Vec<[f64; 4]> {
    let nodes = &body.mesh.contact_nodes;
    let given = limits.initial_stress.as_deref().filter(|given| !given.is_in_equilibrium());
    let (Some(given), Some(at_rest)) = (given, body.at_rest()) else {
        return vec![[0.0; 4]; nodes.len()];
    };
    let beyond = beyond_given(at_rest, given);
    let mut recovery = Recovery::new(&beyond, step.field.symmetric);
    nodes
        .iter()
        .map(|&node| {
            let [x, y, z, shear, ..] = recovery.node(node);
            [x, y, z, shear]
        })
        .collect()
}

/// A body without the stress that is given before the load, which may vary faster than elements
/// tell.
pub(super) fn beyond_given(mut body: BodySolution, given: &GivenStress) -> BodySolution {
    for point in body.stress.points.iter_mut().flatten() {
        let given = given.at(point.position);
        point.stress.iter_mut().zip(given).for_each(|(stress, given)| *stress -= given);
    }
    body
}

/// Returns a stress with the given one added \[MPa\].
pub(super) fn with_given(stress: [f64; 4], limits: &ProblemBody, position: [f64; 2]) -> [f64; 4] {
    let given = limits.initial_stress.as_deref().map_or([0.0; 4], |given| given.at(position));
    std::array::from_fn(|k| stress[k] + given[k])
}

fn point(
    state: StressState,
    body: &BodySolution,
    nodes: &[u32],
    pairs: &[PairState],
) -> Option<SurfacePoint> {
    let ([left, right], [a, b]) = (nodes, pairs) else { return None };
    let Segment { position, tangent, along, around, .. } =
        Segment::of(state, body, [*left, *right]);
    let pressure = 0.5 * (a.pressure + b.pressure);
    let stress = principal(state, body.model.elastic(), [along, around], -pressure);
    Some(SurfacePoint {
        position,
        beyond_given: from_surface(stress, tangent),
        is_free: a.force == 0.0 && b.force == 0.0,
    })
}

/// `[σ_xx, σ_yy, σ_zz, τ_xy]` of the stresses `[σ_t, σ_n, σ_z]` of a surface.
pub(in crate::engine) fn from_surface([t, n, z]: [f64; 3], [c, s]: [f64; 2]) -> [f64; 4] {
    [t * c * c + n * s * s, t * s * s + n * c * c, z, (t - n) * c * s]
}

/// Geometry and strains half-way between two neighbouring nodes of a surface.
#[derive(Debug, Clone, Copy)]
pub(in crate::engine) struct Segment {
    /// \[mm\].
    pub length: f64,
    /// Its middle `[x, y]` \[mm\].
    pub position: [f64; 2],
    /// Unit vector towards larger abscissae.
    pub tangent: [f64; 2],
    /// Strain along the surface.
    pub along: f64,
    /// Hoop strain of a body of revolution.
    pub around: f64,
}

impl Segment {
    pub fn of(state: StressState, body: &BodySolution, nodes: [u32; 2]) -> Self {
        let [(from, u_from), (to, u_to)] =
            nodes.map(|node| (body.mesh.nodes[node as usize], body.displacement[node as usize]));
        let across: [f64; 2] = std::array::from_fn(|k| to[k] - from[k]);
        let length = across[0].hypot(across[1]);
        let tangent = across.map(|component| component / length);
        let position: [f64; 2] = std::array::from_fn(|k| 0.5 * (from[k] + to[k]));
        let along = (0..2).map(|k| (u_to[k] - u_from[k]) * tangent[k]).sum::<f64>() / length;
        let around = match state {
            StressState::Axisymmetric => 0.5 * (u_from[0] + u_to[0]) / position[0],
            StressState::PlaneStrain | StressState::PlaneStress => 0.0,
        };
        Self { length, position, tangent, along, around }
    }
}

/// `[σ_t, σ_n, σ_z]` for strains along the surface and out of the plane and a normal stress
/// \[MPa\].
pub(in crate::engine) fn principal(
    state: StressState,
    moduli: ElasticModuli,
    [along, across]: [f64; 2],
    normal: f64,
) -> [f64; 3] {
    let (lame, twice_shear) = (moduli.lame(), 2.0 * moduli.shear);
    let uniaxial = lame + twice_shear;
    if state == StressState::PlaneStress {
        let lame = lame * twice_shear / uniaxial;
        let inward = (normal - lame * along) / (lame + twice_shear);
        return [twice_shear * along + lame * (along + inward), normal, 0.0];
    }
    let inward = (normal - lame * (along + across)) / uniaxial;
    let volumetric = lame * (along + inward + across);
    [twice_shear * along + volumetric, normal, twice_shear * across + volumetric]
}

/// Highest von Mises stress at the edge of the contact circle of a body of revolution and its
/// place \[MPa, mm\]. Stress along the surface has a peak there that elements do not resolve:
/// beside the contact it falls as 1/r², as that of a force on a point does.
pub(super) fn at_contact_circle(
    step: &StepSolution,
    limits: &ProblemBody,
    points: &[SurfacePoint],
) -> Option<(f64, [f64; 2])> {
    let is_disc =
        step.field.stress_state == StressState::Axisymmetric && step.field.parts.len() == 1;
    let radius = step.field.patch.filter(|patch| is_disc && patch.left <= 0.0)?.right;
    // The outermost, because the others come into contact one after the other while a force is
    // sought.
    let outside = points.last().filter(|point| point.is_free)?;
    let factor = (outside.position[0] / radius).powi(2);
    let position = [radius, limits.outline.height(radius)];
    Some((
        von_mises(with_given(
            outside.beyond_given.map(|stress| factor * stress),
            limits,
            position,
        )),
        position,
    ))
}
