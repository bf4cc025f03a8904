//! The JSON Schema of the wire format, from the tables of fields and the words of the
//! enumerations.
//!
//! An optional member may also be `null`. The reader checks the conditions that a schema cannot
//! express, e.g. a slope below Young's modulus.

use serde_json::{Map, Value, json};

use super::fields::{Example, Field, FieldKind, FieldTable, NumberKind, Record, words};
use super::tensile::{StrainUnit, TensileTest, TestMeasure, YieldPlace};
use super::{
    Analysis, BackstressTerm, CaseCurve, ContactMethod, Coupling, Detrend, Domain, Elastic,
    FarSupport, FatigueLimits, Find, GivenLimits, HardenedCase, Hardening, HardeningRule,
    HardnessProfile, HardnessScale, HardnessTest, InitialStress, Interpolation, Job, Load,
    MeshSettings, Method, Name, Named, OutputSettings, OverDepth, PositiveF64, RollerProfile,
    Rolling, Shape, Side, SolverSettings, Surface, Sweep, TargetFigure, TestScale, Theory,
    Tolerance, Units, Until, name, tags, target,
};

/// The schemas of a job and of all its parts by name. References begin with `base`, e.g.
/// `#/components/schemas/`.
pub fn schemas(base: &str) -> Vec<Part> {
    Schemas { base }.all()
}

struct Schemas<'a> {
    base: &'a str,
}

/// The name and the schema of a part of a job.
type Part = (&'static str, Value);

/// The name, the key, the description and the schema of a kind of load.
type LoadSchema = (&'static str, &'static str, &'static str, Value);

/// A member of an object.
struct Entry {
    key: &'static str,
    schema: Value,
    required: bool,
}

const fn required(key: &'static str, schema: Value) -> Entry {
    Entry { key, schema, required: true }
}

const fn optional(key: &'static str, schema: Value) -> Entry {
    Entry { key, schema, required: false }
}

impl Schemas<'_> {
    fn all(&self) -> Vec<Part> {
        let mut all = vec![
            ("ContactJob", self.job()),
            ("ContactBody", self.body()),
            words_of::<Analysis>(
                "Analysis",
                "Plane strain (long bodies), plane stress (thin discs), bodies of revolution about \
                 the line of approach, or half-spaces in three dimensions.",
            ),
            words_of::<Units>(
                "Units",
                "Units of every figure of the job and of its result: mm, N, MPa or m, N, Pa.",
            ),
            words_of::<FarSupport>(
                "Support",
                "How the far boundary (diametral plane, base) is held: both displacements, or the \
                 normal one alone. Not in three dimensions.",
            ),
            words_of::<Interpolation>(
                "Interpolation",
                "What a face given by points is like between them.",
            ),
            words_of::<RollerProfile>(
                "RollerProfile",
                "How the surface of a roller falls towards its ends.",
            ),
            ("Tags", tags_schema()),
            ("Shape", self.tagged("The undeformed outline of a body.", Shape::TAG, Shape::TABLES)),
            (
                "Plasticity",
                self.tagged(
                    "Uniaxial curve of the stress q over the plastic strain ε_p.",
                    Hardening::TAG,
                    Hardening::TABLES,
                ),
            ),
        ];
        all.extend([
            words_of::<Method>(
                "Method",
                "A method by one word, which sets theory, coupling and contact method.",
            ),
            words_of::<Coupling>(
                "Coupling",
                "How the contact iteration and the plastic iteration alternate.",
            ),
            words_of::<Theory>(
                "Theory",
                "Theory of plasticity: stress as a function of the strain alone, or of its history.",
            ),
            words_of::<ContactMethod>(
                "ContactMethod",
                "The method that solves the contact conditions.",
            ),
        ]);
        all.extend(self.variants(Shape::TAG, Shape::TABLES));
        all.extend(self.variants(Hardening::TAG, Hardening::TABLES).map(|(name, mut law)| {
            law["properties"]["backstress"] = json!({
                "type": ["array", "null"],
                "description": "Terms of the backstress, for flow theory.",
                "items": self.named(BackstressTerm::TABLE.name),
                "maxItems": BackstressTerm::MAX_TERMS,
            });
            law["properties"][OverDepth::KEY] = or_null(
                self.named("StrengthOverDepth"),
                "How the stresses of the curve vary with the depth.",
            );
            (name, law)
        }));
        all.push(self.record(&BackstressTerm::TABLE));
        all.extend(self.over_depth());
        all.extend(self.materials());
        all.extend(self.loads());
        all.push(words_of::<Detrend>("Detrend", "What is taken away from heights."));
        all.push(("SurfaceHeights", self.surface()));
        all.push(("NpyHeights", npy_heights()));
        all.push(self.settings(&MeshSettings::default(), &[]));
        all.push(self.settings(&SolverSettings::default(), &[]));
        all.push(self.settings(&OutputSettings::default(), &[]));
        all.extend(self.tensile_test());
        all.extend(self.find());
        all
    }

    fn tensile_test(&self) -> Vec<Part> {
        let table = TensileTest::FIELDS;
        let mut entries = self.entries(&table);
        let units = or_null(self.named("Units"), "Units of the stresses. Default: `mm_N_MPa`.");
        entries.push(optional("units", units));
        vec![
            (table.name, object(table.description, entries)),
            words_of::<StrainUnit>("StrainUnit", "Unit of the strain of a test."),
            words_of::<TestMeasure>(
                "TestMeasure",
                "Strain and stress over first length and section, or true ones.",
            ),
            words_of::<YieldPlace>(
                "YieldPlace",
                "Yield at a plastic strain, or where the record leaves its first line for good.",
            ),
        ]
    }

    fn named(&self, name: &str) -> Value {
        json!({"$ref": format!("{}{name}", self.base)})
    }

    fn named_as(&self, name: &str, description: &str) -> Value {
        json!({"$ref": format!("{}{name}", self.base), "description": description})
    }

    fn job(&self) -> Value {
        let part =
            |key, name, description: &str| optional(key, or_null(self.named(name), description));
        let units = format!(
            "Units of every figure of the job and of its result. Default: `{}`.",
            Units::default().name()
        );
        let job = object(
            "Two bodies, what presses them together, and how to solve it. An unknown key is an \
             error; null is the same as leaving a member out.",
            vec![
                optional("title", name_schema("What the job is called.")),
                part(
                    "analysis",
                    "Analysis",
                    "Kinematics. Required, but for a hardness test, which is `axisymmetric`.",
                ),
                part("units", "Units", &units),
                part(
                    "upper",
                    "ContactBody",
                    "The body above the contact. Required, but for a hardness test, which brings \
                     its indenter.",
                ),
                required("lower", self.named_as("ContactBody", "The body below the contact.")),
                required("load", self.named("Load")),
                part("find", "Find", "An input that is sought for what it does to a figure."),
                optional("tolerances", tolerances()),
                part("mesh", "MeshSettings", "The mesh."),
                part("solver", "SolverSettings", "Iteration controls."),
                part("output", "OutputSettings", "What the result contains."),
                part(
                    "tags",
                    "Tags",
                    "Free labels, echoed in the result; jobs can be listed by them.",
                ),
            ],
        );
        debug_assert!(Job::KEYS.iter().all(|key| job["properties"][key].is_object()));
        job
    }

    fn body(&self) -> Value {
        let support =
            format!("How the far boundary is held. Default: `{}`.", FarSupport::default().name());
        object(
            "One body, described in its own frame: the contact starts at the origin, heights are \
             counted along the outward normal. At most one of the two is rigid.",
            vec![
                required("shape", self.named("Shape")),
                optional("support", or_null(self.named("Support"), &support)),
                required("material", self.named("Material")),
                optional(
                    Surface::KEY,
                    or_null(
                        self.named("SurfaceHeights"),
                        "Heights on top of the shape, measured or computed; only in three \
                         dimensions.",
                    ),
                ),
            ],
        )
    }

    fn surface(&self) -> Value {
        let counts = |items: Value| {
            json!({
                "type": "array",
                "items": items,
                "minItems": Surface::MIN_CELLS,
                "maxItems": Surface::MAX_CELLS,
            })
        };
        let mut rows = counts(counts(json!({"type": "number"})));
        rows["description"] = json!("Rows of one length.");
        let heights = json!({
            "description": "Heights along the outward normal at the middles of cells: \
                            `heights[i][j]` at the i-th x and the j-th y of the job, the middle \
                            of the grid at the origin. Lists, or an array of numpy.",
            "anyOf": [rows, self.named("NpyHeights")],
        });
        let length = |along: &str| {
            let described = format!("Distance of heights along {along}.");
            let mut schema = figure_schema(&NumberKind::Quantity(Domain::Length), &described);
            schema["examples"] = json!([0.001]);
            schema
        };
        let detrend = format!(
            "What is taken away from the heights. Default: `{}`.",
            Detrend::default().name()
        );
        object(
            "Heights on top of the shape of a half-space. The contact is solved on their grid, \
             and there is none beyond it.",
            vec![
                required("heights", heights),
                required("spacing_x", length("x")),
                required("spacing_y", length("y")),
                optional("detrend", or_null(self.named("Detrend"), &detrend)),
            ],
        )
    }

    /// Returns the schema of exactly one of these tables; the word under `tag` names it.
    fn tagged(&self, description: &str, tag: &str, tables: &[FieldTable]) -> Value {
        let references: Vec<_> = tables.iter().map(|table| self.named(table.name)).collect();
        let mapping: Map<String, Value> = tables
            .iter()
            .map(|table| (table.word.to_owned(), json!(format!("{}{}", self.base, table.name))))
            .collect();
        json!({
            "description": description,
            "oneOf": references,
            "discriminator": {"propertyName": tag, "mapping": mapping},
        })
    }

    fn variants(
        &self,
        tag: &'static str,
        tables: &'static [FieldTable],
    ) -> impl Iterator<Item = Part> {
        tables.iter().map(move |table| {
            let word = json!({"type": "string", "description": "The word that names this kind.", "const": table.word});
            let entries = [required(tag, word)].into_iter().chain(self.entries(table)).collect();
            (table.name, object(table.description, entries))
        })
    }

    fn entries(&self, table: &FieldTable) -> Vec<Entry> {
        table.fields.iter().map(|field| self.entry(field, None)).collect()
    }

    fn record(&self, table: &FieldTable) -> Part {
        (table.name, object(table.description, self.entries(table)))
    }

    fn settings<T: Record>(&self, default: &T, required: &[&str]) -> Part {
        let table = T::TABLE;
        let defaults = default.values().into_iter();
        let entries = table.fields.iter().zip(defaults).map(|(field, default)| {
            let default =
                default.filter(|_| !required.contains(&field.key)).map(|default| match default {
                    super::fields::FieldValue::Figure(figure) => json!(figure),
                    super::fields::FieldValue::Whole(number) => json!(number),
                    super::fields::FieldValue::Flag(flag) => json!(flag),
                    super::fields::FieldValue::Word(word) => json!(word),
                    super::fields::FieldValue::Points(points) => json!(points),
                });
            self.entry(field, default.as_ref())
        });
        (table.name, object(table.description, entries.collect()))
    }

    /// Returns the schema of a field. A field with a default is optional.
    fn entry(&self, field: &Field, default: Option<&Value>) -> Entry {
        let required = field.required && default.is_none();
        let mut schema = match &field.kind {
            FieldKind::Figure(figure) => figure_schema(figure, field.description),
            FieldKind::Whole(range) => {
                let (low, high) = range.clone().into_inner();
                json!({"type": "integer", "description": field.description, "minimum": low, "maximum": high})
            }
            FieldKind::Flag => json!({"type": "boolean", "description": field.description}),
            FieldKind::Choice(name, _) => self.named_as(name, field.description),
            FieldKind::Points { columns: [(first_text, first), (second_text, second)], count } => {
                json!({
                    "type": "array",
                    "description": field.description,
                    "items": {
                        "type": "array",
                        "description": "One point.",
                        "prefixItems": [figure_schema(first, first_text), figure_schema(second, second_text)],
                        "minItems": 2,
                        "maxItems": 2,
                    },
                    "minItems": count.start(),
                    "maxItems": count.end(),
                })
            }
        };
        match (field.example, default) {
            (Example::Figure(figure), _) => schema["examples"] = json!([figure]),
            (Example::Points(points), _) => schema["examples"] = json!([points]),
            (Example::None, Some(default)) if schema["type"] == "number" => {
                schema["examples"] = json!([default]);
            }
            (Example::None, _) => {}
        }
        if let Some(default) = default {
            let written = default.as_str().map_or_else(|| default.to_string(), str::to_owned);
            let description = format!(
                "{} Default: `{written}`.",
                schema["description"].as_str().unwrap_or_default()
            );
            schema["description"] = json!(description);
        }
        if !required {
            let description = schema["description"].as_str().unwrap_or_default().to_owned();
            schema = or_null(schema, &description);
        }
        Entry { key: field.key, schema, required }
    }

    fn materials(&self) -> Vec<Part> {
        let called =
            || optional("name", name_schema("What the material is called; figures alone count."));
        let mut elastic = self.entries(&Elastic::TABLE);
        let absent = elastic
            .iter()
            .map(|entry| entry.key)
            .chain(["plasticity", InitialStress::KEY, FatigueLimits::KEY])
            .collect::<Vec<_>>();
        let plasticity = "The hardening curve; a body without one stays elastic.";
        elastic.push(optional("plasticity", or_null(self.named("Plasticity"), plasticity)));
        elastic.push(optional(
            InitialStress::KEY,
            json!({
                "type": ["array", "null"],
                "description": "Stress before any load, by depth: straight between depths, \
                                constant beyond the ends. It is relaxed before the load; what is \
                                left is reported.",
                "items": self.named(InitialStress::TABLE.name),
                "minItems": 1,
                "maxItems": OverDepth::MAX_POINTS,
            }),
        ));
        let fatigue = "Limits of high-cycle fatigue; without them nothing is said of it.";
        elastic.push(optional(FatigueLimits::KEY, or_null(self.named("FatigueLimits"), fatigue)));
        elastic.push(called());
        elastic.push(never("rigid"));
        let mut given = self.entries(&GivenLimits::TABLE);
        let limits = given.iter().map(|entry| entry.key).collect::<Vec<_>>();
        given.push(never(FatigueLimits::FROM_HARDNESS));
        let mut of_hardness = vec![required(FatigueLimits::FROM_HARDNESS, always_true())];
        of_hardness.extend(limits.into_iter().map(never));
        let mut rigid = vec![required("rigid", always_true()), called()];
        rigid.extend(absent.into_iter().map(never));
        vec![
            ("Material", self.one_of("What a body is made of.", &["Deformable", "Rigid"])),
            (
                "Deformable",
                object("An isotropic body, elastic unless it has a hardening curve.", elastic),
            ),
            ("Rigid", object("A body that does not deform.", rigid)),
            self.record(&InitialStress::TABLE),
            (
                "FatigueLimits",
                self.one_of(
                    "Limits of high-cycle fatigue.",
                    &[GivenLimits::TABLE.name, "FatigueOfHardness"],
                ),
            ),
            (GivenLimits::TABLE.name, object(GivenLimits::TABLE.description, given)),
            (
                "FatigueOfHardness",
                object(
                    "Limits from the hardness over depth by f_w = 1.6 HV up to 400 HV, t_w = f_w/√3.",
                    of_hardness,
                ),
            ),
        ]
    }

    fn over_depth(&self) -> Vec<Part> {
        let mut factors = self.entry(&OverDepth::FACTORS, None).schema;
        factors["type"] = json!("array");
        let tables = [HardnessProfile::TABLE, HardenedCase::TABLE];
        let names = tables.each_ref().map(|table| table.name);
        let hardness = object(
            "Hardness over depth, of which the yield stress follows by σ_y = 2.876 HV − 90.7 MPa.",
            vec![required("hardness", self.one_of("Measured at points, or of a case.", &names))],
        );
        let [profile, case] = tables.each_ref().map(|table| self.record(table));
        vec![
            (
                "StrengthOverDepth",
                self.one_of(
                    "Factors of the stresses of the hardening curve over the depth below the \
                     surface, or the hardness.",
                    &["StrengthFactors", "HardnessOverDepth"],
                ),
            ),
            ("StrengthFactors", factors),
            ("HardnessOverDepth", hardness),
            profile,
            case,
            words_of::<HardnessScale>(
                "HardnessScale",
                "Scale of hardness: Vickers, or Rockwell C, which becomes Vickers by ISO 18265, \
                 table A.1 (20.3 to 68 HRC).",
            ),
            words_of::<CaseCurve>("CaseCurve", "Hardness between surface and core of a case."),
        ]
    }

    fn loads(&self) -> Vec<Part> {
        let force = "Force of the whole contact, both sides of the axis: on unit thickness, in \
                     axisymmetry and three dimensions in all.";
        let force = figures_schema(&[Domain::LineForce, Domain::Force], force);
        let approach = figures_schema(&[Domain::Approach], "Approach α of the two supports.");
        let example = |mut schema: Value, example: Value| {
            schema["examples"] = json!([example]);
            schema
        };
        let sweep = |item: &Value| {
            json!({
                "type": "array",
                "description": "In the order in which they are applied.",
                "items": item,
                "minItems": 1,
                "maxItems": Sweep::MAX_VALUES,
            })
        };
        let step = |key: &str, figure: &Value| {
            let mut figure = figure.clone();
            figure["minimum"] = json!(0);
            let description = "One load of a history; zero takes it away.";
            json!({
                "type": "object",
                "description": description,
                "properties": {key: figure},
                "required": [key],
                "additionalProperties": false,
            })
        };
        let history = histories(step("force", &force), step("approach", &approach));
        let loads = [
            (
                "ForceLoad",
                "force",
                "A force; the approach is an output.",
                example(force.clone(), json!(612.6106)),
            ),
            (
                "ForcesLoad",
                "forces",
                "A sweep of forces.",
                example(sweep(&force), json!([200.0, 400.0, 600.0])),
            ),
            (
                "ApproachLoad",
                "approach",
                "An approach; the force is an output.",
                example(approach.clone(), json!(0.02)),
            ),
            (
                "ApproachesLoad",
                "approaches",
                "A sweep of approaches.",
                example(sweep(&approach), json!([0.01, 0.02])),
            ),
            (
                "HistoryLoad",
                "history",
                "Loads one after the other, each on what the one before has left.",
                history,
            ),
            (
                "OnsetLoad",
                "onset",
                "The force at which the contact begins to yield is the answer.",
                always_true(),
            ),
            (
                "TargetLoad",
                "target",
                "The force under which a figure of the contact has a value is the answer.",
                example(self.named("Target"), json!({"peak_pressure": 1200.0})),
            ),
            self.rolling_load(),
            self.hardness_load(),
        ];
        let names = loads.each_ref().map(|(name, ..)| *name);
        let mut all = vec![(
            "Load",
            self.one_of(
                "What presses the bodies together: exactly one of these. Several values are a \
                 sweep, one step each.",
                &names,
            ),
        )];
        all.extend(loads.into_iter().map(|(name, key, description, schema)| {
            let mut entries = vec![required(key, schema)];
            entries
                .extend(Load::KINDS.iter().filter(|kind| **kind != key).map(|kind| never(kind)));
            (name, object(description, entries))
        }));
        all.extend(self.targets());
        all.extend(self.rolling());
        all.extend(self.hardness());
        all
    }

    fn rolling_load(&self) -> LoadSchema {
        let mut schema = self.named("Rolling");
        schema["examples"] = json!([{"force": 2000.0, "friction": 0.2}]);
        let description = "A force that rolls over a track, pass after pass: what becomes of the \
                           track is the answer.";
        ("RollingLoad", Rolling::KEY, description, schema)
    }

    fn hardness_load(&self) -> LoadSchema {
        let schema = json!({
            "description": "The test, or its name: `HBW 10/3000`, `HV 10`, `HRC`, `HRB`.",
            "anyOf": [self.named(HardnessTest::TABLE.name), {"type": "string"}],
            "examples": [{"scale": "HBW", "ball": 10.0, "force_kgf": 3000.0}],
        });
        let description = "A hardness test of the lower body: its number is the answer.";
        ("HardnessLoad", HardnessTest::KEY, description, schema)
    }

    fn hardness(&self) -> [Part; 2] {
        let scale = words_of::<TestScale>("TestScale", "A scale of hardness.");
        [self.record(&HardnessTest::TABLE), scale]
    }

    fn rolling(&self) -> [Part; 3] {
        let default = Rolling::new(PositiveF64::MICRO);
        [
            self.settings(&default, &["force"]),
            words_of::<HardeningRule>(
                "HardeningRule",
                "How bodies without a backstress harden as a load rolls.",
            ),
            words_of::<Until>("Until", "When the passes of a load that rolls end."),
        ]
    }

    fn targets(&self) -> Vec<Part> {
        const NAMES: [&str; 6] = [
            "PermanentApproachTarget",
            "DentDepthTarget",
            "PeakPressureTarget",
            "MeanPressureTarget",
            "HalfWidthTarget",
            "MaxPlasticStrainTarget",
        ];
        let target = self.one_of(
            "A figure of the contact and the value that it is to have: exactly one of these.",
            &NAMES,
        );
        let each = NAMES.into_iter().zip(TargetFigure::ALL).map(|(name, figure)| {
            let (key, description) = (figure.name(), target::description(*figure));
            let mut schema = figure_schema(&target::measure_of(*figure), description);
            schema["examples"] = json!([target::example(*figure)]);
            let mut entries = vec![required(key, schema)];
            let others = TargetFigure::ALL.iter().filter(|other| *other != figure);
            entries.extend(others.map(|other| never(other.name())));
            (name, object(description, entries))
        });
        std::iter::once(("Target", target)).chain(each).collect()
    }

    fn find(&self) -> [Part; 2] {
        let figures: Vec<_> = Find::figures().map(Named::name).collect();
        let end = |key, end: &str| {
            let schema = json!({
                "type": ["string", "null"],
                "description": format!("Figure that shall be as {end} as it becomes."),
                "enum": figures.iter().copied().map(Value::from).chain([Value::Null]).collect::<Vec<_>>(),
            });
            optional(key, schema)
        };
        let [upper, lower] = Side::BOTH.map(Side::name);
        let body = json!({
            "type": ["string", "null"],
            "description": "Of which body the figure is, where both have it.",
            "enum": [upper, lower, null],
        });
        let value = |name: Name| {
            let description = format!("Wanted value: {}.", name.meaning());
            optional(name.name(), json!({"type": ["number", "null"], "description": description}))
        };
        let mut until = vec![
            end(Find::ENDS[0], "small"),
            end(Find::ENDS[1], "large"),
            optional(Find::BODY, body),
        ];
        until.extend(Find::figures().map(value));
        let pointer = json!({"type": "string", "pattern": "^/"});
        let vary = json!({
            "description": "JSON pointer of a number of the bodies or the load, or a list of \
                            those that all take the value.",
            "anyOf": [
                pointer,
                {"type": "array", "items": pointer, "minItems": 1, "maxItems": Find::MOST_VARIED},
            ],
            "examples": ["/upper/shape/crown_radius"],
        });
        let between = json!({
            "type": "array",
            "description": "Ends of the search, the smaller one first, in the units of the job.",
            "items": {"type": "number"},
            "minItems": 2,
            "maxItems": 2,
        });
        let find = object(
            "An input that is sought between two ends for what it does to a figure of the last \
             load step. The result is that of the job with it.",
            vec![
                required("vary", vary),
                required("between", between),
                required("until", self.named("FindUntil")),
            ],
        );
        let until = object(
            "What shall be: one figure with its value, in its own unit, or `least` or `most`.",
            until,
        );
        [("Find", find), ("FindUntil", until)]
    }

    fn one_of(&self, description: &str, names: &[&str]) -> Value {
        let references: Vec<_> = names.iter().map(|name| self.named(name)).collect();
        json!({"description": description, "oneOf": references})
    }
}

/// Returns the schema of relative tolerances by JSON pointer.
fn tolerances() -> Value {
    json!({
        "type": ["object", "null"],
        "description": "Relative tolerances of numbers of the bodies and the load by JSON pointer: \
                        the result tells what they do to every figure.",
        "additionalProperties": {
            "type": "number",
            "exclusiveMinimum": 0,
            "maximum": Tolerance::LARGEST,
        },
        "minProperties": 1,
        "maxProperties": Tolerance::MOST,
        "examples": [{"/lower/material/plasticity/yield_stress": 0.05}],
    })
}

/// Returns the schema of a history of such loads.
#[expect(clippy::needless_pass_by_value, reason = "the macro takes them")]
fn histories(force: Value, approach: Value) -> Value {
    json!({
        "type": "array",
        "description": "In the order in which they are applied, at least one of them above \
                        zero. Under `deformation` each stands alone.",
        "items": {"oneOf": [force, approach]},
        "minItems": 1,
        "maxItems": Sweep::MAX_VALUES,
        "examples": [[{"force": 612.6106}, {"force": 0.0}]],
    })
}

/// Returns the schema of an array in numpy's file format.
fn npy_heights() -> Value {
    let text = json!({
        "type": "string",
        "description": "Base64 of what numpy.save writes: two dimensions, little-endian float64 \
                        or float32, in the units of lists. Not NaN.",
    });
    object(
        "Heights as an array of numpy, which takes fewer bytes than lists and no digit away.",
        vec![required(Surface::NPY, text)],
    )
}

/// Returns the schema of a closed object with these members.
fn object(description: &str, entries: Vec<Entry>) -> Value {
    let (mut properties, mut required) = (Map::new(), Vec::new());
    for entry in entries {
        properties.insert(entry.key.to_owned(), entry.schema);
        if entry.required {
            required.push(entry.key);
        }
    }
    let mut object = json!({
        "type": "object",
        "description": description,
        "properties": properties,
        "additionalProperties": false,
    });
    if !required.is_empty() {
        object["required"] = json!(required);
    }
    object
}

/// A member of another kind of this object, which may only be `null` here, so that a generated
/// type refuses an object that mixes two kinds.
fn never(key: &'static str) -> Entry {
    let description = "Belongs to another kind of object; not given here.";
    optional(key, json!({"type": "null", "description": description}))
}

/// Returns a schema that also accepts `null`.
fn or_null(mut schema: Value, description: &str) -> Value {
    if let Some(kind) = schema["type"].as_str() {
        schema["type"] = json!([kind, "null"]);
        return schema;
    }
    if let Some(members) = schema.as_object_mut() {
        members.remove("description");
    }
    json!({"description": description, "oneOf": [schema, {"type": "null"}]})
}

fn words_of<T: Named>(name: &'static str, description: &str) -> Part {
    (name, json!({"type": "string", "description": description, "enum": words::<T>()}))
}

fn always_true() -> Value {
    json!({"type": "boolean", "description": "Always true.", "const": true})
}

fn figure_schema(figure: &NumberKind, description: &str) -> Value {
    match figure {
        NumberKind::Quantity(quantity) => figures_schema(&[*quantity], description),
        NumberKind::Pure(range) => json!({
            "type": "number",
            "description": format!("{description} Without unit."),
            "minimum": range.start(),
            "maximum": range.end(),
        }),
    }
}

/// Returns the schema of a figure whose quantity depends on `analysis`. The bounds cover both
/// systems of units; the description lists the bounds of each.
fn figures_schema(quantities: &[Domain], description: &str) -> Value {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut ranges: Vec<String> = Vec::new();
    for units in Units::ALL {
        for quantity in quantities {
            let (least, most) = quantity.wire_range(*units);
            let range = format!("{least:e} to {most:e} {}", quantity.symbol(*units));
            if !ranges.contains(&range) {
                ranges.push(range);
            }
            (low, high) = (low.min(least), high.max(most));
        }
    }
    let description = format!("{description} Range: {}.", ranges.join(" or "));
    json!({"type": "number", "description": description, "minimum": low, "maximum": high})
}

/// Text without control characters.
const PRINTABLE: &str = r"^[^\u0000-\u001f\u007f-\u009f]*$";

fn name_schema(description: &str) -> Value {
    json!({
        "type": ["string", "null"],
        "description": description,
        "minLength": 1,
        "maxLength": name::MAX_NAME,
        "pattern": PRINTABLE,
    })
}

fn tags_schema() -> Value {
    let printable = PRINTABLE;
    json!({
        "type": "object",
        "description": "Labels: key to text, without control characters.",
        "maxProperties": tags::MAX_TAGS,
        "propertyNames": {"minLength": 1, "maxLength": tags::MAX_KEY, "pattern": printable},
        "additionalProperties": {"type": "string", "maxLength": tags::MAX_VALUE, "pattern": printable},
        "examples": [{"bearing": "NU-210"}],
    })
}
