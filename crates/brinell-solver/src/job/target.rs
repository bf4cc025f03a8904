//! A figure of the contact as the target of a search for the force.

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::fields::InUnits;
use super::fields::NumberKind;
use super::reader::Cursor;
use super::{Domain, FaultCode, Named, PositiveF64, Units};
pub use brinell_method::sought::TargetFigure;

/// Returns the name of the figure in a sentence.
pub const fn label_of(figure: TargetFigure) -> &'static str {
    match figure {
        TargetFigure::PermanentApproach => "permanent approach",
        TargetFigure::DentDepth => "depth of the dent",
        TargetFigure::PeakPressure => "peak pressure",
        TargetFigure::MeanPressure => "mean pressure",
        TargetFigure::HalfWidth => "half-width",
        TargetFigure::MaxPlasticStrain => "largest plastic strain",
    }
}

/// Returns the description of the figure for the schema.
pub(super) const fn description(figure: TargetFigure) -> &'static str {
    match figure {
        TargetFigure::PermanentApproach => "Approach that is left when the force is taken away.",
        TargetFigure::DentDepth => {
            "Depth below the undeformed surface of the deeper of the two dents that are left \
             when the force is taken away."
        }
        TargetFigure::PeakPressure => "Largest contact pressure.",
        TargetFigure::MeanPressure => {
            "Force over the width of the contact or, in axisymmetry and three dimensions, \
             over its area."
        }
        TargetFigure::HalfWidth => {
            "Half-width of the contact; its radius in axisymmetry, its shorter semi-axis in \
             three dimensions."
        }
        TargetFigure::MaxPlasticStrain => "Largest equivalent plastic strain of both bodies.",
    }
}

/// Returns a typical value for the schema \[mm, MPa or 1\].
pub(super) const fn example(figure: TargetFigure) -> f64 {
    match figure {
        TargetFigure::PermanentApproach | TargetFigure::DentDepth => 1e-3,
        TargetFigure::PeakPressure | TargetFigure::MeanPressure => 1200.0,
        TargetFigure::HalfWidth => 0.3,
        TargetFigure::MaxPlasticStrain => 0.01,
    }
}

/// Returns the unit and range of the figure.
pub const fn measure_of(figure: TargetFigure) -> NumberKind {
    match figure {
        TargetFigure::PermanentApproach | TargetFigure::DentDepth => {
            NumberKind::Quantity(Domain::Approach)
        }
        TargetFigure::PeakPressure | TargetFigure::MeanPressure => {
            NumberKind::Quantity(Domain::Stress)
        }
        TargetFigure::HalfWidth => NumberKind::Quantity(Domain::Length),
        TargetFigure::MaxPlasticStrain => NumberKind::Pure(1e-9..=1.0),
    }
}

/// A figure and its target value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Target {
    /// The figure.
    pub figure: TargetFigure,
    /// Its target value \[mm, MPa or 1\].
    pub value: PositiveF64,
}

impl Target {
    pub(super) fn read(cursor: Cursor<'_>, units: Option<Units>) -> Option<Self> {
        let object = cursor.object()?;
        let known: Vec<_> = TargetFigure::ALL.iter().map(|figure| figure.name()).collect();
        object.only(&known);
        let given = TargetFigure::ALL.iter().copied().filter(|figure| object.has(figure.name()));
        let read = |figure: TargetFigure| {
            let value = object.required(figure.name(), |c| match measure_of(figure) {
                NumberKind::Quantity(quantity) => c.quantity(quantity, units),
                NumberKind::Pure(range) => c.number_in(&range),
            });
            value.map(|value| Self { figure, value })
        };
        let targets: Vec<_> = given.map(read).collect();
        if let [target] = targets[..] {
            return target;
        }
        let (code, only) = match targets.len() {
            0 => (FaultCode::Required, ""),
            _ => (FaultCode::Inconsistent, "only "),
        };
        object.fault_here(code, format_args!("must have {only}one of: {}", known.join(", ")));
        None
    }
}

impl Serialize for InUnits<'_, Target> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Target { figure, value } = self.0;
        let mut map = serializer.serialize_map(Some(1))?;
        map.serialize_entry(figure.name(), &measure_of(*figure).to_wire(self.1, value.get()))?;
        map.end()
    }
}
