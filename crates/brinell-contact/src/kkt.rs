//! Independent check: does a set of forces solve a contact problem?
//!
//! The check shares no code with the solvers: it recomputes `δ = g + F R - α e` from the data, the
//! forces and the approach by its own loops.

use super::{ContactLoad, ContactProblem};

/// Largest violation of the contact conditions, relative to the forces and displacements of the
/// contact, that a converged state may have. Rounding leaves about 1e-12.
const SOUND: f64 = 1e-8;

/// Violations of the contact conditions by forces and approach; all dimensionless.
///
/// Scales: `R° = max |R_k|` for forces and `u° = max |(F R)_k|`, the elastic displacement they
/// cause, for gaps. Where nothing touches, `u° = max(|α|, max |g_k|)`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct KktReport {
    /// Deepest penetration: `max(0, -δ_k) / u°`.
    pub penetration: f64,
    /// Strongest tension: `max(0, -R_k) / R°`.
    pub tension: f64,
    /// Worst pair that both carries force and is apart: `max_k min(|R_k| / R°, |δ_k| / u°)`.
    pub complementarity: f64,
    /// The load: `|eᵀR - P| / max(P, Σ|R_k|)`, or `|α - α_given| / max(|α|, |α_given|, u°)`.
    pub equilibrium: f64,
}

impl KktReport {
    /// The largest of the four; NaN if any of them is NaN.
    pub fn worst(&self) -> f64 {
        [self.penetration, self.tension, self.complementarity, self.equilibrium]
            .into_iter()
            .fold(0.0, worse)
    }

    /// Whether the violations are as small as a converged state requires.
    pub fn is_sound(&self) -> bool {
        self.passes(SOUND)
    }

    /// Whether all four stay within `tolerance`. NaN never passes.
    pub fn passes(&self, tolerance: f64) -> bool {
        self.worst() <= tolerance
    }
}

/// The scales of the conditions.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ContactScales {
    /// `R°` \[N/mm\].
    pub force: f64,
    /// `u°` \[mm\].
    pub displacement: f64,
}

impl ContactScales {
    /// The larger of each.
    #[must_use]
    pub fn larger(self, other: Self) -> Self {
        Self {
            force: self.force.max(other.force),
            displacement: self.displacement.max(other.displacement),
        }
    }
}

/// Returns the scales of contact forces.
pub fn scales(problem: &ContactProblem<'_>, force: &[f64]) -> ContactScales {
    let displacement = displacement(problem, force);
    ContactScales {
        force: largest(force.iter().copied()),
        displacement: largest(displacement.iter().copied()),
    }
}

/// `F R`.
fn displacement(problem: &ContactProblem<'_>, force: &[f64]) -> Vec<f64> {
    let mut displacement = vec![0.0; force.len()];
    problem.flexibility.apply(force, &mut displacement);
    displacement
}

/// Checks forces and approach.
///
/// Lists of different lengths give infinite violations, figures that are not finite give NaN;
/// neither passes.
pub fn check(problem: &ContactProblem, force: &[f64], approach: f64) -> KktReport {
    check_beside(problem, force, approach, ContactScales::default())
}

/// Checks with scales at least as large as those of earlier loads, because the plastic
/// displacements of these loads have rounding errors of that size.
pub fn check_beside(
    problem: &ContactProblem,
    force: &[f64],
    approach: f64,
    least: ContactScales,
) -> KktReport {
    let n = problem.initial_gap.len();
    if force.len() != n || problem.closing.len() != n || problem.flexibility.len() != n {
        let never = f64::INFINITY;
        return KktReport {
            penetration: never,
            tension: never,
            complementarity: never,
            equilibrium: never,
        };
    }
    judge(problem, force, &displacement(problem, force), approach, least)
}

/// Checks with given displacements `F R`.
pub(crate) fn judge(
    problem: &ContactProblem<'_>,
    force: &[f64],
    displacement: &[f64],
    approach: f64,
    least: ContactScales,
) -> KktReport {
    let n = problem.n_pairs();
    let gap: Vec<f64> = (0..n)
        .map(|k| problem.initial_gap[k] + displacement[k] - problem.closing[k] * approach)
        .collect();

    let force_scale = worse(largest(force.iter().copied()), least.force);
    let mut gap_scale = worse(largest(displacement.iter().copied()), least.displacement);
    if gap_scale == 0.0 {
        gap_scale = largest(problem.initial_gap.iter().copied().chain([approach]));
    }
    let penetration = gap.iter().map(|&d| ratio(negative_part(d), gap_scale)).fold(0.0, worse);
    let tension = force.iter().map(|&r| ratio(negative_part(r), force_scale)).fold(0.0, worse);
    let complementarity = force
        .iter()
        .zip(&gap)
        .map(|(&r, &d)| lesser(ratio(r.abs(), force_scale), ratio(d.abs(), gap_scale)))
        .fold(0.0, worse);
    let equilibrium = match problem.load {
        ContactLoad::Force(total) => {
            let parts = force.iter().zip(problem.closing).map(|(force, closing)| force * closing);
            let sum: f64 = parts.clone().sum();
            let magnitude: f64 = parts.map(f64::abs).sum();
            ratio((sum - total).abs(), worse(total.abs(), magnitude))
        }
        ContactLoad::Approach(given) => {
            ratio((approach - given).abs(), worse(worse(given.abs(), approach.abs()), gap_scale))
        }
    };
    KktReport { penetration, tension, complementarity, equilibrium }
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.map(f64::abs).fold(0.0, worse)
}

/// The larger of two, NaN if either is (`f64::max` would drop it).
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// The smaller of two, NaN if either is.
fn lesser(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.min(b) }
}

/// `max(0, -value)`, NaN for NaN.
fn negative_part(value: f64) -> f64 {
    worse(-value, 0.0)
}

/// Returns a quotient, where 0/0 is 0 and not NaN.
fn ratio(value: f64, scale: f64) -> f64 {
    if value == 0.0 && scale == 0.0 { 0.0 } else { value / scale }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dense_cholesky::SymmetricMatrix;

    #[test]
    fn every_condition_is_seen_on_its_own() {
        let flexibility = SymmetricMatrix::from_fn(2, |i, j| if i == j { 2.0 } else { 1.0 });
        let problem = |load| ContactProblem {
            flexibility: &flexibility,
            initial_gap: &[0.0, 5.0],
            closing: &[1.0; 2],
            load,
        };
        let force = problem(ContactLoad::Force(1.0));
        assert!(check(&force, &[1.0, 0.0], 2.0).passes(0.0));

        let sunk = check(&force, &[1.0, 0.0], 7.0);
        assert!((sunk.penetration - 2.5).abs() < 1e-15 && sunk.tension == 0.0);
        let pulled = check(&force, &[1.5, -0.5], 2.5);
        assert!((pulled.tension - 1.0 / 3.0).abs() < 1e-15 && pulled.equilibrium == 0.0);
        let apart = check(&force, &[1.0, 0.0], 1.0);
        assert!((apart.complementarity - 0.5).abs() < 1e-15 && apart.penetration == 0.0);
        let heavy = check(&force, &[2.0, 0.0], 4.0);
        assert!((heavy.equilibrium - 0.5).abs() < 1e-15 && heavy.complementarity == 0.0);
        let elsewhere = check(&problem(ContactLoad::Approach(1.0)), &[1.0, 0.0], 2.0);
        assert!((elsewhere.equilibrium - 0.5).abs() < 1e-15);
    }

    #[test]
    fn nan_infinity_and_wrong_lengths_never_pass() {
        let flexibility = SymmetricMatrix::from_fn(2, |i, j| if i == j { 2.0 } else { 1.0 });
        let problem = ContactProblem {
            flexibility: &flexibility,
            initial_gap: &[0.0, 5.0],
            closing: &[1.0; 2],
            load: ContactLoad::Force(1.0),
        };
        for (force, approach) in [
            (vec![f64::NAN, 0.0], 2.0),
            (vec![1.0, f64::NAN], 2.0),
            (vec![1.0, 0.0], f64::NAN),
            (vec![f64::INFINITY, 0.0], 2.0),
            (vec![1.0, 0.0], f64::NEG_INFINITY),
            (vec![1.0], 2.0),
            (vec![], 2.0),
        ] {
            assert!(!check(&problem, &force, approach).passes(0.5), "{force:?} {approach}");
        }
        let gaps = [0.0, f64::NAN];
        assert!(
            !check(&ContactProblem { initial_gap: &gaps, ..problem }, &[1.0, 0.0], 2.0)
                .passes(0.5)
        );
    }
}
