//! Uniaxial hardening curves, as the deviatoric law needs them.

use super::laws::{Bilinear, Ludwik, RambergOsgood, Swift, Table, Voce};
use crate::job::{Deformable, Hardening};

/// A uniaxial curve of stress against plastic strain.
pub trait HardeningLaw {
    /// Stress up to which the response is elastic \[MPa\]; 0 where plastic strain begins at once.
    fn yield_stress(&self) -> f64;

    /// Whether a point in this state counts as yielded: where plastic strain has begun or, for a curve without an
    /// elastic limit, by convention above its reference stress.
    fn has_yielded(&self, _equivalent_stress: f64, plastic_strain: f64) -> bool {
        plastic_strain > 0.0
    }

    /// The equivalent stress q \[MPa\] that solves `ε_q = q / (3G) + ε_p(q)` for an equivalent strain `ε_q >= 0`.
    ///
    /// The left side minus the right falls monotonically in q, so the root is unique; it is never above
    /// `3G ε_q`. Implementations end after a bounded number of steps.
    fn equivalent_stress(&self, equivalent_strain: f64) -> f64;
}

/// The curve of one material, prepared for evaluation.
#[derive(Debug, Clone, PartialEq)]
pub enum UniaxialCurve {
    /// Straight hardening.
    Bilinear(Bilinear),
    /// Power law without a yield point.
    RambergOsgood(RambergOsgood),
    /// Piecewise linear.
    Table(Table),
    /// Power law of the total plastic strain.
    Swift(Swift),
    /// Power law added to the yield stress.
    Ludwik(Ludwik),
    /// Exponential saturation.
    Voce(Voce),
}

impl UniaxialCurve {
    /// Prepares the hardening curve of a material; `None` if it is purely elastic.
    pub fn of(material: &Deformable) -> Option<Self> {
        let elastic = material.elastic();
        let (young, triple_shear) = (elastic.young_modulus.get(), 3.0 * elastic.shear_modulus());
        Some(match material.plasticity()? {
            Hardening::Bilinear { yield_stress, tangent_modulus } => {
                let plastic_modulus = tangent_modulus.get() / (1.0 - tangent_modulus.get() / young);
                Self::Bilinear(Bilinear { yield_stress: yield_stress.get(), plastic_modulus, triple_shear })
            }
            Hardening::RambergOsgood { reference_stress, offset, exponent } => {
                Self::RambergOsgood(RambergOsgood {
                    reference_stress: reference_stress.get(),
                    reference_strain: offset.get() * reference_stress.get() / young,
                    exponent: exponent.get(),
                    triple_shear,
                })
            }
            Hardening::Table { points } => Self::Table(Table::new(points.as_slice(), triple_shear)),
            Hardening::Swift { yield_stress, strain_offset, exponent } => Self::Swift(Swift {
                yield_stress: yield_stress.get(),
                strain_offset: strain_offset.get(),
                exponent: exponent.get(),
                triple_shear,
            }),
            Hardening::Ludwik { yield_stress, coefficient, exponent } => Self::Ludwik(Ludwik {
                yield_stress: yield_stress.get(),
                coefficient: coefficient.get(),
                exponent: exponent.get(),
                triple_shear,
            }),
            Hardening::Voce { yield_stress, saturation_stress, rate } => Self::Voce(Voce {
                yield_stress: yield_stress.get(),
                saturation_stress: saturation_stress.get(),
                rate: rate.get(),
                triple_shear,
            }),
        })
    }

    fn law(&self) -> &dyn HardeningLaw {
        match self {
            Self::Bilinear(law) => law,
            Self::RambergOsgood(law) => law,
            Self::Table(law) => law,
            Self::Swift(law) => law,
            Self::Ludwik(law) => law,
            Self::Voce(law) => law,
        }
    }
}

impl HardeningLaw for UniaxialCurve {
    fn yield_stress(&self) -> f64 {
        self.law().yield_stress()
    }

    // The next two are called in innermost loops: a closed form is worth inlining.

    #[inline]
    fn has_yielded(&self, equivalent_stress: f64, plastic_strain: f64) -> bool {
        match self {
            Self::Bilinear(law) => law.has_yielded(equivalent_stress, plastic_strain),
            other => other.law().has_yielded(equivalent_stress, plastic_strain),
        }
    }

    #[inline]
    fn equivalent_stress(&self, equivalent_strain: f64) -> f64 {
        match self {
            Self::Bilinear(law) => law.equivalent_stress(equivalent_strain),
            other => other.law().equivalent_stress(equivalent_strain),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{Elastic, NonNegativeF64, PoissonRatio, PositiveF64, TablePoints};

    fn positive(value: f64) -> PositiveF64 {
        PositiveF64::new(value).unwrap()
    }

    const YOUNG: f64 = 210_000.0;
    const TRIPLE_SHEAR: f64 = 3.0 * YOUNG / 2.6;

    fn curve(hardening: Hardening) -> UniaxialCurve {
        let elastic =
            Elastic { young_modulus: positive(YOUNG), poisson_ratio: PoissonRatio::new(0.3).unwrap() };
        UniaxialCurve::of(&Deformable::new(elastic, Some(hardening)).unwrap()).unwrap()
    }

    type Stress = Box<dyn Fn(f64) -> f64>;

    /// Every law with its own uniaxial curve q(ε_p).
    fn laws() -> Vec<(UniaxialCurve, Stress)> {
        let yield_stress = positive(500.0);
        let tangent = |value| NonNegativeF64::new(value).unwrap();
        let points = vec![[0.0, 400.0], [1e-3, 520.0], [0.01, 600.0], [0.1, 640.0]];
        let table = points.clone();
        vec![
            (
                curve(Hardening::Bilinear { yield_stress, tangent_modulus: tangent(10_500.0) }),
                Box::new(|p| 500.0 + 10_500.0 / 0.95 * p),
            ),
            (curve(Hardening::Bilinear { yield_stress, tangent_modulus: tangent(0.0) }), Box::new(|_| 500.0)),
            (
                curve(Hardening::RambergOsgood {
                    reference_stress: yield_stress,
                    offset: positive(0.3),
                    exponent: positive(5.0),
                }),
                Box::new(|p| 500.0 * (p * YOUNG / (0.3 * 500.0)).powf(0.2)),
            ),
            (
                curve(Hardening::Table { points: TablePoints::new(points).unwrap() }),
                Box::new(move |p| {
                    let k = table.iter().rposition(|point| point[0] <= p).unwrap();
                    let Some(next) = table.get(k + 1) else { return table[k][1] };
                    table[k][1] + (p - table[k][0]) * (next[1] - table[k][1]) / (next[0] - table[k][0])
                }),
            ),
            (
                curve(Hardening::Swift {
                    yield_stress,
                    strain_offset: positive(2e-3),
                    exponent: positive(0.15),
                }),
                Box::new(|p| 500.0 * (1.0 + p / 2e-3).powf(0.15)),
            ),
            (
                curve(Hardening::Ludwik {
                    yield_stress,
                    coefficient: positive(700.0),
                    exponent: positive(0.4),
                }),
                Box::new(|p| 500.0 + 700.0 * p.powf(0.4)),
            ),
            (
                curve(Hardening::Voce {
                    yield_stress,
                    saturation_stress: positive(800.0),
                    rate: positive(30.0),
                }),
                Box::new(|p| 800.0 - 300.0 * (-30.0 * p).exp()),
            ),
        ]
    }

    #[test]
    fn every_law_follows_its_uniaxial_curve() {
        for (law, stress) in laws() {
            for plastic_strain in [1e-9, 1e-6, 3e-5, 1e-3, 5e-3, 0.02, 0.3, 4.0] {
                let q = stress(plastic_strain);
                let found = law.equivalent_stress(q / TRIPLE_SHEAR + plastic_strain);
                assert!((found - q).abs() < 1e-9 * q, "{law:?} at {plastic_strain}: {found} instead of {q}");
            }
        }
    }

    #[test]
    fn below_yield_every_law_is_elastic() {
        for (law, _) in laws() {
            let limit = law.yield_stress();
            for q in [0.0, 0.5 * limit, 0.999 * limit] {
                assert!((law.equivalent_stress(q / TRIPLE_SHEAR) - q).abs() <= 1e-12 * limit, "{law:?}");
            }
        }
    }

    #[test]
    fn stress_never_falls_with_strain_nor_exceeds_the_elastic_one() {
        for (law, _) in laws() {
            let mut last = 0.0;
            for k in 0..2000 {
                let strain = 1e-7 * 1.01f64.powi(k);
                let q = law.equivalent_stress(strain);
                assert!(q >= last * (1.0 - 1e-12) && q <= TRIPLE_SHEAR * strain * (1.0 + 1e-12), "{law:?}");
                last = q;
            }
        }
    }
}
