//! The hardening laws of a job. Each file holds one law: the table of its parameters, the
//! conditions between them, and their conversion to a law of [`crate::material::hardening`]. The
//! list below has one name per law.

mod backstress;
mod bilinear;
mod ludwik;
mod ramberg_osgood;
mod swift;
mod table;
mod voce;

use std::ops::RangeInclusive;
use std::sync::Arc;

pub use backstress::BackstressTerm;
pub use bilinear::Bilinear;
pub use ludwik::Ludwik;
pub use ramberg_osgood::RambergOsgood;
pub use swift::Swift;
pub use table::{Table, TablePoints};
pub use voce::Voce;

use super::fields::tagged;
use crate::material::HardeningLaw;

/// The parameters of a hardening law in a job.
trait Curve {
    /// Returns the hardening curve for a Young's modulus \[MPa\].
    fn law(&self, young_modulus: f64) -> Arc<dyn HardeningLaw>;
}

/// Range of the exponent n of the power laws of plastic strain.
pub(super) const STRAIN_EXPONENT: RangeInclusive<f64> = 1e-3..=1.0;

macro_rules! laws {
    ($($law:ident),+ $(,)?) => {
        tagged! {
            /// Uniaxial curve of the stress q over the plastic strain ε_p.
            pub enum Hardening by "law" beside "backstress", "over_depth" { $($law),+ }
        }

        impl Hardening {
            /// Returns the hardening curve for a Young's modulus \[MPa\].
            pub fn curve(&self, young_modulus: f64) -> Arc<dyn HardeningLaw> {
                match self {
                    $(Self::$law(parameters) => parameters.law(young_modulus)),+
                }
            }
        }
    };
}

laws! { Bilinear, RambergOsgood, Table, Swift, Ludwik, Voce }

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{Deformable, Elastic, NonNegativeF64, PoissonRatio, PositiveF64};

    fn positive(value: f64) -> PositiveF64 {
        PositiveF64::new(value).unwrap()
    }

    const YOUNG: f64 = 210_000.0;

    /// One material for each law, two for the bilinear one.
    fn materials() -> Vec<Deformable> {
        let yield_stress = positive(500.0);
        let tangent = |value| NonNegativeF64::new(value).unwrap();
        let points = vec![[0.0, 400.0], [1e-3, 520.0], [0.01, 600.0], [0.1, 640.0]];
        let elastic = Elastic {
            young_modulus: positive(YOUNG),
            poisson_ratio: PoissonRatio::new(0.3).unwrap(),
        };
        let inputs = [
            Hardening::Bilinear(Bilinear { yield_stress, tangent_modulus: tangent(10_500.0) }),
            Hardening::Bilinear(Bilinear { yield_stress, tangent_modulus: tangent(0.0) }),
            Hardening::RambergOsgood(RambergOsgood {
                reference_stress: yield_stress,
                offset: positive(0.3),
                exponent: positive(5.0),
            }),
            Hardening::Table(Table { points: TablePoints::new(points).unwrap() }),
            Hardening::Swift(Swift {
                yield_stress,
                strain_offset: positive(2e-3),
                exponent: positive(0.15),
            }),
            Hardening::Ludwik(Ludwik {
                yield_stress,
                coefficient: positive(700.0),
                exponent: positive(0.4),
            }),
            Hardening::Voce(Voce {
                yield_stress,
                saturation_stress: positive(800.0),
                rate: positive(30.0),
            }),
        ];
        for table in Hardening::TABLES {
            let has_law = inputs.iter().any(|input| input.table().word == table.word);
            assert!(has_law, "no material has the law {}", table.word);
        }
        inputs.into_iter().map(|input| Deformable::new(elastic, Some(input))).collect()
    }

    fn laws() -> Vec<Arc<dyn HardeningLaw>> {
        materials().iter().filter_map(Deformable::hardening_law).collect()
    }

    /// Evaluates the formulas independently, with the figures of the job.
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
        let laws = laws();
        assert_eq!(laws.len(), formulas.len(), "each law has a formula");
        for (law, formula) in laws.iter().zip(formulas) {
            for p in [0.0, 1e-9, 1e-4, 5e-3, 0.05, 2.0] {
                assert!((law.stress(p) - formula(p)).abs() < 1e-9, "{law:?} at {p}");
            }
        }
    }
}
