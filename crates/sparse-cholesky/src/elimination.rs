//! The order in which nodes are eliminated, and its elimination tree.

#![expect(
    clippy::cast_possible_truncation,
    reason = "nodes are numbered by u32, so that there are fewer than 2^32 of them"
)]

use super::nested_dissection::nested_dissection;
use super::{Graph, LatticePoint};

/// A fill-reducing, postordered numbering of nodes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EliminationOrder {
    /// `node_at[position]`.
    node_at: Vec<u32>,
}

impl EliminationOrder {
    /// Orders the nodes of a graph by nested dissection, except the trailing nodes, which come
    /// last in the given order.
    ///
    /// Afterwards the order is replaced by a postorder of its elimination tree, which changes no
    /// fill but puts the columns of each supernode side by side.
    ///
    /// # Invariants
    /// If the rest of the graph is connected, its elimination couples all trailing nodes: they
    /// form a chain at the root of the tree and keep their order.
    pub fn new(graph: &Graph, lattice: &[LatticePoint], trailing: &[u32]) -> Self {
        let mut is_trailing = vec![false; graph.len()];
        for &node in trailing {
            is_trailing[node as usize] = true;
        }
        let mut node_at: Vec<u32> =
            (0u32..).zip(&is_trailing).filter(|(_, last)| !**last).map(|(node, _)| node).collect();
        nested_dissection(&mut node_at, lattice, graph);
        node_at.extend_from_slice(trailing);
        let order = postorder(&node_at, graph);
        Self { node_at: order.into_iter().map(|position| node_at[position as usize]).collect() }
    }

    /// Nodes from first eliminated to last.
    pub fn nodes(&self) -> &[u32] {
        &self.node_at
    }

    /// Position of each node in the order.
    pub fn positions(&self) -> Vec<u32> {
        positions(&self.node_at)
    }
}

/// End of a list.
pub(crate) const NONE: u32 = u32::MAX;

fn positions(node_at: &[u32]) -> Vec<u32> {
    let mut position = vec![0u32; node_at.len()];
    for (k, &node) in (0u32..).zip(node_at) {
        position[node as usize] = k;
    }
    position
}

/// Parent of each position in the elimination tree of the graph numbered by `node_at`.
///
/// # Reference
/// J. W. H. Liu, *The role of elimination trees in sparse factorization*, SIAM J. Matrix Anal.
/// Appl. 11 (1990) 134–172, algorithm 4.2 (path compression).
fn elimination_tree(node_at: &[u32], graph: &Graph) -> Vec<u32> {
    let n = node_at.len();
    let position = positions(node_at);
    let (mut parent, mut ancestor) = (vec![NONE; n], vec![NONE; n]);
    for (k, &node) in (0u32..).zip(node_at) {
        for &m in graph.neighbours(node) {
            let mut r = position[m as usize];
            if r >= k {
                continue;
            }
            loop {
                let next = ancestor[r as usize];
                ancestor[r as usize] = k;
                if next == k {
                    break;
                }
                if next == NONE {
                    parent[r as usize] = k;
                    break;
                }
                r = next;
            }
        }
    }
    parent
}

/// Positions in postorder of the elimination tree: children in their old order, each before its
/// parent.
fn postorder(node_at: &[u32], graph: &Graph) -> Vec<u32> {
    let parent = elimination_tree(node_at, graph);
    let n = node_at.len();
    let (mut first_child, mut next_sibling) = (vec![NONE; n], vec![NONE; n]);
    let mut roots = Vec::new();
    for k in (0..n as u32).rev() {
        match parent[k as usize] {
            NONE => roots.push(k),
            p => {
                next_sibling[k as usize] = first_child[p as usize];
                first_child[p as usize] = k;
            }
        }
    }
    let mut order = Vec::with_capacity(n);
    let mut stack = Vec::new();
    while let Some(root) = roots.pop() {
        stack.push(root);
        while let Some(&top) = stack.last() {
            match first_child[top as usize] {
                NONE => {
                    order.push(top);
                    stack.pop();
                }
                child => {
                    first_child[top as usize] = next_sibling[child as usize];
                    stack.push(child);
                }
            }
        }
    }
    order
}

#[cfg(test)]
#[expect(clippy::cast_sign_loss, reason = "small grids")]
mod tests {
    use super::*;

    fn strip(columns: i32, rows: i32) -> (Graph, Vec<LatticePoint>) {
        let at = |i: i32, j: i32| (i * rows + j) as u32;
        let cells: Vec<[u32; 4]> = (0..columns - 1)
            .flat_map(|i| (0..rows - 1).map(move |j| (i, j)))
            .map(|(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
            .collect();
        let lattice = (0..columns)
            .flat_map(|i| (0..rows).map(move |j| LatticePoint { patch: 0, i, j }))
            .collect();
        (Graph::from_cells((columns * rows) as usize, &cells), lattice)
    }

    #[test]
    fn trailing_nodes_stay_last_and_in_order() {
        let (graph, lattice) = strip(12, 9);
        let trailing: Vec<u32> = (3..8).map(|i| i * 9).collect();
        let order = EliminationOrder::new(&graph, &lattice, &trailing);
        let mut sorted = order.nodes().to_vec();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..108).collect::<Vec<u32>>());
        assert_eq!(&order.nodes()[103..], trailing);
    }

    #[test]
    fn postorder_numbers_children_before_parents_without_gaps() {
        let (graph, lattice) = strip(10, 10);
        let order = EliminationOrder::new(&graph, &lattice, &[]);
        let parent = elimination_tree(order.nodes(), &graph);
        // In a postorder a node that is not a leaf directly follows its last child.
        for k in 1..100u32 {
            assert!(parent[k as usize] == NONE || parent[k as usize] > k);
            let has_child = parent[..k as usize].contains(&k);
            assert!(!has_child || parent[k as usize - 1] == k);
        }
    }
}
