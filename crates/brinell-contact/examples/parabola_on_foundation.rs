//! A parabola pressed on a row of springs that pull at their neighbours: forces and gaps.
//!
//! `cargo run -p brinell-contact --example parabola_on_foundation`

use std::error::Error;

use brinell_contact::{
    ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolver, kkt, never,
};
use dense_cholesky::SymmetricMatrix;

fn main() -> Result<(), Box<dyn Error>> {
    let n = 21_u16;
    // [mm/N]: falls with the distance.
    let flexibility =
        SymmetricMatrix::from_fn(usize::from(n), |i, j| 0.01 / (1.0 + i.abs_diff(j) as f64));
    let gap: Vec<f64> = (0..n).map(|k| 2e-3 * (f64::from(k) - 10.0).powi(2)).collect();
    let closing = vec![1.0; gap.len()];
    let problem = ContactProblem {
        flexibility: &flexibility,
        initial_gap: &gap,
        closing: &closing,
        load: ContactLoad::Force(10.0),
    };
    let solution = ConjugateGradientSolver::new(1e-9).solve(&problem, None, &mut never)?;
    let check = kkt::check(&problem, &solution.force, solution.approach);
    println!("{:?}, approach {:.5} mm, {check:?}", solution.status, solution.approach);
    for (k, (force, gap)) in solution.force.iter().zip(&solution.gap).enumerate() {
        println!("{k:3}  {force:8.4} N  {gap:9.6} mm");
    }
    Ok(())
}
