//! Cases of one body that yields, and a loop that drives a system until the method's own does.
#![allow(dead_code, reason = "each executable uses a part")]
#![expect(clippy::unwrap_used, reason = "a test that cannot go on says where")]

use std::sync::Arc;

use brinell_contact::{ContactLoad, ContactStatus, never};
use brinell_halfspace::{
    Elasticity, EllipticContact, HalfSpace, HalfSpaceSystem, Hardening, Increment, Layers, LinearHardening,
    PlasticBody, SurfaceFlexibility, SurfaceGrid,
};

pub const YOUNG: f64 = 210_000.0;
pub const POISSON: f64 = 0.3;
pub const YIELD_STRESS: f64 = 500.0;

/// A rigid ellipsoid of radii 10 mm along x and `radius_y` along y on a body that yields.
pub struct Case {
    pub n: usize,
    pub radius_y: f64,
    /// Largest elastic pressure over the yield stress.
    pub ratio: f64,
    /// Tangent modulus over Young's modulus.
    pub tangent: f64,
    /// Expected plastic over elastic semi-axes.
    pub widening: [f64; 2],
    /// How many such bodies touch each other.
    pub count: u8,
}

pub struct Built {
    pub system: HalfSpaceSystem<LinearHardening>,
    pub hertz: EllipticContact,
    pub force: f64,
}

impl Case {
    pub fn ball(n: usize, ratio: f64, tangent: f64, widening: f64) -> Self {
        Self { n, radius_y: 10.0, ratio, tangent, widening: [widening; 2], count: 1 }
    }

    pub fn build(&self) -> Built {
        let law = LinearHardening {
            yield_stress: YIELD_STRESS,
            modulus: self.tangent * YOUNG / (1.0 - self.tangent),
        };
        let count = f64::from(self.count);
        let elastic = Elasticity::new(YOUNG, POISSON).unwrap();
        let modulus = 1.0 / (count * elastic.plane_compliance());
        let unit = EllipticContact::new(10.0, self.radius_y, modulus, 1.0);
        let force = (self.ratio * YIELD_STRESS / unit.peak_pressure).powi(3);
        let hertz = EllipticContact::new(10.0, self.radius_y, modulus, force);
        let axes = [self.widening[0] * hertz.semi_axis_x, self.widening[1] * hertz.semi_axis_y];
        let n = self.n as f64;
        let grid = SurfaceGrid::new(self.n, self.n, 3.2 * axes[0] / n, 3.2 * axes[1] / n).unwrap();
        let layers =
            Layers::graded(0.75 * grid.hx().min(grid.hy()), 1.0 + 1.92 / n, 2.6 * axes[0].min(axes[1]))
                .unwrap();
        let gap = grid.sample(|x, y| x * x / 20.0 + y * y / (2.0 * self.radius_y));
        let space = Arc::new(HalfSpace::new(grid, layers, elastic));
        let body = PlasticBody::new(space, law, self.count);
        let surface = SurfaceFlexibility::new(grid, modulus);
        Built { system: HalfSpaceSystem::new(surface, vec![body], gap, 1e-8), hertz, force }
    }
}

/// Earlier evaluations that the next one is made of.
const MEMORY: usize = 8;

/// Anderson's iteration on `Δε = Δε_new(Δε)`, to a residual over the new increment. Commits nothing. The increment, evaluations
/// and applications of the flexibility.
pub fn solve<H: Hardening>(
    system: &mut HalfSpaceSystem<H>,
    load: ContactLoad,
    tolerance: f64,
) -> (Increment, usize, usize) {
    let mut increment = system.zeros();
    let mut next = system.zeros();
    let (mut images, mut residuals): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (Vec::new(), Vec::new());
    let (mut last, mut applications) = (f64::INFINITY, 0);
    for evaluation in 1..100 {
        let contact = system.equilibrium(&increment, load, &mut never).unwrap();
        assert_eq!(contact.status, ContactStatus::Converged);
        applications += contact.applications;
        system.initial_stress(&increment, &mut next);
        let size = system.norm(&next);
        let residual =
            if size > 0.0 { system.distance(&next, &increment) / size } else { system.norm(&increment) };
        if residual <= tolerance {
            return (increment, evaluation, applications);
        }
        if residual > 2.0 * last {
            images.clear();
            residuals.clear();
        }
        last = residual;
        let (image, from) = (system.pack(&next), system.pack(&increment));
        residuals.push(image.iter().zip(&from).map(|(a, b)| a - b).collect());
        images.push(image);
        if images.len() > MEMORY + 1 {
            images.remove(0);
            residuals.remove(0);
        }
        let mixed = mix(&images, &residuals);
        system.unpack(&mixed, &mut increment);
    }
    panic!("no convergence to {tolerance}: {last}");
}

/// `Σ θ_i image_i` with `Σ θ = 1` and the least `|Σ θ_i residual_i|`. Shorter vectors end in zeros.
fn mix(images: &[Vec<f64>], residuals: &[Vec<f64>]) -> Vec<f64> {
    let newest = residuals.len() - 1;
    let at = |v: &[f64], k: usize| v.get(k).copied().unwrap_or(0.0);
    let len = residuals[newest].len();
    let differences: Vec<Vec<f64>> = residuals[..newest]
        .iter()
        .map(|r| (0..len).map(|k| residuals[newest][k] - at(r, k)).collect())
        .collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut matrix: Vec<Vec<f64>> =
        differences.iter().map(|a| differences.iter().map(|b| dot(a, b)).collect()).collect();
    let mut theta: Vec<f64> = differences.iter().map(|a| dot(a, &residuals[newest])).collect();
    for (k, row) in matrix.iter_mut().enumerate() {
        row[k] *= 1.0 + 1e-12;
    }
    // Gauss with the largest pivot of a column.
    for k in 0..newest {
        let pivot = (k..newest).max_by(|a, b| matrix[*a][k].abs().total_cmp(&matrix[*b][k].abs())).unwrap();
        matrix.swap(k, pivot);
        theta.swap(k, pivot);
        let (above, below) = matrix.split_at_mut(k + 1);
        let pivot_row = &above[k];
        for (i, row) in below.iter_mut().enumerate() {
            let factor = row[k] / pivot_row[k];
            for (entry, eliminated) in row.iter_mut().zip(pivot_row).skip(k) {
                *entry -= factor * eliminated;
            }
            theta[k + 1 + i] -= factor * theta[k];
        }
    }
    for k in (0..newest).rev() {
        theta[k] = (theta[k] - (k + 1..newest).map(|j| matrix[k][j] * theta[j]).sum::<f64>()) / matrix[k][k];
    }
    let own = 1.0 - theta.iter().sum::<f64>();
    (0..len)
        .map(|k| own * images[newest][k] + images.iter().zip(&theta).map(|(v, t)| t * at(v, k)).sum::<f64>())
        .collect()
}

/// Force of increment `k` of `n`: the half-width grows by equal steps from a little beyond first yield.
pub fn force_of(case: &Case, built: &Built, k: usize, n: usize) -> f64 {
    let first = 1.6 / case.ratio;
    built.force * (first + (1.0 - first) * k as f64 / n as f64).powi(3)
}

/// Figures of a loaded or unloaded system.
#[derive(Debug)]
pub struct Figures {
    pub peak: f64,
    pub smoothed_peak: f64,
    pub approach: f64,
    pub strain: f64,
    pub dent: f64,
    pub pile_up: f64,
}

pub fn figures(system: &HalfSpaceSystem<LinearHardening>) -> Figures {
    let (nx, ny) = (system.grid().nx(), system.grid().ny());
    let area = system.grid().cell_area();
    let force = &system.contact().force;
    let pressure = |i: usize, j: usize| force[i * ny + j] / area;
    let weights = [0.25, 0.5, 0.25];
    let smoothed = |i: usize, j: usize| {
        (0..9).map(|n| weights[n / 3] * weights[n % 3] * pressure(i + n / 3 - 1, j + n % 3 - 1)).sum::<f64>()
    };
    let inner = (1..nx - 1).flat_map(|i| (1..ny - 1).map(move |j| (i, j)));
    let opening = system.opening();
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::NEG_INFINITY, f64::max);
    Figures {
        peak: most(&mut force.iter().map(|r| r / area)),
        smoothed_peak: most(&mut inner.map(|(i, j)| smoothed(i, j))),
        approach: system.contact().approach,
        strain: most(&mut system.bodies()[0].equivalent_plastic_strain().into_iter()),
        dent: opening[nx / 2 * ny + ny / 2],
        pile_up: most(&mut opening.iter().map(|u| -u)),
    }
}
