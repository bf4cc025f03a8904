//! A roller that is free to tilt, under a moment.
//!
//! Beside `Σ R = P` the contact then has
//! ```text
//! Σ R y = M,      g(ϑ) = g - ϑ y
//! ```
//! with the tilt ϑ as one more unknown. `E(ϑ) = min ½ RᵀF R + g(ϑ)ᵀR` over `R >= 0, Σ R = P` is the
//! least of functions linear in ϑ, hence concave, and `Σ R y = -dE/dϑ` never falls with ϑ: a root
//! between two tilts stays there. Secants that at most double the last step come to two such tilts;
//! between them secants find it, and halves where a secant leads nowhere.

use super::moment::PrescribedMoment;
use super::problem::BISECTIONS;
use super::system::HalfSpaces;
use crate::engine::CONTACT_TOLERANCE;
use brinell_contact::{ContactLoad, ContactSolution, ContactSolver, ContactStatus};
use brinell_method::contact_system::ContactSystem as _;
use brinell_method::run::Run;

impl HalfSpaces {
    /// `Σ R e y` of forces, with the closing e of their normals \[N mm\].
    pub fn moment_of(&self, force: &[f64]) -> f64 {
        let (grid, ny) = (self.grid(), self.grid().ny());
        let along = force.iter().zip(&self.closing).map(|(force, closing)| force * closing);
        along.enumerate().map(|(cell, force)| force * grid.y(cell % ny)).sum()
    }

    /// A gap with a tilt of the roller \[mm\].
    pub fn tilted(&self, gap: &[f64], tilt: f64) -> Vec<f64> {
        let (grid, ny) = (self.grid(), self.grid().ny());
        let gaps = gap.iter().zip(&self.closing).enumerate();
        gaps.map(|(cell, (gap, closing))| gap - tilt * closing * grid.y(cell % ny)).collect()
    }

    /// The contact under a force and the moment that goes with it, with its tilt; where the
    /// moment is not met, the contact that comes nearest to it. A moment beyond that of the last
    /// row of cells is that of the last row: the grid is enlarged then, or the check tells.
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
    ) -> Result<ContactSolution, brinell_method::Error> {
        let last_row = self.last_row(moment);
        let mut tilt = start.map_or_else(|| self.last_tilt.get(), |start| start.tilt);
        let mut last = start.cloned();
        let mut nearest: Option<(f64, ContactSolution)> = None;
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
            if found.status != ContactStatus::Converged || found.total_force <= 0.0 {
                return Ok(ContactSolution { pivots, applications, ..found });
            }
            let most = found.total_force * last_row;
            let wanted = moment.under(found.total_force).clamp(-most, most);
            let lever = found.total_force * moment.half_length;
            let missing = (self.moment_of(&found.force) - wanted) / lever;
            if nearest.as_ref().is_none_or(|(least, _)| missing.abs() < *least) {
                nearest = Some((missing.abs(), found.clone()));
            }
            if missing.abs() <= CONTACT_TOLERANCE {
                break;
            }
            if missing < 0.0 {
                below = below.max(tilt);
            } else {
                above = above.min(tilt);
            }
            let halves = 0.5 * (below + above);
            let next = match before {
                Some([other, of_other]) => {
                    let step = -missing * (tilt - other) / (missing - of_other);
                    if !halves.is_finite() {
                        // Where another tilt moves little, one twice as far away moves more.
                        let farthest = 2.0 * (tilt - other).abs();
                        let toward = -missing.signum();
                        let step = step * toward;
                        let step = if step > 0.0 { step.min(farthest) } else { farthest };
                        tilt + toward * step
                    } else if missing.abs() > 0.5 * of_other.abs() {
                        halves
                    } else {
                        tilt + step
                    }
                }
                None => tilt + self.first_step(moment, &tilted, &found, missing),
            };
            before = Some([tilt, missing]);
            last = Some(found);
            tilt =
                if halves.is_finite() && !(next > below && next < above) { halves } else { next };
            if tilt <= below || tilt >= above {
                break;
            }
        }
        let nearest = nearest.map(|(_, contact)| contact).unwrap_or_default();
        self.last_tilt.set(nearest.tilt);
        Ok(ContactSolution { pivots, applications, ..nearest })
    }

    /// Distance of the outermost cells of the roller from its middle \[mm\].
    fn last_row(&self, moment: PrescribedMoment) -> f64 {
        let grid = self.grid();
        let rows = (0..grid.ny()).map(|j| grid.y(j).abs());
        rows.filter(|y| *y < moment.half_length).fold(0.0, f64::max)
    }

    /// The tilt by which a missing moment comes about, if the depth δ to which undeformed bodies
    /// would overlap is that of an even layer of springs of a length 2r along the contact:
    /// `M = P r² ϑ/(3 δ)`, and at most that of a moment P r.
    fn first_step(
        &self,
        moment: PrescribedMoment,
        gap: &[f64],
        contact: &ContactSolution,
        missing: f64,
    ) -> f64 {
        let (grid, ny) = (self.grid(), self.grid().ny());
        let touched = (0..gap.len()).filter(|cell| contact.force[*cell] > 0.0);
        let reach = touched.map(|cell| grid.y(cell % ny)).map(f64::abs).fold(grid.hy(), f64::max);
        let overlap = gap.iter().map(|gap| contact.approach - gap).fold(0.0, f64::max);
        -3.0 * overlap / reach * (missing * moment.half_length / reach).clamp(-1.0, 1.0)
    }
}
