//! The least that solves passes: the map of `RacewayBody` under Anderson's mixing.
#![expect(clippy::unwrap_used, reason = "a driver of tests that cannot go on says where")]

use std::sync::Arc;

use brinell_contact::{
    ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolution, ContactSolver, never,
};
use brinell_halfspace::raceway::{RacewayBody, RacewaySpace, RowLaw};
use brinell_halfspace::track::{
    Direction, Ground, LENGTH_OF_ELLIPSE, Operators as _, Outlet, PassStrain, TrackGrid,
};
use brinell_halfspace::{Elasticity, EllipticContact, Layers, SurfaceFlexibility};
use brinell_material::hardening::StraightLine;
use brinell_material::{
    BackstressTerm, ElasticModuli, FlowPlasticity, OutOfPlane, ReturnMapping, StreamOfLayers,
};
use brinell_method::couplings::anderson::Anderson;

pub const YOUNG: f64 = 210_000.0;
pub const POISSON: f64 = 0.3;
pub const YIELD: f64 = 500.0;
/// Plastic modulus of a tangent of a twentieth of Young's modulus.
pub const TWENTIETH: f64 = YOUNG * 0.05 / 0.95;

pub fn modulus() -> f64 {
    YOUNG / (1.0 - POISSON * POISSON)
}

/// A track under a rigid body.
#[derive(Debug, Clone)]
pub struct Setup {
    pub resolution: usize,
    pub length: f64,
    pub friction: f64,
    /// Radii along and across the travel \[mm\].
    pub radii: [f64; 2],
    /// Elastic peak pressure over the yield stress.
    pub ratio: f64,
    pub plastic_modulus: f64,
    /// Terms of backstress: modulus and rate.
    pub terms: Vec<[f64; 2]>,
    /// One body under a rigid one, or two equal ones.
    pub count: u8,
    /// Factor on all lengths.
    pub scale: f64,
    pub tolerance: f64,
}

impl Setup {
    pub fn ball(resolution: usize, ratio: f64, plastic_modulus: f64) -> Self {
        Self {
            resolution,
            length: LENGTH_OF_ELLIPSE,
            friction: 0.0,
            radii: [10.0, 10.0],
            ratio,
            plastic_modulus,
            terms: vec![],
            count: 1,
            scale: 1.0,
            tolerance: 1e-5,
        }
    }

    fn effective_modulus(&self) -> f64 {
        modulus() / f64::from(self.count)
    }

    pub fn force(&self) -> f64 {
        let [rx, ry] = self.radii.map(|radius| self.scale * radius);
        let unit = EllipticContact::new(rx, ry, self.effective_modulus(), 1.0);
        (self.ratio * YIELD / unit.peak_pressure).powi(3)
    }

    pub fn hertz(&self) -> EllipticContact {
        let [rx, ry] = self.radii.map(|radius| self.scale * radius);
        EllipticContact::new(rx, ry, self.effective_modulus(), self.force())
    }

    pub fn grid(&self) -> (TrackGrid, Layers) {
        let hertz = self.hertz();
        let axes = [hertz.semi_axis_x, hertz.semi_axis_y];
        let grid = TrackGrid::of_ellipse(axes, self.resolution, self.length).unwrap();
        (grid, grid.layers(axes, self.friction).unwrap())
    }

    fn law(&self, rows: usize) -> Box<RowLaw> {
        fn of<const N: usize>(setup: &Setup, rows: usize) -> Box<RowLaw> {
            let elastic = ElasticModuli {
                bulk: YOUNG / (3.0 * (1.0 - 2.0 * POISSON)),
                shear: 0.5 * YOUNG / (1.0 + POISSON),
            };
            let law = StraightLine { yield_stress: YIELD, plastic_modulus: setup.plastic_modulus };
            let terms: [BackstressTerm; N] = std::array::from_fn(|i| BackstressTerm {
                modulus: setup.terms[i][0],
                rate: setup.terms[i][1],
            });
            let mapping = ReturnMapping::new(Arc::new(law), elastic.shear);
            let model =
                Arc::new(FlowPlasticity::new(elastic, mapping, terms, OutOfPlane::Strained));
            Box::new(StreamOfLayers::<N, 6>::new(vec![model; rows]))
        }
        match self.terms.len() {
            0 => of::<0>(self, rows),
            _ => of::<1>(self, rows),
        }
    }
}

pub fn space(grid: TrackGrid, layers: Layers, slides: bool) -> RacewaySpace {
    let elastic = Elasticity::new(YOUNG, POISSON).unwrap();
    RacewaySpace::new(Ground { grid, layers, elastic }, slides, &mut || false).unwrap()
}

#[derive(Debug, Clone)]
pub struct Pass {
    pub converged: bool,
    pub evaluations: usize,
    pub outlet: Outlet,
    pub strain: PassStrain,
    pub peak: f64,
    pub approach: f64,
    pub rolling_force: f64,
    pub work_of_traction: f64,
    /// Groove as a ring sums it, which ends half a period away.
    pub ring_groove: f64,
}

pub struct Roller {
    pub setup: Setup,
    pub body: RacewayBody,
    pub grid: TrackGrid,
    pub gap: Vec<f64>,
    pub pressure: Vec<f64>,
    flexibility: SurfaceFlexibility,
    increment: Vec<f64>,
    contact: Option<ContactSolution>,
}

impl Roller {
    pub fn new(setup: &Setup) -> Self {
        let (grid, layers) = setup.grid();
        let (initial, rows) = (vec![[0.0; 2]; layers.len()], layers.len() * grid.n_rows());
        let space = Arc::new(space(grid, layers, setup.friction != 0.0));
        let body = RacewayBody::new(space, setup.law(rows), setup.count, setup.friction, initial);
        let surface = grid.surface().unwrap();
        let [rx, ry] = setup.radii.map(|radius| setup.scale * radius);
        let gap = surface.sample(|x, y| x * x / (2.0 * rx) + y * y / (2.0 * ry));
        Self {
            setup: setup.clone(),
            increment: vec![0.0; body.n_numbers()],
            pressure: vec![0.0; gap.len()],
            gap,
            flexibility: SurfaceFlexibility::new(surface, setup.effective_modulus()),
            body,
            grid,
            contact: None,
        }
    }

    fn evaluate(&mut self, increment: &[f64], trial: &mut [f64], into: &mut [f64]) {
        let mut gap = self.gap.clone();
        self.body.open(increment, &mut gap, &mut || false).unwrap();
        let problem = ContactProblem {
            flexibility: &self.flexibility,
            initial_gap: &gap,
            closing: &vec![1.0; gap.len()],
            load: ContactLoad::Force(self.setup.force()),
        };
        let solver = ConjugateGradientSolver::new(1e-8);
        let contact = solver.solve(&problem, self.contact.as_ref(), &mut never).unwrap();
        for (p, force) in self.pressure.iter_mut().zip(&contact.force) {
            *p = force / self.grid.cell_area();
        }
        self.contact = Some(contact);
        self.body.trial(&self.pressure, trial, &mut || false).unwrap();
        self.body.flow(trial, into);
    }

    /// The other direction, for the passes to come.
    pub fn turn(&mut self) {
        self.body.turn();
        let ny = 2 * self.grid.n_rows();
        self.gap = self.gap.chunks_exact(ny).rev().flatten().copied().collect();
    }

    pub fn pass(&mut self) -> Pass {
        let mut increment = std::mem::take(&mut self.increment);
        let (mut image, mut trial) = (increment.clone(), increment.clone());
        let mut anderson = Anderson::default();
        self.body.begin(&increment);
        let (mut converged, mut evaluations) = (false, 0);
        while evaluations < 150 && !converged {
            evaluations += 1;
            self.evaluate(&increment, &mut trial, &mut image);
            let (mut x, mut y) = (Vec::new(), Vec::new());
            self.body.pack(&increment, &mut x);
            self.body.pack(&image, &mut y);
            let size = y.iter().map(|y| y * y).sum::<f64>().sqrt();
            let change = x.iter().zip(&y).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
            converged = change <= self.setup.tolerance * size;
            if !converged {
                let next = anderson.next(&x, y);
                self.body.unpack(&next, &mut increment);
            }
        }
        self.body.holds().unwrap();
        self.grid.holds(&self.pressure).unwrap();
        let work = self.body.work_of_traction(&self.pressure, &mut || false).unwrap();
        let outlet = self.body.accept(&image, &mut trial);
        let ring_groove = self.ring_groove(&outlet);
        self.body.flow(&trial, &mut image);
        self.increment = image;
        Pass {
            converged,
            evaluations,
            strain: PassStrain::of(&outlet),
            outlet,
            peak: self.pressure.iter().copied().fold(0.0, f64::max),
            approach: self.contact.as_ref().unwrap().approach,
            rolling_force: self.grid.rolling_force(&self.gap, &self.pressure),
            work_of_traction: work,
            ring_groove,
        }
    }

    pub fn passes(&mut self, n: usize) -> Vec<Pass> {
        (0..n).map(|_| self.pass()).collect()
    }

    fn ring_groove(&self, outlet: &Outlet) -> f64 {
        let (space, grid) = (self.body.space(), &self.grid);
        let (nx, rows) = (grid.n_columns(), grid.n_rows());
        let polarization = YOUNG / (1.0 + POISSON);
        let layers = space.ground().layers.len();
        let mut field = Vec::with_capacity(space.ground().field_len::<5>());
        for of_layer in outlet.strain.chunks_exact(rows) {
            for k in 0..5 {
                for strain in of_layer {
                    field.extend(std::iter::repeat_n(polarization * strain[k], nx));
                }
            }
        }
        let mut opening = vec![0.0; rows * grid.window().len()];
        let reach = vec![rows; layers];
        space
            .opening(
                Direction::Normal,
                &field,
                &reach,
                &mut space.work(),
                &mut opening,
                &mut || false,
            )
            .unwrap();
        opening[grid.window().len() / 2]
    }
}

impl Pass {
    /// Smallest residual stresses σxx, σyy on the axis.
    pub fn least_residual(&self) -> [f64; 2] {
        let on_axis = self.outlet.on_axis(&self.outlet.residual);
        let least = |k: usize| on_axis.clone().map(|s| s[k]).fold(0.0, f64::min);
        [least(0), least(1)]
    }

    pub fn line(&self) -> String {
        let [sx, sy] = self.least_residual();
        format!(
            "{} {} evaluations, approach {:.4e}, peak {:.1}, groove {:.4e} (ring {:.4e}), pile \
             {:.3e}, dp {:.3e}, net {:.3e}, residual {sx:.1} {sy:.1}, work {:.4e}, forward \
             {:+.3e}, F {:.4e} + {:.4e}, plastic + stored {:.4e}",
            self.converged,
            self.evaluations,
            self.approach,
            self.peak,
            self.outlet.groove_depth,
            self.ring_groove,
            self.outlet.pile_up,
            self.strain.largest.value,
            self.strain.net.value,
            self.outlet.plastic_work,
            self.outlet.forward,
            self.rolling_force,
            self.work_of_traction,
            self.outlet.plastic_work + self.outlet.stored_energy,
        )
    }
}
