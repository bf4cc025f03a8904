//! The interface of two bodies in contact to the alternation of contact and plasticity.

use super::phases::Phase;
use super::run::Run;
use crate::Error;
use crate::figures::Figures;
use brinell_contact::{ContactLoad, ContactProblem, ContactSolution, ContactSolver};
use brinell_material::ReferenceModuli;

/// One vector for each model of a body.
pub type BlockVector = Vec<Vec<f64>>;

/// Displacements and contact for a given initial stress.
#[derive(Debug, Clone)]
pub struct Response {
    /// Displacements at the equations that enter plastic law and contact \[mm\].
    pub displacement: BlockVector,
    /// The contact: forces of pairs, gaps, approach.
    pub contact: ContactSolution,
}

/// Figures of the whole contact, both sides of an axis of symmetry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactFigures {
    /// Contact force \[N/mm, or N in axisymmetry\].
    pub force: f64,
    /// Approach α \[mm\].
    pub approach: f64,
    /// Largest contact pressure \[MPa\].
    pub peak_pressure: f64,
    /// Pairs in contact.
    pub pairs: usize,
}

impl ContactFigures {
    /// Returns the figures that are known before the fields are, with the half-width \[mm\].
    pub const fn headline(self, half_width: f64) -> Figures {
        Figures {
            peak_pressure: self.peak_pressure,
            middle_pressure: None,
            half_width,
            semi_axis_y: None,
            contact_area: None,
            contact_ratio: None,
            approach: self.approach,
            force: self.force,
            bodies: [None; 2],
        }
    }
}

/// Two bodies and the contact between them.
///
/// `initial_stress` is the paper's P_e: the load that plastic flow puts on the elastic bodies,
/// nodal forces of finite elements. It is a force, not the `initial_stress` of a job. Couplings
/// call the applied vector `loads` and P_e(u) its `image`. Contact forces push the bodies apart,
/// `R >= 0`.
///
/// Loads and figures belong to the whole contact; a system that models half of it, or one of two
/// equal bodies, converts them.
pub trait ContactSystem {
    /// Returns an initial stress, or displacements, of zero.
    fn zeros(&self) -> BlockVector;

    /// Initial gap δ0 of each candidate pair along its normal \[mm\].
    fn initial_gap(&self) -> &[f64];

    /// Returns the contact conditions of the candidate pairs at given gaps \[mm\] under a load of
    /// the whole contact.
    fn contact_problem<'a>(&'a self, gap: &'a [f64], load: ContactLoad) -> ContactProblem<'a>;

    /// Returns `u_p`, the widening of the gap at each pair by the initial stress alone \[mm\].
    fn gap_opening(&self, initial_stress: &BlockVector) -> Vec<f64>;

    /// Solves the contact alone, at gaps widened by `gap_opening`.
    ///
    /// # Errors
    /// Those of the contact solver.
    fn contact(
        &self,
        gap_opening: &[f64],
        solver: &dyn ContactSolver,
        load: ContactLoad,
        start: Option<&ContactSolution>,
        run: &mut Run<'_>,
    ) -> Result<ContactSolution, Error> {
        let gap: Vec<f64> = self
            .initial_gap()
            .iter()
            .zip(gap_opening)
            .map(|(gap, opening)| gap + opening)
            .collect();
        Ok(run.solve_contact(solver, &self.contact_problem(&gap, load), start)?)
    }

    /// Returns the displacements under an initial stress and contact forces.
    fn displacement(&self, initial_stress: &BlockVector, force: &[f64]) -> BlockVector;

    /// Solves contact and displacements for a given initial stress: [`Self::gap_opening`],
    /// [`Self::contact`] and [`Self::displacement`] in one call.
    ///
    /// # Errors
    /// Those of the contact solver.
    fn equilibrium(
        &self,
        initial_stress: &BlockVector,
        solver: &dyn ContactSolver,
        load: ContactLoad,
        start: Option<&ContactSolution>,
        run: &mut Run<'_>,
    ) -> Result<Response, Error> {
        let gap_opening = run.time(Phase::Solves, || self.gap_opening(initial_stress));
        let contact = self.contact(&gap_opening, solver, load, start, run)?;
        let displacement =
            run.time(Phase::Solves, || self.displacement(initial_stress, &contact.force));
        Ok(Response { displacement, contact })
    }

    /// Writes P_e(u), the initial stress of the plastic law at given displacements, into `into`.
    /// Returns the number of points beyond yield.
    fn initial_stress(&self, displacement: &BlockVector, into: &mut BlockVector) -> usize;

    /// Returns a norm of displacements or of an initial stress.
    fn norm(&self, v: &BlockVector) -> f64;

    /// Returns the same norm of `v - w`.
    fn distance(&self, v: &BlockVector, w: &BlockVector) -> f64;

    /// Returns the entries that change between iterations in one vector. The vector may grow from
    /// iteration to iteration; new entries were zero before.
    fn pack(&self, vectors: &BlockVector) -> Vec<f64>;

    /// Writes these entries back to where [`Self::pack`] took them from.
    fn unpack(&self, packed: &[f64], vectors: &mut BlockVector);

    /// Figures of the whole contact.
    fn figures(&self, contact: &ContactSolution) -> ContactFigures;

    /// Displacements of the last accepted state, zero at rest.
    fn accepted(&self) -> &BlockVector;

    /// Accepts the state with these displacements as the start of the next increment of a history.
    fn commit(&mut self, displacement: BlockVector);

    /// Returns the same bodies if their stiffness can be assembled with other than elastic moduli.
    fn linearizable(&mut self) -> Option<&mut dyn Linearize> {
        None
    }

    /// Returns a stiffness with secant moduli, initially elastic, if the bodies have an assembled
    /// stiffness.
    fn secant_stiffness(&self) -> Option<Box<dyn SecantStiffness + '_>> {
        None
    }
}

/// Bodies whose stiffness can be assembled with the moduli of plastic flow.
pub trait Linearize: ContactSystem {
    /// Factorizes the stiffness with the moduli of plastic flow at given displacements; without
    /// displacements, with the elastic moduli.
    ///
    /// # Errors
    /// Those of a factorization.
    fn linearize(
        &mut self,
        at: Option<(&BlockVector, ReferenceModuli)>,
        run: &mut Run<'_>,
    ) -> Result<(), Error>;

    /// Returns the number of factorizations that one linearization takes.
    fn factorizations(&self) -> usize;

    /// Returns the nodal forces of an initial stress and of the contact together.
    fn applied(&self, initial_stress: &BlockVector, force: &[f64]) -> BlockVector;

    /// Returns the work of forces on displacements, over both whole bodies.
    fn work(&self, forces: &BlockVector, displacement: &BlockVector) -> f64;
}

/// A stiffness with the secant moduli of the last state.
pub trait SecantStiffness {
    /// Solves contact and displacements without an initial stress; the displacements cover all
    /// equations.
    ///
    /// # Errors
    /// Those of the contact solver, and where the observer stops it.
    fn equilibrium(
        &self,
        solver: &dyn ContactSolver,
        load: ContactLoad,
        start: Option<&ContactSolution>,
        run: &mut Run<'_>,
    ) -> Result<Response, Error>;

    /// Evaluates the plastic law in a state and keeps its secant moduli.
    ///
    /// # Errors
    /// [`Error::Interrupted`] if the observer stops it.
    fn evaluate(&mut self, response: &Response, run: &mut Run<'_>)
    -> Result<PlasticAnswer, Error>;

    /// Factorizes with the secant moduli of the last state. Returns the number of factorizations.
    ///
    /// # Errors
    /// Those of a factorization, and where the observer stops it.
    fn renew(&mut self, run: &mut Run<'_>) -> Result<usize, Error>;
}

/// The result of the plastic law in a state.
#[derive(Debug, Clone, Copy, Default)]
pub struct PlasticAnswer {
    /// Points beyond yield.
    pub plastic_points: usize,
    /// Out-of-balance force \[N/mm\].
    pub residual_norm: f64,
}
