//! Plastic flow of a cell: from the deviatoric stress of the last accepted increment to a trial stress.
//!
//! ```text
//! f = |s|_eq - q(p) <= 0,  |s|_eq = √(3/2 s:s)      dε_p = dp n,  n = 3/2 s/|s|_eq
//! ```
//! The path `s_old → s_trial` is straight. What lies outside the elastic domain is divided into equal parts, each of which
//! returns along the mean of the normals before and after it (Rice and Tracey):
//! ```text
//! n = 3/2 (s + s_tr)/|s + s_tr|_eq,   s' = s_tr - 2μ Δp n,   |s'|_eq = q(p + Δp)
//! ```
//! From rest such a path keeps its direction, and the increment is deformation theory, whatever the number of parts.
//!
//! # Reference
//! J. R. Rice, D. M. Tracey, *Computational fracture mechanics*, in Numerical and Computer Methods in Structural Mechanics
//! (1973), 585–623.

/// A deviator `[xx, yy, zz, xy, xz, yz]`.
pub(crate) type Deviator = [f64; 6];

/// An isotropic hardening curve, possibly another one in each layer.
pub trait Hardening {
    /// Yield stress q \[MPa\] at the accumulated equivalent plastic strain p, rising with it or constant.
    fn stress(&self, layer: usize, accumulated: f64) -> f64;

    /// dq/dp \[MPa\].
    fn slope(&self, layer: usize, accumulated: f64) -> f64;
}

/// `q = σ_y + H p`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearHardening {
    /// σ_y \[MPa\].
    pub yield_stress: f64,
    /// H \[MPa\], zero for perfect plasticity.
    pub modulus: f64,
}

impl Hardening for LinearHardening {
    fn stress(&self, _: usize, accumulated: f64) -> f64 {
        self.yield_stress + self.modulus * accumulated
    }

    fn slope(&self, _: usize, _: f64) -> f64 {
        self.modulus
    }
}

/// Parts into which the plastic part of a path is divided, as in the plane solver.
const PARTS: u32 = 6;
/// Newton steps of a return: a guard.
const RETURN_STEPS: usize = 50;
/// Residual of a return over the yield stress.
const RETURN_TOLERANCE: f64 = 1e-14;

/// `a : b`.
#[inline(always)]
fn contraction(a: &Deviator, b: &Deviator) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2.0 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5])
}

/// Plastic strain of a path and its equivalent Δp; `None` where the path stays elastic.
pub(crate) fn flow(
    hardening: &impl Hardening,
    layer: usize,
    shear: f64,
    accumulated: f64,
    old: &Deviator,
    trial: &Deviator,
) -> Option<(Deviator, f64)> {
    let radius = hardening.stress(layer, accumulated);
    if 1.5 * contraction(trial, trial) <= radius * radius {
        return None;
    }
    let step: Deviator = std::array::from_fn(|k| trial[k] - old[k]);
    let elastic_part = elastic_part(old, &step, radius);
    let mut stress: Deviator = std::array::from_fn(|k| old[k] + elastic_part * step[k]);
    let part = (1.0 - elastic_part) / f64::from(PARTS);
    let (mut strain, mut p) = ([0.0; 6], accumulated);
    for _ in 0..PARTS {
        let ahead: Deviator = std::array::from_fn(|k| stress[k] + part * step[k]);
        let yield_stress = hardening.stress(layer, p);
        let size = (1.5 * contraction(&ahead, &ahead)).sqrt();
        if size <= yield_stress {
            stress = ahead;
            continue;
        }
        let sum: Deviator = std::array::from_fn(|k| stress[k] + ahead[k]);
        let sum_size = (1.5 * contraction(&sum, &sum)).sqrt();
        let mean = sum.map(|value| 1.5 * value / sum_size);
        let radial = ahead.map(|value| 1.5 * value / size);
        // A part that turns the stress back cannot reach the surface along the mean normal.
        let found = (sum_size > 0.0).then(|| newton(hardening, layer, shear, p, &ahead, &mean)).flatten();
        let (normal, dp) = match found {
            Some(dp) => (mean, dp),
            None => (radial, newton(hardening, layer, shear, p, &ahead, &radial)?),
        };
        p += dp;
        for k in 0..6 {
            strain[k] += dp * normal[k];
            stress[k] = ahead[k] - 2.0 * shear * dp * normal[k];
        }
    }
    Some((strain, p - accumulated))
}

/// Where on the way `old + t step` the stress reaches the yield surface, 0 where it begins on it and leaves it.
fn elastic_part(old: &Deviator, step: &Deviator, radius: f64) -> f64 {
    let (a, b) = (1.5 * contraction(step, step), 1.5 * contraction(old, step));
    let c = (1.5 * contraction(old, old) - radius * radius).min(0.0);
    if a == 0.0 || (c == 0.0 && b >= 0.0) {
        return 0.0;
    }
    // a t² + 2 b t + c = 0, the root that is not negative, without cancellation.
    let root = (b * b - a * c).sqrt();
    let t = if b > 0.0 { -c / (b + root) } else { (root - b) / a };
    t.clamp(0.0, 1.0)
}

/// Δp with `|s_tr - 2μ Δp n|_eq = q(p + Δp)`: the smaller root, by Newton's method from zero, where the left side falls
/// and is convex. `None` where there is no root.
fn newton(
    hardening: &impl Hardening,
    layer: usize,
    shear: f64,
    accumulated: f64,
    ahead: &Deviator,
    normal: &Deviator,
) -> Option<f64> {
    let size = 1.5 * contraction(ahead, ahead);
    let product = 3.0 * shear * contraction(ahead, normal);
    let square = 6.0 * shear * shear * contraction(normal, normal);
    let mut dp = 0.0;
    for _ in 0..RETURN_STEPS {
        let equivalent = (size - 2.0 * product * dp + square * dp * dp).max(0.0).sqrt();
        let yield_stress = hardening.stress(layer, accumulated + dp);
        let residual = equivalent - yield_stress;
        if residual.abs() <= RETURN_TOLERANCE * yield_stress {
            return Some(dp);
        }
        let slope = (square * dp - product) / equivalent - hardening.slope(layer, accumulated + dp);
        let step = -residual / slope;
        if !(slope < 0.0 && step.is_finite()) {
            return None;
        }
        if step.abs() <= f64::EPSILON * dp {
            return Some(dp);
        }
        dp = (dp + step).max(0.0);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHEAR: f64 = 80_000.0;
    const LAW: LinearHardening = LinearHardening { yield_stress: 500.0, modulus: 11_000.0 };

    #[test]
    fn a_proportional_path_is_deformation_theory() {
        let trial = [600.0, -200.0, -400.0, 100.0, 50.0, -30.0];
        let size = (1.5 * contraction(&trial, &trial)).sqrt();
        let dp = (size - 500.0) / (3.0 * SHEAR + 11_000.0);
        let (strain, found) = flow(&LAW, 0, SHEAR, 0.0, &[0.0; 6], &trial).unwrap();
        assert!((found / dp - 1.0).abs() < 1e-12);
        for (k, s) in trial.iter().enumerate() {
            assert!((strain[k] - 1.5 * dp * s / size).abs() < 1e-15);
        }
    }

    #[test]
    fn the_stress_ends_on_the_yield_surface_of_a_turning_path() {
        let old = [300.0, -100.0, -200.0, 0.0, 0.0, 0.0];
        let trial = [-200.0, 500.0, -300.0, 600.0, 0.0, 100.0];
        let (strain, dp) = flow(&LAW, 0, SHEAR, 0.001, &old, &trial).unwrap();
        let end: Deviator = std::array::from_fn(|k| trial[k] - 2.0 * SHEAR * strain[k]);
        let size = (1.5 * contraction(&end, &end)).sqrt();
        assert!((size / LAW.stress(0, 0.001 + dp) - 1.0).abs() < 1e-12);
        assert!((strain[0] + strain[1] + strain[2]).abs() < 1e-17);
    }

    #[test]
    fn a_path_inside_the_surface_flows_nowhere() {
        assert!(flow(&LAW, 0, SHEAR, 0.0, &[0.0; 6], &[100.0, -50.0, -50.0, 0.0, 0.0, 0.0]).is_none());
    }
}
