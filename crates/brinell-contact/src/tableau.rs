//! The condensed tableau of the contact programme: one row for each basic, one column for each
//! other variable.
//!
//! Row i reads `x_basic(i) + Σ_j T_ij x_nonbasic(j) = b_i`. Columns of basic variables are unit
//! vectors and not stored, so there are (n + 1) × (n + 2) numbers, the right-hand side b being the
//! last column.

/// Pivot elements below this part of their column's largest entry are rounding.
const PIVOT_TOLERANCE: f64 = 1e-12;
/// Basic values that the entering variable would leave within this distance of zero have reached
/// it together.
const TIE_TOLERANCE: f64 = 1e-14;

/// One variable of the programme.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Variable {
    /// Contact force `R_k`.
    Force(usize),
    /// Gap `δ_k`.
    Gap(usize),
    /// Approach α, counted from where the first pair touches.
    Approach,
    /// z, what is missing from the prescribed load.
    Artificial,
}

/// Condensed simplex tableau, row by row.
pub(super) struct Tableau {
    n: usize,
    width: usize,
    entries: Vec<f64>,
    basic: Vec<Variable>,
    nonbasic: Vec<Variable>,
}

impl Tableau {
    /// The start tableau `-F R + α e + δ = g`, with load row `eᵀR + z = 1` (force) or `α + z = 1`
    /// (approach).
    pub fn new(
        n: usize,
        flexibility: impl Fn(usize, usize) -> f64,
        gap: impl Fn(usize) -> f64,
        closing: impl Fn(usize) -> f64,
        load_is_force: bool,
    ) -> Self {
        let width = n + 2;
        let mut entries = Vec::with_capacity((n + 1) * width);
        for i in 0..n {
            entries.extend((0..n).map(|j| -flexibility(i, j)));
            entries.extend([closing(i), gap(i)]);
        }
        if load_is_force {
            entries.extend((0..n).map(closing));
            entries.extend([0.0, 1.0]);
        } else {
            entries.extend((0..n).map(|_| 0.0));
            entries.extend([1.0, 1.0]);
        }
        Self {
            n,
            width,
            entries,
            basic: (0..n).map(Variable::Gap).chain([Variable::Artificial]).collect(),
            nonbasic: (0..n).map(Variable::Force).chain([Variable::Approach]).collect(),
        }
    }

    /// The column of a variable that is out of the basis.
    ///
    /// # Panics
    /// If it is in the basis, which the restricted entry rule excludes.
    pub fn column_of(&self, variable: Variable) -> usize {
        let column = self.nonbasic.iter().position(|&v| v == variable);
        debug_assert!(column.is_some(), "{variable:?} is basic");
        column.unwrap_or(self.n)
    }

    /// The row whose basic variable reaches zero first as the column's variable grows; none on a
    /// ray.
    ///
    /// α is free and never leaves. Of rows that tie, z's wins; otherwise the one whose row of the
    /// basis inverse, divided by its pivot element, is lexicographically smallest.
    pub fn leaving_row(&self, column: usize) -> Option<usize> {
        let largest = (0..=self.n).map(|i| self.at(i, column).abs()).fold(0.0, f64::max);
        let mut candidates: Vec<usize> = (0..=self.n)
            .filter(|&i| {
                self.basic[i] != Variable::Approach
                    && self.at(i, column) > PIVOT_TOLERANCE * largest
            })
            .collect();
        let ratio = |i: usize| self.value(i).max(0.0) / self.at(i, column);
        let step = candidates.iter().map(|&i| ratio(i)).fold(f64::INFINITY, f64::min);
        candidates.retain(|&i| {
            let travel = step * self.at(i, column);
            self.value(i) - travel <= TIE_TOLERANCE * (1.0 + travel)
        });
        if let Some(&row) = candidates.iter().find(|&&i| self.basic[i] == Variable::Artificial) {
            return Some(row);
        }
        let mut pair = 0;
        while candidates.len() > 1 && pair < self.n {
            let inverse = self.inverse_column(Variable::Gap(pair));
            let key = |i: usize| inverse(i) / self.at(i, column);
            let least = candidates.iter().map(|&i| key(i)).fold(f64::INFINITY, f64::min);
            candidates.retain(|&i| key(i) <= least);
            pair += 1;
        }
        candidates.first().copied()
    }

    /// Exchanges the column's variable with the row's; returns the one that left the basis.
    pub fn pivot(&mut self, row: usize, column: usize) -> Variable {
        let width = self.width;
        let (above, rest) = self.entries.split_at_mut(row * width);
        let (pivot_row, below) = rest.split_at_mut(width);
        let inverse = 1.0 / pivot_row[column];
        for entry in &mut *pivot_row {
            *entry *= inverse;
        }
        pivot_row[column] = inverse;
        for target in above.chunks_exact_mut(width).chain(below.chunks_exact_mut(width)) {
            let factor = target[column];
            if factor == 0.0 {
                continue;
            }
            target[column] = 0.0;
            for (entry, pivot) in target.iter_mut().zip(&*pivot_row) {
                *entry -= factor * pivot;
            }
        }
        std::mem::swap(&mut self.basic[row], &mut self.nonbasic[column]);
        self.nonbasic[column]
    }

    /// Every basic variable with its value.
    pub fn basic_values(&self) -> impl Iterator<Item = (Variable, f64)> + '_ {
        self.basic.iter().enumerate().map(|(row, &variable)| (variable, self.value(row)))
    }

    fn at(&self, row: usize, column: usize) -> f64 {
        self.entries[row * self.width + column]
    }

    fn value(&self, row: usize) -> f64 {
        self.at(row, self.n + 1)
    }

    /// The column of the basis inverse that belongs to a variable of the start basis.
    fn inverse_column(&self, variable: Variable) -> impl Fn(usize) -> f64 + '_ {
        let column = self.nonbasic.iter().position(|&v| v == variable);
        move |row| match column {
            Some(column) => self.at(row, column),
            None => f64::from(u8::from(self.basic[row] == variable)),
        }
    }
}
