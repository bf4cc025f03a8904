//! Inhomogeneous bodies: strength that varies over depth, and residual stress of the unloaded
//! body.
//!
//! ```text
//! q = s(z) q_0(ε_p)     s: factor; z: depth below the undeformed surface along its normal
//! σ = M(ε + D⁻¹ σ_r)    M: a homogeneous model; σ_r: residual stress of the unloaded body
//! ```
//!
//! The elastic constants are uniform, so that stiffness and flexibility depend on neither. σ_r is
//! in equilibrium without load, so that its nodal forces vanish and only the plastic part of M's
//! initial stresses loads the body.
//!
//! Factors are rounded to layers in geometric sequence from the smallest to the largest;
//! neighbours differ by no more than [`LAYER_RATIO`]. Each layer has its own model, whose curve is
//! prepared once ([`ReturnMapping`](super::ReturnMapping)). This works for any model.

use std::sync::Arc;

use super::{
    ConstitutiveModel, ElasticModuli, HardeningLaw, Inverse, ModuliReduction, OutOfPlane,
    PerPoint, PointOrigin, PointResponse, ReferenceModuli,
};
use crate::DepthStrength;

/// Largest relative difference of the strengths of neighbouring layers; the rounding error is half
/// of it.
const LAYER_RATIO: f64 = 1e-3;

/// A model for each layer of strength.
#[derive(Debug)]
pub struct Inhomogeneous<M> {
    /// The hardening law where the factor is 1.
    law: Option<Arc<dyn HardeningLaw>>,
    strength: Option<DepthStrength>,
    /// One model for each layer, at least one; factors rise in geometric sequence.
    layers: Vec<M>,
}

/// The memory of a point, its layer, and the elastic strain of its residual stress.
#[derive(Debug, Clone, Copy, Default)]
pub struct InhomogeneousState<S> {
    layer: u16,
    initial_strain: [f64; 4],
    inner: S,
}

impl<M: ConstitutiveModel> Inhomogeneous<M> {
    /// Makes one layer for each factor; `model` makes a model of a scaled hardening law.
    pub fn new(
        law: Option<Arc<dyn HardeningLaw>>,
        strength: Option<DepthStrength>,
        model: impl Fn(Option<Arc<dyn HardeningLaw>>) -> M,
    ) -> Self {
        let (least, greatest) = strength.as_ref().map_or((1.0, 1.0), DepthStrength::range);
        let last = ((greatest / least).ln() / LAYER_RATIO.ln_1p()).ceil().min(f64::from(u16::MAX));
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and 2^16"
        )]
        let last = last as u16;
        let factor = |k: u16| match k {
            0 => least,
            k => least * (greatest / least).powf(f64::from(k) / f64::from(last)),
        };
        let scaled = |factor: f64| law.as_ref().map(|law| scaled(law, factor));
        let layers = (0..=last).map(|k| model(scaled(factor(k)))).collect();
        Self { law, strength, layers }
    }

    fn layer(&self, state: &InhomogeneousState<M::State>) -> &M {
        &self.layers[usize::from(state.layer)]
    }

    fn layer_at(&self, position: [f64; 2]) -> u16 {
        let Some(strength) = self.strength.as_ref().filter(|_| self.layers.len() > 1) else {
            return 0;
        };
        let (least, greatest) = strength.range();
        let part = (strength.factor(position) / least).ln() / (greatest / least).ln();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and 2^16"
        )]
        let layer = (part * (self.layers.len() - 1) as f64).round() as u16;
        layer
    }
}

impl<M: ConstitutiveModel> ConstitutiveModel for Inhomogeneous<M> {
    type State = InhomogeneousState<M::State>;

    fn elastic(&self) -> ElasticModuli {
        self.layers[0].elastic()
    }

    #[inline(always)]
    fn out_of_plane(&self) -> OutOfPlane {
        self.layers[0].out_of_plane()
    }

    fn hardening(&self) -> Option<&dyn HardeningLaw> {
        self.law.as_deref()
    }

    fn at_rest(&self, origin: &PointOrigin) -> Self::State {
        let layer = self.layer_at(origin.position);
        let model = &self.layers[usize::from(layer)];
        let initial_strain = self.elastic().strain(origin.initial_stress);
        let inner = model.at_rest(origin);
        let has_stress = origin.initial_stress.iter().any(|stress| stress.abs() > 0.0);
        let inner = if has_stress { model.update(initial_strain, &inner).1 } else { inner };
        InhomogeneousState { layer, initial_strain, inner }
    }

    fn strength(&self, position: [f64; 2]) -> f64 {
        self.strength.as_ref().map_or(1.0, |strength| strength.factor(position))
    }

    fn varies_in_strength(&self) -> bool {
        self.layers.len() > 1
    }

    fn has_memory(&self) -> bool {
        self.layers[0].has_memory()
    }

    #[inline]
    fn update(&self, strain: [f64; 4], state: &Self::State) -> (PointResponse, Self::State) {
        let strain = std::array::from_fn(|k| strain[k] + state.initial_strain[k]);
        let (response, inner) = self.layer(state).update(strain, &state.inner);
        (response, InhomogeneousState { inner, ..*state })
    }

    fn tangent(
        &self,
        strain: [f64; 4],
        state: &Self::State,
        reference: ReferenceModuli,
    ) -> Option<ModuliReduction> {
        let strain = std::array::from_fn(|k| strain[k] + state.initial_strain[k]);
        self.layer(state).tangent(strain, &state.inner, reference)
    }

    #[inline(always)]
    fn initial_stress(
        &self,
        strain: &mut [PerPoint; 4],
        states: &[Self::State; 4],
    ) -> Option<usize> {
        for (k, component) in strain.iter_mut().enumerate() {
            for (value, state) in component.iter_mut().zip(states) {
                *value += state.initial_strain[k];
            }
        }
        let inner = states.each_ref().map(|state| state.inner);
        let layers = states.each_ref().map(|state| state.layer);
        if layers.iter().all(|layer| *layer == layers[0]) {
            return self.layer(&states[0]).initial_stress(strain, &inner);
        }
        // If the weakest layer does not yield, no layer does.
        let all = *strain;
        let weakest = layers.iter().fold(layers[0], |a, b| a.min(*b));
        self.layers[usize::from(weakest)].initial_stress(&mut strain.clone(), &inner)?;
        let mut yielded = 0;
        for (g, layer) in layers.iter().enumerate() {
            let at_point = all.map(|component| component[g]);
            let (response, _) = self.layers[usize::from(*layer)].update(at_point, &inner[g]);
            let elastic = self.elastic().stress(at_point, self.out_of_plane());
            yielded += usize::from(response.yielded);
            let is_plastic = response.equivalent_plastic_strain > 0.0;
            for (component, (elastic, stress)) in
                strain.iter_mut().zip(elastic.into_iter().zip(response.stress))
            {
                component[g] = if is_plastic { elastic - stress } else { 0.0 };
            }
        }
        Some(yielded)
    }
}

/// Returns a hardening law with its stresses multiplied by a factor.
pub fn scaled(law: &Arc<dyn HardeningLaw>, factor: f64) -> Arc<dyn HardeningLaw> {
    let law = Arc::clone(law);
    if factor.to_bits() == 1f64.to_bits() { law } else { Arc::new(Scaled { law, factor }) }
}

/// A hardening law whose stresses are multiplied by a factor.
#[derive(Debug)]
struct Scaled {
    law: Arc<dyn HardeningLaw>,
    factor: f64,
}

impl HardeningLaw for Scaled {
    fn yield_stress(&self) -> f64 {
        self.factor * self.law.yield_stress()
    }

    fn largest_stress(&self) -> f64 {
        self.factor * self.law.largest_stress()
    }

    fn stress(&self, plastic_strain: f64) -> f64 {
        self.factor * self.law.stress(plastic_strain)
    }

    fn slope(&self, plastic_strain: f64) -> f64 {
        self.factor * self.law.slope(plastic_strain)
    }

    fn stress_and_slope(&self, plastic_strain: f64) -> (f64, f64) {
        let (stress, slope) = self.law.stress_and_slope(plastic_strain);
        (self.factor * stress, self.factor * slope)
    }

    fn inverse(&self, stress: f64) -> Option<Inverse> {
        let Inverse { plastic_strain, slope } = self.law.inverse(stress / self.factor)?;
        Some(Inverse { plastic_strain, slope: slope / self.factor })
    }

    fn polyline(&self) -> Option<Vec<[f64; 2]>> {
        let corners = self.law.polyline()?;
        Some(corners.into_iter().map(|[strain, stress]| [strain, self.factor * stress]).collect())
    }

    fn nominal_yield_stress(&self) -> f64 {
        self.factor * self.law.nominal_yield_stress()
    }

    fn flow_stress(&self) -> f64 {
        self.factor * self.law.flow_stress()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hardening::tests::{STEEL, laws};
    use crate::{DeformationPlasticity, Depth, FlowPlasticity, ReturnMapping, StrengthProfile};

    /// Material below y = 0.
    #[derive(Debug)]
    struct Flat;

    impl Depth for Flat {
        fn depth_below(&self, [_, y]: [f64; 2]) -> f64 {
            -y
        }
    }

    fn strength(points: &[[f64; 2]]) -> DepthStrength {
        DepthStrength::new(StrengthProfile::new(points.to_vec()), Flat)
    }

    const STRAIN: [f64; 4] = [6e-3, -4e-3, 1e-3, 5e-3];

    #[test]
    fn each_depth_has_its_own_curve_under_every_law_and_theory() {
        for law in laws() {
            let (elastic, law) = (STEEL, Some(law));
            for oop in [OutOfPlane::Strained, OutOfPlane::PlaneStress] {
                let deformation = |law| DeformationPlasticity::with_law(elastic, law, oop);
                let flow = |law: Option<Arc<dyn HardeningLaw>>| {
                    FlowPlasticity::new(
                        elastic,
                        ReturnMapping::new(law.unwrap(), elastic.shear),
                        [],
                        oop,
                    )
                };
                let profile = || Some(strength(&[[0.0, 1.7], [1.0, 0.6]]));
                let by_strain = Inhomogeneous::new(law.clone(), profile(), deformation);
                let by_history = Inhomogeneous::new(law.clone(), profile(), flow);
                for (depth, factor) in [(0.0, 1.7), (0.5, 1.15), (3.0, 0.6)] {
                    let origin = PointOrigin { position: [0.3, -depth], ..PointOrigin::default() };
                    let scaled = Scaled { law: law.clone().unwrap(), factor };
                    let (expected, ()) = deformation(Some(Arc::new(scaled))).update(STRAIN, &());
                    let found = [
                        by_strain.update(STRAIN, &by_strain.at_rest(&origin)).0,
                        by_history.update(STRAIN, &by_history.at_rest(&origin)).0,
                    ];
                    for found in found {
                        for (a, b) in found.stress.iter().zip(expected.stress) {
                            // Half of a layer.
                            assert!(
                                (a - b).abs() < 5e-4 * 1.7 * 900.0,
                                "{law:?} {depth}: {a} {b}"
                            );
                        }
                    }
                }
            }
        }
    }

    /// Points of different layers in one element load it as they do one by one.
    #[test]
    fn an_element_across_layers_is_loaded_point_by_point() {
        let (elastic, law) = (STEEL, Some(Arc::clone(&laws()[0])));
        let model = Inhomogeneous::new(law, Some(strength(&[[0.0, 2.0], [1.0, 1.0]])), |law| {
            DeformationPlasticity::with_law(elastic, law, OutOfPlane::Strained)
        });
        let initial_stress = [-150.0, 30.0, -80.0, 20.0];
        let states = [0.1, 0.4, 0.45, 0.9]
            .map(|depth| model.at_rest(&PointOrigin { position: [0.0, -depth], initial_stress }));
        for scale in [0.01, 0.35, 1.0] {
            let strains: [[f64; 4]; 4] = std::array::from_fn(|k| {
                std::array::from_fn(|g| scale * STRAIN[k] * (1.0 + 0.1 * g as f64))
            });
            let mut loads = strains;
            let yielded = model.initial_stress(&mut loads, &states);
            let mut expected = 0;
            for (g, state) in states.iter().enumerate() {
                let strain = strains.map(|component| component[g]);
                let (response, _) = model.update(strain, state);
                expected += usize::from(response.yielded);
                let stress = elastic.stress(strain, OutOfPlane::Strained);
                for k in 0..4 {
                    let load = if yielded.is_some() { loads[k][g] } else { 0.0 };
                    let rest = stress[k] + initial_stress[k] - response.stress[k];
                    assert!((load - rest).abs() < 1e-9 * 1000.0, "{scale} {g} {k}: {load} {rest}");
                }
            }
            assert_eq!(yielded.unwrap_or(0), expected);
            assert_eq!(yielded.is_some(), scale > 0.1);
        }
    }

    #[test]
    fn stress_before_any_load_is_there_without_strain() {
        let (elastic, law) = (STEEL, Some(Arc::clone(&laws()[0])));
        for oop in [OutOfPlane::Strained, OutOfPlane::PlaneStress] {
            let initial_stress =
                [-150.0, 30.0, if oop == OutOfPlane::Strained { -80.0 } else { 0.0 }, 20.0];
            let model = Inhomogeneous::new(law.clone(), None, |law| {
                DeformationPlasticity::with_law(elastic, law, oop)
            });
            let state = model.at_rest(&PointOrigin { position: [0.0; 2], initial_stress });
            let (response, _) = model.update([0.0; 4], &state);
            for (a, b) in response.stress.iter().zip(initial_stress) {
                assert!((a - b).abs() < 1e-10, "{oop:?} {a} {b}");
            }
        }
    }
}
