//! The step of a load that rolls as a report shows it.

use brinell_halfspace::Fatigue;
use brinell_halfspace::track::SteadyState;

use super::cost::cost;
use super::document::{PassesReport, RuleVerdict, ShakedownMap, SolvedHardening};
use super::findings::findings;
use super::known::{PassFigure, PassFigures, Rolled, Ruled};
use super::section::section;
use super::verdicts::{word, worst};
use crate::inputs::{RollingInput, SolveError};
use crate::job::{Job, Named as _};
use crate::report::answers::Measured;
use crate::report::cost::JobEstimate;
use crate::report::datum::Datum;
use crate::report::fatigue::BodyFatigue;
use crate::report::findings::Finding;
use crate::report::hertz::line;
use crate::report::known::ErrorEstimate;
use crate::report::known::{Hertz, Known};
use crate::report::shown::{Arrays, Parts, Shown, Solved};
use crate::report::solve_error::track_text;
use crate::report::subsurface::below;
use crate::report::{
    ContactNodes, ContactReport, LayersReport, MeshReport, Patch, PerBody, Side, SubsurfaceReport,
};
use crate::solver::half_spaces::ColumnPoint;
use crate::solver::method::figures::{Figure, ROUNDING, Values};
use crate::solver::rolling::{
    self, FrictionLimit, HardeningRules, Pass, PassErrors, RollingProblem, TrackField, TrackRun,
    TrackStep,
};
use crate::solver::{Interrupt, Observer, Options, SolveStatus, StepReceiver};
use crate::units::UnitConverter;

/// What a rule of hardening says of both bodies.
type Answered<'a> = (&'a [Option<Fatigue>; 2], &'a [Option<SteadyState>; 2]);

/// A load that rolls.
pub(in crate::report) struct Track<'a> {
    job: &'a Job,
    write: UnitConverter,
    input: RollingInput,
}

impl<'a> Track<'a> {
    pub fn new(job: &'a Job, input: RollingInput) -> Self {
        Self { job, write: UnitConverter::new(job.units, job.analysis), input }
    }

    fn shown<'s>(&'s self, step: &'s TrackStep) -> Passes<'s> {
        Passes { write: self.write, problem: &self.input.problem, step, field: &step.field }
    }
}

impl Shown for Track<'_> {
    type Field = TrackField;
    type Memory = ();

    fn job(&self) -> &Job {
        self.job
    }

    fn cost(&self) -> Result<JobEstimate, SolveError> {
        Ok(cost(self.job, &self.input.problem)?)
    }

    fn solve(
        &self,
        _: Options<'_>,
        observer: &mut dyn Observer,
        receiver: &mut dyn StepReceiver<TrackField>,
    ) -> Result<Solved, SolveError> {
        let TrackRun { phases, tracks, interrupted } =
            rolling::run(&self.input.problem, observer, receiver)?;
        Ok(Solved { phases, passes: tracks, interrupted, sensitivity: None })
    }

    fn arrays(&self, step: &TrackStep, _: &mut dyn Observer) -> Result<Arrays, Interrupt> {
        let (shown, output) = (self.shown(step), &self.job.output);
        let of = |side: usize| shown.profile(side);
        let subsurface = output.subsurface.then(|| PerBody { upper: of(0), lower: of(1) });
        let layers = if output.fields { shown.layers() } else { None };
        Ok(Arrays { subsurface, layers, ..Arrays::default() })
    }

    fn findings(&self, step: &TrackStep) -> Vec<Finding> {
        findings(self.job, &self.input.problem, self.input.reference().as_ref(), step)
    }

    fn parts(&self, (): &mut (), step: &TrackStep, _: &[Finding]) -> Parts {
        let (shown, reference) = (self.shown(step), self.input.reference());
        let hertz = reference.as_ref().map(line).or_else(|| shown.ellipse());
        let perfect = reference.as_ref().map(|reference| self.input.over_friction(reference));
        let is_line = self.input.problem.is_line();
        let last = &step.field.last;
        let touches = last.half_width() > 0.0;
        let area = step.figures.contact_area.unwrap_or(2.0 * last.half_width());
        Parts {
            known: Known {
                load: step.load,
                status: step.status,
                figures: step.figures,
                peak_place: [last.peak_position, 0.0],
                mean_pressure: if touches { step.figures.force / area } else { 0.0 },
                half_angle: None,
                parts: usize::from(touches),
                stiffness: None,
                flow: None,
                zones: [None; 2],
                hertz,
                onset: None,
                bars: shown.estimated_error(),
                whole: None,
                rolled: Some(shown.rolled()),
                fatigue: shown.fatigue(),
                is_alike: self.input.problem.is_shared(),
                is_graded: false,
            },
            contact: shown.contact(),
            increments: None,
            surfaces: None,
            passes: Some(shown.passes()),
            rules: shown.rules().into_iter().map(|rule| rule.said).collect(),
            shakedown: shown.over_friction(hertz, perfect.as_deref()),
            spacing: None,
            measured: Measured {
                first_yield: reference.and_then(|reference| reference.yield_onset_force),
                datum: if is_line { Datum::None } else { Datum::FarPoints },
                ..Measured::default()
            },
            target: None,
            indentation: None,
            leaves_unknown: false,
        }
    }

    fn mesh(&self, step: &TrackStep) -> MeshReport {
        let TrackField { x, column, grid: [columns, layers, rows], .. } = &step.field;
        let components = if *rows > 1 { 5 } else { 3 };
        let cells = columns * layers * rows;
        MeshReport {
            spacing: self.write.length(*column),
            contact_pairs: x.len() * rows,
            nodes: columns * rows,
            elements: cells * self.input.problem.yielding().count(),
            equations: x.len() * rows + components * cells,
            cells: Some([*columns, *rows, *layers]),
            ..MeshReport::default()
        }
    }
}

/// The passes of a step, in the units of the job.
struct Passes<'a> {
    write: UnitConverter,
    problem: &'a RollingProblem,
    step: &'a TrackStep,
    field: &'a TrackField,
}

impl Passes<'_> {
    /// Returns the contact of elastic bodies, if it is an ellipse.
    fn ellipse(&self) -> Option<Hertz> {
        let [along, across] = self.problem.semi_axes();
        let limit = self.field.limits[0];
        (!self.problem.is_line()).then(|| Hertz {
            half_width: along.min(across),
            longer: None,
            peak_pressure: self.problem.elastic_peak(),
            approach: None,
            first_yield: None,
            shakedown: limit.map(|limit| [limit.peak_pressure, limit.depth]),
        })
    }

    fn contact(&self) -> ContactReport {
        let (write, field) = (self.write, self.field);
        let last = &field.last;
        let touches = last.half_width() > 0.0;
        let [left, right] = last.ends.map(|x| write.length(x));
        let forces = field.pressure.iter().map(|p| write.force(p * field.cell));
        ContactReport {
            patches: touches.then_some(Patch { left, right }).into_iter().collect(),
            nodes: ContactNodes {
                x: field.x.iter().map(|x| write.length(*x)).collect(),
                force: forces.collect(),
                pressure: field.pressure.iter().map(|p| write.stress(*p)).collect(),
                gap: field.gap.iter().map(|gap| write.length(*gap)).collect(),
            },
            ..ContactReport::default()
        }
    }

    /// Returns the errors of the contact in the last pass.
    fn estimated_error(&self) -> Option<ErrorEstimate> {
        if self.step.status != SolveStatus::Converged {
            return None;
        }
        let errors = self.field.errors.last()?.as_ref()?;
        let last = &self.field.last;
        let mut figures = Values::default();
        let mut set = |figure: Figure, error: f64, value: f64| {
            let bar = Some(error / value.abs()).filter(|bar| bar.is_finite());
            figures.set(figure, 0, bar);
        };
        set(Figure::PeakPressure, errors.peak_pressure, last.peak_pressure);
        set(Figure::HalfWidth, errors.half_width, last.half_width());
        if let Some(approach) = last.approach {
            set(Figure::Approach, errors.approach, approach);
        }
        figures.set(Figure::Force, 0, 0.0);
        Some(ErrorEstimate { figures, contact_stiffness: None })
    }

    fn rolled(&self) -> Rolled {
        let rules = self.rules();
        // Of equal words the larger rate.
        let worst = rules.iter().enumerate().max_by(|(_, a), (_, b)| {
            let rate = |rule: &Ruled| rule.rate.unwrap_or(0.0);
            a.verdict().cmp(&b.verdict()).then(rate(a).total_cmp(&rate(b)))
        });
        let worst = worst.map_or(0, |(place, _)| place);
        Rolled {
            worst,
            rules,
            friction: self.problem.load.friction,
            limits: self.field.limits.map(|limit| limit.filter(|limit| limit.peak_pressure > 0.0)),
            shear_yield_stress: self.problem.shear_yield_stress(),
            last: self.all_passes().last(),
        }
    }

    /// Returns the limits over friction; of a line perfect plasticity is known for all of them.
    fn over_friction(
        &self,
        hertz: Option<Hertz>,
        of_line: Option<&[(f64, crate::analytical::DepthLimit)]>,
    ) -> Option<ShakedownMap> {
        let write = self.write;
        let perfect = |friction: f64| {
            let mut limits = of_line.unwrap_or_default().iter();
            let of_line = limits.find(|(at, _)| (at - friction).abs() < ROUNDING);
            // Of an ellipse the limit of free rolling alone is known.
            let free = || hertz?.shakedown.map(|[limit, _]| limit).filter(|_| friction <= 0.0);
            of_line.map(|(_, limit)| limit.peak_pressure).or_else(free)
        };
        let limits = self.problem.limits_over_friction();
        let stresses = |of: fn(&FrictionLimit) -> f64| {
            limits.iter().map(|limit| write.stress(of(limit))).collect::<Vec<f64>>()
        };
        let map = ShakedownMap {
            friction: limits.iter().map(|limit| limit.friction).collect(),
            elastic: stresses(|limit| limit.elastic),
            perfect: limits
                .iter()
                .map(|limit| perfect(limit.friction).map(|limit| write.stress(limit)))
                .collect(),
            kinematic: stresses(|limit| limit.kinematic),
            perfect_depth: Vec::new(),
        };
        (!map.friction.is_empty()).then_some(map)
    }

    fn all_passes(&self) -> impl Iterator<Item = PassFigures> {
        let passes = self.field.passes.iter().zip(&self.field.errors).enumerate();
        passes.map(|(k, (pass, errors))| {
            let accumulated = [0, 1].map(|side| {
                if pass.bodies[side].is_some() { self.field.accumulated(side, k + 1) } else { 0.0 }
            });
            let force = self.problem.load.force;
            PassFigures::of((k + 1, pass), errors.as_ref(), force, accumulated)
        })
    }

    fn passes(&self) -> PassesReport {
        let mut report = PassesReport::default();
        let write = self.write;
        for pass in self.all_passes() {
            report.number.push(pass.number);
            report.iterations.push(pass.iterations);
            let [upper, lower] = &pass.bodies;
            let contact: Vec<_> = pass.contact.iter().chain(&pass.works).copied().collect();
            for (columns, figures) in [
                (&mut report.contact, &contact),
                (&mut report.upper, upper),
                (&mut report.lower, lower),
            ] {
                for figure in figures {
                    let PassFigure { name, core, .. } = *figure;
                    let course = columns.entry(name.name().to_owned()).or_default();
                    course.value.push(write.of(name.quantity(), core));
                    course.error.push(figure.bar());
                }
            }
        }
        report
    }

    /// Returns the fatigue of bodies with limits, by each rule.
    fn fatigue(&self) -> Vec<BodyFatigue> {
        let (field, rolled) = (self.field, self.rolled());
        let as_given = (&field.fatigue, &field.verdicts);
        let other = field.kinematic.as_ref().map(|other| (&other.fatigue, &other.verdicts));
        let is_one = self.problem.is_shared();
        let sides = || Side::BOTH.into_iter().skip(usize::from(is_one));
        let has_limits = |side: &Side| {
            let material = self.problem.materials[side.member()].as_ref();
            material.is_some_and(|material| material.fatigue().is_some())
        };
        let rules = [as_given].into_iter().chain(other).zip(&rolled.rules).enumerate();
        let of_rule = |(k, ((found, verdicts), rule)): (usize, (Answered<'_>, &Ruled))| {
            let of = |side: Side| BodyFatigue {
                side,
                found: found[side.member()].clone().ok_or(refused(verdicts[side.member()])),
                rule: (rolled.rules.len() > 1).then_some(rule.hardening()),
                is_of_verdict: k == rolled.worst,
                pass: Some(rule.passes),
            };
            sides().filter(has_limits).map(of).collect::<Vec<_>>()
        };
        rules.flat_map(of_rule).collect()
    }

    /// Returns the verdicts by the rules of hardening that were solved.
    fn rules(&self) -> Vec<Ruled> {
        let field = self.field;
        let errors = field.errors.last().and_then(Option::as_ref);
        let hardens = self.problem.hardening_kinematically().is_some();
        let hardening = match self.problem.load.hardening {
            _ if !hardens => SolvedHardening::Given,
            HardeningRules::Kinematic => SolvedHardening::Kinematic,
            HardeningRules::Both | HardeningRules::Isotropic => SolvedHardening::Isotropic,
        };
        let as_given = (&*field.passes, &field.last, errors);
        let mut rules = vec![self.rule(hardening, &field.verdicts, as_given)];
        if let Some(other) = &field.kinematic {
            let passes = (&*other.passes, &other.last, other.errors.as_ref());
            rules.push(self.rule(SolvedHardening::Kinematic, &other.verdicts, passes));
        }
        rules
    }

    /// Returns the verdict by one rule, of both bodies the worse.
    fn rule(
        &self,
        hardening: SolvedHardening,
        verdicts: &[Option<SteadyState>; 2],
        (passes, last, errors): (&[Pass], &Pass, Option<&PassErrors>),
    ) -> Ruled {
        let (side, verdict) = worst(verdicts);
        let (rate, change) = match verdict {
            SteadyState::Elastic | SteadyState::ShakesDown { .. } => (Some(0.0), Some(0.0)),
            SteadyState::ClosedCycle { strain, bar } => (Some(strain), Some(bar)),
            SteadyState::Ratchets { rate, bar } => (Some(rate), Some(bar)),
            SteadyState::Undecided { .. } => (None, None),
        };
        let errors = errors.and_then(|errors| errors.bodies[side?]);
        let of_columns = match verdict {
            SteadyState::ClosedCycle { .. } => errors.map(|errors| errors.largest_strain),
            SteadyState::Ratchets { .. } => errors.map(|errors| errors.net_strain),
            _ => Some(0.0),
        };
        let strain = passes.last().and_then(|pass| Some(pass.bodies[side?].as_ref()?.strain));
        let place = strain.and_then(|strain| match verdict {
            SteadyState::ClosedCycle { .. } => Some(strain.largest),
            SteadyState::Ratchets { .. } => Some(strain.net),
            _ => None,
        });
        let depth = place.map(|at| if at.to_surface > 0.0 { 0.0 } else { at.depth });
        // The bar of a row goes to the surface, where the rate is.
        let to_surface = place.map_or(0.0, |at| at.to_surface);
        let of_columns = of_columns.map(|bar| (bar - to_surface).max(to_surface));
        Ruled {
            said: RuleVerdict {
                hardening,
                verdict: word(verdict),
                reason: self.reason(verdict, passes.len(), last),
            },
            rate,
            rate_error: change.zip(of_columns).map(|(change, columns)| change + columns),
            depth,
            body: side.filter(|_| !self.problem.is_shared()).map(Side::of),
            passes: passes.len(),
        }
    }

    /// Returns why the verdict is open, or why the passes end.
    fn reason(&self, verdict: SteadyState, number: usize, last: &Pass) -> Option<String> {
        match (last.status, &last.fault) {
            (SolveStatus::Converged, _) => {}
            (SolveStatus::NotConverged, Some(fault)) => {
                let fault = track_text(fault, self.write);
                return Some(format!("pass {} has no answer: {fault}", number + 1));
            }
            (SolveStatus::NotConverged, None) => {
                return Some(format!(
                    "pass {} has not converged in {} iterations",
                    number + 1,
                    last.iterations
                ));
            }
            _ => return Some(format!("the job was stopped in pass {}", number + 1)),
        }
        matches!(verdict, SteadyState::Undecided { .. }).then(|| {
            let unit = if self.problem.load.alternating { "pairs of passes" } else { "passes" };
            format!(
                "no word has come three times running: a verdict takes at least ten {unit}, and \
                 more near a limit; {number} were made"
            )
        })
    }

    /// Returns what the last pass has left in the section of a track of finite width.
    fn layers(&self) -> Option<PerBody<Option<LayersReport>>> {
        let of_side = |side: usize| {
            let passes = self.field.passes.iter();
            let passes: Vec<_> = passes.filter_map(|pass| pass.bodies[side].as_ref()).collect();
            section(&passes, self.write)
        };
        let layers = PerBody { upper: of_side(0), lower: of_side(1) };
        Some(layers).filter(|layers| layers.upper.is_some() || layers.lower.is_some())
    }

    /// Returns what the last pass has left over depth, far from the load.
    fn profile(&self, side: usize) -> Option<SubsurfaceReport> {
        let material = self.problem.materials[side].as_ref()?;
        let passes = || self.field.passes.iter().filter_map(|pass| pass.bodies[side].as_ref());
        let outlet = &passes().next_back()?.outlet;
        let accumulated = |layer: usize| {
            let rows = outlet.across.len();
            passes().map(|body| body.outlet.accumulated[layer * rows]).sum()
        };
        let stresses = outlet.on_axis(&outlet.residual).enumerate();
        let points: Vec<ColumnPoint> = stresses
            .map(|(layer, stress)| ColumnPoint {
                depth: outlet.depths[layer],
                stress: *stress,
                equivalent_plastic_strain: accumulated(layer),
            })
            .collect();
        let position = if self.problem.is_line() { vec![0.0] } else { vec![0.0; 2] };
        Some(below(Some(material), 0.0, position, &points, self.write))
    }
}

/// Returns why a body with this verdict has no utilization.
const fn refused(verdict: Option<SteadyState>) -> &'static str {
    match verdict {
        Some(SteadyState::ClosedCycle { .. } | SteadyState::Ratchets { .. }) => {
            "the body flows in each pass: no criterion of high-cycle fatigue holds"
        }
        Some(SteadyState::Undecided { .. }) => {
            "the passes do not tell whether the body shakes down"
        }
        None | Some(SteadyState::Elastic | SteadyState::ShakesDown { .. }) => {
            "no pass has converged"
        }
    }
}
