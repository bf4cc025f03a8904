//! Secant stiffness: the stiffness is reassembled with the secant moduli of the last state, factorized again
//! and condensed to a new flexibility in every iteration. The paper's rival method.

use super::Coupling;
use crate::contact::ContactProblem;
use crate::fem::assembly::StressField;
use crate::solver::body_system::elastic_body::refactor;
use crate::solver::body_system::system::{Response, total_flexibility};
use crate::solver::couplings::iteration::{Iteration, Outcome, State};
use crate::solver::phases::Phase;
use crate::solver::{Interrupt, SolveError};
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
    let mut factors = None;
    let mut previous: Option<Response> = None;
    loop {
        let (response, secant) = match next_state(&mut iteration, factors.as_deref()) {
            Err(SolveError::Interrupted(interrupt)) => {
                return stop(iteration, previous.ok_or(SolveError::Interrupted(interrupt))?, interrupt);
            }
            state => state?,
        };
        let zeros = system.zeros();
        let start = previous.as_ref().map_or(&zeros, |previous| &previous.displacement);
        if let Some(status) = iteration.record(start, &response, secant.plastic_points, secant.residual_norm)
        {
            return iteration.finish(State { response, loads: zeros, factors }, Some(status));
        }
        // Factorized whole, as in the paper: the comparison is between methods, without partial refactorization.
        let empty = || system.bodies.iter().map(|body| Cholesky::empty(body.factor.symbolic())).collect();
        let factors = factors.get_or_insert_with(empty);
        match factorize(&mut iteration, &secant.fields, factors) {
            Err(SolveError::Interrupted(interrupt)) => return stop(iteration, response, interrupt),
            factorized => factorized?,
        }
        previous = Some(response);
        iteration.count_factorizations();
    }
}

/// Ends with the iterations made so far. The factors may be half done.
fn stop(iteration: Iteration<'_>, response: Response, interrupt: Interrupt) -> Result<Outcome, SolveError> {
    let loads = iteration.system.zeros();
    iteration.finish(State { response, loads, factors: None }, Some(interrupt.into()))
}

/// Makes the factors those of the secant stiffness of a state.
fn factorize(
    iteration: &mut Iteration<'_>,
    fields: &[StressField],
    factors: &mut [Cholesky],
) -> Result<(), SolveError> {
    for ((body, field), factor) in iteration.system.bodies.iter().zip(fields).zip(factors) {
        let values = iteration
            .run
            .time(Phase::Assembly, || body.elastic.stiffness_with(|element| field.secant_shear(element)));
        factor.invalidate();
        iteration.run.time_observed(Phase::Numeric, |observer| refactor(factor, values, observer))?;
    }
    Ok(())
}

/// What the plastic law says of a response.
struct SecantState {
    fields: Vec<StressField>,
    plastic_points: usize,
    residual_norm: f64,
}

/// Contact and displacements with the present factors, and what the plastic law says of them.
fn next_state(
    iteration: &mut Iteration<'_>,
    factors: Option<&[Cholesky]>,
) -> Result<(Response, SecantState), SolveError> {
    let response = solve_equilibrium(iteration, factors)?;
    let secant = secant_state(iteration, &response)?;
    Ok((response, secant))
}

fn secant_state(iteration: &mut Iteration<'_>, response: &Response) -> Result<SecantState, SolveError> {
    let system = iteration.system;
    let (mut fields, mut plastic_points, mut squares) = (Vec::new(), 0, 0.0);
    for ((body, x), &copies) in
        system.bodies.iter().zip(&response.displacement).zip(&system.bodies_represented)
    {
        iteration.run.checkpoint()?;
        let nodal = body.elastic.nodal(x);
        let field = iteration.run.time(Phase::Plasticity, || body.stress_field(&nodal));
        plastic_points += copies * field.plastic_points();
        squares += copies as f64 * body.residual_norm(&field, &response.contact.force).powi(2);
        fields.push(field);
    }
    iteration.count_update();
    Ok(SecantState { fields, plastic_points, residual_norm: squares.sqrt() })
}

/// Contact and full displacements with the present factors, at first those of the elastic bodies.
fn solve_equilibrium(
    iteration: &mut Iteration<'_>,
    factors: Option<&[Cholesky]>,
) -> Result<Response, SolveError> {
    let system = iteration.system;
    let n = system.initial_gap.len();
    let factor_of = |k: usize| factors.map_or(&*system.bodies[k].factor, |factors| &factors[k]);
    let mut parts: Vec<SymmetricMatrix> = Vec::with_capacity(system.bodies.len());
    for (k, body) in system.bodies.iter().enumerate() {
        iteration.run.checkpoint()?;
        parts.push(iteration.run.time(Phase::Flexibility, || body.elastic.flexibility(factor_of(k))));
    }
    let flexibility = iteration.run.time(Phase::Flexibility, || {
        total_flexibility(n, &parts.iter().collect::<Vec<_>>(), &system.bodies_represented)
    });
    let problem = ContactProblem {
        flexibility: &flexibility,
        ..system.contact_problem(&system.initial_gap, iteration.controls.load)
    };
    let contact = iteration.solve_contact(&problem)?;
    let mut displacement = Vec::with_capacity(system.bodies.len());
    for (k, body) in system.bodies.iter().enumerate() {
        iteration.run.checkpoint()?;
        displacement.push(iteration.run.time(Phase::Solves, || {
            let mut x = body.elastic.zeros();
            body.elastic.add_contact_forces(&contact.force, &mut x);
            factor_of(k).solve(&mut x);
            x
        }));
    }
    Ok(Response { displacement, contact })
}
