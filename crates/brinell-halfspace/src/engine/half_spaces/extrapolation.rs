//! The displacement of surfaces by plastic strain, extrapolated to cells without size.
//!
//! It has an error of second order, `x + (x(n) - x(n/2))/3` of n cells over a semi-axis. The field
//! of a body has the factor of its deepest point, so that profile, dent and pile-up are those of
//! one surface. The approach that is left without force is the sum of both.

use std::sync::Arc;

use super::step::{HalfSpaceField, HalfSpaceStep};
use brinell_contact::ContactLoad;
use brinell_method::figures::Figure;
use brinell_method::observer::Observer;
use brinell_method::steps::StepReceiver;

/// Extrapolates the steps that it hands on.
pub(super) struct Extrapolated<'a>(pub &'a mut dyn StepReceiver<HalfSpaceField>);

impl StepReceiver<HalfSpaceField> for Extrapolated<'_> {
    fn step(&mut self, step: HalfSpaceStep, observer: &mut dyn Observer) {
        self.0.step(extrapolated(step), observer);
    }

    fn begin_anew(&mut self) {
        self.0.begin_anew();
    }
}

/// Part of the difference between an extrapolated figure and that of the coarse grid that the
/// extrapolation has added.
pub(super) const ADDED: f64 = 0.25;

/// Whether a figure is extrapolated.
pub(super) fn is_extrapolated(step: &HalfSpaceStep, figure: Figure) -> bool {
    step.figures.contact_ratio.is_none()
        && match figure {
            Figure::Dent | Figure::PileUp => true,
            Figure::Approach => is_permanent(step),
            _ => false,
        }
}

/// Returns a step with extrapolated displacements. Heights touch in spots of few cells, which have
/// no order.
pub(super) fn extrapolated(mut step: HalfSpaceStep) -> HalfSpaceStep {
    let Some(coarse) = step.coarse.filter(|_| step.figures.contact_ratio.is_none()) else {
        return step;
    };
    if is_permanent(&step) {
        step.figures.approach *= factor(step.figures.approach, coarse.approach);
    }
    let bodies = &mut step.field.bodies;
    let is_shared = matches!(&*bodies, [Some(upper), Some(lower)] if Arc::ptr_eq(upper, lower));
    if is_shared {
        bodies[0] = None;
    }
    let sides = step.figures.bodies.iter_mut().zip(coarse.bodies).zip(bodies.iter_mut());
    for ((figures, coarse), body) in sides {
        let (Some(figures), Some(coarse)) = (figures, coarse) else { continue };
        let factor = factor(figures.dent, coarse.dent);
        figures.dent *= factor;
        figures.pile_up *= factor;
        if let Some(body) = body {
            Arc::make_mut(body).plastic_displacement.iter_mut().for_each(|u| *u *= factor);
        }
    }
    if is_shared {
        let [upper, lower] = bodies;
        upper.clone_from(lower);
    }
    step
}

/// Whether the approach of a step is that of a force that was taken away.
fn is_permanent(step: &HalfSpaceStep) -> bool {
    matches!(step.load, ContactLoad::Force(_)) && step.figures.force <= 0.0
}

/// Returns the factor from the figure of the fine grid to the extrapolated one. Grids that differ by
/// more than the figure have no order.
fn factor(fine: f64, coarse: f64) -> f64 {
    if fine == 0.0 { 1.0 } else { 1.0 + (1.0 - coarse / fine).clamp(-1.0, 1.0) / 3.0 }
}
