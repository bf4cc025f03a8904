//! The plastic laws of `material` in the cells of a half-space.

use std::sync::Arc;

use crate::{Layers, PlasticLaw};

use brinell_material::{
    BackstressTerm, FlowPlasticity, Flowing, HardeningLaw, OutOfPlane, ReturnMapping, Solid,
    scaled,
};
use brinell_method::settings::Theory;

/// Returns the plastic law of a material in the cells, if the material can yield. Each layer has
/// the strength at its middle.
///
/// Deformation theory follows one path from the stress-free state in one part, without backstress.
pub(super) fn law_of_cells(
    material: &Solid,
    theory: Theory,
    layers: &Layers,
    n_cells: usize,
) -> Option<Box<dyn PlasticLaw>> {
    let curve = Arc::clone(material.hardening_law()?);
    let of = Making { material, curve, theory, layers, n_cells };
    let terms = if theory == Theory::Flow { material.backstress() } else { &[] };
    // The number of terms is a type parameter: every cell stores one tensor for each term.
    Some(match *terms {
        [] => of.cells([]),
        [a] => of.cells([a]),
        [a, b] => of.cells([a, b]),
        [a, b, c] => of.cells([a, b, c]),
        [a, b, c, d, ..] => of.cells([a, b, c, d]),
    })
}

struct Making<'a> {
    material: &'a Solid,
    curve: Arc<dyn HardeningLaw>,
    theory: Theory,
    layers: &'a Layers,
    n_cells: usize,
}

impl Making<'_> {
    fn cells<const N: usize>(self, backstress: [BackstressTerm; N]) -> Box<dyn PlasticLaw> {
        let elastic = self.material.moduli();
        let model = |factor: f64| {
            let mapping = ReturnMapping::new(scaled(&self.curve, factor), elastic.shear);
            Arc::new(FlowPlasticity::new(elastic, mapping, backstress, OutOfPlane::Strained))
        };
        let strength = self.material.strength();
        let same = model(1.0);
        let of_layer = |layer: usize| match strength {
            Some(strength) => model(strength.factor(self.layers.middle(layer))),
            None => Arc::clone(&same),
        };
        let models: Vec<_> = (0..self.layers.len()).map(of_layer).collect();
        let parts = if self.theory == Theory::Flow { same.substeps() } else { 1 };
        let cells = vec![CellState::default(); self.layers.len() * self.n_cells];
        Box::new(Cells { models, parts, accepted: cells.clone(), current: cells })
    }
}

/// Cells that yield by flow theory, with N backstress terms.
struct Cells<const N: usize> {
    /// The material of each layer.
    models: Vec<Arc<FlowPlasticity<N>>>,
    /// Number of parts into which the law divides a path.
    parts: u32,
    accepted: Vec<CellState<N>>,
    current: Vec<CellState<N>>,
}

/// The internal variables of a cell beside its plastic strain.
#[derive(Clone, Copy)]
struct CellState<const N: usize> {
    accumulated: f64,
    backstress: [[f64; 6]; N],
    plastic_work: f64,
}

impl<const N: usize> Default for CellState<N> {
    fn default() -> Self {
        Self { accumulated: 0.0, backstress: [[0.0; 6]; N], plastic_work: 0.0 }
    }
}

impl<const N: usize> PlasticLaw for Cells<N> {
    fn elastic_limit(&self, layer: usize) -> f64 {
        // A backstress moves the elastic domain, so that any stress may yield; hardening alone
        // widens it.
        if N == 0 { self.models[layer].mapping().yield_stress() } else { 0.0 }
    }

    fn flow(
        &mut self,
        layer: usize,
        cell: usize,
        old: &[f64; 6],
        trial: &[f64; 6],
    ) -> Option<[f64; 6]> {
        let CellState { accumulated, backstress, plastic_work } = self.accepted[cell];
        let from = Flowing { stress: *old, accumulated, backstress, plastic_work };
        let step = std::array::from_fn(|k| trial[k] - old[k]);
        let end = self.models[layer].flow_along(from, step, self.parts)?;
        if end.accumulated <= accumulated {
            return None;
        }
        self.current[cell] = CellState {
            accumulated: end.accumulated,
            backstress: end.backstress,
            plastic_work: end.plastic_work,
        };
        Some(std::array::from_fn(|k| trial[k] - end.stress[k]))
    }

    fn rest(&mut self) {
        self.current.copy_from_slice(&self.accepted);
    }

    fn accept(&mut self) {
        self.accepted.copy_from_slice(&self.current);
    }

    fn equivalent_plastic_strain(&self, cell: usize) -> f64 {
        self.current[cell].accumulated
    }

    fn yield_stress(&self, layer: usize, cell: usize) -> f64 {
        let law = self.models[layer].mapping().law();
        law.stress(self.current[cell].accumulated).max(law.nominal_yield_stress())
    }

    fn has_yielded(&self, layer: usize, cell: usize) -> bool {
        let (mapping, strain) = (self.models[layer].mapping(), self.current[cell].accumulated);
        strain > 0.0 && mapping.has_yielded(mapping.law().stress(strain), strain)
    }

    fn plastic_work(&self, layer: usize, cell: usize) -> [f64; 2] {
        let CellState { plastic_work, backstress, .. } = &self.current[cell];
        [*plastic_work, self.models[layer].backstress_energy(backstress)]
    }
}
/// `xx yy xy` of each layer before any load, in axes turned by an angle.
pub(super) fn initial_stress(material: &Solid, angle: f64, layers: &Layers) -> Vec<[f64; 3]> {
    let at = initial_stress_over_depth(material, angle);
    (0..layers.len()).map(|layer| at(layers.middle(layer))).collect()
}

/// `xx yy xy` at a depth before any load, in axes turned by an angle.
pub(super) fn initial_stress_over_depth(material: &Solid, angle: f64) -> impl Fn(f64) -> [f64; 3] {
    let profile = material.initial_stress();
    let (sin, cos) = angle.sin_cos();
    move |depth| {
        let [x, y] = profile.at(depth);
        [cos * cos * x + sin * sin * y, sin * sin * x + cos * cos * y, sin * cos * (y - x)]
    }
}
