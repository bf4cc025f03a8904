//! `−Δu = 1` on the unit square with `u = 0` around it, bilinear elements: what each step of a
//! solve costs.
//!
//! `cargo run --release -p sparse-cholesky --example poisson -- 100 300 1000`; each number is that
//! of the elements along a side.

use std::error::Error;
use std::ops::ControlFlow;
use std::time::Instant;

use sparse_cholesky::{
    Cholesky, EliminationOrder, Graph, LatticePoint, SymbolicCholesky, SymmetricPattern,
};

/// Largest value of the exact solution.
const EXACT: f64 = 0.073_671_353;

fn main() -> Result<(), Box<dyn Error>> {
    let mut sizes: Vec<u32> =
        std::env::args().skip(1).map(|text| text.parse()).collect::<Result<_, _>>()?;
    if sizes.is_empty() {
        sizes = vec![64, 256];
    }
    println!(
        "| equations | entries of L | order | analyse | factorize | refactorize a corner | solve \
         | solve in the corner | error |"
    );
    println!("|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
    for elements in sizes {
        println!("{}", solve(elements)?);
    }
    Ok(())
}

/// Solves on a mesh; returns a row of the table, times in milliseconds.
fn solve(elements: u32) -> Result<String, Box<dyn Error>> {
    // The nodes within the square; those around it are held.
    let side = elements - 1;
    let cells: Vec<[u32; 4]> = (0..side - 1)
        .flat_map(|i| (0..side - 1).map(move |j| i * side + j))
        .map(|node| [node, node + side, node + side + 1, node + 1])
        .collect();
    let lattice: Vec<LatticePoint> = (0..i32::try_from(side)?)
        .flat_map(|i| (0..side).map(move |j| (i, j)))
        .map(|(i, j)| Ok(LatticePoint { patch: 0, i, j: i32::try_from(j)? }))
        .collect::<Result<_, std::num::TryFromIntError>>()?;
    let graph = Graph::from_cells(lattice.len(), &cells);
    // A corner of 1/20 of the side is eliminated last.
    let corner: Vec<u32> =
        (0..side / 20).flat_map(|i| (0..side / 20).map(move |j| i * side + j)).collect();

    let (order, ordering) = timed(|| EliminationOrder::new(&graph, &lattice, &corner));
    let position = order.positions();
    let (symbolic, analysis) =
        timed(|| SymbolicCholesky::new(SymmetricPattern::of_graph(&graph, &order)));
    let symbolic = symbolic?;
    // Assembled from [4 −1 −2 −1] / 6 of each element; `reaction` is added on the diagonal of the
    // corner.
    let matrix = |reaction: f64| -> Vec<f64> {
        let first_of_corner = symbolic.order() - corner.len();
        let column = |j: usize| {
            let diagonal = 8.0 / 3.0 + if j >= first_of_corner { reaction } else { 0.0 };
            let below = symbolic.pattern().column(j).len() - 1;
            std::iter::once(diagonal).chain(std::iter::repeat_n(-1.0 / 3.0, below))
        };
        (0..symbolic.order()).flat_map(column).collect()
    };

    let values = matrix(0.0);
    let (factor, factorization) = timed(|| Cholesky::factor(&symbolic, &values));
    let mut factor = factor?;
    let mut u = vec![f64::from(elements).powi(-2); symbolic.order()];
    let ((), solve) = timed(|| factor.solve(&mut u));
    let middle = side / 2 * (side + 1);
    let error = u[position[middle as usize] as usize] / EXACT - 1.0;

    // A source in the corner, read in the corner: the solve needs the panels of the corner only.
    let equations: Vec<u32> = corner.iter().map(|&node| position[node as usize]).collect();
    let reach = symbolic.reach(&equations);
    let mut whole = vec![0.0; symbolic.order()];
    for &equation in &equations {
        whole[equation as usize] = 1.0;
    }
    let mut part = whole.clone();
    let ((), restricted) = timed(|| factor.solve_restricted(&reach, &mut part));
    factor.solve(&mut whole);
    let is_same =
        equations.iter().all(|&e| part[e as usize].to_bits() == whole[e as usize].to_bits());
    assert!(is_same, "the restricted solve gives the bits of the full one");

    // Another matrix, which differs in the corner only.
    let values = matrix(1.0);
    let (renewed, refactorization) =
        timed(|| factor.refactor(values, &mut || ControlFlow::Continue(())));
    renewed?;
    Ok(format!(
        "| {} | {} | {ordering:.1} | {analysis:.1} | {factorization:.1} | {refactorization:.2} | \
         {solve:.2} | {restricted:.3} | {error:.1e} |",
        symbolic.order(),
        symbolic.factor_entries(),
    ))
}

/// What `work` returns, and its time \[ms\].
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let outcome = work();
    (outcome, start.elapsed().as_secs_f64() * 1e3)
}
