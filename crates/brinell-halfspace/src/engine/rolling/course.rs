//! Cells under a load that rolls: columns of a line, or cells of a track of finite width.

use std::sync::Arc;

use crate::raceway::{RacewayBody, RacewayGrid, RacewaySpace, RowLaw};
use crate::track::{
    LineFlexibility, RollingBody, Rolls, TrackFault, TrackGrid, TrackLimits, TrackSpace,
    rolling_force,
};
use crate::{Elasticity, Layers, SurfaceFlexibility};
use brinell_contact::Flexibility;
use brinell_material::{Deviators, StreamLaw, TrackFrame};

use super::design::TrackDesign;
use super::error::TrackError;
use super::memory::{bytes_of_ellipse, bytes_of_line};
use super::problem::{Limit, RollingProblem, initial_stress, law_of_rows};
use crate::engine::watch::watched;
use brinell_contact::{ConjugateGradientSolver, ContactSolution, ContactSolver};
use brinell_material::Solid;
use brinell_method::phases::Phase;
use brinell_method::run::Run;

/// The cells of a track. Surface fields are those of the window in which the bodies may touch.
pub(super) trait Course: Copy {
    /// A body that can yield.
    type Body: Rolls;
    /// The surfaces of both bodies.
    type Surface: Flexibility;

    /// Cells and layers of a design.
    fn lay(design: &TrackDesign) -> Result<(Self, Layers), TrackError>;

    /// The flexibility of both surfaces with the modulus E\* \[MPa\].
    fn surface(&self, modulus: f64) -> Result<Self::Surface, TrackError>;

    /// A body of a material; `count` is how many bodies it stands for.
    fn body(
        &self,
        layers: &Layers,
        material: &Solid,
        count_and_friction: (u8, f64),
        run: &mut Run<'_>,
    ) -> Result<Self::Body, TrackError>;

    /// The gap between the undeformed bodies \[mm\].
    fn gap(&self, problem: &RollingProblem) -> Vec<f64>;

    /// A surface field with x reversed.
    fn reversed(&self, field: &[f64]) -> Vec<f64>;

    /// Returns the divisor that turns a contact force of a cell into a pressure: width of a column
    /// \[mm\], or area of a cell \[mm²\].
    fn area(&self) -> f64;

    /// Why pressures are cut off, if they are.
    fn holds(&self, pressure: &[f64]) -> Result<(), TrackFault>;

    /// The force against which the load is pushed \[N/mm\], \[N\].
    fn rolling_force(&self, gap: &[f64], pressure: &[f64]) -> f64;

    /// Columns of the ring.
    fn n_columns(&self) -> usize;

    /// Rows of cells in a layer of a body.
    fn n_rows(&self) -> usize;

    /// Middle of the columns of the window \[mm\].
    fn x(&self) -> Vec<f64>;

    /// Width of a column \[mm\].
    fn column(&self) -> f64;

    /// A surface field on the axis of the track.
    fn along(&self, field: &[f64]) -> Vec<f64>;

    /// A surface field across the track in the middle of the load, and y of its values \[mm\];
    /// nothing of a line.
    fn across(&self, field: &[f64]) -> (Vec<f64>, Vec<f64>);

    /// The approach of a contact; a line has none.
    fn approach(contact: &ContactSolution) -> Option<f64>;

    /// The contact solver of a problem.
    fn solver<'s>(
        problem: &RollingProblem,
        iterative: &'s ConjugateGradientSolver,
    ) -> &'s dyn ContactSolver;

    /// Bytes that a solve holds.
    fn bytes(&self, problem: &RollingProblem, layers: usize) -> usize;

    /// The limit of shakedown of bodies that harden kinematically without bound, if it is known.
    fn kinematic(
        &self,
        problem: &RollingProblem,
        bodies: &[Self::Body],
        run: &mut Run<'_>,
    ) -> Result<Option<Limit>, TrackError>;
}

fn elasticity(material: &Solid) -> Result<Elasticity, TrackError> {
    let elastic = material.elastic();
    Ok(Elasticity::new(elastic.young_modulus, elastic.poisson_ratio)?)
}

/// The law of the rows of a body, each as strong as its layer.
fn law<const D: usize, const R: usize>(
    material: &Solid,
    layers: &Layers,
    rows: usize,
) -> Result<Box<dyn StreamLaw<D, R>>, TrackError>
where
    TrackFrame: Deviators<D, R>,
{
    let depths: Vec<f64> = (0..layers.len()).map(|layer| layers.middle(layer)).collect();
    law_of_rows(material, &depths, rows).ok_or(TrackError::NoTrack)
}

impl Course for TrackGrid {
    type Body = RollingBody;
    type Surface = LineFlexibility;

    fn lay(design: &TrackDesign) -> Result<(Self, Layers), TrackError> {
        let (factor, columns) = design.extent();
        let half_width = factor * design.semi_axes[0];
        let grid = Self::of_contact(half_width, columns, design.length)?;
        Ok((grid, grid.layers(half_width, design.friction)?))
    }

    fn surface(&self, modulus: f64) -> Result<LineFlexibility, TrackError> {
        Ok(LineFlexibility::new(self, modulus))
    }

    fn body(
        &self,
        layers: &Layers,
        material: &Solid,
        (count, friction): (u8, f64),
        run: &mut Run<'_>,
    ) -> Result<RollingBody, TrackError> {
        let (elastic, law) = (elasticity(material)?, law::<4, 3>(material, layers, 1)?);
        let space = watched(run, Phase::Flexibility, |stop| {
            TrackSpace::new(*self, layers.clone(), elastic, stop)
        })?;
        let initial = initial_stress(material, layers);
        Ok(RollingBody::new(Arc::new(space), law, count, friction, initial))
    }

    fn gap(&self, problem: &RollingProblem) -> Vec<f64> {
        self.sample(|x| problem.gap(x, 0.0))
    }

    fn reversed(&self, field: &[f64]) -> Vec<f64> {
        field.iter().rev().copied().collect()
    }

    fn area(&self) -> f64 {
        self.h()
    }

    fn holds(&self, pressure: &[f64]) -> Result<(), TrackFault> {
        Self::holds(self, pressure)
    }

    fn rolling_force(&self, gap: &[f64], pressure: &[f64]) -> f64 {
        rolling_force(self, gap, pressure)
    }

    fn n_columns(&self) -> usize {
        Self::n_columns(self)
    }

    fn n_rows(&self) -> usize {
        1
    }

    fn x(&self) -> Vec<f64> {
        self.window().map(|i| Self::x(self, i)).collect()
    }

    fn column(&self) -> f64 {
        self.h()
    }

    fn along(&self, field: &[f64]) -> Vec<f64> {
        field.to_vec()
    }

    fn across(&self, _: &[f64]) -> (Vec<f64>, Vec<f64>) {
        (Vec::new(), Vec::new())
    }

    /// Returns `None`: the approach of half-planes depends on the place from which it is counted.
    fn approach(_: &ContactSolution) -> Option<f64> {
        None
    }

    fn solver<'s>(
        problem: &RollingProblem,
        _: &'s ConjugateGradientSolver,
    ) -> &'s dyn ContactSolver {
        problem.solver.contact
    }

    fn bytes(&self, problem: &RollingProblem, layers: usize) -> usize {
        bytes_of_line(problem, self, layers)
    }

    fn kinematic(
        &self,
        problem: &RollingProblem,
        bodies: &[RollingBody],
        run: &mut Run<'_>,
    ) -> Result<Option<Limit>, TrackError> {
        let [a, _] = problem.semi_axes();
        let pressure = self.sample(|x| (1.0 - (x / a).powi(2)).max(0.0).sqrt());
        let mut least: Option<Limit> = None;
        let has_yield_point = |material: &Solid| material.yield_stress().is_some();
        let limited = problem.yielding().zip(bodies);
        for ((side, _), body) in limited.filter(|((_, material), _)| has_yield_point(material)) {
            let limits = watched(run, Phase::Flexibility, |stop| {
                let strength = |layer: usize| body.law().yield_stress(layer);
                TrackLimits::new(body.space(), &pressure, body.friction(), strength, stop)
            })?;
            let kinematic = limits.kinematic;
            let of_body = Limit { peak_pressure: kinematic.value, depth: kinematic.depth, side };
            if least.is_none_or(|least| of_body.peak_pressure < least.peak_pressure) {
                least = Some(of_body);
            }
        }
        Ok(least.filter(|limit| limit.peak_pressure.is_finite()))
    }
}

impl Course for RacewayGrid {
    type Body = RacewayBody;
    type Surface = SurfaceFlexibility;

    /// A larger track is wider and deeper, and not longer.
    fn lay(design: &TrackDesign) -> Result<(Self, Layers), TrackError> {
        let (factor, cells) = design.extent();
        let semi_axes = design.semi_axes.map(|axis| factor * axis);
        let grid = Self::of_contact(semi_axes, cells, design.length / factor)?;
        Ok((grid, grid.layers(semi_axes, design.friction)?))
    }

    fn surface(&self, modulus: f64) -> Result<SurfaceFlexibility, TrackError> {
        Ok(SurfaceFlexibility::new(Self::surface(self)?, modulus))
    }

    fn body(
        &self,
        layers: &Layers,
        material: &Solid,
        (count, friction): (u8, f64),
        run: &mut Run<'_>,
    ) -> Result<RacewayBody, TrackError> {
        let elastic = elasticity(material)?;
        let law: Box<RowLaw> = law(material, layers, Self::n_rows(self))?;
        let space = watched(run, Phase::Flexibility, |stop| {
            RacewaySpace::new(*self, layers.clone(), elastic, friction != 0.0, stop)
        })?;
        let initial = initial_stress(material, layers);
        Ok(RacewayBody::new(Arc::new(space), law, count, friction, initial))
    }

    fn gap(&self, problem: &RollingProblem) -> Vec<f64> {
        let y = |j: usize| (j as f64 + 0.5 - Self::n_rows(self) as f64) * self.sides()[1];
        let rows = 2 * Self::n_rows(self);
        let columns = self.window().map(|i| Self::x(self, i));
        columns.flat_map(|x| (0..rows).map(move |j| problem.gap(x, y(j)))).collect()
    }

    fn reversed(&self, field: &[f64]) -> Vec<f64> {
        field.chunks_exact(2 * Self::n_rows(self)).rev().flatten().copied().collect()
    }

    fn area(&self) -> f64 {
        self.cell_area()
    }

    fn holds(&self, pressure: &[f64]) -> Result<(), TrackFault> {
        Self::holds(self, pressure)
    }

    fn rolling_force(&self, gap: &[f64], pressure: &[f64]) -> f64 {
        Self::rolling_force(self, gap, pressure)
    }

    fn n_columns(&self) -> usize {
        Self::n_columns(self)
    }

    fn n_rows(&self) -> usize {
        Self::n_rows(self)
    }

    fn x(&self) -> Vec<f64> {
        self.window().map(|i| Self::x(self, i)).collect()
    }

    fn column(&self) -> f64 {
        self.sides()[0]
    }

    /// The mean of both rows beside the axis.
    fn along(&self, field: &[f64]) -> Vec<f64> {
        let rows = Self::n_rows(self);
        let cells = field.chunks_exact(2 * rows);
        cells.map(|cells| 0.5 * (cells[rows - 1] + cells[rows])).collect()
    }

    fn across(&self, field: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let rows = Self::n_rows(self);
        let y = (0..2 * rows).map(|j| (j as f64 + 0.5 - rows as f64) * self.sides()[1]);
        let middle = self.window().len() / 2;
        (y.collect(), field[2 * rows * middle..][..2 * rows].to_vec())
    }

    fn approach(contact: &ContactSolution) -> Option<f64> {
        Some(contact.approach)
    }

    fn solver<'s>(
        _: &RollingProblem,
        iterative: &'s ConjugateGradientSolver,
    ) -> &'s dyn ContactSolver {
        iterative
    }

    fn bytes(&self, problem: &RollingProblem, layers: usize) -> usize {
        bytes_of_ellipse(problem, self, layers)
    }

    /// A residual stress across the track may touch every component: there is no such form.
    fn kinematic(
        &self,
        _: &RollingProblem,
        _: &[RacewayBody],
        _: &mut Run<'_>,
    ) -> Result<Option<Limit>, TrackError> {
        Ok(None)
    }
}
