//! The fields of one body under a load.

use std::sync::Arc;

use crate::assembly::{GaussPoint, MaterialModel, PointStresses, StressField};
use crate::engine::body_system::body::BodyModel;
use crate::mesh::{Mesh, Quality, SurfaceFrame};
use brinell_material::{HardeningLaw, von_mises};

/// Half-widths of the meshed contact zone within which a surface is near the contact.
const SURFACE: f64 = 2.5;

/// Distance from an end of the contact and from the surface, over the half-width, within which
/// strain has no limit on finer meshes.
const AT_END: f64 = 0.1;

/// Equivalent plastic strain that rounding leaves.
const ROUNDING: f64 = 1e-13;

/// Whether a point has yielded by more than rounding leaves at the verge of yield.
pub fn has_yielded(point: &GaussPoint) -> bool {
    point.yielded && point.equivalent_plastic_strain > ROUNDING
}

/// Returns the largest plastic strain, or `None` if the hardening curve no longer rises there.
pub fn bounded_strain(strain: f64, law: Option<&dyn HardeningLaw>) -> Option<f64> {
    (strain == 0.0 || law.is_none_or(|law| law.slope(strain) > 0.0)).then_some(strain)
}

/// Fields of one body, in its own frame (contact at the origin, y outward).
#[derive(Debug, Clone)]
pub struct BodySolution {
    /// Mesh.
    pub mesh: Arc<Mesh>,
    /// Mesh quality.
    pub quality: Quality,
    /// Displacements of the nodes \[mm\]; none in a step that was stopped.
    pub displacement: Vec<[f64; 2]>,
    /// Stresses; none in a step that was stopped.
    pub stress: StressField,
    /// Equations solved.
    pub equations: usize,
    /// Constitutive model of the material.
    pub model: Arc<dyn MaterialModel>,
    /// Stress at the points of each element before the load, after the body has relaxed; none
    /// without initial stress.
    pub initial_stress: Option<Arc<PointStresses>>,
    /// Middle of the contact and its largest half-width so far \[mm\].
    pub contact: [f64; 2],
}

impl BodySolution {
    pub(super) fn of(
        body: &BodyModel,
        displacement: Vec<[f64; 2]>,
        stress: StressField,
        contact: [f64; 2],
    ) -> Self {
        let elastic = &body.elastic;
        Self {
            contact,
            mesh: Arc::clone(&elastic.mesh),
            quality: elastic.quality(),
            displacement,
            stress,
            equations: elastic.equations.len(),
            model: Arc::clone(&body.model),
            initial_stress: body
                .initial_stress
                .as_ref()
                .map(|initial| Arc::clone(&initial.stress)),
        }
    }

    /// Returns this body before the load; `None` without initial stress.
    pub fn at_rest(&self) -> Option<Self> {
        let initial = self.initial_stress.as_ref()?;
        let mut at_rest = self.clone();
        for (points, stresses) in at_rest.stress.points.iter_mut().zip(initial.iter()) {
            for (point, stress) in points.iter_mut().zip(stresses) {
                *point = GaussPoint {
                    position: point.position,
                    weight: point.weight,
                    area: point.area,
                    stress: *stress,
                    largest_von_mises: von_mises(*stress),
                    ..GaussPoint::default()
                };
            }
        }
        Some(at_rest)
    }

    /// Whether a point has yielded.
    pub fn has_yielded(&self) -> bool {
        self.stress.points.iter().flatten().any(has_yielded)
    }

    /// Largest equivalent plastic strain at a Gauss point.
    pub fn max_plastic_strain(&self) -> f64 {
        let strains =
            self.stress.points.iter().flatten().map(|point| point.equivalent_plastic_strain);
        strains.fold(0.0, f64::max)
    }

    /// Returns the Gauss point of the largest equivalent plastic strain but for those at the ends of
    /// the contact, within a tenth of the half-width of an end or beyond it, and of the surface. The
    /// strain there grows with the density of the mesh, whether the material hardens or not.
    pub fn most_strained(&self) -> Option<&GaussPoint> {
        let [middle, half_width] = self.contact;
        let is_inside = |point: &&GaussPoint| {
            let [x, depth] = self.mesh.frame.place(point.position);
            (x - middle).abs() <= (1.0 - AT_END) * half_width || depth >= AT_END * half_width
        };
        let points = self.stress.points.iter().flatten().filter(is_inside);
        points.max_by(|a, b| a.equivalent_plastic_strain.total_cmp(&b.equivalent_plastic_strain))
    }

    /// Largest equivalent plastic strain at a Gauss point but at the ends of the contact.
    pub fn strain_inside(&self) -> f64 {
        self.most_strained().map_or(0.0, |point| point.equivalent_plastic_strain)
    }

    /// Returns that strain, or `None` if the body has yielded at the ends alone or no longer hardens
    /// there. Plastic flow then gathers in bands of the width of one element, and the strain grows
    /// with the density of the mesh.
    pub fn bounded_plastic_strain(&self) -> Option<f64> {
        let inside = self.strain_inside();
        let is_at_ends = inside == 0.0 && self.has_yielded();
        bounded_strain(inside, self.model.hardening()).filter(|_| !is_at_ends)
    }

    /// Largest strain at a Gauss point to which small-strain theory is held: the equivalent
    /// plastic one or, where that adds up over a history of loads, the equivalent strain if it is
    /// less.
    pub fn max_strain(&self) -> f64 {
        let accumulates = self.model.has_memory();
        self.stress
            .points
            .iter()
            .flatten()
            .map(|point| point.strain(accumulates))
            .fold(0.0, f64::max)
    }

    /// The surface near the contact: x and how far the node has moved outward, in order of x
    /// \[mm\].
    pub fn surface(&self) -> Vec<[f64; 2]> {
        let zone = &self.mesh.zone;
        let limit = SURFACE * zone.half_width();
        let node = |&node: &u32| {
            let (position, u) = (self.mesh.nodes[node as usize], self.displacement[node as usize]);
            let ([x, _], [n_x, n_y]) =
                (self.mesh.frame.place(position), self.mesh.frame.normal(position));
            [x, n_x * u[0] + n_y * u[1]]
        };
        let nodes = self.mesh.free_surface_nodes.iter();
        let mut surface: Vec<_> =
            nodes.map(node).filter(|[x, _]| (x - zone.centre()).abs() <= limit).collect();
        surface.sort_by(|a, b| a[0].total_cmp(&b[0]));
        surface
    }

    /// Depth of the deepest point of that surface below the undeformed one \[mm\].
    pub fn dent_depth(&self) -> f64 {
        -self.surface().iter().map(|[_, height]| *height).fold(0.0, f64::min)
    }

    /// Height of the highest point of that surface above the undeformed one \[mm\].
    pub fn pile_up(&self) -> f64 {
        self.surface().iter().map(|[_, height]| *height).fold(0.0, f64::max)
    }

    /// Mean equivalent plastic strain over the area that has yielded.
    pub fn mean_plastic_strain(&self) -> f64 {
        let points = self.stress.points.iter().flatten();
        let yielded = points.filter(|point| has_yielded(point));
        let sums = yielded.fold([0.0; 2], |[area, sum], point| {
            [area + point.area, sum + point.area * point.equivalent_plastic_strain]
        });
        if sums[0] > 0.0 { sums[1] / sums[0] } else { 0.0 }
    }

    /// Area of the section that has yielded, both sides of the axis \[mm²\].
    pub fn plastic_area(&self, symmetric: bool) -> f64 {
        let points = self.stress.points.iter().flatten();
        let area: f64 = points.filter(|point| has_yielded(point)).map(|point| point.area).sum();
        if symmetric { 2.0 * area } else { area }
    }

    /// Nodes of the grid line below the candidate node nearest to `x`.
    pub fn normal_line(&self, x: f64) -> Vec<u32> {
        let mesh = &self.mesh;
        let offset = |node: &u32| (mesh.frame.place(mesh.nodes[*node as usize])[0] - x).abs();
        let top = mesh.contact_nodes.iter().min_by(|a, b| offset(a).total_cmp(&offset(b)));
        top.map_or_else(Vec::new, |&top| mesh.grid_line_below(top))
    }

    /// Width of the body \[mm\].
    pub fn width(&self, symmetric: bool) -> f64 {
        let x = || self.mesh.nodes.iter().map(|node| node[0]);
        let (left, right) =
            (x().fold(f64::INFINITY, f64::min), x().fold(f64::NEG_INFINITY, f64::max));
        if symmetric { 2.0 * right } else { right - left }
    }

    /// Depth of the far boundary below the contact \[mm\]; infinite of a pin, which is held at its
    /// centre.
    pub fn depth(&self) -> f64 {
        if let SurfaceFrame::Circle { radius } = self.mesh.frame {
            let depths = self.mesh.nodes.iter().map(|&node| self.mesh.frame.place(node)[1]);
            return if radius > 0.0 { f64::INFINITY } else { depths.fold(0.0, f64::max) };
        }
        -self.mesh.nodes.iter().map(|node| node[1]).fold(0.0, f64::min)
    }
}
