//! Newton's method with a line search, for loads under which the accelerated coupling stalls.
//!
//! Deformation theory has a potential. Under a force P the displacements u of both bodies and the
//! approach α make
//!
//! ```text
//! Π(u, α) = Σ ∫ W(ε(u)) dV - P α      smallest over all  δ = δ0 + w(u) - α >= 0
//! ```
//!
//! (without the last term under a prescribed α), and W is convex because no law softens. One step
//! linearizes at u and solves the contact problem of that linear body: its answer (u*, α*) is the
//! minimum of a quadratic model of Π under the same conditions. So Π falls from u towards u*,
//! every point on the way satisfies the conditions, and
//!
//! ```text
//! φ'(t) = f(u + t d)·d - P (α* - α),   d = u* - u,   f(u) = Σ ∫ Bᵀ σ(ε(u)) dV
//! ```
//!
//! rises along it. The step goes to u*, or to where φ' is about zero if it is clearly positive
//! there. That converges from any start and for any moduli that are not too soft; with tangent
//! moduli it is quadratic in the end.

use super::iteration::{Controls, InitialState, Iteration, Outcome, State};
use crate::Error;
use crate::contact_system::{BlockVector, Linearize};
use crate::observer::SolveStatus;
use crate::run::Run;
use brinell_contact::ContactLoad;
use brinell_material::ReferenceModuli;

/// Steps at most. Each costs a factorization.
const MAX_STEPS: usize = 60;
/// Part of the first slope of the potential that may be left at the end of a step, and of the last
/// out-of-balance force where a step is to be taken as it is.
const SLOPE_LEFT: f64 = 0.5;
/// Points tried along a step.
const MAX_TRIALS: usize = 10;
/// The farthest a step is extended.
const LONGEST: f64 = 30.0;
/// Steps below the first length show too soft moduli, above the second too stiff ones.
const SHORT: f64 = 0.2;
const LONG: f64 = 2.0;
/// Share of the secant moduli that the moduli keep in every direction, initially and at least.
const STIFFENING: f64 = 1e-3;
const LEAST_STIFFENING: f64 = 1e-5;

/// Continues from the last state of another iteration.
///
/// # Errors
/// Those of a contact solve or a factorization.
pub fn run(
    system: &mut dyn Linearize,
    controls: Controls<'_>,
    from: Outcome,
    run: &mut Run<'_>,
) -> Result<Outcome, Error> {
    let mut outcome = from;
    let mut point = Point::of(system, &outcome.state);
    let mut stiffening = STIFFENING;
    for _ in 0..MAX_STEPS {
        match linearize(system, &point.displacement, &mut stiffening, run) {
            // The iterations made so far are kept.
            Err(Error::Interrupted(interrupt)) => {
                return Ok(Outcome { status: interrupt.into(), ..outcome });
            }
            linearized => linearized?,
        }
        let initial = InitialState {
            displacement: Some(point.displacement.clone()),
            factorizations: system.factorizations(),
            contact: Some(outcome.state.response.contact),
            history: outcome.history,
        };
        let mut iteration = Iteration::new(&*system, controls, initial, run.reborrow());
        let (start, loads) = iteration.initial_state();
        let response = iteration.solve_equilibrium(&loads)?;
        iteration.count_update();
        let mut image = system.zeros();
        let plastic_points = iteration.initial_stress(&response.displacement, &mut image);
        let residual_norm = system.distance(&image, &loads);
        let status = iteration.record(&start, &response, plastic_points, residual_norm);
        let state = State { response, loads, is_complete: false };
        if status.is_some() || iteration.has_diverged() {
            return iteration.finish(state, status.or(Some(SolveStatus::NotConverged)));
        }
        let share = point.advance(&*system, &mut iteration, &state, &image, residual_norm);
        stiffening = if share < SHORT {
            (10.0 * stiffening).min(1.0)
        } else if share > LONG || stiffening > STIFFENING {
            (0.1 * stiffening).max(LEAST_STIFFENING)
        } else {
            stiffening
        };
        outcome = iteration.finish(state, None)?;
    }
    Ok(outcome)
}

/// Factorizes with the moduli of a point plus a share of the secant moduli. The share grows where
/// rounding makes the stiffness indefinite.
fn linearize(
    system: &mut dyn Linearize,
    at: &BlockVector,
    stiffening: &mut f64,
    run: &mut Run<'_>,
) -> Result<(), Error> {
    loop {
        let reference = ReferenceModuli::Stiffened(*stiffening);
        match system.linearize(Some((at, reference)), run) {
            Err(Error::Factorization(_)) if *stiffening < 1.0 => {
                *stiffening = (10.0 * *stiffening).min(1.0);
            }
            linearized => return linearized,
        }
    }
}

/// Where the line search starts.
struct Point {
    displacement: BlockVector,
    approach: f64,
    /// Gap of each pair \[mm\].
    gap: Vec<f64>,
    /// `f = ∫ Bᵀ σ dV`.
    internal: BlockVector,
    /// Out-of-balance force of the last answer \[N/mm\].
    residual_norm: f64,
}

impl Point {
    /// The state of an initial-stress iteration: its `K u` is known.
    fn of(system: &dyn Linearize, state: &State) -> Self {
        let displacement = state.response.displacement.clone();
        let mut image = system.zeros();
        system.initial_stress(&displacement, &mut image);
        let mut internal = system.applied(&state.loads, &state.response.contact.force);
        add(&mut internal, -1.0, &image);
        let contact = &state.response.contact;
        Self {
            displacement,
            approach: contact.approach,
            gap: contact.gap.clone(),
            internal,
            residual_norm: 0.0,
        }
    }

    /// Moves towards an answer of the linearized bodies, whose initial-stress load is `image`.
    /// Returns the length of the step over the distance to that answer.
    ///
    /// Takes the whole step where the out-of-balance force falls; otherwise stops where φ' is
    /// about zero.
    fn advance(
        &mut self,
        system: &dyn Linearize,
        iteration: &mut Iteration<'_>,
        answer: &State,
        image: &BlockVector,
        residual_norm: f64,
    ) -> f64 {
        let mut direction = answer.response.displacement.clone();
        add(&mut direction, -1.0, &self.displacement);
        let step = answer.response.contact.approach - self.approach;
        let force = match iteration.controls.load {
            ContactLoad::Force(force) => force,
            ContactLoad::Approach(_) => 0.0,
        };
        // K u and K u*, with the stiffness K in force; answer.loads is P(u).
        let mut before = self.internal.clone();
        add(&mut before, 1.0, &answer.loads);
        let after = system.applied(&answer.loads, &answer.response.contact.force);
        let slope = |internal: &BlockVector| system.work(internal, &direction) - force * step;
        let internal = |share: f64, image: &BlockVector| {
            let combine = |(b, a, p): (&Vec<f64>, &Vec<f64>, &Vec<f64>)| -> Vec<f64> {
                b.iter().zip(a).zip(p).map(|((b, a), p)| b + share * (a - b) - p).collect()
            };
            let parts = before.iter().zip(&after).zip(image).map(|((b, a), p)| (b, a, p));
            parts.map(combine).collect::<BlockVector>()
        };
        let first = slope(&self.internal);
        let whole = internal(1.0, image);
        let last = slope(&whole);
        let (mut share, mut reached) = (1.0, whole);
        // Near convergence the slopes are differences of nearly equal numbers; the residual is
        // more accurate.
        let gets_on = residual_norm
            <= SLOPE_LEFT * std::mem::replace(&mut self.residual_norm, residual_norm);
        let (first, last) = if gets_on || first >= 0.0 { (0.0, 0.0) } else { (first, last) };
        let at = |share: f64, iteration: &mut Iteration<'_>| {
            let mut trial = self.displacement.clone();
            add(&mut trial, share, &direction);
            let mut image = system.zeros();
            iteration.initial_stress(&trial, &mut image);
            let reached = internal(share, &image);
            (slope(&reached), reached)
        };
        if last > SLOPE_LEFT * first.abs() {
            // False position between the ends.
            let (mut low, mut high) = ((0.0, first), (1.0, last));
            for _ in 0..MAX_TRIALS {
                let margin = 0.05 * (high.0 - low.0);
                share = zero(low, high).clamp(low.0 + margin, high.0 - margin);
                let (here, internal) = at(share, iteration);
                reached = internal;
                if here.abs() <= SLOPE_LEFT * first.abs() {
                    break;
                }
                // Illinois: the end that stays counts half.
                if here > 0.0 {
                    (high, low.1) = ((share, here), 0.5 * low.1);
                } else {
                    (low, high.1) = ((share, here), 0.5 * high.1);
                }
            }
        } else if last < -SLOPE_LEFT * first.abs() {
            // Moduli that are stiffer than the tangent make short steps: go on as far as no pair
            // overlaps.
            let closing =
                self.gap.iter().zip(&answer.response.contact.gap).filter(|(now, then)| then < now);
            let room = closing.map(|(now, then)| now / (now - then)).fold(LONGEST, f64::min);
            let target = zero((0.0, first), (1.0, last)).min(room);
            if target > 1.0 {
                let (here, internal) = at(target, iteration);
                if here <= SLOPE_LEFT * first.abs() {
                    (share, reached) = (target, internal);
                }
            }
        }
        for (now, then) in self.gap.iter_mut().zip(&answer.response.contact.gap) {
            *now = (*now + share * (then - *now)).max(0.0);
        }
        add(&mut self.displacement, share, &direction);
        self.approach += share * step;
        self.internal = reached;
        share
    }
}

/// Where the straight line through two points `(t, φ')` is zero.
fn zero(low: (f64, f64), high: (f64, f64)) -> f64 {
    (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1)
}

/// `a += factor · b`.
fn add(a: &mut BlockVector, factor: f64, b: &BlockVector) {
    for (a, b) in a.iter_mut().flatten().zip(b.iter().flatten()) {
        *a += factor * b;
    }
}
