//! A body that yields: plastic strains of its cells, the stresses that go with them, and what the
//! plastic law answers.
//!
//! With the plastic strain `ε_p` of the accepted increments, the increment Δε of this load and the
//! stress σ0 that the unloaded body has, which depends on depth alone,
//! ```text
//! u_p = Sᵀ(ε_p + Δε)                              opening
//! s_tr = dev(S p + G(ε_p + Δε) + σ0) + 2μ Δε      trial
//! 2μ Δε_new: flow along s_old → s_tr               flow
//! ```
//! Δε enters and leaves as `2μ Δε` \[MPa\], in the order of a [`TensorField`] of deviators.

use std::sync::Arc;

use crate::half_space::{HalfSpace, HalfSpaceWork};
use crate::stop::{Stop, Stopped};
use crate::tensors::{DEVIATOR_COMPONENTS, TensorField};

/// The plastic law of the cells of a body, with what they remember. Cells count through the
/// layers: `layer * n_cells + cell`.
pub trait PlasticLaw {
    /// Von Mises stress below which no cell of a layer flows, whatever it has been through
    /// \[MPa\].
    fn elastic_limit(&self, layer: usize) -> f64;

    /// Returns `2μ Δε` of a straight path of the stress deviator `xx yy zz xy xz yz` from the
    /// accepted state of a cell; `None` where it stays elastic. The new state of the cell is kept
    /// until the next [`rest`](Self::rest).
    fn flow(
        &mut self,
        layer: usize,
        cell: usize,
        old: &[f64; 6],
        trial: &[f64; 6],
    ) -> Option<[f64; 6]>;

    /// Takes all cells back to their accepted states.
    fn rest(&mut self);

    /// Accepts what the cells remember.
    fn accept(&mut self);

    /// Equivalent plastic strain of a cell after the last paths.
    fn equivalent_plastic_strain(&self, cell: usize) -> f64;

    /// Yield stress of a cell at that strain \[MPa\].
    fn yield_stress(&self, layer: usize, cell: usize) -> f64;

    /// Whether a cell counts as yielded at that strain.
    fn has_yielded(&self, layer: usize, cell: usize) -> bool;

    /// `∫σ:dε_p` of a cell \[MPa\], and the part of it that the backstress stores.
    fn plastic_work(&self, layer: usize, cell: usize) -> [f64; 2];
}

/// Plastic strains, stresses and work space of one body.
pub struct YieldingBody {
    space: Arc<HalfSpace>,
    law: Box<dyn PlasticLaw>,
    /// Number of bodies for which this one stands.
    count: f64,
    /// dev σ0 of each layer.
    initial: Vec<[f64; DEVIATOR_COMPONENTS]>,
    strain: TensorField,
    old_stress: TensorField,
    total: TensorField,
    stress: TensorField,
    work: HalfSpaceWork,
    /// Displacement of the surface of one body by plastic strain.
    displacement: Vec<f64>,
}

impl YieldingBody {
    /// A body at rest; two equal bodies are one that stands for `count = 2`.
    ///
    /// `initial` is the deviator `xx yy xy xz yz` of the stress of each layer before any load, and
    /// `at_rest` whether paths begin there or without stress.
    pub fn new(
        space: Arc<HalfSpace>,
        law: Box<dyn PlasticLaw>,
        count: u8,
        initial: Vec<[f64; DEVIATOR_COMPONENTS]>,
        at_rest: bool,
    ) -> Self {
        let (n_layers, n_cells) = (space.layers().len(), space.grid().n_cells());
        let deviators = || TensorField::deviators(n_layers, n_cells);
        let work = space.work();
        let mut old_stress = deviators();
        for (layer, initial) in initial.iter().enumerate().filter(|_| at_rest) {
            for (k, value) in initial.iter().enumerate() {
                old_stress.component_mut(layer, k).fill(*value);
            }
        }
        Self {
            space,
            law,
            count: f64::from(count),
            initial,
            strain: deviators(),
            old_stress,
            total: deviators(),
            stress: deviators(),
            work,
            displacement: vec![0.0; n_cells],
        }
    }

    /// Operators of the body.
    pub fn space(&self) -> &HalfSpace {
        &self.space
    }

    /// The plastic law, with what the cells remember.
    pub fn law(&self) -> &dyn PlasticLaw {
        &*self.law
    }

    /// Numbers of an increment.
    pub fn len(&self) -> usize {
        self.strain.values().len()
    }

    /// Always false: there is at least one layer.
    pub const fn is_empty(&self) -> bool {
        false
    }

    fn double_shear(&self) -> f64 {
        2.0 * self.space.elastic().shear()
    }

    /// Adds u_p of all the bodies that this one stands for to `opening` \[mm\], positive where it
    /// opens the gap.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn open(
        &mut self,
        increment: &[f64],
        opening: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        let compliance = 1.0 / self.double_shear();
        let total = self.total.values_mut().iter_mut();
        for ((e, accepted), stress) in total.zip(self.strain.values()).zip(increment) {
            *e = accepted + compliance * stress;
        }
        self.space.opening(&self.total, &mut self.work, &mut self.displacement, stop)?;
        for (u, part) in opening.iter_mut().zip(&self.displacement) {
            *u += self.count * part;
        }
        Ok(())
    }

    /// The trial deviators under pressures \[MPa\], with the increment of the last
    /// [`open`](Self::open), which it uses up.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn trial(
        &mut self,
        pressure: &[f64],
        increment: &[f64],
        into: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        self.space.stress(pressure, &mut self.work, &mut self.stress, stop)?;
        for ((trial, stress), added) in into.iter_mut().zip(self.stress.values()).zip(increment) {
            *trial = stress + added;
        }
        let n_cells = self.stress.n_cells();
        let rows = into.chunks_exact_mut(n_cells);
        for (row, initial) in
            rows.zip(self.initial.iter().flatten()).filter(|(_, value)| **value != 0.0)
        {
            for value in row {
                *value += initial;
            }
        }
        Ok(())
    }

    /// Answers a trial with `2μ Δε` of the plastic law. Calls `flowing` for each cell that flows.
    pub fn flow(&mut self, trial: &[f64], into: &mut [f64], mut flowing: impl FnMut(usize)) {
        let (n_layers, n_cells) = (self.strain.n_layers(), self.strain.n_cells());
        let layer_len = DEVIATOR_COMPONENTS * n_cells;
        into.fill(0.0);
        self.law.rest();
        for layer in 0..n_layers {
            let (trial, new) =
                (&trial[layer * layer_len..], &mut into[layer * layer_len..][..layer_len]);
            let old = self.old_stress.layer(layer);
            let limit = self.law.elastic_limit(layer).powi(2);
            for cell in 0..n_cells {
                let trial = whole(std::array::from_fn(|k| trial[k * n_cells + cell]));
                if square(&trial) <= limit {
                    continue;
                }
                let from = whole(std::array::from_fn(|k| old[k * n_cells + cell]));
                let index = layer * n_cells + cell;
                let Some(answer) = self.law.flow(layer, index, &from, &trial) else { continue };
                flowing(index);
                for (k, row) in [0, 1, 3, 4, 5].into_iter().enumerate() {
                    new[k * n_cells + cell] = answer[row];
                }
            }
        }
    }

    /// Accepts an increment whose trial is given: its end is where the next one begins.
    pub fn accept(&mut self, increment: &[f64], trial: &[f64]) {
        let compliance = 1.0 / self.double_shear();
        for (strain, stress) in self.strain.values_mut().iter_mut().zip(increment) {
            *strain += compliance * stress;
        }
        for ((old, trial), stress) in
            self.old_stress.values_mut().iter_mut().zip(trial).zip(increment)
        {
            *old = trial - stress;
        }
        self.law.accept();
    }

    /// Plastic strain and displacement of the surface of the last [`open`](Self::open).
    pub const fn opened(&self) -> (&TensorField, &[f64]) {
        (&self.total, self.displacement.as_slice())
    }

    /// `-½ ∫ ε_p : G ε_p dV` \[N mm\]: the elastic energy of the plastic strain of the last
    /// [`open`](Self::open) alone, of one body, from the trial deviators under pressures \[MPa\]
    /// with that increment.
    ///
    /// By reciprocity the stress of the pressures works `Σ p u_p hx hy` on the plastic strain,
    /// which is a deviator.
    pub fn residual_energy(&self, pressure: &[f64], trial: &[f64], increment: &[f64]) -> f64 {
        let (area, layers) = (self.space.grid().cell_area(), self.space.layers());
        let n_cells = self.strain.n_cells();
        let strains = self.total.values().chunks_exact(n_cells);
        let stresses = trial.chunks_exact(n_cells).zip(increment.chunks_exact(n_cells));
        let rows = strains.zip(stresses).zip(self.initial.iter().flatten());
        // a:b = Σ weight a b + tr over xx and yy, for zz = -xx - yy.
        let mut of_all = 0.0;
        for (n, ((strain, (trial, increment)), initial)) in rows.enumerate() {
            let (layer, k) = (n / DEVIATOR_COMPONENTS, n % DEVIATOR_COMPONENTS);
            let other = if k < 2 { Some(self.total.component(layer, 1 - k)) } else { None };
            let work = |cell: usize| {
                let coupled = other.map_or(strain[cell], |other| strain[cell] + 0.5 * other[cell]);
                2.0 * coupled * (trial[cell] - increment[cell] - initial)
            };
            of_all += layers.thickness(layer) * (0..n_cells).map(work).sum::<f64>();
        }
        let of_pressure: f64 = pressure.iter().zip(&self.displacement).map(|(p, u)| p * u).sum();
        0.5 * area * (of_pressure - of_all)
    }

    /// Returns the number of bodies for which this one stands.
    pub const fn count(&self) -> f64 {
        self.count
    }

    /// All six stresses \[MPa\] under pressures with this increment, without σ0.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn stresses(
        &mut self,
        pressure: &[f64],
        increment: &[f64],
        stop: &mut Stop<'_>,
    ) -> Result<TensorField, Stopped> {
        let mut nothing = vec![0.0; self.displacement.len()];
        self.open(increment, &mut nothing, stop)?;
        let mut stress = TensorField::tensors(self.strain.n_layers(), self.strain.n_cells());
        self.space.stress(pressure, &mut self.work, &mut stress, stop)?;
        Ok(stress)
    }
}

/// A deviator of six components.
#[inline(always)]
fn whole([xx, yy, xy, xz, yz]: [f64; DEVIATOR_COMPONENTS]) -> [f64; 6] {
    [xx, yy, -xx - yy, xy, xz, yz]
}

/// `3/2 s:s`.
#[inline(always)]
fn square(s: &[f64; 6]) -> f64 {
    1.5 * (s[0] * s[0]
        + s[1] * s[1]
        + s[2] * s[2]
        + 2.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]))
}
