//! Uniaxial hardening laws: stress against plastic strain.
//!
//! A law is one file with a type that implements [`HardeningLaw`], and an arm of [`law_of`]. It knows nothing of
//! elasticity; [`super::ReturnMapping`] combines the two.

mod bilinear;
mod ludwik;
mod ramberg_osgood;
mod swift;
mod table;
mod voce;

use std::fmt::Debug;
use std::sync::Arc;

pub use bilinear::Bilinear;
pub use ludwik::Ludwik;
pub use ramberg_osgood::RambergOsgood;
pub use swift::Swift;
pub use table::Table;
pub use voce::Voce;

use crate::job::{Deformable, Hardening};

/// A uniaxial curve `q(ε_p)` of stress \[MPa\] against plastic strain, rising and concave.
pub trait HardeningLaw: Debug + Send + Sync {
    /// Stress up to which the response is elastic \[MPa\]; 0 where plastic strain begins at once.
    fn yield_stress(&self) -> f64;

    /// q at a plastic strain `>= 0` \[MPa\].
    fn stress(&self, plastic_strain: f64) -> f64;

    /// `dq/dε_p` \[MPa\]; may be infinite at zero.
    fn slope(&self, plastic_strain: f64) -> f64;

    /// Both at once, for laws that share work between them.
    fn stress_and_slope(&self, plastic_strain: f64) -> (f64, f64) {
        (self.stress(plastic_strain), self.slope(plastic_strain))
    }

    /// `ε_p(q)` for a law that is given that way round; `None` for all others.
    fn inverse(&self, _stress: f64) -> Option<Inverse> {
        None
    }

    /// The corners `[ε_p, q]` of a piecewise linear law, the first at zero plastic strain; beyond the last it has the slope
    /// there. `None` for a curved law.
    fn polyline(&self) -> Option<Vec<[f64; 2]>> {
        None
    }

    /// Stress above which a point counts as yielded \[MPa\]: the yield stress or, for a curve without an elastic limit,
    /// what convention says.
    fn nominal_yield_stress(&self) -> f64 {
        self.yield_stress()
    }

    /// A stress at which the material flows noticeably \[MPa\]; contacts are sized by it before anything is solved.
    fn flow_stress(&self) -> f64 {
        1.2 * self.yield_stress()
    }

    /// Whether a point in this state counts as yielded: where plastic strain has begun or, for a curve without an elastic
    /// limit, above the nominal yield stress.
    fn has_yielded(&self, stress: f64, plastic_strain: f64) -> bool {
        plastic_strain > 0.0 && (self.yield_stress() > 0.0 || stress > self.nominal_yield_stress())
    }
}

/// Plastic strain at a stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inverse {
    /// ε_p.
    pub plastic_strain: f64,
    /// `dε_p/dq` \[1/MPa\].
    pub slope: f64,
}

/// The hardening law of a material; `None` if it is purely elastic.
pub fn law_of(material: &Deformable) -> Option<Arc<dyn HardeningLaw>> {
    let young = material.elastic().young_modulus.get();
    Some(match material.plasticity()? {
        Hardening::Bilinear { yield_stress, tangent_modulus } => Arc::new(Bilinear {
            yield_stress: yield_stress.get(),
            plastic_modulus: tangent_modulus.get() / (1.0 - tangent_modulus.get() / young),
        }),
        Hardening::RambergOsgood { reference_stress, offset, exponent } => Arc::new(RambergOsgood {
            reference_stress: reference_stress.get(),
            reference_strain: offset.get() * reference_stress.get() / young,
            exponent: exponent.get(),
        }),
        Hardening::Table { points } => Arc::new(Table { points: points.as_slice().to_vec() }),
        Hardening::Swift { yield_stress, strain_offset, exponent } => Arc::new(Swift {
            yield_stress: yield_stress.get(),
            strain_offset: strain_offset.get(),
            exponent: exponent.get(),
        }),
        Hardening::Ludwik { yield_stress, coefficient, exponent } => Arc::new(Ludwik {
            yield_stress: yield_stress.get(),
            coefficient: coefficient.get(),
            exponent: exponent.get(),
        }),
        Hardening::Voce { yield_stress, saturation_stress, rate } => Arc::new(Voce {
            yield_stress: yield_stress.get(),
            saturation_stress: saturation_stress.get(),
            rate: rate.get(),
        }),
    })
}

#[cfg(test)]
pub(in crate::material) mod tests {
    use super::*;
    use crate::job::{Elastic, NonNegativeF64, PoissonRatio, PositiveF64, TablePoints};

    fn positive(value: f64) -> PositiveF64 {
        PositiveF64::new(value).unwrap()
    }

    pub(in crate::material) const YOUNG: f64 = 210_000.0;
    pub(in crate::material) const TRIPLE_SHEAR: f64 = 3.0 * YOUNG / 2.6;

    /// A material of every law, two of one.
    pub(in crate::material) fn materials() -> Vec<Deformable> {
        let yield_stress = positive(500.0);
        let tangent = |value| NonNegativeF64::new(value).unwrap();
        let points = vec![[0.0, 400.0], [1e-3, 520.0], [0.01, 600.0], [0.1, 640.0]];
        let elastic =
            Elastic { young_modulus: positive(YOUNG), poisson_ratio: PoissonRatio::new(0.3).unwrap() };
        let inputs = [
            Hardening::Bilinear { yield_stress, tangent_modulus: tangent(10_500.0) },
            Hardening::Bilinear { yield_stress, tangent_modulus: tangent(0.0) },
            Hardening::RambergOsgood {
                reference_stress: yield_stress,
                offset: positive(0.3),
                exponent: positive(5.0),
            },
            Hardening::Table { points: TablePoints::new(points).unwrap() },
            Hardening::Swift { yield_stress, strain_offset: positive(2e-3), exponent: positive(0.15) },
            Hardening::Ludwik { yield_stress, coefficient: positive(700.0), exponent: positive(0.4) },
            Hardening::Voce { yield_stress, saturation_stress: positive(800.0), rate: positive(30.0) },
        ];
        inputs.into_iter().map(|input| Deformable::new(elastic, Some(input)).unwrap()).collect()
    }

    pub(in crate::material) fn laws() -> Vec<Arc<dyn HardeningLaw>> {
        materials().iter().filter_map(law_of).collect()
    }

    /// The formulas once more, written from the job's figures.
    #[test]
    fn every_law_is_its_formula() {
        let formulas: [fn(f64) -> f64; 7] = [
            |p| 500.0 + 10_500.0 / 0.95 * p,
            |_| 500.0,
            |p| 500.0 * (p * YOUNG / (0.3 * 500.0)).powf(0.2),
            |p| match p {
                p if p < 1e-3 => 400.0 + 120.0 * p / 1e-3,
                p if p < 0.01 => 520.0 + 80.0 * (p - 1e-3) / 9e-3,
                p if p < 0.1 => 600.0 + 40.0 * (p - 0.01) / 0.09,
                _ => 640.0,
            },
            |p| 500.0 * (1.0 + p / 2e-3).powf(0.15),
            |p| 500.0 + 700.0 * p.powf(0.4),
            |p| 800.0 - 300.0 * (-30.0 * p).exp(),
        ];
        for (law, formula) in laws().iter().zip(formulas) {
            for p in [0.0, 1e-9, 1e-4, 5e-3, 0.05, 2.0] {
                assert!((law.stress(p) - formula(p)).abs() < 1e-9, "{law:?} at {p}");
            }
        }
    }

    #[test]
    fn slopes_are_derivatives_and_inverses_are_inverse() {
        for law in laws() {
            for p in [2e-4, 5e-3, 0.05, 2.0] {
                let step = 1e-6 * p;
                let derivative = (law.stress(p + step) - law.stress(p - step)) / (2.0 * step);
                assert!((law.slope(p) - derivative).abs() < 1e-5 * derivative.max(1.0), "{law:?} at {p}");
                assert_eq!(law.stress_and_slope(p), (law.stress(p), law.slope(p)));
                if let Some(inverse) = law.inverse(law.stress(p)) {
                    assert!((inverse.plastic_strain - p).abs() < 1e-12 * p);
                    assert!((inverse.slope * law.slope(p) - 1.0).abs() < 1e-12);
                }
            }
        }
    }
}
