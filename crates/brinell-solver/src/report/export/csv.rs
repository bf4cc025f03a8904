//! CSV tables with a header row that names the units, and a block of rows for each load step.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use strum::VariantArray as _;

use super::{Export, ExportError};
use crate::job::{Analysis, Job, Named, Quantity, Units};
use crate::report::{
    Answer, AnswerAt, AnswerBody, Course, FatigueCriterion, FatigueReport, Name, PassesReport,
    PerBody, Report, SolvedHardening, StepReport, SubsurfaceReport,
};

/// A table of all load steps, written one by one.
#[derive(Debug, Clone)]
pub struct Table {
    form: Export,
    units: Units,
    force: Quantity,
    /// Names of the directions along the surface, along the normal and across the section.
    /// Stresses use all three names; positions along the surface use the first name.
    directions: [&'static str; 3],
    /// Columns of the summary.
    columns: Vec<Column>,
    /// Columns of the passes: of the contact, the upper and the lower body.
    passes: [Vec<String>; 3],
    of_depth: ColumnsOfDepth,
}

/// A column of figures of one name.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Column {
    name: String,
    body: Option<AnswerBody>,
    hardening: Option<SolvedHardening>,
    criterion: Option<FatigueCriterion>,
    quantity: Quantity,
}

impl Column {
    fn of(row: &Answer) -> Self {
        let AnswerAt { hardening, criterion, .. } = row.at.unwrap_or_default();
        let (name, body, quantity) = (row.name.clone(), row.body, row.quantity);
        Self { name, body, hardening, criterion, quantity }
    }

    fn heading(&self, unit: &str) -> String {
        let body = match self.body {
            Some(AnswerBody::Upper) => "upper_",
            Some(AnswerBody::Lower) => "lower_",
            Some(AnswerBody::Both) | None => "",
        };
        let rule = self.hardening.map(|rule| format!("_{}", rule.name())).unwrap_or_default();
        let criterion = self.criterion.map(|of| format!("_{}", of.name())).unwrap_or_default();
        format!("{body}{}{criterion}{rule}{}", self.name, in_brackets(unit))
    }
}

/// Columns that a table over depth has where a body needs them.
#[derive(Debug, Clone, Copy)]
struct ColumnsOfDepth {
    /// Those of a strength over depth.
    is_graded: bool,
    /// Those of an initial stress.
    is_stressed: bool,
}

impl Table {
    /// Returns a table of this form. `first` is the first load step; a summary has the columns of
    /// the steps that it [has seen](Self::see).
    ///
    /// # Errors
    /// [`ExportError::NoSubsurface`], [`ExportError::NoFlow`], [`ExportError::Rolling`],
    /// [`ExportError::NotRolling`], [`ExportError::NoFatigue`] or [`ExportError::NoHardness`] if the
    /// first load step has no rows.
    pub fn new(form: Export, job: &Job, first: &StepReport) -> Result<Self, ExportError> {
        match form {
            Export::SubsurfaceCsv if first.subsurface.is_none() => {
                return Err(ExportError::NoSubsurface);
            }
            Export::IncrementsCsv | Export::SurfaceCsv if first.increments.is_none() => {
                return Err(ExportError::without_flow(first));
            }
            Export::HardnessCsv if job.load.hardness().is_none() || first.increments.is_none() => {
                return Err(ExportError::NoHardness);
            }
            Export::FatigueCsv if !has_fatigue(first) => return Err(ExportError::NoFatigue),
            Export::PassesCsv if first.passes.is_none() => return Err(ExportError::NotRolling),
            _ => {}
        }
        let profiles = || first.profiles().map(|(_, body)| body);
        Ok(Self {
            form,
            units: job.units,
            force: job.analysis.force().quantity(),
            directions: match job.analysis {
                Analysis::Axisymmetric => ["r", "z", "theta"],
                Analysis::ThreeDimensional => ["xx", "zz", "yy"],
                Analysis::PlaneStrain | Analysis::PlaneStress => ["x", "y", "z"],
            },
            columns: Vec::new(),
            passes: first.passes.as_ref().map(names_of).unwrap_or_default(),
            of_depth: ColumnsOfDepth {
                is_graded: profiles().any(|body| body.yield_stress.is_some()),
                is_stressed: profiles().any(|body| body.initial_sigma_x.is_some()),
            },
        })
    }

    /// Adds the columns of a load step to a summary, in the order of the names.
    pub fn see(&mut self, step: &StepReport) {
        for column in step.answers.iter().map(Column::of) {
            if !self.columns.contains(&column) {
                self.columns.push(column);
            }
        }
        let place = |column: &Column| {
            let known = Name::VARIANTS.iter().position(|name| name.name() == column.name);
            (known, column.heading(""))
        };
        self.columns.sort_by_cached_key(place);
    }

    fn has_cells(&self) -> bool {
        self.directions[0] == "xx"
    }

    /// Returns the first line, which names columns and units.
    pub fn header(&self) -> String {
        let symbol = |quantity: Quantity| self.units.symbol(quantity);
        let (force, length, stress) =
            (symbol(self.force), symbol(Quantity::Length), symbol(Quantity::Stress));
        match self.form {
            Export::PressureCsv if self.has_cells() => {
                format!("step,x [{length}],y [{length}],pressure [{stress}],gap [{length}]\n")
            }
            Export::PressureCsv => {
                format!("step,x [{length}],pressure [{stress}],force [{force}],gap [{length}]\n")
            }
            Export::SubsurfaceCsv => {
                let strength = format!(",yield_stress [{stress}],utilization");
                let of = |prefix: &str| {
                    self.directions
                        .map(|direction| format!(",{prefix}sigma_{direction} [{stress}]"))
                        .concat()
                };
                let initial = of("initial_");
                let across = format!(
                    ",y [{length}],sigma_xy [{stress}],sigma_xz [{stress}],sigma_yz [{stress}]"
                );
                format!(
                    "step,body,depth [{length}]{},tau_max [{stress}],von_mises [{stress}],\
                     equivalent_plastic_strain{}{},{} [{length}]{}\n",
                    of(""),
                    if self.of_depth.is_graded { strength.as_str() } else { "" },
                    if self.of_depth.is_stressed { initial.as_str() } else { "" },
                    if self.directions[0] == "r" { "r" } else { "x" },
                    if self.has_cells() { across.as_str() } else { "" },
                )
            }
            Export::IncrementsCsv => format!(
                "step,increment,force [{force}],approach [{length}],peak_pressure [{stress}],\
                 half_width [{length}],iterations\n"
            ),
            Export::HardnessCsv => format!(
                "step,displacement [{length}],force [{force}],diameter [{length}],mean_pressure \
                 [{stress}]\n"
            ),
            Export::PassesCsv => self.heading_of_passes(),
            Export::FatigueCsv => {
                let names = FatigueCriterion::VARIANTS.iter().map(|of| format!(",{}", of.name()));
                format!("step,body,depth [{length}]{}\n", names.collect::<String>())
            }
            Export::SurfaceCsv => format!("step,body,x [{length}],height [{length}]\n"),
            _ => {
                let column = |column: &Column| {
                    format!(",{}", column.heading(self.units.symbol(column.quantity)))
                };
                let columns: String = self.columns.iter().map(column).collect();
                format!("step,status{columns}\n")
            }
        }
    }

    /// Returns the heading of a table of passes.
    fn heading_of_passes(&self) -> String {
        let of = |(body, names): (&str, &Vec<String>)| {
            let column = |name: &String| {
                let known = Name::VARIANTS.iter().find(|known| known.name() == name);
                let quantity = known.map_or(Quantity::Number, |name| name.quantity());
                let unit = match quantity {
                    Quantity::Force => self.units.symbol(self.force),
                    quantity => self.units.symbol(quantity),
                };
                format!(",{body}{name}{}", in_brackets(unit))
            };
            names.iter().map(column).collect::<String>()
        };
        let columns = ["", "upper_", "lower_"].into_iter().zip(&self.passes).map(of);
        format!("step,pass,iterations{}\n", columns.collect::<String>())
    }

    /// Returns the rows of a load step, counted from 1.
    pub fn rows(&self, number: usize, step: &StepReport) -> String {
        let mut text = String::new();
        match self.form {
            Export::PressureCsv if self.has_cells() => cells(&mut text, number, step),
            Export::PressureCsv => pressure(&mut text, number, step),
            Export::SubsurfaceCsv => self.subsurface(&mut text, number, step),
            Export::IncrementsCsv => increments(&mut text, number, step),
            Export::HardnessCsv => hardness(&mut text, number, step),
            Export::PassesCsv => self.passes(&mut text, number, step),
            Export::FatigueCsv => fatigue(&mut text, number, step),
            Export::SurfaceCsv => surfaces(&mut text, number, step),
            _ => self.summary(&mut text, number, step),
        }
        text
    }

    /// Writes one row with the figures of a load step. A column of another step is empty.
    fn summary(&self, text: &mut String, number: usize, step: &StepReport) {
        let _ = write!(text, "{number},{}", Named::name(step.status));
        for column in &self.columns {
            let row = step.answers.iter().find(|row| Column::of(row) == *column);
            let value = row.and_then(|row| row.value);
            let _ = write!(text, ",{}", value.map_or_else(String::new, |value| value.to_string()));
        }
        text.push('\n');
    }

    /// Writes a row for each pass.
    fn passes(&self, text: &mut String, number: usize, step: &StepReport) {
        let Some(passes) = &step.passes else { return };
        let [of_contact, of_upper, of_lower] = &self.passes;
        let parts =
            [(&passes.contact, of_contact), (&passes.upper, of_upper), (&passes.lower, of_lower)];
        for (k, (pass, iterations)) in passes.number.iter().zip(&passes.iterations).enumerate() {
            let _ = write!(text, "{number},{pass},{iterations}");
            for (columns, names) in parts {
                for name in names {
                    let value = columns.get(name).and_then(|course| course.value.get(k));
                    let _ = write!(text, ",{}", value.map_or_else(String::new, f64::to_string));
                }
            }
            text.push('\n');
        }
    }

    /// Writes stresses and plastic strain along the normals below the middle of the contact and
    /// below the peak pressure, with the position of the normal at the end of each row.
    fn subsurface(&self, text: &mut String, number: usize, step: &StepReport) {
        for (name, body) in step.profiles() {
            write_profile(text, (number, name), body, self.of_depth);
        }
    }
}

/// Returns the names of the columns of passes.
fn names_of(passes: &PassesReport) -> [Vec<String>; 3] {
    let names = |columns: &BTreeMap<String, Course>| columns.keys().cloned().collect();
    [&passes.contact, &passes.upper, &passes.lower].map(names)
}

/// Returns a unit as the end of a heading, without characters beyond ASCII.
fn in_brackets(unit: &str) -> String {
    let unit = unit.replace('²', "2").replace('³', "3").replace('°', "degree");
    if unit.is_empty() { unit } else { format!(" [{unit}]") }
}

/// Returns the table of a report.
pub(super) fn table(form: Export, job: &Job, report: &Report) -> Result<String, ExportError> {
    let first = report.steps.first().ok_or(ExportError::NoStep(0))?;
    let mut table = Table::new(form, job, first)?;
    report.steps.iter().for_each(|step| table.see(step));
    let rows = (1..).zip(&report.steps).map(|(number, step)| table.rows(number, step));
    Ok([table.header()].into_iter().chain(rows).collect())
}

/// Writes `step, x, pressure, force, gap` of every candidate pair.
fn pressure(text: &mut String, number: usize, step: &StepReport) {
    let nodes = &step.contact.nodes;
    let columns = nodes.x.iter().zip(&nodes.pressure).zip(&nodes.force).zip(&nodes.gap);
    for (((x, pressure), force), gap) in columns {
        let _ = writeln!(text, "{number},{x},{pressure},{force},{gap}");
    }
}

/// Writes `step, x, y, pressure, gap` of all cells if the job asks for fields, else of the cells
/// of the sections y = 0 and x = 0.
fn cells(text: &mut String, number: usize, step: &StepReport) {
    let mut row = |x: f64, y: f64, pressure: f64, gap: f64| {
        let _ = writeln!(text, "{number},{x},{y},{pressure},{gap}");
    };
    let contact = &step.contact;
    if let Some(maps) = &contact.maps {
        let places = maps.x.iter().flat_map(|x| maps.y.iter().map(move |y| (*x, *y)));
        for ((x, y), (pressure, gap)) in places.zip(maps.pressure.iter().zip(&maps.gap)) {
            row(x, y, *pressure, *gap);
        }
        return;
    }
    let nodes = &contact.nodes;
    for (x, (pressure, gap)) in nodes.x.iter().zip(nodes.pressure.iter().zip(&nodes.gap)) {
        row(*x, 0.0, *pressure, *gap);
    }
    if let Some(section) = &contact.section {
        let values = section.pressure.iter().zip(&section.gap);
        for (y, (pressure, gap)) in section.y.iter().zip(values) {
            row(0.0, *y, *pressure, *gap);
        }
    }
}

fn has_fatigue(step: &StepReport) -> bool {
    let is_known =
        |both: &PerBody<Option<FatigueReport>>| both.upper.is_some() || both.lower.is_some();
    step.fatigue.as_ref().is_some_and(is_known)
}

/// Writes `step, body, depth` and the utilization by each criterion.
fn fatigue(text: &mut String, number: usize, step: &StepReport) {
    let Some(PerBody { upper, lower }) = &step.fatigue else { return };
    for (name, body) in [("upper", upper), ("lower", lower)] {
        let Some(FatigueReport { depth, dang_van, crossland, orthogonal_shear }) = body else {
            continue;
        };
        for (k, depth) in depth.iter().enumerate() {
            let _ = write!(text, "{number},{name},{depth}");
            for column in [dang_van, crossland, orthogonal_shear] {
                let value = column.as_ref().and_then(|column| column.get(k));
                let _ = write!(text, ",{}", value.map_or_else(String::new, f64::to_string));
            }
            text.push('\n');
        }
    }
}

/// Writes `step, increment, force, approach, peak_pressure, half_width, iterations` of every
/// increment.
fn increments(text: &mut String, number: usize, step: &StepReport) {
    let Some(ends) = &step.increments else { return };
    let columns = ends.force.iter().zip(&ends.approach).zip(&ends.peak_pressure);
    let columns = columns.zip(&ends.half_width).zip(&ends.iterations);
    for (n, ((((force, approach), peak), half_width), iterations)) in columns.enumerate() {
        let _ = writeln!(
            text,
            "{number},{},{force},{approach},{peak},{half_width},{iterations}",
            n + 1
        );
    }
}

/// Writes `step, displacement, force, diameter, mean_pressure` of a hardness test from rest on. The
/// pressure is empty without contact.
fn hardness(text: &mut String, number: usize, step: &StepReport) {
    let Some(ends) = &step.increments else { return };
    if number == 1 {
        text.push_str("1,0,0,0,\n");
    }
    let columns = ends.force.iter().zip(&ends.approach).zip(&ends.half_width);
    for ((force, approach), half_width) in columns {
        let area = std::f64::consts::PI * half_width * half_width;
        let pressure = if area > 0.0 { (force / area).to_string() } else { String::new() };
        let _ = writeln!(text, "{number},{approach},{force},{},{pressure}", 2.0 * half_width);
    }
}

/// Writes `step, body, x, height` of the surfaces. Heights are outward from the undeformed
/// surface: without force they show the dent and its pile-up.
fn surfaces(text: &mut String, number: usize, step: &StepReport) {
    let Some(surfaces) = &step.surfaces else { return };
    for (name, surface) in [("upper", &surfaces.upper), ("lower", &surfaces.lower)] {
        for (x, height) in surface.iter().flat_map(|surface| surface.x.iter().zip(&surface.height))
        {
            let _ = writeln!(text, "{number},{name},{x},{height}");
        }
    }
}

/// Writes the rows of one body along one normal. Columns of varying strength or of initial stress
/// are empty for a body that has none.
fn write_profile(
    text: &mut String,
    (step, name): (usize, &str),
    body: &SubsurfaceReport,
    ColumnsOfDepth { is_graded, is_stressed }: ColumnsOfDepth,
) {
    for (k, depth) in body.depth.iter().enumerate() {
        let columns = [
            &body.sigma_x,
            &body.sigma_y,
            &body.sigma_z,
            &body.tau_max,
            &body.von_mises,
            &body.equivalent_plastic_strain,
        ];
        let _ = write!(text, "{step},{name},{depth}");
        for column in columns {
            let _ = write!(text, ",{}", column.get(k).copied().unwrap_or(0.0));
        }
        let of_strength =
            [&body.yield_stress, &body.utilization].into_iter().filter(|_| is_graded);
        let initial = [&body.initial_sigma_x, &body.initial_sigma_y, &body.initial_sigma_z];
        for column in of_strength.chain(initial.into_iter().filter(|_| is_stressed)) {
            let value = column.as_ref().and_then(|column| column.get(k));
            let _ = write!(text, ",{}", value.map_or_else(String::new, f64::to_string));
        }
        for place in &body.position {
            let _ = write!(text, ",{place}");
        }
        if body.position.len() > 1 {
            for column in [&body.sigma_xy, &body.sigma_xz, &body.sigma_yz].into_iter().flatten() {
                let _ = write!(text, ",{}", column.get(k).copied().unwrap_or(0.0));
            }
        }
        text.push('\n');
    }
}
