//! Sparsity of a symmetric matrix.

#![expect(
    clippy::cast_possible_truncation,
    reason = "equations are numbered by u32, so that there are fewer than 2^32 of them"
)]

use super::{EliminationOrder, Graph};

/// Lower triangle, diagonal included, in compressed columns; rows ascend within a column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SymmetricPattern {
    column_offsets: Vec<u32>,
    rows: Vec<u32>,
}

impl SymmetricPattern {
    /// Takes columns that are already sorted and contain their diagonal as first entry.
    pub fn from_columns(column_offsets: Vec<u32>, rows: Vec<u32>) -> Self {
        debug_assert!(column_offsets.windows(2).enumerate().all(|(j, w)| {
            let column = &rows[w[0] as usize..w[1] as usize];
            column.first() == Some(&(j as u32)) && column.is_sorted()
        }));
        Self { column_offsets, rows }
    }

    /// Pattern of a matrix with one equation for each node of a graph, in elimination order: two
    /// are coupled if their nodes are neighbours.
    pub fn of_graph(graph: &Graph, order: &EliminationOrder) -> Self {
        let position = order.positions();
        let (mut column_offsets, mut rows) = (vec![0], Vec::new());
        for (k, &node) in (0u32..).zip(order.nodes()) {
            let start = rows.len();
            rows.push(k);
            rows.extend(
                graph
                    .neighbours(node)
                    .iter()
                    .map(|&m| position[m as usize])
                    .filter(|&row| row > k),
            );
            rows[start..].sort_unstable();
            column_offsets.push(rows.len() as u32);
        }
        Self::from_columns(column_offsets, rows)
    }

    /// Order of the matrix.
    pub fn order(&self) -> usize {
        self.column_offsets.len() - 1
    }

    /// Stored entries.
    pub fn entry_count(&self) -> usize {
        self.rows.len()
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.column_offsets.as_slice()) + size_of_val(self.rows.as_slice())
    }

    /// Rows of a column, diagonal first.
    pub fn column(&self, j: usize) -> &[u32] {
        &self.rows[self.column_start(j)..self.column_start(j + 1)]
    }

    /// Where a column begins in the list of entries; also valid one past the last column.
    pub fn column_start(&self, j: usize) -> usize {
        self.column_offsets[j] as usize
    }

    /// Offsets and indices of the upper triangle by columns, that is, of the lower one by rows.
    pub(super) fn transposed(&self) -> (Vec<u32>, Vec<u32>) {
        let n = self.order();
        let mut offsets = vec![0u32; n + 1];
        for &row in &self.rows {
            offsets[row as usize + 1] += 1;
        }
        for k in 0..n {
            offsets[k + 1] += offsets[k];
        }
        let mut next = offsets.clone();
        let mut columns = vec![0u32; self.rows.len()];
        for j in 0..n {
            for &row in self.column(j) {
                let slot = &mut next[row as usize];
                columns[*slot as usize] = j as u32;
                *slot += 1;
            }
        }
        (offsets, columns)
    }
}
