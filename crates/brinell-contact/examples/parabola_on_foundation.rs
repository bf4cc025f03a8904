//! A parabola pressed on a row of springs that pull at their neighbours: forces and gaps.
//!
//! `cargo run -p brinell-contact --example parabola_on_foundation`

use std::error::Error;

use brinell_contact::{
    ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolution, ContactSolver, DenseFlexibility,
    never,
};

fn main() -> Result<(), Box<dyn Error>> {
    let n = 21_u16;
    let len = usize::from(n);
    // [mm/N]: falls with the distance.
    let entries = (0..n).flat_map(|i| (0..n).map(move |j| 0.01 / (1.0 + f64::from(i.abs_diff(j))))).collect();
    let flexibility = DenseFlexibility::new(len, entries).ok_or("the entries are not symmetric")?;
    let gap: Vec<f64> = (0..n).map(|k| 2e-3 * (f64::from(k) - 10.0).powi(2)).collect();
    let problem =
        ContactProblem { flexibility: &flexibility, initial_gap: &gap, load: ContactLoad::Force(10.0) };
    let mut solution = ContactSolution::default();
    ConjugateGradientSolver::new(1e-9).solve(&problem, &mut solution, &mut never)?;
    println!("{:?}, approach {:.5} mm, {:?}", solution.status, solution.approach, solution.kkt);
    for (k, (force, gap)) in solution.force.iter().zip(&solution.gap).enumerate() {
        println!("{k:3}  {force:8.4} N  {gap:9.6} mm");
    }
    Ok(())
}
