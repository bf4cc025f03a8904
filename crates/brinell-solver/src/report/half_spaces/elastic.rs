//! The elastic reference of a contact of half-spaces, and the load at its onset of yield.

use std::f64::consts::PI;

use brinell_contact::{
    ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolver as _, never,
};
use brinell_halfspace::{EllipticContact, SurfaceFlexibility, SurfaceGrid};

use crate::analytical::{DepthLimit, HertzEllipse, YieldOnset};
use crate::job::{Analysis, Body, Deformable, Job, Material, Roller, RollerProfile, Shape};
use crate::solver::half_spaces::{
    Conformity, HalfSpaceProblem, HalfSpaceStep, HeightMap, Relief, RollerGap, SurfaceMap,
};
use crate::solver::{factor_of_onset, small};

/// Factors of the logarithmic profiles of ISO 16281 over the diameter: for rollers up to
/// `LONG_ROLLER` diameters long, and for longer rollers.
const ISO_FACTOR: f64 = 0.00035;
const ISO_FACTOR_LONG: f64 = 0.0005;
const LONG_ROLLER: f64 = 2.5;

/// Hertz's theory of two half-spaces, for any force.
#[derive(Debug, Clone)]
pub struct EllipticReference {
    problem: HalfSpaceProblem,
    onset: Option<DepthLimit>,
    rolling: Option<DepthLimit>,
}

/// Returns the problem of a job for the engine of half-spaces, or `None` if the job is not in
/// three dimensions.
pub fn problem_of(job: &Job) -> Option<HalfSpaceProblem> {
    let reference = EllipticReference::of(job)?;
    let onset = reference.onset_force().filter(|force| {
        let problem = &reference.problem;
        problem.heights.is_none() && !problem.is_line(&problem.hertz(*force))
    });
    Some(HalfSpaceProblem { onset, ..reference.problem })
}

/// Returns the problem without its onset of yield.
fn shapes_of(job: &Job) -> Option<HalfSpaceProblem> {
    let [upper, lower] = [&job.upper, &job.lower].map(|body| body.shape.curvatures());
    let (upper, lower) = (upper?, lower?);
    let material = |material: &Material| match material {
        Material::Rigid => None,
        Material::Deformable(material) => Some(material.clone()),
    };
    let problem = (job.analysis == Analysis::ThreeDimensional).then(|| HalfSpaceProblem {
        materials: [material(&job.upper.material), material(&job.lower.material)],
        curvature: std::array::from_fn(|k| upper[k] + lower[k]),
        conformity: Conformity::default(),
        rollers: rollers(job),
        heights: heights(job),
        load: job.load.clone(),
        cells_per_semi_axis: job.mesh.elements_per_half_width,
        cells_of_slopes: job.output.contact_stiffness.then(|| small(job)),
        onset: None,
        solver: job.solver,
    })?;
    if problem.heights.is_some() {
        return Some(problem);
    }
    let [upper, lower] =
        [upper, lower].map(|curvatures| along_axes(curvatures, problem.orientation()));
    Some(HalfSpaceProblem { conformity: Conformity::of(upper, lower), ..problem })
}

/// Returns the curvatures of a surface along axes that are turned by an angle.
pub(super) fn along_axes([xx, yy, xy]: [f64; 3], angle: f64) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    let along_x = cosine * cosine * xx + sine * sine * yy + 2.0 * sine * cosine * xy;
    [along_x, xx + yy - along_x]
}

/// Returns the sum of the heights of both bodies.
fn heights(job: &Job) -> Option<HeightMap> {
    let mut surfaces =
        [&job.upper, &job.lower].into_iter().filter_map(|body| body.surface.as_ref());
    let first = surfaces.next()?;
    let mut heights = first.levelled();
    for surface in surfaces {
        for (sum, height) in heights.iter_mut().zip(surface.levelled()) {
            *sum += height;
        }
    }
    Some(HeightMap { heights, cells: first.cells(), spacing: first.spacing() })
}

/// Returns the rollers among the bodies of a job.
fn rollers(job: &Job) -> Vec<RollerGap> {
    let bodies = [&job.upper, &job.lower];
    let compliance = |body: &Body| match &body.material {
        Material::Rigid => 0.0,
        Material::Deformable(material) => material.elastic().plane_strain_modulus().recip(),
    };
    let modulus = bodies.map(compliance).iter().sum::<f64>().recip();
    let roller = |body: &&Body| match &body.shape {
        Shape::Roller(roller) => Some(RollerGap {
            radius: roller.radius.get(),
            length: roller.length.get(),
            rotation: roller.rotation.unwrap_or(0.0).to_radians(),
            tilt: 1e-3 * roller.tilt.unwrap_or(0.0),
            moment: roller.moment,
            relief: relief(roller, modulus),
        }),
        _ => None,
    };
    bodies.iter().filter_map(roller).collect()
}

/// Returns the relief of a roller in a contact with the effective modulus E* `modulus`.
///
/// A uniform line load `w = Q/L` displaces the surfaces of half-spaces less off its middle.
/// Lundberg's profile is this difference, `w/(πE*) ln(1/(1 - (2y/L)²))`.
///
/// # Reference
/// G. Lundberg, *Elastische Berührung zweier Halbräume*, Forsch. Ing.-Wes. 10 (1939) 201–211;
/// ISO/TS 16281:2008, roller profiles.
fn relief(roller: &Roller, modulus: f64) -> Relief {
    let (diameter, length) = (2.0 * roller.radius.get(), roller.length.get());
    match roller.profile {
        None | Some(RollerProfile::Crowned) => Relief::Straight,
        Some(RollerProfile::Logarithmic) => {
            let line_load = roller.design_force.unwrap_or(0.0) / length;
            Relief::Logarithmic(line_load / (PI * modulus))
        }
        Some(RollerProfile::Iso16281) => {
            let factor =
                if length <= LONG_ROLLER * diameter { ISO_FACTOR } else { ISO_FACTOR_LONG };
            Relief::Logarithmic(factor * diameter)
        }
        Some(RollerProfile::Points) => {
            Relief::Points(whole(roller.points.clone().unwrap_or_default()))
        }
    }
}

/// Completes points on one side of the middle by their mirror images.
fn whole(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let starts_in_the_middle = points.first().is_some_and(|[y, _]| *y >= 0.0);
    let ends_in_the_middle = points.last().is_some_and(|[y, _]| *y <= 0.0);
    let mirrored = points.iter().rev().filter(|[y, _]| *y != 0.0).map(|[y, height]| [-y, *height]);
    let mirrored: Vec<_> = mirrored.collect();
    if starts_in_the_middle {
        points.splice(0..0, mirrored);
    } else if ends_in_the_middle {
        points.extend(mirrored);
    }
    points
}

impl EllipticReference {
    /// Returns the reference for a job, or `None` if the job is not in three dimensions.
    pub fn of(job: &Job) -> Option<Self> {
        let problem = shapes_of(job)?;
        if !problem.has_hertz() {
            return Some(Self { onset: None, rolling: None, problem });
        }
        let unit = problem.hertz(1.0);
        let ellipse = (!problem.is_line(&unit))
            .then_some(HertzEllipse { axis_ratio: unit.semi_axis_x / unit.semi_axis_y });
        let half_width = unit.semi_axis_x / unit.peak_pressure;
        let least = |limit: fn(&Deformable, Option<HertzEllipse>, f64) -> Option<DepthLimit>| {
            let bodies = problem.materials.iter().flatten();
            let limits = bodies.filter_map(|material| limit(material, ellipse, half_width));
            limits.min_by(|a, b| a.peak_pressure.total_cmp(&b.peak_pressure))
        };
        let (onset, rolling) = (
            least(|body, ellipse, half_width| onset(body, ellipse, half_width, 1.0)),
            least(rolling),
        );
        // The closed forms neglect stress before the load.
        let is_stressed =
            problem.materials.iter().flatten().any(|body| !body.initial_stress().is_empty());
        // They also neglect that a contact may reach the ends of a roller before it yields.
        let is_alike = |limit: &DepthLimit| {
            let force = problem.force_where(|hertz| hertz.peak_pressure, limit.peak_pressure, 3.0);
            problem.is_line(&problem.hertz(force)) == ellipse.is_none()
        };
        let onset = onset.filter(|limit| !is_stressed && is_alike(limit));
        Some(Self { onset, rolling: rolling.filter(is_alike), problem })
    }

    /// Returns the contact under a force \[N\].
    pub fn under(&self, force: f64) -> EllipticContact {
        self.problem.hertz(force)
    }

    /// Returns the gap before loading at the middles of the cells \[mm\].
    pub(super) fn initial_gap(&self, grid: &SurfaceGrid) -> Vec<f64> {
        self.problem.gap(grid)
    }

    /// Returns the force at the onset of yield \[N\]. Returns `None` if no body has a yield
    /// stress, or if Hertz's theory does not apply: to a body with a stress before the load, or to
    /// a roller with a profile or a tilt.
    pub fn onset_force(&self) -> Option<f64> {
        let force = |peak| self.problem.force_where(|hertz| hertz.peak_pressure, peak, 3.0);
        let is_plain = self.problem.rollers.iter().all(RollerGap::is_plain);
        self.onset.filter(|_| is_plain).map(|limit| force(limit.peak_pressure))
    }

    /// Returns the largest von Mises stress of elastic bodies over the yield stress under a force,
    /// its depth \[mm\] and the body: the factor on the yield stresses that makes the force that
    /// of first yield. Returns `None` where [`onset_force`](Self::onset_force) does.
    pub fn utilization(&self, force: f64) -> Option<(f64, f64, usize)> {
        self.onset_force()?;
        let hertz = self.problem.hertz(force);
        let ellipse = (!self.problem.is_line(&hertz))
            .then_some(HertzEllipse { axis_ratio: hertz.semi_axis_x / hertz.semi_axis_y });
        let half_width = hertz.semi_axis_x / hertz.peak_pressure;
        let bodies = self.problem.materials.iter().enumerate();
        let used = bodies.filter_map(|(side, material)| {
            let onset = |factor: f64| onset(material.as_ref()?, ellipse, half_width, factor);
            onset(1.0)?;
            // The force goes with the cube of the peak pressure, or with its square.
            let of_peak = |factor: f64| {
                onset(factor)
                    .map_or((0.0, 0.0), |limit| (limit.peak_pressure.powf(2.5), limit.depth))
            };
            let (factor, depth) = factor_of_onset(of_peak, hertz.peak_pressure.powf(2.5));
            Some((factor, depth, side))
        });
        used.max_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Returns the depth of the onset of yield \[mm\].
    pub fn onset_depth(&self) -> Option<f64> {
        self.onset.map(|limit| limit.depth)
    }

    /// Returns the shakedown limit of a contact that rolls along its shorter semi-axis, or `None`
    /// if no body has a yield stress. Beyond this limit the bodies yield in every passage.
    pub const fn rolling(&self) -> Option<DepthLimit> {
        self.rolling
    }

    /// Returns the reciprocal of the sum of the curvatures of both surfaces along the shorter
    /// semi-axis \[mm\]: of two cylinders and of two balls that of their plane section.
    pub fn effective_radius(&self) -> f64 {
        self.problem.principal_curvatures()[0].recip()
    }

    /// Returns dP/dα of elastic bodies at a constant contact area of the load step \[N/mm\], or 0
    /// without contact.
    pub fn stiffness(&self, step: &HalfSpaceStep) -> f64 {
        let has_outline = self.problem.heights.is_none() && self.problem.rollers.is_empty();
        if has_outline {
            let semi_axes = step.figures.semi_axes();
            self.of_outline(semi_axes) * self.problem.conformity.of_stiffness(semi_axes)
        } else {
            self.of_cells(&step.field.surface)
        }
    }

    /// Returns the stiffness of a flat punch with the shape of the cells in contact: the force
    /// that displaces all these cells by 1.
    fn of_cells(&self, map: &SurfaceMap) -> f64 {
        if map.pressure.iter().all(|pressure| *pressure <= 0.0) {
            return 0.0;
        }
        let flexibility = SurfaceFlexibility::new(map.grid, self.problem.effective_modulus());
        // With a gap of 2 no cell beside the punch comes into contact.
        let initial_gap: Vec<f64> =
            map.pressure.iter().map(|p| if *p > 0.0 { 0.0 } else { 2.0 }).collect();
        let problem = ContactProblem {
            flexibility: &flexibility,
            initial_gap: &initial_gap,
            closing: &vec![1.0; initial_gap.len()],
            load: ContactLoad::Approach(1.0),
        };
        let pressed = ConjugateGradientSolver::new(1e-6).solve(&problem, None, &mut never);
        pressed.map_or(0.0, |pressed| pressed.total_force)
    }

    /// Returns the stiffness of a flat punch with an elliptic outline of the semi-axes `a <= b`:
    /// `π E* b/K(√(1 - (a/b)²))`.
    ///
    /// # Reference
    /// K. L. Johnson, *Contact Mechanics* (1985), section 3.5.
    fn of_outline(&self, [a, b]: [f64; 2]) -> f64 {
        let (short, long) = (a.min(b), a.max(b));
        if short <= 0.0 {
            return 0.0;
        }
        let modulus = self.problem.effective_modulus();
        let (mut mean, mut root) = (1.0_f64, short / long);
        // The arithmetic-geometric mean gives K.
        for _ in 0..40 {
            (mean, root) = (0.5 * (mean + root), (mean * root).sqrt());
        }
        2.0 * modulus * long * mean
    }
}

/// Returns the yield stress of a material, or `None` if it has none.
fn yield_stress(material: &Deformable) -> Option<f64> {
    material.hardening_law().map(|law| law.yield_stress()).filter(|stress| *stress > 0.0)
}

/// Returns peak pressure and depth at the shakedown limit of a body. `half_width` is the shorter
/// semi-axis at a unit peak pressure. Without an ellipse the contact is a line contact.
fn rolling(
    material: &Deformable,
    ellipse: Option<HertzEllipse>,
    half_width: f64,
) -> Option<DepthLimit> {
    let yield_stress = yield_stress(material)?;
    let strength = material.strength();
    let over_depth =
        |depth: f64| yield_stress * strength.as_ref().map_or(1.0, |s| s.factor(depth));
    Some(match (ellipse, strength.is_some()) {
        (Some(ellipse), true) => DepthLimit::ellipse_rolling(ellipse, half_width, over_depth),
        (Some(ellipse), false) => {
            DepthLimit::uniform_ellipse_rolling(ellipse, half_width, yield_stress)
        }
        (None, true) => DepthLimit::rolling(half_width, over_depth),
        (None, false) => DepthLimit::uniform_rolling(half_width, yield_stress),
    })
}

/// Returns peak pressure and depth at the onset of yield of a body. `half_width` is the shorter
/// semi-axis at a unit peak pressure. Without an ellipse the contact is a line contact. `factor`
/// multiplies the yield stress.
fn onset(
    material: &Deformable,
    ellipse: Option<HertzEllipse>,
    half_width: f64,
    factor: f64,
) -> Option<DepthLimit> {
    let yield_stress = factor * yield_stress(material)?;
    let poisson_ratio = material.elastic().poisson_ratio.get();
    if let Some(strength) = material.strength() {
        let over_depth = |depth: f64| yield_stress * strength.factor(depth);
        return Some(match ellipse {
            Some(ellipse) => {
                DepthLimit::ellipse_onset(ellipse, poisson_ratio, half_width, over_depth)
            }
            None => DepthLimit::line_onset(poisson_ratio, half_width, over_depth),
        });
    }
    let onset = ellipse.map_or_else(
        || YieldOnset::line_von_mises(poisson_ratio),
        |ellipse| YieldOnset::ellipse(ellipse, poisson_ratio),
    );
    let peak_pressure = onset.pressure_ratio * yield_stress;
    Some(DepthLimit { peak_pressure, depth: onset.depth_ratio * half_width * peak_pressure })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stiffness_of_a_circle_is_that_of_a_round_punch() {
        let job = br#"{"analysis": "three_dimensional",
            "upper": {"shape": {"type": "sphere", "radius": 10}, "material": {"rigid": true}},
            "lower": {"shape": {"type": "flat"},
                "material": {"young_modulus": 210000, "poisson_ratio": 0.3,
                "plasticity": {"law": "bilinear", "yield_stress": 500, "tangent_modulus": 0}}},
            "load": {"force": 100}}"#;
        let reference = EllipticReference::of(&Job::from_json(job).unwrap()).unwrap();
        let modulus = 210_000.0 / 0.91;
        assert!((reference.of_outline([0.2, 0.2]) / (2.0 * modulus * 0.2) - 1.0).abs() < 1e-14);
        // At the onset p0 = 1.613 σ_y and P = π³ R² p0³/(6 E*²).
        let force = PI.powi(3) * 100.0 * (1.6132 * 500.0f64).powi(3) / (6.0 * modulus * modulus);
        assert!((reference.onset_force().unwrap() / force - 1.0).abs() < 1e-3);
        // The tangent of Hertz's curve.
        let [before, here, after] = [99.0, 100.0, 101.0].map(|force| reference.under(force));
        let slope = 2.0 / (after.approach - before.approach);
        assert!(
            (reference.of_outline([here.semi_axis_x, here.semi_axis_y]) / slope - 1.0).abs()
                < 1e-4
        );
    }
}
