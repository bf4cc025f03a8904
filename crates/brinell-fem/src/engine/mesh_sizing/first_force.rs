//! The force from which a search begins, by what closed forms say of the size of the contact.

use crate::engine::error::MeshedError;
use crate::engine::mesh_sizing::contact_size::ContactSizeEstimate;
use crate::engine::problem::{Problem, ProblemBody};
use brinell_contact::ContactLoad;
use brinell_method::sought::{Sought, Target, TargetFigure};

/// Lowest yield stress of all depths \[MPa\].
pub(crate) fn weakest(problem: &Problem) -> Option<f64> {
    let strength = |body: &ProblemBody| Some(body.yield_stress()? * body.strength_range().0);
    problem.bodies.iter().filter_map(strength).reduce(f64::min)
}

/// A force to start from: the one that is expected to give the half-width that is sought, or a
/// mean pressure.
///
/// # Errors
/// [`MeshedError::Conforming`] or [`MeshedError::TouchesAtEnd`].
pub(crate) fn first_force(sought: Sought, problem: &Problem) -> Result<f64, MeshedError> {
    if let Sought::Target(Target { figure: TargetFigure::HalfWidth, value }) = sought {
        return force_below(problem, |_, a| a < value);
    }
    let mean = sought.first_mean_pressure(weakest(problem)).unwrap_or(f64::INFINITY);
    force_below(problem, |force, a| problem.mean_pressure(force, a) < mean)
}

/// The largest force of which something is expected to hold that holds for small ones; `holds`
/// takes the force and the half-width that is expected under it.
fn force_below(problem: &Problem, holds: impl Fn(f64, f64) -> bool) -> Result<f64, MeshedError> {
    let (mut low, mut high) = (1e-9, 1e9);
    let expected = |force: f64| ContactSizeEstimate::expected(problem, ContactLoad::Force(force));
    if let Err(error @ (MeshedError::Conforming { .. } | MeshedError::TouchesAtEnd { .. })) =
        expected(low)
    {
        return Err(error);
    }
    for _ in 0..80 {
        let middle = f64::sqrt(low * high);
        match expected(middle) {
            Ok(extent) if holds(middle, extent.half_width) => low = middle,
            _ => high = middle,
        }
    }
    Ok(low)
}
