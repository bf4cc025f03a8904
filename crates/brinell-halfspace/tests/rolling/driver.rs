//! The least that solves passes: the map of `LineBody` under Anderson's mixing.
#![allow(dead_code, reason = "tests and benches use parts of it")]
#![expect(clippy::unwrap_used, reason = "a driver of tests that cannot go on says where")]

use std::f64::consts::PI;
use std::sync::Arc;

use brinell_contact::{
    ActiveSetSolver, ContactLoad, ContactProblem, ContactSolution, ContactSolver, never,
};
use brinell_halfspace::line::{LineBody, LineFlexibility, LineSpace};
use brinell_halfspace::track::{
    Ground, LENGTH_OF_LINE, Operators as _, Outlet, PassStrain, TrackFault, TrackGrid, TrackLimits,
};
use brinell_halfspace::{Elasticity, Layers};
use brinell_material::hardening::{StraightLine, Voce};
use brinell_material::{
    BackstressTerm, ElasticModuli, FlowPlasticity, HardeningLaw, OutOfPlane, ReturnMapping,
    StreamLaw, StreamOfLayers, scaled,
};
use brinell_method::couplings::anderson::Anderson;

pub const YOUNG: f64 = 210_000.0;
pub const POISSON: f64 = 0.3;
pub const YIELD: f64 = 500.0;
/// Half-width of the elastic contact.
pub const A: f64 = 1.0;

pub fn shear_strength() -> f64 {
    YIELD / 3f64.sqrt()
}

pub fn modulus() -> f64 {
    YOUNG / (1.0 - POISSON * POISSON)
}

/// Limits of the continuum over k.
pub fn limit(friction: f64) -> f64 {
    match (friction.abs() * 100.0).round() {
        0.0 => 4.0,
        10.0 => 3.564,
        20.0 => 3.202,
        30.0 => 2.9,
        40.0 => 2.5,
        _ => 2.0,
    }
}

/// A hardening law and terms of backstress.
#[derive(Clone)]
pub struct Material {
    pub law: Arc<dyn HardeningLaw>,
    pub terms: Vec<[f64; 2]>,
}

impl Material {
    pub fn perfect() -> Self {
        Self::straight(0.0)
    }

    pub fn straight(plastic_modulus: f64) -> Self {
        Self {
            law: Arc::new(StraightLine { yield_stress: YIELD, plastic_modulus }),
            terms: vec![],
        }
    }

    pub fn voce(saturation_stress: f64, rate: f64) -> Self {
        let law = Voce { yield_stress: YIELD, saturation_stress, rate };
        Self { law: Arc::new(law), terms: vec![] }
    }

    pub fn with(mut self, terms: &[[f64; 2]]) -> Self {
        self.terms = terms.to_vec();
        self
    }

    pub fn stream(&self, factors: &[f64]) -> Box<dyn StreamLaw> {
        fn of<const N: usize>(material: &Material, factors: &[f64]) -> Box<dyn StreamLaw> {
            let elastic = ElasticModuli {
                bulk: YOUNG / (3.0 * (1.0 - 2.0 * POISSON)),
                shear: 0.5 * YOUNG / (1.0 + POISSON),
            };
            let terms: [BackstressTerm; N] = std::array::from_fn(|i| BackstressTerm {
                modulus: material.terms[i][0],
                rate: material.terms[i][1],
            });
            let model = |factor: &f64| {
                let mapping = ReturnMapping::new(scaled(&material.law, *factor), elastic.shear);
                Arc::new(FlowPlasticity::new(elastic, mapping, terms, OutOfPlane::Strained))
            };
            Box::new(StreamOfLayers::new(factors.iter().map(model).collect()))
        }
        match self.terms.len() {
            0 => of::<0>(self, factors),
            1 => of::<1>(self, factors),
            2 => of::<2>(self, factors),
            _ => of::<3>(self, factors),
        }
    }
}

/// A track, a roller and a material.
#[derive(Clone)]
pub struct Setup {
    pub resolution: usize,
    pub length: f64,
    pub friction: f64,
    /// Elastic peak pressure.
    pub peak: f64,
    /// Whether the pressure is that of Hertz whatever the body does.
    pub is_prescribed: bool,
    pub material: Material,
    /// One body under a rigid roller, or two equal ones.
    pub count: u8,
    /// Factor of the strength over depth.
    pub strength: fn(f64) -> f64,
    /// σxx, σyy over depth.
    pub initial: fn(f64) -> [f64; 2],
    pub tolerance: f64,
}

impl Setup {
    /// A perfectly plastic track at a multiple of the limit of the continuum.
    pub fn new(resolution: usize, friction: f64, factor: f64) -> Self {
        Self {
            resolution,
            length: LENGTH_OF_LINE,
            friction,
            peak: factor * limit(friction) * shear_strength(),
            is_prescribed: false,
            material: Material::perfect(),
            count: 1,
            strength: |_| 1.0,
            initial: |_| [0.0; 2],
            tolerance: 1e-4,
        }
    }

    /// The same at a multiple of the limit of its own layers.
    pub fn of_discrete(resolution: usize, friction: f64, factor: f64) -> Self {
        let mut setup = Self::new(resolution, friction, 1.0);
        let (grid, layers) = setup.grid();
        let space = space(grid, layers);
        setup.peak = factor * limits(&space, friction).perfect.value;
        setup
    }

    pub fn grid(&self) -> (TrackGrid, Layers) {
        let grid = TrackGrid::of_line(A, self.resolution, self.length).unwrap();
        (grid, grid.layers([A; 2], self.friction).unwrap())
    }
}

pub fn space(grid: TrackGrid, layers: Layers) -> LineSpace {
    let elastic = Elasticity::new(YOUNG, POISSON).unwrap();
    LineSpace::new(Ground { grid, layers, elastic }, true, &mut || false).unwrap()
}

/// Means of Hertz's pressure over the columns of the window.
pub fn hertz(grid: &TrackGrid, peak: f64) -> Vec<f64> {
    let integral = |x: f64| {
        let x = (x / A).clamp(-1.0, 1.0);
        0.5 * (x * (1.0 - x * x).sqrt() + x.asin())
    };
    let h = grid.column();
    grid.sample(|x, _| peak * A * (integral(x + 0.5 * h) - integral(x - 0.5 * h)) / h)
}

/// Limits of the layers: elastic peak pressures.
pub fn limits(space: &LineSpace, friction: f64) -> TrackLimits {
    TrackLimits::new(space, &hertz(&space.ground().grid, 1.0), friction, |_| YIELD, &mut || false)
        .unwrap()
}

/// How a pass has ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    Converged,
    Stalled,
    NotFinite,
    Refused(TrackFault),
}

#[derive(Debug, Clone)]
pub struct Pass {
    pub end: End,
    pub evaluations: usize,
    pub residual: f64,
    pub outlet: Outlet,
    pub strain: PassStrain,
    /// Peak pressure.
    pub peak: f64,
    pub rolling_force: f64,
    pub work_of_traction: f64,
}

pub struct Roller {
    pub setup: Setup,
    pub body: LineBody,
    pub grid: TrackGrid,
    pub gap: Vec<f64>,
    pub pressure: Vec<f64>,
    flexibility: LineFlexibility,
    increment: Vec<f64>,
    contact: Option<ContactSolution>,
}

impl Roller {
    pub fn new(setup: &Setup) -> Self {
        let (grid, layers) = setup.grid();
        let depths: Vec<f64> = (0..layers.len()).map(|layer| layers.middle(layer)).collect();
        let factors: Vec<f64> = depths.iter().map(|z| (setup.strength)(*z)).collect();
        let initial = depths.iter().map(|z| (setup.initial)(*z)).collect();
        let space = Arc::new(space(grid, layers));
        let law = setup.material.stream(&factors);
        let body = LineBody::new(space, law, setup.count, setup.friction, initial);
        let modulus = modulus() / f64::from(setup.count);
        let radius = modulus * A / (2.0 * setup.peak);
        Self {
            setup: setup.clone(),
            increment: vec![0.0; body.n_numbers()],
            body,
            gap: grid.sample(|x, _| x * x / (2.0 * radius)),
            pressure: hertz(&grid, setup.peak),
            flexibility: LineFlexibility::new(&grid, modulus),
            contact: None,
            grid,
        }
    }

    /// One evaluation: `2μ Δε` of an increment.
    pub fn evaluate(&mut self, increment: &[f64], trial: &mut [f64], into: &mut [f64]) {
        let mut opening = vec![0.0; self.gap.len()];
        self.body.open(increment, &mut opening, &mut || false).unwrap();
        if !self.setup.is_prescribed {
            let gap: Vec<f64> = self.gap.iter().zip(&opening).map(|(g, u)| g + u).collect();
            let force = 0.5 * PI * A * self.setup.peak;
            let problem = ContactProblem {
                flexibility: &self.flexibility,
                initial_gap: &gap,
                closing: &vec![1.0; gap.len()],
                load: ContactLoad::Force(force),
            };
            let contact =
                ActiveSetSolver.solve(&problem, self.contact.as_ref(), &mut never).unwrap();
            for (p, force) in self.pressure.iter_mut().zip(&contact.force) {
                *p = force / self.grid.column();
            }
            self.contact = Some(contact);
        }
        self.body.trial(&self.pressure, trial, &mut || false).unwrap();
        self.body.flow(trial, into);
    }

    /// One evaluation of the increment of the last pass.
    pub fn evaluate_again(&mut self, trial: &mut [f64], into: &mut [f64]) {
        let increment = std::mem::take(&mut self.increment);
        self.evaluate(&increment, trial, into);
        self.increment = increment;
    }

    /// Layers that have flowed in the last pass.
    pub fn n_strained(&self) -> usize {
        let rows = self.increment.chunks_exact(3 * self.grid.n_columns());
        rows.filter(|rows| rows.iter().any(|value| *value != 0.0)).count()
    }

    /// Whether the surface bears the traction under a peak pressure.
    pub fn bears(&self, peak: f64) -> Result<(), TrackFault> {
        TrackFault::require_strength(self.body.law(), self.setup.friction.abs() * peak)
    }

    /// The other direction, for the passes to come.
    pub fn turn(&mut self) {
        self.body.turn();
        self.gap.reverse();
    }

    pub fn pass(&mut self, most: usize) -> Pass {
        let mut increment = std::mem::take(&mut self.increment);
        let mut image = vec![0.0; increment.len()];
        let mut trial = vec![0.0; increment.len()];
        let mut anderson = Anderson::default();
        self.body.begin(&increment);
        let (mut end, mut residual, mut evaluations) = (End::Stalled, 0.0, 0);
        if let Err(fault) = self.bears(self.setup.peak) {
            end = End::Refused(fault);
        }
        while evaluations < most && end == End::Stalled {
            evaluations += 1;
            self.evaluate(&increment, &mut trial, &mut image);
            let (mut x, mut y) = (Vec::new(), Vec::new());
            self.body.pack(&increment, &mut x);
            self.body.pack(&image, &mut y);
            let size = y.iter().map(|y| y * y).sum::<f64>().sqrt();
            let change = x.iter().zip(&y).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
            residual = if change > 0.0 { change / size.max(1e-300) } else { 0.0 };
            if !residual.is_finite() {
                end = End::NotFinite;
            } else if residual < self.setup.tolerance || size <= 0.0 {
                end = End::Converged;
            } else {
                let next = anderson.next(&x, y);
                self.body.unpack(&next, &mut increment);
            }
        }
        if end == End::Converged {
            let window = self.grid.holds(&self.pressure);
            if let Err(fault) = window.and_then(|()| self.body.holds()) {
                end = End::Refused(fault);
            }
        }
        let work_of_traction = self.body.work_of_traction(&self.pressure, &mut || false).unwrap();
        let outlet = self.body.accept(&image, &mut trial);
        self.increment = image;
        Pass {
            end,
            evaluations,
            residual,
            strain: PassStrain::of(&outlet),
            outlet,
            peak: self.pressure.iter().copied().fold(0.0, f64::max),
            rolling_force: self.grid.rolling_force(&self.gap, &self.pressure),
            work_of_traction,
        }
    }

    pub fn passes(&mut self, n: usize) -> Vec<Pass> {
        (0..n).map(|_| self.pass(150)).collect()
    }
}

impl Pass {
    /// Smallest residual stresses σxx, σyy.
    pub fn least_residual(&self) -> [f64; 2] {
        let least = |k: usize| self.outlet.residual.iter().map(|s| s[k]).fold(0.0, f64::min);
        [least(0), least(1)]
    }

    pub fn line(&self) -> String {
        let [sx, sy] = self.least_residual();
        format!(
            "{:?} {} evaluations, dp {:.3e} @ {:.2}, net {:.3e} @ {:.2}, forward {:+.3e}, groove \
             {:.3e}, residual {sx:.1} {sy:.1}, peak {:.1}, F {:.4e} + {:.4e}, plastic + stored \
             {:.4e}",
            self.end,
            self.evaluations,
            self.strain.largest.value,
            self.strain.largest.depth,
            self.strain.net.value,
            self.strain.net.depth,
            self.outlet.forward,
            self.outlet.groove_depth,
            self.peak,
            self.rolling_force,
            self.work_of_traction,
            self.outlet.plastic_work + self.outlet.stored_energy,
        )
    }
}
