//! Nested dissection on structured patches.
//!
//! A set of nodes is cut by a line of the lattice into two halves and the separator between them;
//! the halves are numbered first, each by the same rule, and the separator last. On an n-node
//! quadrilateral mesh this bounds the entries of the Cholesky factor by `O(n log n)` and the
//! operations by `O(n^1.5)`.
//!
//! # Reference
//! A. George, *Nested dissection of a regular finite element mesh*, SIAM J. Numer. Anal. 10 (1973)
//! 345–363.

use super::Graph;

/// Place of a node in a structured patch. Neighbouring nodes of one patch differ by at most 1 in
/// `i` and `j`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LatticePoint {
    /// Patch number; patches are parted from each other before they are bisected.
    pub patch: u32,
    /// First lattice coordinate.
    pub i: i32,
    /// Second lattice coordinate.
    pub j: i32,
}

/// Sets of this size are not cut any further.
const LEAF: usize = 6;

/// Rearranges `nodes` into elimination order.
pub(super) fn nested_dissection(nodes: &mut [u32], lattice: &[LatticePoint], graph: &Graph) {
    let mut scratch = Vec::with_capacity(nodes.len());
    let mut part = vec![Part::Outside; graph.len()];
    part_patches(nodes, lattice, graph, &mut part, &mut scratch);
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Outside,
    Low,
    High,
    Separator,
}

/// Parts the patches from one another, lowest number first, then bisects each.
fn part_patches(
    nodes: &mut [u32],
    lattice: &[LatticePoint],
    graph: &Graph,
    part: &mut [Part],
    scratch: &mut Vec<u32>,
) {
    let patches = nodes.iter().map(|&n| lattice[n as usize].patch);
    let (Some(first), Some(last)) = (patches.clone().min(), patches.max()) else { return };
    if first == last {
        bisect(nodes, lattice, graph, part, scratch);
        return;
    }
    let (low, high) = split(nodes, graph, part, scratch, |n| lattice[n as usize].patch == first);
    let (low_nodes, rest) = nodes.split_at_mut(low);
    bisect(low_nodes, lattice, graph, part, scratch);
    part_patches(&mut rest[..high], lattice, graph, part, scratch);
}

fn bisect(
    nodes: &mut [u32],
    lattice: &[LatticePoint],
    graph: &Graph,
    part: &mut [Part],
    scratch: &mut Vec<u32>,
) {
    if nodes.len() <= LEAF {
        return;
    }
    let extent = |coordinate: fn(&LatticePoint) -> i32| {
        let values = nodes.iter().map(|&n| coordinate(&lattice[n as usize]));
        values.fold((i32::MAX, i32::MIN), |(low, high), v| (low.min(v), high.max(v)))
    };
    let (i_range, j_range) = (extent(|p| p.i), extent(|p| p.j));
    let along_i = i_range.1 - i_range.0 >= j_range.1 - j_range.0;
    let coordinate: fn(&LatticePoint) -> i32 = if along_i { |p| p.i } else { |p| p.j };
    let (lowest, highest) = if along_i { i_range } else { j_range };
    if highest - lowest < 2 {
        return;
    }
    scratch.clear();
    scratch.extend_from_slice(nodes);
    let middle = scratch.len() / 2;
    let (_, &mut median, _) =
        scratch.select_nth_unstable_by_key(middle, |&n| coordinate(&lattice[n as usize]));
    let cut = coordinate(&lattice[median as usize]).clamp(lowest + 1, highest - 1);
    let (low, high) =
        split(nodes, graph, part, scratch, |n| coordinate(&lattice[n as usize]) <= cut);
    let (low_nodes, rest) = nodes.split_at_mut(low);
    bisect(low_nodes, lattice, graph, part, scratch);
    bisect(&mut rest[..high], lattice, graph, part, scratch);
}

/// Rearranges `nodes` into `[low, high, separator]` and returns the sizes of the first two. The
/// separator is made of the low nodes that touch a high one.
fn split(
    nodes: &mut [u32],
    graph: &Graph,
    part: &mut [Part],
    scratch: &mut Vec<u32>,
    is_low: impl Fn(u32) -> bool,
) -> (usize, usize) {
    for &n in nodes.iter() {
        part[n as usize] = if is_low(n) { Part::Low } else { Part::High };
    }
    for &n in nodes.iter() {
        if part[n as usize] == Part::Low
            && graph.neighbours(n).iter().any(|&m| part[m as usize] == Part::High)
        {
            part[n as usize] = Part::Separator;
        }
    }
    scratch.clear();
    scratch.extend_from_slice(nodes);
    let mut filled = 0;
    let mut sizes = [0; 3];
    for (size, wanted) in sizes.iter_mut().zip([Part::Low, Part::High, Part::Separator]) {
        for &n in scratch.iter().filter(|&&n| part[n as usize] == wanted) {
            nodes[filled] = n;
            filled += 1;
            *size += 1;
        }
    }
    for &n in nodes.iter() {
        part[n as usize] = Part::Outside;
    }
    (sizes[0], sizes[1])
}

#[cfg(test)]
#[expect(clippy::cast_sign_loss, clippy::cast_possible_truncation, reason = "small grids")]
mod tests {
    use super::*;

    /// An m × m grid of nodes joined as by quadrilaterals.
    pub(crate) fn grid(m: i32) -> (Graph, Vec<LatticePoint>) {
        let at = |i: i32, j: i32| (i * m + j) as u32;
        let cells: Vec<[u32; 4]> = (0..m - 1)
            .flat_map(|i| (0..m - 1).map(move |j| (i, j)))
            .map(|(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
            .collect();
        let lattice =
            (0..m).flat_map(|i| (0..m).map(move |j| LatticePoint { patch: 0, i, j })).collect();
        (Graph::from_cells((m * m) as usize, &cells), lattice)
    }

    #[test]
    fn numbers_every_node_once_and_the_middle_line_last() {
        let m = 17;
        let (graph, lattice) = grid(m);
        let mut nodes: Vec<u32> = (0..graph.len() as u32).collect();
        nested_dissection(&mut nodes, &lattice, &graph);
        let mut sorted = nodes.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..graph.len() as u32).collect::<Vec<_>>());
        let last: Vec<i32> =
            nodes[nodes.len() - m as usize..].iter().map(|&n| lattice[n as usize].i).collect();
        assert_eq!(last, vec![8; m as usize]);
    }
}
