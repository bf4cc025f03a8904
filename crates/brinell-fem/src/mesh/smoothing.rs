//! The smoothing of folded rings.
//!
//! Where the zone takes up most of a narrow body, or lies far from its middle, interpolation
//! between block and boundary can fold rings over. Then the nodes around the folded elements are
//! moved towards where the coordinates `(ξ, η)` of the grid are harmonic functions of the place
//! (Winslow):
//!
//! ```text
//! α X_ξξ - 2 β X_ξη + γ X_ηη = 0,   α = X_η·X_η,  β = X_ξ·X_η,  γ = X_ξ·X_ξ
//! ```
//!
//! A harmonic map onto a convex domain, here a rectangle, is one-to-one, so that nothing folds. It
//! is solved for `X = (ln r, φ)`, a conformal image of the place, in which growing rings are even
//! steps and the equation is the same. Only the nodes around folded elements move, because on
//! finite steps the map itself folds at the corners of the block.
//!
//! # Reference
//! A. M. Winslow, *Numerical solution of the quasilinear Poisson equation in a nonuniform triangle
//! mesh*, J. Comput. Phys. 1 (1966) 149–172.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::{Mesh, quality};

/// Rounds at most, each of so many sweeps over the nodes around what is folded.
const ROUNDS: usize = 60;
const SWEEPS: usize = 10;
/// Rounds after which the part that is moved grows by a layer of nodes to each side.
const ROUNDS_PER_LAYER: usize = 4;

/// The ring nodes of a mesh as a grid: `[ring][ray]`, the perimeter of the block first.
struct RingGrid {
    nodes: Vec<Vec<u32>>,
}

impl RingGrid {
    fn of(mesh: &Mesh) -> Option<Self> {
        let is_ring = |node: u32| mesh.lattice[node as usize].patch == 1;
        let first =
            mesh.elements.iter().position(|corners| corners.iter().any(|&node| is_ring(node)))?;
        let rays = mesh.lattice.iter().filter(|p| p.patch == 1 && p.j == 0).count();
        let mut perimeter: Vec<u32> =
            mesh.elements[first..].iter().take(rays - 1).map(|c| c[0]).collect();
        perimeter.push(mesh.elements[first + rays - 2][1]);
        let mut nodes = vec![perimeter];
        let ring_nodes: Vec<u32> =
            (0u32..).take(mesh.nodes.len()).filter(|&node| is_ring(node)).collect();
        nodes.extend(ring_nodes.chunks(rays).map(<[u32]>::to_vec));
        Some(Self { nodes })
    }
}

/// Moves inner nodes of the rings about `centre` until no element is folded, or gives up.
pub(super) fn unfold(mesh: &mut Mesh, centre: [f64; 2]) {
    let Some(grid) = RingGrid::of(mesh) else { return };
    let (rings, rays) = (grid.nodes.len(), grid.nodes[0].len());
    let polar = |node: u32| {
        let [x, y] = mesh.nodes[node as usize];
        let (x, y) = (x - centre[0], y - centre[1]);
        let angle = y.atan2(x);
        [x.hypot(y).ln(), if angle > FRAC_PI_2 { angle - TAU } else { angle }]
    };
    let mut place: Vec<Vec<[f64; 2]>> =
        grid.nodes.iter().map(|ring| ring.iter().map(|&node| polar(node)).collect()).collect();
    // Steps of η along the last ray, the axis or the far free surface.
    let eta: Vec<f64> = place.iter().map(|ring| ring[rays - 1][0]).collect();
    for round in 0..ROUNDS {
        let folded: Vec<bool> =
            (0..mesh.elements.len()).map(|element| quality::is_folded(mesh, element)).collect();
        if !folded.contains(&true) {
            return;
        }
        let mut is_near = vec![false; mesh.nodes.len()];
        for (corners, _) in mesh.elements.iter().zip(&folded).filter(|(_, folded)| **folded) {
            for &node in corners {
                is_near[node as usize] = true;
            }
        }
        let reach = 1 + round / ROUNDS_PER_LAYER;
        let is_moved = |k: usize, s: usize| {
            (k.saturating_sub(reach)..(k + reach + 1).min(rings)).any(|k| {
                (s.saturating_sub(reach)..(s + reach + 1).min(rays))
                    .any(|s| is_near[grid.nodes[k][s] as usize])
            })
        };
        let inner = (1..rings - 1).flat_map(|k| (1..rays - 1).map(move |s| (k, s)));
        let moved: Vec<(usize, usize)> = inner.filter(|&(k, s)| is_moved(k, s)).collect();
        for _ in 0..SWEEPS {
            for &(k, s) in &moved {
                place[k][s] = winslow(&place, k, s, eta[k] - eta[k - 1], eta[k + 1] - eta[k]);
            }
        }
        for &(k, s) in &moved {
            let [log_radius, angle] = place[k][s];
            let ((sin, cos), radius) = (angle.sin_cos(), log_radius.exp());
            mesh.nodes[grid.nodes[k][s] as usize] =
                [centre[0] + radius * cos, centre[1] + radius * sin];
        }
    }
}

/// Returns the position of a node between its neighbours, whose steps of η may differ.
fn winslow(place: &[Vec<[f64; 2]>], k: usize, s: usize, below: f64, above: f64) -> [f64; 2] {
    let component = |c: usize| {
        let (left, right) = (place[k][s - 1][c], place[k][s + 1][c]);
        let (inner, outer) = (place[k - 1][s][c], place[k + 1][s][c]);
        let cross = place[k + 1][s + 1][c] - place[k + 1][s - 1][c] - place[k - 1][s + 1][c]
            + place[k - 1][s - 1][c];
        [
            0.5 * (right - left),
            (outer - inner) / (below + above),
            0.5 * cross / (below + above),
            left + right,
            inner,
            outer,
        ]
    };
    let [x, y] = [component(0), component(1)];
    let alpha = x[1] * x[1] + y[1] * y[1];
    let beta = x[0] * x[1] + y[0] * y[1];
    let gamma = x[0] * x[0] + y[0] * y[0];
    // X_ηη = 2 (outer/above + inner/below - X (1/above + 1/below)) / (above + below)
    let weight = 2.0 * gamma / (below + above);
    let whole = 2.0 * alpha + weight * (1.0 / above + 1.0 / below);
    [x, y].map(|[_, _, cross, sides, inner, outer]| {
        (alpha * sides - 2.0 * beta * cross + weight * (outer / above + inner / below)) / whole
    })
}
