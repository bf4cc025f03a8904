//! Strength over the depth below a surface.

use std::fmt::Debug;
use std::sync::Arc;

/// Factors of the hardening curve over depth: linear between points, constant before the first and
/// beyond the last.
#[derive(Debug, Clone, PartialEq)]
pub struct StrengthProfile {
    points: Vec<[f64; 2]>,
}

impl StrengthProfile {
    /// Factors at points `[depth, s]` \[mm, 1\] in order of depth; 1 everywhere without points.
    pub fn new(points: Vec<[f64; 2]>) -> Self {
        Self { points }
    }

    /// The factor at a depth \[mm\].
    pub fn factor(&self, depth: f64) -> f64 {
        interpolate(&self.points, depth).unwrap_or(1.0)
    }

    /// Smallest and largest factor.
    pub fn range(&self) -> (f64, f64) {
        let factors = || self.points.iter().map(|[_, s]| *s);
        (factors().fold(f64::INFINITY, f64::min), factors().fold(0.0, f64::max))
    }

    /// Points `[depth, s]` \[mm, 1\].
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }
}

/// Interpolates linearly between points in order of depth, constant beyond the ends; `None`
/// without points.
pub fn interpolate(points: &[[f64; 2]], depth: f64) -> Option<f64> {
    let right = points.partition_point(|point| point[0] <= depth);
    match (right.checked_sub(1).and_then(|k| points.get(k)), points.get(right)) {
        (Some([z0, s0]), Some([z1, s1])) => Some(s0 + (s1 - s0) * ((depth - z0) / (z1 - z0))),
        (Some([_, s]), None) | (None, Some([_, s])) => Some(*s),
        (None, None) => None,
    }
}

/// A body whose points lie below an undeformed surface.
pub trait Depth: Debug + Send + Sync {
    /// Distance of a place `[x, y]` from the surface, along its normal \[mm\].
    fn depth_below(&self, position: [f64; 2]) -> f64;
}

/// Factors of the hardening curve in a body.
#[derive(Debug, Clone)]
pub struct DepthStrength {
    profile: StrengthProfile,
    body: Arc<dyn Depth>,
}

impl DepthStrength {
    /// Factors over the depth in a body.
    pub fn new(profile: StrengthProfile, body: impl Depth + 'static) -> Self {
        Self { profile, body: Arc::new(body) }
    }

    /// The factor at a place `[x, y]` of the body \[mm\].
    pub fn factor(&self, position: [f64; 2]) -> f64 {
        self.profile.factor(self.body.depth_below(position))
    }

    /// Smallest and largest factor.
    pub fn range(&self) -> (f64, f64) {
        self.profile.range()
    }
}
