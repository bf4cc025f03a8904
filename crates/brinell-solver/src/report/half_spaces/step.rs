//! Steps of half-spaces as a report shows them.

use brinell_halfspace::Stop;

use super::document::{MapsReport, PressureQuantiles, RollerReport, SectionReport};
use super::estimate::estimate;
use super::findings::{findings, has_kinks, largest_strain, roller_end};
use super::flow::{FlowState, surfaces};
use super::layers::layers;
use super::measured::measured;
use super::sections::{middle, section_along_x, section_along_y};
use super::{seats, spots};
use crate::contact::ContactLoad;
use crate::fatigue::not_smooth;
use crate::inputs::SolveError;
use crate::job::{Job, Load, Quantity};
use crate::report::cost::JobEstimate;
use crate::report::error_bars::BESIDE;
use crate::report::fatigue;
use crate::report::findings::{Finding, Known};
use crate::report::known::ErrorEstimate;
use crate::report::known::{self, Hertz, Onset, RollerFigures, Rough, Whole, Zone};
use crate::report::shown::{Arrays, Parts, Shown, Solved};
use crate::report::subsurface::below;
use crate::report::{
    ContactNodes, ContactReport, IncrementsReport, MeshReport, Patch, PerBody, PlasticityReport,
    SubsurfaceReport,
};
use crate::solver::half_spaces::{
    self, EllipticReference, HalfSpaceBody, HalfSpaceField, HalfSpaceProblem, HalfSpaceRun,
    HalfSpaceStep, Row, target_error, target_figure,
};
use crate::solver::method::figures::{Figure, ROUNDING, Values};
use crate::solver::{Interrupt, Observer, Options, SLOPE_ERROR, StepReceiver};
use crate::units::UnitConverter;

/// Relative error of an onset of yield in closed form, which is sought over some hundred depths.
const CLOSED_FORM: f64 = 1e-3;
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

    fn arrays(
        &self,
        step: &HalfSpaceStep,
        observer: &mut dyn Observer,
    ) -> Result<Arrays, Interrupt> {
        let (field, bodies) = (&step.field, &step.field.bodies);
        let of = |side: usize, stop: &mut Stop<'_>| field.fatigue(&self.problem, side, stop);
        let fatigue = if step.figures.force > 0.0 {
            let refused = self.without_fatigue(step);
            fatigue::of_pressed(self.job, self.is_alike(step), refused, observer, of)?
        } else {
            Vec::new()
        };
        let [subsurface, below_peak] = self.subsurface(step);
        Ok(Arrays {
            subsurface,
            below_peak,
            plasticity: PerBody::of(bodies, |_, _| PlasticityReport::default()),
            covers: [None; 2],
            fatigue,
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
        let (flow, heights) = memory.next(job, step, reference).unzip();
        let touches = step.figures.force > 0.0;
        Parts {
            known: known::Known {
                load: step.load,
                status: step.status,
                figures: step.figures,
                peak_place: step.field.peak_position,
                mean_pressure: self.mean_pressure(step),
                half_angle: None,
                parts: usize::from(touches),
                stiffness,
                flow,
                zones: [0, 1].map(|side| {
                    step.field.bodies[side].as_deref().map(|body| self.zone(body, side))
                }),
                hertz: self.hertz(step),
                onset: self.onset(step, known),
                bars: self.estimated_error(step, stiffness, known),
                whole: self.whole(step),
                rolled: None,
                fatigue: Vec::new(),
                is_alike: self.is_alike(step),
                is_graded: problem
                    .materials
                    .iter()
                    .flatten()
                    .any(|material| material.strength().is_some() && material.can_yield()),
            },
            contact: self.contact(step),
            increments: job
                .has_memory()
                .then(|| IncrementsReport::of(&step.path.increments, self.write)),
            surfaces: heights.map(|heights| surfaces(step, &heights, self.write)),
            passes: None,
            rules: Vec::new(),
            shakedown: None,
            spacing: Some(step.field.surface.grid.hx()),
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
            cells: Some([
                cells / grid.ny(),
                grid.ny(),
                bodies().map(|body| body.layers.len()).max().unwrap_or(0),
            ]),
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

    /// Returns whether both bodies have the same figures.
    fn is_alike(&self, step: &HalfSpaceStep) -> bool {
        self.problem.materials[0] == self.problem.materials[1]
            && known::is_shared(&step.field.bodies)
    }

    /// Returns why the bodies of a contact have no fatigue.
    fn without_fatigue(&self, step: &HalfSpaceStep) -> Option<&'static str> {
        if self.problem.heights.is_some() {
            return Some("the contact of single asperities is not resolved");
        }
        if roller_end(&self.problem, step).is_some() || has_kinks(&self.problem) {
            return Some("the end of a roller or a kink of its profile carries pressure");
        }
        let map = &step.field.surface;
        let rows = Row::all(&map.grid, &map.pressure).into_iter().enumerate();
        let touched = rows.filter(|(_, row)| row.half_width > 0.0).map(|(j, _)| map.grid.y(j));
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        let ends = touched.fold(none, |[low, high], y| [low.min(y), high.max(y)]);
        not_smooth(1, step.field.peak_position[1], ends)
    }

    /// Returns the elastic contact of the same bodies.
    fn hertz(&self, step: &HalfSpaceStep) -> Option<Hertz> {
        let (hertz, reference) = (step.field.hertz?, &self.reference);
        let first_yield = reference.onset_force().zip(reference.onset_depth());
        Some(Hertz {
            half_width: hertz.semi_axis_x,
            longer: Some(hertz.semi_axis_y),
            peak_pressure: hertz.peak_pressure,
            approach: Some(hertz.approach),
            first_yield: first_yield.map(|(force, depth)| [force, depth]),
            shakedown: reference.rolling().map(|limit| [limit.peak_pressure, limit.depth]),
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

    /// Returns the force over the contact area; of inclined forces the force is a part.
    fn mean_pressure(&self, step: &HalfSpaceStep) -> f64 {
        let (figures, map) = (&step.figures, &step.field.surface);
        let borne = if self.problem.conformity.is_conforming() {
            map.grid.cell_area() * map.pressure.iter().sum::<f64>()
        } else {
            figures.force
        };
        let area = figures.contact_area.filter(|_| figures.force > 0.0);
        area.map_or(0.0, |area| borne / area)
    }

    fn contact(&self, step: &HalfSpaceStep) -> ContactReport {
        let (write, figures, map) = (self.write, &step.figures, &step.field.surface);
        let [a, _] = ordered(figures.semi_axes());
        let pressure = section_along_x(map, &map.pressure);
        let cell = map.grid.cell_area();
        let lengths =
            |values: &[f64]| -> Vec<f64> { values.iter().map(|x| write.length(*x)).collect() };
        let stresses =
            |values: &[f64]| -> Vec<f64> { values.iter().map(|p| write.stress(*p)).collect() };
        let x: Vec<f64> = (0..map.grid.nx()).map(|i| write.length(map.grid.x(i))).collect();
        let y: Vec<f64> = (0..map.grid.ny()).map(|j| write.length(map.grid.y(j))).collect();
        let part = || Patch { left: write.length(-a), right: write.length(a) };
        ContactReport {
            patches: (figures.force > 0.0).then(part).into_iter().collect(),
            nodes: ContactNodes {
                x: x.clone(),
                force: pressure.iter().map(|pressure| write.force(pressure * cell)).collect(),
                pressure: stresses(&pressure),
                gap: lengths(&section_along_x(map, &map.gap)),
            },
            section: Some(SectionReport {
                y: y.clone(),
                pressure: stresses(&section_along_y(map, &map.pressure)),
                gap: lengths(&section_along_y(map, &map.gap)),
            }),
            along: self.along(step),
            quantiles: step.figures.contact_ratio.map(|_| quantiles(step, write)),
            maps: (self.job.output.fields && !step.status.is_stopped()).then(|| MapsReport {
                x,
                y,
                pressure: stresses(&map.pressure),
                gap: lengths(&map.gap),
                dent: dent(step).map(|dent| lengths(&dent)),
            }),
        }
    }

    /// Returns the onset of yield if the job asks for it.
    fn onset(&self, step: &HalfSpaceStep, known: Known) -> Option<Onset> {
        if self.job.load != Load::Onset || !known.has_estimate() {
            return None;
        }
        let force = step.figures.force;
        let closed = self.problem.onset.and_then(|_| self.reference.utilization(force));
        let (side, [x, depth]) = if let Some((_, depth, side)) = closed {
            (side, [0.0, depth])
        } else {
            let first = self.problem.highest_utilization(step)?;
            (first.side, [first.position[0], first.position[2]])
        };
        Some(Onset { force, closed_peak: None, side, position: x, depth })
    }

    /// Returns dP/dα at a constant contact area \[N/mm\] of bodies that do not flow.
    fn elastic_stiffness(&self, step: &HalfSpaceStep) -> Option<f64> {
        let is_known = !(step.status.is_stopped() || step.path.flows);
        is_known.then(|| self.reference.stiffness(step))
    }

    fn whole(&self, step: &HalfSpaceStep) -> Option<Whole> {
        let (figures, map) = (&step.figures, &step.field.surface);
        let all = map.grid.cell_area() * map.grid.n_cells() as f64;
        Some(Whole {
            orientation: self.orientation.to_degrees(),
            semi_axes: ordered(figures.semi_axes()),
            area: figures.contact_area?,
            largest_cell_pressure: step.field.largest_cell_pressure,
            roller: self.roller(step),
            rough: figures.contact_ratio.map(|contact_ratio| Rough {
                contact_ratio,
                nominal_pressure: figures.force / all,
                yielded_part: plastic_part(step),
            }),
        })
    }

    /// Returns the rows of cells between the ends of a roller, each with its y.
    fn rows(&self, step: &HalfSpaceStep) -> Option<Vec<(f64, Row)>> {
        let (half_length, map) = (self.problem.half_length()?, &step.field.surface);
        let rows = Row::all(&map.grid, &map.pressure).into_iter().enumerate();
        let rows = rows.map(|(j, row)| (map.grid.y(j), row));
        Some(rows.filter(|(y, _)| y.abs() < half_length).collect())
    }

    fn along(&self, step: &HalfSpaceStep) -> Option<RollerReport> {
        let (rows, write) = (self.rows(step)?, self.write);
        let line_load = |row: &Row| write.figure(Quantity::LineForce, row.line_load);
        Some(RollerReport {
            y: rows.iter().map(|(y, _)| write.length(*y)).collect(),
            line_load: rows.iter().map(|(_, row)| line_load(row)).collect(),
            half_width: rows.iter().map(|(_, row)| write.length(row.half_width)).collect(),
            pressure: rows.iter().map(|(_, row)| write.stress(row.largest_pressure)).collect(),
        })
    }

    fn roller(&self, step: &HalfSpaceStep) -> Option<RollerFigures> {
        let (half_length, rows) = (self.problem.half_length()?, self.rows(step)?);
        let width = step.field.surface.grid.hy();
        let pressure = |row: usize| rows[row].1.largest_pressure;
        let [low, high] = middle(rows.len());
        let (first, last) = (rows.first()?.0, rows.last()?.0);
        let reaches_ends = half_length - last < width;
        let at_end = |row: usize| if reaches_ends { pressure(row) } else { 0.0 };
        Some(RollerFigures {
            end_pressure: [at_end(0), at_end(rows.len() - 1)],
            ends: [first, last],
            middle_pressure: pressure(low).max(pressure(high)),
            moment: rows.iter().map(|(y, row)| y * row.line_load * width).sum(),
            tilt: 1e3 * step.field.tilt,
        })
    }

    fn zone(&self, body: &HalfSpaceBody, side: usize) -> Zone {
        let most = body.largest_strain;
        let section = body.plastic_section;
        let first = body.equivalent_plastic_strain.iter().position(|strain| *strain > 0.0);
        let top = first.map(|cell| body.layers.faces()[cell / body.grid.n_cells()]);
        Zone {
            yielded: most.is_some(),
            largest: largest_strain(self.job, body, side),
            mean: section.mean_strain,
            place: most.map_or([0.0; 3], |most| most.position),
            area: section.area,
            volume: Some(body.plastic_volume),
            cover: if section.reaches_surface { Some(0.0) } else { top },
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
        let position = place.map(|length| self.write.length(length)).to_vec();
        let material = self.problem.materials[side].as_ref();
        below(material, self.orientation, position, &body.column(place), self.write)
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
        let contact_stiffness = match (self.elastic_stiffness(step), stiffness) {
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
        let approach = match step.load {
            ContactLoad::Force(_) => known.bar(Figure::Approach, 0, approach),
            ContactLoad::Approach(_) => Some(0.0),
        };
        // The stress at the onset of yield is proportional to the cube root of the force.
        let force = match self.job.load {
            Load::Onset if self.problem.onset.is_some() => {
                Some(CLOSED_FORM + seats::error_of_onset(self.job, self.orientation, step))
            }
            Load::Onset => peak.map(|peak| 3.0 * peak),
            _ => of(Figure::Force).map(|error| error + of_spots[1]),
        };
        let mut figures = Values::default();
        for (figure, bar) in [
            (Figure::PeakPressure, peak),
            (Figure::MiddlePressure, middle),
            (Figure::HalfWidth, self.semi_axis_error(step, Figure::HalfWidth)),
            (Figure::SemiAxisY, self.semi_axis_error(step, Figure::SemiAxisY)),
            (Figure::ContactArea, of(Figure::ContactArea)),
            (Figure::Approach, approach),
            (Figure::Force, force),
        ] {
            figures.set(figure, 0, bar);
        }
        // Under load the surfaces have an elastic deflection, which has no bar.
        let without_load: &[Figure] = if step.figures.force > 0.0 {
            &[]
        } else {
            &[Figure::Dent, Figure::PileUp, Figure::LeastStress]
        };
        for side in (0..2).filter(|side| step.field.bodies[*side].is_some()) {
            for figure in [Figure::MaxPlasticStrain].iter().chain(without_load) {
                let bar = known.bar(*figure, side, errors.get(*figure, side));
                figures.set(*figure, side, bar);
            }
        }
        Some(ErrorEstimate { figures, contact_stiffness })
    }

    /// Returns the relative error of a semi-axis, or `None` for heights: single asperities bound
    /// their contact. A circle has one radius, with the larger error of both.
    fn semi_axis_error(&self, step: &HalfSpaceStep, axis: Figure) -> Option<f64> {
        let errors = self.errors(step).filter(|_| self.problem.heights.is_none())?;
        let errors = errors.zip(&step.figures.values(), relative);
        let is_circle = step.field.hertz.is_some_and(|hertz| {
            (hertz.semi_axis_x - hertz.semi_axis_y).abs() <= ROUNDING * hertz.semi_axis_x
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
}

/// Returns the pressures below which parts of the cells in contact are.
fn quantiles(step: &HalfSpaceStep, write: UnitConverter) -> PressureQuantiles {
    let pressures = step.field.surface.pressure.iter().copied();
    let mut pressures: Vec<f64> = pressures.filter(|pressure| *pressure > 0.0).collect();
    pressures.sort_by(f64::total_cmp);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a part of a length"
    )]
    let at = |part: &f64| pressures.get((part * pressures.len() as f64) as usize);
    let quantiles = QUANTILES.iter().filter_map(at);
    PressureQuantiles {
        part: QUANTILES.to_vec(),
        pressure: quantiles.map(|pressure| write.stress(*pressure)).collect(),
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
