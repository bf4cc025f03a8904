//! The bodies with secant moduli, which are assembled and factorized anew for every state.

use crate::assembly::{Extent, StressField};
use crate::engine::body_system::elastic_body::refactor;
use crate::engine::body_system::system::{System, total_flexibility};
use brinell_contact::{ContactLoad, ContactProblem, ContactSolution, ContactSolver};
use brinell_method::contact_system::{
    ContactSystem as _, PlasticAnswer, Response, SecantStiffness,
};
use brinell_method::phases::Phase;
use brinell_method::run::Run;
use dense_cholesky::SymmetricMatrix;
use sparse_cholesky::Cholesky;

/// A system with other factors than its own.
pub(crate) struct SecantBodies<'a> {
    system: &'a System,
    /// Empty while the stiffness is the elastic one of the system.
    factors: Vec<Cholesky>,
    /// Stresses of the last state in each model.
    fields: Vec<StressField>,
}

impl<'a> SecantBodies<'a> {
    pub fn new(system: &'a System) -> Self {
        Self { system, factors: Vec::new(), fields: Vec::new() }
    }

    fn factor(&self, model: usize) -> &Cholesky {
        self.factors.get(model).unwrap_or(&self.system.bodies[model].factor)
    }
}

impl SecantStiffness for SecantBodies<'_> {
    fn equilibrium(
        &self,
        solver: &dyn ContactSolver,
        load: ContactLoad,
        start: Option<&ContactSolution>,
        run: &mut Run<'_>,
    ) -> Result<Response, brinell_method::Error> {
        let system = self.system;
        let mut parts: Vec<SymmetricMatrix> = Vec::with_capacity(system.bodies.len());
        for (k, body) in system.bodies.iter().enumerate() {
            run.checkpoint()?;
            parts.push(run.time(Phase::Flexibility, || body.elastic.flexibility(self.factor(k))));
        }
        let flexibility = run.time(Phase::Flexibility, || {
            let parts: Vec<_> = parts.iter().collect();
            total_flexibility(system.initial_gap.len(), &parts, &system.bodies_represented)
        });
        let problem = ContactProblem {
            flexibility: &flexibility,
            ..system.contact_problem(&system.initial_gap, load)
        };
        let contact = run.solve_contact(solver, &problem, start)?;
        let mut displacement = Vec::with_capacity(system.bodies.len());
        for (k, body) in system.bodies.iter().enumerate() {
            run.checkpoint()?;
            displacement.push(run.time(Phase::Solves, || {
                let mut x = body.elastic.zeros();
                body.elastic.add_contact_forces(&contact.force, &mut x);
                self.factor(k).solve(&mut x);
                x
            }));
        }
        Ok(Response { displacement, contact })
    }

    fn evaluate(
        &mut self,
        response: &Response,
        run: &mut Run<'_>,
    ) -> Result<PlasticAnswer, brinell_method::Error> {
        let system = self.system;
        let (mut plastic_points, mut squares) = (0, 0.0);
        self.fields.clear();
        for (k, (body, x)) in system.bodies.iter().zip(&response.displacement).enumerate() {
            run.checkpoint()?;
            let field = run.time(Phase::Plasticity, || {
                body.stress_field(&body.elastic.nodal(x), Extent::Body)
            });
            plastic_points += system.copies(k) * field.plastic_points();
            let copies = system.bodies_represented[k] as f64;
            squares += copies * body.residual_norm(&field, &response.contact.force).powi(2);
            self.fields.push(field);
        }
        Ok(PlasticAnswer { plastic_points, residual_norm: squares.sqrt() })
    }

    fn renew(&mut self, run: &mut Run<'_>) -> Result<usize, brinell_method::Error> {
        let bodies = &self.system.bodies;
        if self.factors.is_empty() {
            self.factors =
                bodies.iter().map(|body| Cholesky::empty(body.factor.symbolic())).collect();
        }
        for ((body, field), factor) in bodies.iter().zip(&self.fields).zip(&mut self.factors) {
            let values = run.time(Phase::Assembly, || {
                body.elastic.stiffness_with(|element| field.secant_shear(element))
            });
            factor.invalidate();
            run.time_observed(Phase::Numeric, |observer| refactor(factor, values, observer))?;
        }
        Ok(bodies.len())
    }
}
