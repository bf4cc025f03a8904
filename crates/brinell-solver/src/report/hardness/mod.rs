//! The answer of a hardness test.
//!
//! The edge of a contact lies between two nodes, so that half-width and approach under a force
//! scatter. A parabola over the root of the force, fitted by least squares to the increments from
//! 15 % of the force on, has the figure under the force. The figures of the mesh and of one of half
//! the density are extrapolated: the radius by first order, the approach by second. A quarter of
//! their difference and one and a half standard errors bound the error.
//!
//! Beside the mean pressure p stands that of published results with large strains. Balls: D.
//! Tabor, *The Hardness of Metals* (1951), `p = 2.8 σ(0.2 a/R)` with full plasticity. Cones of
//! 70.3°: M. Dao et al., Acta Mater. 49 (2001) 3899, `p/E* = 0.268536 (0.9952495 − h_r/h_m)^1.1142735`
//! from the depths under load and after it, and their loading curvature F/h² from the stress at a
//! plastic strain of 3.3 %.

mod answer;
mod found;
mod remarks;
mod seen;

pub(super) use self::seen::Seen;
use crate::job::Job;
use crate::solver::{SolveStatus, StepSolution};

/// Tabor's strains of a ball over a/R and of a pyramid.
const BALL_STRAIN: f64 = 0.2;
const PYRAMID_STRAIN: f64 = 0.08;
/// Strain of Dao's curvature.
const DAO_STRAIN: f64 = 0.033;

/// The loads of a test, as they are solved.
#[derive(Debug, Clone, Default)]
pub(super) struct HardnessSeen(Vec<Seen>);

impl HardnessSeen {
    /// Records a load.
    pub fn see(&mut self, load: Option<Seen>) {
        self.0.extend(load);
    }
}

/// Returns what is seen of a load of a hardness test; `None` of another job.
pub(super) fn indentation(job: &Job, step: &StepSolution) -> Option<Seen> {
    job.load.hardness()?;
    // The last iteration of a step that was stopped has no displacements.
    let specimen = step.field.bodies[1].as_ref().filter(|_| !step.status.is_stopped())?;
    let surface = specimen.surface();
    let highest = surface.iter().copied().fold([0.0; 2], |a, b| if b[1] > a[1] { b } else { a });
    let increments = [&step.path.increments, &step.path.coarse_increments];
    Some(Seen {
        force: step.figures.force,
        approach: step.figures.approach,
        half_width: step.figures.half_width,
        stiffness: step.field.unloading_stiffness,
        dent: specimen.dent_depth(),
        has_yielded: specimen.has_yielded(),
        highest,
        surface,
        increments: increments
            .map(|all| all.iter().map(|end| [end.force, end.half_width, end.approach]).collect()),
        is_converged: step.status == SolveStatus::Converged,
    })
}

/// Dao's loading curvature of an E* and the stress at his strain, within the moduli over stress of
/// his materials \[MPa\].
fn dao_curvature(modulus: f64, stress: f64) -> Option<f64> {
    let x = (modulus / stress).ln();
    let ratio = ((-1.131 * x + 13.635) * x - 30.594) * x + 29.267;
    (3.0..6.3).contains(&x).then_some(ratio * stress)
}
