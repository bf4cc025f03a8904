//! Two meshed bodies as a contact system of the method.

use crate::engine::body_system::body::BodyModel;
use crate::engine::body_system::secant_bodies::SecantBodies;
use crate::engine::body_system::system::System;
use brinell_contact::{ContactLoad, ContactProblem, ContactSolution, ContactSolver};
use brinell_material::ReferenceModuli;
use brinell_method::contact_system::{
    BlockVector, ContactFigures, ContactSystem, Linearize, Response, SecantStiffness,
};
use brinell_method::phases::Phase;
use brinell_method::run::Run;

impl ContactSystem for System {
    fn zeros(&self) -> BlockVector {
        self.bodies.iter().map(|body| body.elastic.zeros()).collect()
    }

    fn initial_gap(&self) -> &[f64] {
        &self.initial_gap
    }

    /// Of the meshed pairs.
    fn contact_problem<'a>(
        &'a self,
        initial_gap: &'a [f64],
        load: ContactLoad,
    ) -> ContactProblem<'a> {
        let load = match load {
            ContactLoad::Force(force) => ContactLoad::Force(force / self.sides() as f64),
            approach @ ContactLoad::Approach(_) => approach,
        };
        ContactProblem {
            flexibility: &self.flexibility,
            initial_gap,
            closing: &self.closing,
            load,
        }
    }

    fn gap_opening(&self, loads: &BlockVector) -> Vec<f64> {
        let mut gap_opening = vec![0.0; self.initial_gap.len()];
        for ((body, load), count) in self.bodies.iter().zip(loads).zip(&self.bodies_represented) {
            let mut x = load.clone();
            body.factor.solve_restricted(&body.plastic_region.reach, &mut x);
            for (g, w) in gap_opening.iter_mut().zip(body.elastic.contact_displacement(&x)) {
                *g += *count as f64 * w;
            }
        }
        gap_opening
    }

    /// `u = K⁻¹ (P_e + R)` on the active equations.
    fn displacement(&self, loads: &BlockVector, force: &[f64]) -> BlockVector {
        let solve = |(body, load): (&BodyModel, &Vec<f64>)| {
            let mut x = load.clone();
            body.elastic.add_contact_forces(force, &mut x);
            body.factor.solve_restricted(&body.plastic_region.reach, &mut x);
            x
        };
        self.bodies.iter().zip(loads).map(solve).collect()
    }

    /// Both halves of a solve share the forward substitution.
    fn equilibrium(
        &self,
        loads: &BlockVector,
        solver: &dyn ContactSolver,
        load: ContactLoad,
        start: Option<&ContactSolution>,
        run: &mut Run<'_>,
    ) -> Result<Response, brinell_method::Error> {
        let (forward, gap_opening) = run.time(Phase::Solves, || self.eliminate(loads));
        let contact = self.contact(&gap_opening, solver, load, start, run)?;
        let displacement = run.time(Phase::Solves, || self.substitute(forward, &contact.force));
        Ok(Response { displacement, contact })
    }

    fn initial_stress(&self, displacement: &BlockVector, loads: &mut BlockVector) -> usize {
        let evaluate = |(k, body): (usize, &BodyModel)| {
            let points = body
                .plastic_region
                .points
                .as_ref()
                .map_or(0, |points| points.evaluate(&displacement[k], &mut loads[k]));
            points * self.copies(k)
        };
        self.bodies.iter().enumerate().map(evaluate).sum()
    }

    /// `√Σ ‖v‖²` over both bodies on the active equations.
    fn norm(&self, vectors: &BlockVector) -> f64 {
        self.distance_or_norm(vectors, None)
    }

    fn distance(&self, v: &BlockVector, w: &BlockVector) -> f64 {
        self.distance_or_norm(v, Some(w))
    }

    /// The entries on the active equations, one model after the other.
    fn pack(&self, vectors: &BlockVector) -> Vec<f64> {
        let parts = self.bodies.iter().zip(vectors);
        parts
            .flat_map(|(body, v)| {
                body.plastic_region.active_equations.iter().map(|&e| v[e as usize])
            })
            .collect()
    }

    fn unpack(&self, packed: &[f64], vectors: &mut BlockVector) {
        let mut values = packed.iter();
        for (body, v) in self.bodies.iter().zip(vectors) {
            for (&e, value) in body.plastic_region.active_equations.iter().zip(&mut values) {
                v[e as usize] = *value;
            }
        }
    }

    fn figures(&self, contact: &ContactSolution) -> ContactFigures {
        let on_axis = self.sides() == 2 && contact.active_set.contains(0);
        ContactFigures {
            force: self.sides() as f64 * contact.total_force,
            approach: contact.approach,
            peak_pressure: self.peak_pressure(&contact.force),
            pairs: contact.active_set.len() * self.sides() - usize::from(on_axis),
        }
    }

    fn accepted(&self) -> &BlockVector {
        &self.accepted.displacement
    }

    /// On the active equations.
    fn commit(&mut self, displacement: BlockVector) {
        for (body, u) in self.bodies.iter_mut().zip(&displacement) {
            if let Some(points) = &mut body.plastic_region.points {
                points.commit(u);
            }
        }
        self.accepted.displacement = displacement;
    }

    fn linearizable(&mut self) -> Option<&mut dyn Linearize> {
        Some(self)
    }

    fn secant_stiffness(&self) -> Option<Box<dyn SecantStiffness + '_>> {
        Some(Box::new(SecantBodies::new(self)))
    }
}

impl Linearize for System {
    fn linearize(
        &mut self,
        at: Option<(&BlockVector, ReferenceModuli)>,
        run: &mut Run<'_>,
    ) -> Result<(), brinell_method::Error> {
        for (k, body) in self.bodies.iter_mut().enumerate() {
            body.linearize(at.map(|(u, reference)| (u[k].as_slice(), reference)), run)?;
        }
        self.sum_flexibility();
        Ok(())
    }

    fn factorizations(&self) -> usize {
        self.bodies.len()
    }

    fn applied(&self, initial_stress: &BlockVector, force: &[f64]) -> BlockVector {
        let mut applied = initial_stress.clone();
        for (body, load) in self.bodies.iter().zip(&mut applied) {
            body.elastic.add_contact_forces(force, load);
        }
        applied
    }

    fn work(&self, forces: &BlockVector, displacement: &BlockVector) -> f64 {
        let sum = self.bodies.iter().enumerate().map(|(k, body)| {
            let products = body
                .plastic_region
                .active_equations
                .iter()
                .map(|&e| forces[k][e as usize] * displacement[k][e as usize]);
            self.copies(k) as f64 * products.sum::<f64>()
        });
        sum.sum()
    }
}
