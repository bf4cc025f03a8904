//! What a contact needs to know of two elastic bodies.

/// The displacements along the normals that contact forces cause, `u = F R`.
///
/// `F = flexibility [mm/N]`, the sum over both bodies, is symmetric and positive definite. u is positive where it
/// opens the gap.
pub trait Flexibility {
    /// Number of candidate cells.
    fn len(&self) -> usize;

    /// Whether there are no candidate cells.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// `u = F R`; both slices have [`len`](Self::len) entries.
    fn apply(&self, force: &[f64], displacement: &mut [f64]);

    /// A symmetric positive definite approximation of `F⁻¹ u`, up to a positive factor. The identity by default.
    fn precondition(&self, displacement: &[f64], force: &mut [f64]) {
        force.copy_from_slice(displacement);
    }

    /// The entries of F row by row, where they are at hand.
    fn dense(&self) -> Option<&[f64]> {
        None
    }
}

/// A flexibility given by its entries.
#[derive(Debug, Clone, PartialEq)]
pub struct DenseFlexibility {
    len: usize,
    entries: Vec<f64>,
}

impl DenseFlexibility {
    /// A matrix of `len` rows from its entries row by row; `None` unless they are `len²` numbers, symmetric to
    /// the last bit.
    pub fn new(len: usize, entries: Vec<f64>) -> Option<Self> {
        let at = |i: usize, j: usize| entries[i * len + j].to_bits();
        let fits = entries.len() == len * len;
        let symmetric = fits && (0..len).all(|i| (0..i).all(|j| at(i, j) == at(j, i)));
        symmetric.then_some(Self { len, entries })
    }
}

impl Flexibility for DenseFlexibility {
    fn len(&self) -> usize {
        self.len
    }

    fn apply(&self, force: &[f64], displacement: &mut [f64]) {
        for (row, u) in self.entries.chunks_exact(self.len).zip(displacement) {
            *u = row.iter().zip(force).map(|(f, r)| f * r).sum();
        }
    }

    fn precondition(&self, displacement: &[f64], force: &mut [f64]) {
        for (k, (r, u)) in force.iter_mut().zip(displacement).enumerate() {
            *r = u / self.entries[k * (self.len + 1)];
        }
    }

    fn dense(&self) -> Option<&[f64]> {
        Some(&self.entries)
    }
}
