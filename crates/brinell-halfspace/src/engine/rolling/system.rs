//! Two bodies on a track as a contact system of the method.
//!
//! An initial stress is `2μ Δε` in the columns that yield \[MPa\], and the "displacements" of the
//! method are the trials T of the stream \[MPa\] (`crate::track`). Their norm is
//! ```text
//! ‖a‖ = h √(Σ h_l/a a:a)      h: width of a column or area of a cell, a: shorter elastic semi-axis
//! ```
//! over the columns that have flowed in this pass. It is a force, on unit thickness of a line,
//! comparable to the forces of the cells in contact, with which the method compares it.

use std::cell::RefCell;
use std::ops::Range;

use crate::Stopped;
use crate::track::{Operators, Outlet, TrackBody, TrackGrid};

use super::design::TrackDesign;
use crate::engine::watch::{never, watched};
use brinell_contact::{ContactLoad, ContactProblem, ContactSolution, ContactSolver, Flexibility};
use brinell_method::contact_system::{BlockVector, ContactFigures, ContactSystem, Response};
use brinell_method::phases::Phase;
use brinell_method::run::Run;

/// Two bodies and the window of columns in which they touch.
pub(super) struct Track<O: Operators<D, R>, const D: usize, const R: usize> {
    pub design: TrackDesign,
    pub grid: TrackGrid,
    pub flexibility: Box<dyn Flexibility>,
    /// Initial gap δ0 \[mm\].
    pub initial_gap: Vec<f64>,
    /// Components of the normals along the approach, all 1.
    pub closing: Vec<f64>,
    /// The bodies that can yield; two equal bodies that roll freely are one.
    pub bodies: RefCell<Vec<TrackBody<O, D, R>>>,
    /// Trials to start the next pass from.
    pub accepted: BlockVector,
    /// States of the bodies at the back of the last pass.
    pub outlets: Vec<Outlet>,
    /// Body and numbers of the columns that began to flow together, in the order in which they
    /// did.
    pub begun: RefCell<Vec<(usize, Range<usize>)>>,
}

impl<O: Operators<D, R>, const D: usize, const R: usize> Track<O, D, R> {
    /// Pressures of contact forces \[MPa\].
    pub fn pressure(&self, force: &[f64]) -> Vec<f64> {
        force.iter().map(|force| force / self.grid.cell_area()).collect()
    }

    /// The approach of a contact. A line has none: that of half-planes depends on the place from
    /// which it is counted.
    pub fn approach(&self, contact: &ContactSolution) -> Option<f64> {
        (!self.grid.is_line()).then_some(contact.approach)
    }

    /// Turns the track round, for a pass that goes back.
    pub fn turn(&mut self) {
        self.bodies.get_mut().iter_mut().for_each(TrackBody::turn);
        self.initial_gap = self.grid.reversed(&self.initial_gap);
    }

    fn scale(&self) -> f64 {
        self.grid.cell_area() / self.design.shorter().sqrt()
    }

    /// `h √(Σ h_l/a a:a)` of packed columns.
    fn norm_of(&self, packed: impl Iterator<Item = f64>) -> f64 {
        self.scale() * packed.map(|value| value * value).sum::<f64>().sqrt()
    }
}

impl<O: Operators<D, R>, const D: usize, const R: usize> ContactSystem for Track<O, D, R> {
    fn zeros(&self) -> BlockVector {
        self.bodies.borrow().iter().map(|body| vec![0.0; body.n_numbers()]).collect()
    }

    fn initial_gap(&self) -> &[f64] {
        &self.initial_gap
    }

    fn contact_problem<'a>(&'a self, gap: &'a [f64], load: ContactLoad) -> ContactProblem<'a> {
        ContactProblem {
            flexibility: &*self.flexibility,
            initial_gap: gap,
            closing: &self.closing,
            load,
        }
    }

    fn gap_opening(&self, initial_stress: &BlockVector) -> Vec<f64> {
        let mut opening = vec![0.0; self.initial_gap.len()];
        for (body, part) in self.bodies.borrow_mut().iter_mut().zip(initial_stress) {
            let done = body.open(part, &mut opening, &mut never);
            debug_assert!(done.is_ok(), "nobody stops it");
        }
        opening
    }

    fn displacement(&self, initial_stress: &BlockVector, force: &[f64]) -> BlockVector {
        self.gap_opening(initial_stress);
        let (pressure, mut trial) = (self.pressure(force), self.zeros());
        for (body, into) in self.bodies.borrow_mut().iter_mut().zip(&mut trial) {
            let done = body.trial(&pressure, into, &mut never);
            debug_assert!(done.is_ok(), "nobody stops it");
        }
        trial
    }

    /// Gap and stress share one transform of the plastic strain.
    fn equilibrium(
        &self,
        initial_stress: &BlockVector,
        solver: &dyn ContactSolver,
        load: ContactLoad,
        start: Option<&ContactSolution>,
        run: &mut Run<'_>,
    ) -> Result<Response, brinell_method::Error> {
        let mut opening = vec![0.0; self.initial_gap.len()];
        watched(run, Phase::Solves, |stop| {
            let mut bodies = self.bodies.borrow_mut();
            bodies
                .iter_mut()
                .zip(initial_stress)
                .try_for_each(|(body, part)| body.open(part, &mut opening, stop))
        })?;
        let contact = self.contact(&opening, solver, load, start, run)?;
        let (pressure, mut displacement) = (self.pressure(&contact.force), self.zeros());
        watched(run, Phase::Solves, |stop| -> Result<(), Stopped> {
            let mut bodies = self.bodies.borrow_mut();
            bodies
                .iter_mut()
                .zip(&mut displacement)
                .try_for_each(|(body, into)| body.trial(&pressure, into, stop))
        })?;
        Ok(Response { displacement, contact })
    }

    fn initial_stress(&self, displacement: &BlockVector, into: &mut BlockVector) -> usize {
        let mut bodies = self.bodies.borrow_mut();
        for (body, (trial, into)) in bodies.iter_mut().zip(displacement.iter().zip(into)) {
            body.flow(trial, into);
        }
        let mut begun = self.begun.borrow_mut();
        for (n, body) in bodies.iter().enumerate() {
            let ends = begun.iter().filter(|(of, _)| *of == n).map(|(_, numbers)| numbers.end);
            let first = ends.max().unwrap_or(0);
            if body.n_flowed() > first {
                begun.push((n, first..body.n_flowed()));
            }
        }
        bodies.iter().flat_map(TrackBody::strains).filter(|strain| **strain > 0.0).count()
    }

    fn norm(&self, v: &BlockVector) -> f64 {
        self.norm_of(self.pack(v).into_iter())
    }

    fn distance(&self, v: &BlockVector, w: &BlockVector) -> f64 {
        let (v, w) = (self.pack(v), self.pack(w));
        self.norm_of(v.into_iter().zip(w).map(|(v, w)| v - w))
    }

    /// The columns that have flowed, in the order in which their flow began: a vector packed
    /// earlier is the beginning of one packed later.
    fn pack(&self, vectors: &BlockVector) -> Vec<f64> {
        let bodies = self.bodies.borrow();
        let of_body = |(body, vector): (&TrackBody<O, D, R>, &Vec<f64>)| {
            let mut packed = Vec::with_capacity(R * body.n_flowed());
            body.pack(vector, &mut packed);
            packed
        };
        let parts: Vec<Vec<f64>> = bodies.iter().zip(vectors).map(of_body).collect();
        let begun = self.begun.borrow();
        begun
            .iter()
            .flat_map(|(n, numbers)| &parts[*n][components::<R>(numbers)])
            .copied()
            .collect()
    }

    fn unpack(&self, packed: &[f64], vectors: &mut BlockVector) {
        let bodies = self.bodies.borrow();
        let empty = |body: &TrackBody<O, D, R>| vec![0.0; R * body.n_flowed()];
        let mut parts: Vec<Vec<f64>> = bodies.iter().map(empty).collect();
        let mut rest = packed;
        for (n, numbers) in self.begun.borrow().iter() {
            let (mine, next) = rest.split_at((R * numbers.len()).min(rest.len()));
            parts[*n][components::<R>(numbers)][..mine.len()].copy_from_slice(mine);
            rest = next;
        }
        for ((body, part), vector) in bodies.iter().zip(&parts).zip(vectors) {
            body.unpack(part, vector);
        }
    }

    fn figures(&self, contact: &ContactSolution) -> ContactFigures {
        let largest = contact.force.iter().copied().fold(0.0, f64::max);
        ContactFigures {
            force: contact.total_force,
            approach: self.approach(contact).unwrap_or(0.0),
            peak_pressure: largest / self.grid.cell_area(),
            pairs: contact.active_set.len(),
        }
    }

    fn accepted(&self) -> &BlockVector {
        &self.accepted
    }

    /// Accepts the pass with these trials. The next pass starts from trials of the same path,
    /// behind the residual stress that this one leaves.
    fn commit(&mut self, displacement: BlockVector) {
        let mut increment = self.zeros();
        self.initial_stress(&displacement, &mut increment);
        self.accepted = displacement;
        self.outlets.clear();
        let bodies = self.bodies.get_mut().iter_mut();
        for (body, (increment, trial)) in bodies.zip(increment.iter().zip(&mut self.accepted)) {
            self.outlets.push(body.accept(increment, trial));
            body.begin(&vec![0.0; increment.len()]);
        }
        self.begun.get_mut().clear();
    }
}

/// Numbers of columns in a packed vector.
const fn components<const R: usize>(columns: &Range<usize>) -> Range<usize> {
    R * columns.start..R * columns.end
}
