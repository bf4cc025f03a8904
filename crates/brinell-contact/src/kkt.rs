//! Independent check: does a set of forces solve a contact problem?
//!
//! Kept apart from both solvers on purpose: it recomputes `δ = g + F R - α` from the data and trusts nothing but the
//! forces and the approach it is handed.

use super::{ContactLoad, ContactProblem};

/// How far forces and approach are from satisfying the contact conditions; every figure is dimensionless.
///
/// Scales: `R° = max |R_k|` for forces and `u° = max |(F R)_k|`, the elastic displacement they cause, for gaps.
/// Where nothing touches, `u° = max(|α|, max |g_k|)`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct KktReport {
    /// Deepest penetration: `max(0, -δ_k) / u°`.
    pub penetration: f64,
    /// Strongest tension: `max(0, -R_k) / R°`.
    pub tension: f64,
    /// Worst cell that both carries force and is apart: `max_k min(|R_k| / R°, |δ_k| / u°)`.
    pub complementarity: f64,
    /// The load: `|Σ R - P| / max(P, Σ|R_k|)`, or `|α - α_given| / max(|α_given|, u°)`.
    pub equilibrium: f64,
}

impl KktReport {
    /// The largest of the four; NaN if any of them is NaN.
    pub fn worst(&self) -> f64 {
        [self.penetration, self.tension, self.complementarity, self.equilibrium].into_iter().fold(0.0, worse)
    }

    /// Whether all four stay within `tolerance`. NaN never passes.
    pub fn passes(&self, tolerance: f64) -> bool {
        self.worst() <= tolerance
    }
}

/// Judges forces and approach, and leaves the gaps δ they make in `gap`. Costs one application of F.
///
/// Lists of different lengths give infinities, figures that are not finite give NaN; neither passes.
pub fn check(problem: &ContactProblem<'_>, force: &[f64], approach: f64, gap: &mut [f64]) -> KktReport {
    let n = problem.initial_gap.len();
    if force.len() != n || gap.len() != n || problem.flexibility.len() != n {
        let never = f64::INFINITY;
        return KktReport { penetration: never, tension: never, complementarity: never, equilibrium: never };
    }
    problem.flexibility.apply(force, gap);
    let force_scale = largest(force.iter().copied());
    let mut gap_scale = largest(gap.iter().copied());
    if gap_scale == 0.0 {
        gap_scale = largest(problem.initial_gap.iter().copied().chain([approach]));
    }
    let mut report = KktReport::default();
    for ((opening, initial), r) in gap.iter_mut().zip(problem.initial_gap).zip(force) {
        *opening += initial - approach;
        let (apart, pressed) = (ratio(opening.abs(), gap_scale), ratio(r.abs(), force_scale));
        if *opening < 0.0 || opening.is_nan() {
            report.penetration = worse(report.penetration, apart);
        }
        if *r < 0.0 || r.is_nan() {
            report.tension = worse(report.tension, pressed);
        }
        report.complementarity = worse(report.complementarity, if apart < pressed { apart } else { pressed });
    }
    report.equilibrium = match problem.load {
        ContactLoad::Force(prescribed) => {
            let (total, size) = force.iter().fold((0.0, 0.0), |(sum, size), r| (sum + r, size + r.abs()));
            ratio((total - prescribed).abs(), worse(prescribed, size))
        }
        ContactLoad::Approach(prescribed) => {
            ratio((approach - prescribed).abs(), worse(prescribed.abs(), gap_scale))
        }
    };
    report
}

/// The larger of two figures; NaN if either is.
fn worse(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

/// The largest magnitude; NaN if there is one.
fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.map(f64::abs).fold(0.0, worse)
}

/// `a / b`, where nothing over nothing is nothing.
fn ratio(a: f64, b: f64) -> f64 {
    if a == 0.0 { 0.0 } else { a / b }
}
