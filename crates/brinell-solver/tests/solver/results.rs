//! What a report says beyond the contact itself: fields, plastic zone, load–approach curve, onset,
//! validity.

use std::cell::RefCell;
use std::ops::ControlFlow;

use brinell_solver::job::Job;
use brinell_solver::report::{
    self, AnswerBody, FieldsReport, LoadReport, Name, Report, StepReport,
};
use brinell_solver::solver::{
    Held, Interrupt, IterationRecord, Observer, Options, SolveStatus, Unobserved,
};
use serde_json::{Value, json};

use crate::theory::by_deformation_theory;

const FORCE: f64 = 612.6106;

fn run(job: &Value) -> Report {
    let job =
        Job::from_value(&by_deformation_theory(job)).unwrap_or_else(|error| panic!("{error:?}"));
    report::run(&job, &mut Unobserved).unwrap()
}

fn step(job: &Value) -> StepReport {
    run(job).steps.remove(0)
}

fn cylinders(plasticity: &Value, force: f64) -> Value {
    let mut material = json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3});
    if !plasticity.is_null() {
        material["plasticity"] = plasticity.clone();
    }
    let body = json!({"shape": {"type": "cylinder", "radius": 20.0}, "support": "clamped",
        "material": material});
    json!({"analysis": "plane_strain", "upper": body, "lower": body, "load": {"force": force}})
}

fn bilinear() -> Value {
    json!({"law": "bilinear", "yield_stress": 500.0, "tangent_modulus": 10_500.0})
}

fn paper() -> Value {
    cylinders(&bilinear(), FORCE)
}

#[track_caller]
fn assert_within(value: f64, expected: f64, tolerance: f64) {
    assert!((value / expected - 1.0).abs() <= tolerance, "{value} instead of {expected}");
}

fn signed_area(polygon: &[[f64; 2]]) -> f64 {
    let pairs = polygon.iter().zip(polygon.iter().cycle().skip(1));
    0.5 * pairs.map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>()
}

/// A report without its times.
fn timeless(report: &Report) -> Value {
    let mut value = serde_json::to_value(report).unwrap();
    value["timings_ms"] = Value::Null;
    for step in value["steps"].as_array_mut().unwrap() {
        for record in step["history"].as_array_mut().unwrap() {
            record["elapsed_ms"] = Value::Null;
        }
    }
    value
}

#[test]
fn fields_add_themselves_and_change_nothing_else() {
    let plain = run(&paper());
    assert!(plain.steps[0].fields.is_none());
    let mut job = paper();
    job["output"] = json!({"fields": true});
    let mut full = run(&job);
    assert!(full.steps[0].fields.take().is_some());
    assert_eq!(timeless(&full), timeless(&plain));
}

#[test]
fn the_default_report_stays_below_100_kilobytes() {
    let size = serde_json::to_vec(&run(&paper())).unwrap().len();
    assert!(size < 100_000, "{size} bytes");
}

#[test]
fn fields_are_in_one_frame_for_both_bodies() {
    let mut job = paper();
    job["output"] = json!({"fields": true});
    let step = step(&job);
    let fields = step.fields.as_ref().unwrap();
    let (upper, lower) = (fields.upper.as_ref().unwrap(), fields.lower.as_ref().unwrap());
    assert!(
        upper.nodes.iter().all(|[_, y]| *y >= 0.0) && lower.nodes.iter().all(|[_, y]| *y <= 0.0)
    );
    for body in [upper, lower] {
        assert_sound(body);
        let areas =
            body.elements.iter().map(|e| signed_area(&e.map(|node| body.nodes[node as usize])));
        assert!(areas.fold(f64::INFINITY, f64::min) > 0.0);
        let (_, at_origin) = nearest(body, [0.0, 0.0]);
        assert_within(-body.sigma_y[at_origin], step[Name::PeakPressure], 0.03);
    }
    // The bodies approach each other by α on the axis, where they touch.
    let (_, u) = nearest(upper, [0.0, 0.0]);
    let (_, l) = nearest(lower, [0.0, 0.0]);
    assert_within(
        upper.displacement[u][1] - lower.displacement[l][1],
        step.approach().unwrap(),
        1e-9,
    );
    for (a, b) in upper.tau_xy.iter().zip(&lower.tau_xy) {
        assert!((a + b).abs() <= 1e-9 * step[Name::PeakPressure]);
    }
}

fn assert_sound(body: &FieldsReport) {
    let n = body.nodes.len();
    for list in [
        &body.sigma_x,
        &body.sigma_y,
        &body.sigma_z,
        &body.tau_xy,
        &body.von_mises,
        &body.equivalent_plastic_strain,
    ] {
        assert_eq!(list.len(), n);
        assert!(list.iter().all(|value| value.is_finite()));
    }
    assert_eq!(body.displacement.len(), n);
    assert!(body.elements.iter().flatten().all(|&node| (node as usize) < n));
    assert!(body.equivalent_plastic_strain.iter().all(|strain| *strain >= 0.0));
}

fn nearest(body: &FieldsReport, [x, y]: [f64; 2]) -> (f64, usize) {
    let distances =
        body.nodes.iter().enumerate().map(|(k, node)| ((node[0] - x).hypot(node[1] - y), k));
    distances.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
}

#[test]
fn a_rigid_body_has_no_fields() {
    let mut job = cylinders(&Value::Null, 300.0);
    job["upper"]["material"] = json!({"rigid": true});
    job["output"] = json!({"fields": true});
    let fields = step(&job).fields.unwrap();
    assert!(fields.upper.is_none() && fields.lower.is_some());
}

#[test]
fn fields_in_si_are_the_same_numbers_in_other_units() {
    let mut job = cylinders(&Value::Null, 300.0);
    job["mesh"] = json!({"elements_per_half_width": 10});
    job["output"] = json!({"fields": true});
    let mm = step(&job).fields.unwrap().lower.unwrap();
    job["units"] = json!("SI");
    for body in ["upper", "lower"] {
        job[body]["shape"]["radius"] = json!(0.02);
        job[body]["material"]["young_modulus"] = json!(210e9);
    }
    job["load"]["force"] = json!(300e3);
    let si = step(&job).fields.unwrap().lower.unwrap();
    for k in [0, mm.nodes.len() / 2] {
        assert!((si.nodes[k][1] - 1e-3 * mm.nodes[k][1]).abs() < 1e-12);
        assert!((si.von_mises[k] - 1e6 * mm.von_mises[k]).abs() < 1.0);
        assert!((si.displacement[k][1] - 1e-3 * mm.displacement[k][1]).abs() < 1e-12);
    }
}

#[test]
fn the_outline_of_the_plastic_zone_encloses_its_area() {
    for force in [FORCE, 1089.0855] {
        let step = step(&cylinders(&bilinear(), force));
        let zones = &step.plasticity;
        for zone in [&zones.upper, &zones.lower] {
            let zone = &zone.as_ref().unwrap().outline;
            let points: usize = zone.iter().map(Vec::len).sum();
            assert!((3..=400).contains(&points), "{points} points");
            let enclosed: f64 = zone.iter().map(|polygon| signed_area(polygon)).sum();
            assert_within(enclosed, step[Name::PlasticArea], 0.03);
            let xs = || zone.iter().flatten().map(|point| point[0]);
            let (left, right) =
                (xs().fold(f64::INFINITY, f64::min), xs().fold(f64::NEG_INFINITY, f64::max));
            assert!((left + right).abs() < 1e-9, "{left} to {right}");
        }
    }
}

#[test]
fn the_plastic_zone_reaches_the_surface_only_under_high_loads() {
    let pressed = |force: f64| step(&cylinders(&bilinear(), force));
    let buried = pressed(270.0);
    let outline = &buried.plasticity.lower.as_ref().unwrap().outline;
    let highest = outline.iter().flatten().map(|point| point[1]).fold(f64::INFINITY, f64::min);
    assert!(highest > 0.0);
    assert_eq!(buried[Name::PlasticCover], highest);
    assert_eq!(pressed(1701.696)[Name::PlasticCover], 0.0);
    let elastic = pressed(100.0);
    assert!(elastic.plasticity.lower.as_ref().unwrap().outline.is_empty());
    assert!(elastic.row(Name::PlasticCover).is_none());
}

#[test]
fn a_law_without_a_yield_point_is_outlined_where_it_counts_as_yielded() {
    let law = json!({"law": "ramberg_osgood", "reference_stress": 500.0, "offset": 0.3,
        "exponent": 5.0});
    let step = step(&cylinders(&law, FORCE));
    let zone = &step.plasticity.lower.as_ref().unwrap().outline;
    let enclosed: f64 = zone.iter().map(|polygon| signed_area(polygon)).sum();
    assert_within(enclosed, step[Name::PlasticArea], 0.05);
}

#[test]
fn the_stiffness_of_a_sweep_is_the_slope_of_its_curve_and_that_of_its_steps() {
    let mut job = cylinders(&Value::Null, 1.0);
    let forces: Vec<f64> = (0..7).map(|k| 300.0 + 25.0 * f64::from(k)).collect();
    job["load"] = json!({"forces": forces});
    let report = run(&job);
    let curve = report.load_approach.as_ref().unwrap();
    assert_eq!(curve.force.len(), 7);
    assert!(curve.approach.windows(2).all(|pair| pair[1] > pair[0]));
    for (slope, step) in curve.stiffness.iter().zip(&report.steps) {
        assert_within(*slope, step[Name::ContactStiffness], 1e-12);
    }
    for (k, slope) in curve.stiffness.iter().enumerate().take(6).skip(1) {
        let secant = (curve.force[k + 1] - curve.force[k - 1])
            / (curve.approach[k + 1] - curve.approach[k - 1]);
        assert_within(*slope, secant, 0.02);
    }
    assert!(run(&paper()).load_approach.is_none());
}

#[test]
fn the_onset_of_yield_is_reported_with_its_place() {
    let mut job = paper();
    job["load"] = json!({"onset": true});
    let step = step(&job);
    let onset = step.row(Name::FirstYieldForce).unwrap();
    let place = onset.place.unwrap();
    assert_eq!(step.load, LoadReport::Force(onset.value.unwrap()));
    assert_within(onset.value.unwrap(), onset.elastic.unwrap(), 0.01);
    // 0.705 half-widths below a line contact.
    assert_within(place.depth, 0.705 * step.elastic(Name::HalfWidth).unwrap(), 0.1);
    assert_within(step[Name::FirstYieldPeakPressure], 1.794 * 500.0, 5e-3);
    assert!(place.x.abs() < 0.1 * step[Name::HalfWidth]);
    job["upper"]["material"]["plasticity"]["yield_stress"] = json!(300.0);
    let softer = run(&job).steps.remove(0);
    let place = softer.row(Name::FirstYieldForce).unwrap().place.unwrap();
    assert_eq!(place.body, AnswerBody::Upper);
    assert!(run(&paper()).steps[0].row(Name::FirstYieldPeakPressure).is_none());
}

#[test]
#[ignore = "full"]
fn several_contacts_are_several_patches() {
    let single = step(&paper());
    let [part] = single.contact.patches.as_slice() else { panic!("not one part") };
    assert_within(part.right - part.left, 2.0 * single[Name::HalfWidth], 1e-12);

    let bumps: Vec<[f64; 2]> = (-60..=60)
        .map(|k| f64::from(k) * 0.1)
        .map(|x| [x, -0.5 * (x.abs() - 2.0).powi(2) / 20.0])
        .collect();
    let mut job = cylinders(&Value::Null, 100.0);
    job["upper"]["shape"] = json!({"type": "profile", "points": bumps, "depth": 10.0});
    job["lower"]["shape"] = json!({"type": "block", "width": 40.0, "depth": 20.0});
    let contact = step(&job).contact;
    assert_eq!(contact.patches.len(), 2, "{:?}", contact.patches);
    let [left, right] = [contact.patches[0], contact.patches[1]];
    assert!((left.left + right.right).abs() < 1e-9 && (left.right + right.left).abs() < 1e-9);
    assert!(left.left < left.right && left.right < 0.0 && right.left < 2.0 && right.right > 2.0);
}

fn codes(step: &StepReport) -> Vec<&str> {
    step.validity.iter().map(|note| note.code.as_str()).collect()
}

#[track_caller]
fn assert_says(job: &Value, code: &str) {
    let step = step(job);
    assert!(codes(&step).contains(&code), "{:?}", codes(&step));
}

#[test]
fn a_small_elastic_contact_calls_for_no_remark() {
    assert_eq!(codes(&step(&cylinders(&Value::Null, 100.0))), [""; 0]);
    let mut job = cylinders(&Value::Null, 100.0);
    job["mesh"] = json!({"elements_per_half_width": 10});
    assert_eq!(codes(&step(&job)), [""; 0], "ten elements are what coarse_mesh asks for");
}

#[test]
fn wide_contact() {
    assert_says(&cylinders(&Value::Null, 12_000.0), "wide_contact");
}

#[test]
fn large_strain() {
    let soft = json!({"law": "bilinear", "yield_stress": 100.0, "tangent_modulus": 200.0});
    assert_says(&cylinders(&soft, 1200.0), "large_strain");
}

/// The remark of deformation theory has the figures of the shape and of the elastic peak.
#[test]
fn deformation_theory_says_what_is_known_of_its_error() {
    let says = |job: &Value| {
        let notes = step(job).validity;
        let note = notes.into_iter().find(|note| note.code == "deformation_theory").unwrap();
        assert!(note.message.contains("the error of the theory is not bounded"), "{note:?}");
        note.message
    };
    let mut job = paper();
    job["solver"] = json!({"theory": "deformation"});
    job["mesh"] = json!({"elements_per_half_width": 6});
    let line = says(&job);
    assert!(line.contains("up to 3 times, peak pressures of lines are at most 4.2 %"), "{line}");
    job["analysis"] = json!("axisymmetric");
    job["load"] = json!({"approach": 0.05});
    let ball = says(&job);
    assert!(ball.contains("peak pressures of balls are at most"), "{ball}");
    job["upper"]["shape"] = json!({"type": "cone", "angle": 19.7, "width": 4, "depth": 4});
    job["upper"]["material"] = json!({"rigid": true});
    job["lower"]["shape"] = json!({"type": "block", "width": 8, "depth": 4});
    job["load"] = json!({"approach": 0.02});
    let cone = says(&job);
    assert!(cone.contains("16 to 22 %"), "{cone}");
}

/// A load divided into many increments takes many times the work of others, by count; few
/// increments and default jobs do not.
#[test]
fn a_load_that_takes_much_work_says_why() {
    let history = |increments: u32| {
        let mut job = cylinders(&bilinear(), 600.0);
        job["load"] = json!({"history": [{"force": 600.0}]});
        job["mesh"] = json!({"elements_per_half_width": 4});
        job["solver"] = json!({"theory": "flow", "increments": increments});
        step(&job)
    };
    let slow = |step: &StepReport| {
        let note = step.validity.iter().find(|note| note.code == "slow_coupling");
        note.map(|note| note.message.clone())
    };
    let told = slow(&history(160)).unwrap();
    assert!(told.contains("160 increments") && told.contains("evaluations"), "{told}");
    assert_eq!(slow(&history(10)), None);
    assert_eq!(slow(&step(&paper())), None);
}

#[test]
fn coarse_mesh() {
    let mut job = cylinders(&Value::Null, 100.0);
    job["mesh"] = json!({"elements_per_half_width": 5});
    assert_says(&job, "coarse_mesh");
}

/// A weak core holds what a strong layer under compression pulls on.
#[test]
fn a_core_that_yields_before_the_load_is_told() {
    let plasticity = json!({"law": "bilinear", "yield_stress": 900.0, "tangent_modulus": 20_000.0,
        "over_depth": [[0.0, 1.0], [2.0, 1.0], [2.1, 0.06]]});
    let mut job = cylinders(&plasticity, 50.0);
    for side in ["upper", "lower"] {
        let row = |depth: f64, stress: f64| {
            json!({"depth": depth, "sigma_x": stress,
            "sigma_z": stress})
        };
        job[side]["material"]["initial_stress"] =
            json!([row(0.0, -800.0), row(2.0, -800.0), row(2.1, 0.0)]);
    }
    job["mesh"] = json!({"elements_per_half_width": 6});
    assert_says(&job, "initial_yield");
}

/// A pin that nearly fills its hole touches over a large part of its own radius, small as that is
/// beside the effective one.
#[test]
fn a_pin_in_its_groove_is_a_wide_contact() {
    let mut job = cylinders(&Value::Null, 5000.0);
    job["upper"]["shape"] = json!({"type": "cylinder", "radius": 10.0});
    job["lower"]["shape"] =
        json!({"type": "groove", "radius": 10.2, "width": 20.0, "depth": 40.0});
    assert_says(&job, "wide_contact");
}

#[test]
fn sharp_corner() {
    let mut job = cylinders(&Value::Null, 100.0);
    job["upper"] = json!({"shape": {"type": "punch", "width": 2.0, "depth": 5.0},
        "material": {"rigid": true}});
    job["lower"]["shape"] = json!({"type": "block", "width": 60.0, "depth": 30.0});
    assert_says(&job, "sharp_corner");
}

#[test]
fn near_support() {
    let mut job = cylinders(&Value::Null, 600.0);
    job["lower"]["shape"] = json!({"type": "block", "width": 6.0, "depth": 1.7});
    assert_says(&job, "near_support");
}

#[test]
fn not_converged() {
    let mut job = paper();
    job["solver"] = json!({"max_iterations": 2});
    assert_says(&job, "not_converged");
}

/// Stops after the first iteration.
struct Impatient(Interrupt);

impl Observer for Impatient {
    fn on_iteration(&mut self, _: &IterationRecord) -> ControlFlow<Interrupt> {
        ControlFlow::Break(self.0)
    }
}

#[test]
fn cancelled_and_timed_out() {
    let job = Job::from_value(&by_deformation_theory(&paper())).unwrap();
    for (interrupt, status, code) in [
        (Interrupt::Cancelled, SolveStatus::Cancelled, "cancelled"),
        (Interrupt::TimedOut, SolveStatus::TimedOut, "timed_out"),
    ] {
        let report = report::run(&job, &mut Impatient(interrupt)).unwrap();
        assert_eq!(report.status, status);
        assert!(codes(&report.steps[0]).contains(&code));
    }
}

/// Keeps what is shown.
#[derive(Default)]
struct Recorder(Vec<IterationRecord>);

impl Observer for Recorder {
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.0.push(record.clone());
        ControlFlow::Continue(())
    }
}

/// Who watches an iteration and who reads it in the result see the same figures.
#[test]
fn iterations_are_shown_in_the_units_of_the_job() {
    let mut si = paper();
    si["units"] = json!("SI");
    for body in ["upper", "lower"] {
        si[body]["shape"]["radius"] = json!(0.02);
        si[body]["material"] = json!({
            "young_modulus": 210e9, "poisson_ratio": 0.3,
            "plasticity": {"law": "bilinear", "yield_stress": 500e6, "tangent_modulus": 10.5e9},
        });
    }
    si["load"]["force"] = json!(FORCE * 1e3);
    for (job, peak) in [(paper(), 1.0e3), (si, 1.0e9)] {
        let mut shown = Recorder::default();
        let report =
            report::run(&Job::from_value(&by_deformation_theory(&job)).unwrap(), &mut shown)
                .unwrap();
        let history = &report.steps[0].history;
        assert_eq!(&shown.0[shown.0.len() - history.len()..], history.as_slice());
        let last = history.last().unwrap();
        assert!((0.8..1.5).contains(&(last.peak_pressure / peak)), "{last:?}");
    }
}

/// A sum over nothing is -0 in binary arithmetic, which readers take for a figure.
#[test]
fn no_zero_has_a_sign() {
    let mut job = paper();
    job["solver"] = json!({"theory": "flow"});
    job["mesh"] = json!({"elements_per_half_width": 6});
    job["load"] = json!({"history": [{"force": FORCE}, {"force": 0}]});
    job["output"] = json!({"fields": true});
    let report = serde_json::to_string(&run(&job)).unwrap();
    let signed = [":-0.0,", ":-0.0}", ",-0.0,", "[-0.0,", ",-0.0]"].map(|zero| report.find(zero));
    let place =
        signed.into_iter().flatten().min().map(|at| &report[at.saturating_sub(120)..at + 6]);
    assert_eq!(place, None);
}

/// Notes the load that is iterated, and what is held.
struct Steps<'a> {
    seen: &'a RefCell<Vec<(char, usize)>>,
    held: [usize; 2],
}

impl Observer for Steps<'_> {
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        let load = record.increment.as_ref().map_or(0, |increment| increment.load);
        self.seen.borrow_mut().push(('i', load - 1));
        ControlFlow::Continue(())
    }

    fn on_held(&mut self, part: Held, bytes: usize) -> ControlFlow<Interrupt> {
        let most = &mut self.held[usize::from(part == Held::Increments)];
        *most = (*most).max(bytes);
        ControlFlow::Continue(())
    }
}

#[test]
fn steps_of_a_history_are_handed_over_as_they_end() {
    let mut job = paper();
    job["solver"] = json!({"theory": "flow"});
    job["mesh"] = json!({"elements_per_half_width": 6});
    job["load"] = json!({"history": [{"force": FORCE}, {"force": 0.5 * FORCE}, {"force": 0}]});
    let job = Job::from_value(&by_deformation_theory(&job)).unwrap();
    let seen = RefCell::new(Vec::new());
    let mut observer = Steps { seen: &seen, held: [0; 2] };
    let mut on_step = |number, _| seen.borrow_mut().push(('s', number));
    report::run_each(&job, Options::default(), &mut observer, &mut on_step).unwrap();
    let held = observer.held;
    let mut order = seen.into_inner();
    order.dedup();
    assert_eq!(order, [('i', 0), ('s', 0), ('i', 1), ('s', 1), ('i', 2), ('s', 2)]);
    let estimate = report::preflight(&job).unwrap().bytes;
    assert!(
        held.iter().all(|held| *held > 0) && (held.iter().sum::<usize>() as u64) < estimate,
        "{held:?}"
    );
}
