//! Conversion of figures to the units of the job.

use crate::job::fields::NumberKind;
use crate::job::{Analysis, Quantity, TargetFigure, Units, measure_of};

/// Converts figures of the solver to the units of a job.
#[derive(Debug, Clone, Copy)]
pub(crate) struct UnitConverter {
    units: Units,
    /// Quantity of a force: force on unit thickness, or total force.
    force: Quantity,
}

impl UnitConverter {
    pub fn new(units: Units, analysis: Analysis) -> Self {
        Self { units, force: analysis.force().quantity() }
    }

    /// Converts a figure from N–mm–MPa to the units of the job. Zero loses its sign.
    pub fn figure(self, quantity: Quantity, core: f64) -> f64 {
        self.units.to_wire(quantity, core) + 0.0
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

    /// Converts a stiffness, force over length.
    pub fn stiffness(self, core: f64) -> f64 {
        self.force(core) / self.length(1.0)
    }

    /// Converts an area \[mm²\].
    pub fn area(self, core: f64) -> f64 {
        self.length(self.length(core))
    }

    /// Converts the figure of a row of the table of figures.
    pub fn of(self, quantity: Quantity, core: f64) -> f64 {
        match quantity {
            Quantity::Area => self.area(core),
            Quantity::Force => self.force(core),
            quantity => self.figure(quantity, core),
        }
    }

    /// Returns a length with its unit, for sentences: all digits of a dimension of the job.
    pub fn exact_length(self, core: f64) -> String {
        format!("{} {}", self.length(core), self.units.symbol(Quantity::Length))
    }

    /// Returns a length with its unit, to five digits, for sentences.
    pub fn length_text(self, core: f64) -> String {
        format!("{} {}", rounded(self.length(core)), self.units.symbol(Quantity::Length))
    }

    /// Converts the figure of a target to its own unit.
    pub fn of_target(self, figure: TargetFigure, core: f64) -> f64 {
        measure_of(figure).to_wire(self.units, core)
    }

    /// Returns the figure of a target with its unit, to five digits, for sentences.
    pub fn target_text(self, figure: TargetFigure, core: f64) -> String {
        let value = rounded(self.of_target(figure, core));
        match measure_of(figure) {
            NumberKind::Quantity(quantity) => format!("{value} {}", quantity.symbol(self.units)),
            NumberKind::Pure(_) => value,
        }
    }

    /// Returns a length with its unit, to three digits, for sentences.
    pub fn length_about(self, core: f64) -> String {
        format!("{} {}", about(self.length(core)), self.units.symbol(Quantity::Length))
    }

    /// Returns a stress with its unit, to three digits, for sentences.
    pub fn stress_about(self, core: f64) -> String {
        format!("{} {}", about(self.stress(core)), self.units.symbol(Quantity::Stress))
    }

    /// Returns a stress with its unit, to five digits, for sentences.
    pub fn stress_text(self, core: f64) -> String {
        format!("{} {}", rounded(self.stress(core)), self.units.symbol(Quantity::Stress))
    }

    /// Returns a force with its unit, to five digits, for sentences.
    pub fn force_text(self, core: f64) -> String {
        format!("{} {}", rounded(self.force(core)), self.units.symbol(self.force))
    }
}

/// Returns a figure to five digits, for sentences.
pub(crate) fn rounded(value: f64) -> String {
    to_digits(value, 5)
}

/// Returns a figure to three digits, for sentences.
pub(crate) fn about(value: f64) -> String {
    to_digits(value, 3)
}

/// Returns a figure to a number of digits, for sentences.
pub(crate) fn to_digits(value: f64, digits: usize) -> String {
    let digits = format!("{value:.*e}", digits - 1);
    match digits.parse::<f64>() {
        Ok(plain) if plain == 0.0 || (1e-3..1e7).contains(&plain.abs()) => plain.to_string(),
        Ok(plain) => format!("{plain:e}"),
        Err(_) => digits,
    }
}

/// Returns a fraction in percent, to two digits.
pub(crate) fn percent(part: f64) -> String {
    let digits = format!("{:.1e}", 100.0 * part);
    match digits.parse::<f64>() {
        Ok(percent) if percent == 0.0 || (1e-3..1e4).contains(&percent) => format!("{percent} %"),
        _ => format!("{digits} %"),
    }
}
