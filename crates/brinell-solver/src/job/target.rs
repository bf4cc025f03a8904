//! A figure of the contact as the target of a search for the force.

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::fields::Figure;
use super::fields::InUnits;
use super::reader::Cursor;
use super::{FaultCode, Named, PositiveF64, Quantity, Units};

/// A figure of the contact that determines the force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TargetFigure {
    /// Approach after unloading.
    PermanentApproach,
    /// Depth of the deeper of the two dents after unloading.
    DentDepth,
    /// Largest contact pressure.
    PeakPressure,
    /// Force over the width, or over the area, of the contact.
    MeanPressure,
    /// Half-width, or radius, of the contact.
    HalfWidth,
    /// Largest equivalent plastic strain of both bodies.
    MaxPlasticStrain,
}

impl Named for TargetFigure {
    const ALL: &'static [Self] = &[
        Self::PermanentApproach,
        Self::DentDepth,
        Self::PeakPressure,
        Self::MeanPressure,
        Self::HalfWidth,
        Self::MaxPlasticStrain,
    ];

    fn name(self) -> &'static str {
        match self {
            Self::PermanentApproach => "permanent_approach",
            Self::DentDepth => "dent_depth",
            Self::PeakPressure => "peak_pressure",
            Self::MeanPressure => "mean_pressure",
            Self::HalfWidth => "half_width",
            Self::MaxPlasticStrain => "max_plastic_strain",
        }
    }
}

impl TargetFigure {
    /// Returns the name of the figure in a sentence.
    pub const fn label(self) -> &'static str {
        match self {
            Self::PermanentApproach => "permanent approach",
            Self::DentDepth => "depth of the dent",
            Self::PeakPressure => "peak pressure",
            Self::MeanPressure => "mean pressure",
            Self::HalfWidth => "half-width",
            Self::MaxPlasticStrain => "largest plastic strain",
        }
    }

    /// Returns the description of the figure for the schema.
    pub(super) const fn description(self) -> &'static str {
        match self {
            Self::PermanentApproach => "Approach that is left when the force is taken away.",
            Self::DentDepth => {
                "Depth below the undeformed surface of the deeper of the two dents that are left \
                 when the force is taken away."
            }
            Self::PeakPressure => "Largest contact pressure.",
            Self::MeanPressure => {
                "Force over the width of the contact or, in axisymmetry and three dimensions, \
                 over its area."
            }
            Self::HalfWidth => {
                "Half-width of the contact; its radius in axisymmetry, its shorter semi-axis in \
                 three dimensions."
            }
            Self::MaxPlasticStrain => "Largest equivalent plastic strain of both bodies.",
        }
    }

    /// Returns a typical value for the schema \[mm, MPa or 1\].
    pub(super) const fn example(self) -> f64 {
        match self {
            Self::PermanentApproach | Self::DentDepth => 1e-3,
            Self::PeakPressure | Self::MeanPressure => 1200.0,
            Self::HalfWidth => 0.3,
            Self::MaxPlasticStrain => 0.01,
        }
    }

    /// Returns the unit and range of the figure.
    pub const fn figure(self) -> Figure {
        match self {
            Self::PermanentApproach | Self::DentDepth => Figure::Quantity(Quantity::Approach),
            Self::PeakPressure | Self::MeanPressure => Figure::Quantity(Quantity::Stress),
            Self::HalfWidth => Figure::Quantity(Quantity::Length),
            Self::MaxPlasticStrain => Figure::Pure(1e-9..=1.0),
        }
    }

    /// Whether the figure is measured after unloading, which needs flow theory.
    pub const fn is_permanent(self) -> bool {
        matches!(self, Self::PermanentApproach | Self::DentDepth)
    }

    /// Whether the figure is zero without plastic flow.
    pub const fn needs_yield(self) -> bool {
        self.is_permanent() || matches!(self, Self::MaxPlasticStrain)
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
            let value = object.required(figure.name(), |c| match figure.figure() {
                Figure::Quantity(quantity) => c.quantity(quantity, units),
                Figure::Pure(range) => c.number_in(&range),
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
        map.serialize_entry(figure.name(), &figure.figure().to_wire(self.1, value.get()))?;
        map.end()
    }
}
