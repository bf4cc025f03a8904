//! Stiffness matrix of a body.

#![expect(
    clippy::cast_possible_truncation,
    reason = "the limits of a job keep node and equation counts far below 2^31"
)]

use super::Equations;
use crate::element::{ElementStiffness, Quad, StressState};
use crate::mesh::Mesh;
use sparse_cholesky::SymmetricPattern;

/// Sums element stiffnesses into the entries of a pattern, always in the order of the elements, so
/// that the sums are the same in every run.
#[derive(Debug, Clone, Copy)]
pub struct StiffnessAssembler<'a> {
    /// Mesh of the body.
    pub mesh: &'a Mesh,
    /// Third direction.
    pub stress_state: StressState,
    /// Numbering.
    pub equations: &'a Equations,
    /// Sparsity; that of [`Equations::pattern`].
    pub pattern: &'a SymmetricPattern,
}

impl StiffnessAssembler<'_> {
    /// Lower-triangle values of the stiffness matrix \[N/mm per mm\], from the stiffness of each
    /// element.
    pub fn assemble(
        &self,
        mut stiffness_of: impl FnMut(usize, &Quad) -> ElementStiffness,
    ) -> Vec<f64> {
        let mut values = vec![0.0; self.pattern.entry_count()];
        for (element, nodes) in self.mesh.elements.iter().enumerate() {
            let quad = Quad::new(&self.mesh.corners(element), self.stress_state);
            let stiffness = stiffness_of(element, &quad);
            self.add_to(&mut values, nodes, &stiffness);
        }
        values
    }

    /// Adds to the stiffness of one element.
    pub fn add(&self, values: &mut [f64], element: usize, stiffness: &ElementStiffness) {
        self.add_to(values, &self.mesh.elements[element], stiffness);
    }

    fn add_to(&self, values: &mut [f64], nodes: &[u32; 4], stiffness: &ElementStiffness) {
        let equations = nodes.map(|node| self.equations.of_node(node));
        for (j, columns) in equations.iter().enumerate() {
            for (b, &column) in columns.iter().enumerate() {
                self.add_column(values, column, &equations, |i, a| stiffness[i][j][a][b]);
            }
        }
    }

    /// Adds the entries of one element column that lie on or below the diagonal.
    fn add_column(
        &self,
        values: &mut [f64],
        column: u32,
        equations: &[[u32; 2]; 4],
        entry: impl Fn(usize, usize) -> f64,
    ) {
        let held = self.equations.len() as u32;
        if column == held {
            return;
        }
        let start = self.pattern.column_start(column as usize);
        let rows = self.pattern.column(column as usize);
        for (i, components) in equations.iter().enumerate() {
            let mut next = 0;
            for (a, &row) in components.iter().enumerate() {
                if (column..held).contains(&row) {
                    // The components of a node mostly follow each other.
                    let place = match rows.get(next) {
                        Some(&found) if found == row => next,
                        _ => rows.partition_point(|&r| r < row),
                    };
                    values[start + place] += entry(i, a);
                    next = place + 1;
                }
            }
        }
    }
}
