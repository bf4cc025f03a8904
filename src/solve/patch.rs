//! Where the contact begins and ends.

/// The loaded part of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactPatch {
    /// Left end, interpolated \[mm\].
    pub left: f64,
    /// Right end, interpolated \[mm\].
    pub right: f64,
}

impl ContactPatch {
    /// Finds the ends of the pressure over ascending abscissae; `None` where nothing touches. On a half model,
    /// whose first abscissa is the axis, the left end mirrors the right one.
    ///
    /// Near its end a contact pressure falls like the square root of the distance, so its square is extended
    /// linearly from the last nodes that are loaded over their whole length; the outermost loaded node, loaded
    /// over a part of it, only bounds the answer to its own element.
    pub fn find(x: &[f64], pressure: &[f64], symmetric: bool) -> Option<Self> {
        let first = pressure.iter().position(|&p| p > 0.0)?;
        let last = pressure.iter().rposition(|&p| p > 0.0)?;
        let right = end_beyond(x, pressure, last, |k| k.checked_add(1));
        let left = if symmetric { -right } else { end_beyond(x, pressure, first, |k| k.checked_sub(1)) };
        Some(Self { left, right })
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
    let neighbour = outward(outermost).filter(|&k| k < x.len());
    let limit = neighbour.map_or(x[outermost], |k| x[k]);
    let inward = |steps: usize| {
        let up = neighbour.map_or(outermost > 0, |k| k > outermost);
        if up { outermost.checked_sub(steps) } else { outermost.checked_add(steps).filter(|&k| k < x.len()) }
    };
    let (Some(near), Some(far)) = (inward(1), inward(2)) else { return x[outermost] };
    let (near_square, far_square) = (pressure[near].powi(2), pressure[far].powi(2));
    if far_square <= near_square {
        return 0.5 * (x[outermost] + limit);
    }
    let end = x[near] + (x[near] - x[far]) * near_square / (far_square - near_square);
    let (low, high) = if limit < x[near] { (limit, x[near]) } else { (x[near], limit) };
    end.clamp(low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nodal values as a mesh gives them: the mean of Hertz's pressure over each node's length.
    fn hertz_nodes(a: f64, h: f64, n: usize) -> (Vec<f64>, Vec<f64>) {
        let area = |x: f64| {
            let t = (x / a).clamp(-1.0, 1.0);
            0.5 * a * (t * (1.0 - t * t).sqrt() + t.asin())
        };
        let x: Vec<f64> = (0..n).map(|k| k as f64 * h).collect();
        let p = x
            .iter()
            .map(|&x| {
                let from = (x - 0.5 * h).max(0.0);
                (area(x + 0.5 * h) - area(from)) / (x + 0.5 * h - from)
            })
            .collect();
        (x, p)
    }

    #[test]
    fn finds_the_half_width_of_hertz_to_a_fraction_of_an_element() {
        for a in [1.0, 1.02, 1.04, 1.07] {
            let (x, p) = hertz_nodes(a, 0.1, 20);
            let patch = ContactPatch::find(&x, &p, true).unwrap();
            assert!((patch.half_width() - a).abs() < 0.02, "{a}: {patch:?}");
        }
    }

    #[test]
    fn an_off_centre_contact_has_two_ends() {
        let (x, p) = hertz_nodes(1.03, 0.1, 20);
        let x_full: Vec<f64> =
            x.iter().rev().map(|v| 2.0 - v).chain(x[1..].iter().map(|v| 2.0 + v)).collect();
        let p_full: Vec<f64> = p.iter().rev().copied().chain(p[1..].iter().copied()).collect();
        let patch = ContactPatch::find(&x_full, &p_full, false).unwrap();
        assert!((patch.left - 0.97).abs() < 0.02 && (patch.right - 3.03).abs() < 0.02, "{patch:?}");
    }

    #[test]
    fn nothing_touches() {
        assert_eq!(ContactPatch::find(&[0.0, 1.0], &[0.0, 0.0], true), None);
    }
}
