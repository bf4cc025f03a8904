//! A chain of springs between two walls: its stiffness factorized, and its displacement under a
//! force in the middle.

use dense_cholesky::{DenseCholesky, NotPositiveDefinite, SymmetricMatrix, dot, simd_dispatch};

fn main() -> Result<(), NotPositiveDefinite> {
    let n = 99;
    let stiffness = SymmetricMatrix::from_fn(n, |i, j| match i.abs_diff(j) {
        0 => 2.0,
        1 => -1.0,
        _ => 0.0,
    });
    let mut displacement = vec![0.0; n];
    displacement[n / 2] = 1.0;
    DenseCholesky::factor(stiffness)?.solve_in_place(&mut displacement);
    let energy = 0.5 * displacement[n / 2];
    let length = simd_dispatch(|| dot(&displacement, &displacement)).sqrt();
    println!(
        "in the middle {:.3} (25 by hand), energy {energy:.3}, norm {length:.3}",
        displacement[n / 2]
    );
    Ok(())
}
