//! Contact stiffness: the slope dP/dα of the load-approach curve at an answer.
//!
//! With the tangent stiffness K_T of the answer and its set of pairs in contact, the displacements v that go with
//! `dα = 1` are those of the least energy `v·K_T v` that close every active pair by its cosine e to the approach, mostly 1, and
//! that energy is ∂P/∂α.
//!
//! That is the slope for elements that are small beside all else. A mesh has a curve with corners: it is steeper where a pair
//! has just come into contact and its material is still elastic, and flatter until the next one does. Linear bodies tell enough
//! of that by their stiffness with one pair more or less. Where bodies yield the slopes differ by up to half at 20 elements over
//! the half-width, and the mesh has to grow with the contact, so that its ends stay where they are between two nodes:
//!
//! ```text
//! dP/dα = ∂P/∂α + Σ_j μ_j ∂P/∂a_j,     μ_j = da_j/dα
//! ```
//!
//! with one `a_j` for each end of the contact that moves, and ∂P/∂a_j the change of the load as the mesh moves with that end
//! and the approach stays (`mesh_motion.rs`), which is nothing but the error of the mesh. The ends move so that the force between
//! each of them and the point that does not move keeps its second moment about that point.

use nalgebra::{DMatrix, DVector};

use super::edge_contact::EdgeContact;
use super::mesh_motion::MeshMotion;
use super::tangent::{ActivePairConstraint, Change, Correction, Tangent, add};
use crate::solver::body_system::system::System;
use crate::solver::mesh_solve::MeshSolve;
use crate::solver::method::contact_system::{BlockVector, ContactSystem as _};
use crate::solver::method::couplings::iteration::State;
use crate::solver::method::observer::ask;
use crate::solver::method::solve::Answer as _;
use crate::solver::problem::Problem;
use crate::solver::{ContactPatch, Interrupt, Observer};
use dense_cholesky::DenseCholesky;

/// dP/dα of both sides of the axis together \[N/mm per mm, or N per mm\]; 0 where nothing touches.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ContactStiffness {
    pub slope: f64,
    /// Part of it that is not known, at least, where the contact ends on rounded edges with few elements or where the mesh does not tell
    /// how fast it grows; 0 elsewhere.
    pub least_error: f64,
}

/// The contact stiffness of an answer. The observer can stop it.
pub(crate) fn contact_stiffness(
    problem: &Problem,
    solve: &MeshSolve,
    observer: &mut dyn Observer,
) -> Result<ContactStiffness, Interrupt> {
    let MeshSolve { system, outcome, patch, .. } = solve;
    let state = &outcome.state;
    let tangent = Tangent::new(system, &state.response.displacement);
    let softening = |v: &BlockVector| tangent.softening(v);
    ask(observer)?;
    let edge = patch.and_then(|patch| Some((patch, RoundedEdges::of(problem, solve, patch)?)));
    let edge_error = edge.map_or(0.0, |(_, edge)| edge.least_error(solve.yields()));
    if let Some((patch, _)) = edge.filter(|(_, edge)| edge.is_narrow && edge.elements < HELD_EDGE) {
        let slope = stiffness(system, state, None, &softening, observer)?;
        let active: Vec<usize> = state.response.contact.active_set.iter().collect();
        let one_pair = (edge_correction(system, &active, patch) - 1.0).abs();
        return Ok(ContactStiffness { slope, least_error: one_pair.max(edge_error) });
    }
    let mut least_error = edge_error;
    // Ends that go back, or forth again over material that has yielded, leave it as elastic as the rest.
    if solve.yields() && !solve.is_within_earlier_contact {
        match growing(problem, solve, &MeshMotion::of(solve), &softening, observer)? {
            Growth::Told(slope) => return Ok(ContactStiffness { slope, least_error }),
            Growth::NotTold => least_error = least_error.max(NOT_TOLD),
            Growth::None => {}
        }
    }
    let slope = stiffness(system, state, *patch, &softening, observer)?;
    Ok(ContactStiffness { slope, least_error })
}

/// Elements on a rounded edge below which the contact does not grow there with the load as far as the mesh can tell.
const HELD_EDGE: f64 = 2.0;
/// Elements on a rounded edge from which on its stiffness is as well known as that of any other contact.
const RESOLVED_EDGE: f64 = 8.0;
/// What is not known of the stiffness, as a part of it: for elastic bodies, and for those that yield times the number of elements.
const ELASTIC_EDGE: f64 = 0.03;
const YIELDING_EDGE: f64 = 0.6;

/// The rounded edges of a flat punch on which a contact ends.
#[derive(Debug, Clone, Copy)]
struct RoundedEdges {
    /// Over how many elements the contact reaches onto each of them.
    elements: f64,
    /// Whether elements are too large for them.
    is_narrow: bool,
}

impl RoundedEdges {
    fn of(problem: &Problem, solve: &MeshSolve, patch: ContactPatch) -> Option<Self> {
        let (spacing, force) = (solve.system.zone.spacing(), solve.figures().force);
        let edge = EdgeContact::of(problem, patch, spacing, force)?;
        let elements = (patch.half_width() - edge.flat) / spacing;
        Some(Self { elements, is_narrow: edge.is_narrow(spacing) })
    }

    /// What is not known of the stiffness at least, as a part of it. With less than one element on it an edge that yields is as
    /// sharp as the mesh can tell.
    fn least_error(self, yields: bool) -> f64 {
        match self.elements {
            elements if yields && (1.0..RESOLVED_EDGE).contains(&elements) => YIELDING_EDGE / elements,
            elements if !yields && self.is_narrow && elements < HELD_EDGE => ELASTIC_EDGE / elements.max(1.0),
            _ => 0.0,
        }
    }
}

/// Stiffness of a contact that grows over that of its present pairs at most; growth mostly lowers it, and never by itself doubles it.
const MOST_GROWTH: f64 = 2.0;
/// What is not known of the stiffness, as a part of it, where that of a growing contact is not believed.
const NOT_TOLD: f64 = 1.0;

/// What the ends of a contact say of its stiffness \[N/mm per mm, or N per mm\].
enum Growth {
    /// No end moves the mesh.
    None,
    /// They do, but how fast cannot be told.
    NotTold,
    Told(f64),
}

/// The stiffness with the tangent `K - softening` and a contact whose ends move the mesh.
fn growing(
    problem: &Problem,
    solve: &MeshSolve,
    motions: &[MeshMotion],
    softening: &dyn Fn(&BlockVector) -> BlockVector,
    observer: &mut dyn Observer,
) -> Result<Growth, Interrupt> {
    let MeshSolve { system, outcome, .. } = solve;
    let Some(constraint) = ActivePairConstraint::new(system, &outcome.state) else { return Ok(Growth::None) };
    if motions.is_empty() || constraint.active.len() <= motions.len() {
        return Ok(Growth::None);
    }
    let mut press = constraint.close(|k| system.closing[k]);
    let elastic = press.load(system);
    let Correction { change, energy } =
        constraint.correct(&press.displacement, elastic, softening, observer)?;
    press.add(&change);
    let mut columns = Vec::with_capacity(motions.len());
    for motion in motions {
        columns.push(moved(problem, solve, &constraint, *motion, softening, observer)?);
    }
    let force = &outcome.state.response.contact.force;
    let moments = Moments::new(system, force, motions);
    let matrix = DMatrix::from_fn(columns.len(), columns.len(), |k, j| moments.rate(k, &columns[j].force));
    let right = DVector::from_fn(columns.len(), |k, _| -moments.rate(k, &press.force));
    let speeds = matrix.lu().solve(&right);
    let held = elastic - energy;
    let stiffness = speeds.map(|speeds| {
        let growth = speeds.iter().zip(&columns).map(|(speed, column)| speed * column.load(system));
        held + growth.sum::<f64>()
    });
    let is_told = |stiffness: &f64| *stiffness > 0.0 && *stiffness < MOST_GROWTH * held;
    Ok(stiffness.filter(is_told).map_or(Growth::NotTold, Growth::Told))
}

/// The change of displacements and contact forces as the mesh moves and the approach stays.
fn moved(
    problem: &Problem,
    solve: &MeshSolve,
    constraint: &ActivePairConstraint<'_>,
    motion: MeshMotion,
    softening: &dyn Fn(&BlockVector) -> BlockVector,
    observer: &mut dyn Observer,
) -> Result<Change, Interrupt> {
    let system = &solve.system;
    let mut displacement = motion.force_rates(solve, observer)?;
    ask(observer)?;
    let mut opening = motion.gap_rates(problem, system);
    for ((body, x), &count) in system.bodies.iter().zip(&mut displacement).zip(&system.bodies_represented) {
        for value in x.iter_mut() {
            *value = -*value;
        }
        body.factor.solve(x);
        ask(observer)?;
        for (g, w) in opening.iter_mut().zip(body.elastic.contact_displacement(x)) {
            *g += count as f64 * w;
        }
    }
    let mut change = constraint.close(|k| -opening[k]);
    add(&mut change.displacement, 1.0, &displacement);
    ask(observer)?;
    let correction = constraint.correct(&change.displacement, 0.0, softening, observer)?;
    change.add(&correction.change);
    Ok(change)
}

/// How the contact force is spread between the ends of the contact that move and the points that do not: its second moment about
/// each of these points, over the nodes from there to the end.
struct Moments<'a> {
    force: &'a [f64],
    /// Of each end, the distance of the nodes from the point that does not move, towards the end \[mm\].
    arms: Vec<Vec<f64>>,
}

impl<'a> Moments<'a> {
    fn new(system: &System, force: &'a [f64], motions: &[MeshMotion]) -> Self {
        let arms =
            |motion: &MeshMotion| system.zone.abscissae().iter().map(|&x| motion.arm(x).max(0.0)).collect();
        Self { force, arms: motions.iter().map(arms).collect() }
    }

    /// By how much the k-th moment over the force there changes, relative to what it is.
    fn rate(&self, k: usize, change: &[f64]) -> f64 {
        let moment = |force: &[f64], order: i32| -> f64 {
            let beyond = force.iter().zip(&self.arms[k]).filter(|(_, arm)| **arm > 0.0);
            beyond.map(|(r, arm)| r * arm.powi(order)).sum()
        };
        moment(change, 2) / moment(self.force, 2) - moment(change, 0) / moment(self.force, 0)
    }
}

/// The same where the load begins to fall and plastic strain stays as it is; the stiffness of the system is the elastic one.
pub(crate) fn unloading(
    system: &System,
    state: &State,
    patch: Option<ContactPatch>,
    observer: &mut dyn Observer,
) -> Result<f64, Interrupt> {
    stiffness(system, state, patch, &|_| system.zeros(), observer)
}

/// The stiffness with the tangent `K - softening` and a contact that does not grow.
fn stiffness(
    system: &System,
    state: &State,
    patch: Option<ContactPatch>,
    softening: &dyn Fn(&BlockVector) -> BlockVector,
    observer: &mut dyn Observer,
) -> Result<f64, Interrupt> {
    let Some(constraint) = ActivePairConstraint::new(system, state) else { return Ok(0.0) };
    let press = constraint.close(|k| system.closing[k]);
    let load = press.load(system);
    let Correction { energy, .. } = constraint.correct(&press.displacement, load, softening, observer)?;
    let correction = patch.map_or(1.0, |patch| edge_correction(system, &constraint.active, patch));
    Ok((load - energy) * correction)
}

/// Part of an element by which active pairs reach beyond the outermost of them. With it the stiffness of elastic
/// cylinders agrees with the slope of their load-approach curve to 0.1 % at 10 to 40 elements over the half-width.
const OVERHANG: f64 = 0.25;

/// By what factor the stiffness of a contact that ends somewhere between two nodes differs from that of its active
/// pairs.
///
/// The stiffness grows in steps as pair after pair comes into contact. Between two steps it is interpolated, by how it
/// would change with one pair more or less; for that the present flexibility is accurate enough.
fn edge_correction(system: &System, active: &[usize], patch: ContactPatch) -> f64 {
    let stiffness = |pairs: &[usize]| -> Option<f64> {
        let factor = DenseCholesky::factor(system.flexibility.principal_block(pairs)).ok()?;
        let closing: Vec<f64> = pairs.iter().map(|&k| system.closing[k]).collect();
        let mut force = closing.clone();
        factor.solve_in_place(&mut force);
        Some(force.iter().zip(closing).map(|(r, e)| r * e).sum())
    };
    let (Some(&first), Some(&last), Some(whole)) = (active.first(), active.last(), stiffness(active)) else {
        return 1.0;
    };
    let zone = &system.zone;
    let share = |beyond: f64| (beyond / zone.spacing() - OVERHANG).clamp(-1.0, 1.0);
    let change =
        |pairs: Vec<usize>, share: f64| stiffness(&pairs).map_or(0.0, |s| share.abs() * (s / whole - 1.0));
    let mut correction = 1.0;
    let right = share(patch.right - zone.abscissa(last));
    if right >= 0.0 && last < zone.columns() {
        correction += change(active.iter().copied().chain([last + 1]).collect(), right);
    } else if right < 0.0 && active.len() > 2 {
        correction += change(active[..active.len() - 1].to_vec(), right);
    }
    if !zone.is_symmetric() {
        let left = share(zone.abscissa(first) - patch.left);
        if left >= 0.0 && first > 0 {
            correction += change(std::iter::once(first - 1).chain(active.iter().copied()).collect(), left);
        } else if left < 0.0 && active.len() > 2 {
            correction += change(active[1..].to_vec(), left);
        }
    }
    correction
}
