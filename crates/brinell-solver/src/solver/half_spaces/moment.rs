//! A roller that is free to tilt, under a moment.
//!
//! Beside `Σ R = P` the contact then has
//! ```text
//! Σ R y = M,      g(ϑ) = g - ϑ y
//! ```
//! with the tilt ϑ as one more unknown. `E(ϑ) = min ½ RᵀF R + g(ϑ)ᵀR` over `R >= 0, Σ R = P` is the
//! least of functions linear in ϑ, hence concave, and `Σ R y = -dE/dϑ` never falls with ϑ: a root
//! between two tilts stays there. Secants find it, and halves where a secant leads nowhere.

use super::engine::CONTACT_TOLERANCE;
use super::problem::{BISECTIONS, HalfSpaceProblem};
use super::system::HalfSpaces;
use crate::contact::{ContactLoad, ContactSolution, ContactSolver, ContactStatus};
use crate::solver::method;
use crate::solver::method::contact_system::ContactSystem as _;
use crate::solver::method::run::Run;

/// The moment of a job along y of the fields.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PrescribedMoment {
    /// About the middle, positive where the half at positive y bears more \[N mm\].
    moment: f64,
    /// The force from which on it is whole; in proportion to the force below \[N\].
    whole_from: f64,
    /// Half the length of the roller \[mm\].
    half_length: f64,
}

impl PrescribedMoment {
    /// Under a force \[N mm\].
    pub fn under(self, force: f64) -> f64 {
        self.moment * (force / self.whole_from).min(1.0)
    }

    /// What is missing of it, over force and half the length.
    pub fn missing(self, moment: f64, force: f64) -> f64 {
        if force <= 0.0 {
            return 0.0;
        }
        (moment - self.under(force)) / (force * self.half_length)
    }
}

impl HalfSpaceProblem {
    /// The moment under which a roller tilts; `None` where tilts are given.
    pub(super) fn moment(&self) -> Option<PrescribedMoment> {
        let orientation = self.orientation();
        let along = self.rollers.iter().find_map(|roller| {
            Some(roller.moment? * (roller.rotation - orientation).cos().signum())
        });
        Some(PrescribedMoment {
            moment: along?,
            whole_from: self.load.least_force()?,
            half_length: self.half_length()?,
        })
    }
}

impl HalfSpaces {
    /// `Σ R y` of forces \[N mm\].
    pub fn moment_of(&self, force: &[f64]) -> f64 {
        let (grid, ny) = (self.grid(), self.grid().ny());
        force.iter().enumerate().map(|(cell, force)| force * grid.y(cell % ny)).sum()
    }

    /// A gap with a tilt of the roller \[mm\].
    pub fn tilted(&self, gap: &[f64], tilt: f64) -> Vec<f64> {
        let (grid, ny) = (self.grid(), self.grid().ny());
        gap.iter().enumerate().map(|(cell, gap)| gap - tilt * grid.y(cell % ny)).collect()
    }

    /// The contact under a force and the moment that goes with it, with its tilt. An answer whose
    /// moment is not found has not converged.
    ///
    /// # Errors
    /// Those of the contact solver.
    pub fn balanced(
        &self,
        moment: PrescribedMoment,
        gap: &[f64],
        solver: &dyn ContactSolver,
        load: ContactLoad,
        start: Option<&ContactSolution>,
        run: &mut Run<'_>,
    ) -> Result<ContactSolution, method::Error> {
        let mut tilt = start.map_or(0.0, |start| start.tilt);
        let mut last = start.cloned();
        let (mut below, mut above) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut before: Option<[f64; 2]> = None;
        let [mut pivots, mut applications] = [0, 0];
        for _ in 0..BISECTIONS {
            let tilted = self.tilted(gap, tilt);
            let problem = self.contact_problem(&tilted, load);
            let mut found = run.solve_contact(solver, &problem, last.as_ref())?;
            pivots += found.pivots;
            applications += found.applications;
            found.tilt = tilt;
            let missing = moment.missing(self.moment_of(&found.force), found.total_force);
            if missing.abs() <= CONTACT_TOLERANCE || found.status != ContactStatus::Converged {
                return Ok(ContactSolution { pivots, applications, ..found });
            }
            if missing < 0.0 {
                below = below.max(tilt);
            } else {
                above = above.min(tilt);
            }
            let (slope, stays) = match before {
                Some([other, of_other]) => {
                    ((missing - of_other) / (tilt - other), missing.abs() > 0.5 * of_other.abs())
                }
                None => (self.stiffness(moment, &tilted, &found), false),
            };
            before = Some([tilt, missing]);
            let step = -missing / slope;
            let halves = 0.5 * (below + above);
            tilt = match tilt + step {
                next if next > below && next < above && !(stays && halves.is_finite()) => next,
                _ if halves.is_finite() => halves,
                // Where another tilt moves nothing, a larger one may.
                _ => tilt - 2.0 * missing.signum() * step.abs().max(tilt.abs()),
            };
            last = Some(found);
        }
        let status = ContactStatus::IterationLimit;
        Ok(ContactSolution { pivots, applications, status, ..last.unwrap_or_default() })
    }

    /// What a tilt changes of the moment, over force and half the length, if the depth δ to which
    /// undeformed bodies would overlap is that of an even layer of springs along the contact:
    /// `P b²/(3 δ)`.
    fn stiffness(&self, moment: PrescribedMoment, gap: &[f64], contact: &ContactSolution) -> f64 {
        let (grid, ny) = (self.grid(), self.grid().ny());
        let touched = (0..gap.len()).filter(|cell| contact.force[*cell] > 0.0);
        let reach = touched.map(|cell| grid.y(cell % ny)).map(f64::abs).fold(grid.hy(), f64::max);
        let overlap = gap.iter().map(|gap| contact.approach - gap).fold(0.0, f64::max);
        reach * reach / (3.0 * overlap * moment.half_length)
    }
}
