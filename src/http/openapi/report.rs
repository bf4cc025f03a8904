//! The schema of a result: what `report::Report` is written as, with the unit and the sign of every figure.

use serde_json::{Value, json};

use super::schema::Unit::{Area, Energy, Force, Length, Milliseconds, Pure, Stiffness, Stress};
use super::schema::{
    Field, count, field, figure, figure_or_null, list, list_of, named, named_as, nullable, object, one_of,
    optional, pair, signed, text, truth, words,
};

/// The schemas by name.
pub(super) fn schemas() -> Vec<(&'static str, Value)> {
    let mut all = vec![
        ("Report", report()),
        ("Step", step()),
        (
            "SolveStatus",
            words(
                "How a solve ended. Converged means that displacements and out-of-balance force are below the tolerance and the final state has passed a check of its own.",
                &["converged", "not_converged", "cancelled", "timed_out"],
            ),
        ),
        ("LoadReport", one_of("What was prescribed.", &["PrescribedForce", "PrescribedApproach"])),
        ("PrescribedForce", object("A force.", [field("force", figure(Force, "Force.", 612.6106))])),
        (
            "PrescribedApproach",
            object("An approach.", [field("approach", figure(Length, "Approach α.", 0.02))]),
        ),
        ("LoadApproach", load_approach()),
        ("Iteration", iteration()),
        ("ValidityNote", validity_note()),
        ("ErrorEstimate", estimated_error()),
        ("Mesh", mesh()),
        ("Timings", timings()),
    ];
    all.extend(contact());
    all.extend(bodies());
    all.extend(closed_forms());
    all.extend(flow());
    all
}

fn report() -> Value {
    object(
        "The answer to a job. x is tangential, y normal to the contact, z out of the plane; tension is positive, \
         contact pressure too.",
        [
            field("units", named("Units")),
            field("analysis", named("Analysis")),
            field("status", named_as("SolveStatus", "The least good status of all steps.")),
            field("steps", list_of("One for each load.", named("Step"))),
            optional("load_approach", named("LoadApproach")),
            field("mesh", named_as("Mesh", "The mesh of the last step.")),
            field("timings_ms", named("Timings")),
            optional("tags", named_as("Tags", "The labels of the job.")),
            field("version", text("Version of the program.", env!("CARGO_PKG_VERSION"))),
        ],
    )
}

fn step() -> Value {
    object(
        "The contact under one load.",
        [
            field("load", named("LoadReport")),
            field("status", named("SolveStatus")),
            field(
                "approach",
                signed(Length, "Approach α of the two boundaries that `approach_datum` names.", 0.017_911),
            ),
            field(
                "approach_datum",
                text(
                    "Between which two boundaries the approach is counted.",
                    "the diametral plane of the upper body, 20 mm from the contact towards the diametral plane of the lower body, 20 mm from the contact",
                ),
            ),
            field("contact", named("Contact")),
            field(
                "contact_stiffness",
                signed(
                    Stiffness,
                    "dP/dα, the slope of the load-approach curve at this load, with the plastic flow that it brings. 0 where nothing touches and where the step was stopped.",
                    61_000.0,
                ),
            ),
            optional("flow", named("Flow")),
            optional("subsurface", named("SubsurfaceOfBodies")),
            field("plasticity", named("PlasticityOfBodies")),
            field(
                "hertz",
                nullable(
                    "Hertz",
                    "The closed-form elastic contact of the same bodies under the same force; null where there is none.",
                ),
            ),
            optional("yield_onset", named("YieldOnset")),
            field("validity", list_of("What to keep in mind about this answer.", named("ValidityNote"))),
            field(
                "estimated_error",
                nullable(
                    "ErrorEstimate",
                    "Bounds of the relative discretization errors; null where nothing touches and where the bodies collapse.",
                ),
            ),
            optional("fields", named("FieldsOfBodies")),
            field("history", list_of("Every iteration.", named("Iteration"))),
        ],
    )
}

fn flow() -> Vec<(&'static str, Value)> {
    let energy = |key, description: &str, example| field(key, figure(Energy, description, example));
    let ends = |key, unit, description: &str, example| field(key, list(unit, description, &[example]));
    vec![
        (
            "Flow",
            object(
                "What only flow theory knows: increments, dents, energies.",
                [
                    field(
                        "unloading_stiffness",
                        figure(
                            Stiffness,
                            "dP/dα where the load begins to fall: that of the elastic bodies with the pairs in contact. 0 where nothing touches.",
                            41_600.0,
                        ),
                    ),
                    field("energy", named("Energy")),
                    field("increments", named("Increments")),
                    field("surfaces", named("SurfacesOfBodies")),
                ],
            ),
        ),
        (
            "Energy",
            object(
                "Where the work of the force has gone since the bodies were at rest, both bodies together.",
                [
                    energy("work", "Work of the contact force, the sum of the next two.", 5.34),
                    energy("elastic", "Elastic energy.", 4.79),
                    energy("plastic", "Work of the stresses on plastic strain.", 0.551),
                    energy("stored", "The part of that which the backstress stores.", 0.0),
                    energy("dissipated", "The rest of it.", 0.551),
                ],
            ),
        ),
        (
            "Increments",
            object(
                "The ends of the increments of a load, in order.",
                [
                    ends("force", Force, "Contact force.", 612.6106),
                    ends("approach", Length, "Approach.", 0.017_856),
                    ends("peak_pressure", Stress, "Largest pressure.", 1149.3),
                    ends("half_width", Length, "Half-width.", 0.306_95),
                    field("iterations", list_of("Iterations made.", count("Of one increment.", 9))),
                ],
            ),
        ),
        (
            "SurfacesOfBodies",
            object(
                "The surface of each body; null for a rigid one.",
                [
                    field("upper", nullable("Surface", "Of the upper body.")),
                    field("lower", nullable("Surface", "Of the lower body.")),
                ],
            ),
        ),
        (
            "Surface",
            object(
                "The surface of one body near the contact: the dent where the force is zero.",
                [
                    field("x", list(Length, "x of the nodes, both sides of the axis.", &[0.0])),
                    field(
                        "height",
                        list(
                            Length,
                            "How far each has moved outward from the undeformed surface; a dent is negative.",
                            &[-0.0008],
                        ),
                    ),
                    field(
                        "depth",
                        figure(Length, "Depth of the deepest point below the undeformed surface.", 0.0008),
                    ),
                    field(
                        "pile_up",
                        figure(Length, "Height of the highest point above the undeformed surface.", 0.0001),
                    ),
                    field("pile_up_position", figure(Length, "|x| of that point.", 0.35)),
                    field(
                        "yielded_in_reverse",
                        truth("Whether any point yielded since the load last began to fall."),
                    ),
                    field(
                        "reverse_area",
                        figure(Area, "Area of these points in the section x–y, both sides of the axis.", 0.0),
                    ),
                    field(
                        "max_reverse_strain",
                        figure(Pure, "Largest equivalent plastic strain gained since then.", 0.0),
                    ),
                ],
            ),
        ),
    ]
}

fn contact() -> Vec<(&'static str, Value)> {
    vec![
        (
            "Contact",
            object(
                "Contact pressure and its resultants, both sides of the axis.",
                [
                    field("force", figure(Force, "Sum of the nodal forces.", 612.6106)),
                    field(
                        "half_width",
                        figure(
                            Length,
                            "Half of the distance between the ends of the pressure, interpolated to where it vanishes; a radius in axisymmetry.",
                            0.308_44,
                        ),
                    ),
                    field("peak_pressure", figure(Stress, "Largest pressure.", 1182.4)),
                    field("peak_position", signed(Length, "x of the largest pressure.", 0.0)),
                    field(
                        "mean_pressure",
                        figure(Stress, "Force over width, or over the area of the contact circle.", 993.08),
                    ),
                    field(
                        "patches",
                        list_of("The connected parts of the contact, from left to right.", named("Patch")),
                    ),
                    field("nodes", named("ContactNodes")),
                ],
            ),
        ),
        (
            "Patch",
            object(
                "One connected part of the contact.",
                [
                    field("left", signed(Length, "Left end.", -0.308_44)),
                    field("right", signed(Length, "Right end.", 0.308_44)),
                ],
            ),
        ),
        (
            "ContactNodes",
            object(
                "Values at the candidate pairs of nodes, in order of x; all lists have the same length.",
                [
                    field("x", list(Length, "Tangential position.", &[-0.01, 0.0, 0.01])),
                    field(
                        "pressure",
                        list(Stress, "Contact pressure, not negative.", &[1182.0, 1182.4, 1182.0]),
                    ),
                    field("force", list(Force, "Nodal force.", &[12.3, 12.4, 12.3])),
                    field("gap", list(Length, "Gap under the load, 0 in contact.", &[0.0, 0.0, 0.0])),
                ],
            ),
        ),
    ]
}

/// An object with one of these for each body, `null` for a rigid one.
fn of_bodies(description: &str, name: &str) -> Value {
    let side = |side, description| field(side, nullable(name, description));
    object(
        description,
        [
            side("upper", "Of the upper body; null if it is rigid."),
            side("lower", "Of the lower body; null if it is rigid."),
        ],
    )
}

fn stresses() -> Vec<Field> {
    vec![
        field("sigma_x", list(Stress, "Tangential stress, radial in axisymmetry.", &[-1020.0])),
        field("sigma_y", list(Stress, "Normal stress.", &[-1182.4])),
        field("sigma_z", list(Stress, "Out-of-plane stress, hoop stress in axisymmetry.", &[-660.0])),
        field("von_mises", list(Stress, "Von Mises stress.", &[470.0])),
        field("equivalent_plastic_strain", list(Pure, "Equivalent plastic strain.", &[0.0])),
    ]
}

fn bodies() -> Vec<(&'static str, Value)> {
    let subsurface = [
        field("depth", list(Length, "Depth below the surface, from 0.", &[0.0, 0.01])),
        field("tau_max", list(Stress, "Largest shear stress.", &[260.0])),
    ];
    let nodes = pair("x, y.", &json!({"type": "number"}), &json!({"type": "number"}));
    let corner = json!({"type": "integer", "minimum": 0});
    let mut corners = list_of("Corners of one element, counter-clockwise.", corner);
    corners["minItems"] = json!(4);
    corners["maxItems"] = json!(4);
    let fields = [
        field(
            "nodes",
            list_of(
                "Nodes `[x, y]` before loading, y from the lower body to the upper one. Unit: mm (SI: m).",
                nodes.clone(),
            ),
        ),
        field("elements", list_of("Elements by their corners, counted from 0.", corners)),
        field(
            "displacement",
            list_of(
                "Displacements `[u_x, u_y]` of the nodes, each body relative to its own support. Unit: mm (SI: m).",
                nodes,
            ),
        ),
        field("tau_xy", list(Stress, "Shear stress.", &[0.0])),
    ];
    vec![
        (
            "SubsurfaceOfBodies",
            of_bodies("Stresses over depth; only where `output.subsurface` asks for them.", "Subsurface"),
        ),
        (
            "Subsurface",
            object(
                "Stresses along the normal under the peak pressure; all lists have the same length.",
                subsurface.into_iter().chain(stresses()),
            ),
        ),
        ("PlasticityOfBodies", of_bodies("Plastic flow in each body.", "PlasticZone")),
        ("PlasticZone", plastic_zone()),
        (
            "FieldsOfBodies",
            of_bodies("Mesh and nodal fields; only where `output.fields` asks for them.", "Fields"),
        ),
        (
            "Fields",
            object(
                "The mesh of one body and the fields at its nodes; one half of the body where `mesh.symmetric`.",
                fields.into_iter().chain(stresses()),
            ),
        ),
    ]
}

fn plastic_zone() -> Value {
    let point = pair("x, depth.", &json!({"type": "number"}), &json!({"type": "number"}));
    object(
        "Extent of plastic flow in one body.",
        [
            field("yielded", truth("Whether any Gauss point is beyond yield.")),
            field(
                "max_equivalent_plastic_strain",
                figure(Pure, "Largest equivalent plastic strain at a Gauss point.", 0.002_880_9),
            ),
            field("position", signed(Length, "x of that point.", 0.007)),
            field("depth", signed(Length, "Depth of that point.", 0.21)),
            field(
                "area",
                figure(Area, "Area of the plastic zone in the section, both sides of the axis.", 0.35),
            ),
            field("reached_surface", truth("Whether the plastic zone includes a part of the free surface.")),
            field(
                "outline",
                list_of(
                    "Outline of the plastic zone, both sides of the axis: closed polygons, the first point not repeated, counter-clockwise in (x, depth), holes clockwise. Unit: mm (SI: m).",
                    list_of("One polygon of points `[x, depth]`.", point),
                ),
            ),
        ],
    )
}

fn closed_forms() -> Vec<(&'static str, Value)> {
    vec![
        (
            "Hertz",
            object(
                "Hertz's elastic contact under the same force.",
                [
                    field("half_width", figure(Length, "Half-width a; radius in axisymmetry.", 0.26)),
                    field("peak_pressure", figure(Stress, "Peak pressure.", 1500.0)),
                    field(
                        "yield_onset_force",
                        figure_or_null(
                            Force,
                            "Force at which the first body begins to yield; null if none can.",
                            218.99,
                        ),
                    ),
                    field("yield_onset_depth", figure_or_null(Length, "Depth at which it does.", 0.109)),
                ],
            ),
        ),
        (
            "YieldOnset",
            object(
                "The onset of yield, found for the job's own shapes; only for `\"load\": {\"onset\": true}`.",
                [
                    field("force", figure(Force, "Force at first yield.", 218.4)),
                    field("approach", signed(Length, "Approach under it.", 0.0068)),
                    field("peak_pressure", figure(Stress, "Peak pressure under it.", 895.0)),
                    field(
                        "body",
                        words("Which body yields first; of two alike, the lower one.", &["upper", "lower"]),
                    ),
                    field(
                        "position",
                        signed(Length, "x of the middle of the first element to yield.", 0.003),
                    ),
                    field("depth", signed(Length, "Depth of that middle.", 0.11)),
                ],
            ),
        ),
    ]
}

fn load_approach() -> Value {
    object(
        "The load–approach curve of a sweep, in order of the approach; only converged steps.",
        [
            field("force", list(Force, "Contact force P.", &[100.0, 200.0])),
            field("approach", list(Length, "Approach α.", &[0.003, 0.006])),
            field("stiffness", list(Stiffness, "dP/dα along the curve.", &[32_000.0, 33_000.0])),
        ],
    )
}

fn iteration() -> Value {
    object(
        "One outer iteration. Counts are of this iteration alone.",
        [
            field("iteration", count("Its number, from 1.", 1)),
            field("contact_pivots", count("Pivots, or changes of the active set, of the contact solve.", 3)),
            field("initial_stress_updates", count("Initial-stress loads put into effect.", 1)),
            field("factorizations", count("Stiffness factorizations.", 0)),
            field("displacement_change", figure(Pure, "‖u − u_previous‖ / ‖u‖.", 1e-3)),
            field("force_change", figure(Pure, "‖R − R_previous‖ / ‖R‖.", 1e-3)),
            field("equilibrium_residual", figure(Pure, "Out-of-balance force over contact force.", 1e-4)),
            field("plastic_points", count("Gauss points beyond yield, both bodies.", 812)),
            field("contact_pairs", count("Pairs in contact.", 24)),
            field("approach", signed(Length, "Approach α.", 0.0179)),
            field("peak_pressure", figure(Stress, "Largest contact pressure.", 1182.4)),
            field("elapsed_ms", figure(Milliseconds, "Since the start of the job.", 31.5)),
        ],
    )
}

fn validity_note() -> Value {
    let codes = [
        "not_converged",
        "cancelled",
        "timed_out",
        "wide_contact",
        "large_strain",
        "collapse",
        "deformation_theory",
        "contact_at_edge",
        "coarse_mesh",
        "near_support",
    ];
    let mut code = text("Stable identifier; there may be more in the future.", "deformation_theory");
    code["examples"] = json!(codes);
    object(
        "One remark on the validity of the answer.",
        [field("code", code), field("message", text("For a person.", "Plasticity by deformation theory: …"))],
    )
}

fn estimated_error() -> Value {
    object(
        "Bounds of the relative discretization errors: they hold in at least 95 of 100 cases and say nothing about the theory.",
        [
            field("peak_pressure", figure(Pure, "Of the peak pressure.", 0.000_52)),
            field("half_width", figure(Pure, "Of the half-width.", 0.024)),
            field("approach", figure(Pure, "Of the approach; 0 where it is prescribed.", 0.000_94)),
            field("force", figure(Pure, "Of the contact force; 0 where it is prescribed.", 0.0)),
        ],
    )
}

fn mesh() -> Value {
    object(
        "The mesh that was solved on.",
        [
            field("symmetric", truth("Whether one half stands for both by symmetry.")),
            field("spacing", figure(Length, "Tangential spacing in the contact.", 0.0154)),
            field("contact_pairs", count("Candidate pairs of nodes of the meshed part.", 41)),
            field("nodes", count("Nodes of both bodies.", 8834)),
            field("elements", count("Elements of both bodies.", 8600)),
            field("equations", count("Equations of both bodies.", 17_226)),
            field("passes", count("Mesh passes made, the sizing ones included.", 3)),
            field(
                "enlargements",
                count("Times the mesh was enlarged because the contact reached its edge.", 0),
            ),
            field(
                "min_jacobian_ratio",
                signed(
                    Pure,
                    "Smallest ratio of Jacobian determinants within one element; 1 is a parallelogram.",
                    0.8,
                ),
            ),
            field("max_aspect_ratio", figure(Pure, "Largest ratio of element side lengths.", 2.4)),
        ],
    )
}

fn timings() -> Value {
    let time = |name, description: &str| field(name, figure(Milliseconds, description, 4.2));
    object(
        "Where the time went, all passes and steps together.",
        [
            time("total", "Everything."),
            time("mesh", "Mesh generation."),
            time("assembly", "Stiffness assembly."),
            time("ordering", "Fill-reducing ordering."),
            time("symbolic", "Symbolic factorization."),
            time("numeric", "Numeric factorization."),
            time("flexibility", "Contact flexibility matrix."),
            time("contact", "Contact solves."),
            time("plasticity", "Plastic law and initial-stress loads."),
            time("solves", "Forward and back substitutions, the contact stiffness among them."),
            time("output", "Final fields and the report."),
        ],
    )
}
