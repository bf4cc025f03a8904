//! The command line: exit codes, messages and the table.
#![expect(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that cannot go on says where"
)]

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread;

use serde_json::{Value, json};

const EXAMPLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/api/examples/two_cylinders.json");

/// Runs the program with this standard input.
fn brinell(args: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_brinell"))
        .args(args)
        .env("LC_ALL", "C.UTF-8")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the binary starts");
    let mut stdin = child.stdin.take().expect("a pipe");
    let input = input.to_owned();
    let feeder = thread::spawn(move || drop(stdin.write_all(input.as_bytes())));
    let output = child.wait_with_output().expect("the binary ends");
    feeder.join().expect("the feeder ends");
    output
}

fn example() -> Value {
    serde_json::from_str(include_str!("../api/examples/two_cylinders.json"))
        .expect("the example is JSON")
}

/// The example with one value replaced or added.
fn spoilt(pointer: &str, value: Value) -> String {
    let mut job = example();
    let (parent, key) = pointer.rsplit_once('/').unwrap();
    job.pointer_mut(parent).unwrap()[key] = value;
    job.to_string()
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("UTF-8")
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("UTF-8")
}

/// The table of a job, which keeps to the width of a terminal.
fn table_of(job: &str, input: &str) -> String {
    let output = brinell(&["solve", job, "--format", "table"], input);
    let table = stdout(&output);
    assert_eq!(output.status.code(), Some(0), "{}{table}", stderr(&output));
    for line in table.lines() {
        assert!(line.chars().count() <= 80, "{line:?} is too long");
    }
    table
}

fn shown(job: &Value) -> String {
    table_of("-", &job.to_string())
}

#[test]
fn three_dimensions_have_two_semi_axes_and_two_pictures() {
    let raceway = concat!(env!("CARGO_MANIFEST_DIR"), "/api/examples/ball_in_raceway.json");
    let text = table_of(raceway, "");
    for part in
        ["force 500.0000 N", "Shorter semi-axis", "Longer semi-axis", "x = 0 mm", "y = 0 mm"]
    {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
    let svg = stdout(&brinell(&["solve", raceway, "--format", "svg"], ""));
    assert!(
        svg.matches("<rect").count() > 300,
        "a filled map has a rectangle for each cell that is pressed"
    );
}

#[test]
fn solve_writes_json_into_a_pipe() {
    let output = brinell(&["solve", EXAMPLE], "");
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let report: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(report["status"], "converged");
    assert!(report["timings_ms"]["total"].as_f64().is_some());
}

#[test]
fn solve_reads_standard_input_and_writes_files() {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR"));
    for (format, file) in [("json", "result.json"), ("table", "result.txt")] {
        let path: PathBuf = directory.join(file);
        let name = path.to_str().unwrap();
        let output =
            brinell(&["solve", "-", "--format", format, "-o", name], &example().to_string());
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        assert!(output.stdout.is_empty());
        let written = std::fs::read_to_string(&path).unwrap();
        assert_eq!(format == "json", serde_json::from_str::<Value>(&written).is_ok(), "{written}");
    }
}

#[test]
fn solve_writes_every_format() {
    let mut sweep = example();
    sweep["mesh"] = json!({"elements_per_half_width": 6});
    sweep["load"] = json!({"forces": [300.0, 600.0]});
    for (format, beginning) in [
        ("csv", "step,x [mm],pressure [MPa]"),
        ("subsurface-csv", "step,body,depth [mm]"),
        ("vtu", "<?xml version=\"1.0\"?>"),
        ("svg", "<svg "),
        ("depth-svg", "<svg "),
        ("load-approach-svg", "<svg "),
    ] {
        let output = brinell(&["solve", "-", "--format", format], &sweep.to_string());
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        assert!(stdout(&output).starts_with(beginning), "{format}");
    }
    let figure = |step: &str| {
        brinell(&["solve", "-", "--format", "svg", "--step", step], &sweep.to_string())
    };
    assert_ne!(figure("1").stdout, figure("2").stdout);
    let beyond = figure("3");
    assert_eq!(
        (beyond.status.code(), stderr(&beyond).as_str()),
        (Some(2), "error: there is no step 3\n")
    );
}

/// A case and a stress before the load are parts of a body; the limit of rolling stands beside the
/// onset of yield.
#[test]
fn the_table_says_what_lies_below_the_surface() {
    for (example, words) in [
        ("case_hardened_roller", ["its stresses × 1.00 to 1.98 over depth", "Shakedown pressure"]),
        ("peened_roller", ["σ_x -1000 to 60 before the load", "σ_x -500 to 0 before the load"]),
    ] {
        let path = format!("api/examples/{example}.json");
        let table = table_of(&path, "").replace("\n       ", " ");
        for expected in words {
            assert!(table.contains(expected), "{expected:?} is missing:\n{table}");
        }
    }
}

#[test]
fn the_table_says_what_matters() {
    let table = table_of(EXAMPLE, "");
    for expected in [
        "upper  Cylinder R 20",
        "lower  Cylinder R 20",
        "force 612.6106 N/mm",
        "converged in",
        "Peak pressure",
        "Half-width",
        "Approach",
        "Largest plastic strain",
        "Utilization",
        "Margin to first yield",
        "Yields: 2.8 times first yield at 218.99 N/mm",
        "Hertz",
        "Plastic depth",
        "residual",
        "time   ",
    ] {
        assert!(table.contains(expected), "{expected:?} is missing:\n{table}");
    }
    assert!(!table.contains('\x1b'), "no colours into a pipe");
    let history = table.lines().skip_while(|line| !line.contains("residual"));
    assert!(history.take_while(|line| !line.is_empty()).count() <= 13, "{table}");
}

/// A ball has a radius of contact, and its pressure is drawn over the radius.
#[test]
fn bodies_of_revolution_have_their_own_words() {
    let mut ball = example();
    ball["analysis"] = json!("axisymmetric");
    ball["mesh"] = json!({"elements_per_half_width": 10});
    ball["load"] = json!({"force": 2000.0});
    let table = shown(&ball);
    for expected in ["upper  Sphere R 20", "Contact radius", "r = 0 mm", " at r 0"] {
        assert!(table.contains(expected), "{expected:?} is missing:\n{table}");
    }
    for plane in ["Cylinder", "Half-width", "x = 0", "at x"] {
        assert!(!table.contains(plane), "{plane:?} is of plane bodies:\n{table}");
    }
    let drawn = table.lines().skip_while(|line| !line.contains("pressure  [")).skip(1).take(12);
    let filled =
        drawn.filter(|line| line.chars().skip(11).take(8).any(|sign| sign != ' ')).count();
    assert!(filled >= 2, "the curve begins at the axis:\n{table}");
}

/// Long names and lists of a law's parameters keep to the width of a terminal too.
#[test]
fn tables_of_examples_keep_to_80_columns() {
    for name in ["ball_runs_in", "rolled_hardened_roller", "ellipse_dent"] {
        let path = format!("{}/api/examples/{name}.json", env!("CARGO_MANIFEST_DIR"));
        let mut job: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
        job["mesh"] = json!({"elements_per_half_width": 8});
        let table = shown(&job);
        assert!(table.lines().count() > 20, "{table}");
    }
    let mut job = example();
    job["mesh"] = json!({"elements_per_half_width": 5});
    for radius in ["2.4", "2.41", "2.412", "2.4123"] {
        job["upper"] = json!({"shape": {"type": "cylinder", "radius": radius.parse::<f64>().unwrap()},
            "material": {"young_modulus": 84_279, "poisson_ratio": 0.2679, "plasticity":
                {"law": "swift", "yield_stress": 290.6, "strain_offset": 3.788e-5,
                    "exponent": 0.056_46}}});
        let table = shown(&job);
        assert!(table.contains("Swift"), "{table}");
    }
}

/// Places of two coordinates and long approaches keep to the width of a terminal too.
#[test]
fn tables_of_yielding_balls_keep_to_80_columns() {
    for (units, scale) in [("mm_N_MPa", 1.0), ("SI", 1e-3)] {
        let mut balls = example();
        balls["analysis"] = json!("three_dimensional");
        balls["units"] = json!(units);
        for body in ["upper", "lower"] {
            let to_stress = if units == "SI" { 1e6 } else { 1.0 };
            balls[body] = json!({"shape": {"type": "sphere", "radius": 0.123_456 * scale},
                "material": {"young_modulus": 210_000.0 * to_stress, "poisson_ratio": 0.3,
                    "plasticity": {"law": "bilinear", "yield_stress": 500.0 * to_stress,
                        "tangent_modulus": 10_500.0 * to_stress}}});
        }
        balls["load"] = json!({"history": [{"force": 0.012_345}, {"force": 0.03}]});
        balls["mesh"] = json!({"elements_per_half_width": 5});
        balls["solver"] = json!({"theory": "flow"});
        let table = shown(&balls);
        assert!(table.contains(", y ") && table.contains("depth"), "{table}");
    }
}

/// A figure that is not known says why: of a pin whose contact is narrower than an element.
#[test]
fn the_table_says_why_a_figure_is_not_known() {
    let mut pin = example();
    pin["analysis"] = json!("plane_strain");
    pin["upper"]["shape"] = json!({"type": "cylinder", "radius": 10});
    pin["lower"]["shape"] = json!({"type": "hole", "radius": 10.02, "outer_radius": 14});
    pin["load"] = json!({"history": [{"force": 5}, {"force": 2500}]});
    pin["mesh"] = json!({"elements_per_half_width": 8});
    pin["solver"] = json!({"theory": "flow"});
    let table = shown(&pin);
    for label in ["Half-width", "Mean pressure"] {
        let line = table.lines().find(|line| line.starts_with(label)).expect(label);
        assert!(line.ends_with("—  narrower than an element"), "{line}");
    }
    let margin = table.find("Margin to first yield").expect("a margin");
    assert!(table[margin..].contains("`load.onset`"), "{table}");
    let angles =
        table.lines().filter(|line| line.starts_with("Angle of contact ") && line.contains('±'));
    assert_eq!(angles.count(), 1, "of the large force only: {table}");
}

/// Hertz's mean pressure of a circle is two thirds of the peak.
#[test]
fn the_table_has_the_mean_pressure_of_a_circle() {
    let mut ball = example();
    ball["analysis"] = json!("axisymmetric");
    ball["mesh"] = json!({"elements_per_half_width": 20});
    ball["load"] = json!({"force": 10.0});
    let table = shown(&ball);
    let mean =
        table.lines().find(|line| line.starts_with("Mean pressure")).expect("a mean pressure");
    let ratio: f64 =
        mean.split_whitespace().nth(5).and_then(|word| word.parse().ok()).expect("a ratio");
    assert!((ratio - 1.0).abs() < 0.06, "{mean}");
}

/// Without load the table begins with what is left; a target begins with its answer.
#[test]
fn the_table_begins_with_the_answer() {
    let mut dent = example();
    dent["mesh"] = json!({"elements_per_half_width": 6});
    dent["solver"] = json!({"theory": "flow"});
    dent["load"] = json!({"history": [{"force": 612.0}, {"force": 0}]});
    let table = shown(&dent);
    let (_, unloaded) = table.split_once("force 0 N/mm").expect("a step without load");
    let names: Vec<&str> =
        unloaded.lines().filter_map(|line| line.get(..28)).map(str::trim).collect();
    let first = names.iter().position(|name| *name == "Dent").expect("a dent");
    let expected = ["Dent", "Pile-up", "Permanent approach", "Residual tension"];
    assert_eq!(names.get(first..first + 4), Some(&expected[..]), "{table}");
    assert!(unloaded.contains("The load has left a dent of "), "{table}");
    assert!(!unloaded.contains("Hertz"), "{table}");
    assert!(
        unloaded.contains(" at x ") && table.contains("N/mm²") && !table.contains("N/mm mm"),
        "{table}"
    );
    assert!(table.contains(" ± ") && !table.contains("± 0 %"), "{table}");
    // A line for every increment of a load that is divided.
    assert!(table.contains(" inc  iter"), "{table}");
    let mut target = example();
    target["mesh"] = json!({"elements_per_half_width": 6});
    target["load"] = json!({"target": {"peak_pressure": 900.0}});
    let table = shown(&target);
    let second = table.lines().nth(1).expect("two lines");
    assert!(second.starts_with("Force found ") && second.contains(" N/mm "), "{table}");
    // The force has one error bar.
    let forces = table.lines().filter(|line| line.starts_with("Force ") && line.contains('±'));
    assert_eq!(forces.count(), 1, "{table}");
}

#[test]
fn terminals_without_unicode_get_ascii() {
    let output = Command::new(env!("CARGO_BIN_EXE_brinell"))
        .args(["solve", EXAMPLE, "--format", "table"])
        .env("LC_ALL", "C")
        .output()
        .expect("the binary runs");
    assert!(output.stdout.is_ascii(), "{}", stdout(&output));
}

#[test]
fn not_converging_has_an_exit_code_of_its_own() {
    let mut job = example();
    job["solver"]["max_iterations"] = json!(2);
    let output = brinell(&["solve", "-"], &job.to_string());
    assert_eq!(output.status.code(), Some(3), "{}", stderr(&output));
    let report: Value = serde_json::from_slice(&output.stdout).expect("the last state is printed");
    assert_eq!(report["status"], "not_converged");
}

#[test]
fn bad_input_names_the_fields() {
    let faults = [
        ("/upper/shape/radius", json!(-20.0)),
        ("/lower/material/poisson_ratio", json!(0.5)),
        ("/upper/material/plasticity/tangent_modulus", json!(210_000.0)),
        ("/load/force", json!(0.0)),
        ("/upper/shape/raduis", json!(20.0)),
        ("/upper/material/young_modulus", json!("stiff")),
        ("/mesh/elements_per_half_width", json!(1_000_000)),
    ];
    for command in ["solve", "validate"] {
        for (pointer, value) in &faults {
            let output = brinell(&[command, "-"], &spoilt(pointer, value.clone()));
            assert_eq!(output.status.code(), Some(2), "{pointer}");
            assert!(output.stdout.is_empty());
            let message = stderr(&output);
            assert!(
                message.starts_with("error: standard input is not a valid job\n"),
                "{message}"
            );
            assert!(message.contains(&format!("\n  {pointer}: ")), "{message}");
            assert_eq!(message.lines().count(), 2, "one fault, one line: {message}");
        }
    }
}

#[test]
fn all_faults_are_named_at_once() {
    let mut job = example();
    job["upper"]["shape"]["radius"] = json!(-1);
    job["lower"]["shape"]["radius"] = json!(-1);
    job["load"]["force"] = json!(0);
    let message = stderr(&brinell(&["solve", "-"], &job.to_string()));
    for pointer in ["/upper/shape/radius", "/lower/shape/radius", "/load/force"] {
        assert!(message.contains(&format!("\n  {pointer}: ")), "{message}");
    }
}

#[test]
fn faults_of_json_are_located() {
    let texts =
        [spoilt("/load/force", json!(12.5)).replace("12.5", "NaN"), "{\"upper\": {".to_owned()];
    for text in texts {
        let output = brinell(&["solve", "-"], &text);
        assert_eq!(output.status.code(), Some(2));
        let message = stderr(&output);
        assert!(message.contains("not valid JSON") && message.contains("line 1"), "{message}");
    }
}

#[test]
fn files_that_are_not_there_and_places_that_cannot_be_written() {
    let output = brinell(&["solve", "no/such/job.json"], "");
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("no/such/job.json"));
    // Before the solve, which would take minutes.
    let output = brinell(
        &["solve", EXAMPLE, "--set", "/mesh/elements_per_half_width=320", "-o", "no/such/place"],
        "",
    );
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("no/such/place"));
    assert_eq!(brinell(&["solve"], "").status.code(), Some(2));
    assert_eq!(brinell(&["dissolve"], "").status.code(), Some(2));
}

/// What was there stays until there is an answer.
#[test]
fn a_solve_that_fails_leaves_files_alone() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("kept.json");
    let name = path.to_str().unwrap();
    let solve = || brinell(&["solve", EXAMPLE, "--format", "vtr", "-o", name], "");
    let _ = std::fs::remove_file(&path);
    assert_eq!(solve().status.code(), Some(2));
    assert!(!path.exists());
    std::fs::write(&path, "kept").unwrap();
    assert_eq!(solve().status.code(), Some(2));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "kept");
    let output = brinell(&["validate", EXAMPLE, "--format", "json"], "");
    assert_eq!(output.status.code(), Some(0));
    let output = brinell(&["solve", EXAMPLE, "--format", "summary-csv", "-o", name], "");
    assert_eq!(output.status.code(), Some(0));
    assert!(std::fs::read_to_string(&path).unwrap().starts_with("step,status,"));
}

#[test]
fn a_file_has_the_form_of_its_name_and_is_not_the_job() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let (job, drawn) = (folder.join("named.json"), folder.join("named.svg"));
    std::fs::copy(EXAMPLE, &job).unwrap();
    let solve = |output: &Path| {
        brinell(&["solve", job.to_str().unwrap(), "-o", output.to_str().unwrap()], "")
    };
    assert_eq!(solve(&drawn).status.code(), Some(0));
    assert!(std::fs::read_to_string(&drawn).unwrap().starts_with("<svg "));
    let output = solve(&folder.join("../tmp/named.json"));
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).ends_with("named.json: the job is there\n"), "{}", stderr(&output));
    assert_eq!(std::fs::read(&job).unwrap(), std::fs::read(EXAMPLE).unwrap());
}

#[test]
fn mistakes_of_newcomers_get_a_sentence() {
    const FOLDER: &str = env!("CARGO_TARGET_TMPDIR");
    let table = Path::new(FOLDER).join("mistaken.csv");
    std::fs::write(&table, "x,height\n0,1\n1,2\n").unwrap();
    let table = table.to_str().unwrap();
    for (args, told) in [
        (&["solve", table][..], "expected a value"),
        (&["solve", EXAMPLE, "--step", "0"], "--step cannot be \"0\": must be at least 1"),
        (
            &["solve", EXAMPLE, "--step", "last"],
            "--step cannot be \"last\": must be a whole number",
        ),
        (&["solve", EXAMPLE, "--format", "CSV"], "must be one of: json, table, summary-csv"),
        (&["solve", EXAMPLE, "--out", "results"], "cannot be used with"),
        (&["solve", EXAMPLE, "--part", "1/2"], "cannot be used with"),
        (&["serve", "--workers", "0"], "must be at least 1"),
        (&["worker"], "--database-url"),
    ] {
        let output = brinell(args, "");
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        let said = stderr(&output);
        assert!(said.lines().next().is_some_and(|line| line.contains(told)), "{args:?}: {said}");
        assert_eq!(said.matches("error: ").count(), 1, "{said}");
    }
}

#[test]
fn members_of_a_job_are_set() {
    let equations = |args: &[&str]| {
        let output = brinell(&[&["validate", EXAMPLE], args].concat(), "");
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        serde_json::from_slice::<Value>(&output.stdout).unwrap()["estimate"]["equations"].as_u64()
    };
    let fine = ["--set", "/mesh/elements_per_half_width=40", "--set", "/title=fine"];
    assert!(equations(&fine) > equations(&[]));
    for (setting, told) in [
        ("/load/force=-1", "/load/force: must be"),
        ("/upper/shape/radius/x=1", "--set /upper/shape/radius/x: the job has no such place"),
        ("load=1", "JSON pointer"),
        ("/load", "JSON pointer"),
    ] {
        let output = brinell(&["validate", EXAMPLE, "--set", setting], "");
        assert_eq!(output.status.code(), Some(2));
        assert!(stderr(&output).contains(told), "{}", stderr(&output));
    }
}

#[test]
fn a_long_sweep_has_a_line_for_each_load() {
    let forces = "/load={\"forces\": [100, 200, 300, 400, 500, 600, 700, 800]}";
    let coarse = ["--set", "/mesh/elements_per_half_width=6", "--set", forces];
    let table = |more: &[&str]| {
        let output =
            brinell(&[&["solve", EXAMPLE, "--format", "table"], &coarse[..], more].concat(), "");
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        stdout(&output)
    };
    let short = table(&[]);
    assert!(short.lines().all(|line| line.chars().count() <= 80), "{short}");
    assert!(short.lines().count() < 40, "{short}");
    for force in 1..=8 {
        let row = short.lines().find(|line| line.starts_with(&format!("   {force} ")));
        assert!(row.is_some_and(|row| row.contains(&format!("{force}00.00"))), "{short}");
    }
    let third = table(&["--step", "3"]);
    assert!(third.contains("force 300.0000 N/mm") && !third.contains("force 400"), "{third}");
    let output = brinell(&["solve", EXAMPLE, "--format", "table", "--step", "2"], "");
    assert_eq!(
        (output.status.code(), stderr(&output).as_str()),
        (Some(2), "error: there is no step 2\n")
    );
}

#[test]
fn examples_are_printed_and_can_be_solved() {
    let names = stdout(&brinell(&["example"], ""));
    assert!(names.lines().count() > 10 && names.lines().any(|name| name == "two_cylinders"));
    let job = brinell(&["example", "ball_in_raceway"], "");
    assert_eq!(brinell(&["validate", "-"], &stdout(&job)).status.code(), Some(0));
    let output = brinell(&["example", "two_cylinder"], "");
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("two_cylinders"), "{}", stderr(&output));
}

#[test]
fn shells_complete_commands_and_options() {
    for shell in ["bash", "zsh", "fish"] {
        let script = stdout(&brinell(&["completions", shell], ""));
        assert!(script.contains("validate") && script.contains("factor-cache"), "{shell}");
    }
}

#[test]
fn every_command_has_a_manual_page() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("manual");
    let output = brinell(&["man", folder.to_str().unwrap()], "");
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let page = std::fs::read_to_string(folder.join("brinell-solve.1")).unwrap();
    assert!(page.contains(".SH OPTIONS") && page.contains("depth\\-svg"), "{page}");
    assert!(folder.join("brinell-key-create.1").exists());
}

#[test]
fn keys_are_not_looked_for_where_there_is_no_database() {
    let nowhere = Path::new(env!("CARGO_TARGET_TMPDIR")).join("no_database_here");
    let id = "0197e1f0-0000-7000-8000-000000000000";
    for args in [&["list"][..], &["revoke", id], &["rotate", id], &["limit", id]] {
        let place = ["--data-dir", nowhere.to_str().unwrap()];
        let output = brinell(&[&["key"], args, &place].concat(), "");
        assert_eq!(output.status.code(), Some(1));
        assert!(stderr(&output).contains("there is no database in"), "{}", stderr(&output));
        assert!(!nowhere.exists());
    }
}

#[test]
fn validate_estimates() {
    let output = brinell(&["validate", EXAMPLE], "");
    assert_eq!(output.status.code(), Some(0));
    let verdict: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(verdict["valid"], true);
    assert!(verdict["estimate"]["equations"].as_u64().is_some_and(|count| count > 1000));
    let shown = stdout(&brinell(&["validate", EXAMPLE, "--format", "table"], ""));
    assert!(shown.contains("is valid") && shown.contains("equations"), "{shown}");
}

#[test]
fn the_demonstration_goes_the_whole_way_and_ends_without_a_terminal() {
    let output = brinell(&["demo"], "");
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let shown = stdout(&output);
    for expected in
        ["POST http://127.0.0.1:", "202 /v1/jobs/", "200 succeeded", "Peak pressure", "residual"]
    {
        assert!(shown.contains(expected), "{expected:?} is missing:\n{shown}");
    }
    assert!(!stderr(&output).contains("INFO"), "{}", stderr(&output));
}

#[test]
fn an_address_that_cannot_be_is_bad_input() {
    let output = brinell(&["serve", "--data-dir", ":memory:", "--listen", "127.0.0.1:99999"], "");
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("--listen"), "{}", stderr(&output));
}

#[test]
fn an_address_in_use_is_told() {
    let taken = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let address = taken.local_addr().unwrap().to_string();
    let output = brinell(&["serve", "--listen", &address], "");
    assert_eq!(output.status.code(), Some(1));
    assert!(
        stderr(&output).contains(&format!("cannot listen on {address}")),
        "{}",
        stderr(&output)
    );
}

/// Runs the program with these variables.
fn with_variables(args: &[&str], variables: &[(&str, &str)]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_brinell"))
        .args(args)
        .envs(variables.iter().copied())
        .stdin(Stdio::null())
        .output()
        .expect("the binary starts")
}

#[test]
fn settings_are_shown_without_secrets() {
    let variables = [
        ("BRINELL_DATABASE_URL", "postgres://user:hunter2@host/jobs?password=hunter2"),
        ("BRINELL_WEBHOOK_SECRETS", "whsec_MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSwMfKQ9r8GKYo="),
        ("BRINELL_GRACE", "7"),
    ];
    let output =
        with_variables(&["serve", "--print-config", "--listen", "127.0.0.1:9"], &variables);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let text = stdout(&output);
    for lines in [
        "# --listen: set by the flag\nBRINELL_LISTEN=127.0.0.1:9\n",
        "# --grace: set by the variable\nBRINELL_GRACE=7\n",
        "# --database-url: set by the variable\nBRINELL_DATABASE_URL=postgres://***@host/jobs\n",
        "# --queue-capacity: the default\nBRINELL_QUEUE_CAPACITY=10000\n",
        "# --workers: not set\n# BRINELL_WORKERS=\n",
        "# --require-api-key: the default\nBRINELL_REQUIRE_API_KEY=false\n",
    ] {
        assert!(text.contains(lines), "{lines}\nis not in\n{text}");
    }
    assert!(!text.contains("hunter2") && !text.contains("whsec_"), "{text}");
    let help = stdout(&with_variables(&["serve", "--help"], &[]));
    for variable in help.split("[env: ").skip(1).filter_map(|rest| rest.split(['=', ']']).next()) {
        assert!(text.contains(&format!("{variable}=")), "{variable} is not shown");
    }
}

#[test]
fn wrong_settings_are_named_in_one_line() {
    for (args, variables, expected) in [
        (
            &["serve", "--workers", "none"][..],
            &[][..],
            &["--workers", "BRINELL_WORKERS", "none"][..],
        ),
        (
            &["serve"],
            &[("BRINELL_GRACE", "soon")],
            &["--grace", "BRINELL_GRACE", "must be a number of seconds"],
        ),
        (&["serve"], &[("BRINELL_MAX_BODY", "-1")], &["--max-body", "BRINELL_MAX_BODY", "-1"]),
        (&["serve"], &[("BRINELL_LOG", "a=b=c")], &["--log", "BRINELL_LOG"]),
        (
            &["serve"],
            &[("BRINELL_LOG_FORMAT", "xml")],
            &["--log-format", "BRINELL_LOG_FORMAT", "text, json"],
        ),
        (
            &["worker"],
            &[("BRINELL_DATABASE_URL", "mysql://u:secret@h")],
            &["--database-url", "BRINELL_DATABASE_URL", "postgres://"],
        ),
        (&["serve"], &[("BRINELL_LISTEN", "nowhere")], &["--listen", "BRINELL_LISTEN", "nowhere"]),
        (
            &["serve", "--listen", "127.0.0.1:0"],
            &[("BRINELL_METRICS_LISTEN", "nowhere")],
            &["--metrics-listen", "BRINELL_METRICS_LISTEN"],
        ),
        (&["serve", "--no-workers"], &[], &["--database-url", "BRINELL_DATABASE_URL"]),
        (
            &["serve", "--once-key-env", "SHORT_KEY"],
            &[("SHORT_KEY", "0123456789")],
            &["SHORT_KEY", "32 characters", "--once-key-env", "BRINELL_ONCE_KEY_ENV"],
        ),
    ] {
        let quiet = [variables, &[("BRINELL_DATA_DIR", env!("CARGO_TARGET_TMPDIR"))]].concat();
        let quiet = if variables.iter().any(|(name, _)| *name == "BRINELL_LOG") {
            quiet
        } else {
            [&quiet[..], &[("BRINELL_LOG", "off")]].concat()
        };
        let output = with_variables(args, &quiet);
        let text = stderr(&output);
        assert!(!output.status.success());
        assert_eq!(text.lines().count(), 1, "{args:?} {variables:?}: {text}");
        for word in expected {
            assert!(text.contains(word), "{word} is not in {text}");
        }
        assert!(!text.contains("secret"), "{text}");
    }
}

#[test]
fn a_service_that_is_not_there_is_not_well() {
    let free =
        std::net::TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().to_string();
    let output = with_variables(&["healthcheck"], &[("BRINELL_LISTEN", &free)]);
    assert_eq!(output.status.code(), Some(1));
    let told = stderr(&output);
    assert!(
        told.starts_with("error: /readyz of 127.0.0.1:") && told.contains("refused"),
        "{told}"
    );
    assert!(!told.contains("demonstration"), "{told}");
    assert_eq!(
        with_variables(&["healthcheck", "--listen", "nowhere"], &[]).status.code(),
        Some(1)
    );
}

#[test]
fn the_tasks_of_an_array_solve_each_job_once() {
    let folder = std::env::temp_dir().join(format!("brinell-array-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let jobs = folder.join("jobs.jsonl");
    let line = |force: f64| {
        let mut job = example();
        job["mesh"] = json!({ "elements_per_half_width": 4 });
        job["output"] = json!({ "fields": force > 400.0 });
        job["load"] = json!({ "force": force });
        job.to_string()
    };
    let good: Vec<String> = (1..=5).map(|k| line(100.0 * f64::from(k))).collect();
    std::fs::write(&jobs, good.join("\n")).unwrap();
    let out = folder.join("results");
    let [jobs, out] = [&jobs, &out].map(|path| path.to_str().unwrap());
    let task = |id: &str| {
        let slurm = [("ID", id), ("MIN", "10"), ("STEP", "5"), ("COUNT", "2")];
        let output = Command::new(env!("CARGO_BIN_EXE_brinell"))
            .args(["solve", "--array", jobs, "--out", out])
            .envs(slurm.map(|(name, value)| (format!("SLURM_ARRAY_TASK_{name}"), value)))
            .output()
            .unwrap();
        (output.status.code(), stderr(&output))
    };
    let kept = || {
        let files = std::fs::read_dir(out).unwrap().map(|file| file.unwrap());
        let times =
            files.map(|file| (file.file_name(), file.metadata().unwrap().modified().unwrap()));
        times.collect::<std::collections::BTreeMap<_, _>>()
    };
    assert_eq!(task("10"), (Some(0), String::new()));
    assert_eq!(kept().len(), 4, "lines 1, 3 and 5, the last with fields");
    assert_eq!(task("15"), (Some(0), String::new()));
    assert_eq!(kept().len(), 6);
    // A machine without power may leave half a file.
    let half = kept().into_keys().find(|name| name.to_string_lossy().ends_with("jsonl")).unwrap();
    let half = Path::new(out).join(half);
    let whole = std::fs::read(&half).unwrap();
    std::fs::write(&half, &whole[..whole.len() - 2]).unwrap();
    // What cannot be written ends the task, and leaves nothing behind.
    std::fs::remove_file(&half).unwrap();
    std::fs::create_dir(&half).unwrap();
    let before = kept();
    let ends: Vec<_> =
        [task("10"), task("15")].into_iter().filter(|end| end.0 != Some(0)).collect();
    let [(Some(1), said)] = &ends[..] else { panic!("{ends:?}") };
    assert!(said.starts_with("error: cannot write ") && said.lines().count() == 1, "{said}");
    assert_eq!(kept().into_keys().collect::<Vec<_>>(), before.into_keys().collect::<Vec<_>>());
    std::fs::remove_dir(&half).unwrap();
    assert_eq!([task("10"), task("15")].map(|(code, _)| code), [Some(0); 2]);
    assert!(std::fs::read(&half).unwrap().ends_with(b"}\n"));
    let all = kept();
    // Again, with a line that is no job, and a byte order mark: what is there stays.
    let text = [b"{}\n\xff\n\xef\xbb\xbf", good.join("\n").as_bytes()].concat();
    std::fs::write(jobs, text).unwrap();
    let output = brinell(&["solve", "--array", jobs, "--out", out], "");
    assert_eq!(output.status.code(), Some(2));
    let told = stderr(&output);
    assert!(told.contains("jobs.jsonl line 1 is not a valid job"), "{told}");
    assert!(told.contains("jobs.jsonl line 2 is not valid JSON"), "{told}");
    let output = brinell(&["solve", "--array", jobs, "--out", out, "--set", "/load/force=7"], "");
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("cannot be used with"), "{}", stderr(&output));
    assert_eq!(kept(), all);
    let of = |force: f64| {
        let output = brinell(&["solve", "-"], &line(force));
        let report: Value = serde_json::from_slice(&output.stdout).unwrap();
        report["steps"][0]["contact"].clone()
    };
    let solved: Vec<Value> = all
        .keys()
        .filter(|name| Path::new(name).extension().is_some_and(|one| one == "jsonl"))
        .map(|name| {
            let text = std::fs::read_to_string(Path::new(out).join(name)).unwrap();
            let lines: Vec<Value> =
                text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
            let [summary, job, report] = &lines[..] else { panic!("three lines") };
            assert_eq!(summary["steps"][0]["answers"], report["steps"][0]["answers"]);
            assert_eq!(summary["steps"][0]["history"], json!([]));
            assert!(report["steps"][0].get("fields").is_none());
            assert!(good.contains(&job.to_string()));
            report["steps"][0]["contact"].clone()
        })
        .collect();
    assert!((1..=4).all(|k| solved.contains(&of(100.0 * f64::from(k)))));
    // A gap in the numbers of the tasks would leave jobs out.
    let (code, said) = task("12");
    assert_eq!(code, Some(2));
    assert!(said.contains("SLURM_ARRAY_TASK_ID"), "{said}");
    std::fs::remove_dir_all(folder).unwrap();
}
