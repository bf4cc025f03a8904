//! What is known of limits: long contacts, one increment, energies.

use brinell_solver::job::Job;
use brinell_solver::report;
use brinell_solver::report::Name;
use serde_json::json;

use super::*;

/// Peak pressure of a rigid cylinder of the same radius in plane strain, under a force for each
/// unit of its length.
fn plane_peak(line_load: f64, theory: &str) -> f64 {
    let load = if theory == "flow" {
        json!({"history": [{"force": line_load}]})
    } else {
        json!({"force": line_load})
    };
    let plasticity = json!({"law": "bilinear", "yield_stress": YIELD_STRESS, "tangent_modulus": 0.05 * 210_000.0});
    let job = json!({
        "analysis": "plane_strain",
        "upper": {"shape": {"type": "cylinder", "radius": RADIUS}, "material": {"rigid": true}},
        "lower": {
            "shape": {"type": "block", "width": 40.0, "depth": 20.0},
            "material": {"young_modulus": 210_000.0, "poisson_ratio": 0.3, "plasticity": plasticity},
        },
        "load": load, "solver": {"theory": theory}, "mesh": {"elements_per_half_width": 40},
    });
    let report = report::run(&Job::from_value(&job).unwrap(), &mut Unobserved).unwrap();
    assert_eq!(report.status, SolveStatus::Converged);
    report.steps[0][Name::PeakPressure]
}

/// In the middle of a long ellipse bodies are in plane strain, under the line load that is there:
/// yield sheds load along it.
#[test]
#[ignore = "full"]
fn the_middle_of_a_long_ellipse_is_in_plane_strain() {
    let problem = on_flat(400.0 * RADIUS, steel(Some(0.05)), 10);
    let step = under(problem, 4.0);
    let map = &step.field.surface;
    let (nx, ny) = (map.grid.nx(), map.grid.ny());
    let row = |j: usize| (0..nx).map(|i| map.pressure[i * ny + j]).sum::<f64>() * map.grid.hx();
    let line_load = 0.5 * (row((ny - 1) / 2) + row(ny / 2));
    near(step.figures.peak_pressure, plane_peak(line_load, "deformation"), 1e-2, "peak");
    assert!(step.figures.semi_axes()[1] > 20.0 * step.figures.semi_axes()[0]);
}

/// From rest the path of an increment is straight, as deformation theory takes it to be.
#[test]
fn one_increment_from_rest_is_deformation_theory() {
    let mut problem = on_flat(3.0 * RADIUS, steel(Some(0.05)), 4);
    let force = force_of(&problem, 6.0);
    problem.solver.tolerance = 1e-11;
    problem.loads = forces([force]);
    let whole = solved(&problem).remove(0);
    problem.solver.theory = Theory::Flow;
    problem.solver.increments = Increments::Given(1);
    problem.loads = forces([force]);
    let flow = solved(&problem).remove(0);
    near(flow.field.surface.grid.hx(), whole.field.surface.grid.hx(), 1e-12, "cells");
    near(flow.figures.approach, whole.figures.approach, 1e-9, "approach");
    near(flow.field.largest_cell_pressure, whole.field.largest_cell_pressure, 1e-9, "peak");
    near(
        flow.figures.bodies[1].unwrap().max_plastic_strain,
        whole.figures.bodies[1].unwrap().max_plastic_strain,
        1e-9,
        "plastic strain",
    );
}

/// `∫P dα` of the increments, by powers of the approach between them.
fn work_of_force(step: &HalfSpaceStep) -> f64 {
    let ends: Vec<[f64; 2]> =
        step.path.increments.iter().map(|end| [end.approach, end.force]).collect();
    let first = 0.4 * ends[0][0] * ends[0][1];
    let segments = ends.windows(2).map(|pair| {
        let [[before, low], [after, high]] = [pair[0], pair[1]];
        let power = (high / low).ln() / (after / before).ln();
        (high * after - low * before) / (power + 1.0)
    });
    first + segments.sum::<f64>()
}

/// Energies are integrals over the bodies, the work of the force is that of its curve.
#[test]
fn work_is_stored_or_dissipated() {
    let energy_of = |ratio: f64, tolerance: f64| {
        let mut problem = on_flat(2.0 * RADIUS, steel(Some(0.05)), 6);
        problem.solver.increments = Increments::Given(20);
        let [loaded, unloaded] = loaded_and_unloaded(problem, ratio);
        near(loaded.path.energy.unwrap().work(), work_of_force(&loaded), tolerance, "work");
        [loaded, unloaded].map(|step| step.path.energy.unwrap())
    };
    let [loaded, _] = energy_of(1.2, 1e-3);
    assert!(loaded.plastic_work.abs() < 1e-300, "nothing yields");
    let [loaded, unloaded] = energy_of(4.0, 1e-3);
    near(unloaded.plastic_work, loaded.plastic_work, 1e-9, "plastic work");
    // What residual stress stores.
    assert!(unloaded.elastic > 0.0 && unloaded.elastic < 0.1 * loaded.elastic);
}
