//! The figures of one body.

use crate::element::StressState;
use crate::engine::body_solution::{BodySolution, has_yielded};
use crate::engine::surface_recovery::recovered_under;
use brinell_material::analytical::Stress;
use brinell_method::figures::BodyFigures;

impl BodySolution {
    /// All figures; `None` where the iteration was stopped. Stresses are those below the node of the surface nearest to
    /// the middle of the contact, under a pressure at each candidate node \[MPa\].
    pub fn figures(
        &self,
        state: StressState,
        symmetric: bool,
        middle: f64,
        pressure: &[f64],
    ) -> Option<BodyFigures> {
        if self.displacement.is_empty() {
            return None;
        }
        let mut recovery = recovered_under(state, symmetric, self, pressure);
        let below = self.normal_line(middle).into_iter().map(|node| {
            let position = self.mesh.nodes[node as usize];
            let [sigma_x, sigma_y, sigma_z, tau_xy, ..] = recovery.node(node);
            let stress = Stress { sigma_x, sigma_y, sigma_z, tau_xy }
                .along(self.mesh.frame.normal(position));
            [stress.sigma_x, stress.von_mises() / self.model.strength(position)]
        });
        let [least_stress, largest_von_mises] =
            below.fold([0.0; 2], |[least, most], [along, von_mises]| {
                [f64::min(least, along), f64::max(most, von_mises)]
            });
        Some(BodyFigures {
            max_plastic_strain: self.strain_inside(),
            mean_plastic_strain: Some(self.mean_plastic_strain()),
            plastic_area: Some(self.plastic_area(symmetric)),
            plastic_depth: self
                .stress
                .points
                .iter()
                .flatten()
                .filter(|point| has_yielded(point))
                .map(|point| self.mesh.frame.place(point.position)[1])
                .filter(|depth| *depth > 0.0)
                .reduce(f64::max),
            dent: self.dent_depth(),
            pile_up: self.pile_up(),
            least_stress: Some(least_stress),
            largest_von_mises: Some(largest_von_mises),
        })
    }
}
