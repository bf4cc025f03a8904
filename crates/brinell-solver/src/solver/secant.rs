//! Secant stiffness: the stiffness is reassembled with the secant moduli of the last state, factorized again
//! and condensed to a new flexibility in every iteration. The paper's rival method.

use super::SolveError;
use super::body::BodyModel;
use super::elastic_body::refactor;
use super::iteration::{Iteration, Outcome, State};
use super::phases::Phase;
use super::system::{Response, total_flexibility};
use crate::contact::ContactProblem;
use crate::fem::assembly::StressField;
use sparse_cholesky::Cholesky;
use sparse_cholesky::dense::SymmetricMatrix;

pub(super) fn run(mut iteration: Iteration<'_>) -> Result<Outcome, SolveError> {
    let system = iteration.system;
    // The elastic factors are there already.
    let mut factors: Vec<Cholesky> = system.bodies.iter().map(|body| body.factor.clone()).collect();
    let mut start = system.zeros();
    loop {
        let response = respond(&mut iteration, &factors)?;
        let secant = secant_state(&mut iteration, &response);
        if let Some(status) = iteration.record(&start, &response, secant.plastic_points, secant.imbalance) {
            let state = State { response, loads: system.zeros(), factors: Some(factors) };
            return Ok(iteration.finish(state, Some(status)));
        }
        for ((body, field), factor) in system.bodies.iter().zip(&secant.fields).zip(&mut factors) {
            let values = iteration.phases.time(Phase::Assembly, iteration.observer, || {
                body.elastic.stiffness_with(|element| field.secant_shear(element))
            });
            // Whole, as in the paper: what is compared are methods, not what this factorization knows from last time.
            factor.forget();
            let refactored = iteration.phases.time_observed(Phase::Numeric, iteration.observer, |observer| {
                refactor(factor, values, observer)
            });
            match refactored {
                // What has been iterated is worth keeping.
                Err(SolveError::Interrupted(interrupt)) => {
                    let state = State { response, loads: system.zeros(), factors: None };
                    return Ok(iteration.finish(state, Some(interrupt.into())));
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
    imbalance: f64,
}

fn secant_state(iteration: &mut Iteration<'_>, response: &Response) -> SecantState {
    let system = iteration.system;
    let (mut fields, mut plastic_points, mut squares) = (Vec::new(), 0, 0.0);
    for ((body, x), &copies) in system.bodies.iter().zip(&response.displacement).zip(&system.multiplicity) {
        let nodal = body.elastic.nodal(x);
        let field = iteration.phases.time(Phase::Plasticity, iteration.observer, || {
            StressField::evaluate(&body.elastic.mesh, body.elastic.kinematics(), &body.material, &nodal)
        });
        plastic_points += copies * field.plastic_points();
        squares += copies as f64 * body.imbalance(&field, &response.contact.force).powi(2);
        fields.push(field);
    }
    iteration.count_update();
    SecantState { fields, plastic_points, imbalance: squares.sqrt() }
}

/// Contact and full displacements with the present factors.
fn respond(iteration: &mut Iteration<'_>, factors: &[Cholesky]) -> Result<Response, SolveError> {
    let system = iteration.system;
    let n = system.initial_gap.len();
    let flexibility = iteration.phases.time(Phase::Flexibility, iteration.observer, || {
        let parts: Vec<SymmetricMatrix> = factors.iter().map(|factor| factor.trailing_inverse(n)).collect();
        total_flexibility(n, &parts.iter().collect::<Vec<_>>(), &system.multiplicity)
    });
    let problem = ContactProblem {
        flexibility: &flexibility,
        initial_gap: &system.initial_gap,
        load: iteration.controls.load,
    };
    let contact = iteration.solve_contact(&problem)?;
    let displacement = iteration.phases.time(Phase::Solves, iteration.observer, || {
        let solve = |(body, factor): (&BodyModel, &Cholesky)| {
            let mut x = body.elastic.zeros();
            body.elastic.press(&contact.force, &mut x);
            factor.solve(&mut x);
            x
        };
        system.bodies.iter().zip(factors).map(solve).collect()
    });
    Ok(Response { displacement, contact })
}
