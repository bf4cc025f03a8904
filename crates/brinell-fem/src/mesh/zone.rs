//! The contact zone: the abscissae of the candidate pairs.

use std::sync::Arc;

use super::{Corner, Outline, ROUNDING};

/// Largest part of the body's surface that the zone may take.
const MAX_ZONE_SPAN: f64 = 0.8;
/// Least distance of two corners that both become nodes, over the element size.
const MIN_COLUMN: f64 = 0.3;
/// Times that the column beside an edge is halved towards it.
const GRADING_LEVELS: i32 = 3;

/// Distance of the outermost pair from an edge, over the element size. A pair at the edge itself
/// acts like a punch that is wider by this distance: with 20 elements the elastic approach is 0.25
/// % low and the limit load of a flat punch 0.34 % high.
const EDGE_INSET: f64 = 0.1;

/// The part of the surface where contact may happen, and its division into columns of about the
/// same width.
///
/// Corners of the surfaces are nodes. Columns beside an edge are graded towards it.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactZone {
    abscissae: Arc<[f64]>,
    /// Nodes that are corners, ascending, and these corners.
    corners: Arc<[(usize, Corner)]>,
    spacing: f64,
    is_graded: bool,
    symmetric: bool,
}

impl ContactZone {
    /// Even columns from `x_min` to `x_max` \[mm\]. With `symmetric`, `x_min` is 0 and an axis of
    /// symmetry.
    pub fn uniform(x_min: f64, x_max: f64, columns: usize, symmetric: bool) -> Self {
        let spacing = (x_max - x_min) / columns as f64;
        let abscissae = (0..=columns)
            .map(|k| if k == columns { x_max } else { x_min + spacing * k as f64 })
            .collect();
        Self { abscissae, corners: Arc::default(), spacing, is_graded: false, symmetric }
    }

    /// Columns about as wide as those of [`Self::uniform`], between whose nodes no corner lies;
    /// corners are ascending. Of corners that are much closer than a column, the first one counts.
    pub fn with_corners(
        x_min: f64,
        x_max: f64,
        columns: usize,
        symmetric: bool,
        corners: &[Corner],
    ) -> Self {
        let mut zone = Self::uniform(x_min, x_max, columns, symmetric);
        let reach = MIN_COLUMN * zone.spacing;
        let mut breaks: Vec<(f64, Option<Corner>)> = vec![(x_min, None)];
        for &corner in corners {
            let x = corner.x - EDGE_INSET * zone.spacing * corner.edge();
            match breaks.last_mut() {
                Some(last) if last.1.is_none() && (x - last.0).abs() < 1e-9 * zone.spacing => {
                    last.1 = Some(corner);
                }
                Some(last) if x > last.0 + reach && x < x_max - reach => {
                    breaks.push((x, Some(corner)));
                }
                _ => {}
            }
        }
        if breaks.iter().all(|(_, corner)| corner.is_none()) {
            return zone;
        }
        breaks.push((x_max, None));
        let mut abscissae = vec![x_min];
        let mut nodes = Vec::new();
        for pair in breaks.windows(2) {
            let ((from, left), (to, right)) = (pair[0], pair[1]);
            if let Some(corner) = left {
                nodes.push((abscissae.len() - 1, corner));
            }
            let is_edge =
                |corner: Option<Corner>| corner.is_some_and(|corner| corner.edge() != 0.0);
            zone.is_graded |= is_edge(left) || is_edge(right);
            divide(from, to, zone.spacing, is_edge(left), is_edge(right), &mut abscissae);
        }
        zone.abscissae = abscissae.into();
        zone.corners = nodes.into();
        zone
    }

    /// Left end \[mm\]; 0 for a half model.
    pub fn x_min(&self) -> f64 {
        self.abscissae[0]
    }

    /// Right end \[mm\].
    pub fn x_max(&self) -> f64 {
        self.abscissae[self.columns()]
    }

    /// Elements across the zone.
    pub fn columns(&self) -> usize {
        self.abscissae.len() - 1
    }

    /// Whether `x = 0` is a symmetry axis and only `x >= 0` is meshed.
    pub fn is_symmetric(&self) -> bool {
        self.symmetric
    }

    /// Width of a column away from corners \[mm\].
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Abscissa of candidate node `k` \[mm\], the same on both bodies.
    pub fn abscissa(&self, k: usize) -> f64 {
        self.abscissae[k]
    }

    /// Abscissae of the candidate nodes \[mm\], ascending.
    pub fn abscissae(&self) -> &[f64] {
        &self.abscissae
    }

    /// Whether candidate node `k` is a corner of one of the surfaces.
    pub fn is_corner(&self, k: usize) -> bool {
        self.corner(k).is_some()
    }

    /// Whether candidate node `k` is a sharp corner or an edge.
    pub fn is_sharp_corner(&self, k: usize) -> bool {
        self.corner(k).is_some_and(|corner| !corner.is_rounded || corner.edge() != 0.0)
    }

    fn corner(&self, k: usize) -> Option<&Corner> {
        let place = self.corners.binary_search_by_key(&k, |(node, _)| *node).ok()?;
        self.corners.get(place).map(|(_, corner)| corner)
    }

    /// Returns the abscissa of the edge beside candidate node `k`, if there is one \[mm\]; the
    /// node lies slightly inside the edge.
    pub fn edge(&self, k: usize) -> Option<f64> {
        self.corner(k).filter(|corner| corner.edge() != 0.0).map(|corner| corner.x)
    }

    /// Whether all columns are equally wide and no node is a corner.
    pub fn is_uniform(&self) -> bool {
        self.corners.is_empty()
    }

    /// Whether columns are graded towards an edge.
    pub fn is_graded(&self) -> bool {
        self.is_graded
    }

    /// Middle of the contact zone \[mm\]: the axis of a half model.
    pub fn centre(&self) -> f64 {
        if self.symmetric { 0.0 } else { 0.5 * (self.x_min() + self.x_max()) }
    }

    /// Whether the zone leaves enough of a body's surface beside it to be meshed.
    pub fn fits(&self, outline: &Outline) -> bool {
        let (left, right) = Self::room(outline);
        let slack = ROUNDING * (right - left);
        self.x_max() <= right + slack && self.x_min() >= left - slack
    }

    /// Where a zone may be on a body, from left to right \[mm\].
    pub fn room(outline: &Outline) -> (f64, f64) {
        let (left, right) = outline.span();
        // The span of a pin or a hole is where a zone may be.
        let part = if outline.ring().is_some() { 1.0 } else { MAX_ZONE_SPAN };
        (part * left, part * right)
    }

    /// Largest half-width of a zone on a body \[mm\].
    pub(super) fn available(outline: &Outline) -> f64 {
        let (left, right) = outline.span();
        MAX_ZONE_SPAN * right.min(-left)
    }

    /// Half of the zone's width, both sides of the axis counted \[mm\].
    pub fn half_width(&self) -> f64 {
        if self.symmetric { self.x_max() } else { 0.5 * (self.x_max() - self.x_min()) }
    }

    /// Depths of the nodes in a block of so many rows as a part of its depth, from 0 to 1: graded
    /// towards the surface if columns are graded towards an edge.
    pub(super) fn row_depths(&self, rows: usize) -> Vec<f64> {
        if !self.is_graded {
            return (0..=rows).map(|row| row as f64 / rows as f64).collect();
        }
        let mut depths = vec![0.0];
        divide(0.0, 1.0, (rows as f64).recip(), true, false, &mut depths);
        depths
    }
}

/// Appends the nodes beyond `from` of columns as wide as `spacing`, graded towards ends that are
/// edges.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a small positive number of columns"
)]
fn divide(from: f64, to: f64, spacing: f64, from_edge: bool, to_edge: bool, nodes: &mut Vec<f64>) {
    let columns = ((to - from) / spacing)
        .round()
        .max(1.0 + f64::from(u8::from(from_edge && to_edge))) as usize;
    let width = (to - from) / columns as f64;
    let halvings = || (1..=GRADING_LEVELS).map(|level| width * 0.5_f64.powi(level));
    if from_edge {
        let inner: Vec<f64> = halvings().map(|distance| from + distance).collect();
        nodes.extend(inner.into_iter().rev());
    }
    nodes.extend((1..columns).map(|k| from + width * k as f64));
    if to_edge {
        nodes.extend(halvings().map(|distance| to - distance));
    }
    nodes.push(to);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_corners_columns_are_even() {
        let zone = ContactZone::uniform(-0.5, 0.5, 10, false);
        assert_eq!(zone, ContactZone::with_corners(-0.5, 0.5, 10, false, &[]));
        assert!(zone.is_uniform() && !zone.is_graded());
        assert_eq!(zone.row_depths(4), [0.0, 0.25, 0.5, 0.75, 1.0]);
    }

    #[test]
    fn corners_are_nodes_and_edges_are_graded() {
        let corner = |x: f64, slopes: [f64; 2]| Corner { x, slopes, is_rounded: false };
        let corners = [corner(0.0, [0.05, -0.05]), corner(0.73, [0.0, -10.0])];
        let zone = ContactZone::with_corners(0.0, 1.0, 10, true, &corners);
        let edge = (0..=zone.columns()).find(|&k| zone.edge(k) == Some(0.73)).unwrap();
        assert!(zone.is_corner(0) && zone.edge(0).is_none() && !zone.is_corner(1));
        assert!(zone.abscissae().windows(2).all(|pair| pair[1] > pair[0]));
        let inset = 0.73 - zone.abscissa(edge);
        assert!((inset - 0.1 * EDGE_INSET).abs() < 1e-12);
        let beside = zone.abscissa(edge + 1) - zone.abscissa(edge);
        assert!(beside > 0.0 && beside < 0.1 / 7.0);
        assert_eq!((zone.x_min(), zone.x_max()), (0.0, 1.0));
        assert!(zone.row_depths(5).len() > 6);
    }
}
