//! A report as plain text for a person, at most 80 columns wide.

mod bodies;
mod history;
mod number;
mod plot;

use std::fmt::Write;

use super::style::Style;
use brinell_solver::job::fields::Figure;
use brinell_solver::job::{Analysis, Job, Load, Quantity, Target, TargetFigure};
use brinell_solver::report::{
    FlowReport, HertzReport, LoadReport, PlasticityReport, Report, RollerReport,
    RoughContactReport, StepReport, SubsurfaceReport, SurfaceReport, TargetReport, Timings,
};
use brinell_solver::solver::SolveStatus;
pub(super) use number::significant;

/// Widest line.
const WIDTH: usize = 80;

/// Lays a report out as text. `job` is what was asked.
pub fn table(job: &Job, report: &Report, style: Style) -> String {
    let page = Page { style, names: Names::of(job), text: String::new(), said: Vec::new() };
    page.lay_out(job, report)
}

/// How units and figures are written, which depends on whether the bodies are turned about an
/// axis.
#[derive(Debug, Clone, Copy)]
struct Names {
    length: &'static str,
    stress: &'static str,
    force: &'static str,
    is_round: bool,
    is_three_dimensional: bool,
}

impl Names {
    fn of(job: &Job) -> Self {
        let is_round = job.analysis == Analysis::Axisymmetric;
        let is_three_dimensional = job.analysis == Analysis::ThreeDimensional;
        let [length, stress, force] = [Quantity::Length, Quantity::Stress, job.analysis.force()]
            .map(|q| q.symbol(job.units));
        Self { length, stress, force, is_round, is_three_dimensional }
    }

    fn width(self) -> &'static str {
        match (self.is_round, self.is_three_dimensional) {
            (true, _) => "contact radius",
            (_, true) => "semi-axis a, along x",
            _ => "half-width",
        }
    }

    /// Places along the surface.
    fn abscissa(self) -> &'static str {
        if self.is_round { "r" } else { "x" }
    }

    /// Where piled up material is, on both sides of the axis.
    fn pile_up_abscissa(self) -> &'static str {
        if self.is_round || self.is_three_dimensional { "r" } else { "|x|" }
    }

    /// Unit of work: of a plane body per thickness, whose length cancels with the displacement.
    fn work(self) -> String {
        match self.force.strip_suffix(&format!("/{}", self.length)) {
            Some(force) => force.to_owned(),
            None => format!("{} {}", self.force, self.length),
        }
    }

    fn stiffness(self) -> String {
        if self.is_whole() {
            format!("{}/{}", self.force, self.length)
        } else {
            format!("{}²", self.force)
        }
    }

    /// Hertz's mean pressure over its peak: an ellipse over a line, an ellipsoid over a circle.
    fn mean_of_peak(self) -> f64 {
        if self.is_whole() { 2.0 / 3.0 } else { std::f64::consts::FRAC_PI_4 }
    }

    /// Stresses along the surface and across the section.
    fn tangential(self) -> [&'static str; 2] {
        match (self.is_round, self.is_three_dimensional) {
            (true, _) => ["σ_r", "σ_θ"],
            (_, true) => ["σ_xx", "σ_yy"],
            _ => ["σ_x", "σ_z"],
        }
    }

    /// Whether a force is that of the whole contact and not of a length of it.
    fn is_whole(self) -> bool {
        self.is_round || self.is_three_dimensional
    }
}

/// The text so far.
struct Page {
    style: Style,
    names: Names,
    text: String,
    /// Remarks and datums already written: a remark that holds for every step appears once.
    said: Vec<String>,
}

impl Page {
    fn lay_out(mut self, job: &Job, report: &Report) -> String {
        let analysis = report.analysis.replace('_', " ");
        let title = self.style.bold(&format!("Brinell {}", report.version));
        self.line(&format!("{title} · {analysis} · {}", report.units));
        if let Some(target) = &report.target {
            self.target(job, target);
            self.line("");
        }
        for (name, body) in [("upper", &job.upper), ("lower", &job.lower)] {
            self.line(&wrapped(&format!("{name}  "), &bodies::describe(body, job), ", "));
        }
        for step in &report.steps {
            self.line("");
            self.step(step);
        }
        self.line("");
        let mesh = &report.mesh;
        let half = if mesh.symmetric { " of one half" } else { "" };
        let elements = if self.names.is_three_dimensional { "cells" } else { "elements" };
        self.line(&format!(
            "mesh   {} {elements}, {} equations{half}, spacing {} {}, {} solves",
            mesh.elements,
            mesh.equations,
            significant(mesh.spacing, 3),
            self.names.length,
            mesh.passes
        ));
        self.line(&times(&report.timings_ms));
        self.style.spell(self.text)
    }

    /// The force that the job asked for by what it does.
    fn target(&mut self, job: &Job, target: &TargetReport) {
        let Load::Target(Target { figure, .. }) = &job.load else { return };
        let unit = match figure.figure() {
            Figure::Quantity(quantity) => format!(" {}", quantity.symbol(job.units)),
            Figure::Pure(_) => String::new(),
        };
        let when = match figure {
            TargetFigure::PermanentApproach | TargetFigure::DentDepth => {
                "when this force is taken away"
            }
            _ => "under this force",
        };
        let bar = target
            .relative_error
            .map_or_else(String::new, |error| format!(" ± {} %", significant(100.0 * error, 2)));
        let force =
            self.style.bold(&format!("{} {}", significant(target.force, 7), self.names.force));
        let name = target.figure.replace('_', " ");
        let reached = significant(target.reached, 5);
        self.line(&format!("force for a {name} of {}{unit}: {force}{bar}", target.wanted));
        self.line(&self.style.dim(&format!("it is {reached}{unit} {when}")));
    }

    fn step(&mut self, step: &StepReport) {
        let load = match step.load {
            LoadReport::Force(force) => {
                format!("force {} {}", significant(force, 7), self.names.force)
            }
            LoadReport::Approach(approach) => {
                format!("approach {} {}", significant(approach, 7), self.names.length)
            }
        };
        let (count, style) = (step.history.len(), self.style);
        let count = format!("{count} iteration{}", if count == 1 { "" } else { "s" });
        let status = match step.status {
            SolveStatus::Converged => style.green(&format!("converged in {count}")),
            SolveStatus::NotConverged => style.red(&format!("NOT CONVERGED after {count}")),
            SolveStatus::Cancelled => style.yellow(&format!("cancelled after {count}")),
            SolveStatus::TimedOut => style.yellow(&format!("timed out after {count}")),
        };
        self.line(&format!("{load} · {status}"));
        self.line("");
        if let (true, Some(flow)) = (step.contact.force == 0.0, &step.flow) {
            self.left_behind(step, flow);
        } else {
            self.figures(step);
        }
        let picture = plot::pressure(step, self.names, style);
        if !picture.is_empty() {
            self.line("");
            self.text.push_str(&picture);
        }
        self.line("");
        self.plastic_zone("upper", step.plasticity.upper.as_ref());
        self.plastic_zone("lower", step.plasticity.lower.as_ref());
        self.utilization(step);
        if let Some(flow) = &step.flow {
            self.flow(flow, step.contact.force > 0.0);
        }
        for note in &step.validity {
            if self.said.contains(&note.message) {
                continue;
            }
            self.said.push(note.message.clone());
            let label = style.yellow("note ");
            let text = wrapped("note   ", &words(&note.message), " ");
            self.line(&text.replacen("note ", &label, 1));
        }
        if !step.history.is_empty() {
            self.line("");
            self.text.push_str(&history::history(&step.history, style));
        }
    }

    fn figures(&mut self, step: &StepReport) {
        let (contact, names) = (&step.contact, self.names);
        let error = step.estimated_error.as_ref();
        let hertz = step.hertz.as_ref();
        self.line(
            &self
                .style
                .dim(&format!("{:27}{:>13}{:>13}{:>9}", "", "this contact", "Hertz", "ratio")),
        );
        self.figure(
            ("peak pressure", names.stress),
            contact.peak_pressure,
            hertz.map(|hertz| hertz.peak_pressure),
            error.and_then(|error| error.peak_pressure),
        );
        let half_widths = hertz.map(|hertz| hertz.half_width);
        let error_of_width = error.and_then(|error| error.half_width);
        self.figure(
            (names.width(), names.length),
            contact.half_width,
            half_widths,
            error_of_width,
        );
        if let Some(whole) = &step.three_dimensional {
            let errors = whole.estimated_error.as_ref();
            let longer = whole.hertz.map(|hertz| hertz.b);
            let error = errors.and_then(|errors| errors.b);
            self.figure(("semi-axis b, along y", names.length), whole.b, longer, error);
        }
        if let Some(roller) =
            step.three_dimensional.as_ref().and_then(|whole| whole.roller.as_ref())
        {
            self.roller(roller);
        }
        if let Some(rough) =
            step.three_dimensional.as_ref().and_then(|whole| whole.surface.as_ref())
        {
            self.rough_contact(rough);
        }
        let is_roller =
            step.three_dimensional.as_ref().is_some_and(|whole| whole.roller.is_some());
        let mean = hertz.filter(|_| !is_roller);
        let mean = mean.map(|hertz| names.mean_of_peak() * hertz.peak_pressure);
        self.figure(("mean pressure", names.stress), contact.mean_pressure, mean, None);
        let error_of_approach = error.and_then(|error| error.approach);
        let elastic = step.three_dimensional.as_ref().and_then(|whole| whole.hertz);
        let elastic = elastic.map(|hertz| hertz.approach);
        self.figure(("approach", names.length), step.approach, elastic, error_of_approach);
        if let Some(strain) = step.max_plastic_strain() {
            self.figure(("max plastic strain", "%"), 100.0 * strain, hertz.map(|_| 0.0), None);
        }
        if let Some(whole) = &step.three_dimensional
            && whole.orientation != 0.0
        {
            let angle = significant(whole.orientation, 4);
            self.line(&format!(
                "the x of these figures is the x of the job turned by {angle}° towards its y"
            ));
        }
        if let Some(angle) = contact.half_angle {
            self.line(&format!(
                "it touches over {}° to each side, along the arc",
                significant(angle, 3)
            ));
        }
        if !self.said.contains(&step.approach_datum) {
            self.line(&self.style.dim(&wrapped("approach: ", &words(&step.approach_datum), " ")));
            self.said.push(step.approach_datum.clone());
        }
        if let Some(HertzReport { yield_onset_force: Some(onset), .. }) = hertz {
            let times = significant(contact.force / onset, 3);
            let onset = significant(*onset, 5);
            self.line(&format!(
                "yield begins at {onset} {}; this force is {times} times that",
                names.force
            ));
        }
        if let Some(limit) = hertz.and_then(|hertz| hertz.shakedown_pressure) {
            let limit = significant(limit, 5);
            self.line(&format!(
                "rolling freely, it shakes down up to a Hertz peak of {limit} {}",
                names.stress
            ));
        }
    }

    /// Writes the real contact area and the part of it that has yielded.
    fn rough_contact(&mut self, rough: &RoughContactReport) {
        let stress = self.names.stress;
        self.value("nominal pressure", stress, rough.nominal_pressure, None, "");
        self.value("real contact area", "%", 100.0 * rough.contact_ratio, None, "");
        if let Some(part) = rough.plastic_part {
            self.value("yielded below it", "%", 100.0 * part, None, "");
        }
    }

    /// Pressure in the middle and at the ends of a roller, and its moment.
    fn roller(&mut self, roller: &RollerReport) {
        let [low, high] = roller.end_pressure.map(|pressure| significant(pressure, 5));
        let stress = self.names.stress;
        self.value("pressure in middle", stress, roller.middle_pressure, None, "");
        self.line(&format!(
            "pressure at the ends of the roller: {low} {stress} at -y, {high} {stress} at +y"
        ));
        let moment = significant(roller.moment, 5);
        let (force, length) = (self.names.force, self.names.length);
        self.line(&format!("moment about the x axis in its middle: {moment} {force} {length}"));
    }

    /// Writes the figures after unloading: the bodies are apart, and Hertz's theory does not
    /// apply.
    fn left_behind(&mut self, step: &StepReport, flow: &FlowReport) {
        let length = self.names.length;
        let both = [("upper", &flow.surfaces.upper), ("lower", &flow.surfaces.lower)];
        let surfaces =
            || both.into_iter().filter_map(|(body, surface)| Some((body, surface.as_ref()?)));
        let errors = |body: &str| {
            let whole =
                step.three_dimensional.as_ref().and_then(|whole| whole.estimated_error.as_ref());
            let bodies = whole.map(|errors| errors.bodies).or(step.estimated_error?.bodies)?;
            if body == "upper" { bodies.upper } else { bodies.lower }
        };
        for (body, SurfaceReport { depth, .. }) in surfaces() {
            let error = errors(body).and_then(|errors| errors.depth);
            self.value(&format!("dent, {body} body"), length, *depth, error, "");
        }
        for (body, SurfaceReport { pile_up, pile_up_position, .. }) in surfaces() {
            let place = format!(
                "at {} {}",
                self.names.pile_up_abscissa(),
                significant(*pile_up_position, 3)
            );
            let error = errors(body).and_then(|errors| errors.pile_up);
            self.value(&format!("pile-up, {body} body"), length, *pile_up, error, &place);
        }
        let error = step.estimated_error.as_ref().and_then(|error| error.approach);
        self.value("permanent approach", length, step.approach, error, "");
        for body in ["upper", "lower"] {
            let tensions =
                step.profiles().filter(|(of, _)| *of == body).filter_map(|(_, profile)| {
                    let largest = largest_tension(profile, self.names.tangential())?;
                    Some((largest, step.place_of(profile)))
                });
            let Some(((name, stress, depth), at)) =
                tensions.max_by(|a, b| a.0.1.total_cmp(&b.0.1))
            else {
                continue;
            };
            let (abscissa, at) = (self.names.abscissa(), significant(at, 3));
            let place =
                format!("{name} at {abscissa} {at}, depth {} {length}", significant(depth, 3));
            self.value(&format!("tension, {body} body"), self.names.stress, stress, None, &place);
        }
    }

    fn value(&mut self, name: &str, unit: &str, value: f64, error: Option<f64>, place: &str) {
        let value = self.style.bold(&format!("{:>13}", significant(value, 4)));
        let error = error.filter(|error| *error > 0.0);
        let error = error
            .map_or_else(String::new, |error| format!("± {} %", significant(100.0 * error, 2)));
        let gap = if error.is_empty() { "" } else { "  " };
        self.line(format!("{name:21}{unit:>6}{value}  {error}{gap}{place}").trim_end());
    }

    fn figure(
        &mut self,
        (name, unit): (&str, &str),
        value: f64,
        hertz: Option<f64>,
        error: Option<f64>,
    ) {
        let reference = hertz.map_or_else(|| "—".to_owned(), |hertz| significant(hertz, 5));
        let ratio = match hertz {
            Some(hertz) if hertz > 0.0 => format!("{:.3}", value / hertz),
            _ => String::new(),
        };
        // A prescribed figure, or zero without contact, has no error.
        let error = error.filter(|error| *error > 0.0);
        let error = error
            .map_or_else(String::new, |error| format!("  ± {} %", significant(100.0 * error, 2)));
        let value = self.style.bold(&format!("{:>13}", significant(value, 5)));
        let line = format!("{name:21}{unit:>6}{value}{reference:>13}{ratio:>9}{error}");
        self.line(line.trim_end());
    }

    fn plastic_zone(&mut self, name: &str, zone: Option<&PlasticityReport>) {
        let text = match zone {
            None => "rigid".to_owned(),
            Some(zone) if !zone.yielded => "elastic throughout".to_owned(),
            Some(zone) => self.yielded(zone),
        };
        self.line(&format!("{name}  {text}"));
    }

    /// How much has yielded, and where most; a strain without a limit has no place.
    fn yielded(&self, zone: &PlasticityReport) -> String {
        let length = self.names.length;
        let size = zone.volume.map_or_else(
            || format!("{} {length}²", significant(zone.area, 3)),
            |volume| format!("{} {length}³", significant(volume, 3)),
        );
        let Some(strain) = zone.max_equivalent_plastic_strain else {
            let mean = significant(100.0 * zone.mean_equivalent_plastic_strain, 3);
            return format!("plastic zone {size}; mean strain {mean} %");
        };
        let [strain, x, depth] =
            [100.0 * strain, zone.position, zone.depth].map(|figure| significant(figure, 3));
        let place = match zone.position_y {
            Some(y) => format!("x {x}, y {}", significant(y, 3)),
            None => format!("{} {x}", self.names.abscissa()),
        };
        format!("plastic zone {size}; strain up to {strain} % at {place}, depth {depth} {length}")
    }

    /// Describes where a body of varying strength uses most of its strength, and how much.
    fn utilization(&mut self, step: &StepReport) {
        for name in ["upper", "lower"] {
            let profiles = step.profiles().filter(|(of, _)| *of == name);
            let used = profiles.flat_map(|(_, profile)| {
                let used = profile.utilization.iter().flatten().zip(&profile.depth);
                used.map(|(used, depth)| (*used, *depth, step.place_of(profile)))
            });
            let Some((used, depth, at)) = used.max_by(|a, b| a.0.total_cmp(&b.0)) else {
                continue;
            };
            self.line(&format!(
                "{name}  uses at most {} % of its yield stress, at {} {}, depth {} {}",
                significant(100.0 * used, 3),
                self.names.abscissa(),
                significant(at, 3),
                significant(depth, 3),
                self.names.length
            ));
        }
    }

    /// Writes the figures of flow theory: surfaces, work and unloading stiffness.
    fn flow(&mut self, flow: &FlowReport, loaded: bool) {
        let names = self.names;
        let surfaces = &flow.surfaces;
        for (name, surface) in [("upper", &surfaces.upper), ("lower", &surfaces.lower)] {
            let Some(surface) =
                surface.as_ref().filter(|surface| loaded || surface.yielded_in_reverse)
            else {
                continue;
            };
            // The lines after unloading stand above.
            let depth = format!("surface {} {} deep", significant(surface.depth, 4), names.length);
            let pile_up = format!(
                "pile-up {} {} at {} {}",
                significant(surface.pile_up, 3),
                names.length,
                names.pile_up_abscissa(),
                significant(surface.pile_up_position, 3),
            );
            let words = [
                (loaded, depth),
                (loaded && surface.pile_up > 0.0, pile_up),
                (surface.yielded_in_reverse, "yielded in reverse".to_owned()),
            ];
            let words: Vec<String> =
                words.into_iter().filter(|(is_so, _)| *is_so).map(|(_, one)| one).collect();
            self.line(&wrapped(&format!("{name}  "), &words, ", "));
        }
        let energy = &flow.energy;
        let stored = significant(energy.stored, 3);
        let stored = if energy.stored > 0.0 {
            format!(", stored by backstress {stored}")
        } else {
            String::new()
        };
        self.line(&format!(
            "work   {} {}: elastic {}, dissipated {}{stored}",
            significant(energy.work, 4),
            names.work(),
            significant(energy.elastic, 3),
            significant(energy.dissipated, 3),
        ));
        if flow.unloading_stiffness > 0.0 {
            let stiffness = significant(flow.unloading_stiffness, 4);
            self.line(&format!("unloading stiffness {stiffness} {}", names.stiffness()));
        }
    }

    fn line(&mut self, text: &str) {
        self.text.push_str(text);
        self.text.push('\n');
    }
}

/// The largest of the stresses along the surface and across the section, where that is a tension:
/// name, stress, depth.
fn largest_tension(
    profile: &SubsurfaceReport,
    [along, across]: [&'static str; 2],
) -> Option<(&'static str, f64, f64)> {
    let column = |name, stresses: &[f64]| {
        let largest = stresses.iter().copied().zip(profile.depth.iter().copied());
        largest.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(stress, depth)| (name, stress, depth))
    };
    let both = [column(along, &profile.sigma_x), column(across, &profile.sigma_z)];
    both.into_iter()
        .flatten()
        .filter(|(_, stress, _)| *stress > 0.0)
        .max_by(|a, b| a.1.total_cmp(&b.1))
}

/// One line: the total and the phases that matter, the longest first.
fn times(timings: &Timings) -> String {
    let mut phases = [
        ("mesh", timings.mesh),
        ("assembly", timings.assembly),
        ("ordering", timings.ordering),
        ("symbolic", timings.symbolic),
        ("numeric", timings.numeric),
        ("flexibility", timings.flexibility),
        ("contact", timings.contact),
        ("plasticity", timings.plasticity),
        ("solves", timings.solves),
        ("output", timings.output),
    ];
    phases.sort_by(|(_, one), (_, other)| other.total_cmp(one));
    let mut text = format!("time   {} ms", significant(timings.total, 3));
    for (number, (name, time)) in
        phases.into_iter().filter(|(_, time)| *time > 0.0).take(4).enumerate()
    {
        let separator = if number == 0 { ": " } else { ", " };
        let _ = write!(text, "{separator}{name} {}", significant(time, 2));
    }
    text
}

fn words(text: &str) -> Vec<String> {
    text.split_whitespace().map(str::to_owned).collect()
}

/// Items after a label, broken into lines that are indented like the first.
fn wrapped(label: &str, items: &[String], separator: &str) -> String {
    let indent = label.chars().count();
    let (mut text, mut column) = (label.to_owned(), indent);
    for (number, item) in items.iter().enumerate() {
        let width = item.chars().count();
        if number > 0 {
            if column + separator.len() + width > WIDTH {
                text.push_str(separator.trim_end());
                text.push('\n');
                text.push_str(&" ".repeat(indent));
                column = indent;
            } else {
                text.push_str(separator);
                column += separator.len();
            }
        }
        text.push_str(item);
        column += width;
    }
    text
}
