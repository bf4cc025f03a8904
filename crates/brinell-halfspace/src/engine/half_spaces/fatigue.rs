//! Fatigue under a contact that is pressed, as if it passed over the bodies.

use brinell_material::fatigue::{Stress, hydrostatic};

use crate::{Elasticity, Fatigue, HalfSpace, Passing, Stop, Stopped, TensorField};

use super::law::initial_stress_over_depth;
use super::problem::HalfSpaceProblem;
use super::step::{HalfSpaceBody, HalfSpaceField};

impl HalfSpaceField {
    /// The fatigue of a body (0 for the upper one) under one elastic pass of this contact along x of
    /// the fields; `None` of a body that is rigid or without limits, of surfaces with heights, and
    /// without contact.
    ///
    /// The stress that stands still is that of the section across the travel through the middle of
    /// the contact: its initial stress and the residual stress of its plastic strain, as if the whole
    /// track had yielded like it.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn fatigue(
        &self,
        problem: &HalfSpaceProblem,
        side: usize,
        stop: &mut Stop<'_>,
    ) -> Result<Option<Fatigue>, Stopped> {
        let (Some(material), Some(body)) = (&problem.materials[side], &self.bodies[side]) else {
            return Ok(None);
        };
        let surface = &*self.surface;
        let poisson = material.elastic().poisson_ratio;
        let passing = Passing::area(&surface.pressure, &surface.grid, poisson);
        let asked = material.fatigue().filter(|_| problem.heights.is_none()).zip(passing);
        let Some((strength, passing)) = asked else { return Ok(None) };
        let initial = initial_stress_over_depth(material, problem.orientation());
        let elastic = Elasticity::new(material.elastic().young_modulus, poisson).ok();
        let section = body.residual_section(elastic, stop)?;
        let at_rest = |depth: f64, y: f64| {
            let [xx, yy, xy] = initial(depth);
            hydrostatic(&[xx, yy, 0.0, xy, 0.0, 0.0]) + body.at(&section, depth, y)
        };
        let depths = body.layers.faces_and_middles();
        let found = Fatigue::of(&passing, 0.0, strength, depths, at_rest, stop)?;
        let elastic = self.hertz.and_then(|hertz| {
            let axes = [hertz.semi_axis_x, hertz.semi_axis_y];
            let cells = [problem.cells_per_semi_axis as usize; 2];
            Some(Passing::hertz_ellipse(axes, cells, poisson)?.times(hertz.peak_pressure))
        });
        found.beside(elastic.as_ref(), 0.0, strength, stop).map(Some)
    }
}

impl HalfSpaceBody {
    /// The hydrostatic part of the residual stress beside x = 0, layer by layer in order of y
    /// \[MPa\]; empty of a body that has not yielded.
    fn residual_section(
        &self,
        elastic: Option<Elasticity>,
        stop: &mut Stop<'_>,
    ) -> Result<Vec<f64>, Stopped> {
        let yielded = self.plastic_strain.as_ref().filter(|_| self.largest_strain.is_some());
        let Some((strain, elastic)) = yielded.zip(elastic) else { return Ok(Vec::new()) };
        let (n_cells, ny) = (self.grid.n_cells(), self.grid.ny());
        let space = HalfSpace::new(self.grid, self.layers.clone(), elastic, false, stop)?;
        let (mut work, mut opening) = (space.work(), vec![0.0; n_cells]);
        let mut stress = TensorField::tensors(self.layers.len(), n_cells);
        space.opening(strain, &mut work, &mut opening, stop)?;
        space.stress(&vec![0.0; n_cells], &mut work, &mut stress, stop)?;
        let row = self.grid.nx() / 2 * ny;
        let at = |layer: usize, j: usize| -> Stress {
            std::array::from_fn(|k| stress.component(layer, k)[row + j])
        };
        let places = (0..self.layers.len()).flat_map(|layer| (0..ny).map(move |j| (layer, j)));
        Ok(places.map(|(layer, j)| hydrostatic(&at(layer, j))).collect())
    }

    /// The value of a section in the layer at a depth and the row nearest to y; 0 of an empty one.
    fn at(&self, section: &[f64], depth: f64, y: f64) -> f64 {
        let (layer, ny) = (self.layers.at(depth), self.grid.ny());
        let from = |j: &usize| (self.grid.y(*j) - y).abs();
        let nearest = (0..ny).min_by(|a, b| from(a).total_cmp(&from(b))).unwrap_or(0);
        section.get(layer * ny + nearest).copied().unwrap_or(0.0)
    }
}
