//! The plastic law of the rows of a track.

use std::sync::Arc;

use brinell_material::{
    BackstressTerm, Deviators, FlowPlasticity, HardeningLaw, OutOfPlane, ReturnMapping, Solid,
    StreamLaw, StreamOfLayers, TrackFrame, scaled,
};

/// The plastic law of so many rows in each of the layers at these depths, if the material can
/// yield. Each layer has the strength at its depth.
pub(super) fn law_of_rows<const D: usize, const R: usize>(
    material: &Solid,
    depths: &[f64],
    rows: usize,
) -> Option<Box<dyn StreamLaw<D, R>>>
where
    TrackFrame: Deviators<D, R>,
{
    let curve = Arc::clone(material.hardening_law()?);
    let of = Making { material, curve, depths, rows };
    // The number of terms is a type parameter, as in the cells of three dimensions.
    Some(match *material.backstress() {
        [] => of.rows([]),
        [a] => of.rows([a]),
        [a, b] => of.rows([a, b]),
        [a, b, c] => of.rows([a, b, c]),
        [a, b, c, d, ..] => of.rows([a, b, c, d]),
    })
}

struct Making<'a> {
    material: &'a Solid,
    curve: Arc<dyn HardeningLaw>,
    depths: &'a [f64],
    rows: usize,
}

impl Making<'_> {
    fn rows<const N: usize, const D: usize, const R: usize>(
        self,
        backstress: [BackstressTerm; N],
    ) -> Box<dyn StreamLaw<D, R>>
    where
        TrackFrame: Deviators<D, R>,
    {
        let elastic = self.material.moduli();
        let strength = self.material.strength();
        let of_layer = |depth: &f64| {
            let factor = strength.map_or(1.0, |strength| strength.factor(*depth));
            let mapping = ReturnMapping::new(scaled(&self.curve, factor), elastic.shear);
            let model = FlowPlasticity::new(elastic, mapping, backstress, OutOfPlane::Strained);
            std::iter::repeat_n(Arc::new(model), self.rows)
        };
        Box::new(StreamOfLayers::<N, D>::new(self.depths.iter().flat_map(of_layer).collect()))
    }
}
