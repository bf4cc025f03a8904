//! The tangent of an answer with its pairs in contact: how displacements and contact forces change where these pairs are closed
//! further.
//!
//! ```text
//! K_T v = C r + p,    v closes every active pair by c
//! ```
//!
//! Conjugate gradients find v and the contact forces r with the factor K that is there already as preconditioner. K_T itself is
//! not formed: `(K - K_T) v` is the derivative of the initial-stress load in the direction of v.

use crate::solver::body_system::system::System;
use crate::solver::method::contact_system::{BlockVector, ContactSystem as _, Linearize as _};
use crate::solver::method::couplings::iteration::State;
use crate::solver::method::observer::ask;
use crate::solver::{Interrupt, Observer};
use dense_cholesky::DenseCholesky;

/// Steps at most; a factor of the elastic stiffness takes about ten, one of tangent moduli two or three.
const MAX_STEPS: usize = 40;
/// Part of the energy that the last step may have changed it by; that leaves stiffnesses wrong by 2e-3 at most, mostly by less than 5e-4.
const TOLERANCE: f64 = 1e-3;
/// Step of the finite difference, relative to the displacements.
const DIFFERENCE: f64 = 1e-6;

/// Displacements on the active equations and the contact forces of all pairs that go with them.
pub(super) struct Change {
    pub displacement: BlockVector,
    pub force: Vec<f64>,
}

impl Change {
    /// Adds another one.
    pub fn add(&mut self, other: &Self) {
        add(&mut self.displacement, 1.0, &other.displacement);
        add_to(&mut self.force, 1.0, &other.force);
    }

    /// The change of the load of the whole contact.
    pub fn load(&self, system: &System) -> f64 {
        system.whole_load(&self.force)
    }
}

/// What has to be added to the answer of the linear bodies, and what that takes from its energy.
pub(super) struct Correction {
    pub change: Change,
    pub energy: f64,
}

/// Solves with the active pairs tied together.
pub(super) struct ActivePairConstraint<'a> {
    pub system: &'a System,
    pub active: Vec<usize>,
    factor: DenseCholesky,
}

impl<'a> ActivePairConstraint<'a> {
    /// `None` where nothing touches.
    pub fn new(system: &'a System, state: &State) -> Option<Self> {
        let active: Vec<usize> = state.response.contact.active_set.iter().collect();
        if active.is_empty() {
            return None;
        }
        let factor = DenseCholesky::factor(system.flexibility.principal_block(&active)).ok()?;
        Some(Self { system, active, factor })
    }

    /// The contact forces of the bodies with the stiffness K that close every active pair by so much, and the displacements
    /// under them.
    pub fn close(&self, closing: impl Fn(usize) -> f64) -> Change {
        let force = self.forces(closing);
        Change { displacement: self.system.substitute(self.system.zeros(), &force), force }
    }

    /// Displacements of these bodies under loads on the active equations, with contact forces that keep every active pair as it
    /// is.
    fn solve(&self, loads: &BlockVector) -> Change {
        let (forward, gap_opening) = self.system.eliminate(loads);
        let force = self.forces(|k| -gap_opening[k]);
        Change { displacement: self.system.substitute(forward, &force), force }
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

    /// What the tangent `K - softening` adds to displacements v that solve the same equations with K. Steps end that take less
    /// than a small part of `scale` from the energy. The observer can stop it.
    pub fn correct(
        &self,
        v: &BlockVector,
        scale: f64,
        softening: &dyn Fn(&BlockVector) -> BlockVector,
        observer: &mut dyn Observer,
    ) -> Result<Correction, Interrupt> {
        let system = self.system;
        let mut change = Change { displacement: system.zeros(), force: vec![0.0; system.initial_gap.len()] };
        ask(observer)?;
        let mut residual = softening(v);
        let mut energy = system.work(v, &residual);
        let mut last: Option<(Change, BlockVector, f64)> = None;
        for _ in 0..MAX_STEPS {
            ask(observer)?;
            let mut direction = self.solve(&residual);
            ask(observer)?;
            let product = system.work(&residual, &direction.displacement);
            // `load` is K times the direction, but for contact forces, which do no work on it.
            let mut load = residual.clone();
            if let Some((last_direction, last_load, last_product)) = &last {
                let factor = product / last_product;
                add(&mut direction.displacement, factor, &last_direction.displacement);
                add_to(&mut direction.force, factor, &last_direction.force);
                add(&mut load, factor, last_load);
            }
            let mut tangent_load = load.clone();
            add(&mut tangent_load, -1.0, &softening(&direction.displacement));
            let curvature = system.work(&direction.displacement, &tangent_load);
            if !(product > 0.0 && curvature > 0.0) {
                break;
            }
            let step = product / curvature;
            energy += step * product;
            add(&mut change.displacement, step, &direction.displacement);
            add_to(&mut change.force, step, &direction.force);
            if step * product <= TOLERANCE * (scale - energy).abs() {
                break;
            }
            add(&mut residual, -step, &tangent_load);
            last = Some((direction, load, product));
        }
        Ok(Correction { change, energy })
    }
}

/// `a += factor · b`.
pub(super) fn add(a: &mut BlockVector, factor: f64, b: &BlockVector) {
    for (a, b) in a.iter_mut().zip(b) {
        add_to(a, factor, b);
    }
}

/// `a += factor · b`.
fn add_to(a: &mut [f64], factor: f64, b: &[f64]) {
    for (a, b) in a.iter_mut().zip(b) {
        *a += factor * b;
    }
}

/// The tangent of the initial-stress load at an answer.
pub(super) struct Tangent<'a> {
    system: &'a System,
    displacement: &'a BlockVector,
    load: BlockVector,
    size: f64,
}

impl<'a> Tangent<'a> {
    pub fn new(system: &'a System, displacement: &'a BlockVector) -> Self {
        let mut load = system.zeros();
        system.initial_stress(displacement, &mut load);
        Self { system, displacement, load, size: system.norm(displacement) }
    }

    /// `(K - K_T) v`.
    pub fn softening(&self, v: &BlockVector) -> BlockVector {
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
