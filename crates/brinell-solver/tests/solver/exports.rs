//! What the files for other programs say: `field.vtu` number by number, the tables line by line.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use brinell_solver::job::{Job, Named as _};
use brinell_solver::report::export::{Export, ExportError};
use brinell_solver::report::{self, Name, Report};
use brinell_solver::solver::Unobserved;
use serde_json::{Value, json};

use crate::theory::by_deformation_theory;

fn solve(job: &Value) -> (Job, Report) {
    let job =
        Job::from_value(&by_deformation_theory(job)).unwrap_or_else(|error| panic!("{error:?}"));
    let report = report::run(&job, &mut Unobserved).unwrap();
    (job, report)
}

fn paper() -> Value {
    let mut job: Value =
        serde_json::from_str(include_str!("../../../../api/examples/two_cylinders.json")).unwrap();
    job["output"] = json!({"fields": true});
    job
}

/// A `field.vtu`, read.
struct Grid {
    points: Vec<[f64; 3]>,
    cells: Vec<[usize; 4]>,
    displacement: Vec<[f64; 3]>,
    stress: Vec<[f64; 6]>,
    body: Vec<u8>,
}

impl Grid {
    fn of(job: &Value) -> (Self, Report) {
        let (job, report) = solve(job);
        let text = Export::FieldVtu.write(&job, &report, None).unwrap();
        (Self::read(&text), report)
    }

    fn read(text: &str) -> Self {
        Self {
            points: tuples(&floats(text, "Points")),
            cells: tuples(&integers(text, "connectivity")),
            displacement: tuples(&floats(text, "displacement")),
            stress: tuples(&floats(text, "stress")),
            body: array(text, "UInt8", "body"),
        }
    }

    fn area(&self, cell: usize) -> f64 {
        let corners = self.cells[cell].map(|node| self.points[node]);
        let sides = (0..4).map(|k| (corners[k], corners[(k + 1) % 4]));
        sides.map(|(a, b)| 0.5 * (a[0] * b[1] - b[0] * a[1])).sum()
    }

    fn nodes_of(&self, body: u8) -> Vec<usize> {
        let cells = self.cells.iter().zip(&self.body).filter(|(_, b)| **b == body);
        let mut nodes: Vec<usize> = cells.flat_map(|(cell, _)| *cell).collect();
        nodes.sort_unstable();
        nodes.dedup();
        nodes
    }

    /// The node of a body at a place.
    fn node_at(&self, body: u8, [x, y]: [f64; 2]) -> usize {
        let nodes = self.nodes_of(body).into_iter();
        let distance = |node: &usize| (self.points[*node][0] - x).hypot(self.points[*node][1] - y);
        let nearest = nodes.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap();
        assert!(distance(&nearest) < 1e-9, "no node of body {body} at ({x}, {y})");
        nearest
    }
}

/// The bytes of a data array, after its count of them.
fn array(text: &str, kind: &str, name: &str) -> Vec<u8> {
    let element =
        text.split("<DataArray ").find(|part| part.contains(&format!("Name=\"{name}\""))).unwrap();
    assert!(
        element.starts_with(&format!("type=\"{kind}\"")) && element.contains("format=\"binary\"")
    );
    let (_, rest) = element.split_once('>').unwrap();
    let bytes = STANDARD.decode(rest.split_once('<').unwrap().0).unwrap();
    let (count, values) = bytes.split_at(8);
    assert_eq!(u64::from_le_bytes(count.try_into().unwrap()), values.len() as u64);
    values.to_vec()
}

fn floats(text: &str, name: &str) -> Vec<f64> {
    let bytes = array(text, "Float64", name);
    bytes.chunks_exact(8).map(|eight| f64::from_le_bytes(eight.try_into().unwrap())).collect()
}

fn integers(text: &str, name: &str) -> Vec<usize> {
    let bytes = array(text, "Int64", name);
    let number =
        |eight: &[u8]| usize::try_from(i64::from_le_bytes(eight.try_into().unwrap())).unwrap();
    bytes.chunks_exact(8).map(number).collect()
}

fn tuples<T: Copy, const N: usize>(values: &[T]) -> Vec<[T; N]> {
    assert_eq!(values.len() % N, 0);
    values
        .chunks_exact(N)
        .map(|chunk| <[T; N]>::try_from(chunk).unwrap_or_else(|_| unreachable!()))
        .collect()
}

#[test]
fn both_bodies_are_whole_and_the_right_way_round() {
    let (grid, _) = Grid::of(&paper());
    let (n, m) = (grid.points.len(), grid.cells.len());
    assert_eq!((grid.displacement.len(), grid.stress.len(), grid.body.len()), (n, n, m));
    for body in [0, 1] {
        let areas: Vec<f64> =
            (0..m).filter(|cell| grid.body[*cell] == body).map(|cell| grid.area(cell)).collect();
        assert!(areas.iter().all(|area| *area > 0.0));
        let half_disc = 0.5 * std::f64::consts::PI * 20.0 * 20.0;
        let ratio = areas.iter().sum::<f64>() / half_disc;
        assert!((0.98..1.0).contains(&ratio), "{ratio}");
        let nodes = grid.nodes_of(body);
        assert_eq!(
            nodes.iter().filter(|node| grid.points[**node][0] == 0.0).count() % 2,
            nodes.len() % 2
        );
        let sum: f64 = nodes.iter().map(|node| grid.points[*node][0]).sum();
        assert!(sum.abs() < 1e-9);
    }
    // The upper body lies above: what is lowest of it is what is highest of the lower one.
    let heights = |body| {
        grid.nodes_of(body).into_iter().map(|node| grid.points[node][1]).collect::<Vec<_>>()
    };
    assert!(heights(0).iter().all(|y| *y <= 0.0) && heights(1).iter().all(|y| *y >= 0.0));
}

#[test]
fn the_surface_carries_the_contact_pressure() {
    let (grid, report) = Grid::of(&paper());
    let step = &report.steps[0];
    let pairs = step.contact.nodes.x.iter().zip(&step.contact.nodes.pressure);
    let inner: Vec<_> = pairs.filter(|(x, _)| x.abs() < 0.7 * step[Name::HalfWidth]).collect();
    assert!(inner.len() > 20);
    for (&x, &pressure) in inner {
        let height = 20.0 - (400.0 - x * x).sqrt();
        for (body, sign) in [(0, -1.0), (1, 1.0)] {
            let node = grid.node_at(body, [x, sign * height]);
            let sigma_y = grid.stress[node][1];
            assert!(
                (sigma_y + pressure).abs() < 0.03 * step[Name::PeakPressure],
                "{x}: {sigma_y} {pressure}"
            );
        }
    }
}

#[test]
fn equal_bodies_move_as_mirror_images_and_the_upper_one_comes_down() {
    let (grid, report) = Grid::of(&paper());
    let approach = report.steps[0].approach().unwrap();
    let (lower, upper) = (grid.nodes_of(0), grid.nodes_of(1));
    assert_eq!(lower.len(), upper.len());
    for (&l, &u) in lower.iter().zip(&upper) {
        let (below, above) = (grid.points[l], grid.points[u]);
        assert_eq!((below[0], below[1]), (above[0], -above[1] + 0.0));
        let ([x, y, _], [u_x, u_y, _]) = (grid.displacement[l], grid.displacement[u]);
        assert!((u_x - x).abs() < 1e-9 * approach && (u_y + y + approach).abs() < 1e-9 * approach);
        if below[1] < -20.0 + 1e-9 {
            assert!(y == 0.0 && (u_y + approach).abs() < 1e-12, "{y} {u_y}");
        }
    }
    let (l, u) = (grid.node_at(0, [0.0, 0.0]), grid.node_at(1, [0.0, 0.0]));
    let closed = grid.displacement[u][1] - grid.displacement[l][1];
    assert!(closed.abs() < 1e-7 * approach, "displaced, the bodies touch: {closed}");
}

/// A flat block under a face whose only summit is off the centre, in SI.
fn bump_in_si() -> Value {
    let material = json!({"young_modulus": 210e9, "poisson_ratio": 0.3});
    let points: Vec<[f64; 2]> = (-20..=20)
        .map(|k| {
            let x = 1e-3 * f64::from(k);
            [x, 5e-4 - 2.0 * (x - 4e-3).powi(2) - 5e-4 + 2.0 * 16e-6]
        })
        .collect();
    json!({
        "analysis": "plane_strain", "units": "SI", "load": {"force": 2e5},
        "upper": {"shape": {"type": "profile", "points": points, "depth": 0.02},
            "material": material},
        "lower": {"shape": {"type": "block", "width": 0.04, "depth": 0.02}, "material": material},
        "mesh": {"elements_per_half_width": 8}, "output": {"fields": true},
    })
}

#[test]
fn bodies_that_touch_off_the_centre_are_put_together_there() {
    let (grid, report) = Grid::of(&bump_in_si());
    let contact = &report.steps[0].contact;
    let peak = report.steps[0].peak_position();
    assert!((peak - 4e-3).abs() < 2e-4, "{peak}");
    let pairs = contact.nodes.x.iter().zip(&contact.nodes.pressure);
    let pressed: Vec<f64> =
        pairs.filter(|(_, pressure)| **pressure > 0.0).map(|(x, _)| *x).collect();
    assert!(pressed.len() > 8, "{}", pressed.len());
    let upper = grid.nodes_of(1);
    let height = |node: &usize| grid.points[*node][1];
    let lowest = upper.iter().map(height).fold(f64::INFINITY, f64::min);
    assert!(lowest.abs() < 1e-9, "the surfaces just touch before loading: {lowest}");
    for x in pressed {
        let column =
            upper.iter().copied().filter(|node| (grid.points[*node][0] - x).abs() < 1e-12);
        let above = column.min_by(|a, b| height(a).total_cmp(&height(b))).unwrap();
        let below = grid.node_at(0, [x, 0.0]);
        let gap = height(&above) + grid.displacement[above][1] - grid.displacement[below][1];
        assert!(gap.abs() < 1e-6 * report.steps[0].approach().unwrap(), "{x}: {gap}");
    }
}

#[test]
fn a_body_of_revolution_is_its_half_section() {
    let mut job = paper();
    job["analysis"] = json!("axisymmetric");
    job["mesh"] = json!({"elements_per_half_width": 6});
    job["upper"]["material"] = json!({"rigid": true});
    let (grid, _) = Grid::of(&job);
    assert!(grid.points.iter().all(|point| point[0] >= 0.0));
    assert!(grid.body.iter().all(|body| *body == 0), "a rigid body has no fields");
}

#[test]
fn what_the_result_lacks_is_named() {
    let mut job = paper();
    job["output"] = json!({"fields": false, "subsurface": false});
    let (job, report) = solve(&job);
    let write = |form: Export, step| form.write(&job, &report, step);
    assert_eq!(write(Export::FieldVtu, None), Err(ExportError::NoFields));
    assert_eq!(write(Export::FieldVtr, None), Err(ExportError::NoLayers));
    assert_eq!(write(Export::SubsurfaceCsv, None), Err(ExportError::NoSubsurface));
    assert_eq!(write(Export::DepthSvg, None), Err(ExportError::NoSubsurface));
    assert_eq!(write(Export::FatigueCsv, None), Err(ExportError::NoFatigue));
    assert_eq!(write(Export::PressureSvg, Some(1)), Err(ExportError::NoStep(1)));
    let needed = |form: Export| {
        let mut job = job.clone();
        form.require(&mut job);
        (job.output.fields, job.output.subsurface)
    };
    assert_eq!(
        Export::ALL.iter().copied().map(needed).collect::<Vec<_>>(),
        [
            (false, false),
            (false, false),
            (false, true),
            (false, false),
            (false, false),
            (false, false),
            (false, false),
            (false, false),
            (true, false),
            (true, false),
            (false, false),
            (false, true),
            (false, false),
            (false, false)
        ]
    );
}

#[test]
fn tables_hold_every_step() {
    let mut job = paper();
    job["load"] = json!({"forces": [300.0, 400.0]});
    job["mesh"] = json!({"elements_per_half_width": 6});
    let (job, report) = solve(&job);
    let text = Export::PressureCsv.write(&job, &report, None).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("step,x [mm],pressure [MPa],force [N/mm],gap [mm]"));
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    for (step, force) in [("1", 300.0), ("2", 400.0)] {
        let of_step = rows.iter().filter(|row| row[0] == step);
        let total: f64 = of_step.map(|row| row[3].parse::<f64>().unwrap()).sum();
        assert!((total / force - 1.0).abs() < 1e-9, "{step}: {total}");
    }
    let last = Export::PressureSvg.write(&job, &report, None).unwrap();
    assert_eq!(last, Export::PressureSvg.write(&job, &report, Some(1)).unwrap());
    assert_ne!(last, Export::PressureSvg.write(&job, &report, Some(0)).unwrap());
}

/// A later step has rows that the first has not, and none is lost.
#[test]
fn a_summary_has_the_columns_of_all_steps() {
    let mut job = paper();
    job["load"] = json!({"forces": [100.0, 400.0]});
    job["mesh"] = json!({"elements_per_half_width": 6});
    job["output"] = json!({});
    let (job, report) = solve(&job);
    let text = Export::SummaryCsv.write(&job, &report, None).unwrap();
    let rows: Vec<Vec<&str>> = text.lines().map(|row| row.split(',').collect()).collect();
    let heads = &rows[0];
    for (step, cells) in report.steps.iter().zip(&rows[1..]) {
        let filled = cells.iter().skip(2).filter(|cell| !cell.is_empty()).count();
        assert_eq!(
            filled,
            step.answers.iter().filter(|row| row.value.is_some()).count(),
            "{text}"
        );
    }
    let depth = heads.iter().position(|head| *head == "plastic_depth [mm]").unwrap();
    assert_eq!((rows[1][depth], rows[2][depth].is_empty()), ("", false), "{text}");
    let place = |name: &str| heads.iter().position(|head| head.starts_with(name));
    assert!(place("peak_pressure") < place("utilization"), "in the order of the names: {text}");
}

/// Line by line what the report has: every increment, every node of the surfaces.
#[test]
fn a_history_is_written_as_tables_and_figures() {
    let mut asked = paper();
    asked["mesh"] = json!({"elements_per_half_width": 6});
    asked["load"] = json!({"history": [{"force": 700}, {"force": 0}]});
    asked["solver"] = json!({"theory": "flow"});
    let (job, report) = solve(&asked);
    let written = |form: Export| form.write(&job, &report, None).unwrap();
    let ends = report.steps[0].increments.as_ref().unwrap();
    let increments = written(Export::IncrementsCsv);
    let rows: Vec<&str> = increments.lines().skip(1).collect();
    assert_eq!(rows.len(), ends.force.len() + 1);
    assert!(rows[rows.len() - 1].starts_with("2,1,0,"), "{}", rows[rows.len() - 1]);
    let summary = written(Export::SummaryCsv);
    let rows: Vec<Vec<&str>> = summary.lines().map(|row| row.split(',').collect()).collect();
    assert!(rows.len() == 3 && rows.iter().all(|row| row.len() == rows[0].len()), "{summary}");
    let last: Vec<_> = rows[0].iter().zip(&rows[2]).collect();
    let cell = |name: &str| *last.iter().find(|(column, _)| column.starts_with(name)).unwrap().1;
    let of_the_dent = [Name::DentDepth, Name::PermanentApproach, Name::ResidualTension];
    for name in of_the_dent.into_iter().chain([Name::PlasticDepth, Name::Work]) {
        let (word, value): (&str, _) = (name.into(), report.steps[1][name].to_string());
        assert_eq!(cell(word), value);
    }
    // A step without force has no slope of its load.
    assert_eq!(cell("unloading_stiffness"), "");
    let surfaces = written(Export::SurfaceCsv);
    let dent = report.steps[1].surfaces.as_ref().unwrap().lower.as_ref().unwrap();
    let last =
        format!("2,lower,{},{}", dent.x[dent.x.len() - 1], dent.height[dent.height.len() - 1]);
    assert_eq!(surfaces.lines().last(), Some(last.as_str()));
    for (form, texts) in [
        (Export::LoadApproachSvg, ["approach [mm]", "force [N/mm]"]),
        (Export::SurfaceSvg, ["Residual profile", "height over the undeformed surface [mm]"]),
        (Export::DepthSvg, ["Residual stresses", "plastic"]),
    ] {
        let figure = written(form);
        assert!(texts.iter().all(|text| figure.contains(text)), "{form:?}");
    }
    let vtu = Grid::of(&{
        asked["output"] = json!({"fields": true});
        asked
    });
    let largest = vtu.0.stress.iter().map(|stress| stress[0].abs()).fold(0.0, f64::max);
    assert!(largest > 20.0, "stresses are left: {largest}");
    let (job, report) = solve(&paper());
    assert_eq!(Export::IncrementsCsv.write(&job, &report, None), Err(ExportError::NoFlow));
    assert_eq!(Export::SurfaceSvg.write(&job, &report, None), Err(ExportError::NoFlow));
    assert_eq!(Export::LoadApproachSvg.write(&job, &report, None), Err(ExportError::NoCurve));
}

/// Unloading in one increment is not drawn as if it had been solved on its way.
#[test]
fn a_loop_says_where_nothing_is_solved() {
    let body = json!({
        "shape": {"type": "cylinder", "radius": 20},
        "material": {"young_modulus": 210e3, "poisson_ratio": 0.3,
            "plasticity": {"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10.5e3}},
    });
    let job = |load: Value| {
        json!({
            "analysis": "plane_strain", "upper": body, "lower": body, "load": load,
            "mesh": {"elements_per_half_width": 6}, "solver": {"theory": "flow"},
        })
    };
    for (load, count) in [
        (json!({"history": [{"force": 600}, {"force": 0}]}), 1),
        (json!({"history": [{"force": 600}, {"force": 0}, {"force": 600}, {"force": 0}]}), 1),
        (json!({"forces": [400, 600]}), 0),
    ] {
        let (job, report) = solve(&job(load));
        let svg = Export::LoadApproachSvg.write(&job, &report, None).unwrap();
        assert_eq!(svg.matches("nothing solved between").count(), count);
        assert_eq!(svg.matches("this contact").count(), 1);
    }
}

/// A load that rolls has the columns of its steps, in plane strain and under a ball.
#[test]
fn each_row_has_the_fields_of_its_heading() {
    let steel = json!({"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity":
        {"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10_500}});
    let rigid = json!({"rigid": true});
    let of = |analysis: &str, upper: Value, lower: Value, load: Value| {
        json!({"analysis": analysis, "solver": {"theory": "flow"}, "load": load,
            "upper": {"shape": upper, "material": rigid},
            "lower": {"shape": lower, "material": steel},
            "mesh": {"elements_per_half_width": 5}})
    };
    let ball = || json!({"type": "sphere", "radius": 10});
    let flat = || json!({"type": "flat"});
    let cylinder = || json!({"type": "cylinder", "radius": 10});
    let block = || json!({"type": "block", "width": 40, "depth": 20});
    let rolling = |force: f64| json!({"rolling": {"force": force, "passes": 2}});
    let turn = |force: f64| json!({"history": [{"force": force}, {"force": 0.0}]});
    for asked in [
        of("three_dimensional", ball(), flat(), rolling(40.0)),
        of("three_dimensional", ball(), flat(), turn(40.0)),
        of("plane_strain", cylinder(), block(), rolling(400.0)),
        of("plane_strain", cylinder(), block(), turn(400.0)),
    ] {
        let (job, report) = solve(&asked);
        let is_rolling = report.steps[0].passes.is_some();
        for form in [
            Export::SummaryCsv,
            Export::PressureCsv,
            Export::SubsurfaceCsv,
            Export::IncrementsCsv,
            Export::SurfaceCsv,
            Export::PassesCsv,
        ] {
            let table = match form.write(&job, &report, None) {
                Ok(table) => table,
                Err(error) => {
                    let expected =
                        if is_rolling { ExportError::Rolling } else { ExportError::NotRolling };
                    assert_eq!(error, expected, "{form:?}");
                    continue;
                }
            };
            let fields: Vec<usize> = table.lines().map(|line| line.split(',').count()).collect();
            assert!(
                fields.len() > 1 && fields.iter().all(|n| *n == fields[0]),
                "{form:?} {asked}"
            );
        }
    }
}
