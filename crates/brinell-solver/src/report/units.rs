//! Figures as the job wants them written.

use crate::job::fields::Figure;
use crate::job::{Analysis, Quantity, TargetFigure, Units};

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

    /// A figure in N–mm–MPa in the job's units; zero has no sign.
    pub fn figure(self, quantity: Quantity, core: f64) -> f64 {
        quantity.to_wire(self.units, core) + 0.0
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

    /// The figure of a target in its own unit.
    pub fn of_target(self, figure: TargetFigure, core: f64) -> f64 {
        figure.figure().to_wire(self.units, core)
    }

    /// The figure of a target with its unit, to five digits, for sentences.
    pub fn target_text(self, figure: TargetFigure, core: f64) -> String {
        let value = rounded(self.of_target(figure, core));
        match figure.figure() {
            Figure::Quantity(quantity) => format!("{value} {}", quantity.symbol(self.units)),
            Figure::Pure(_) => value,
        }
    }

    /// A stress with its unit, to five digits, for sentences.
    pub fn stress_text(self, core: f64) -> String {
        format!("{} {}", rounded(self.stress(core)), Quantity::Stress.symbol(self.units))
    }

    /// A force with its unit, to five digits, for sentences.
    pub fn force_text(self, core: f64) -> String {
        format!("{} {}", rounded(self.force(core)), self.force.symbol(self.units))
    }
}

/// A figure to five digits, for sentences.
pub(super) fn rounded(value: f64) -> String {
    let digits = format!("{value:.4e}");
    match digits.parse::<f64>() {
        Ok(plain) if plain == 0.0 || (1e-3..1e7).contains(&plain.abs()) => plain.to_string(),
        _ => digits,
    }
}
