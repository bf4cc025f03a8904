//! An answer on one grid, before its errors are known.

use std::sync::Arc;

use super::check::Check;
use super::measure::Measured;
use super::problem::HalfSpaceProblem;
use super::step::{HalfSpaceFigures, HalfSpaceStep};
use crate::contact::ContactLoad;
use crate::solver::method::observer::{IterationRecord, SolveStatus};
use crate::solver::method::steps::IncrementRecord;

/// The answer to a load on one grid.
pub(super) struct RawStep {
    pub load: ContactLoad,
    pub status: SolveStatus,
    pub measured: Measured,
    pub check: Check,
    pub history: Vec<IterationRecord>,
    pub increments: Vec<IncrementRecord>,
    pub enlargements: usize,
}

impl RawStep {
    /// Semi-axes of the contact, or these where nothing touches.
    pub fn semi_axes_or(&self, other: [f64; 2]) -> [f64; 2] {
        let axes = self.measured.figures.semi_axes;
        if axes[0] > 0.0 && axes[1] > 0.0 { axes } else { other }
    }

    /// Whether a cell has yielded.
    pub fn yields(&self) -> bool {
        self.measured.figures.max_plastic_strain.iter().any(|strain| *strain > 0.0)
    }

    pub fn into_step(self, problem: &HalfSpaceProblem, errors: Option<HalfSpaceFigures>) -> HalfSpaceStep {
        let Measured { figures, peak_position, largest_cell_pressure, surface, energy, bodies } =
            self.measured;
        HalfSpaceStep {
            status: self.status,
            load: self.load,
            figures,
            errors,
            peak_position,
            largest_cell_pressure,
            hertz: (figures.force > 0.0).then(|| problem.hertz(figures.force)),
            surface: Arc::new(surface),
            energy,
            bodies,
            history: self.history,
            contact_check: self.check.contact,
            plastic_residual: self.check.plastic_residual,
            increments: self.increments,
            enlargements: self.enlargements,
        }
    }
}
