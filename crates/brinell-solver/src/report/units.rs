//! Figures as the job wants them written.

use crate::job::{Analysis, Quantity, Units};

/// Writes figures of the core in a job's units.
#[derive(Debug, Clone, Copy)]
pub(super) struct UnitConverter {
    units: Units,
    /// What a force is: on unit thickness, or in all.
    force: Quantity,
}

impl UnitConverter {
    pub fn new(units: Units, analysis: Analysis) -> Self {
        Self { units, force: analysis.force() }
    }

    /// A figure in N–mm–MPa in the job's units.
    pub fn figure(self, quantity: Quantity, core: f64) -> f64 {
        quantity.to_wire(self.units, core)
    }

    pub fn length(self, core: f64) -> f64 {
        self.figure(Quantity::Length, core)
    }

    pub fn stress(self, core: f64) -> f64 {
        self.figure(Quantity::Stress, core)
    }

    pub fn force(self, core: f64) -> f64 {
        self.figure(self.force, core)
    }

    /// A stiffness, force over length.
    pub fn stiffness(self, core: f64) -> f64 {
        self.force(core) / self.length(1.0)
    }

    /// An area \[mm²\].
    pub fn area(self, core: f64) -> f64 {
        self.length(self.length(core))
    }

    /// A length with its unit, for sentences.
    pub fn length_text(self, core: f64) -> String {
        format!("{} {}", self.length(core), Quantity::Length.symbol(self.units))
    }
}
