//! CSV tables with a header row that names the units, and a block of rows for each load step.

use std::fmt::Write as _;

use super::{Export, ExportError};
use crate::job::{Analysis, Job, Named, Quantity, Units};
use crate::report::{
    AnswerBody, BodyPassReport, FlowReport, PassReport, Report, StepReport, SubsurfaceReport,
    ThreeDimensionalReport,
};
use crate::solver::method::figures::Figure;

/// A table of all load steps, written one by one.
#[derive(Debug, Clone, Copy)]
pub struct Table {
    form: Export,
    units: Units,
    force: Quantity,
    /// Names of the directions along the surface, along the normal and across the section.
    /// Stresses use all three names; positions along the surface use the first name.
    directions: [&'static str; 3],
    /// Whether the table has the columns of an ellipse and of flow theory.
    has_ellipse: bool,
    has_flow: bool,
    of_depth: ColumnsOfDepth,
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
    /// Returns a table of this form with the columns of the first load step. Later load steps have
    /// no further columns.
    ///
    /// # Errors
    /// [`ExportError::NoSubsurface`], [`ExportError::NoFlow`], [`ExportError::Rolling`],
    /// [`ExportError::NotRolling`] or [`ExportError::NoHardness`] if the first load step has no
    /// rows.
    pub fn new(form: Export, job: &Job, first: &StepReport) -> Result<Self, ExportError> {
        match form {
            Export::SubsurfaceCsv if first.subsurface.is_none() => {
                return Err(ExportError::NoSubsurface);
            }
            Export::IncrementsCsv | Export::SurfaceCsv if first.flow.is_none() => {
                return Err(ExportError::without_flow(first));
            }
            Export::HardnessCsv if job.load.hardness().is_none() || first.flow.is_none() => {
                return Err(ExportError::NoHardness);
            }
            Export::PassesCsv if first.rolling.is_none() => return Err(ExportError::NotRolling),
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
            has_ellipse: first.three_dimensional.is_some(),
            has_flow: first.flow.is_some(),
            of_depth: ColumnsOfDepth {
                is_graded: profiles().any(|body| body.yield_stress.is_some()),
                is_stressed: profiles().any(|body| body.initial_sigma_x.is_some()),
            },
        })
    }

    fn is_three_dimensional(&self) -> bool {
        self.directions[0] == "xx"
    }

    /// Returns the first line, which names columns and units.
    pub fn header(&self) -> String {
        let symbol = |quantity: Quantity| self.units.symbol(quantity);
        let (force, length, stress) =
            (symbol(self.force), symbol(Quantity::Length), symbol(Quantity::Stress));
        match self.form {
            Export::PressureCsv if self.has_ellipse => {
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
                    if self.is_three_dimensional() { across.as_str() } else { "" },
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
            Export::SurfaceCsv => format!("step,body,x [{length}],height [{length}]\n"),
            _ => {
                let ellipse = format!(
                    ",semi_axis_b [{length}],area [{length}2],orientation [degree],plastic_volume \
                     [{length}3]"
                );
                let flow = format!(
                    ",unloading_stiffness [{force}/{length}],upper_dent [{length}],upper_pile_up \
                     [{length}],lower_dent [{length}],lower_pile_up [{length}],work [{force} \
                     {length}],dissipated [{force} {length}],increments"
                );
                format!(
                    "step,status,force [{force}],approach [{length}],peak_pressure [{stress}],\
                     mean_pressure [{stress}],half_width [{length}],contact_stiffness \
                     [{force}/{length}],\
                     max_equivalent_plastic_strain{}{}{}\n",
                    if self.has_flow { flow.as_str() } else { "" },
                    if self.has_ellipse { ellipse.as_str() } else { "" },
                    self.answers_alone(),
                )
            }
        }
    }

    /// Returns the heading of a table of passes.
    fn heading_of_passes(&self) -> String {
        let column = |(name, quantity): (&str, Option<Quantity>)| {
            let unit = quantity.map(|quantity| format!(" [{}]", self.unit(quantity)));
            format!(",{name}{}", unit.unwrap_or_default())
        };
        let columns = OF_PASS.iter().map(|(name, quantity, _)| (*name, *quantity));
        let columns = columns.chain(OF_BODY.iter().map(|(name, quantity, _)| (*name, *quantity)));
        format!("step,pass,body{}\n", columns.map(column).collect::<String>())
    }

    /// Returns the unit of a quantity, without characters beyond ASCII.
    fn unit(&self, quantity: Quantity) -> String {
        match quantity {
            Quantity::Area => format!("{}2", self.units.symbol(Quantity::Length)),
            Quantity::Force => self.units.symbol(self.force).to_owned(),
            quantity => self.units.symbol(quantity).to_owned(),
        }
    }

    /// Returns the columns of the figures that are answers and have no member.
    fn answers_alone(&self) -> String {
        let column = |(body, figure): (&str, Figure)| {
            let unit = Some(self.unit(figure.quantity())).filter(|unit| !unit.is_empty());
            let unit = unit.map(|unit| format!(" [{unit}]")).unwrap_or_default();
            format!(",{body}{}{unit}", figure.name())
        };
        answers_alone().map(|(body, figure, _)| column((body, figure))).collect()
    }

    /// Returns the rows of a load step, counted from 1.
    pub fn rows(&self, number: usize, step: &StepReport) -> String {
        let mut text = String::new();
        match self.form {
            Export::PressureCsv => match &step.three_dimensional {
                Some(whole) => cells(&mut text, number, step, whole),
                None => pressure(&mut text, number, step),
            },
            Export::SubsurfaceCsv => self.subsurface(&mut text, number, step),
            Export::IncrementsCsv => increments(&mut text, number, step),
            Export::HardnessCsv => hardness(&mut text, number, step),
            Export::PassesCsv => passes(&mut text, number, step),
            Export::SurfaceCsv => surfaces(&mut text, number, step),
            _ => self.summary(&mut text, number, step),
        }
        text
    }

    /// Writes one row with the figures of a load step, and with dents and energies under flow
    /// theory.
    fn summary(&self, text: &mut String, number: usize, step: &StepReport) {
        let status = Named::name(step.status);
        let strain =
            step.max_plastic_strain().map_or_else(String::new, |strain| strain.to_string());
        let contact = &step.contact;
        let _ = write!(
            text,
            "{number},{status},{},{},{},{},{},{},{strain}",
            contact.force,
            step.approach.map_or_else(String::new, |approach| approach.to_string()),
            contact.peak_pressure,
            contact.mean_pressure,
            contact.half_width,
            step.contact_stiffness.map_or_else(String::new, |slope| slope.to_string()),
        );
        if self.has_flow {
            write_flow(text, step.flow.as_ref());
        }
        if let Some(whole) = &step.three_dimensional {
            let zones = [&step.plasticity.upper, &step.plasticity.lower];
            let volume: f64 = zones.into_iter().flatten().filter_map(|zone| zone.volume).sum();
            let _ = write!(text, ",{},{},{},{volume}", whole.b, whole.area, whole.orientation);
        }
        for (_, figure, sides) in answers_alone() {
            let mut found = step.answers.iter().filter(|answer| answer.name == figure.name());
            let value =
                found.find(|answer| sides.contains(&answer.body)).and_then(|found| found.value);
            let _ = write!(text, ",{}", value.map_or_else(String::new, |value| value.to_string()));
        }
        text.push('\n');
    }

    /// Writes stresses and plastic strain along the normals below the middle of the contact and
    /// below the peak pressure, with the position of the normal at the end of each row.
    fn subsurface(&self, text: &mut String, number: usize, step: &StepReport) {
        for (name, body) in step.profiles() {
            write_profile(text, (number, name, step.place_of(body)), body, self.of_depth);
        }
    }
}

/// Returns the figures that are answers and have no member: the beginning of their column, and
/// whose answer it may be.
fn answers_alone() -> impl Iterator<Item = (&'static str, Figure, [Option<AnswerBody>; 2])> {
    let both = Some(AnswerBody::Both);
    let alone = Figure::ALL.iter().filter(|figure| !figure.has_member());
    alone.flat_map(move |figure| {
        let of_bodies = [
            ("upper_", *figure, [Some(AnswerBody::Upper), both]),
            ("lower_", *figure, [Some(AnswerBody::Lower), both]),
        ];
        let of_contact = [("", *figure, [None; 2])];
        let columns: &[_] = if figure.is_of_body() { &of_bodies } else { &of_contact };
        columns.to_vec()
    })
}

/// Returns the table of a report.
pub(super) fn table(form: Export, job: &Job, report: &Report) -> Result<String, ExportError> {
    let first = report.steps.first().ok_or(ExportError::NoStep(0))?;
    let table = Table::new(form, job, first)?;
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
fn cells(text: &mut String, number: usize, step: &StepReport, whole: &ThreeDimensionalReport) {
    let mut row = |x: f64, y: f64, pressure: f64, gap: f64| {
        let _ = writeln!(text, "{number},{x},{y},{pressure},{gap}");
    };
    if let Some(maps) = &whole.maps {
        let places = maps.x.iter().flat_map(|x| maps.y.iter().map(move |y| (*x, *y)));
        for ((x, y), (pressure, gap)) in places.zip(maps.pressure.iter().zip(&maps.gap)) {
            row(x, y, *pressure, *gap);
        }
        return;
    }
    let (nodes, section) = (&step.contact.nodes, &whole.section);
    for (x, (pressure, gap)) in nodes.x.iter().zip(nodes.pressure.iter().zip(&nodes.gap)) {
        row(*x, 0.0, *pressure, *gap);
    }
    for (y, (pressure, gap)) in section.y.iter().zip(section.pressure.iter().zip(&section.gap)) {
        row(0.0, *y, *pressure, *gap);
    }
}

/// Writes `step, increment, force, approach, peak_pressure, half_width, iterations` of every
/// increment.
fn increments(text: &mut String, number: usize, step: &StepReport) {
    let Some(ends) = step.flow.as_ref().map(|flow| &flow.increments) else { return };
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
    let Some(ends) = step.flow.as_ref().map(|flow| &flow.increments) else { return };
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

/// A column: its name, its quantity if it has a unit, and the figure; `None` of one that is empty.
type Column<T> = (&'static str, Option<Quantity>, fn(&T) -> Option<f64>);

/// Columns of a pass.
const OF_PASS: [Column<PassReport>; 11] = [
    ("iterations", None, |pass| Some(pass.iterations as f64)),
    ("peak_pressure", Some(Quantity::Stress), |pass| Some(pass.peak_pressure)),
    ("half_width", Some(Quantity::Length), |pass| Some(pass.half_width)),
    ("half_width_across", Some(Quantity::Length), |pass| pass.half_width_across),
    ("approach", Some(Quantity::Length), |pass| pass.approach),
    ("rolling_force", Some(Quantity::Force), |pass| Some(pass.rolling_force)),
    ("loss", None, |pass| Some(pass.loss)),
    ("plastic_work", Some(Quantity::Force), |pass| Some(pass.plastic_work)),
    ("stored_energy", Some(Quantity::Force), |pass| Some(pass.stored_energy)),
    ("traction_work", Some(Quantity::Force), |pass| Some(pass.traction_work)),
    ("energy_gap", None, |pass| Some(pass.energy_gap)),
];

/// Columns of what a pass leaves in a body.
const OF_BODY: [Column<BodyPassReport>; 14] = [
    ("groove_depth", Some(Quantity::Length), |body| Some(body.groove_depth)),
    ("pile_up", Some(Quantity::Length), |body| Some(body.pile_up)),
    ("forward", Some(Quantity::Length), |body| Some(body.forward)),
    ("largest_strain", None, |body| Some(body.largest_strain)),
    ("largest_strain_depth", Some(Quantity::Length), |body| Some(body.largest_strain_depth)),
    ("largest_strain_across", Some(Quantity::Length), |body| Some(body.largest_strain_across)),
    ("net_strain", None, |body| Some(body.net_strain)),
    ("net_strain_depth", Some(Quantity::Length), |body| Some(body.net_strain_depth)),
    ("net_strain_across", Some(Quantity::Length), |body| Some(body.net_strain_across)),
    ("accumulated_strain", None, |body| Some(body.accumulated_strain)),
    ("least_sigma_x", Some(Quantity::Stress), |body| Some(body.least_sigma_x)),
    ("largest_sigma_x", Some(Quantity::Stress), |body| Some(body.largest_sigma_x)),
    ("least_sigma_z", Some(Quantity::Stress), |body| Some(body.least_sigma_z)),
    ("largest_sigma_z", Some(Quantity::Stress), |body| Some(body.largest_sigma_z)),
];

/// Writes a row for each pass and each body that can yield; one without a body where none can.
fn passes(text: &mut String, number: usize, step: &StepReport) {
    let value = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    for pass in step.rolling.iter().flat_map(|rolling| &rolling.passes) {
        let sides = [("upper", &pass.bodies.upper), ("lower", &pass.bodies.lower)];
        let mut bodies: Vec<(&str, Option<&BodyPassReport>)> = sides
            .into_iter()
            .filter_map(|(name, body)| Some((name, Some(body.as_ref()?))))
            .collect();
        if bodies.is_empty() {
            bodies.push(("", None));
        }
        for (name, body) in bodies {
            let _ = write!(text, "{number},{},{name}", pass.number);
            for (_, _, of) in &OF_PASS {
                let _ = write!(text, ",{}", value(of(pass)));
            }
            for (_, _, of) in &OF_BODY {
                let _ = write!(text, ",{}", value(body.and_then(of)));
            }
            text.push('\n');
        }
    }
}

/// Writes `step, body, x, height` of the surfaces. Heights are outward from the undeformed
/// surface: without force they show the dent and its pile-up.
fn surfaces(text: &mut String, number: usize, step: &StepReport) {
    let Some(flow) = &step.flow else { return };
    for (name, surface) in [("upper", &flow.surfaces.upper), ("lower", &flow.surfaces.lower)] {
        for (x, height) in surface.iter().flat_map(|surface| surface.x.iter().zip(&surface.height))
        {
            let _ = writeln!(text, "{number},{name},{x},{height}");
        }
    }
}

/// Writes the columns of flow theory. The columns of a rigid body are empty.
fn write_flow(text: &mut String, flow: Option<&FlowReport>) {
    let Some(flow) = flow else {
        text.push_str(",,,,,,,,");
        return;
    };
    let _ = write!(text, ",{}", flow.unloading_stiffness);
    for surface in [&flow.surfaces.upper, &flow.surfaces.lower] {
        match surface {
            Some(surface) => {
                let _ = write!(text, ",{},{}", surface.depth, surface.pile_up);
            }
            None => text.push_str(",,"),
        }
    }
    let energy = &flow.energy;
    let _ = write!(text, ",{},{},{}", energy.work, energy.dissipated, flow.increments.force.len());
}

/// Writes the rows of one body along one normal. Columns of varying strength or of initial stress
/// are empty for a body that has none.
fn write_profile(
    text: &mut String,
    (step, name, place): (usize, &str, f64),
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
        let _ = write!(text, ",{place}");
        if let Some(y) = body.position_y {
            let _ = write!(text, ",{y}");
            for column in [&body.sigma_xy, &body.sigma_xz, &body.sigma_yz].into_iter().flatten() {
                let _ = write!(text, ",{}", column.get(k).copied().unwrap_or(0.0));
            }
        }
        text.push('\n');
    }
}
