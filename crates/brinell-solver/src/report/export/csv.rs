//! Tables with a header row that names the units; one block of rows for each step.

use std::fmt::Write as _;

use super::ExportError;
use crate::job::{Named, Quantity, Units};
use crate::report::{FlowReport, Report, StepReport, SubsurfaceReport};

fn units(report: &Report) -> Units {
    if report.units == Units::Si.name() { Units::Si } else { Units::MmNMpa }
}

/// Places along the surface: the distance from the axis in axisymmetry.
fn abscissa(report: &Report) -> &'static str {
    if report.analysis == "axisymmetric" { "r" } else { "x" }
}

/// One row of figures for each step, as a spreadsheet wants them; of a history by flow theory with its dents and energies.
pub fn summary_csv(report: &Report) -> String {
    let units = units(report);
    let force = if report.analysis == "axisymmetric" { Quantity::Force } else { Quantity::LineForce };
    let (force, length) = (force.symbol(units), Quantity::Length.symbol(units));
    let stress = Quantity::Stress.symbol(units);
    let mut text = format!(
        "step,status,force [{force}],approach [{length}],peak_pressure [{stress}],mean_pressure [{stress}],\
         half_width [{length}],contact_stiffness [{force}/{length}],max_equivalent_plastic_strain"
    );
    let has_flow = report.steps.iter().any(|step| step.flow.is_some());
    if has_flow {
        let _ = write!(
            text,
            ",unloading_stiffness [{force}/{length}],upper_dent [{length}],upper_pile_up [{length}],\
             lower_dent [{length}],lower_pile_up [{length}],work [{force} {length}],\
             dissipated [{force} {length}],increments"
        );
    }
    text.push('\n');
    for (k, step) in report.steps.iter().enumerate() {
        let status = Named::name(step.status);
        let zones = [&step.plasticity.upper, &step.plasticity.lower];
        let strain =
            zones.into_iter().flatten().map(|zone| zone.max_equivalent_plastic_strain).fold(0.0, f64::max);
        let contact = &step.contact;
        let _ = write!(
            text,
            "{},{status},{},{},{},{},{},{},{strain}",
            k + 1,
            contact.force,
            step.approach,
            contact.peak_pressure,
            contact.mean_pressure,
            contact.half_width,
            step.contact_stiffness,
        );
        if has_flow {
            write_flow(&mut text, step.flow.as_ref());
        }
        text.push('\n');
    }
    text
}

/// The columns of flow theory. A rigid body leaves its own empty.
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

/// `step, x, pressure, force, gap` of every candidate pair.
pub fn pressure_csv(report: &Report) -> String {
    let units = units(report);
    let symbol = |quantity: Quantity| quantity.symbol(units);
    let force = if report.analysis == "axisymmetric" { Quantity::Force } else { Quantity::LineForce };
    let (length, stress) = (symbol(Quantity::Length), symbol(Quantity::Stress));
    let mut text =
        format!("step,x [{length}],pressure [{stress}],force [{}],gap [{length}]\n", symbol(force));
    for (k, step) in report.steps.iter().enumerate() {
        let nodes = &step.contact.nodes;
        let columns = nodes.x.iter().zip(&nodes.pressure).zip(&nodes.force).zip(&nodes.gap);
        for (((x, pressure), force), gap) in columns {
            let _ = writeln!(text, "{},{x},{pressure},{force},{gap}", k + 1);
        }
    }
    text
}

/// Names of the stresses along the surface, along the normal and across the section.
fn directions(report: &Report) -> [&'static str; 3] {
    if report.analysis == "axisymmetric" { ["r", "z", "theta"] } else { ["x", "y", "z"] }
}

/// `step, body, depth, stresses, plastic strain` along the normals below the middle of the contact and below the peak pressure, and
/// at the end where they are.
///
/// # Errors
/// [`ExportError::NoSubsurface`] where the job did not ask for it.
pub fn subsurface_csv(report: &Report) -> Result<String, ExportError> {
    if report.steps.iter().all(|step| step.subsurface.is_none()) {
        return Err(ExportError::NoSubsurface);
    }
    let units = units(report);
    let (length, stress) = (Quantity::Length.symbol(units), Quantity::Stress.symbol(units));
    let profiles = || report.steps.iter().flat_map(StepReport::profiles);
    let graded = profiles().any(|(_, body)| body.yield_stress.is_some());
    let mut text = format!("step,body,depth [{length}]");
    for direction in directions(report) {
        let _ = write!(text, ",sigma_{direction} [{stress}]");
    }
    let _ = write!(text, ",tau_max [{stress}],von_mises [{stress}],equivalent_plastic_strain");
    if graded {
        let _ = write!(text, ",yield_stress [{stress}],utilization");
    }
    let stressed = profiles().any(|(_, body)| body.initial_sigma_x.is_some());
    if stressed {
        for direction in directions(report) {
            let _ = write!(text, ",initial_sigma_{direction} [{stress}]");
        }
    }
    let _ = writeln!(text, ",{} [{length}]", abscissa(report));
    for (k, step) in report.steps.iter().enumerate() {
        for (name, body) in step.profiles() {
            write_profile(&mut text, (k + 1, name, step.place_of(body)), body, (graded, stressed));
        }
    }
    Ok(text)
}

/// `step, increment, force, approach, peak_pressure, half_width, iterations` of every increment.
///
/// # Errors
/// [`ExportError::NoFlow`] of deformation theory.
pub fn increments_csv(report: &Report) -> Result<String, ExportError> {
    if report.steps.iter().all(|step| step.flow.is_none()) {
        return Err(ExportError::NoFlow);
    }
    let units = units(report);
    let force = if report.analysis == "axisymmetric" { Quantity::Force } else { Quantity::LineForce };
    let (length, stress) = (Quantity::Length.symbol(units), Quantity::Stress.symbol(units));
    let mut text = format!(
        "step,increment,force [{}],approach [{length}],peak_pressure [{stress}],half_width [{length}],iterations\n",
        force.symbol(units)
    );
    for (k, step) in report.steps.iter().enumerate() {
        let Some(ends) = step.flow.as_ref().map(|flow| &flow.increments) else { continue };
        let columns = ends.force.iter().zip(&ends.approach).zip(&ends.peak_pressure);
        let columns = columns.zip(&ends.half_width).zip(&ends.iterations);
        for (n, ((((force, approach), peak), half_width), iterations)) in columns.enumerate() {
            let _ = writeln!(text, "{},{},{force},{approach},{peak},{half_width},{iterations}", k + 1, n + 1);
        }
    }
    Ok(text)
}

/// `step, body, x, height` of the surfaces, outward from the undeformed one: without force the dent and its pile-up.
///
/// # Errors
/// [`ExportError::NoFlow`] of deformation theory.
pub fn surface_csv(report: &Report) -> Result<String, ExportError> {
    if report.steps.iter().all(|step| step.flow.is_none()) {
        return Err(ExportError::NoFlow);
    }
    let length = Quantity::Length.symbol(units(report));
    let mut text = format!("step,body,x [{length}],height [{length}]\n");
    for (k, step) in report.steps.iter().enumerate() {
        let Some(flow) = &step.flow else { continue };
        for (name, surface) in [("upper", &flow.surfaces.upper), ("lower", &flow.surfaces.lower)] {
            for (x, height) in surface.iter().flat_map(|surface| surface.x.iter().zip(&surface.height)) {
                let _ = writeln!(text, "{},{name},{x},{height}", k + 1);
            }
        }
    }
    Ok(text)
}

/// A body whose strength does not vary, or without initial stress, leaves the columns of those that have them empty.
fn write_profile(
    text: &mut String,
    (step, name, place): (usize, &str, f64),
    body: &SubsurfaceReport,
    (graded, stressed): (bool, bool),
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
        let of_strength = [&body.yield_stress, &body.utilization].into_iter().filter(|_| graded);
        let initial = [&body.initial_sigma_x, &body.initial_sigma_y, &body.initial_sigma_z];
        for column in of_strength.chain(initial.into_iter().filter(|_| stressed)) {
            let value = column.as_ref().and_then(|column| column.get(k));
            let _ = write!(text, ",{}", value.map_or_else(String::new, f64::to_string));
        }
        let _ = writeln!(text, ",{place}");
    }
}
