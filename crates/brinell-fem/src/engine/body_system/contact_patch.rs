//! The ends of the contact.

/// Part of the force that a part of the contact carries at least to be resolved for its own sake.
pub(crate) const LEAST_PART: f64 = 0.05;

/// Part of an element before a node at which a contact ends as the node begins to carry force. A
/// set of loaded nodes serves ends over one element, from there to the same place before the next
/// node.
pub(crate) const BEFORE_NODE: f64 = 0.3;
/// Power of the pressure ratio in the place of an end between two such places.
const PRESSURE_POWER: f64 = 1.85;
/// Factor of the gap ratio.
const OPENING: f64 = 0.64;

/// The loaded part of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactPatch {
    /// Left end, interpolated \[mm\].
    pub left: f64,
    /// Right end, interpolated \[mm\].
    pub right: f64,
}

/// What is known of the candidate pairs, in ascending order of x.
#[derive(Clone, Copy)]
pub(crate) struct Pairs<'a> {
    /// Abscissae \[mm\].
    pub x: &'a [f64],
    /// Pressures \[MPa\].
    pub pressure: &'a [f64],
    /// Gaps after loading \[mm\].
    pub gap: &'a [f64],
    /// Whether the first abscissa is an axis of symmetry, so that the left end mirrors the right one.
    pub symmetric: bool,
}

impl ContactPatch {
    /// Finds the ends of the contact; `None` where nothing touches. `edge` is the edge of a surface
    /// that a node stands for.
    ///
    /// From the place where the outermost loaded node x_j took up force to that where the next one
    /// will, a contact ends by the pressures p of the last two loaded nodes and the gaps g of the
    /// first two open ones:
    ///
    /// ```text
    /// a = x_j + h (f - 0.3),  f = r^1.85 / (r^1.85 + 0.64 γ),
    /// r = p_j/p_(j-1),  γ = g_(j+1)/g_(j+2)
    /// ```
    ///
    /// It moves steadily as a node takes up force, where `γ` or r vanishes. Where the contact ends
    /// at an edge, before one or at a single node, the end is that of [`Self::for_sizing`].
    pub(crate) fn find(pairs: Pairs<'_>, edge: impl Fn(usize) -> Option<f64>) -> Option<Self> {
        Self::by_ends(pairs, |outermost, outward| {
            edge(outermost)
                .or_else(|| end_by_gaps(pairs, outermost, outward, &edge))
                .unwrap_or_else(|| end_by_root(pairs, outermost, outward))
        })
    }

    /// Finds the ends by which meshes are sized.
    ///
    /// From the last node that is loaded over its whole length, the pressure is taken to fall like
    /// the square root of the distance to the end; the end is where it has to be for the outermost
    /// node to receive its force. Where that node stands for an edge of a surface, the contact
    /// ends at the edge.
    pub(crate) fn for_sizing(
        pairs: Pairs<'_>,
        edge: impl Fn(usize) -> Option<f64>,
    ) -> Option<Self> {
        Self::by_ends(pairs, |outermost, outward| {
            edge(outermost).unwrap_or_else(|| end_by_root(pairs, outermost, outward))
        })
    }

    /// The ends by the end beyond an outermost node in a direction, -1 or 1.
    fn by_ends(pairs: Pairs<'_>, end: impl Fn(usize, isize) -> f64) -> Option<Self> {
        let first = pairs.pressure.iter().position(|&p| p > 0.0)?;
        let last = pairs.pressure.iter().rposition(|&p| p > 0.0)?;
        let right = end(last, 1);
        Some(Self { left: if pairs.symmetric { -right } else { end(first, -1) }, right })
    }

    /// Ends of each connected part of the contact, left to right, at the outermost loaded nodes
    /// \[mm\]; on a half model those of the half.
    pub fn parts(x: &[f64], pressure: &[f64]) -> Vec<Self> {
        let mut parts: Vec<Self> = Vec::new();
        let mut open = false;
        for (&x, &p) in x.iter().zip(pressure) {
            match (p > 0.0, open, parts.last_mut()) {
                (true, true, Some(part)) => part.right = x,
                (true, _, _) => parts.push(Self { left: x, right: x }),
                (false, _, _) => {}
            }
            open = p > 0.0;
        }
        parts
    }

    /// Returns the part of the contact between two walls.
    #[must_use]
    pub fn within(self, [left, right]: [f64; 2]) -> Self {
        Self { left: self.left.max(left), right: self.right.min(right) }
    }

    /// Half of the distance between the ends \[mm\].
    pub fn half_width(&self) -> f64 {
        0.5 * (self.right - self.left)
    }
}

/// The node so many steps beyond another one, in the direction of `outward`.
fn node(x: &[f64], from: usize, outward: isize, steps: isize) -> Option<usize> {
    from.checked_add_signed(outward * steps).filter(|&k| k < x.len())
}

/// The end by two pressures and two gaps; `None` where there are not so many, or the next node
/// stands for an edge.
fn end_by_gaps(
    Pairs { x, pressure, gap, .. }: Pairs<'_>,
    outermost: usize,
    outward: isize,
    edge: impl Fn(usize) -> Option<f64>,
) -> Option<f64> {
    let at = |steps: isize| node(x, outermost, outward, steps);
    let (inner, next, second) = (at(-1)?, at(1)?, at(2)?);
    if pressure[inner] <= 0.0 || gap[second] <= 0.0 || edge(next).is_some() {
        return None;
    }
    let loaded = (pressure[outermost] / pressure[inner]).powf(PRESSURE_POWER);
    let part = loaded / (loaded + OPENING * gap[next].max(0.0) / gap[second]);
    let before = |k: usize, inner: usize| x[k] - BEFORE_NODE * (x[k] - x[inner]);
    let from = before(outermost, inner);
    Some(from + part * (before(next, outermost) - from))
}

/// The end of a pressure that falls like a square root; the outermost node where it is alone.
fn end_by_root(Pairs { x, pressure, .. }: Pairs<'_>, outermost: usize, outward: isize) -> f64 {
    let inner = node(x, outermost, outward, -1).filter(|&k| pressure[k] > 0.0);
    let Some(inner) = inner.filter(|_| node(x, outermost, outward, 1).is_some()) else {
        return x[outermost];
    };
    // In elements, counted outward from the inner node.
    let share = pressure[outermost] / pressure[inner];
    let (mut low, mut high) = (0.0, 2.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if outermost_share(middle) < share { low = middle } else { high = middle }
    }
    x[inner] + 0.5 * (low + high) * (x[outermost] - x[inner])
}

/// Pressure of the outermost node over that of the one before, `∫ N √(1 - t/e) dt` with the hat
/// function N at 1, for a pressure that ends at the distance `e <= 2` elements from the inner
/// node.
pub(crate) fn outermost_share(end: f64) -> f64 {
    const STEPS: u32 = 200;
    let step = end / f64::from(STEPS);
    let value = |k: u32| {
        let t = (f64::from(k) + 0.5) * step;
        (1.0 - (t - 1.0).abs()).max(0.0) * (1.0 - t / end).sqrt()
    };
    (0..STEPS).map(value).sum::<f64>() * step
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nodal values as a mesh gives them: Hertz's pressure weighted with each node's hat function.
    fn hertz_nodes(a: f64, h: f64, n: usize) -> (Vec<f64>, Vec<f64>) {
        let x: Vec<f64> = (0..n).map(|k| k as f64 * h).collect();
        let weighted = |centre: f64| {
            let samples = (0..2000).map(|k| (f64::from(k) + 0.5) / 1000.0 - 1.0);
            let values = samples.map(|t| {
                let s = (centre + t * h) / a;
                (1.0 - t.abs()) * (1.0 - s * s).max(0.0).sqrt()
            });
            values.sum::<f64>() / 1000.0
        };
        let p = x.iter().map(|&x| weighted(x)).collect();
        (x, p)
    }

    fn pairs<'a>(x: &'a [f64], pressure: &'a [f64], gap: &'a [f64], symmetric: bool) -> Pairs<'a> {
        Pairs { x, pressure, gap, symmetric }
    }

    #[test]
    fn finds_the_half_width_of_hertz_to_a_fraction_of_an_element() {
        for a in [1.0, 1.02, 1.04, 1.07] {
            let (x, p) = hertz_nodes(a, 0.1, 20);
            let patch = ContactPatch::for_sizing(pairs(&x, &p, &[], true), |_| None).unwrap();
            assert!((patch.half_width() - a).abs() < 0.02, "{a}: {patch:?}");
        }
    }

    #[test]
    fn an_off_centre_contact_has_two_ends() {
        let (x, p) = hertz_nodes(1.03, 0.1, 20);
        let x_full: Vec<f64> =
            x.iter().rev().map(|v| 2.0 - v).chain(x[1..].iter().map(|v| 2.0 + v)).collect();
        let p_full: Vec<f64> = p.iter().rev().copied().chain(p[1..].iter().copied()).collect();
        let all = pairs(&x_full, &p_full, &[], false);
        let patch = ContactPatch::for_sizing(all, |_| None).unwrap();
        assert!(
            (patch.left - 0.97).abs() < 0.02 && (patch.right - 3.03).abs() < 0.02,
            "{patch:?}"
        );
    }

    /// As a node takes up force the end goes on where it was, on columns of two widths too, and a
    /// set of loaded nodes serves ends over one element.
    #[test]
    fn an_end_moves_steadily_as_a_node_takes_up_force() {
        let x = [-0.5, 0.0, 1.0, 2.0, 4.0, 6.0];
        let right = |pressure: [f64; 6], gap: [f64; 6]| {
            ContactPatch::find(pairs(&x, &pressure, &gap, false), |_| None).unwrap().right
        };
        let open = [0.0, 0.0, 0.0, 0.0, 0.3, 0.9];
        let before = right([5.0, 5.0, 4.0, 0.0, 0.0, 0.0], open);
        let after = right([5.0, 5.0, 4.0, 1e-9, 0.0, 0.0], open);
        assert!((before - 1.7).abs() < 1e-12 && (after - 1.7).abs() < 1e-6, "{before}, {after}");
        let ends = [0.5, 1.0, 2.0, 3.0].map(|p| right([5.0, 5.0, 4.0, p, 0.0, 0.0], open));
        assert!(ends.is_sorted() && ends[3] < 4.0 - 2.0 * BEFORE_NODE, "{ends:?}");
    }

    #[test]
    fn beside_an_edge_the_pressure_falls_like_a_root() {
        let (x, p) = hertz_nodes(1.04, 0.1, 20);
        let gap: Vec<f64> = x.iter().map(|x| (x - 1.04).max(0.0).powf(1.5)).collect();
        let all = pairs(&x, &p, &gap, true);
        let at = |node: usize| ContactPatch::find(all, |k| (k == node).then_some(1.11));
        let sizing = ContactPatch::for_sizing(all, |_| None);
        assert_eq!(at(12), sizing);
        assert_ne!(at(13), sizing);
        assert!((at(11).unwrap().right - 1.11).abs() < 1e-12);
    }

    #[test]
    fn nothing_touches() {
        assert_eq!(
            ContactPatch::find(pairs(&[0.0, 1.0], &[0.0; 2], &[0.0; 2], true), |_| None),
            None
        );
    }
}
