//! The interface between the solver and the laws of its materials.

use std::fmt::Debug;

use super::HardeningLaw;
use super::moduli::{ElasticModuli, ModuliReduction, OutOfPlane, ReferenceModuli};

/// One value for each Gauss point of an element; the innermost index, so that loops over it
/// vectorize.
pub type PerPoint = [f64; 4];

/// A material point of the unloaded body.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PointOrigin {
    /// `[x, y]` in the frame of the undeformed body \[mm\].
    pub position: [f64; 2],
    /// Residual stress `[σ_xx, σ_yy, σ_zz, τ_xy]` of the unloaded body, in equilibrium \[MPa\].
    pub initial_stress: [f64; 4],
}

/// The response of a material point to a strain.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PointResponse {
    /// `[σ_xx, σ_yy, σ_zz, τ_xy]` \[MPa\], tensile positive.
    pub stress: [f64; 4],
    /// Secant shear modulus G_s \[MPa\]; the elastic one for a law with a memory.
    pub secant_shear: f64,
    /// Equivalent plastic strain, accumulated over the history.
    pub equivalent_plastic_strain: f64,
    /// Whether the point counts as yielded.
    pub yielded: bool,
    /// `∫σ:dε_p` over the history \[MPa\]; zero for a law without a memory.
    pub plastic_work: f64,
    /// The part of this work that the backstress stores \[MPa\].
    pub backstress_energy: f64,
}

/// Stress as a function of strain and of the history of the point.
///
/// The state belongs to the last accepted increment. Every iterate of an increment starts from
/// this state, which changes only when the increment is accepted. So an iteration cannot drift,
/// and a failed iteration leaves the state unchanged.
pub trait ConstitutiveModel: Debug + Send + Sync + 'static {
    /// The memory of a point; the default is a point without a history in a homogeneous body.
    type State: Copy + Default + Debug + Send + Sync + 'static;

    /// Returns the elastic moduli.
    fn elastic(&self) -> ElasticModuli;

    /// Returns the condition of the out-of-plane direction.
    fn out_of_plane(&self) -> OutOfPlane;

    /// Returns the isotropic hardening law; `None` for a material that cannot yield.
    fn hardening(&self) -> Option<&dyn HardeningLaw>;

    /// Returns the state of a point before any load.
    fn at_rest(&self, origin: &PointOrigin) -> Self::State {
        let _ = origin;
        Self::State::default()
    }

    /// Returns the factor of the stresses of [`Self::hardening`] at a place `[x, y]` of the
    /// undeformed body \[mm\].
    fn strength(&self, position: [f64; 2]) -> f64 {
        let _ = position;
        1.0
    }

    /// Whether [`Self::strength`] varies over the body.
    fn varies_in_strength(&self) -> bool {
        false
    }

    /// Whether the stress depends on the strain path, so that loads are a history.
    fn has_memory(&self) -> bool {
        false
    }

    /// Returns stress and new state at a strain `[ε_xx, ε_yy, ε_zz, γ_xy]`, from the state of the
    /// last accepted increment. Ignores ε_zz in plane stress.
    fn update(&self, strain: [f64; 4], state: &Self::State) -> (PointResponse, Self::State);

    /// Returns reference moduli near `dσ/dε` as their reduction from the elastic ones; `None`
    /// where they are elastic. They change the rate of convergence, not the solution.
    fn tangent(
        &self,
        strain: [f64; 4],
        state: &Self::State,
        reference: ReferenceModuli,
    ) -> Option<ModuliReduction> {
        let _ = (strain, state, reference);
        None
    }

    /// Turns the strains of the points of an element into initial stresses `D_e ε - σ` \[MPa\],
    /// without the residual stress of the unloaded body, whose nodal forces are zero. Returns the
    /// number of yielded points, or `None` where all initial stresses are zero; the strains are
    /// then undefined.
    ///
    /// For a given ε_zz initial stresses are deviatoric and do not depend on the dilatation.
    #[inline(always)]
    fn initial_stress(
        &self,
        strain: &mut [PerPoint; 4],
        states: &[Self::State; 4],
    ) -> Option<usize> {
        self.initial_stress_point_by_point(strain, states)
    }

    /// The default calls [`Self::update`]; models override it with a faster method.
    #[inline(always)]
    fn initial_stress_point_by_point(
        &self,
        strain: &mut [PerPoint; 4],
        states: &[Self::State; 4],
    ) -> Option<usize> {
        let mut yielded = 0;
        let mut is_loaded = false;
        for (g, state) in states.iter().enumerate() {
            let at_point = strain.map(|component| component[g]);
            let (response, _) = self.update(at_point, state);
            let elastic = self.elastic().stress(at_point, self.out_of_plane());
            yielded += usize::from(response.yielded);
            let is_plastic = response.equivalent_plastic_strain > 0.0;
            is_loaded |= is_plastic;
            for (component, (elastic, stress)) in
                strain.iter_mut().zip(elastic.into_iter().zip(response.stress))
            {
                component[g] = if is_plastic { elastic - stress } else { 0.0 };
            }
        }
        is_loaded.then_some(yielded)
    }
}
