//! The ends of the contact.

/// Part of the force that a part of the contact carries at least to be resolved for its own sake.
pub(crate) const LEAST_PART: f64 = 0.05;

/// The loaded part of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactPatch {
    /// Left end, interpolated \[mm\].
    pub left: f64,
    /// Right end, interpolated \[mm\].
    pub right: f64,
}

impl ContactPatch {
    /// Finds the ends of the pressure over ascending abscissae; `None` where nothing touches. On a
    /// half model, whose first abscissa is the axis, the left end mirrors the right one.
    ///
    /// From the last node that is loaded over its whole length, the pressure is taken to fall like
    /// the square root of the distance to the end; the end is where it has to be for the outermost
    /// node to receive its force. Where that node stands for an edge of a surface, the contact
    /// ends at the edge.
    pub fn find(
        x: &[f64],
        pressure: &[f64],
        symmetric: bool,
        edge: impl Fn(usize) -> Option<f64>,
    ) -> Option<Self> {
        let first = pressure.iter().position(|&p| p > 0.0)?;
        let last = pressure.iter().rposition(|&p| p > 0.0)?;
        let right =
            edge(last).unwrap_or_else(|| end_beyond(x, pressure, last, |k| k.checked_add(1)));
        let left = if symmetric {
            -right
        } else {
            edge(first).unwrap_or_else(|| end_beyond(x, pressure, first, |k| k.checked_sub(1)))
        };
        Some(Self { left, right })
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

/// The end of the pressure beyond its outermost loaded node, in the direction of `outward`.
fn end_beyond(
    x: &[f64],
    pressure: &[f64],
    outermost: usize,
    outward: impl Fn(usize) -> Option<usize>,
) -> f64 {
    let beyond = outward(outermost).filter(|&k| k < x.len());
    let Some(beyond) = beyond else { return x[outermost] };
    let inner = if beyond > outermost { outermost.checked_sub(1) } else { Some(outermost + 1) };
    let Some(inner) = inner.filter(|&k| k < x.len() && pressure[k] > 0.0) else {
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

    #[test]
    fn finds_the_half_width_of_hertz_to_a_fraction_of_an_element() {
        for a in [1.0, 1.02, 1.04, 1.07] {
            let (x, p) = hertz_nodes(a, 0.1, 20);
            let patch = ContactPatch::find(&x, &p, true, |_| None).unwrap();
            assert!((patch.half_width() - a).abs() < 0.02, "{a}: {patch:?}");
        }
    }

    #[test]
    fn an_off_centre_contact_has_two_ends() {
        let (x, p) = hertz_nodes(1.03, 0.1, 20);
        let x_full: Vec<f64> =
            x.iter().rev().map(|v| 2.0 - v).chain(x[1..].iter().map(|v| 2.0 + v)).collect();
        let p_full: Vec<f64> = p.iter().rev().copied().chain(p[1..].iter().copied()).collect();
        let patch = ContactPatch::find(&x_full, &p_full, false, |_| None).unwrap();
        assert!(
            (patch.left - 0.97).abs() < 0.02 && (patch.right - 3.03).abs() < 0.02,
            "{patch:?}"
        );
    }

    #[test]
    fn nothing_touches() {
        assert_eq!(ContactPatch::find(&[0.0, 1.0], &[0.0, 0.0], true, |_| None), None);
    }
}
