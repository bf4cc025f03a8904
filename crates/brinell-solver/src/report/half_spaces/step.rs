//! Steps of half-spaces as a report shows them.

use super::document::{
    EllipseErrors, EllipticHertzReport, MapsReport, RollerReport, RoughContactReport,
    SectionReport, ThreeDimensionalReport,
};
use super::estimate::estimate;
use super::findings::{findings, largest_strain};
use super::flow::FlowState;
use super::layers::layers;
use super::measured::measured;
use super::sections::{middle, section_along_x, section_along_y};
use super::{seats, spots};
use crate::contact::ContactLoad;
use crate::inputs::SolveError;
use crate::job::{Deformable, Job, Load, Material, Quantity};
use crate::report::cost::JobEstimate;
use crate::report::error_bars::BESIDE;
use crate::report::findings::{Finding, Known};
use crate::report::shown::{Arrays, Parts, Shown, Solved};
use crate::report::{
    BodyErrors, ContactNodes, ContactReport, ErrorEstimate, HertzReport, MeshReport, Patch,
    PerBody, PlasticityReport, Side, SubsurfaceReport, YieldOnsetReport,
};
use crate::solver::half_spaces::{
    self, ColumnPoint, EllipticReference, HalfSpaceBody, HalfSpaceField, HalfSpaceProblem,
    HalfSpaceRun, HalfSpaceStep, Row, target_error, target_figure, von_mises,
};
use crate::solver::method::figures::{Figure, Values};
use crate::solver::{Interrupt, Observer, Options, SLOPE_ERROR, StepReceiver};
use crate::units::UnitConverter;

/// Relative error of an onset of yield in closed form, which is sought over some hundred depths.
const CLOSED_FORM: f64 = 1e-3;
/// Relative difference of semi-axes that are one radius.
const ALIKE: f64 = 1e-9;
/// Fractions of the contact area for which the quantile of the pressure is reported.
const QUANTILES: [f64; 7] = [0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95];

/// Two half-spaces.
pub(in crate::report) struct HalfSpaces<'a> {
    job: &'a Job,
    write: UnitConverter,
    problem: HalfSpaceProblem,
    reference: EllipticReference,
    /// Angle from the x of the job to the x of the fields \[rad\].
    orientation: f64,
}

impl Shown for HalfSpaces<'_> {
    type Field = HalfSpaceField;
    type Memory = FlowState;

    fn job(&self) -> &Job {
        self.job
    }

    fn cost(&self) -> Result<JobEstimate, SolveError> {
        Ok(estimate(self.job, &self.problem)?)
    }

    fn solve(
        &self,
        _: Options<'_>,
        observer: &mut dyn Observer,
        receiver: &mut dyn StepReceiver<HalfSpaceField>,
    ) -> Result<Solved, SolveError> {
        let HalfSpaceRun { phases, grids, interrupted, sensitivity } =
            half_spaces::run_each(&self.problem, observer, receiver)?;
        Ok(Solved { phases, passes: grids, interrupted, sensitivity })
    }

    fn arrays(&self, step: &HalfSpaceStep, _: &mut dyn Observer) -> Result<Arrays, Interrupt> {
        let bodies = &step.field.bodies;
        let [subsurface, below_peak] = self.subsurface(step);
        Ok(Arrays {
            subsurface,
            below_peak,
            plasticity: PerBody::of(bodies, |body, side| self.plasticity(body, side)),
            fields: None,
            layers: (self.job.output.fields)
                .then(|| PerBody::of(bodies, |body, _| layers(body, self.write))),
        })
    }

    fn findings(&self, step: &HalfSpaceStep) -> Vec<Finding> {
        findings(self.job, &self.problem, step)
    }

    fn parts(&self, memory: &mut FlowState, step: &HalfSpaceStep, findings: &[Finding]) -> Parts {
        let (job, problem, reference) = (self.job, &self.problem, &self.reference);
        let known = Known::of_job(job, findings);
        let stiffness = self.elastic_stiffness(step).or(step.contact_stiffness);
        let stiffness = stiffness.filter(|_| !step.status.is_stopped());
        Parts {
            contact: self.contact(step),
            stiffness,
            spacing: Some(step.field.surface.grid.hx()),
            flow: memory.report(job, step, reference, self.write),
            hertz: self.hertz(step),
            yield_onset: self.yield_onset(step, known),
            bars: self.estimated_error(step, stiffness, known),
            three_dimensional: self.three_dimensional(step, known),
            rolling: None,
            measured: measured(job, problem, reference, step, findings),
            target: self.target(step),
            indentation: None,
            leaves_unknown: job.has_memory(),
        }
    }

    fn mesh(&self, step: &HalfSpaceStep) -> MeshReport {
        let grid = &step.field.surface.grid;
        let cells = grid.n_cells();
        let bodies = || step.field.bodies.iter().flatten();
        MeshReport {
            spacing: self.write.length(grid.hx()),
            contact_pairs: cells,
            nodes: cells,
            elements: bodies().map(|body| cells * body.layers.len()).sum(),
            equations: cells
                + bodies().map(|body| 5 * body.equivalent_plastic_strain.len()).sum::<usize>(),
            max_aspect_ratio: (grid.hy() / grid.hx()).max(grid.hx() / grid.hy()),
            ..MeshReport::default()
        }
    }
}

impl<'a> HalfSpaces<'a> {
    pub fn new(job: &'a Job, (problem, reference): (HalfSpaceProblem, EllipticReference)) -> Self {
        let write = UnitConverter::new(job.units, job.analysis);
        Self { job, write, orientation: problem.orientation(), problem, reference }
    }

    /// Returns the elastic contact of the same bodies.
    fn hertz(&self, step: &HalfSpaceStep) -> Option<HertzReport> {
        let (write, reference) = (self.write, &self.reference);
        let (hertz, limit) = (step.field.hertz?, reference.rolling());
        Some(HertzReport {
            half_width: write.length(hertz.semi_axis_x),
            peak_pressure: write.stress(hertz.peak_pressure),
            yield_onset_force: reference.onset_force().map(|force| write.force(force)),
            yield_onset_depth: reference.onset_depth().map(|depth| write.length(depth)),
            shakedown_pressure: limit.map(|limit| write.stress(limit.peak_pressure)),
            shakedown_depth: limit.map(|limit| write.length(limit.depth)),
            shakedown_over_friction: Vec::new(),
        })
    }

    /// Returns the figure that a target asks for, and its relative error under the force that was
    /// found: the error of the force follows from it.
    fn target(&self, step: &HalfSpaceStep) -> Option<(f64, Option<f64>)> {
        let Load::Target(target) = &self.job.load else { return None };
        let errors = half_spaces::errors(step, None);
        let error = errors.and_then(|errors| target_error(step, &errors, target.figure));
        Some((target_figure(&step.figures, target.figure), error))
    }

    fn contact(&self, step: &HalfSpaceStep) -> ContactReport {
        let (write, figures, map) = (self.write, &step.figures, &step.field.surface);
        let [a, _] = ordered(figures.semi_axes());
        let touches = figures.force > 0.0;
        let area = figures.contact_area.filter(|_| touches);
        let pressure = section_along_x(map, &map.pressure);
        let cell = map.grid.cell_area();
        // Of inclined forces the force is a part.
        let borne = if self.problem.conformity.is_conforming() {
            cell * map.pressure.iter().sum::<f64>()
        } else {
            figures.force
        };
        let places = (0..map.grid.nx()).map(|i| write.length(map.grid.x(i)));
        ContactReport {
            force: write.force(figures.force),
            half_width: write.length(a),
            half_angle: None,
            peak_pressure: write.stress(figures.peak_pressure),
            peak_position: write.length(step.field.peak_position[0]),
            middle_pressure: figures.middle_pressure.map(|pressure| write.stress(pressure)),
            mean_pressure: area.map_or(0.0, |area| write.stress(borne / area)),
            patches: touches
                .then(|| Patch { left: write.length(-a), right: write.length(a) })
                .into_iter()
                .collect(),
            nodes: ContactNodes {
                x: places.collect(),
                force: pressure.iter().map(|pressure| write.force(pressure * cell)).collect(),
                pressure: pressure.iter().map(|pressure| write.stress(*pressure)).collect(),
                gap: section_along_x(map, &map.gap).iter().map(|gap| write.length(*gap)).collect(),
            },
        }
    }

    /// Returns the onset of yield if the job asks for it.
    fn yield_onset(&self, step: &HalfSpaceStep, known: Known) -> Option<YieldOnsetReport> {
        if self.job.load != Load::Onset || !known.has_estimate() {
            return None;
        }
        let (write, force) = (self.write, step.figures.force);
        let closed = self.problem.onset.and_then(|_| self.reference.utilization(force));
        let (side, [x, depth]) = if let Some((_, depth, side)) = closed {
            (side, [0.0, depth])
        } else {
            let first = self.problem.highest_utilization(step)?;
            (first.side, [first.position[0], first.position[2]])
        };
        Some(YieldOnsetReport {
            force: write.force(force),
            approach: write.length(step.figures.approach),
            peak_pressure: write.stress(step.figures.peak_pressure),
            body: if side == 0 { Side::Upper } else { Side::Lower },
            position: write.length(x),
            depth: write.length(depth),
        })
    }

    /// Returns dP/dα at a constant contact area \[N/mm\] of bodies that do not flow.
    fn elastic_stiffness(&self, step: &HalfSpaceStep) -> Option<f64> {
        let is_known = !(step.status.is_stopped() || step.path.flows);
        is_known.then(|| self.reference.stiffness(step))
    }

    fn three_dimensional(
        &self,
        step: &HalfSpaceStep,
        known: Known,
    ) -> Option<ThreeDimensionalReport> {
        let (write, figures, map) = (self.write, &step.figures, &step.field.surface);
        let lengths =
            |values: &[f64]| -> Vec<f64> { values.iter().map(|x| write.length(*x)).collect() };
        let stresses =
            |values: &[f64]| -> Vec<f64> { values.iter().map(|p| write.stress(*p)).collect() };
        let y: Vec<f64> = (0..map.grid.ny()).map(|j| write.length(map.grid.y(j))).collect();
        Some(ThreeDimensionalReport {
            orientation: self.orientation.to_degrees(),
            a: write.length(ordered(figures.semi_axes())[0]),
            b: write.length(ordered(figures.semi_axes())[1]),
            area: write.area(figures.contact_area?),
            largest_cell_pressure: write.stress(step.field.largest_cell_pressure),
            peak_position_y: write.length(step.field.peak_position[1]),
            hertz: step.field.hertz.map(|hertz| EllipticHertzReport {
                a: write.length(hertz.semi_axis_x),
                b: write.length(hertz.semi_axis_y),
                approach: write.length(hertz.approach),
            }),
            roller: self.roller(step),
            surface: self.rough_contact(step),
            section: SectionReport {
                y: y.clone(),
                pressure: stresses(&section_along_y(map, &map.pressure)),
                gap: lengths(&section_along_y(map, &map.gap)),
            },
            maps: (self.job.output.fields && !step.status.is_stopped()).then(|| MapsReport {
                x: (0..map.grid.nx()).map(|i| write.length(map.grid.x(i))).collect(),
                y,
                pressure: stresses(&map.pressure),
                gap: lengths(&map.gap),
                dent: dent(step).map(|dent| lengths(&dent)),
            }),
            estimated_error: self.ellipse_errors(step, known),
        })
    }

    /// Returns the report of a contact of heights.
    fn rough_contact(&self, step: &HalfSpaceStep) -> Option<RoughContactReport> {
        let contact_ratio = step.figures.contact_ratio?;
        let (write, map) = (self.write, &step.field.surface);
        let all = map.grid.cell_area() * map.grid.n_cells() as f64;
        let mut pressures: Vec<f64> = map.pressure.iter().copied().filter(|p| *p > 0.0).collect();
        pressures.sort_by(f64::total_cmp);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a part of a length"
        )]
        let at = |part: f64| pressures.get((part * pressures.len() as f64) as usize).copied();
        let quantiles = QUANTILES.iter().filter_map(|part| at(*part));
        Some(RoughContactReport {
            contact_ratio,
            nominal_pressure: write.stress(step.figures.force / all),
            parts: QUANTILES.to_vec(),
            pressure_quantiles: quantiles.map(|pressure| write.stress(pressure)).collect(),
            plastic_part: plastic_part(step),
        })
    }

    /// Returns the rows of cells between the ends of a roller.
    fn roller(&self, step: &HalfSpaceStep) -> Option<RollerReport> {
        let (half_length, write) = (self.problem.half_length()?, self.write);
        let map = &step.field.surface;
        let rows = Row::all(&map.grid, &map.pressure).into_iter().enumerate();
        let rows =
            rows.map(|(j, row)| (map.grid.y(j), row)).filter(|(y, _)| y.abs() < half_length);
        let (y, rows): (Vec<f64>, Vec<Row>) = rows.unzip();
        let pressure: Vec<f64> =
            rows.iter().map(|row| write.stress(row.largest_pressure)).collect();
        let [low, high] = middle(rows.len());
        let reaches_ends = half_length - y.last()? < map.grid.hy();
        let moment =
            y.iter().zip(&rows).map(|(y, row)| y * row.line_load * map.grid.hy()).sum::<f64>();
        let at_end = |end: Option<&f64>| end.copied().filter(|_| reaches_ends).unwrap_or_default();
        Some(RollerReport {
            y: y.iter().map(|y| write.length(*y)).collect(),
            line_load: rows
                .iter()
                .map(|row| write.figure(Quantity::LineForce, row.line_load))
                .collect(),
            half_width: rows.iter().map(|row| write.length(row.half_width)).collect(),
            moment: write.length(write.force(moment)),
            tilt: 1e3 * step.field.tilt,
            middle_pressure: pressure[low].max(pressure[high]),
            end_pressure: [at_end(pressure.first()), at_end(pressure.last())],
            pressure,
        })
    }

    fn plasticity(&self, body: &HalfSpaceBody, side: usize) -> PlasticityReport {
        let write = self.write;
        let most = body.largest_strain;
        let [x, y, depth] = most.map_or([0.0; 3], |most| most.position);
        let section = body.plastic_section;
        PlasticityReport {
            yielded: most.is_some(),
            max_equivalent_plastic_strain: largest_strain(self.job, body, side),
            mean_equivalent_plastic_strain: section.mean_strain,
            position: write.length(x),
            depth: write.length(depth),
            area: write.area(section.area),
            reached_surface: section.reaches_surface,
            outline: Vec::new(),
            position_y: Some(write.length(y)),
            volume: Some(write.length(write.area(body.plastic_volume))),
        }
    }

    /// Returns the stresses below the middle of the contact, and below a peak pressure off the
    /// middle.
    fn subsurface(&self, step: &HalfSpaceStep) -> [Option<PerBody<Option<SubsurfaceReport>>>; 2] {
        if !self.job.output.subsurface {
            return [None, None];
        }
        let below = |place: [f64; 2]| {
            PerBody::of(&step.field.bodies, |body, side| self.profile(body, side, place))
        };
        let is_beside = step
            .field
            .peak_position
            .iter()
            .zip([step.field.surface.grid.hx(), step.field.surface.grid.hy()]);
        let is_beside = is_beside.into_iter().any(|(x, side)| x.abs() > side);
        [Some(below([0.0; 2])), is_beside.then(|| below(step.field.peak_position))]
    }

    fn profile(&self, body: &HalfSpaceBody, side: usize, place: [f64; 2]) -> SubsurfaceReport {
        let write = self.write;
        let points = body.column(place);
        let column = |of: &dyn Fn(&ColumnPoint) -> f64| -> Vec<f64> {
            points.iter().map(|point| write.figure(Quantity::Stress, of(point))).collect()
        };
        let component = |k: usize| column(&|point: &ColumnPoint| point.stress[k]);
        let material = match &[&self.job.upper, &self.job.lower][side].material {
            Material::Deformable(material) => Some(material),
            Material::Rigid => None,
        };
        let limits = material.and_then(|material| strengths(material, &points));
        let initial = material.filter(|material| !material.initial_stress().is_empty());
        let initial = initial.map(|material| self.initial_stress(material, &points));
        let of_initial = |k: usize| initial.as_ref().map(|columns| columns[k].clone());
        SubsurfaceReport {
            position: Some(write.length(place[0])),
            position_y: Some(write.length(place[1])),
            depth: points.iter().map(|point| write.length(point.depth)).collect(),
            sigma_x: component(0),
            sigma_y: component(2),
            sigma_z: component(1),
            sigma_xx: Some(component(0)),
            sigma_yy: Some(component(1)),
            sigma_zz: Some(component(2)),
            sigma_xy: Some(component(3)),
            sigma_xz: Some(component(4)),
            sigma_yz: Some(component(5)),
            tau_max: column(&|point| largest_shear(point.stress)),
            von_mises: column(&|point| von_mises(point.stress)),
            equivalent_plastic_strain: points
                .iter()
                .map(|point| point.equivalent_plastic_strain)
                .collect(),
            utilization: limits.as_ref().map(|limits| {
                points
                    .iter()
                    .zip(limits)
                    .map(|(point, limit)| von_mises(point.stress) / limit)
                    .collect()
            }),
            yield_stress: limits
                .map(|limits| limits.iter().map(|limit| write.stress(*limit)).collect()),
            initial_sigma_x: of_initial(0),
            initial_sigma_y: of_initial(1),
            initial_sigma_z: of_initial(2),
        }
    }

    /// Returns the stresses before the load, `[along x, normal, along y]`.
    fn initial_stress(&self, material: &Deformable, points: &[ColumnPoint]) -> [Vec<f64>; 3] {
        let profile = material.initial_stress_profile();
        let (sine, cosine) = self.orientation.sin_cos();
        let at = |depth: f64| {
            let [x, y] = profile.at(depth);
            [cosine * cosine * x + sine * sine * y, 0.0, sine * sine * x + cosine * cosine * y]
        };
        let column =
            |k: usize| points.iter().map(|point| self.write.stress(at(point.depth)[k])).collect();
        std::array::from_fn(column)
    }

    /// Returns the absolute errors of the figures.
    fn errors(&self, step: &HalfSpaceStep) -> Option<Values> {
        let sought = match &self.job.load {
            Load::Target(target) => Some(target.figure),
            _ => None,
        };
        half_spaces::errors(step, sought)
    }

    fn estimated_error(
        &self,
        step: &HalfSpaceStep,
        stiffness: Option<f64>,
        known: Known,
    ) -> Option<ErrorEstimate> {
        let errors = self.relative_errors(step, known)?;
        let of = |figure: Figure| errors.get(figure, 0);
        let of_stiffness = match (self.elastic_stiffness(step), stiffness) {
            // The stiffness of elastic bodies is proportional to the contact size.
            (Some(_), _) => of(Figure::ContactArea).map(|error| 0.5 * error),
            (None, Some(_)) => Some(SLOPE_ERROR),
            (None, None) => None,
        };
        let peak = known.bar(Figure::PeakPressure, 0, of(Figure::PeakPressure));
        let [x, y] = step.field.peak_position;
        let grid = &step.field.surface.grid;
        let is_peak_in_middle = x.abs() < BESIDE * grid.hx() && y.abs() < BESIDE * grid.hy();
        let middle = known
            .bar(Figure::MiddlePressure, 0, of(Figure::MiddlePressure))
            .filter(|_| peak.is_some() || !is_peak_in_middle);
        let of_spots = spots::error_of_approach(&self.problem, step);
        let of_spots = match step.load {
            ContactLoad::Force(_) => [of_spots, 0.0],
            ContactLoad::Approach(_) => [0.0, of_spots],
        };
        let approach = of(Figure::Approach).map(|error| error + of_spots[0]);
        Some(ErrorEstimate {
            peak_pressure: peak,
            middle_pressure: middle,
            half_width: self.semi_axis_error(step, Figure::HalfWidth),
            approach: match step.load {
                ContactLoad::Force(_) => known.bar(Figure::Approach, 0, approach),
                ContactLoad::Approach(_) => Some(0.0),
            },
            // The stress at the onset of yield is proportional to the cube root of the force.
            force: match self.job.load {
                Load::Onset if self.problem.onset.is_some() => {
                    Some(CLOSED_FORM + seats::error_of_onset(self.job, self.orientation, step))
                }
                Load::Onset => peak.map(|peak| 3.0 * peak),
                _ => of(Figure::Force).map(|error| error + of_spots[1]),
            },
            contact_stiffness: of_stiffness,
            bodies: None,
        })
    }

    /// Returns the relative error of a semi-axis, or `None` for heights: single asperities bound
    /// their contact. A circle has one radius, with the larger error of both.
    fn semi_axis_error(&self, step: &HalfSpaceStep, axis: Figure) -> Option<f64> {
        let errors = self.errors(step).filter(|_| self.problem.heights.is_none())?;
        let errors = errors.zip(&step.figures.values(), relative);
        let is_circle = step.field.hertz.is_some_and(|hertz| {
            (hertz.semi_axis_x - hertz.semi_axis_y).abs() <= ALIKE * hertz.semi_axis_x
        });
        let of = |axis: Figure| errors.get(axis, 0);
        if is_circle && self.problem.rollers.is_empty() {
            return of(Figure::HalfWidth).zip(of(Figure::SemiAxisY)).map(|(a, b)| a.max(b));
        }
        of(axis)
    }

    /// Returns the relative errors of the figures; `None` where a finding takes the estimate away.
    fn relative_errors(&self, step: &HalfSpaceStep, known: Known) -> Option<Values> {
        let errors = self.errors(step).filter(|_| known.has_estimate())?;
        Some(errors.zip(&step.figures.values(), relative))
    }

    fn ellipse_errors(&self, step: &HalfSpaceStep, known: Known) -> Option<EllipseErrors> {
        let errors = self.relative_errors(step, known)?;
        let of = |side: usize| {
            let part = |figure: Figure| known.bar(figure, side, errors.get(figure, side));
            let without_load = |figure: Figure| part(figure).filter(|_| step.figures.force <= 0.0);
            step.field.bodies[side].as_ref().map(|_| BodyErrors {
                max_equivalent_plastic_strain: part(Figure::MaxPlasticStrain),
                mean_equivalent_plastic_strain: None,
                area: None,
                depth: without_load(Figure::Dent),
                pile_up: without_load(Figure::PileUp),
                least_stress: without_load(Figure::LeastStress),
                utilization: None,
            })
        };
        Some(EllipseErrors {
            b: self.semi_axis_error(step, Figure::SemiAxisY),
            area: errors.get(Figure::ContactArea, 0)?,
            bodies: PerBody { upper: of(0), lower: of(1) },
        })
    }
}

/// Returns the fraction of the cells in contact below which a body has yielded, or `None` if no
/// body can yield.
fn plastic_part(step: &HalfSpaceStep) -> Option<f64> {
    let n_cells = step.field.surface.pressure.len();
    let touched: Vec<usize> =
        (0..n_cells).filter(|cell| step.field.surface.pressure[*cell] > 0.0).collect();
    let strains =
        || step.field.bodies.iter().flatten().map(|body| &body.equivalent_plastic_strain);
    let below =
        |cell: usize| strains().flat_map(move |strain| strain.iter().skip(cell).step_by(n_cells));
    let plastic = touched.iter().filter(|cell| below(**cell).any(|strain| *strain > 0.0)).count();
    let part = if plastic > 0 { plastic as f64 / touched.len() as f64 } else { 0.0 };
    strains().any(|strain| !strain.is_empty()).then_some(part)
}

/// Returns two semi-axes, the shorter one first. An initial stress along one axis may make the
/// contact longer along the axis with the larger curvature of the gap.
fn ordered([x, y]: [f64; 2]) -> [f64; 2] {
    [x.min(y), x.max(y)]
}

fn relative(error: f64, figure: f64) -> f64 {
    if figure == 0.0 { 0.0 } else { (error / figure).abs() }
}

/// Returns the displacement of both surfaces by plastic strain in every cell \[mm\], or `None` if
/// no body can yield.
fn dent(step: &HalfSpaceStep) -> Option<Vec<f64>> {
    let mut bodies =
        step.field.bodies.iter().flatten().filter(|body| body.plastic_strain.is_some());
    let mut dent = bodies.next()?.plastic_displacement.clone();
    for body in bodies {
        for (sum, displacement) in dent.iter_mut().zip(&body.plastic_displacement) {
            *sum += displacement;
        }
    }
    Some(dent)
}

/// Returns the yield stresses at the depths of the points, or `None` for a constant strength.
fn strengths(material: &Deformable, points: &[ColumnPoint]) -> Option<Vec<f64>> {
    let (strength, nominal) =
        (material.strength()?, material.hardening_law()?.nominal_yield_stress());
    Some(points.iter().map(|point| nominal * strength.factor(point.depth)).collect())
}

/// Returns half the difference of the extreme principal stresses, from the Lode angle.
fn largest_shear(stress: [f64; 6]) -> f64 {
    let [xx, yy, zz, xy, xz, yz] = stress;
    let equivalent = von_mises(stress);
    if equivalent == 0.0 {
        return 0.0;
    }
    let mean = (xx + yy + zz) / 3.0;
    let [x, y, z] = [xx - mean, yy - mean, zz - mean];
    let third = x * (y * z - yz * yz) - xy * (xy * z - yz * xz) + xz * (xy * yz - y * xz);
    let angle = (13.5 * third / equivalent.powi(3)).clamp(-1.0, 1.0).acos() / 3.0;
    // The principal deviators are 2/3 q cos θ and 2/3 q cos(θ ± 120°).
    let turn = 2.0 * std::f64::consts::FRAC_PI_3;
    (equivalent / 3.0) * (angle.cos() - (angle + turn).cos().min((angle - turn).cos()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_shear_is_half_the_difference_of_principal_stresses() {
        for (stress, expected) in [
            ([300.0, 100.0, -500.0, 0.0, 0.0, 0.0], 400.0),
            ([0.0, 0.0, 0.0, 70.0, 0.0, 0.0], 70.0),
            ([0.0, 0.0, 0.0, 0.0, -70.0, 0.0], 70.0),
            ([0.0; 6], 0.0),
            ([100.0, 40.0, 40.0, 0.0, 0.0, 0.0], 30.0),
            // Principal stresses 100, 40 and -150.
            ([40.0, -60.0, 10.0, 0.0, 0.0, 120.0], 125.0),
        ] {
            let found = largest_shear(stress);
            assert!((found - expected).abs() < 1e-6, "{stress:?} {found}");
        }
    }
}
