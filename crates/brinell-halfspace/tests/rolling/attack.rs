//! Jobs of all kinds, at random: no NaN, no hang, and a reason for every pass without an answer.

use std::sync::Arc;

use brinell_material::HardeningLaw;
use brinell_material::hardening::{Ludwik, PolyLine, RambergOsgood, Swift};

use super::driver::{End, Material, Roller, Setup, YIELD, YOUNG, shear_strength};

/// Numbers in order from a seed.
struct Dice(u64);

impl Dice {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn one_of<T: Clone>(&mut self, choices: &[T]) -> T {
        let place = self.between(0.0, choices.len() as f64);
        choices
            [(0..choices.len() - 1).find(|k| place < (*k + 1) as f64).unwrap_or(choices.len() - 1)]
        .clone()
    }

    fn material(&mut self) -> Material {
        let of = |law: Arc<dyn HardeningLaw>| Material { law, terms: vec![] };
        let material = match self.one_of(&[0, 1, 2, 3, 4, 5, 6, 7]) {
            0 => Material::perfect(),
            3 => {
                of(Arc::new(RambergOsgood::of_offset(YIELD, 0.3, self.between(3.0, 50.0), YOUNG)))
            }
            4 => of(Arc::new(Swift {
                yield_stress: YIELD,
                strain_offset: 2e-3,
                exponent: self.between(0.05, 0.4),
            })),
            5 => of(Arc::new(Ludwik {
                yield_stress: YIELD,
                coefficient: 700.0,
                exponent: self.between(0.2, 1.0),
            })),
            6 => of(Arc::new(PolyLine {
                points: vec![[0.0, YIELD], [1e-3, 1.1 * YIELD], [1e-2, 1.2 * YIELD]],
            })),
            1 => Material::straight(self.between(100.0, 30_000.0)),
            2 => Material::voce(YIELD * self.between(1.0, 1.8), self.between(1.0, 300.0)),
            _ => Material::voce(YIELD * self.between(1.0, 1.1), self.between(1.0, 3000.0)),
        };
        match self.one_of(&[0, 0, 1, 2, 3]) {
            0 => material,
            1 => material.with(&[[self.between(1e3, 5e4), 0.0]]),
            2 => material.with(&[[self.between(1e3, 1e5), self.between(1.0, 1000.0)]]),
            _ => material.with(&[[60_000.0, 600.0], [20_000.0, 100.0], [3_000.0, 0.0]]),
        }
    }
}

const STRENGTHS: [fn(f64) -> f64; 4] = [
    |_| 1.0,
    |z| if z < 0.5 { 1.8 } else { 1.0 },
    |z| 1.0 + 0.7 * (-2.0 * z).exp(),
    |z| if z < 0.1 { 0.6 } else { 1.0 },
];
const STRESSES: [fn(f64) -> [f64; 2]; 3] = [
    |_| [0.0; 2],
    |z| [-300.0 * (-3.0 * z).exp() + 40.0, -250.0 * (-3.0 * z).exp() + 30.0],
    |_| [150.0, -100.0],
];

#[test]
fn passes_at_random_end_with_figures_or_a_reason() {
    let mut dice = Dice(0x5eed_1234_abcd_0001);
    let (mut ends, mut worst) = ([0usize; 4], 0);
    for job in 0..150 {
        let mut setup = Setup::new(10, 0.0, 1.0);
        setup.length = 16.0;
        setup.friction = dice.one_of(&[0.0, 1.0, 1.0]) * dice.between(-0.6, 0.6);
        setup.peak = dice.between(0.8, 6.0) * shear_strength();
        setup.material = dice.material();
        setup.strength = dice.one_of(&STRENGTHS);
        setup.initial = dice.one_of(&STRESSES);
        let alternates = dice.one_of(&[true, false]);
        let mut roller = Roller::new(&setup);
        let mut last = String::new();
        for number in 1..=4 {
            let pass = roller.pass(150);
            worst = worst.max(pass.evaluations);
            last = pass.line();
            let place = match pass.end {
                End::Converged => 0,
                End::Stalled => 1,
                End::NotFinite => 2,
                End::Refused(_) => 3,
            };
            ends[place] += 1;
            if place != 0 {
                println!(
                    "job {job} pass {number}: {:?}, friction {:.2}, {:.2} k, {:?} {:?}: {last}",
                    pass.end,
                    setup.friction,
                    setup.peak / shear_strength(),
                    setup.material.law,
                    setup.material.terms
                );
                break;
            }
            let figures = [
                pass.strain.largest.value,
                pass.strain.net.value,
                pass.outlet.forward,
                pass.outlet.groove_depth,
                pass.outlet.plastic_work,
                pass.outlet.stored_energy,
                pass.peak,
                pass.rolling_force,
                pass.work_of_traction,
            ];
            assert!(figures.iter().all(|x| x.is_finite()), "job {job}: {figures:?}");
            assert!(
                pass.outlet.plastic_work >= 0.0
                    && pass.strain.net.value <= pass.strain.largest.value * 1.001 + 1e-12,
                "job {job}: {last}"
            );
            if alternates {
                roller.turn();
            }
        }
        assert!(!last.contains("NaN"), "job {job}: {last}");
    }
    println!("converged, stalled, not finite, refused: {ends:?}; at most {worst} evaluations");
    assert_eq!(ends[2], 0, "{ends:?}");
    assert!(ends[1] * 20 < ends[0], "{ends:?}");
}
