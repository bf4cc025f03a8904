//! TEMPORARY STUB, replaced at merge: just enough of `Job::from_json` to exercise the service.

use serde_json::Value;

use super::{
    Analysis, Body, ContactMethod, Coupling, FieldError, Job, JobError, Load, Material, MeshSettings,
    OutputSettings, PositiveF64, Shape, SolverSettings, Support, Units,
};

struct Faults(Vec<FieldError>);

impl Faults {
    fn add(&mut self, pointer: &str, detail: impl Into<String>) {
        self.0.push(FieldError { pointer: pointer.to_owned(), detail: detail.into() });
    }

    fn number(&mut self, root: &Value, pointer: &str, message: &str, test: fn(f64) -> bool) -> f64 {
        match root.pointer(pointer) {
            None => self.add(pointer, "is missing"),
            Some(value) => match value.as_f64() {
                Some(number) if test(number) => return number,
                Some(number) => self.add(pointer, format!("{message}, got {number}")),
                None => self.add(pointer, format!("must be a number, got {value}")),
            },
        }
        1.0
    }

    fn keys(&mut self, root: &Value, pointer: &str, known: &[&str]) {
        let Some(object) = root.pointer(pointer).and_then(Value::as_object) else { return };
        for key in object.keys().filter(|key| !known.contains(&key.as_str())) {
            self.add(&format!("{pointer}/{key}"), "unknown key");
        }
    }
}

impl Job {
    /// Parses the wire format.
    ///
    /// # Errors
    /// [`JobError`] with every fault found.
    pub fn from_json(text: &[u8]) -> Result<Self, JobError> {
        let root: Value = serde_json::from_slice(text).map_err(|e| JobError::Syntax {
            message: e.to_string(),
            line: e.line(),
            column: e.column(),
        })?;
        let mut faults = Faults(Vec::new());
        if !root.is_object() {
            faults.add("", "must be an object");
            return Err(JobError::Fields(faults.0));
        }
        faults.keys(
            &root,
            "",
            &["analysis", "units", "upper", "lower", "load", "mesh", "solver", "output", "tags"],
        );
        let upper = body(&mut faults, &root, "/upper");
        let lower = body(&mut faults, &root, "/lower");
        let force =
            faults.number(&root, "/load/force", "must be a finite number greater than 0", |v| v > 0.0);
        let elements = if root.pointer("/mesh/elements_per_half_width").is_some() {
            faults.number(&root, "/mesh/elements_per_half_width", "must be 4 to 320", |v| {
                (4.0..=320.0).contains(&v)
            })
        } else {
            20.0
        };
        let tags = match root.get("tags") {
            None => std::collections::BTreeMap::default(),
            Some(tags) => serde_json::from_value(tags.clone()).unwrap_or_default(),
        };
        if !faults.0.is_empty() {
            return Err(JobError::Fields(faults.0));
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "stub, checked above")]
        Ok(Self {
            analysis: Analysis::PlaneStrain,
            units: Units::MmNMpa,
            upper,
            lower,
            load: Load::Forces(vec![positive(force)]),
            mesh: MeshSettings { elements_per_half_width: elements as u32 },
            solver: SolverSettings {
                coupling: Coupling::Accelerated,
                contact: ContactMethod::ActiveSet,
                tolerance: positive(1e-6),
                max_iterations: root.pointer("/solver/max_iterations").and_then(Value::as_u64).unwrap_or(500)
                    as u32,
            },
            output: OutputSettings::default(),
            tags,
        })
    }
}

#[expect(clippy::unwrap_used, reason = "stub, checked by the caller")]
fn positive(value: f64) -> PositiveF64 {
    PositiveF64::new(value).unwrap()
}

fn body(faults: &mut Faults, root: &Value, at: &str) -> Body {
    let radius =
        faults.number(root, &format!("{at}/shape/radius"), "must be a finite number greater than 0", |v| {
            v > 0.0
        });
    let modulus =
        faults.number(root, &format!("{at}/material/young_modulus"), "must be greater than 0", |v| v > 0.0);
    faults.number(
        root,
        &format!("{at}/material/poisson_ratio"),
        "must be at least 0 and less than 0.5",
        |v| (0.0..0.5).contains(&v),
    );
    faults.keys(root, &format!("{at}/shape"), &["type", "radius"]);
    faults.keys(root, &format!("{at}/material"), &["young_modulus", "poisson_ratio", "plasticity", "rigid"]);
    let tangent = format!("{at}/material/plasticity/tangent_modulus");
    let has_modulus = root.pointer(&format!("{at}/material/young_modulus")).is_some_and(Value::is_number);
    if has_modulus && root.pointer(&tangent).and_then(Value::as_f64).is_some_and(|value| value >= modulus) {
        faults.add(&tangent, "must be less than young_modulus");
    }
    Body {
        shape: Shape::Cylinder { radius: positive(radius) },
        material: Material::Rigid,
        support: Support::Clamped,
    }
}
