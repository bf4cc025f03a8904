//! What the alternation of contact and plasticity asks of two bodies.

use super::phases::Phase;
use super::run::Run;
use crate::Error;
use brinell_contact::{ContactLoad, ContactProblem, ContactSolution, ContactSolver};
use brinell_material::ReferenceModuli;

/// One vector for each model of a body.
pub type BlockVector = Vec<Vec<f64>>;

/// Displacements and contact for a given initial stress.
#[derive(Debug, Clone)]
pub struct Response {
    /// Displacements where plastic flow and contact are evaluated \[mm\].
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

/// Two bodies and the contact between them.
///
/// `initial_stress` is the paper's P_e: the load that plastic flow puts on the elastic bodies,
/// nodal forces of finite elements. It is no stress, and another thing than the `initial_stress`
/// of a job. Couplings call the one that is applied `loads`, and P_e(u) its `image`. Forces of the
/// contact push the bodies apart, `R >= 0`.
///
/// Symmetry and equal bodies are the affair of the system: loads and figures are those of the
/// whole contact.
pub trait ContactSystem {
    /// An initial stress, or displacements, of nothing.
    fn zeros(&self) -> BlockVector;

    /// Initial gap δ0 of each candidate pair along its normal \[mm\].
    fn initial_gap(&self) -> &[f64];

    /// The contact conditions of the candidate pairs under other gaps and a load of the whole
    /// contact.
    fn contact_problem<'a>(&'a self, gap: &'a [f64], load: ContactLoad) -> ContactProblem<'a>;

    /// `u_p`: by how much an initial stress alone widens the gap at each pair \[mm\].
    fn gap_opening(&self, initial_stress: &BlockVector) -> Vec<f64>;

    /// The contact alone, at gaps that plastic flow has widened by `gap_opening`.
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

    /// The displacements under an initial stress and contact forces.
    fn displacement(&self, initial_stress: &BlockVector, force: &[f64]) -> BlockVector;

    /// Contact and displacements for a given initial stress: [`Self::gap_opening`],
    /// [`Self::contact`] and [`Self::displacement`] in one.
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

    /// The initial stress that the plastic law answers displacements with, written over `into`.
    /// Returns the points beyond yield.
    fn initial_stress(&self, displacement: &BlockVector, into: &mut BlockVector) -> usize;

    /// A norm of displacements or of an initial stress.
    fn norm(&self, v: &BlockVector) -> f64;

    /// The same norm of a difference.
    fn distance(&self, v: &BlockVector, w: &BlockVector) -> f64;

    /// The entries that change from one iteration to the next, in one vector. It may become longer
    /// from iteration to iteration: the entries to come have been zero.
    fn pack(&self, vectors: &BlockVector) -> Vec<f64>;

    /// Writes these entries back to where [`Self::pack`] took them from.
    fn unpack(&self, packed: &[f64], vectors: &mut BlockVector);

    /// Figures of the whole contact.
    fn figures(&self, contact: &ContactSolution) -> ContactFigures;

    /// Displacements of the last accepted state, zero at rest.
    fn accepted(&self) -> &BlockVector;

    /// Accepts the state with these displacements: increments of a history go on from it.
    fn commit(&mut self, displacement: BlockVector);

    /// The same bodies, if their stiffness can take other moduli than the elastic ones.
    fn linearizable(&mut self) -> Option<&mut dyn Linearize> {
        None
    }

    /// Their stiffness with secant moduli, at first the elastic ones, if there is one.
    fn secant_stiffness(&self) -> Option<Box<dyn SecantStiffness + '_>> {
        None
    }
}

/// Bodies whose stiffness can take the moduli of plastic flow.
pub trait Linearize: ContactSystem {
    /// Factorizes with moduli of plastic flow at displacements or, without any, with the elastic
    /// ones.
    ///
    /// # Errors
    /// Those of a factorization.
    fn linearize(
        &mut self,
        at: Option<(&BlockVector, ReferenceModuli)>,
        run: &mut Run<'_>,
    ) -> Result<(), Error>;

    /// Factorizations that take.
    fn factorizations(&self) -> usize;

    /// Forces on the bodies: those of an initial stress and of the contact.
    fn applied(&self, initial_stress: &BlockVector, force: &[f64]) -> BlockVector;

    /// The work of forces on displacements of both whole bodies.
    fn work(&self, forces: &BlockVector, displacement: &BlockVector) -> f64;
}

/// A stiffness with the secant moduli of the last state.
pub trait SecantStiffness {
    /// Contact and displacements, the latter on all equations, without any initial stress.
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

    /// What the plastic law says of a state, whose secant moduli it keeps.
    ///
    /// # Errors
    /// Where the observer stops it.
    fn evaluate(&mut self, response: &Response, run: &mut Run<'_>)
    -> Result<PlasticAnswer, Error>;

    /// Factorizes with the secant moduli of the last state. Returns the number of factorizations.
    ///
    /// # Errors
    /// Those of a factorization, and where the observer stops it.
    fn renew(&mut self, run: &mut Run<'_>) -> Result<usize, Error>;
}

/// What the plastic law says of a state.
#[derive(Debug, Clone, Copy, Default)]
pub struct PlasticAnswer {
    /// Points beyond yield.
    pub plastic_points: usize,
    /// Out-of-balance force \[N/mm\].
    pub residual_norm: f64,
}
