//! Exports of results for other programs.

use brinell_solver::job::Named as _;
use brinell_solver::report::export::Export;
use serde_json::{Value, json};

use crate::in_process::{InProcess, job};
use crate::server::{Server, Target, example};

fn solved(service: &Target, load: &serde_json::Value, output: &serde_json::Value) -> String {
    let mut job = example();
    job["mesh"] = json!({"elements_per_half_width": 6});
    job["load"] = load.clone();
    job["output"] = output.clone();
    job["solver"] = json!({"theory": "deformation"});
    let job = service.submit(&job);
    service.wait_for(&job, &["succeeded"]);
    job
}

#[test]
fn every_form_of_a_result_is_served_under_its_name() {
    let server = Server::start();
    let job = solved(&server.target, &json!({"force": 600.0}), &json!({"fields": true}));
    for (file, media_type, disposition, beginning) in [
        ("summary.csv", "text/csv; charset=utf-8; header=present", "attachment", "step,status,"),
        ("pressure.csv", "text/csv; charset=utf-8; header=present", "attachment", "step,x [mm],"),
        (
            "subsurface.csv",
            "text/csv; charset=utf-8; header=present",
            "attachment",
            "step,body,depth [mm],",
        ),
        ("field.vtu", "application/xml", "attachment", "<?xml version"),
        ("pressure.svg", "image/svg+xml", "inline", "<svg "),
        ("depth.svg", "image/svg+xml", "inline", "<svg "),
    ] {
        let answer = server.target.get(&format!("{job}/{file}"));
        let text = String::from_utf8(answer.body.clone()).unwrap();
        assert_eq!(
            (answer.status, answer.header("content-type")),
            (200, Some(media_type)),
            "{text}"
        );
        assert!(text.starts_with(beginning), "{file}: {}", &text[..80]);
        let id = job.rsplit('/').next().unwrap();
        let expected = format!("{disposition}; filename=\"{id}-{file}\"");
        assert_eq!(answer.header("content-disposition"), Some(expected.as_str()));
    }
}

#[test]
fn stresses_over_depth_say_at_which_x_or_r_they_lie() {
    let server = Server::start();
    let mut asked = example();
    asked["mesh"] = json!({"elements_per_half_width": 6});
    for (analysis, place, stresses) in [
        ("plane_strain", "x [mm]", "sigma_x [MPa],sigma_y [MPa],sigma_z [MPa]"),
        ("axisymmetric", "r [mm]", "sigma_r [MPa],sigma_z [MPa],sigma_theta [MPa]"),
    ] {
        asked["analysis"] = json!(analysis);
        let job = server.target.submit(&asked);
        server.target.wait_for(&job, &["succeeded"]);
        let text =
            String::from_utf8(server.target.get(&format!("{job}/subsurface.csv")).body).unwrap();
        assert!(text.starts_with(&format!("step,body,depth [mm],{stresses},")), "{text}");
        let mut rows = text.lines().map(|line| line.rsplit(',').next().unwrap());
        assert_eq!(rows.next(), Some(place));
        let report = server.target.get(&format!("{job}/result")).json();
        let at = report["steps"][0]["subsurface"]["lower"]["position"][0].as_f64().unwrap();
        assert!(at == 0.0 && rows.any(|row| row == at.to_string()), "{analysis}");
    }
}

#[test]
fn a_history_is_served_as_tables_and_figures() {
    let server = Server::start();
    let mut asked = example();
    asked["mesh"] = json!({"elements_per_half_width": 6});
    asked["load"] = json!({"history": [{"force": 700.0}, {"force": 0.0}]});
    asked["solver"] = json!({"theory": "flow"});
    let job = server.target.submit(&asked);
    server.target.wait_for(&job, &["succeeded"]);
    for (file, beginning) in [
        ("increments.csv", "step,increment,force [N/mm],"),
        ("surface.csv", "step,body,x [mm],height [mm]"),
        ("surface.svg", "<svg "),
        ("load_approach.svg", "<svg "),
    ] {
        let answer = server.target.get(&format!("{job}/{file}"));
        assert_eq!(answer.status, 200, "{file}");
        assert!(String::from_utf8(answer.body).unwrap().starts_with(beginning), "{file}");
    }
    let other = solved(&server.target, &json!({"force": 600.0}), &json!({}));
    server.target.get(&format!("{job}/hardness.csv")).problem(409, "not-in-result");
    let files =
        ["increments.csv", "hardness.csv", "surface.csv", "surface.svg", "load_approach.svg"];
    for file in files {
        server.target.get(&format!("{other}/{file}")).problem(409, "not-in-result");
    }
}

#[test]
fn a_hardness_test_has_its_curve() {
    let server = Server::start();
    let mut asked: Value =
        serde_json::from_str(include_str!("../../api/examples/brinell_test.json")).unwrap();
    asked["mesh"] = json!({"elements_per_half_width": 6});
    let job = server.target.submit(&asked);
    server.target.wait_for(&job, &["succeeded"]);
    let linked = server.target.get(&job).json()["links"]["hardness_csv"].clone();
    let text = String::from_utf8(server.target.get(linked.as_str().unwrap()).body).unwrap();
    assert!(text.starts_with("step,displacement [mm],force [N],diameter [mm],"), "{text}");
    assert!(text.lines().last().unwrap().starts_with("2,"), "{text}");
}

#[test]
fn a_step_of_a_sweep_is_chosen() {
    let server = Server::start();
    let job = solved(&server.target, &json!({"forces": [200.0, 600.0]}), &json!({}));
    let figure = |query: &str| server.target.get(&format!("{job}/pressure.svg{query}"));
    let (first, second, last) = (figure("?step=1"), figure("?step=2"), figure(""));
    assert_eq!((first.status, second.status), (200, 200));
    assert_eq!(last.body, second.body);
    assert_ne!(first.body, second.body);
    figure("?step=3").problem(404, "step-not-found");
    for query in ["?step=0", "?step=x", "?steps=1"] {
        figure(query).problem(400, "invalid-query");
    }
    let table = server.target.get(&format!("{job}/pressure.csv?step=1"));
    table.problem(400, "invalid-query");
    let table = server.target.get(&format!("{job}/pressure.csv"));
    let text = String::from_utf8(table.body).unwrap();
    assert!(
        text.lines().any(|line| line.starts_with("1,"))
            && text.lines().any(|line| line.starts_with("2,"))
    );
}

#[test]
fn parts_of_a_result_are_selected() {
    let server = Server::start();
    let job = solved(&server.target, &json!({"forces": [200.0, 400.0, 600.0]}), &json!({}));
    let result = |query: &str| server.target.get(&format!("{job}/result{query}")).json();
    let (whole, part) = (result(""), result("?fields=subsurface&step=3"));
    assert_eq!(part["steps"].as_array().unwrap().len(), 1);
    let (whole, part) = (&whole["steps"][2], &part["steps"][0]);
    assert_eq!(part["subsurface"], whole["subsurface"]);
    assert_eq!(part["answers"], whole["answers"]);
    assert_eq!((&part["contact"]["nodes"]["x"], &part["history"]), (&json!([]), &json!([])));
    assert!(part.get("fields").is_none());
    let thinned = result("?subsurface_points=7");
    let depth = thinned["steps"][2]["subsurface"]["upper"]["depth"].as_array().unwrap();
    let all = whole["subsurface"]["upper"]["depth"].as_array().unwrap();
    assert!(depth.len() <= 7 && depth.first() == all.first() && depth.last() == all.last());

    let csv = ["-H", "Accept: text/csv", &format!("{}{job}/result", server.target.url)];
    let table = crate::curl::curl(&csv);
    assert!(table.header("content-type").is_some_and(|kind| kind.starts_with("text/csv")));
    assert_eq!(String::from_utf8(table.body).unwrap().lines().count(), 4);
}

/// Jobs of each engine, with the names of arrays that it has and those that it does not have.
fn engines() -> [(Value, &'static str, &'static str); 4] {
    let steel = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
    let mut soft = steel.clone();
    soft["plasticity"] =
        json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10_500});
    let mut mesh = example();
    mesh["load"] = json!({"history": [{"force": 700.0}, {"force": 0.0}]});
    mesh["solver"] = json!({"theory": "flow"});
    let half_spaces = json!({
        "analysis": "three_dimensional",
        "upper": {"shape": {"type": "sphere", "radius": 5}, "material": steel},
        "lower": {"shape": {"type": "flat"}, "material": soft},
        "load": {"force": 300},
        "solver": {"theory": "flow"},
    });
    let mut track = half_spaces.clone();
    track["load"] = json!({"rolling": {"force": 300, "passes": 2}});
    let line = json!({
        "analysis": "plane_strain",
        "upper": {"shape": {"type": "cylinder", "radius": 10}, "material": steel},
        "lower": {"shape": {"type": "block", "width": 60, "depth": 30}, "material": soft},
        "load": {"rolling": {"force": 2000, "passes": 2}},
        "solver": {"theory": "flow"},
    });
    let (of_mesh, of_layers) = ("nodes,sigma_x", "z_faces,sigma_xx");
    [
        (mesh, of_mesh, of_layers),
        (half_spaces, of_layers, of_mesh),
        (track, of_layers, of_mesh),
        (line, "", "nodes,z_faces"),
    ]
}

#[test]
fn what_an_engine_does_not_have_is_not_in_its_results() {
    let server = Server::start();
    for (mut asked, present, missing) in engines() {
        asked["mesh"] = json!({"elements_per_half_width": 4});
        for with_fields in [false, true] {
            asked["output"] = json!({"fields": with_fields, "subsurface": with_fields});
            let job = server.target.submit(&asked);
            let links = server.target.wait_for(&job, &["succeeded"])["links"].clone();
            for form in Export::ALL.iter().map(|form| form.name()) {
                let answer = server.target.get(&format!("{job}/{form}"));
                if links[form.replace('.', "_")].is_string() {
                    assert_eq!(answer.status, 200, "{form} of {asked}");
                } else {
                    answer.problem(409, "not-in-result");
                }
            }
            let arrays =
                |names: &str| server.target.get(&format!("{job}/fields/1?arrays={names}"));
            let problem = arrays(missing).problem(409, "not-in-result");
            if with_fields && !present.is_empty() {
                let detail = problem["detail"].as_str().unwrap();
                assert!(present.split(',').all(|name| detail.contains(name)), "{detail}");
                let (some, both) = (arrays(present), arrays(&format!("{missing},{present}")));
                assert_eq!((some.status, some.body), (200, both.body));
            }
        }
    }
}

#[test]
fn missing_exports_are_problems() {
    let server = Server::start();
    let job = solved(&server.target, &json!({"force": 600.0}), &json!({"subsurface": false}));
    let problem = server.target.get(&format!("{job}/field.vtu")).problem(409, "not-in-result");
    assert!(problem["detail"].as_str().is_some_and(|detail| detail.contains("\"fields\": true")));
    for file in ["subsurface.csv", "depth.svg"] {
        server.target.get(&format!("{job}/{file}")).problem(409, "not-in-result");
    }
    for file in ["pressure.csv", "field.vtu"] {
        server.target.get(&format!("/v1/jobs/{JOB}/{file}")).problem(404, "job-not-found");
    }
    server.target.get(&format!("{job}/field.vtk")).problem(404, "not-found");
}

/// An id that no job has.
const JOB: &str = "01a1fc6a-2293-7211-9e1b-645589471433";

#[test]
fn an_unfinished_job_has_no_form() {
    let service = InProcess::start(|_| ());
    let slow = service.target.submit(&job("slow"));
    service.target.get(&format!("{slow}/pressure.csv")).problem(409, "job-unfinished");
    service.solver.open_gate();
    let failed = service.target.submit(&job("impossible"));
    service.target.wait_for(&failed, &["failed"]);
    service.target.get(&format!("{failed}/pressure.csv")).problem(409, "no-result");
}
