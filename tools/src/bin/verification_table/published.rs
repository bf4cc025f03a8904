//! Published results where the contact is fully plastic, or nearly so, beside the answers here.
//!
//! Each case is one job by the default theory. Its error is the bound of the mesh and the increments; of a
//! hardness test the difference to large strains is added.

use std::error::Error;
use std::f64::consts::PI;
use std::fmt::Write;

use brinell_solver::analytical::YieldOnset;
use brinell_solver::job::Job;
use brinell_solver::report::{self, Answer, Report, StepReport};
use brinell_solver::solver::{SolveStatus, Unobserved};
use serde_json::{Value, json};

pub const HEAD: &str = "
## Published results beyond yield

All by the default, flow theory. *Error*: that of mesh and increments, and of a hardness test its difference to
large strains. *Difference*: what is found over what is published. *Inside*: whether what is
published lies within the error of what is found.

| case | quantity | published | source | found | error | difference | inside |
|---|---|---|---|---|---|---|---|
";

pub const NOTES: &str = "
- Published results have errors of their own, which no source states: the two fits of balls differ
  by 1 % at ten critical interferences and 4 % at forty.
- Dao's cone was computed, and the Brinell number measured, with large strains; here strains are
  small.
- Storåkers' area is that of solids `ε = (σ/σ_0)^m` without elasticity; here the elastic strain at
  σ_0 is a ten-thousandth of the plastic one.
- Deformation theory misses those that it can answer by more: `docs/notes/flow_theory.md`.
";

/// A figure with its relative error; `None` where the answer has none.
struct Found {
    value: f64,
    error: Option<f64>,
}

struct Published {
    name: &'static str,
    quantity: &'static str,
    value: f64,
    source: &'static str,
    job: Value,
    of: fn(&Report) -> Option<Found>,
    /// Why the published result is not within the error, where it is not.
    why: &'static str,
}

/// A row of this name.
fn row(rows: &[Answer], name: &str) -> Option<Found> {
    let row = rows.iter().find(|row| row.name == name)?;
    Some(Found { value: row.value?, error: row.error.bound() })
}

/// A figure of a step.
fn answer(step: &StepReport, name: &str) -> Option<Found> {
    row(&step.answers, name)
}

fn last(report: &Report) -> Option<&StepReport> {
    report.steps.last()
}

fn force(report: &Report) -> Option<Found> {
    answer(last(report)?, "force")
}

/// `a²/(2 R h)` of a rigid ball of 10 mm that is 0.05 mm deep.
fn area_ratio(report: &Report) -> Option<Found> {
    let a = answer(last(report)?, "half_width")?;
    let error = a.error.map(|error| 2.0 * error);
    Some(Found { value: a.value * a.value / (2.0 * BALL * 0.05), error })
}

fn mean_pressure(report: &Report) -> Option<Found> {
    let mean = answer(last(report)?, "mean_pressure")?;
    Some(Found { value: mean.value / SOFT, ..mean })
}

/// The approach that is left over that of the first load.
fn left_over(report: &Report) -> Option<Found> {
    let loaded = answer(report.steps.first()?, "approach")?;
    let left = answer(report.steps.get(1)?, "permanent_approach")?;
    let error = loaded.error.zip(left.error).map(|(a, b)| a + b);
    Some(Found { value: left.value / loaded.value, error })
}

/// F/h² of a cone \[MPa\].
fn curvature(report: &Report) -> Option<Found> {
    let depth = row(&report.answers, "indentation_depth")?;
    let force = answer(report.steps.first()?, "force")?;
    let error = depth.error.map(|error| 2.0 * error);
    Some(Found { value: force.value / (depth.value * depth.value), error })
}

fn number(report: &Report) -> Option<Found> {
    let number = row(&report.answers, "hardness")?;
    let bias = row(&report.answers, "large_strain_bias").map_or(0.0, |bias| bias.value.abs());
    Some(Found { error: number.error.map(|error| error + bias), ..number })
}

/// Hertz's peak pressure under the force of the first step \[MPa\], with a third of its error.
fn nominal_pressure(report: &Report) -> Option<Found> {
    let step = report.steps.first()?;
    let force = answer(step, "force")?;
    let error = force.error.map(|error| error / 3.0);
    let peak = step.answers.iter().find(|row| row.name == "peak_pressure")?;
    Some(Found { value: peak.elastic?, error })
}

/// A ball of 10 mm of a soft steel \[mm, MPa\].
const BALL: f64 = 10.0;
const SOFT: f64 = 200.0;
const YOUNG: f64 = 200_000.0;
const EFFECTIVE: f64 = YOUNG / 0.91;

/// Interference and force of Kogut's and Etsion's first yield: `K = 0.454 + 0.41 ν`, `H = 2.8 Y`.
fn first_yield() -> [f64; 2] {
    let strain = PI * 0.577 * 2.8 * SOFT / (2.0 * EFFECTIVE);
    let interference = strain * strain * BALL;
    [interference, 2.0 / 3.0 * 0.577 * 2.8 * SOFT * PI * interference * BALL]
}

/// Jackson's and Green's force at an interference, beyond 1.9 of that at first yield.
fn jackson_green(interference: f64) -> f64 {
    let c = 1.295 * (0.736_f64 * 0.3).exp();
    let critical = (PI * c * SOFT / (2.0 * EFFECTIVE)).powi(2) * BALL;
    let w = interference / critical;
    let radius =
        (interference / BALL * (w / 1.9).powf(0.14 * (23.0 * SOFT / EFFECTIVE).exp())).sqrt();
    let hardness = 2.84 * (1.0 - (-0.82 * radius.powf(-0.7)).exp());
    let elastic = (-0.25 * w.powf(5.0 / 12.0)).exp() * w.powf(1.5);
    let plastic = 4.0 * hardness / c * (1.0 - (-0.04 * w.powf(5.0 / 9.0)).exp()) * w;
    YieldOnset::jackson_green_force(0.3, SOFT, BALL, EFFECTIVE) * (elastic + plastic)
}

fn material(young: f64, law: &Value) -> Value {
    json!({"young_modulus": young, "poisson_ratio": 0.3, "plasticity": law})
}

fn perfectly_plastic(yield_stress: f64, tangent_modulus: f64) -> Value {
    json!({"law": "bilinear", "yield_stress": yield_stress, "tangent_modulus": tangent_modulus})
}

fn ball(radius: f64, material: &Value) -> Value {
    json!({"shape": {"type": "cylinder", "radius": radius}, "material": material})
}

fn block(width: f64, material: &Value) -> Value {
    json!({"shape": {"type": "block", "width": width, "depth": 0.5 * width},
        "material": material})
}

fn round(upper: &Value, lower: &Value, load: &Value, elements: u32) -> Value {
    json!({"analysis": "axisymmetric", "upper": upper, "lower": lower, "load": load,
        "mesh": {"elements_per_half_width": elements}})
}

fn rigid() -> Value {
    json!({"rigid": true})
}

/// A rigid ball in a solid `ε = (σ/1000)^m`, whose elastic strain is a ten-thousandth at 1000 MPa.
fn power_law(m: f64) -> Value {
    let law = json!({"law": "ramberg_osgood", "reference_stress": 1000.0, "offset": 1e4,
        "exponent": m});
    let lower = block(60.0, &material(1e7, &law));
    round(&ball(BALL, &rigid()), &lower, &json!({"approach": 0.05}), 16)
}

/// A514 steel of Dowling's table under an indenter.
fn tested(width: f64, test: &Value, elements: u32) -> Value {
    let law = json!({"law": "swift", "yield_stress": 650.0, "strain_offset": 0.0025,
        "exponent": 0.088});
    json!({"lower": block(width, &material(208_000.0, &law)), "load": {"hardness": test},
        "mesh": {"elements_per_half_width": elements}})
}

/// A ball of bearing steel in its groove.
fn raceway() -> Value {
    let steel = material(
        210_000.0,
        &json!({"law": "swift", "yield_stress": 1357.865, "strain_offset": 2e-5,
            "exponent": 0.121}),
    );
    json!({"analysis": "three_dimensional",
        "upper": {"shape": {"type": "sphere", "radius": 5.0}, "material": steel},
        "lower": {"shape": {"type": "curved", "radius_x": 20.0, "radius_y": -5.2},
            "material": steel},
        "load": {"target": {"permanent_approach": 1e-3}},
        "mesh": {"elements_per_half_width": 10}})
}

#[expect(clippy::too_many_lines, reason = "one entry for each case")]
fn cases() -> Vec<Published> {
    let [interference, critical] = first_yield();
    let (soft, hardening) = (
        material(YOUNG, &perfectly_plastic(SOFT, 0.0)),
        material(YOUNG, &perfectly_plastic(SOFT, 0.02 * YOUNG)),
    );
    let flat = block(40.0, &rigid());
    let pressed = |times: f64| {
        let load = json!({"approach": times * interference});
        round(&flat, &ball(BALL, &soft), &load, 16)
    };
    let storakers = |m: f64| 1.43 * (-0.97 / m).exp();
    let storakers_source = "Storåkers, Biwa, Larsson, IJSS 34 (1997) 3061: 1.43 e^(−0.97/m)";
    let dao = {
        let (stress, modulus) =
            (650.0 * ((0.0025_f64 + 0.033) / 0.0025).powf(0.088), 208_000.0 / 0.91);
        let x = (modulus / stress).ln();
        (((-1.131 * x + 13.635) * x - 30.594) * x + 29.267) * stress
    };
    let soft_block = material(210_000.0, &perfectly_plastic(50.0, 0.0));
    let case = |name, quantity, value, source, job, of, why| Published {
        name,
        quantity,
        value,
        source,
        job,
        of,
        why,
    };
    let mut cases = vec![case(
        "rigid sphere of 500 mm, σ_y 50 MPa, 20 mm deep",
        "force [N]",
        2.0 * PI * 2.038_04e6,
        "code_aster V6.04.506 (SSNV506)",
        round(&ball(500.0, &rigid()), &block(4000.0, &soft_block), &json!({"approach": 20.0}), 20),
        force as fn(&Report) -> Option<Found>,
        "",
    )];
    for (name, m) in [
        ("rigid ball, power law m = 3", 3.0),
        ("rigid ball, power law m = 5", 5.0),
        ("rigid ball, power law m = 10", 10.0),
    ] {
        let (value, job) = (storakers(m), power_law(m));
        cases.push(case(name, "a²/(2 R h)", value, storakers_source, job, area_ratio, ""));
    }
    cases.push(case(
        "cone of 70.3°, A514 steel, HV 1",
        "F/h² [MPa]",
        dao,
        "Dao et al., Acta Mater. 49 (2001) 3899",
        tested(2.0, &json!("HV 1"), 16),
        curvature,
        "",
    ));
    cases.push(case(
        "ball below a rigid flat, 10 critical interferences",
        "force [N]",
        critical * 1.40 * 10.0_f64.powf(1.263),
        "Kogut, Etsion, J. Appl. Mech. 69 (2002) 657",
        pressed(10.0),
        force,
        "no: a fit to finite elements, whose own scatter is not in the error",
    ));
    cases.push(case(
        "ball below a rigid flat, 20 critical interferences",
        "force [N]",
        jackson_green(20.0 * interference),
        "Jackson, Green, J. Tribol. 127 (2005) 343",
        pressed(20.0),
        force,
        "no: a fit to finite elements, whose own scatter is not in the error",
    ));
    cases.push(case(
        "rigid ball, perfectly plastic, 500 critical interferences",
        "p_m/σ_y",
        2.8,
        "Tabor, The Hardness of Metals (1951)",
        round(
            &ball(BALL, &rigid()),
            &block(300.0, &soft),
            &json!({"history": [{"approach": 500.0 * interference}]}),
            24,
        ),
        mean_pressure,
        "",
    ));
    cases.push(case(
        "ball below a rigid flat, E_t = 0.02 E, 20 critical interferences and back",
        "approach left over approach",
        (1.0 - 20.0_f64.powf(-0.28)) * (1.0 - 20.0_f64.powf(-0.69)),
        "Etsion, Kligerman, Kadin, IJSS 42 (2005) 3716",
        round(
            &flat,
            &ball(BALL, &hardening),
            &json!({"history": [{"approach": 20.0 * interference}, {"force": 0.0}]}),
            16,
        ),
        left_over,
        "no: a fit to finite elements, whose own scatter is not in the error",
    ));
    cases.push(case(
        "HBW 10/3000, A514 steel",
        "Brinell number",
        256.0,
        "Dowling, Mechanical Behavior of Materials, tables 4.2 and 4.6",
        tested(80.0, &json!({"scale": "HBW", "ball": 10.0, "force_kgf": 3000.0}), 24),
        number,
        "",
    ));
    cases.push(case(
        "ball of 10 mm in its groove, 52100 steel, 0.0001 D left",
        "Hertz's peak [MPa]",
        4200.0,
        "ISO 76",
        raceway(),
        nominal_pressure,
        "no: one curve of a steel without retained austenite (`docs/static_rating.md`)",
    ));
    cases
}

/// Appends the table.
///
/// # Errors
/// A job that is no job, does not converge or does not answer what is asked.
pub fn table(page: &mut String) -> Result<(), Box<dyn Error>> {
    page.push_str(HEAD);
    for case in cases() {
        let report = report::run(&Job::from_value(&case.job)?, &mut Unobserved)?;
        if report.status != SolveStatus::Converged {
            return Err(format!("{}: not converged", case.name).into());
        }
        let found = (case.of)(&report).ok_or_else(|| format!("{}: no answer", case.name))?;
        let (error, inside) = match found.error {
            Some(error) => {
                let is_inside = (case.value - found.value).abs() <= error * found.value.abs();
                (format!("± {:.1} %", 100.0 * error), if is_inside { "yes" } else { case.why })
            }
            None => ("–".to_owned(), "no: the answer has no bar"),
        };
        if inside.is_empty() {
            return Err(format!("{}: outside, and nobody says why", case.name).into());
        }
        writeln!(
            page,
            "| {} | {} | {} | {} | {} | {error} | {:+.1} % | {inside} |",
            case.name,
            case.quantity,
            short(case.value),
            case.source,
            short(found.value),
            100.0 * (found.value / case.value - 1.0),
        )?;
    }
    page.push_str(NOTES);
    Ok(())
}

/// Four digits.
fn short(value: f64) -> String {
    match value.abs() {
        1e5.. => format!("{value:.3e}"),
        1000.0.. => format!("{value:.0}"),
        100.0.. => format!("{value:.1}"),
        10.0.. => format!("{value:.2}"),
        1.0.. => format!("{value:.3}"),
        _ => format!("{value:.4}"),
    }
}
