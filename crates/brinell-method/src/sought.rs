//! The loads of a solve: given ones, or a force that is sought for its effect.

use strum::{IntoStaticStr, VariantArray};

use super::figures::{Figure, Figures};
use brinell_contact::ContactLoad;

/// Mean pressure over the yield stress under which a figure of plastic flow is first looked for.
const PLASTIC_START: f64 = 1.5;
/// Mean pressure over the yield stress that a first trial does not exceed.
const HIGHEST_START: f64 = 2.5;
/// Mean over peak pressure of a first trial.
const MEAN_OF_PEAK: f64 = 0.75;

/// The loads of a solve.
#[derive(Debug, Clone, PartialEq)]
pub enum Loads {
    /// Loads that are applied to bodies at rest, each by itself.
    Each(Vec<ContactLoad>),
    /// Loads one after the other. Bodies with a memory keep what the loads before have left.
    History(Vec<ContactLoad>),
    /// A force that is sought for its effect.
    Sought(Sought),
}

/// The effect that defines a force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sought {
    /// The elastic bodies just reach the yield stress at one point.
    Onset,
    /// A figure of the contact has a value.
    Target(Target),
}

/// A figure and its target value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Target {
    /// The figure.
    pub figure: TargetFigure,
    /// Its target value \[mm, MPa or 1\].
    pub value: f64,
}

/// A figure of the contact that determines the force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "snake_case")]
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

impl Loads {
    /// Returns the smallest force above zero, if all loads are given as forces.
    pub fn least_force(&self) -> Option<f64> {
        let (Self::Each(loads) | Self::History(loads)) = self else { return None };
        let force = |load: &ContactLoad| match *load {
            ContactLoad::Force(force) => Some(force),
            ContactLoad::Approach(_) => None,
        };
        let forces: Vec<f64> = loads.iter().map(force).collect::<Option<_>>()?;
        forces.into_iter().filter(|force| *force > 0.0).reduce(f64::min)
    }
}

/// Returns loads one after the other as a history; `None` without a load above zero.
pub fn history_of(loads: &[ContactLoad]) -> Option<Loads> {
    let are_loads =
        loads.iter().all(|load| load.magnitude().is_finite() && load.magnitude() >= 0.0);
    let is_loaded = loads.iter().any(|load| load.magnitude() > 0.0);
    (are_loads && is_loaded).then(|| Loads::History(loads.to_vec()))
}

/// Returns the largest force and the largest approach, if they are above zero.
pub fn largest_loads(loads: &[ContactLoad]) -> Vec<ContactLoad> {
    let largest =
        |of: fn(&ContactLoad) -> Option<f64>| loads.iter().filter_map(of).fold(0.0, f64::max);
    let force =
        largest(|load| if let ContactLoad::Force(force) = load { Some(*force) } else { None });
    let approach =
        largest(|load| if let ContactLoad::Approach(a) = load { Some(*a) } else { None });
    let mut found = Vec::new();
    if force > 0.0 {
        found.push(ContactLoad::Force(force));
    }
    if approach > 0.0 {
        found.push(ContactLoad::Approach(approach));
    }
    found
}

impl Sought {
    /// Whether the effect is that of a force that is taken away.
    pub const fn is_permanent(self) -> bool {
        matches!(self, Self::Target(target) if target.figure.is_permanent())
    }

    /// Whether the effect follows the width of the contact, which a mesh knows to half an element.
    pub const fn follows_width(self) -> bool {
        use TargetFigure::{HalfWidth, MeanPressure};
        matches!(self, Self::Target(Target { figure: HalfWidth | MeanPressure, .. }))
    }

    /// Returns the mean pressure under which the effect is first looked for \[MPa\]: of bodies
    /// that yield from `weakest` on, if they do. `None` where only a width is known.
    pub fn first_mean_pressure(self, weakest: Option<f64>) -> Option<f64> {
        let mean = match self {
            Self::Onset => weakest,
            Self::Target(Target { figure, value }) => match figure {
                TargetFigure::HalfWidth => None,
                TargetFigure::PeakPressure => Some(MEAN_OF_PEAK * value),
                TargetFigure::MeanPressure => Some(value),
                TargetFigure::PermanentApproach
                | TargetFigure::DentDepth
                | TargetFigure::MaxPlasticStrain => weakest.map(|stress| PLASTIC_START * stress),
            },
        };
        mean.map(|mean| weakest.map_or(mean, |stress| mean.min(HIGHEST_START * stress)))
    }

    /// Returns the expected `d ln figure / d ln force`.
    pub const fn expected_slope(self) -> f64 {
        match self {
            Self::Onset => 0.5,
            Self::Target(target) => match target.figure {
                TargetFigure::PeakPressure | TargetFigure::MeanPressure => 0.4,
                TargetFigure::HalfWidth => 0.5,
                TargetFigure::PermanentApproach
                | TargetFigure::DentDepth
                | TargetFigure::MaxPlasticStrain => 2.0,
            },
        }
    }
}

impl TargetFigure {
    /// Returns the figure at the end of the loads by which it is found \[mm, MPa or 1\]; of two
    /// semi-axes the shorter one.
    pub fn of(self, figures: &Figures, mean_pressure: f64) -> f64 {
        let largest = |figure| figures.values().largest(figure).unwrap_or_default();
        let [along_x, along_y] = figures.semi_axes();
        match self {
            Self::PermanentApproach => figures.approach,
            Self::DentDepth => largest(Figure::Dent),
            Self::PeakPressure => figures.peak_pressure,
            Self::MeanPressure => mean_pressure,
            Self::HalfWidth => along_x.min(along_y),
            Self::MaxPlasticStrain => largest(Figure::MaxPlasticStrain),
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
