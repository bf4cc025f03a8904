//! Secant stiffness: the stiffness is reassembled with the secant moduli of the last state,
//! factorized again and condensed to a new flexibility in every iteration. The paper's rival
//! method.

use super::Coupling;
use crate::Error;
use crate::contact_system::{PlasticAnswer, Response};
use crate::couplings::iteration::{Iteration, Outcome, State};
use crate::observer::Interrupt;

/// The stiffness takes the secant moduli of each iterate.
pub struct SecantStiffness;

impl Coupling for SecantStiffness {
    fn iterate(&self, iteration: Iteration<'_>) -> Result<Outcome, Error> {
        run(iteration)
    }

    fn needs_whole_body(&self) -> bool {
        true
    }
}

fn run(mut iteration: Iteration<'_>) -> Result<Outcome, Error> {
    let system = iteration.system;
    let mut stiffness = system.secant_stiffness().ok_or(Error::NoSecantStiffness)?;
    let mut previous: Option<Response> = None;
    loop {
        let state = iteration.secant_equilibrium(&*stiffness).and_then(|response| {
            let answer = stiffness.evaluate(&response, &mut iteration.run)?;
            Ok((response, answer))
        });
        let (response, PlasticAnswer { plastic_points, residual_norm }) = match state {
            Err(Error::Interrupted(interrupt)) => {
                return stop(iteration, previous.ok_or(Error::Interrupted(interrupt))?, interrupt);
            }
            state => state?,
        };
        iteration.count_update();
        let zeros = system.zeros();
        let start = previous.as_ref().map_or(&zeros, |previous| &previous.displacement);
        if let Some(status) = iteration.record(start, &response, plastic_points, residual_norm) {
            return iteration
                .finish(State { response, loads: zeros, is_complete: true }, Some(status));
        }
        // Factorized whole, as in the paper: the comparison is between methods, without partial
        // refactorization.
        match stiffness.renew(&mut iteration.run) {
            Err(Error::Interrupted(interrupt)) => return stop(iteration, response, interrupt),
            renewed => iteration.count_factorizations(renewed?),
        }
        previous = Some(response);
    }
}

/// Ends with the iterations made so far.
fn stop(
    iteration: Iteration<'_>,
    response: Response,
    interrupt: Interrupt,
) -> Result<Outcome, Error> {
    let loads = iteration.system.zeros();
    iteration.finish(State { response, loads, is_complete: true }, Some(interrupt.into()))
}
