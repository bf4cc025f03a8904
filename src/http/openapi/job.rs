//! The schema of a job. Words and ranges are the model's own, so that they cannot differ from what is accepted.

use serde_json::{Value, json};

use super::schema::{
    Field, closed, field, list_of, named, named_as, names, object, one_of, optional, pair, pure, quantities,
    quantity, tagged, truth, whole, word,
};
use brinell_solver::job::{
    Analysis, ContactMethod, Coupling, MeshSettings, OutputSettings, Profile, Quantity, SolverSettings,
    Support, Sweep, TablePoints, Units, hardening, tags,
};

/// The schemas by name.
pub(super) fn schemas() -> Vec<(&'static str, Value)> {
    let mut all = vec![
        ("Job", job()),
        (
            "Analysis",
            names::<Analysis>(
                "Plane strain (long bodies), plane stress (thin discs), or bodies of revolution about the line of approach.",
            ),
        ),
        (
            "Units",
            names::<Units>("Units of every figure of the job and of its result: mm, N, MPa or m, N, Pa."),
        ),
        ("Body", body()),
        (
            "Load",
            one_of(
                "What presses the bodies together: exactly one of these. Several values are a sweep, one step each.",
                &["ForceLoad", "ForcesLoad", "ApproachLoad", "ApproachesLoad", "OnsetLoad"],
            ),
        ),
        ("MeshSettings", mesh()),
        ("SolverSettings", solver()),
        ("OutputSettings", output()),
        ("Tags", labels()),
    ];
    all.extend(loads());
    all.extend(shapes());
    all.extend(materials());
    all.extend(laws());
    all
}

fn job() -> Value {
    let optional_part = |name, schema: &str, description: &str| optional(name, named_as(schema, description));
    closed(object(
        "Two bodies, what presses them together, and how to solve it. An unknown key is an error.",
        [
            field("analysis", named("Analysis")),
            optional("units", {
                let mut units = named("Units");
                units["default"] = json!(Units::default().name());
                units
            }),
            field("upper", named_as("Body", "The body above the contact.")),
            field("lower", named_as("Body", "The body below the contact.")),
            field("load", named("Load")),
            optional_part("mesh", "MeshSettings", "The mesh."),
            optional_part("solver", "SolverSettings", "Iteration controls."),
            optional_part("output", "OutputSettings", "What the result contains."),
            optional_part("tags", "Tags", "Free labels, echoed in the result; jobs can be listed by them."),
        ],
    ))
}

fn body() -> Value {
    let mut support = names::<Support>(
        "How the far boundary (diametral plane, base) is held: both displacements, or the normal one alone.",
    );
    support["default"] = json!("clamped");
    closed(object(
        "One body, described in its own frame: the contact starts at the origin, heights are counted along the \
         outward normal. At most one of the two is rigid.",
        [field("shape", named("Shape")), optional("support", support), field("material", named("Material"))],
    ))
}

fn length(name: &'static str, description: &str, example: f64) -> Field {
    field(name, quantity(Quantity::Length, description, example))
}

fn shapes() -> Vec<(&'static str, Value)> {
    let shape = |word_of: &str, description: &str, fields: Vec<Field>| {
        let kind = field("type", word("The kind of shape.", word_of));
        closed(object(description, [kind].into_iter().chain(fields)))
    };
    let position = |description| quantity(Quantity::Position, description, 0.5);
    let point = pair("A point of the face.", &position("x, tangential."), &position("Height."));
    let mut points = list_of(
        "Points `[x, height]`, x rising and passing 0. A face that starts or ends at x = 0 is completed by its mirror image.",
        point,
    );
    points["minItems"] = json!(2);
    points["maxItems"] = json!(Profile::MAX_POINTS);
    vec![
        (
            "Shape",
            tagged(
                "The undeformed outline.",
                "type",
                &[("cylinder", "Cylinder"), ("block", "Block"), ("groove", "Groove"), ("profile", "Profile")],
            ),
        ),
        (
            "Cylinder",
            shape(
                "cylinder",
                "Half a cylinder, a sphere in axisymmetry, held at its diametral plane.",
                vec![length("radius", "Radius.", 20.0)],
            ),
        ),
        (
            "Block",
            shape(
                "block",
                "A rectangle, held at its base.",
                vec![
                    length("width", "Full width, centred on the contact.", 200.0),
                    length("depth", "Height of the rectangle below the contact.", 200.0),
                ],
            ),
        ),
        (
            "Groove",
            shape(
                "groove",
                "A block with a concave circular trough across its whole upper face.",
                vec![
                    length("radius", "Radius of the trough.", 30.0),
                    length("width", "Full width, at most twice the radius.", 40.0),
                    length("depth", "From the bottom of the trough to the base.", 50.0),
                ],
            ),
        ),
        (
            "Profile",
            shape(
                "profile",
                "A block whose upper face passes through points, interpolated without overshoot.",
                vec![
                    field("points", points),
                    length("depth", "From height 0 to the base; every height is above it.", 50.0),
                ],
            ),
        ),
    ]
}

fn materials() -> Vec<(&'static str, Value)> {
    let mut poisson_ratio = pure("Poisson's ratio ν, below 0.5.", &(0.0..=0.5), 0.3);
    if let Some(bounds) = poisson_ratio.as_object_mut() {
        let limit = bounds.remove("maximum").unwrap_or_default();
        bounds.insert("exclusiveMaximum".to_owned(), limit);
    }
    let deformable = closed(object(
        "An isotropic body, elastic unless it has a hardening curve.",
        [
            field("young_modulus", quantity(Quantity::Modulus, "Young's modulus E.", 210_000.0)),
            field("poisson_ratio", poisson_ratio),
            optional("plasticity", named("Plasticity")),
        ],
    ));
    let mut yes = truth("Always true.");
    yes["const"] = json!(true);
    vec![
        ("Material", one_of("What a body is made of.", &["Deformable", "Rigid"])),
        ("Deformable", deformable),
        ("Rigid", closed(object("A body that does not deform.", [field("rigid", yes)]))),
    ]
}

fn laws() -> Vec<(&'static str, Value)> {
    let law = |word_of: &str, description: &str, fields: Vec<Field>| {
        let kind = field("law", word("The kind of curve.", word_of));
        closed(object(description, [kind].into_iter().chain(fields)))
    };
    let stress =
        |name, description: &str, example| field(name, quantity(Quantity::Stress, description, example));
    let yield_stress = || stress("yield_stress", "Yield stress σ_y.", 500.0);
    let exponent = || field("exponent", pure("n.", &hardening::STRAIN_EXPONENT, 0.2));
    let stress_of_table = quantity(Quantity::Stress, "Stress, never falling.", 500.0);
    let strain_of_table = pure("Plastic strain, rising; the first is 0.", &hardening::PLASTIC_STRAIN, 0.0);
    let point = pair("A point of the curve.", &strain_of_table, &stress_of_table);
    let mut points = list_of(
        "Points `[plastic_strain, stress]`, joined by straight lines, constant beyond the last.",
        point,
    );
    points["minItems"] = json!(1);
    points["maxItems"] = json!(TablePoints::MAX_POINTS);
    let slope = quantity(
        Quantity::TangentModulus,
        "Slope E_t of stress over total strain beyond yield, below E; 0 is perfectly plastic.",
        10_500.0,
    );
    vec![
        (
            "Plasticity",
            tagged(
                "Uniaxial curve of the stress q over the plastic strain ε_p.",
                "law",
                &[
                    ("bilinear", "Bilinear"),
                    ("ramberg_osgood", "RambergOsgood"),
                    ("table", "Table"),
                    ("swift", "Swift"),
                    ("ludwik", "Ludwik"),
                    ("voce", "Voce"),
                ],
            ),
        ),
        (
            "Bilinear",
            law(
                "bilinear",
                "A straight line beyond the yield stress.",
                vec![yield_stress(), field("tangent_modulus", slope)],
            ),
        ),
        (
            "RambergOsgood",
            law(
                "ramberg_osgood",
                "ε_p = a (σ_0/E) (q/σ_0)^m.",
                vec![
                    stress("reference_stress", "Reference stress σ_0.", 500.0),
                    field("offset", pure("Offset a.", &hardening::OFFSET, 0.3)),
                    field("exponent", pure("Exponent m.", &hardening::STRESS_EXPONENT, 5.0)),
                ],
            ),
        ),
        ("Table", law("table", "A measured curve.", vec![field("points", points)])),
        (
            "Swift",
            law(
                "swift",
                "q = σ_y (1 + ε_p/ε_0)^n.",
                vec![
                    yield_stress(),
                    field("strain_offset", pure("ε_0.", &hardening::STRAIN_OFFSET, 0.01)),
                    exponent(),
                ],
            ),
        ),
        (
            "Ludwik",
            law(
                "ludwik",
                "q = σ_y + k ε_p^n.",
                vec![yield_stress(), stress("coefficient", "k.", 400.0), exponent()],
            ),
        ),
        (
            "Voce",
            law(
                "voce",
                "q = σ_y + (σ_s − σ_y) (1 − exp(−b ε_p)).",
                vec![
                    yield_stress(),
                    stress("saturation_stress", "Saturation stress σ_s, at least σ_y.", 700.0),
                    field("rate", pure("b.", &hardening::RATE, 10.0)),
                ],
            ),
        ),
    ]
}

fn loads() -> Vec<(&'static str, Value)> {
    let force = || {
        quantities(
            &[Quantity::LineForce, Quantity::Force],
            "Force of the whole contact, both sides of the axis: on unit thickness, in axisymmetry in all.",
            612.6106,
        )
    };
    let approach = || quantity(Quantity::Approach, "Approach α of the two supports.", 0.02);
    let sweep = |description, item| {
        let mut values = list_of(description, item);
        values["minItems"] = json!(1);
        values["maxItems"] = json!(Sweep::MAX_VALUES);
        values
    };
    let one = |description: &str, name, value| closed(object(description, [field(name, value)]));
    let mut onset = truth("Always true.");
    onset["const"] = json!(true);
    vec![
        ("ForceLoad", one("A force; the approach is an output.", "force", force())),
        (
            "ForcesLoad",
            one("A sweep of forces.", "forces", sweep("In the order in which they are applied.", force())),
        ),
        ("ApproachLoad", one("An approach; the force is an output.", "approach", approach())),
        (
            "ApproachesLoad",
            one(
                "A sweep of approaches.",
                "approaches",
                sweep("In the order in which they are applied.", approach()),
            ),
        ),
        ("OnsetLoad", one("The force at which the contact begins to yield is the answer.", "onset", onset)),
    ]
}

fn mesh() -> Value {
    let range = MeshSettings::MIN_ELEMENTS_PER_HALF_WIDTH..=MeshSettings::MAX_ELEMENTS_PER_HALF_WIDTH;
    let default = MeshSettings::default().elements_per_half_width;
    let elements = whole("Elements over one contact half-width.", range, default);
    closed(object("The mesh.", [optional("elements_per_half_width", elements)]))
}

fn solver() -> Value {
    let default = SolverSettings::default();
    let mut coupling = names::<Coupling>("How the contact iteration and the plastic iteration alternate.");
    coupling["default"] = json!(default.coupling);
    let mut contact = names::<ContactMethod>("The method that solves the contact conditions.");
    contact["default"] = json!(default.contact);
    let mut tolerance = pure(
        "Relative tolerance on the displacement change and on the out-of-balance force.",
        &SolverSettings::TOLERANCES,
        1e-6,
    );
    tolerance["default"] = json!(default.tolerance);
    let iterations = whole("Iteration limit.", SolverSettings::ITERATION_LIMITS, default.max_iterations);
    closed(object(
        "Iteration controls.",
        [
            optional("coupling", coupling),
            optional("contact", contact),
            optional("tolerance", tolerance),
            optional("max_iterations", iterations),
        ],
    ))
}

fn output() -> Value {
    let default = OutputSettings::default();
    let switch = |name, description, default: bool| {
        let mut switch = truth(description);
        switch["default"] = json!(default);
        optional(name, switch)
    };
    closed(object(
        "What the result contains beside the contact itself.",
        [
            switch("subsurface", "Stresses over depth under the peak pressure.", default.subsurface),
            switch("fields", "Mesh and nodal fields, some megabytes.", default.fields),
        ],
    ))
}

fn labels() -> Value {
    let printable = r"^[^\u0000-\u001f\u007f-\u009f]*$";
    json!({
        "type": "object",
        "description": "Labels: key to text, without control characters.",
        "maxProperties": tags::MAX_TAGS,
        "propertyNames": {"minLength": 1, "maxLength": tags::MAX_KEY, "pattern": printable},
        "additionalProperties": {"type": "string", "maxLength": tags::MAX_VALUE, "pattern": printable},
        "examples": [{"bearing": "NU-210"}],
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::http::openapi::document;
    use brinell_solver::job::{Job, strategy};

    fn validator() -> jsonschema::Validator {
        let mut schema = document();
        schema["$ref"] = json!("#/components/schemas/Job");
        jsonschema::draft202012::new(&schema).unwrap()
    }

    proptest! {
        #[test]
        fn whatever_the_format_can_say_is_in_the_schema(job in strategy::job()) {
            let job = serde_json::to_value(job).unwrap();
            let faults: Vec<_> = validator().iter_errors(&job).map(|fault| fault.to_string()).collect();
            prop_assert!(faults.is_empty(), "{faults:?} in {job}");
        }
    }

    #[test]
    fn what_is_refused_by_its_form_is_refused_by_the_schema() {
        let text = include_str!("../../../api/examples/two_cylinders.json");
        let validator = validator();
        for (pointer, value) in [
            ("/analysis", json!("plane")),
            ("/units", json!(null)),
            ("/upper/shape/radius", json!(-20.0)),
            ("/upper/shape/raduis", json!(20.0)),
            ("/upper/shape/type", json!("cone")),
            ("/upper/support", json!("glued")),
            ("/upper/material/poisson_ratio", json!(0.5)),
            ("/upper/material/plasticity/law", json!("linear")),
            ("/upper/material/plasticity/rate", json!(1.0)),
            ("/lower/material", json!({"rigid": false})),
            ("/load", json!({"force": 1.0, "approach": 1.0})),
            ("/load/force", json!(0.0)),
            ("/load", json!({"forces": []})),
            ("/mesh/elements_per_half_width", json!(3)),
            ("/solver/tolerance", json!(1.0)),
            ("/output/fields", json!("yes")),
            ("/tags", json!({"": "empty key"})),
            ("/tags", json!({"key": 1})),
            ("/colour", json!("red")),
        ] {
            let mut job: Value = serde_json::from_str(text).unwrap();
            assert!(validator.is_valid(&job));
            let (parent, key) = pointer.rsplit_once('/').unwrap();
            job.pointer_mut(parent).unwrap()[key] = value;
            assert!(!validator.is_valid(&job), "{pointer}");
            assert!(Job::from_value(&job).is_err(), "{pointer}");
        }
    }
}
