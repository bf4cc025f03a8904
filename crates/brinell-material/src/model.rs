//! The seam between the solver and the laws of its materials.

use std::fmt::Debug;

use super::HardeningLaw;
use super::moduli::{ElasticModuli, ModuliReduction, OutOfPlane, ReferenceModuli};

/// One value for each Gauss point of an element; the innermost index, so that loops over it
/// vectorize.
pub type PerPoint = [f64; 4];

/// What is known of a point before any load.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PointOrigin {
    /// `[x, y]` in the frame of the undeformed body \[mm\].
    pub position: [f64; 2],
    /// Stress `[σ_xx, σ_yy, σ_zz, τ_xy]` that the unloaded body is in equilibrium with \[MPa\].
    pub initial_stress: [f64; 4],
}

/// The answer of a material point to a strain.
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
    /// The part of it that the backstress stores \[MPa\].
    pub backstress_energy: f64,
}

/// Stress as a function of strain and of what the point has been through.
///
/// The state is that of the last accepted increment. Every iterate of an increment starts from it,
/// and it is replaced once, when the increment is accepted; so an iteration cannot drift, and one
/// that fails leaves nothing behind.
pub trait ConstitutiveModel: Debug + Send + Sync + 'static {
    /// What a point remembers; the default is a point that has seen nothing and is like every
    /// other.
    type State: Copy + Default + Debug + Send + Sync + 'static;

    /// Elastic moduli.
    fn elastic(&self) -> ElasticModuli;

    /// What is known of the out-of-plane direction.
    fn out_of_plane(&self) -> OutOfPlane;

    /// The isotropic hardening law; `None` for a material that cannot yield.
    fn hardening(&self) -> Option<&dyn HardeningLaw>;

    /// The state of a point before any load.
    fn at_rest(&self, origin: &PointOrigin) -> Self::State {
        let _ = origin;
        Self::State::default()
    }

    /// Factor of the stresses of [`Self::hardening`] at a place `[x, y]` of the undeformed body
    /// \[mm\].
    fn strength(&self, position: [f64; 2]) -> f64 {
        let _ = position;
        1.0
    }

    /// Whether [`Self::strength`] is not the same everywhere.
    fn varies_in_strength(&self) -> bool {
        false
    }

    /// Whether the answer depends on the way there, so that loads are a history.
    fn has_memory(&self) -> bool {
        false
    }

    /// Stress and new state at a strain `[ε_xx, ε_yy, ε_zz, γ_xy]`, from the state of the last
    /// accepted increment. In plane stress ε_zz is not looked at.
    fn update(&self, strain: [f64; 4], state: &Self::State) -> (PointResponse, Self::State);

    /// Moduli near `dσ/dε`, for the stiffness that an iteration refers to, as what they fall short
    /// of the elastic ones; `None` where they are elastic. They decide how fast an iteration ends,
    /// not where.
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
    /// but for a stress that the unloaded body has already, whose nodal forces are zero; returns
    /// the points that count as yielded, or `None` where all initial stresses are zero (the
    /// strains are then left in any state).
    ///
    /// For a given ε_zz initial stresses are deviatoric, so that the dilatation of the strains
    /// does not matter.
    #[inline(always)]
    fn initial_stress(
        &self,
        strain: &mut [PerPoint; 4],
        states: &[Self::State; 4],
    ) -> Option<usize> {
        self.initial_stress_point_by_point(strain, states)
    }

    /// The same by [`Self::update`], for models without a faster way.
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
