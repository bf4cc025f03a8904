//! Secant stiffness: the stiffness is reassembled with the secant moduli of the last state, factorized again
//! and condensed to a new flexibility in every iteration. The paper's rival method.

use super::Coupling;
use crate::contact::ContactProblem;
use crate::fem::assembly::StressField;
use crate::solver::SolveError;
use crate::solver::body_system::body::BodyModel;
use crate::solver::body_system::elastic_body::refactor;
use crate::solver::body_system::system::{Response, total_flexibility};
use crate::solver::couplings::iteration::{Iteration, Outcome, State};
use crate::solver::phases::Phase;
use sparse_cholesky::Cholesky;
use sparse_cholesky::dense::SymmetricMatrix;

/// The stiffness takes the secant moduli of each iterate.
pub(crate) struct SecantStiffness;

impl Coupling for SecantStiffness {
    fn iterate(&self, iteration: Iteration<'_>) -> Result<Outcome, SolveError> {
        run(iteration)
    }

    fn needs_whole_body(&self) -> bool {
        true
    }
}

fn run(mut iteration: Iteration<'_>) -> Result<Outcome, SolveError> {
    let system = iteration.system;
    // The elastic factors are there already.
    let mut factors: Vec<Cholesky> = system.bodies.iter().map(|body| body.factor.clone()).collect();
    let mut start = system.zeros();
    loop {
        let response = solve_equilibrium(&mut iteration, &factors)?;
        let secant = secant_state(&mut iteration, &response);
        if let Some(status) = iteration.record(&start, &response, secant.plastic_points, secant.residual_norm)
        {
            let state = State { response, loads: system.zeros(), factors: Some(factors) };
            return iteration.finish(state, Some(status));
        }
        for ((body, field), factor) in system.bodies.iter().zip(&secant.fields).zip(&mut factors) {
            let values = iteration.phases.time(Phase::Assembly, iteration.observer, || {
                body.elastic.stiffness_with(|element| field.secant_shear(element))
            });
            // Factorized whole, as in the paper: the comparison is between methods, without partial refactorization.
            factor.invalidate();
            let refactored = iteration.phases.time_observed(Phase::Numeric, iteration.observer, |observer| {
                refactor(factor, values, observer)
            });
            match refactored {
                // The iterations so far are kept.
                Err(SolveError::Interrupted(interrupt)) => {
                    let state = State { response, loads: system.zeros(), factors: None };
                    return iteration.finish(state, Some(interrupt.into()));
                }
                refactored => refactored?,
            }
        }
        start = response.displacement;
        iteration.count_factorizations();
    }
}

/// What the plastic law says of a response.
struct SecantState {
    fields: Vec<StressField>,
    plastic_points: usize,
    residual_norm: f64,
}

fn secant_state(iteration: &mut Iteration<'_>, response: &Response) -> SecantState {
    let system = iteration.system;
    let (mut fields, mut plastic_points, mut squares) = (Vec::new(), 0, 0.0);
    for ((body, x), &copies) in
        system.bodies.iter().zip(&response.displacement).zip(&system.bodies_represented)
    {
        let nodal = body.elastic.nodal(x);
        let field =
            iteration.phases.time(Phase::Plasticity, iteration.observer, || body.stress_field(&nodal));
        plastic_points += copies * field.plastic_points();
        squares += copies as f64 * body.residual_norm(&field, &response.contact.force).powi(2);
        fields.push(field);
    }
    iteration.count_update();
    SecantState { fields, plastic_points, residual_norm: squares.sqrt() }
}

/// Contact and full displacements with the present factors.
fn solve_equilibrium(iteration: &mut Iteration<'_>, factors: &[Cholesky]) -> Result<Response, SolveError> {
    let system = iteration.system;
    let n = system.initial_gap.len();
    let flexibility = iteration.phases.time(Phase::Flexibility, iteration.observer, || {
        let bodies = system.bodies.iter().zip(factors);
        let parts: Vec<SymmetricMatrix> =
            bodies.map(|(body, factor)| body.elastic.flexibility(factor)).collect();
        total_flexibility(n, &parts.iter().collect::<Vec<_>>(), &system.bodies_represented)
    });
    let problem = ContactProblem {
        flexibility: &flexibility,
        ..system.contact_problem(&system.initial_gap, iteration.controls.load)
    };
    let contact = iteration.solve_contact(&problem)?;
    let displacement = iteration.phases.time(Phase::Solves, iteration.observer, || {
        let solve = |(body, factor): (&BodyModel, &Cholesky)| {
            let mut x = body.elastic.zeros();
            body.elastic.add_contact_forces(&contact.force, &mut x);
            factor.solve(&mut x);
            x
        };
        system.bodies.iter().zip(factors).map(solve).collect()
    });
    Ok(Response { displacement, contact })
}
