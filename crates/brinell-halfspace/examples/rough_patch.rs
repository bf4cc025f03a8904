//! The elastic contact of heights, for comparison with other programs: `tools/rough_patch.py`.
//!
//! Takes a file of n × n heights (little-endian doubles, x outermost), n, the force, the tolerance
//! and a file for the pressures. The side of the patch and E* are 1. Prints area over nominal
//! area, largest pressure, approach from the highest point, applications and seconds.

use std::error::Error;
use std::time::Instant;

use brinell_contact::{
    ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolver, never,
};
use brinell_halfspace::{SurfaceFlexibility, SurfaceGrid};

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [source, n, force, tolerance, result] = words.as_slice() else {
        return Err("heights, cells along a side, force, tolerance, pressures".into());
    };
    let n: usize = n.parse()?;
    let bytes = std::fs::read(source)?;
    let heights: Vec<f64> =
        bytes.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
    let highest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let gap: Vec<f64> = heights.iter().map(|height| highest - height).collect();
    let grid = SurfaceGrid::new(n, n, 1.0 / n as f64, 1.0 / n as f64)?;
    let surface = SurfaceFlexibility::new(grid, 1.0);
    let closing = vec![1.0; gap.len()];
    let problem = ContactProblem {
        flexibility: &surface,
        initial_gap: &gap,
        closing: &closing,
        load: ContactLoad::Force(force.parse()?),
    };
    let solver = ConjugateGradientSolver::new(tolerance.parse()?);
    let start = Instant::now();
    let solution = solver.solve(&problem, None, &mut never)?;
    let seconds = start.elapsed().as_secs_f64();
    let pressure: Vec<f64> = solution.force.iter().map(|force| force / grid.cell_area()).collect();
    println!(
        "{:?}, area {:.6} ({} cells), largest pressure {:.8}, approach {:.8e}, {} applications, {} \
         sets, {seconds:.2} s",
        solution.status,
        solution.active_set.len() as f64 / gap.len() as f64,
        solution.active_set.len(),
        pressure.iter().copied().fold(0.0, f64::max),
        solution.approach,
        solution.applications,
        solution.pivots,
    );
    let bytes: Vec<u8> = pressure.iter().flat_map(|pressure| pressure.to_le_bytes()).collect();
    Ok(std::fs::write(result, bytes)?)
}
