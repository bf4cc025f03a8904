//! The step of a load that rolls as a report shows it.

use brinell_halfspace::track::SteadyState;

use super::cost::cost;
use super::document::{
    BodyPassErrorReport, BodyPassReport, FrictionLimits, PassErrorReport, PassReport,
    RollingReport, RuleVerdict, SolvedHardening, TrackLimitReport, TrackLimitsReport,
    TrackVerdict,
};
use super::findings::findings;
use super::section::section;
use super::verdicts::{word, worst};
use crate::inputs::{RollingInput, SolveError};
use crate::job::Job;
use crate::report::answers::Measured;
use crate::report::cost::JobEstimate;
use crate::report::datum::Datum;
use crate::report::findings::Finding;
use crate::report::hertz::{line, over_friction};
use crate::report::shown::{Arrays, Parts, Shown, Solved};
use crate::report::solve_error::track_text;
use crate::report::{
    ContactNodes, ContactReport, ErrorEstimate, HertzReport, LayersReport, MeshReport, Patch,
    PerBody, Side, SubsurfaceReport,
};
use crate::solver::rolling::{
    self, BodyPass, BodyPassErrors, FrictionLimit, HardeningRules, Limit, Pass, PassErrors,
    RollingProblem, TrackField, TrackRun, TrackStep,
};
use crate::solver::{Interrupt, Observer, Options, SolveStatus, StepReceiver};
use crate::units::UnitConverter;

/// Difference below which two frictions are one.
const SAME_FRICTION: f64 = 1e-9;

/// The verdict by one rule of hardening, the body of which it is said, and the depth of its rate.
#[derive(Clone)]
struct Ruled {
    verdict: RuleVerdict,
    body: Option<Side>,
    depth: Option<f64>,
}

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
        let hertz = reference.as_ref().map(|reference| {
            let limits = over_friction(&self.input.over_friction(reference), self.write);
            line(reference, &limits, self.write)
        });
        let hertz = hertz.or_else(|| shown.ellipse());
        let is_line = self.input.problem.is_line();
        Parts {
            contact: shown.contact(),
            stiffness: None,
            spacing: None,
            flow: None,
            rolling: Some(shown.rolling(hertz.as_ref())),
            hertz,
            yield_onset: None,
            bars: shown.estimated_error(),
            three_dimensional: None,
            measured: Measured {
                first_yield: reference.and_then(|reference| reference.yield_onset_force),
                figures: step.figures.values(),
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
    fn ellipse(&self) -> Option<HertzReport> {
        let write = self.write;
        let [along, across] = self.problem.semi_axes();
        let limit = self.field.limits[0];
        (!self.problem.is_line()).then(|| HertzReport {
            half_width: write.length(along.min(across)),
            peak_pressure: write.stress(self.problem.elastic_peak()),
            yield_onset_force: None,
            yield_onset_depth: None,
            shakedown_pressure: limit.map(|limit| write.stress(limit.peak_pressure)),
            shakedown_depth: limit.map(|limit| write.length(limit.depth)),
            shakedown_over_friction: Vec::new(),
        })
    }

    fn contact(&self) -> ContactReport {
        let (write, field, figures) = (self.write, self.field, &self.step.figures);
        let last = &field.last;
        let [left, right] = last.ends.map(|x| write.length(x));
        let touches = last.half_width() > 0.0;
        let area = figures.contact_area.unwrap_or(2.0 * last.half_width());
        let mean = if touches { figures.force / area } else { 0.0 };
        let forces = field.pressure.iter().map(|p| write.force(p * field.cell));
        ContactReport {
            force: write.force(figures.force),
            half_width: write.length(last.half_width()),
            half_angle: None,
            peak_pressure: write.stress(last.peak_pressure),
            peak_position: write.length(last.peak_position),
            middle_pressure: figures.middle_pressure.map(|pressure| write.stress(pressure)),
            mean_pressure: write.stress(mean),
            patches: touches.then_some(Patch { left, right }).into_iter().collect(),
            nodes: ContactNodes {
                x: field.x.iter().map(|x| write.length(*x)).collect(),
                force: forces.collect(),
                pressure: field.pressure.iter().map(|p| write.stress(*p)).collect(),
                gap: field.gap.iter().map(|gap| write.length(*gap)).collect(),
            },
        }
    }

    /// Returns the errors of the contact in the last pass.
    fn estimated_error(&self) -> Option<ErrorEstimate> {
        if self.step.status != SolveStatus::Converged {
            return None;
        }
        let errors = self.field.errors.last()?.as_ref()?;
        let last = &self.field.last;
        Some(ErrorEstimate {
            peak_pressure: relative(errors.peak_pressure, last.peak_pressure),
            half_width: relative(errors.half_width, last.half_width()),
            approach: last.approach.and_then(|approach| relative(errors.approach, approach)),
            force: Some(0.0),
            ..ErrorEstimate::default()
        })
    }

    fn rolling(&self, hertz: Option<&HertzReport>) -> RollingReport {
        let (write, field) = (self.write, self.field);
        let rules = self.rules();
        // Of equal words the larger rate.
        let worst = rules.iter().max_by(|a, b| {
            let rate = |rule: &Ruled| rule.verdict.rate.unwrap_or(0.0);
            a.verdict.verdict.cmp(&b.verdict.verdict).then(rate(a).total_cmp(&rate(b)))
        });
        let worst = worst.cloned();
        let limit = |limit: &Limit| TrackLimitReport {
            peak_pressure: write.stress(limit.peak_pressure),
            depth: write.length(limit.depth),
            body: Side::of(limit.side),
        };
        let [perfect, kinematic] = &field.limits;
        RollingReport {
            verdict: worst.as_ref().map_or(TrackVerdict::Undecided, |of| of.verdict.verdict),
            body: worst.as_ref().and_then(|of| of.body),
            rate: worst.as_ref().and_then(|of| of.verdict.rate),
            rate_error: worst.as_ref().and_then(|of| of.verdict.rate_error),
            rate_depth: worst.as_ref().and_then(|of| of.depth),
            reason: worst.and_then(|of| of.verdict.reason),
            rules: rules.into_iter().map(|of| of.verdict).collect(),
            friction: self.problem.load.friction,
            passes: self.passes(),
            limits: TrackLimitsReport {
                perfect: perfect.as_ref().filter(|limit| limit.peak_pressure > 0.0).map(limit),
                kinematic: kinematic.as_ref().filter(|limit| limit.peak_pressure > 0.0).map(limit),
                shear_yield_stress: self.problem.shear_yield_stress().map(|k| write.stress(k)),
                over_friction: self.over_friction(hertz),
            },
            columns: field.grid[0],
            layers: field.grid[1],
            rows: field.grid[2],
        }
    }

    /// Returns the limits over friction.
    fn over_friction(&self, hertz: Option<&HertzReport>) -> Vec<FrictionLimits> {
        let write = self.write;
        let perfect = |friction: f64| {
            let mut limits = hertz?.shakedown_over_friction.iter();
            let of_line = limits.find(|limit| (limit.friction - friction).abs() < SAME_FRICTION);
            // Of an ellipse the limit of free rolling alone is known.
            let of_ellipse = || hertz?.shakedown_pressure.filter(|_| friction <= 0.0);
            of_line.map(|limit| limit.pressure).or_else(of_ellipse)
        };
        let limits = self.problem.limits_over_friction().into_iter();
        let of_friction = |limit: FrictionLimit| FrictionLimits {
            friction: limit.friction,
            elastic_pressure: write.stress(limit.elastic),
            perfect_pressure: perfect(limit.friction),
            kinematic_pressure: write.stress(limit.kinematic),
        };
        limits.map(of_friction).collect()
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
            body: side.filter(|_| !self.problem.is_shared()).map(Side::of),
            depth: depth.map(|depth| self.write.length(depth)),
            verdict: RuleVerdict {
                hardening,
                verdict: word(verdict),
                rate,
                rate_error: change.zip(of_columns).map(|(change, columns)| change + columns),
                passes: passes.len(),
                reason: self.reason(verdict, passes.len(), last),
            },
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

    fn passes(&self) -> Vec<PassReport> {
        let passes = self.field.passes.iter().zip(&self.field.errors).enumerate();
        passes.map(|(k, (pass, errors))| self.pass(k + 1, pass, errors.as_ref())).collect()
    }

    fn pass(&self, number: usize, pass: &Pass, errors: Option<&PassErrors>) -> PassReport {
        let write = self.write;
        let of_side = |side: usize| {
            let body = pass.bodies[side].as_ref()?;
            Some(body_report(body, self.field.accumulated(side, number), write))
        };
        PassReport {
            number,
            iterations: pass.iterations,
            peak_pressure: write.stress(pass.peak_pressure),
            half_width: write.length(pass.half_width()),
            half_width_across: pass.half_width_across.map(|width| write.length(width)),
            approach: pass.approach.map(|approach| write.length(approach)),
            rolling_force: write.force(pass.rolling_force),
            loss: pass.rolling_force / self.problem.load.force,
            plastic_work: write.force(pass.plastic_work()),
            stored_energy: write.force(pass.stored_energy()),
            traction_work: write.force(pass.work_of_traction),
            energy_gap: pass.energy_gap(),
            bodies: PerBody { upper: of_side(0), lower: of_side(1) },
            estimated_error: errors.map(|errors| PassErrorReport {
                peak_pressure: relative(errors.peak_pressure, pass.peak_pressure),
                half_width: relative(errors.half_width, pass.half_width()),
                approach: pass.approach.and_then(|approach| relative(errors.approach, approach)),
                plastic_work: relative(errors.work, pass.plastic_work()),
                bodies: PerBody {
                    upper: errors_report(pass, errors.bodies, 0),
                    lower: errors_report(pass, errors.bodies, 1),
                },
            }),
        }
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
        let write = self.write;
        let material = self.problem.materials[side].as_ref()?;
        let passes = || self.field.passes.iter().filter_map(|pass| pass.bodies[side].as_ref());
        let outlet = &passes().next_back()?.outlet;
        let layers = || outlet.on_axis(&outlet.residual);
        let stress =
            |of: &dyn Fn(&[f64; 6]) -> f64| layers().map(|s| write.stress(of(s))).collect();
        // On the axis σxy and σyz are zero: σyy is principal.
        let von_mises = |[x, y, z, _, xz, _]: &[f64; 6]| {
            let normal = (x - y).powi(2) + (y - z).powi(2) + (z - x).powi(2);
            (0.5 * normal + 3.0 * xz * xz).sqrt()
        };
        let largest_shear = |[x, y, z, _, xz, _]: &[f64; 6]| {
            let (mean, radius) = (0.5 * (x + z), f64::hypot(0.5 * (x - z), *xz));
            0.5 * ((mean + radius).max(*y) - (mean - radius).min(*y))
        };
        let whole = |k: usize| (!self.problem.is_line()).then(|| stress(&|s| s[k]));
        let rows = outlet.across.len();
        let accumulated =
            |layer: usize| passes().map(|body| body.outlet.accumulated[layer * rows]).sum();
        let initial = material.initial_stress();
        let is_stressed = !material.initial_stress().is_empty();
        let before = |k: usize| {
            let at = |depth: &f64| write.stress(initial.at(*depth)[k]);
            is_stressed.then(|| outlet.depths.iter().map(at).collect::<Vec<f64>>())
        };
        let limits = material.hardening_law().zip(material.strength()).map(|(law, strength)| {
            let at = |depth: &f64| law.nominal_yield_stress() * strength.factor(*depth);
            outlet.depths.iter().map(at).collect::<Vec<f64>>()
        });
        Some(SubsurfaceReport {
            position: Some(0.0),
            depth: outlet.depths.iter().map(|depth| write.length(*depth)).collect(),
            sigma_x: stress(&|s| s[0]),
            sigma_y: stress(&|s| s[2]),
            sigma_z: stress(&|s| s[1]),
            tau_max: stress(&largest_shear),
            von_mises: stress(&von_mises),
            equivalent_plastic_strain: (0..outlet.depths.len()).map(accumulated).collect(),
            utilization: limits.as_ref().map(|limits| {
                layers().zip(limits).map(|(stress, limit)| von_mises(stress) / limit).collect()
            }),
            yield_stress: limits
                .map(|limits| limits.iter().map(|limit| write.stress(*limit)).collect()),
            initial_sigma_x: before(0),
            initial_sigma_y: before(0).map(|stresses| vec![0.0; stresses.len()]),
            initial_sigma_z: before(1),
            position_y: (!self.problem.is_line()).then_some(0.0),
            sigma_xx: whole(0),
            sigma_yy: whole(1),
            sigma_zz: whole(2),
            sigma_xy: whole(3),
            sigma_xz: whole(4),
            sigma_yz: whole(5),
        })
    }
}

fn body_report(body: &BodyPass, accumulated: f64, write: UnitConverter) -> BodyPassReport {
    let outlet = &body.outlet;
    let stresses = |k: usize| outlet.on_axis(&outlet.residual).map(move |stress| stress[k]);
    let least = |k: usize| write.stress(stresses(k).fold(f64::INFINITY, f64::min));
    let most = |k: usize| write.stress(stresses(k).fold(f64::NEG_INFINITY, f64::max));
    BodyPassReport {
        groove_depth: write.length(body.outlet.groove_depth),
        pile_up: write.length(body.outlet.pile_up),
        forward: write.length(body.outlet.forward),
        largest_strain: body.strain.largest.value,
        largest_strain_depth: write.length(body.strain.largest.depth),
        largest_strain_across: write.length(body.strain.largest.across),
        net_strain: body.strain.net.value,
        net_strain_depth: write.length(body.strain.net.depth),
        net_strain_across: write.length(body.strain.net.across),
        accumulated_strain: accumulated,
        least_sigma_x: least(0),
        largest_sigma_x: most(0),
        least_sigma_z: least(1),
        largest_sigma_z: most(1),
    }
}

fn errors_report(
    pass: &Pass,
    errors: [Option<BodyPassErrors>; 2],
    side: usize,
) -> Option<BodyPassErrorReport> {
    let (body, errors) = (pass.bodies[side].as_ref()?, errors[side]?);
    let stresses = body.outlet.on_axis(&body.outlet.residual).flat_map(|stress| &stress[..2]);
    let largest = stresses.fold(0.0, |most: f64, stress| most.max(stress.abs()));
    Some(BodyPassErrorReport {
        groove_depth: relative(errors.groove_depth, body.outlet.groove_depth),
        pile_up: relative(errors.pile_up, body.outlet.pile_up),
        forward: relative(errors.forward, body.outlet.forward),
        largest_strain: relative(errors.largest_strain, body.strain.largest.value),
        net_strain: relative(errors.net_strain, body.strain.net.value),
        residual: relative(errors.residual, largest),
    })
}

/// Returns an error relative to its figure; `None` of a figure that is 0.
fn relative(error: f64, figure: f64) -> Option<f64> {
    Some(error / figure.abs()).filter(|error| error.is_finite())
}
