//! Jobs in three dimensions: contacts of half-spaces.

use std::f64::consts::PI;

use super::settings::{loads, settings};
use super::slopes::of_slopes;
use crate::job::{Analysis, Body, Job, Roller, RollerProfile, Shape};
use crate::material::Solid;
use crate::solver::half_spaces::{
    Conformity, EllipticReference, HalfSpaceProblem, HeightMap, Relief, RollerGap,
};

/// Factors of the logarithmic profiles of ISO 16281 over the diameter: for rollers up to
/// `LONG_ROLLER` diameters long, and for longer rollers.
const ISO_FACTOR: f64 = 0.00035;
const ISO_FACTOR_LONG: f64 = 0.0005;
const LONG_ROLLER: f64 = 2.5;

/// Returns the contact of a job, and its elastic reference; `None` if the job is not in three
/// dimensions.
pub(crate) fn half_spaces_with_reference(
    job: &Job,
) -> Option<(HalfSpaceProblem, EllipticReference)> {
    let reference = elliptic_reference(job)?;
    Some((reference.with_onset(), reference))
}

/// Returns the contact of a job; `None` if the job is not in three dimensions.
pub fn half_spaces(job: &Job) -> Option<HalfSpaceProblem> {
    Some(elliptic_reference(job)?.with_onset())
}

/// Returns the elastic reference of a job; `None` if the job is not in three dimensions.
pub fn elliptic_reference(job: &Job) -> Option<EllipticReference> {
    shapes_of(job).map(EllipticReference::of)
}

/// Returns the problem without its onset of yield.
fn shapes_of(job: &Job) -> Option<HalfSpaceProblem> {
    let [upper, lower] = job.bodies().map(|body| body.shape.curvatures());
    let (upper, lower) = (upper?, lower?);
    let problem = (job.analysis == Analysis::ThreeDimensional).then(|| HalfSpaceProblem {
        materials: job.bodies().map(|body| body.deformable().map(Solid::from)),
        curvature: std::array::from_fn(|k| upper[k] + lower[k]),
        conformity: Conformity::default(),
        rollers: rollers(job),
        heights: heights(job),
        loads: loads(&job.load),
        cells_per_semi_axis: job.mesh.elements_per_half_width,
        cells_of_slopes: of_slopes(job),
        onset: None,
        solver: settings(job),
    })?;
    if problem.heights.is_some() {
        return Some(problem);
    }
    let [upper, lower] =
        [upper, lower].map(|curvatures| along_axes(curvatures, problem.orientation()));
    Some(HalfSpaceProblem { conformity: Conformity::of(upper, lower), ..problem })
}

/// Returns the curvatures of a surface along axes that are turned by an angle.
pub(crate) fn along_axes([xx, yy, xy]: [f64; 3], angle: f64) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    let along_x = cosine * cosine * xx + sine * sine * yy + 2.0 * sine * cosine * xy;
    [along_x, xx + yy - along_x]
}

/// Returns the sum of the heights of both bodies.
fn heights(job: &Job) -> Option<HeightMap> {
    let mut surfaces = job.bodies().into_iter().filter_map(|body| body.surface.as_ref());
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
    let bodies = job.bodies();
    let modulus = bodies.map(Body::compliance).iter().sum::<f64>().recip();
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
