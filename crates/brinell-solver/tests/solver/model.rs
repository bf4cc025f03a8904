//! The wire format from outside: what is accepted, and what exactly is said about what is not.

use brinell_solver::job::{
    Bilinear, Block, Cylinder, FarSupport, Hardening, Job, JobError, Load, Material, Shape, Units,
};
use insta::assert_snapshot;
use proptest::prelude::*;
use serde_json::{Value, json};

const TWO_CYLINDERS: &str = include_str!("../../../../api/examples/two_cylinders.json");
const CYLINDER_ON_BLOCK: &str = include_str!("../../../../api/examples/cylinder_on_block.json");
const RAMBERG_OSGOOD: &str = include_str!("../../../../api/examples/ramberg_osgood.json");

fn example() -> Value {
    serde_json::from_str(TWO_CYLINDERS).unwrap()
}

/// The example with one member replaced.
fn with(pointer: &str, value: Value) -> Value {
    let mut job = example();
    *job.pointer_mut(pointer).unwrap() = value;
    job
}

/// All faults, one a line.
fn faults(text: impl AsRef<[u8]>) -> String {
    match Job::from_json(text.as_ref()) {
        Ok(_) => "none".to_owned(),
        Err(JobError::Fields(faults)) => {
            faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
        }
        Err(syntax @ JobError::Syntax { .. }) => syntax.to_string(),
    }
}

fn faults_of(job: &Value) -> String {
    faults(job.to_string())
}

mod accepted {
    use super::*;

    #[test]
    fn names_of_job_and_materials() {
        let mut job = example();
        job["title"] = json!("Rolling mill, stand 4");
        job["upper"]["material"]["name"] = json!("100Cr6, 60 HRC");
        job["lower"]["material"] = json!({"name": "diamond", "rigid": true});
        let read = Job::from_value(&job).unwrap();
        assert_eq!(read.title.as_deref(), Some("Rolling mill, stand 4"));
        assert_eq!(read.upper.material_name.as_deref(), Some("100Cr6, 60 HRC"));
        let written = serde_json::to_value(&read).unwrap();
        assert_eq!(written["title"], job["title"]);
        assert_eq!(written["upper"]["material"]["name"], job["upper"]["material"]["name"]);
        assert_eq!(written["lower"]["material"], job["lower"]["material"]);
    }

    #[test]
    fn the_papers_problem() {
        let job = Job::from_json(TWO_CYLINDERS.as_bytes()).unwrap();
        assert_eq!(job.units, Units::MmNMpa);
        assert_eq!(job.upper, job.lower);
        let Shape::Cylinder(Cylinder { radius }) = job.upper.shape else {
            panic!("{:?}", job.upper.shape)
        };
        assert!((radius.get() - 20.0).abs() < f64::EPSILON);
        let Material::Deformable(steel) = &job.upper.material else { panic!("rigid") };
        assert!(matches!(steel.plasticity, Some(Hardening::Bilinear(Bilinear { .. }))));
        let Load::Forces(forces) = &job.load else { panic!("no force") };
        assert_eq!(forces.iter().map(|force| force.get()).collect::<Vec<_>>(), [612.6106]);
        assert_eq!(job.mesh.elements_per_half_width, 20);
    }

    #[test]
    fn the_other_examples() {
        let job = Job::from_json(CYLINDER_ON_BLOCK.as_bytes()).unwrap();
        assert!(matches!(job.lower.shape, Shape::Block(Block { .. })));
        let job = Job::from_json(RAMBERG_OSGOOD.as_bytes()).unwrap();
        assert_eq!(job.lower.support, FarSupport::Roller);
    }

    #[test]
    fn the_least_that_can_be_said() {
        let body = json!({
            "shape": {"type": "cylinder", "radius": 20},
            "material": {"young_modulus": 210_000, "poisson_ratio": 0.3}
        });
        let least = json!({"analysis": "plane_strain", "upper": body, "lower": body,
            "load": {"force": 100}});
        let job = Job::from_value(&least).unwrap();
        let mut written = serde_json::to_value(&job).unwrap();
        assert_eq!(written["mesh"], json!({"elements_per_half_width": 20}));
        assert_eq!(
            written["solver"],
            json!({"method": "standard", "theory": "flow", "coupling": "accelerated", "contact": "active_set",
                "tolerance": 1e-6,
                "max_iterations": 500})
        );
        assert_eq!(
            written["output"],
            json!({"subsurface": true, "fields": false, "contact_stiffness": false})
        );
        assert_eq!(written["upper"]["support"], "clamped");
        assert_eq!(written["units"].take(), "mm_N_MPa");
        assert_eq!(written.get("tags"), None);
    }

    #[test]
    fn every_example_is_written_as_it_was_read() {
        for text in [TWO_CYLINDERS, CYLINDER_ON_BLOCK, RAMBERG_OSGOOD] {
            let job = Job::from_json(text.as_bytes()).unwrap();
            let mut read: Value = serde_json::from_str(text).unwrap();
            // The examples leave these to their defaults, which are written.
            read["solver"]["method"] = json!("standard");
            read["solver"]["theory"] = json!("flow");
            read["output"]["contact_stiffness"] = json!(false);
            assert_eq!(serde_json::to_value(&job).unwrap(), read);
            assert_eq!(job.validate(), Ok(()));
        }
    }

    #[test]
    fn si_is_the_same_job() {
        let mut si = with("/units", json!("SI"));
        for side in ["upper", "lower"] {
            si[side]["shape"]["radius"] = json!(0.02);
            si[side]["material"]["young_modulus"] = json!(210e9);
            si[side]["material"]["plasticity"]["yield_stress"] = json!(500e6);
            si[side]["material"]["plasticity"]["tangent_modulus"] = json!(10.5e9);
        }
        si["load"]["force"] = json!(612_610.6);
        let read = Job::from_value(&si).unwrap();
        let plain = Job::from_json(TWO_CYLINDERS.as_bytes()).unwrap();
        assert_eq!(Job { units: Units::MmNMpa, ..read.clone() }, plain);
        si["solver"]["method"] = json!("standard");
        si["solver"]["theory"] = json!("flow");
        si["output"]["contact_stiffness"] = json!(false);
        assert_eq!(serde_json::to_value(&read).unwrap(), si);
    }

    #[test]
    fn perfect_plasticity_a_rigid_body_and_a_sweep_of_one() {
        assert_eq!(
            faults_of(&with("/upper/material/plasticity/tangent_modulus", json!(0))),
            "none"
        );
        assert_eq!(faults_of(&with("/upper/material", json!({"rigid": true}))), "none");
        assert_eq!(faults_of(&with("/load", json!({"forces": [100.0]}))), "none");
        assert_eq!(faults_of(&with("/mesh", json!({"elements_per_half_width": 8.0}))), "none");
    }
}

mod refused {
    use super::*;

    #[test]
    fn text_that_is_not_json() {
        assert_snapshot!(faults(TWO_CYLINDERS.replace("612.6106", "NaN")), @r#"not valid JSON: "NaN" is not a JSON number; only finite numbers can be written (line 22, column 22)"#);
        assert_snapshot!(faults(TWO_CYLINDERS.replace("612.6106", "-Infinity")), @r#"not valid JSON: "-Infinity" is not a JSON number; only finite numbers can be written (line 22, column 23)"#);
        assert_snapshot!(faults(TWO_CYLINDERS.replace("612.6106", "1e999")), @"not valid JSON: a number is too large; magnitudes end at 1.8e308 (line 22, column 26)");
        assert_snapshot!(faults(&TWO_CYLINDERS[..300]), @"not valid JSON: the text ends too early (EOF while parsing a string) (line 10, column 74)");
        assert_snapshot!(faults(""), @"not valid JSON: the document is empty (line 1, column 1)");
        assert_snapshot!(faults(b"\xff\xfe{\0"), @"not valid JSON: the text is not UTF-8 (line 1, \
                                                   column 1)");
        assert_snapshot!(faults("[".repeat(100_000)), @"not valid JSON: values are nested too \
                                                        deeply (line 1, column 128)");
        assert_snapshot!(faults("{\"a\":".repeat(100_000)), @"not valid JSON: values are nested too deeply (line 1, column 636)");
    }

    #[test]
    fn json_that_is_no_object() {
        assert_snapshot!(faults("[]"), @"(job): must be an object, got an array");
        assert_snapshot!(faults("null"), @"(job): must be an object, got null");
        assert_snapshot!(faults("{}"), @r"
        /analysis: is required
        /upper: is required
        /lower: is required
        /load: is required
        ");
    }

    #[test]
    fn figures_out_of_range() {
        assert_snapshot!(faults_of(&with("/upper/shape/radius", json!(-20.0))), @"/upper/shape/radius: must be greater than 0, got -20");
        assert_snapshot!(faults_of(&with("/upper/shape/radius", json!(1e300))), @"/upper/shape/radius: must be between 1e-6 and 1000000 mm (units mm_N_MPa), got 1e300");
        assert_snapshot!(faults_of(&with("/lower/material/poisson_ratio", json!(0.5))), @"/lower/material/poisson_ratio: must be between 0 and 0.499999, got 0.5");
        assert_snapshot!(faults_of(&with("/lower/material/young_modulus", json!(210e9))), @"/lower/material/young_modulus: must be between 0.001 and 1e8 MPa (units mm_N_MPa), got 2.1e11");
        assert_snapshot!(faults_of(&with("/lower/material/plasticity/tangent_modulus", json!(210_000))), @"/lower/material/plasticity/tangent_modulus: must be less than `young_modulus`, got 210000");
        assert_snapshot!(faults_of(&with("/lower/material/plasticity/tangent_modulus", json!(-1))), @"/lower/material/plasticity/tangent_modulus: must be at least 0, got -1");
        assert_snapshot!(faults_of(&with("/load/force", json!(0))), @"/load/force: must be greater than 0, got 0");
        assert_snapshot!(faults_of(&with("/mesh/elements_per_half_width", json!(1_000_000))), @"/mesh/elements_per_half_width: must be a whole number between 4 and 320, got 1000000");
        assert_snapshot!(faults_of(&with("/mesh/elements_per_half_width", json!(20.5))), @"/mesh/elements_per_half_width: must be a whole number between 4 and 320, got 20.5");
        assert_snapshot!(faults_of(&with("/solver/tolerance", json!(0.5))), @"/solver/tolerance: must be between 1e-12 and 0.1, got 0.5");
        assert_snapshot!(faults_of(&with("/solver/max_iterations", json!(0))), @"/solver/max_iterations: must be a whole number between 1 and 100000, got 0");
    }

    #[test]
    fn figures_in_si_are_answered_in_si() {
        let mut job = with("/units", json!("SI"));
        job["load"]["force"] = json!(1e300);
        let all = faults_of(&job);
        let load = all.lines().find(|line| line.starts_with("/load")).unwrap();
        assert_snapshot!(load, @"/load/force: must be between 1e-6 and 1e12 N/m (units SI), got \
                                 1e300");
    }

    #[test]
    fn unknown_units_do_not_cause_further_faults() {
        let mut job = with("/units", json!("si"));
        job["upper"]["material"]["young_modulus"] = json!(210e9);
        assert_snapshot!(faults_of(&job), @r#"/units: must be one of: mm_N_MPa, SI, got "si"; did you mean `SI`?"#);
    }

    #[test]
    fn wrong_types() {
        assert_snapshot!(faults_of(&with("/upper/shape/radius", json!("20"))), @"/upper/shape/radius: must be a number, got a string");
        assert_snapshot!(faults_of(&with("/upper/material/young_modulus", json!([210_000, 300_000]))), @"/upper/material/young_modulus: must be a number, got an array; layers of other moduli are not solved; strength over depth is `over_depth` of a law");
        assert_snapshot!(faults_of(&with("/upper/shape", json!(null))), @"/upper/shape: must be an object, got null");
        assert_snapshot!(faults_of(&with("/solver", json!([]))), @"/solver: must be an object, got an array");
        assert_snapshot!(faults_of(&with("/output/fields", json!(1))), @"/output/fields: must be true or false, got a number");
        assert_snapshot!(faults_of(&with("/analysis", json!("plane-strain"))), @r#"/analysis: must be one of: plane_strain, plane_stress, axisymmetric, three_dimensional, got "plane-strain"; did you mean `plane_strain`?"#);
        assert_snapshot!(faults_of(&with("/solver/coupling", json!("fast"))), @r#"/solver/coupling: must be one of: accelerated, strong, weak, secant_stiffness, got "fast""#);
    }

    #[test]
    fn unknown_keys_at_every_level() {
        let misspelt = json!({"type": "cylinder", "raduis": 20.0});
        assert_snapshot!(faults_of(&with("/upper/shape", misspelt)), @r#"
        /upper/shape/raduis: unknown key "raduis"; expected one of: type, radius; did you mean `radius`?
        /upper/shape/radius: is required
        "#);
        for place in [
            "",
            "/upper",
            "/upper/shape",
            "/upper/material",
            "/upper/material/plasticity",
            "/load",
            "/mesh",
            "/solver",
            "/output",
        ] {
            let mut job = example();
            job.pointer_mut(place).unwrap()["co/lour"] = json!("red");
            let found = faults_of(&job);
            let expected = format!("{place}/co~1lour: unknown key \"co/lour\"; expected one of: ");
            assert!(found.starts_with(&expected) && found.lines().count() == 1, "{found}");
        }
    }

    #[test]
    fn duplicate_keys() {
        let doubled =
            TWO_CYLINDERS.replacen("\"radius\": 20.0", "\"radius\": 20.0, \"radius\": 30.0", 1);
        assert_snapshot!(faults(doubled), @r#"/upper/shape/radius: the key "radius" is given more than once"#);
    }

    #[test]
    fn two_rigid_bodies() {
        let mut job = with("/upper/material", json!({"rigid": true}));
        job["lower"] = json!({"shape": {"type": "cylinder"}, "material": {"rigid": true}});
        assert_snapshot!(faults_of(&job), @r"
        /lower/material: both bodies are rigid; one of them must deform
        /lower/shape/radius: is required
        /upper/material: both bodies are rigid; one of them must deform
        ");
        assert_snapshot!(faults_of(&with("/upper/material", json!({"rigid": false}))), @"/upper/material/rigid: must be true, or left out for a body that deforms");
        let both = json!({"rigid": true, "young_modulus": 1});
        assert_snapshot!(faults_of(&with("/upper/material", both)), @r#"/upper/material/young_modulus: unknown key "young_modulus"; expected one of: name, rigid"#);
    }

    #[test]
    fn loads() {
        assert_snapshot!(faults_of(&with("/load", json!({}))), @"/load: must have one of: force, forces, approach, approaches, history, onset, target, rolling, hardness");
        assert_snapshot!(faults_of(&with("/load", json!({"force": 1, "approach": 0}))), @r"
        /load: must have only one of: force, forces, approach, approaches, history, onset, target, rolling, hardness
        /load/approach: must be greater than 0, got 0
        ");
        assert_snapshot!(faults_of(&with("/load", json!({"forces": []}))), @"/load/forces: must have between 1 and 1000 items, got 0");
    }

    #[test]
    fn targets() {
        let target = |target: Value| faults_of(&with("/load", json!({"target": target})));
        assert_snapshot!(target(json!({})), @"/load/target: must have one of: permanent_approach, \
                                              dent_depth, peak_pressure, mean_pressure, \
                                              half_width, max_plastic_strain");
        assert_snapshot!(target(json!({"peak_pressure": 1200, "half_width": -1})), @r"
        /load/target: must have only one of: permanent_approach, dent_depth, peak_pressure, mean_pressure, half_width, max_plastic_strain
        /load/target/half_width: must be greater than 0, got -1
        ");
        assert_snapshot!(target(json!({"peak_presure": 1200})), @r#"
        /load/target: must have one of: permanent_approach, dent_depth, peak_pressure, mean_pressure, half_width, max_plastic_strain
        /load/target/peak_presure: unknown key "peak_presure"; expected one of: permanent_approach, dent_depth, peak_pressure, mean_pressure, half_width, max_plastic_strain; did you mean `peak_pressure`?
        "#);
        assert_snapshot!(target(json!({"max_plastic_strain": 2})), @"/load/target/max_plastic_strain: must be between 1e-9 and 1, got 2");
        let mut dent = with("/load", json!({"target": {"dent_depth": 0.001}}));
        dent["solver"]["theory"] = json!("deformation");
        assert_snapshot!(faults_of(&dent), @"/load/target/dent_depth: deformation theory knows no unloading, so nothing is left of a contact; it needs the theory `flow`");
        let mut elastic = with("/load", json!({"target": {"max_plastic_strain": 0.01}}));
        for side in ["upper", "lower"] {
            elastic[side]["material"].as_object_mut().unwrap().remove("plasticity");
        }
        assert_snapshot!(faults_of(&elastic), @"/load/target/max_plastic_strain: neither body has \
                                                a hardening law, so nothing yields under any \
                                                force");
        assert_snapshot!(faults_of(&with("/load", json!({"forces": [1, -1, "2"]}))), @r"
        /load/forces/1: must be greater than 0, got -1
        /load/forces/2: must be a number, got a string
        ");
        assert_snapshot!(faults_of(&with("/load", json!({"forces": vec![1; 1001]}))), @"/load/forces: must have between 1 and 1000 items, got 1001");
    }

    #[test]
    fn shapes_and_curves_at_odds_with_themselves() {
        let groove = json!({"type": "groove", "radius": 10, "width": 21, "depth": -1});
        assert_snapshot!(faults_of(&with("/lower/shape", groove)), @r"
        /lower/shape/depth: must be greater than 0, got -1
        /lower/shape/width: must be at most twice `radius`, got 21
        ");
        let profile = json!({"type": "profile", "points": [[1, 0], [0.5, -9], [2]], "depth": 5});
        assert_snapshot!(faults_of(&with("/lower/shape", profile)), @"/lower/shape/points/2: must be an array of 2 numbers, got an array of 1");
        let profile = json!({"type": "profile", "points": [[1, 0], [0.5, -9]], "depth": 5});
        assert_snapshot!(faults_of(&with("/lower/shape", profile)), @r"
        /lower/shape/points: must reach from x <= 0 to x >= 0, because the contact starts at x = 0
        /lower/shape/points/1/0: must be greater than the x of the point before, got 0.5
        /lower/shape/points/1/1: must be above the base, which lies at -`depth`, got -9
        ");
        let curve = "/lower/material/plasticity";
        let table = json!({"law": "table", "points": [[0.1, 250], [0.1, 240]]});
        assert_snapshot!(faults_of(&with(curve, table)), @r"
        /lower/material/plasticity/points/0/0: must be 0: the first point of the curve is where yielding starts, got 0.1
        /lower/material/plasticity/points/1/0: must be greater than the plastic strain of the point before, got 0.1
        /lower/material/plasticity/points/1/1: must be at least the stress of the point before: softening is not covered, got 240
        ");
        let voce = json!({"law": "voce", "yield_stress": 300, "saturation_stress": 299});
        assert_snapshot!(faults_of(&with(curve, voce)), @r"
        /lower/material/plasticity/saturation_stress: must be at least `yield_stress`, got 299
        /lower/material/plasticity/rate: is required
        ");
        let power = json!({"law": "ramberg_osgood", "reference_stress": 500, "offset": 0,
            "exponent": 0.5});
        assert_snapshot!(faults_of(&with(curve, power)), @r"
        /lower/material/plasticity/exponent: must be between 1 and 200, got 0.5
        /lower/material/plasticity/offset: must be between 1e-9 and 1000000, got 0
        ");
        let swift =
            json!({"law": "swift", "yield_stress": 500, "strain_offset": 0.01, "exponent": 1.5});
        assert_snapshot!(faults_of(&with(curve, swift)), @"/lower/material/plasticity/exponent: must be between 0.001 and 1, got 1.5");
    }

    #[test]
    fn tags() {
        let mut job = example();
        job["tags"] = json!({"": "empty", "long": "x".repeat(257), "number": 7, "bell": "\u{7}"});
        assert_snapshot!(faults_of(&job), @r"
        /tags/: the key must have between 1 and 64 characters, got 0
        /tags/bell: the value must not contain control characters
        /tags/long: the value must have between 0 and 256 characters, got 257
        /tags/number: must be a string, got a number
        ");
        job["tags"] = (0..33).map(|index| (format!("key{index}"), json!("value"))).collect();
        assert_snapshot!(faults_of(&job), @"/tags: must have at most 32 tags, got 33");
    }

    #[test]
    fn names_that_are_none() {
        let mut job = example();
        job["title"] = json!("x".repeat(81));
        job["upper"]["material"]["name"] = json!("");
        job["lower"]["material"] = json!({"name": "a\u{7}b", "rigid": true});
        assert_snapshot!(faults_of(&job), @r"
        /lower/material/name: the name must not contain control characters
        /title: the name must have between 1 and 80 characters, got 81
        /upper/material/name: the name must have between 1 and 80 characters, got 0
        ");
    }

    #[test]
    fn several_faults_at_once_in_document_order() {
        let text = r#"{
            "load": {"force": 0},
            "lower": {
                "material": {"poisson_ratio": 0.5, "young_modulus": 1000,
                             "plasticity": {"law": "bilinear", "tangent_modulus": 1000}},
                "shape": {"radius": "big", "type": "cylinder", "colour": "red"}
            },
            "mesh": {"elements_per_half_width": 1000000},
            "upper": {"shape": {"type": "ball"}, "material": {"rigid": true}, "support": "welded"},
            "units": "inch"
        }"#;
        assert_snapshot!(faults(text), @r#"
        /load/force: must be greater than 0, got 0
        /lower/material/poisson_ratio: must be between 0 and 0.499999, got 0.5
        /lower/material/plasticity/tangent_modulus: must be less than `young_modulus`, got 1000
        /lower/material/plasticity/yield_stress: is required
        /lower/shape/radius: must be a number, got a string
        /lower/shape/colour: unknown key "colour"; expected one of: type, radius
        /mesh/elements_per_half_width: must be a whole number between 4 and 320, got 1000000
        /upper/shape/type: must be one of: cylinder, block, groove, hole, profile, wedge, cone, punch, parabola, ellipse, power, sphere, curved, roller, flat, got "ball"
        /upper/support: must be one of: clamped, roller, got "welded"
        /units: must be one of: mm_N_MPa, SI, got "inch"
        /analysis: is required
        "#);
    }

    #[test]
    fn the_whole_format_is_solved() {
        let mut job = with("/analysis", json!("axisymmetric"));
        job["lower"]["shape"] = json!({"type": "groove", "radius": 30, "width": 20, "depth": 10});
        job["upper"]["material"]["plasticity"] =
            json!({"law": "table", "points": [[0, 250], [0.1, 300]]});
        job["load"] = json!({"approaches": [0.01, 0.02]});
        assert!(Job::from_value(&job).is_ok());
        job["load"] = json!({"onset": true});
        assert!(Job::from_value(&job).is_ok());
        job["load"] = json!({"onset": false});
        assert_snapshot!(faults_of(&job), @"/load/onset: must be true");
    }

    #[test]
    fn a_body_of_revolution_is_given_by_its_meridian() {
        let mut job = with("/analysis", json!("axisymmetric"));
        let profile = |points: Value| json!({"type": "profile", "points": points, "depth": 20});
        job["lower"]["shape"] = profile(json!([[0, 0], [5, -0.1], [20, -3]]));
        assert!(Job::from_value(&job).is_ok());
        job["lower"]["shape"] = profile(json!([[-10, -1], [0, 0], [20, -3]]));
        assert_snapshot!(faults_of(&job), @"/lower/shape/points: must start at x = 0 or be \
                                            symmetric about it, because an axisymmetric body is \
                                            the profile turned about x = 0");
    }

    #[test]
    fn messages_are_bounded() {
        let long = "x".repeat(1_000_000);
        let mut job = with("/analysis", json!(long));
        job[&long] = json!(long);
        job["upper"]["support"] = json!({});
        job["tags"] = json!({&long: long});
        for index in 0..1000 {
            job["mesh"][format!("unknown{index}")] = json!(index);
        }
        let Err(JobError::Fields(faults)) = Job::from_json(job.to_string().as_bytes()) else {
            panic!("accepted")
        };
        assert_eq!(faults.len(), 101);
        assert!(faults.iter().all(|fault| fault.pointer.len() < 300 && fault.detail.len() < 500));
        assert_snapshot!(faults.last().unwrap(), @"(job): 905 more faults are not listed; these \
                                                   are the first 100");
    }
}

/// Any JSON value, a few levels deep, with keys that the format knows mixed in.
fn any_json() -> impl Strategy<Value = Value> {
    let key = prop_oneof![
        proptest::sample::select(vec![
            "analysis",
            "units",
            "upper",
            "lower",
            "load",
            "shape",
            "type",
            "radius",
            "material",
            "plasticity",
            "law",
            "points",
            "force",
            "forces",
            "mesh",
            "tags",
            "rigid",
        ])
        .prop_map(str::to_owned),
        ".{0,8}",
    ];
    any_leaf().prop_recursive(5, 64, 6, move |inner| {
        prop_oneof![
            proptest::collection::vec(inner.clone(), 0..6).prop_map(Value::Array),
            proptest::collection::hash_map(key.clone(), inner, 0..6)
                .prop_map(|members| Value::Object(members.into_iter().collect())),
        ]
    })
}

fn any_leaf() -> impl Strategy<Value = Value> {
    let words =
        vec!["plane_strain", "SI", "cylinder", "profile", "table", "bilinear", "simplex", ""];
    prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        any::<i64>().prop_map(Value::from),
        any::<f64>().prop_map(Value::from),
        (-10.0..10.0_f64).prop_map(Value::from),
        proptest::sample::select(words).prop_map(Value::from),
        ".{0,20}".prop_map(Value::from),
    ]
}

/// Every pointer into a value.
fn pointers(value: &Value) -> Vec<String> {
    let below = |step: &str, child: &Value| {
        let inner = pointers(child);
        let step = step.replace('~', "~0").replace('/', "~1");
        inner.into_iter().map(|rest| format!("/{step}{rest}")).collect::<Vec<_>>()
    };
    let mut all = vec![String::new()];
    match value {
        Value::Object(members) => {
            all.extend(members.iter().flat_map(|(key, child)| below(key, child)));
        }
        Value::Array(items) => {
            all.extend(
                items
                    .iter()
                    .enumerate()
                    .flat_map(|(index, child)| below(&index.to_string(), child)),
            );
        }
        _ => {}
    }
    all
}

/// A refusal says something and is bounded; what is accepted can be written and read again.
fn check(outcome: Result<Job, JobError>) {
    match outcome {
        Ok(job) => assert_eq!(job.validate(), Ok(())),
        Err(JobError::Syntax { message, line, .. }) => assert!(!message.is_empty() && line > 0),
        Err(JobError::Fields(faults)) => {
            assert!((1..=101).contains(&faults.len()));
            assert!(
                faults.iter().all(|fault| !fault.detail.is_empty() && fault.detail.len() < 500)
            );
            assert!(
                faults
                    .iter()
                    .all(|fault| fault.pointer.is_empty() || fault.pointer.starts_with('/'))
            );
        }
    }
}

proptest! {
    #[test]
    fn no_value_is_too_strange(value in any_json()) {
        check(Job::from_value(&value));
        check(Job::from_json(value.to_string().as_bytes()));
    }

    #[test]
    fn no_mutation_of_a_job_is_too_strange(
        changes in proptest::collection::vec((any::<prop::sample::Index>(), any_json()), 1..4),
    ) {
        let mut job = example();
        for (index, value) in changes {
            let places = pointers(&job);
            *job.pointer_mut(&places[index.index(places.len())]).unwrap() = value;
        }
        check(Job::from_value(&job));
    }

    #[test]
    fn no_damage_to_the_text_is_too_strange(
        damage in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
        end in any::<prop::sample::Index>(),
    ) {
        let mut text = TWO_CYLINDERS.as_bytes().to_vec();
        for (index, byte) in damage {
            let at = index.index(text.len());
            text[at] = byte;
        }
        check(Job::from_json(&text));
        text.truncate(end.index(text.len()));
        check(Job::from_json(&text));
    }
}
