//! A rigid ball on a bed of springs that yield: the least that the method asks of two bodies.
//!
//! Spring k carries `R = s (w - p)` under a compression w, of which p is plastic: beyond yield it
//! grows so that `R = R_y + H p`. The initial stress of the method is `s p`.

use brinell_contact::{ActiveSetSolver, ContactLoad, ContactProblem, ContactSolution};
use brinell_method::contact_system::{BlockVector, ContactFigures, ContactSystem};
use brinell_method::couplings::iteration::{Controls, InitialState, Scales};
use brinell_method::couplings::{Accelerated, iterate};
use brinell_method::observer::Unobserved;
use brinell_method::phases::PhaseTimes;
use brinell_method::run::Run;
use dense_cholesky::SymmetricMatrix;

/// Stiffness and hardening of a spring \[N/mm\], and the force at which it yields \[N\].
const STIFFNESS: f64 = 1e4;
const HARDENING: f64 = 1e3;
const YIELD: f64 = 50.0;

/// The springs.
struct Bed {
    initial_gap: Vec<f64>,
    closing: Vec<f64>,
    flexibility: SymmetricMatrix,
    accepted: BlockVector,
}

impl Bed {
    /// Under a ball of 10 mm, one spring every 0.1 mm.
    fn new(springs: usize) -> Self {
        let x = |k: usize| 0.1 * (k as f64 - 0.5 * (springs - 1) as f64);
        Self {
            initial_gap: (0..springs).map(|k| x(k).powi(2) / 20.0).collect(),
            closing: vec![1.0; springs],
            flexibility: SymmetricMatrix::from_fn(springs, |i, j| {
                if i == j { 1.0 / STIFFNESS } else { 0.0 }
            }),
            accepted: vec![vec![0.0; springs]],
        }
    }
}

fn norm(v: impl Iterator<Item = f64>) -> f64 {
    v.map(|v| v * v).sum::<f64>().sqrt()
}

impl ContactSystem for Bed {
    fn zeros(&self) -> BlockVector {
        vec![vec![0.0; self.initial_gap.len()]]
    }

    fn initial_gap(&self) -> &[f64] {
        &self.initial_gap
    }

    fn contact_problem<'a>(
        &'a self,
        initial_gap: &'a [f64],
        load: ContactLoad,
    ) -> ContactProblem<'a> {
        ContactProblem {
            flexibility: &self.flexibility,
            initial_gap,
            closing: &self.closing,
            load,
        }
    }

    fn gap_opening(&self, initial_stress: &BlockVector) -> Vec<f64> {
        initial_stress[0].iter().map(|stress| stress / STIFFNESS).collect()
    }

    fn displacement(&self, initial_stress: &BlockVector, force: &[f64]) -> BlockVector {
        vec![
            initial_stress[0]
                .iter()
                .zip(force)
                .map(|(stress, force)| (stress + force) / STIFFNESS)
                .collect(),
        ]
    }

    fn initial_stress(&self, displacement: &BlockVector, into: &mut BlockVector) -> usize {
        for (stress, w) in into[0].iter_mut().zip(&displacement[0]) {
            *stress = STIFFNESS * ((STIFFNESS * w - YIELD) / (STIFFNESS + HARDENING)).max(0.0);
        }
        into[0].iter().filter(|stress| **stress > 0.0).count()
    }

    fn norm(&self, v: &BlockVector) -> f64 {
        norm(v[0].iter().copied())
    }

    fn distance(&self, v: &BlockVector, w: &BlockVector) -> f64 {
        norm(v[0].iter().zip(&w[0]).map(|(v, w)| v - w))
    }

    fn pack(&self, vectors: &BlockVector) -> Vec<f64> {
        vectors[0].clone()
    }

    fn unpack(&self, packed: &[f64], vectors: &mut BlockVector) {
        vectors[0].copy_from_slice(packed);
    }

    fn figures(&self, contact: &ContactSolution) -> ContactFigures {
        ContactFigures {
            force: contact.total_force,
            approach: contact.approach,
            peak_pressure: contact.force.iter().copied().fold(0.0, f64::max),
            pairs: contact.active_set.len(),
        }
    }

    fn accepted(&self) -> &BlockVector {
        &self.accepted
    }

    fn commit(&mut self, displacement: BlockVector) {
        self.accepted = displacement;
    }
}

fn main() -> Result<(), brinell_method::Error> {
    let (mut phases, mut passes, mut observer) = (PhaseTimes::default(), 0, Unobserved);
    let mut run = Run::new(&mut phases, &mut passes, &mut observer);
    println!("{:>8} {:>10} {:>6} {:>10}", "force N", "approach", "pairs", "iterations");
    for force in [100.0, 500.0, 2000.0] {
        let mut bed = Bed::new(81);
        let controls = Controls {
            contact: &ActiveSetSolver,
            load: ContactLoad::Force(force),
            tolerance: 1e-9,
            max_iterations: 100,
            renewable: false,
            scales: Scales::default(),
            increment: None,
        };
        let outcome =
            iterate(&mut bed, &Accelerated, controls, InitialState::default(), &mut run)?;
        let contact = bed.figures(&outcome.state.response.contact);
        println!(
            "{force:>8} {:>7.4} mm {:>6} {:>10}",
            contact.approach,
            contact.pairs,
            outcome.history.len()
        );
    }
    Ok(())
}
