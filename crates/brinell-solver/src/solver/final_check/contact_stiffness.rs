//! Contact stiffness: the slope dP/dα of the load-approach curve at an answer.
//!
//! With the tangent stiffness K_T of the answer and its set of pairs in contact, the displacements v that go with
//! `dα = 1` are those of the least energy `v·K_T v` that close every active pair by its cosine e to the approach, mostly 1, and
//! that energy is dP/dα.
//! Conjugate gradients find it with the factor K that is there already as preconditioner. K_T itself is not formed:
//! `(K - K_T) v` is the derivative of the initial-stress load in the direction of v.

use crate::solver::body_system::system::{BlockVector, System};
use crate::solver::couplings::iteration::State;
use crate::solver::observer::ask;
use crate::solver::{ContactPatch, Interrupt, Observer};
use sparse_cholesky::dense::DenseCholesky;

/// Steps at most; a factor of the elastic stiffness takes about ten, one of tangent moduli two or three.
const MAX_STEPS: usize = 40;
/// Part of the stiffness that the last step may have changed it by.
const TOLERANCE: f64 = 1e-4;
/// Step of the finite difference, relative to the displacements.
const DIFFERENCE: f64 = 1e-6;

/// dP/dα of both sides of the axis together \[N/mm per mm, or N per mm\]; 0 where nothing touches. The observer can
/// stop it.
pub(crate) fn contact_stiffness(
    system: &System,
    state: &State,
    patch: Option<ContactPatch>,
    observer: &mut dyn Observer,
) -> Result<f64, Interrupt> {
    let tangent = Tangent::new(system, &state.response.displacement);
    ask(observer)?;
    stiffness(system, state, patch, |v| tangent.softening(v), observer)
}

/// The same where the load begins to fall and plastic strain stays as it is; the stiffness of the system is the elastic one.
pub(crate) fn unloading(
    system: &System,
    state: &State,
    patch: Option<ContactPatch>,
    observer: &mut dyn Observer,
) -> Result<f64, Interrupt> {
    stiffness(system, state, patch, |_| system.zeros(), observer)
}

/// The stiffness with the tangent `K - softening`.
fn stiffness(
    system: &System,
    state: &State,
    patch: Option<ContactPatch>,
    softening: impl Fn(&BlockVector) -> BlockVector,
    observer: &mut dyn Observer,
) -> Result<f64, Interrupt> {
    let active: Vec<usize> = state.response.contact.active_set.iter().collect();
    if active.is_empty() {
        return Ok(0.0);
    }
    let block = system.flexibility.principal_block(&active);
    let Ok(factor) = DenseCholesky::factor(block) else { return Ok(0.0) };
    let closing = ActivePairConstraint { system, active, factor };
    let (v, force) = closing.close();
    ask(observer)?;
    let mut residual = softening(&v);
    let along = force.iter().zip(&system.closing).map(|(r, e)| r * e);
    let mut stiffness = along.sum::<f64>() - system.inner(&v, &residual);
    let mut last: Option<(BlockVector, BlockVector, f64)> = None;
    for _ in 0..MAX_STEPS {
        ask(observer)?;
        let mut direction = closing.solve(&residual);
        ask(observer)?;
        let product = system.inner(&residual, &direction);
        // `load` is K times the direction, but for contact forces, which do no work on it.
        let mut load = residual.clone();
        if let Some((last_direction, last_load, last_product)) = &last {
            add(&mut direction, product / last_product, last_direction);
            add(&mut load, product / last_product, last_load);
        }
        let mut tangent_load = load.clone();
        add(&mut tangent_load, -1.0, &softening(&direction));
        let energy = system.inner(&direction, &tangent_load);
        if !(product > 0.0 && energy > 0.0) {
            break;
        }
        let step = product / energy;
        stiffness -= step * product;
        if step * product <= TOLERANCE * stiffness.abs() {
            break;
        }
        add(&mut residual, -step, &tangent_load);
        last = Some((direction, load, product));
    }
    let correction = patch.map_or(1.0, |patch| edge_correction(system, &closing.active, patch));
    Ok(system.symmetry_factor() as f64 * stiffness * correction)
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

/// `a += factor · b`.
fn add(a: &mut BlockVector, factor: f64, b: &BlockVector) {
    for (a, b) in a.iter_mut().flatten().zip(b.iter().flatten()) {
        *a += factor * b;
    }
}

/// Solves with the active pairs tied together.
struct ActivePairConstraint<'a> {
    system: &'a System,
    active: Vec<usize>,
    factor: DenseCholesky,
}

impl ActivePairConstraint<'_> {
    /// The contact forces that close every active pair by its cosine, and the displacements under them.
    fn close(&self) -> (BlockVector, Vec<f64>) {
        let force = self.forces(|k| self.system.closing[k]);
        (self.system.substitute(self.system.zeros(), &force), force)
    }

    /// Displacements under loads, with contact forces that keep every active pair as it is.
    fn solve(&self, loads: &BlockVector) -> BlockVector {
        let (forward, gap_opening) = self.system.eliminate(loads);
        self.system.substitute(forward, &self.forces(|k| -gap_opening[k]))
    }

    /// Contact forces of all pairs that close each active one by so much.
    fn forces(&self, closing: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut tied: Vec<f64> = self.active.iter().map(|&k| closing(k)).collect();
        self.factor.solve_in_place(&mut tied);
        let mut force = vec![0.0; self.system.initial_gap.len()];
        for (&k, r) in self.active.iter().zip(tied) {
            force[k] = r;
        }
        force
    }
}

/// The tangent of the initial-stress load at an answer.
struct Tangent<'a> {
    system: &'a System,
    displacement: &'a BlockVector,
    load: BlockVector,
    size: f64,
}

impl<'a> Tangent<'a> {
    fn new(system: &'a System, displacement: &'a BlockVector) -> Self {
        let mut load = system.zeros();
        system.initial_stress(displacement, &mut load);
        Self { system, displacement, load, size: system.norm(displacement) }
    }

    /// `(K - K_T) v`.
    fn softening(&self, v: &BlockVector) -> BlockVector {
        let step = DIFFERENCE * self.size / self.system.norm(v).max(f64::MIN_POSITIVE);
        let mut beyond = self.displacement.clone();
        add(&mut beyond, step, v);
        let mut load = self.system.zeros();
        self.system.initial_stress(&beyond, &mut load);
        add(&mut load, -1.0, &self.load);
        for value in load.iter_mut().flatten() {
            *value /= step;
        }
        load
    }
}
