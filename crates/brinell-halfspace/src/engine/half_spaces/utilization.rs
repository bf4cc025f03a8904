//! Utilization of a half-space: von Mises stress over yield stress.

use super::law::initial_stress_over_depth;
use super::problem::HalfSpaceProblem;
use super::step::{HalfSpaceBody, HalfSpaceStep, von_mises};
use brinell_material::Solid;

/// Parts of the depth from the middle of the layer above to that of the layer below.
const PARTS: usize = 16;

/// The point with the largest ratio of stress to yield stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HighestUtilization {
    /// Von Mises stress over the nominal yield stress of the unloaded body.
    pub ratio: f64,
    /// 0 for the upper body, 1 for the lower body.
    pub side: usize,
    /// `[x, y, z]`: the middle of a cell, at any depth \[mm\].
    pub position: [f64; 3],
}

impl HalfSpaceProblem {
    /// Returns the highest utilization of all bodies with a hardening curve; `None` without one.
    pub fn highest_utilization(&self, step: &HalfSpaceStep) -> Option<HighestUtilization> {
        let sides = self.materials.iter().zip(&step.field.bodies).enumerate();
        let of_sides = sides.filter_map(|(side, (material, body))| {
            highest_in(side, material.as_ref()?, self.orientation(), body.as_deref()?)
        });
        of_sides.max_by(|a, b| a.ratio.total_cmp(&b.ratio))
    }
}

/// The highest utilization of a body: the most stressed column of each layer is followed over the
/// depth, from the middle of the layer above or the surface to that of the layer below. There the
/// stress of the pressure is the parabola that has the means of three layers, and initial stress
/// and strength are those of the depth.
fn highest_in(
    side: usize,
    material: &Solid,
    angle: f64,
    body: &HalfSpaceBody,
) -> Option<HighestUtilization> {
    let (law, strength) = (material.hardening_law()?, material.strength());
    let initial = initial_stress_over_depth(material, angle);
    let (layers, n_cells, ny) = (&body.layers, body.grid.n_cells(), body.grid.ny());
    let limit = |depth: f64| {
        law.nominal_yield_stress() * strength.map_or(1.0, |strength| strength.factor(depth))
    };
    let of_layer = |layer: usize| {
        let cell = (0..n_cells)
            .max_by(|a, b| body.von_mises(layer, *a).total_cmp(&body.von_mises(layer, *b)))?;
        let of_pressure = |layer: usize| {
            let [xx, yy, xy] = initial(layers.middle(layer));
            let before = [xx, yy, 0.0, xy, 0.0, 0.0];
            std::array::from_fn(|k| body.stress.component(layer, k)[cell] - before[k])
        };
        let first = layer.saturating_sub(1).min(layers.len().checked_sub(3)?);
        let parabola = Parabola {
            faces: layers.faces().get(first..first + 4)?.try_into().ok()?,
            means: [0, 1, 2].map(|below| of_pressure(first + below)),
        };
        let above = layer.checked_sub(1).map_or(0.0, |above| layers.middle(above));
        let below = layers.middle((layer + 1).min(layers.len() - 1));
        let at = |sample: usize| {
            let depth = above + (below - above) * sample as f64 / PARTS as f64;
            let [xx, yy, xy] = initial(depth);
            let before = [xx, yy, 0.0, xy, 0.0, 0.0];
            let of_pressure = parabola.at(depth);
            let stress = std::array::from_fn(|k| of_pressure[k] + before[k]);
            HighestUtilization {
                ratio: von_mises(stress) / limit(depth),
                side,
                position: [body.grid.x(cell / ny), body.grid.y(cell % ny), depth],
            }
        };
        (0..=PARTS).map(at).max_by(|a, b| a.ratio.total_cmp(&b.ratio))
    };
    (0..layers.len()).filter_map(of_layer).max_by(|a, b| a.ratio.total_cmp(&b.ratio))
}

/// A stress over depth, quadratic in each component, with given means over three layers.
struct Parabola {
    faces: [f64; 4],
    means: [[f64; 6]; 3],
}

impl Parabola {
    /// The derivative of the cubic that has the integral of the stress at the faces.
    fn at(&self, z: f64) -> [f64; 6] {
        let [a, b, c, d] = self.faces;
        let linear = (z - a) + (z - b);
        let quadratic = (z - a) * (z - b) + (z - a) * (z - c) + (z - b) * (z - c);
        std::array::from_fn(|k| {
            let [first, second, third] = self.means.map(|mean| mean[k]);
            let (upper, lower) = ((second - first) / (c - a), (third - second) / (d - b));
            first + upper * linear + (lower - upper) / (d - a) * quadratic
        })
    }
}
