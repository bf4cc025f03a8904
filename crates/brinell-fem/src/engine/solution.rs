//! The result of a solve.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::element::StressState;
use crate::engine::body_solution::BodySolution;
use crate::engine::body_system::contact_patch::{ContactPatch, LEAST_PART};
use crate::engine::conforming::ConformingPair;
use brinell_material::analytical::RoundedEdge;
use brinell_method::figures::Figures;
use brinell_method::observer::Interrupt;
use brinell_method::phases::PhaseTimes;
use brinell_method::sought::TargetFigure;
use brinell_method::steps::Step;

/// The answer to a job.
#[derive(Debug, Clone, Default)]
pub struct Solution {
    /// One for each load.
    pub steps: Vec<StepSolution>,
    /// Time by phase.
    pub phases: PhaseTimes,
    /// Mesh solves made.
    pub passes: usize,
    /// Why loads at the end are missing, or have only the figures of a coarser mesh.
    pub interrupted: Option<Interrupt>,
    /// For a sought force: relative change of its figure over the relative change of the force.
    pub sensitivity: Option<f64>,
}

/// The answer to one load.
pub type StepSolution = Step<SectionField>;

/// The section of two bodies under one load. Half models are not mirrored here.
#[derive(Debug, Clone)]
pub struct SectionField {
    /// Whether `x = 0` is a symmetry axis and only `x >= 0` is here.
    pub symmetric: bool,
    /// Third direction.
    pub stress_state: StressState,
    /// A pin and its hole, whose abscissae are arc lengths.
    pub conforming: Option<ConformingPair>,
    /// The smallest gap of the outlines as they are given, in whose place the gaps and the
    /// approach begin \[mm\].
    pub smallest_gap: f64,
    /// Tangential spacing of the candidate pairs \[mm\].
    pub spacing: f64,
    /// The candidate pairs in order of x.
    pub pairs: Vec<PairState>,
    /// Ends of the contact; `None` where nothing touches.
    pub patch: Option<ContactPatch>,
    /// Its connected parts, from outermost node to outermost node.
    pub parts: Vec<ContactPatch>,
    /// x of the peak pressure; where nothing touches, of the largest that the history had \[mm\].
    pub peak_position: f64,
    /// x of the middle of the contact, 0 of half models; where nothing touches, of the contact
    /// with the largest pressure that the history had \[mm\].
    pub middle: f64,
    /// Upper and lower body; `None` for a rigid one.
    pub bodies: [Option<Arc<BodySolution>>; 2],
    /// Corners of the surfaces that carry pressure, of the half that is meshed \[mm\].
    pub loaded_corners: Vec<f64>,
    /// Element size that surfaces given by points would need, where it is smaller than that of the
    /// mesh \[mm\].
    pub unresolved: Option<f64>,
    /// The rounded edge of a punch, where elements are too large for the contact on it.
    pub rounded_edge: Option<NarrowEdge>,
    /// The tip of a wedge or cone that is rounded off within a few elements, or that of a power
    /// below 2.
    pub rounded_tip: Option<RoundedTip>,
    /// Slope of the load-approach curve where the load begins to fall: of bodies with a memory the
    /// elastic one, of the pairs in contact \[N/mm per mm\].
    pub unloading_stiffness: f64,
}

/// A rounded edge on which the contact is narrow beside the elements.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NarrowEdge {
    /// Width of the contact and pressure on it, of elastic bodies.
    pub elastic: RoundedEdge,
    /// Half-width of that contact \[mm\].
    pub half_width: f64,
}

/// A tip that is narrow beside the elements.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoundedTip {
    /// Half of the width of the arc \[mm\]; `None` of a power below 2, whose curvature is infinite
    /// there.
    pub arc: Option<f64>,
    /// Largest pressure on it of elastic bodies, in closed form \[MPa\].
    pub elastic_pressure: f64,
}

/// One candidate pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairState {
    /// Abscissa, or arc length on a pin in a hole \[mm\].
    pub x: f64,
    /// Contact pressure \[MPa\].
    pub pressure: f64,
    /// Contact force along the normal, both sides of the axis for a pair on it \[N/mm\].
    pub force: f64,
    /// The part of that force along the approach.
    pub closing: f64,
    /// Gap after loading \[mm\].
    pub gap: f64,
}

impl SectionField {
    /// Whether the meshed half stands for two: a plane half model, not a body of revolution.
    pub fn is_mirrored(&self) -> bool {
        self.symmetric && self.stress_state != StressState::Axisymmetric
    }

    /// Contact force on both sides of the axis \[N/mm, or N in axisymmetry\].
    fn force(&self) -> f64 {
        let meshed: f64 = self.pairs.iter().map(|pair| pair.closing * pair.force).sum();
        let on_axis = self.pairs.first().map_or(0.0, |pair| pair.force);
        if self.is_mirrored() { 2.0 * meshed - on_axis } else { meshed }
    }

    /// Of a contact in several parts: the one with the fewest elements, of those that carry a
    /// share of the force worth looking at, and its elements over half of its own width. `None`
    /// for a contact in one part.
    pub fn coarsest_part(&self) -> Option<(ContactPatch, f64)> {
        let is_on_axis = |part: &ContactPatch| self.symmetric && part.left == 0.0;
        if let [only] = self.parts.as_slice()
            && (!self.symmetric || is_on_axis(only))
        {
            return None;
        }
        let least = LEAST_PART * self.pairs.iter().map(|pair| pair.force).sum::<f64>();
        let resolved = self.parts.iter().filter_map(|part| {
            let inside =
                || self.pairs.iter().filter(|pair| (part.left..=part.right).contains(&pair.x));
            let nodes = inside().count() as f64;
            // Each node stands for one element, on the axis for half of one.
            let elements = if is_on_axis(part) { nodes - 0.5 } else { 0.5 * nodes };
            (inside().map(|pair| pair.force).sum::<f64>() >= least).then_some((*part, elements))
        });
        resolved.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Figures of the contact and of both bodies under this approach and with this peak pressure.
    pub(super) fn figures(&self, approach: f64, peak_pressure: f64) -> Figures {
        let x: Vec<f64> = self.pairs.iter().map(|pair| pair.x).collect();
        let pressure: Vec<f64> = self.pairs.iter().map(|pair| pair.pressure).collect();
        let of = |body: &Option<Arc<BodySolution>>| {
            let of = |body: &Arc<BodySolution>| {
                body.figures(self.stress_state, self.symmetric, self.middle, &pressure)
            };
            body.as_ref().and_then(of)
        };
        Figures {
            peak_pressure,
            middle_pressure: Some(pressure_in_middle(
                self.stress_state,
                self.middle,
                &x,
                &pressure,
            )),
            half_width: self.patch.map_or(0.0, |patch| patch.half_width()),
            semi_axis_y: None,
            contact_area: None,
            contact_ratio: None,
            approach,
            force: self.force(),
            bodies: self.bodies.each_ref().map(of),
        }
    }

    /// Force over the width or, of a body of revolution, over the area of the contact circle; 0
    /// where nothing touches \[MPa\].
    pub fn mean_pressure(&self, figures: &Figures) -> f64 {
        let a = figures.half_width;
        if a <= 0.0 {
            return 0.0;
        }
        // Of a pin in a hole across the approach.
        let across = self.conforming.map_or(a, |pair| pair.half_chord(a));
        let area = match self.stress_state {
            StressState::PlaneStrain | StressState::PlaneStress => 2.0 * across,
            StressState::Axisymmetric => PI * across * across,
        };
        // The half-width is known to half an element; a mean above the peak would be its error.
        (figures.force / area).min(figures.peak_pressure)
    }
}

/// Returns the pressure at `middle` from those at ascending x \[MPa\]: interpolated between two
/// pairs, of a body of revolution by the parabola through the two pairs beside the axis. The pair
/// on the axis stands for a circle of half an element.
pub(super) fn pressure_in_middle(
    state: StressState,
    middle: f64,
    x: &[f64],
    pressure: &[f64],
) -> f64 {
    if let (StressState::Axisymmetric, [_, inner, outer, ..]) = (state, pressure) {
        return ((4.0 * inner - outer) / 3.0).max(0.0);
    }
    let right = x.partition_point(|x| *x <= middle);
    match (right.checked_sub(1).and_then(|left| pressure.get(left)), pressure.get(right)) {
        (Some(left), Some(beyond)) => {
            let part = (middle - x[right - 1]) / (x[right] - x[right - 1]);
            left + part * (beyond - left)
        }
        (Some(only), None) | (None, Some(only)) => *only,
        (None, None) => 0.0,
    }
}

/// A figure of the contact at the end of the loads by which it is found \[mm, MPa or 1\].
pub fn target_figure(step: &StepSolution, figure: TargetFigure) -> f64 {
    figure.of(&step.figures, step.field.mean_pressure(&step.figures))
}
