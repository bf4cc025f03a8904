//! The search for the force of a sought figure of a contact in three dimensions: the onset of
//! yield, or a target.

use crate::EllipticContact;

use super::error::HalfSpaceError;
use super::errors::{errors, target_error};
use super::given::given;
use super::law::initial_stress_over_depth;
use super::problem::HalfSpaceProblem;
use super::step::{HalfSpaceBody, HalfSpaceField, HalfSpaceStep, von_mises};
use brinell_contact::ContactLoad;
use brinell_material::Solid;
use brinell_method::Limit;
use brinell_method::figures::{Figure, Figures};
use brinell_method::force_search::{Density, Terms, find};
use brinell_method::loads::{Tried, Wanted};
use brinell_method::run::Run;
use brinell_method::sought::{Sought, TargetFigure};

/// Factor by which the coarse grids of the search have fewer cells than the job asks for, and
/// their least number of cells over a semi-axis.
const COARSER: u32 = 2;
const FEWEST_CELLS: u32 = 4;
/// Relative deviation that ends the search, largest number of fine solves, and relative deviation
/// from which on the value counts as missed: for a target, and for the onset of yield.
const TARGET: (f64, usize, f64) = (1e-3, 4, 1e-2);
const ONSET: (f64, usize, f64) = (2e-4, 8, 3e-3);
/// Growth of the stress at the onset of yield with the force.
const ONSET_SLOPE: f64 = 1.0 / 3.0;
/// Ratio of elastic peak pressure to yield stress in the first trial for a figure of plastic flow,
/// and the largest ratio in the first trial for a pressure.
const PLASTIC_START: f64 = 2.5;
const HIGHEST_START: f64 = 4.0;
/// Parts of the depth from the middle of the layer above to that of the layer below.
const PARTS: usize = 16;

/// Searches for the force. Returns the steps at this force, the unloading included, and the
/// relative change of the figure over the relative change of the force.
///
/// # Errors
/// [`HalfSpaceError::NoYieldPoint`], [`brinell_method::Error::Unreachable`], and the errors of a solve.
pub(super) fn run(
    problem: &HalfSpaceProblem,
    sought: Sought,
    run: &mut Run<'_>,
) -> Result<(Vec<HalfSpaceStep>, f64), HalfSpaceError> {
    let mut solved = problem.clone();
    if sought == Sought::Onset {
        let elastic = |material: &Option<Solid>| material.as_ref().map(Solid::without_plasticity);
        solved.materials = problem.materials.each_ref().map(elastic);
    }
    if let (Sought::Onset, Some(force)) = (sought, problem.onset) {
        let mut steps: Vec<HalfSpaceStep> = Vec::new();
        let interrupt = given(&solved, &[ContactLoad::Force(force)], run, &mut steps)?;
        return match interrupt.or_else(|| steps.iter().find_map(|step| step.status.interrupt())) {
            Some(interrupt) => {
                Err(HalfSpaceError::Method(brinell_method::Error::Interrupted(interrupt)))
            }
            None => Ok((steps, ONSET_SLOPE)),
        };
    }
    let search = ForceSearch { problem, solved, sought };
    let trial = |density, force, run: &mut Run<'_>| search.trial(density, force, run);
    let found = find(trial, search.terms()?, run)?;
    let mut steps = found.trial.steps;
    for step in &mut steps {
        step.search.systems = *run.passes;
    }
    if let Sought::Target(target) = sought {
        let errors = steps.last().and_then(|step| Some((step, errors(step, None)?)));
        let error = errors.and_then(|(step, errors)| target_error(step, &errors, target.figure));
        for step in &mut steps {
            step.search.force_error = error.map(|error| error / found.sensitivity);
        }
    }
    Ok((steps, found.sensitivity))
}

/// Returns the force of the first trial \[N\].
///
/// # Errors
/// [`HalfSpaceError::NoYieldPoint`].
pub(super) fn first_force(
    problem: &HalfSpaceProblem,
    sought: Sought,
) -> Result<f64, HalfSpaceError> {
    let weakest = problem.weakest();
    let under_peak = |peak: f64| problem.force_where(|hertz| hertz.peak_pressure, peak, 3.0);
    let highest = weakest.map_or(f64::INFINITY, |weakest| HIGHEST_START * weakest);
    match sought {
        Sought::Onset => problem.yield_force().ok_or(HalfSpaceError::NoYieldPoint),
        Sought::Target(target) => match target.figure {
            TargetFigure::HalfWidth => {
                let shorter = |hertz: &EllipticContact| hertz.semi_axis_x.min(hertz.semi_axis_y);
                Ok(problem.force_where(shorter, target.value, 3.0))
            }
            TargetFigure::PeakPressure => Ok(under_peak(target.value.min(highest))),
            TargetFigure::MeanPressure => Ok(under_peak((1.5 * target.value).min(highest))),
            TargetFigure::PermanentApproach
            | TargetFigure::DentDepth
            | TargetFigure::MaxPlasticStrain => weakest
                .map(|weakest| under_peak(PLASTIC_START * weakest))
                .ok_or(HalfSpaceError::NoYieldPoint),
        },
    }
}

struct ForceSearch<'a> {
    /// The problem as it is given.
    problem: &'a HalfSpaceProblem,
    /// The problem that the trials solve: without plasticity if the onset of yield is sought.
    solved: HalfSpaceProblem,
    sought: Sought,
}

impl ForceSearch<'_> {
    fn terms(&self) -> Result<Terms, HalfSpaceError> {
        let (tolerance, most_fine, missed) =
            if self.sought == Sought::Onset { ONSET } else { TARGET };
        let first_force = first_force(self.problem, self.sought)?;
        Ok(Terms {
            first_force,
            expected_slope: self.expected_slope(),
            tolerance,
            most_fine,
            missed,
        })
    }

    /// Returns an estimate of `d ln figure / d ln force`.
    fn expected_slope(&self) -> f64 {
        match self.sought {
            Sought::Onset => ONSET_SLOPE,
            Sought::Target(target) => match target.figure {
                TargetFigure::PeakPressure | TargetFigure::MeanPressure => 0.3,
                TargetFigure::HalfWidth => 0.4,
                TargetFigure::PermanentApproach
                | TargetFigure::DentDepth
                | TargetFigure::MaxPlasticStrain => 1.5,
            },
        }
    }

    /// Solves under one force.
    fn trial(
        &self,
        density: Density,
        force: f64,
        run: &mut Run<'_>,
    ) -> Result<Tried<HalfSpaceField>, HalfSpaceError> {
        let mut problem = self.solved.clone();
        if density == Density::Coarse {
            let cells = problem.cells_per_semi_axis;
            problem.cells_per_semi_axis = (cells / COARSER).max(FEWEST_CELLS).min(cells);
        }
        let wanted = Wanted {
            is_permanent: self.sought.is_permanent(),
            ratio: &|step| self.ratio(step),
            too_large: &|error| match error {
                HalfSpaceError::Overloaded { .. } => Ok(Limit::Other(error.to_string())),
                error => Err(error),
            },
        };
        wanted.trial(force, |loads, steps| given(&problem, loads, run, steps))
    }

    /// Returns the ratio of the figure to its target value.
    fn ratio(&self, step: &HalfSpaceStep) -> f64 {
        match self.sought {
            Sought::Onset => {
                self.problem.highest_utilization(step).map_or(0.0, |highest| highest.ratio)
            }
            Sought::Target(target) => target_figure(&step.figures, target.figure) / target.value,
        }
    }
}

/// The point with the largest ratio of stress to yield stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HighestUtilization {
    /// Von Mises stress over the nominal yield stress of the unloaded body.
    pub ratio: f64,
    /// 0 for the upper body, 1 for the lower body.
    pub side: usize,
    /// `[x, y, z]`: the middle of a cell, at any depth \[mm\].
    pub position: [f64; 3],
}

impl HalfSpaceProblem {
    /// Returns the highest utilization of all bodies with a hardening curve; `None` without one.
    pub fn highest_utilization(&self, step: &HalfSpaceStep) -> Option<HighestUtilization> {
        let sides = self.materials.iter().zip(&step.field.bodies).enumerate();
        let of_sides = sides.filter_map(|(side, (material, body))| {
            highest_in(side, material.as_ref()?, self.orientation(), body.as_deref()?)
        });
        of_sides.max_by(|a, b| a.ratio.total_cmp(&b.ratio))
    }
}

/// The highest utilization of a body: the most stressed column of each layer is followed over the
/// depth, from the middle of the layer above or the surface to that of the layer below. There the
/// stress of the pressure is the parabola that has the means of three layers, and initial stress
/// and strength are those of the depth.
fn highest_in(
    side: usize,
    material: &Solid,
    angle: f64,
    body: &HalfSpaceBody,
) -> Option<HighestUtilization> {
    let (law, strength) = (material.hardening_law()?, material.strength());
    let initial = initial_stress_over_depth(material, angle);
    let (layers, n_cells, ny) = (&body.layers, body.grid.n_cells(), body.grid.ny());
    let limit = |depth: f64| {
        law.nominal_yield_stress() * strength.map_or(1.0, |strength| strength.factor(depth))
    };
    let of_layer = |layer: usize| {
        let cell = (0..n_cells)
            .max_by(|a, b| body.von_mises(layer, *a).total_cmp(&body.von_mises(layer, *b)))?;
        let of_pressure = |layer: usize| {
            let [xx, yy, xy] = initial(layers.middle(layer));
            let before = [xx, yy, 0.0, xy, 0.0, 0.0];
            std::array::from_fn(|k| body.stress.component(layer, k)[cell] - before[k])
        };
        let first = layer.saturating_sub(1).min(layers.len().checked_sub(3)?);
        let parabola = Parabola {
            faces: layers.faces().get(first..first + 4)?.try_into().ok()?,
            means: [0, 1, 2].map(|below| of_pressure(first + below)),
        };
        let above = layer.checked_sub(1).map_or(0.0, |above| layers.middle(above));
        let below = layers.middle((layer + 1).min(layers.len() - 1));
        let at = |sample: usize| {
            let depth = above + (below - above) * sample as f64 / PARTS as f64;
            let [xx, yy, xy] = initial(depth);
            let before = [xx, yy, 0.0, xy, 0.0, 0.0];
            let of_pressure = parabola.at(depth);
            let stress = std::array::from_fn(|k| of_pressure[k] + before[k]);
            HighestUtilization {
                ratio: von_mises(stress) / limit(depth),
                side,
                position: [body.grid.x(cell / ny), body.grid.y(cell % ny), depth],
            }
        };
        (0..=PARTS).map(at).max_by(|a, b| a.ratio.total_cmp(&b.ratio))
    };
    (0..layers.len()).filter_map(of_layer).max_by(|a, b| a.ratio.total_cmp(&b.ratio))
}

/// A stress over depth, quadratic in each component, with given means over three layers.
struct Parabola {
    faces: [f64; 4],
    means: [[f64; 6]; 3],
}

impl Parabola {
    /// The derivative of the cubic that has the integral of the stress at the faces.
    fn at(&self, z: f64) -> [f64; 6] {
        let [a, b, c, d] = self.faces;
        let linear = (z - a) + (z - b);
        let quadratic = (z - a) * (z - b) + (z - a) * (z - c) + (z - b) * (z - c);
        std::array::from_fn(|k| {
            let [first, second, third] = self.means.map(|mean| mean[k]);
            let (upper, lower) = ((second - first) / (c - a), (third - second) / (d - b));
            first + upper * linear + (lower - upper) / (d - a) * quadratic
        })
    }
}

/// Returns a figure of the contact at the end of its loads, of rigid bodies 0 \[mm, MPa or 1\].
pub fn target_figure(figures: &Figures, figure: TargetFigure) -> f64 {
    let largest = |figure: Figure| figures.values().largest(figure).unwrap_or_default();
    match figure {
        TargetFigure::PermanentApproach => figures.approach,
        TargetFigure::DentDepth => largest(Figure::Dent),
        TargetFigure::PeakPressure => figures.peak_pressure,
        TargetFigure::MeanPressure => {
            figures.force / largest(Figure::ContactArea).max(f64::MIN_POSITIVE)
        }
        TargetFigure::HalfWidth => figures.semi_axes()[0].min(figures.semi_axes()[1]),
        TargetFigure::MaxPlasticStrain => largest(Figure::MaxPlasticStrain),
    }
}
