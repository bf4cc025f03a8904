//! Weak coupling: plasticity is converged at fixed contact forces between contact solves.
//!
//! Without relaxation this iteration diverges once the elastic peak pressure exceeds about three
//! yield stresses: the contact overreacts to each plastic displacement, and the next one turns
//! back. The displacement that the contact sees is therefore relaxed, `u_p ← u_p + ω (u_p* -
//! u_p)`, with Aitken's factor `ω ← -ω rᵀΔr / ‖Δr‖²`, `r = u_p* - u_p`.
//!
//! # Reference
//! B. M. Irons, R. C. Tuck, *A version of the Aitken accelerator for computer iteration*, Int. J.
//! Numer. Meth. Engng 1 (1969) 275–277.

use super::Coupling;
use crate::Error;
use crate::contact_system::{BlockVector, Response};
use crate::couplings::anderson::Anderson;
use crate::couplings::iteration::{Iteration, Outcome, State, norm};
use crate::observer::SolveStatus;
use crate::phases::Phase;

const FIRST_FACTOR: f64 = 0.3;
const SMALLEST_FACTOR: f64 = 0.02;
/// Initial-stress updates of all alternations at most. Five yield stresses take about 400.
const MAX_UPDATES: usize = 1500;
/// Initial-stress updates within one alternation at most.
const MAX_INNER: usize = 200;
/// Alternations whose plastic iteration may fail to converge because the contact forces exceed the
/// strength of the bodies.
const MAX_UNSETTLED: usize = 2;
/// Displacement change that ends the plastic iteration, over the 3/2-th power of that of the
/// alternation.
const INNER_ACCURACY: f64 = 0.003;
/// Least value of the same change over the tolerance. The contact amplifies the change that is
/// left several times.
const INNER_FLOOR: f64 = 0.01;
/// Out-of-balance force over the contact force that goes with that change.
const BALANCE: f64 = 100.0;

/// Plasticity is converged between contact solves.
pub struct Weak;

impl Coupling for Weak {
    fn iterate(&self, iteration: Iteration<'_>) -> Result<Outcome, Error> {
        run(iteration)
    }
}

fn run(mut iteration: Iteration<'_>) -> Result<Outcome, Error> {
    let system = iteration.system;
    let mut relaxation = Aitken::new(system.initial_gap().len());
    let (mut start, mut loads) = iteration.initial_state();
    let mut unsettled = 0;
    loop {
        let contact = iteration.contact(relaxation.value())?;
        let displacement = iteration.displacement(&loads, &contact.force);
        let mut response = Response { displacement, contact };
        let Plasticity { mut plastic_points, mut residual_norm, is_settled } =
            converge_plasticity(&mut iteration, &start, &mut response, &mut loads);
        unsettled += usize::from(!is_settled);
        // Elastic so far, but the contact has not seen u_p; or settled.
        let may_end = (residual_norm == 0.0 && system.gap_opening(&loads) != relaxation.value())
            || iteration.displacement_change(&start, &response.displacement)
                <= iteration.controls.tolerance;
        if may_end {
            // The contact has answered a relaxed displacement so far; let it answer the true one
            // before anything is called converged.
            response = iteration.solve_equilibrium(&loads)?;
            let mut image = system.zeros();
            plastic_points = iteration.initial_stress(&response.displacement, &mut image);
            residual_norm = system.distance(&image, &loads);
        }
        if let Some(status) = iteration.record(&start, &response, plastic_points, residual_norm) {
            return iteration.finish(State { response, loads, is_complete: false }, Some(status));
        }
        if iteration.updates() > MAX_UPDATES || unsettled > MAX_UNSETTLED {
            let state = State { response, loads, is_complete: false };
            return iteration.finish(state, Some(SolveStatus::NotConverged));
        }
        start = response.displacement;
        relaxation.advance(&system.gap_opening(&loads));
    }
}

/// The result of the plastic iteration at fixed contact forces.
#[derive(Default)]
struct Plasticity {
    /// Points beyond yield.
    plastic_points: usize,
    /// Out-of-balance force \[N/mm\].
    residual_norm: f64,
    /// Whether the plastic iteration has converged.
    is_settled: bool,
}

/// Initial-stress iteration at fixed contact forces, accelerated like the strong coupling. On
/// return displacements, forces and loads are in elastic equilibrium.
///
/// `alternation` are the displacements at the start of the alternation. The tolerance of this
/// iteration falls with the movement of the contact since then, so that Aitken's factor compares
/// converged states.
fn converge_plasticity(
    iteration: &mut Iteration<'_>,
    alternation: &BlockVector,
    response: &mut Response,
    loads: &mut BlockVector,
) -> Plasticity {
    let system = iteration.system;
    let moved = iteration.displacement_change(alternation, &response.displacement);
    let floor = INNER_FLOOR * iteration.controls.tolerance;
    let sufficient = (INNER_ACCURACY * moved.min(1.0).powf(1.5)).max(floor);
    let mut anderson = Anderson::default();
    let mut start = response.displacement.clone();
    let mut image = system.zeros();
    let mut state = Plasticity::default();
    for _ in 0..MAX_INNER {
        // A request to stop takes effect when the iteration is recorded.
        if iteration.run.observer.on_checkpoint().is_break() {
            break;
        }
        iteration.initial_stress(&start, loads);
        iteration.count_update();
        response.displacement = iteration.displacement(loads, &response.contact.force);
        state.plastic_points = iteration.initial_stress(&response.displacement, &mut image);
        state.residual_norm =
            iteration.run.time(Phase::Plasticity, || system.distance(&image, loads));
        let change = iteration.displacement_change(&start, &response.displacement);
        let balanced = state.residual_norm <= BALANCE * sufficient * norm(&response.contact.force);
        if change <= sufficient && balanced {
            state.is_settled = true;
            break;
        }
        iteration.run.time(Phase::Plasticity, || {
            let next = anderson.next(&system.pack(&start), system.pack(&response.displacement));
            system.unpack(&next, &mut start);
        });
    }
    state
}

/// A vector that follows a target with Aitken's relaxation.
struct Aitken {
    value: Vec<f64>,
    factor: f64,
    last_residual: Option<Vec<f64>>,
}

impl Aitken {
    fn new(n: usize) -> Self {
        Self { value: vec![0.0; n], factor: FIRST_FACTOR, last_residual: None }
    }

    fn value(&self) -> &[f64] {
        &self.value
    }

    fn advance(&mut self, target: &[f64]) {
        let residual: Vec<f64> = target.iter().zip(&self.value).map(|(t, v)| t - v).collect();
        if let Some(last) = &self.last_residual {
            let (mut product, mut square) = (0.0, 0.0);
            for (new, old) in residual.iter().zip(last) {
                product += old * (new - old);
                square += (new - old).powi(2);
            }
            if square > 0.0 {
                self.factor = (-self.factor * product / square).clamp(SMALLEST_FACTOR, 1.0);
            }
        }
        for (value, r) in self.value.iter_mut().zip(&residual) {
            *value += self.factor * r;
        }
        self.last_residual = Some(residual);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn relaxation_finds_the_fixed_point_of_a_diverging_map() {
        // x = 3 - 1.8 x oscillates and diverges by itself; its fixed point is 3 / 2.8.
        let mut aitken = Aitken::new(1);
        for _ in 0..6 {
            let target = [3.0 - 1.8 * aitken.value()[0]];
            aitken.advance(&target);
        }
        assert!((aitken.value()[0] - 3.0 / 2.8).abs() < 1e-12);
    }
}
