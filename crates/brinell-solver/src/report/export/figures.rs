//! Charts as SVG: pressure over the contact and stresses over depth with their elastic closed
//! forms, force over approach, and surfaces.

use plotters::style::RGBColor;

use super::ExportError;
use super::chart::{Chart, Curve, Stroke};
use super::map;
use crate::analytical::HertzLine;
use crate::job::{Analysis, Body, Job, Material, Quantity};
use crate::report::{Name, Report, StepReport, SubsurfaceReport};

// Okabe and Ito's palette, distinguishable with every kind of colour vision.
const BLUE: RGBColor = RGBColor(0, 114, 178);
const VERMILION: RGBColor = RGBColor(213, 94, 0);
const GREEN: RGBColor = RGBColor(0, 158, 115);
const GREY: RGBColor = RGBColor(110, 110, 110);

/// Points of a closed-form curve.
const SAMPLES: u32 = 400;

/// Draws the contact pressure over x and Hertz's pressure. Load steps are counted from 0.
///
/// # Errors
/// [`ExportError`].
pub fn pressure_svg(job: &Job, report: &Report, step: usize) -> Result<String, ExportError> {
    let step = report.steps.get(step).ok_or(ExportError::NoStep(step))?;
    let (length, stress) =
        (job.units.symbol(Quantity::Length), job.units.symbol(Quantity::Stress));
    let nodes = &step.contact.nodes;
    let mut curves = vec![Curve {
        name: "this contact".to_owned(),
        points: nodes.x.iter().copied().zip(nodes.pressure.iter().copied()).collect(),
        colour: BLUE,
        stroke: Stroke::Solid,
    }];
    curves.extend(hertz(step).map(|hertz| hertz_curve(job, hertz)));
    curves.extend(sections_along_y(job, step));
    if step.contact.section.is_some() {
        "this contact, over x at y = 0".clone_into(&mut curves[0].name);
    }
    let highest = curves.iter().flat_map(|curve| &curve.points).map(|p| p.1).fold(0.0, f64::max);
    let places = || curves.iter().flat_map(|curve| &curve.points).map(|point| point.0);
    let ends =
        (places().fold(f64::INFINITY, f64::min), places().fold(f64::NEG_INFINITY, f64::max));
    let (left, right) = if ends.0 < ends.1 { ends } else { (-1.0, 1.0) };
    let chart = Chart {
        title: "Contact pressure".to_owned(),
        x_label: format!("{} [{length}]", abscissa(job)),
        y_label: format!("pressure [{stress}]"),
        x_range: (left, right),
        y_range: (0.0, if highest > 0.0 { 1.08 * highest } else { 1.0 }),
        curves,
        legend_below: false,
        band: None,
    };
    let maps = step.contact.maps.as_ref();
    maps.map_or_else(|| chart.svg(), |maps| map::svg(maps, "Contact pressure", length, &chart))
}

/// Returns the name of the positions along the surface.
fn abscissa(job: &Job) -> &'static str {
    match job.analysis {
        Analysis::Axisymmetric => "radius r",
        Analysis::ThreeDimensional => "x or y",
        Analysis::PlaneStrain | Analysis::PlaneStress => "x",
    }
}

/// Returns half-width and peak pressure of Hertz's contact.
fn hertz(step: &StepReport) -> Option<[f64; 2]> {
    let elastic = |name: Name| step.row(name)?.elastic;
    let half_width = elastic(Name::HalfWidth).or_else(|| elastic(Name::SemiAxisA));
    Some([half_width?, elastic(Name::PeakPressure)?])
}

/// Returns the pressure over y at x = 0 and Hertz's pressure.
fn sections_along_y(job: &Job, step: &StepReport) -> Vec<Curve> {
    let Some(section) = &step.contact.section else { return Vec::new() };
    let mut curves = vec![Curve {
        name: "over y at x = 0".to_owned(),
        points: section.y.iter().copied().zip(section.pressure.iter().copied()).collect(),
        colour: VERMILION,
        stroke: Stroke::Solid,
    }];
    // Along a roller the pressure of Hertz's line contact is constant.
    let longer = step.row(Name::SemiAxisB).and_then(|row| row.elastic);
    let longer = longer.filter(|_| step.contact.along.is_none());
    if let Some((half_width, [_, peak])) = longer.zip(hertz(step)) {
        let curve = hertz_curve(job, [half_width, peak]);
        curves.push(Curve { name: String::new(), ..curve });
    }
    curves
}

fn hertz_curve(job: &Job, [a, p0]: [f64; 2]) -> Curve {
    let from = if job.analysis == Analysis::Axisymmetric { 0.0 } else { -1.0 };
    let points = (0..=SAMPLES).map(|k| {
        let s = from + (1.0 - from) * f64::from(k) / f64::from(SAMPLES);
        (s * a, p0 * (1.0 - s * s).max(0.0).sqrt())
    });
    Curve {
        name: "Hertz, elastic".to_owned(),
        points: points.collect(),
        colour: GREY,
        stroke: Stroke::Dashed,
    }
}

/// Draws the stresses over depth below the middle of the contact, in the lower body if it deforms.
/// Line contacts have McEwen's elastic stresses too. The plastic region is shaded. Load steps are
/// counted from 0.
///
/// # Errors
/// [`ExportError`].
pub fn depth_svg(job: &Job, report: &Report, step: usize) -> Result<String, ExportError> {
    let step = report.steps.get(step).ok_or(ExportError::NoStep(step))?;
    let bodies = step.subsurface.as_ref().ok_or(ExportError::NoSubsurface)?;
    let (body, profile) = [(&job.lower, &bodies.lower), (&job.upper, &bodies.upper)]
        .into_iter()
        .find_map(|(body, profile)| Some((body, profile.as_ref()?)))
        .ok_or(ExportError::NoSubsurface)?;
    let reach = shown_depth(step, profile);
    let mut curves = Vec::new();
    let (abscissa, names) = match job.analysis {
        Analysis::Axisymmetric => ("r", ["σ_r", "σ_z", "σ_θ"]),
        Analysis::ThreeDimensional => ("x", ["σ_xx", "σ_zz", "σ_yy"]),
        Analysis::PlaneStrain | Analysis::PlaneStress => ("x", ["σ_x", "σ_y", "σ_z"]),
    };
    let stresses =
        [(&profile.sigma_x, BLUE), (&profile.sigma_y, VERMILION), (&profile.sigma_z, GREEN)];
    for (name, (values, colour)) in names.into_iter().zip(stresses) {
        let points = profile.depth.iter().copied().zip(values.iter().copied());
        curves.push(Curve {
            name: format!("{name}, this contact"),
            points: points.take_while(|(depth, _)| *depth <= reach).collect(),
            colour,
            stroke: Stroke::Solid,
        });
    }
    // Yield stress and von Mises stress have the same axis as the other stresses, so that the
    // margin to yield is visible.
    for (name, values) in
        [("von Mises", Some(&profile.von_mises)), ("yield stress", profile.yield_stress.as_ref())]
    {
        let Some(values) = values.filter(|_| profile.yield_stress.is_some()) else { continue };
        let points = profile.depth.iter().copied().zip(values.iter().copied());
        curves.push(Curve {
            name: name.to_owned(),
            points: points.take_while(|(depth, _)| *depth <= reach).collect(),
            colour: RGBColor(60, 60, 60),
            stroke: if name == "von Mises" { Stroke::Solid } else { Stroke::Dashed },
        });
    }
    curves.extend(elastic_curves(job, body, step, reach));
    let values = || curves.iter().flat_map(|curve| &curve.points).map(|p| p.1);
    let (lowest, highest) = (values().fold(0.0, f64::min), values().fold(0.0, f64::max));
    let margin = 0.06 * (highest - lowest).max(f64::MIN_POSITIVE);
    let (length, stress) =
        (job.units.symbol(Quantity::Length), job.units.symbol(Quantity::Stress));
    Chart {
        title: if step.value(Name::Force) > Some(0.0) {
            "Stresses below the contact"
        } else {
            "Residual stresses"
        }
        .to_owned(),
        x_label: format!(
            "depth [{length}] below {abscissa} = {} {length}",
            short(profile.position.first().copied().unwrap_or_default())
        ),
        y_label: format!("stress, tension positive [{stress}]"),
        x_range: (0.0, reach),
        y_range: (lowest - margin, highest + margin),
        curves,
        legend_below: true,
        band: plastic_band(profile).map(|band| (band, "plastic".to_owned())),
    }
    .svg()
}

/// Returns a value in four digits.
fn short(value: f64) -> f64 {
    format!("{value:.3e}").parse().map_or(value, |short: f64| short + 0.0)
}

/// Returns the depth of the chart: four half-widths or, without contact, 1.5 times the depth of
/// the plastic region; at most the depth of the profile.
fn shown_depth(step: &StepReport, profile: &SubsurfaceReport) -> f64 {
    let deepest = profile.depth.last().copied().unwrap_or(1.0);
    let half_width = step.value(Name::HalfWidth).or_else(|| step.value(Name::SemiAxisA));
    let half_width = half_width.unwrap_or_default();
    let wanted = if half_width > 0.0 {
        Some(4.0 * half_width)
    } else {
        plastic_band(profile).map(|band| 1.5 * band.1)
    };
    wanted.filter(|wanted| *wanted > 0.0).map_or(deepest, |wanted| deepest.min(wanted))
}

/// Distance of two points of a loop, as a fraction of the range of forces, above which the line
/// between them is dashed.
const FAR: f64 = 0.25;

/// Draws force over approach of all increments or loads in their order. A history with unloading
/// draws a loop.
///
/// # Errors
/// [`ExportError::NoCurve`] for fewer than two converged loads.
pub fn load_approach_svg(job: &Job, report: &Report) -> Result<String, ExportError> {
    let curve = report.load_approach.as_ref().ok_or(ExportError::NoCurve)?;
    let points: Vec<(f64, f64)> =
        curve.approach.iter().copied().zip(curve.force.iter().copied()).collect();
    let (x_range, y_range) =
        (range(points.iter().map(|p| p.0)), range(points.iter().map(|p| p.1)));
    let force = job.analysis.force().symbol(job.units);
    Chart {
        title: "Force over approach".to_owned(),
        x_label: format!("approach [{}]", job.units.symbol(Quantity::Length)),
        y_label: format!("force [{force}]"),
        x_range,
        y_range,
        curves: loop_curves(&points),
        legend_below: true,
        band: None,
    }
    .svg()
}

/// Returns the pieces of a curve. If the force falls anywhere, long pieces are dashed: unloading
/// is often a single increment, and the straight line between its ends is not computed.
fn loop_curves(points: &[(f64, f64)]) -> Vec<Curve> {
    let forces = || points.iter().map(|point| point.1);
    let span = forces().fold(0.0, f64::max) - forces().fold(f64::INFINITY, f64::min);
    let turns = points.windows(2).any(|pair| pair[1].1 < pair[0].1);
    let is_far = |from: &(f64, f64), to: &(f64, f64)| turns && (to.1 - from.1).abs() > FAR * span;
    let curve = |name: &str, points: Vec<(f64, f64)>, stroke| Curve {
        name: name.to_owned(),
        points,
        colour: BLUE,
        stroke,
    };
    let solid = points.chunk_by(|from, to| !is_far(from, to)).filter(|run| run.len() > 1);
    let dashed = points.windows(2).filter(|pair| is_far(&pair[0], &pair[1]));
    let mut curves: Vec<Curve> = solid.map(|run| curve("", run.to_vec(), Stroke::Solid)).collect();
    let count = curves.len();
    // All pieces start at their lower end, so that the dashes of overlapping pieces coincide.
    let from_below = |pair: &[(f64, f64)]| {
        let mut pair = pair.to_vec();
        pair.sort_by(|a, b| a.1.total_cmp(&b.1));
        pair
    };
    curves.extend(dashed.map(|pair| curve("", from_below(pair), Stroke::Dashed)));
    // The legend has one entry for each line style.
    let (solid, dashed) = curves.split_at_mut(count);
    for (kind, name) in [(solid, "this contact"), (dashed, "nothing solved between")] {
        if let Some(first) = kind.first_mut() {
            name.clone_into(&mut first.name);
        }
    }
    curves
}

/// Draws the height of the surface of each body over x, outward from the undeformed surface.
/// Without force it shows the dent and the pile-up. Load steps are counted from 0.
///
/// # Errors
/// [`ExportError::NoStep`]; [`ExportError::NoFlow`] under deformation theory and
/// [`ExportError::Rolling`] of a load that rolls.
pub fn surface_svg(job: &Job, report: &Report, step: usize) -> Result<String, ExportError> {
    let step = report.steps.get(step).ok_or(ExportError::NoStep(step))?;
    let surfaces = step.surfaces.as_ref().ok_or_else(|| ExportError::without_flow(step))?;
    let curves: Vec<Curve> =
        [("upper body", &surfaces.upper, VERMILION), ("lower body", &surfaces.lower, BLUE)]
            .into_iter()
            .filter_map(|(name, surface, colour)| {
                let surface = surface.as_ref()?;
                let points =
                    surface.x.iter().copied().zip(surface.height.iter().copied()).collect();
                // Equal bodies have equal surfaces: a dashed second curve shows the first one
                // below.
                let stroke = if name == "lower body" { Stroke::Dashed } else { Stroke::Solid };
                Some(Curve { name: name.to_owned(), points, colour, stroke })
            })
            .collect();
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let (x_range, y_range) = (range(points().map(|p| p.0)), range(points().map(|p| p.1)));
    let length = job.units.symbol(Quantity::Length);
    let is_dent = step.value(Name::Force) == Some(0.0);
    Chart {
        title: if is_dent { "Residual profile" } else { "Surfaces under load" }.to_owned(),
        x_label: format!("{} [{length}]", abscissa(job)),
        y_label: format!("height over the undeformed surface [{length}]"),
        x_range,
        y_range,
        curves,
        legend_below: true,
        band: None,
    }
    .svg()
}

/// Returns the range of values and zero, with a margin.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) =
        values.fold((0.0, 0.0), |(low, high), v| (f64::min(low, v), f64::max(high, v)));
    let margin = 0.06 * (high - low);
    if margin > 0.0 { (low - margin, high + margin) } else { (-1.0, 1.0) }
}

/// Returns the smallest and the largest depth with plastic strain.
fn plastic_band(profile: &SubsurfaceReport) -> Option<(f64, f64)> {
    let most = profile.equivalent_plastic_strain.iter().copied().fold(0.0, f64::max);
    let plastic = || {
        let pairs = profile.depth.iter().zip(&profile.equivalent_plastic_strain);
        pairs
            .filter(move |(_, strain)| **strain > 1e-3 * most && **strain > 0.0)
            .map(|(depth, _)| *depth)
    };
    Some((plastic().next()?, plastic().next_back()?))
}

fn elastic_curves(job: &Job, body: &Body, step: &StepReport, reach: f64) -> Vec<Curve> {
    let (Some([half_width, peak]), Material::Deformable(material)) = (hertz(step), &body.material)
    else {
        return Vec::new();
    };
    let poisson = match job.analysis {
        Analysis::PlaneStrain => material.elastic.poisson_ratio.get(),
        Analysis::PlaneStress => 0.0,
        Analysis::Axisymmetric | Analysis::ThreeDimensional => return Vec::new(),
    };
    // a = 2 R p0 / E*, so that R = a and E* = 2 p0 give this half-width and peak pressure.
    let field = HertzLine::from_peak_pressure(peak, half_width, 2.0 * peak);
    let sample = |k: u32| {
        let depth = reach * f64::from(k) / f64::from(SAMPLES);
        (depth, field.stress_on_axis(depth, poisson))
    };
    let curve = |colour, name: &str, component: fn(&crate::analytical::Stress) -> f64| Curve {
        name: name.to_owned(),
        points: (0..=SAMPLES)
            .map(sample)
            .map(|(depth, stress)| (depth, component(&stress)))
            .collect(),
        colour,
        stroke: Stroke::Dashed,
    };
    vec![
        curve(BLUE, "elastic (McEwen)", |stress| stress.sigma_x),
        curve(VERMILION, "", |stress| stress.sigma_y),
        curve(GREEN, "", |stress| stress.sigma_z),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report;
    use crate::solver::Unobserved;

    #[test]
    fn figures_show_both_curves_with_their_units() {
        let job = Job::from_json(include_bytes!("../../../../../api/examples/two_cylinders.json"))
            .unwrap();
        let report = report::run(&job, &mut Unobserved).unwrap();
        let pressure = pressure_svg(&job, &report, 0).unwrap();
        for text in ["<svg", "pressure [MPa]", "x [mm]", "Hertz, elastic", "this contact"] {
            assert!(pressure.contains(text), "{text}");
        }
        let depth = depth_svg(&job, &report, 0).unwrap();
        for text in ["depth [mm] below x = 0 mm", "σ_x", "σ_y", "σ_z", "plastic", "McEwen"] {
            assert!(depth.contains(text), "{text}");
        }
        assert_eq!(pressure_svg(&job, &report, 1), Err(ExportError::NoStep(1)));
    }
}
