//! The elastic contact of a steel ball with a flat of steel: pressure, approach and Hertz beside
//! them.
//!
//! `cargo run --release -p brinell-halfspace --example ball_on_flat`

use std::error::Error;

use brinell_contact::{
    ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolver, never,
};
use brinell_halfspace::{Elasticity, EllipticContact, SurfaceFlexibility, SurfaceGrid};

fn main() -> Result<(), Box<dyn Error>> {
    let steel = Elasticity::new(210_000.0, 0.3)?;
    let (radius, force) = (10.0, 100.0);
    let modulus = 1.0 / (2.0 * steel.plane_compliance());
    let hertz = EllipticContact::new(radius, radius, modulus, force);
    println!("cells  applications  p0 [MPa]   alpha [mm]");
    for n in [32, 64, 128, 256] {
        let side = 2.6 * hertz.semi_axis_x / f64::from(n);
        let n = usize::try_from(n)?;
        let grid = SurfaceGrid::new(n, n, side, side)?;
        let gap = grid.sample(|x, y| (x * x + y * y) / (2.0 * radius));
        let closing = vec![1.0; gap.len()];
        let surface = SurfaceFlexibility::new(grid, modulus);
        let problem = ContactProblem {
            flexibility: &surface,
            initial_gap: &gap,
            closing: &closing,
            load: ContactLoad::Force(force),
        };
        let solution = ConjugateGradientSolver::new(1e-8).solve(&problem, None, &mut never)?;
        let peak = solution.force.iter().copied().fold(0.0, f64::max) / grid.cell_area();
        println!("{n:5}  {:12}  {peak:8.2}  {:.5e}", solution.applications, solution.approach);
    }
    println!("Hertz                {:8.2}  {:.5e}", hertz.peak_pressure, hertz.approach);
    Ok(())
}
