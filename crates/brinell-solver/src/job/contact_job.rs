//! The job as a whole.

use std::collections::BTreeMap;

use serde::de::Deserialize;
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::fields::{InUnits, read_settings, read_settings_from};
use super::reader::{self, Cursor, Faults, Node};
use super::{
    Analysis, Body, Domain, FatigueLimits, FaultCode, FieldError, Find, HardnessTest, JobError,
    Load, MeshSettings, Method, Named as _, OutputSettings, Side, SolverSettings, Theory,
    Tolerance, Units, hardness, name, tags,
};

/// A complete, valid job. All figures are in N–mm–MPa; [`Job::units`] are the units of the wire
/// format and of the result.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// What people call it.
    pub title: Option<String>,
    /// Kinematics.
    pub analysis: Analysis,
    /// Units of the wire figures.
    pub units: Units,
    /// Body above the contact.
    pub upper: Body,
    /// Body below the contact.
    pub lower: Body,
    /// Forces or approaches of the load steps, or the target of a search for the force.
    pub load: Load,
    /// An input that is sought for what it does to a figure.
    pub find: Option<Find>,
    /// Tolerances of numbers of the bodies and the load.
    pub tolerances: Vec<Tolerance>,
    /// Resolution of the mesh.
    pub mesh: MeshSettings,
    /// Iteration controls.
    pub solver: SolverSettings,
    /// Optional parts of the result.
    pub output: OutputSettings,
    /// Free labels, repeated in the result and searchable.
    pub tags: BTreeMap<String, String>,
}

impl Job {
    pub(super) const KEYS: &'static [&'static str] = &[
        "title",
        "analysis",
        "units",
        "upper",
        "lower",
        "load",
        "find",
        "tolerances",
        "mesh",
        "solver",
        "output",
        "tags",
    ];

    /// Parses the wire format and reports every fault, not only the first.
    ///
    /// # Errors
    /// [`JobError::Syntax`] if the text is not JSON; [`JobError::Fields`] with every fault in
    /// document order if it is not a job. The list ends with a note after 100 faults.
    pub fn from_json(text: &[u8]) -> Result<Self, JobError> {
        Self::solvable(&reader::parse(text)?)
    }

    /// Reads a job like [`Job::from_json`], from parsed JSON, which has lost repeated keys.
    ///
    /// # Errors
    /// [`JobError::Fields`], as in [`Job::from_json`].
    pub fn from_value(value: &serde_json::Value) -> Result<Self, JobError> {
        Self::solvable(&Node::deserialize(value).map_err(|error| reader::explain("", &error))?)
    }

    /// Checks a job that was built in code against every limit of the wire format.
    ///
    /// # Errors
    /// [`JobError::Fields`], as in [`Job::from_json`].
    pub fn validate(&self) -> Result<(), JobError> {
        let wire = serde_json::to_value(self).map_err(|error| reader::explain("", &error))?;
        Self::from_value(&wire).map(drop)
    }

    /// Both bodies, the upper one first.
    pub const fn bodies(&self) -> [&Body; 2] {
        [&self.upper, &self.lower]
    }

    /// Whether at least one body has a hardening law.
    pub(super) fn has_plasticity(&self) -> bool {
        let yields = |body: &Body| body.deformable().is_some_and(|of| of.plasticity.is_some());
        self.bodies().into_iter().any(yields)
    }

    /// The theory of plasticity, where a body can yield.
    pub fn theory(&self) -> Option<Theory> {
        self.has_plasticity().then_some(self.solver.theory)
    }

    /// Whether loads leave something in the bodies: under flow theory, where a body can yield or
    /// the loads are a history. The onset of yield is one of elastic bodies.
    pub fn has_memory(&self) -> bool {
        self.solver.theory == Theory::Flow
            && self.load != Load::Onset
            && (self.has_plasticity() || self.load.is_history())
    }

    /// Whether a body has limits of fatigue.
    pub fn has_fatigue(&self) -> bool {
        Side::BOTH.into_iter().any(|side| self.fatigue(side).is_some())
    }

    /// The limits of fatigue of a body.
    pub fn fatigue(&self, side: Side) -> Option<FatigueLimits> {
        self.bodies()[side.member()].deformable()?.fatigue
    }

    fn solvable(document: &Node) -> Result<Self, JobError> {
        let job = Self::read(document)?;
        let faults = Faults::default();
        faults.extend(job.faults_of_revolution());
        faults.extend(job.faults_of_theory());
        faults.extend(job.faults_of_rolling());
        faults.extend(job.faults_of_hardness());
        faults.extend(job.faults_of_shapes());
        faults.extend(job.faults_of_three_dimensions(document));
        let mut refused = faults.into_sorted(document);
        if refused.is_empty() {
            refused = job.faults_of_find();
        }
        if refused.is_empty() { Ok(job) } else { Err(JobError::Fields(refused)) }
    }

    /// Reads any job of the format, solvable or not.
    pub(super) fn read(document: &Node) -> Result<Self, JobError> {
        let faults = Faults::default();
        let job = Self::read_members(Cursor::root(document, &faults), document);
        faults.extend(both_rigid(document));
        let faults = faults.into_sorted(document);
        match job {
            Some(job) if faults.is_empty() => Ok(job),
            _ => Err(JobError::Fields(faults)),
        }
    }

    /// Reads any job and leaves its faults.
    pub(super) fn read_with(document: &Node, faults: &Faults) {
        Self::read_members(Cursor::root(document, faults), document);
    }

    /// Reads the members. A hardness test brings its upper body and is of revolution, under flow
    /// theory.
    fn read_members(cursor: Cursor<'_>, document: &Node) -> Option<Self> {
        let (object, is_test) = (cursor.object()?, is_test(document));
        object.only(Self::KEYS);
        let title = object.or("title", None, |c| name::read(c).map(Some));
        let analysis = if is_test {
            object.or("analysis", Analysis::Axisymmetric, |c| c.named())
        } else {
            object.required("analysis", |c| c.named())
        };
        let units = object.or("units", Units::default(), |c| c.named());
        let upper = (!is_test).then(|| object.required("upper", |c| Body::read(c, units)));
        if is_test && object.has("upper") {
            let detail = "a hardness test brings its indenter; `load.hardness` has its material";
            object.fault("upper", FaultCode::Inconsistent, format_args!("{detail}"));
        }
        let lower = object.required("lower", |c| Body::read(c, units));
        let force = analysis.map_or(Domain::LineForce, Analysis::force);
        let load = object.required("load", |c| Load::read(c, force, units));
        let find = object.or("find", None, |c| Find::read(c).map(Some));
        let tolerances = object.or("tolerances", Vec::new(), Tolerance::read_all);
        let default_mesh = if is_test {
            hardness::mesh()
        } else {
            analysis.map_or_else(MeshSettings::default, MeshSettings::of)
        };
        let mesh = object.or("mesh", default_mesh, |c| read_settings_from(c, default_mesh));
        let given = if is_paper(document) {
            SolverSettings::paper()
        } else if is_test {
            hardness::settings()
        } else {
            SolverSettings::default()
        };
        let solver = object.or("solver", given, |c| read_settings_from(c, given));
        let output = object.or("output", OutputSettings::default(), read_settings);
        let tags = object.or("tags", BTreeMap::new(), tags::read);
        let (lower, load) = (lower?, load?);
        let upper = upper.unwrap_or_else(|| {
            let indenter = load.hardness()?.indenter(&lower.material);
            if indenter.is_none() {
                let detail = "no indenter is of this size";
                object.fault("load", FaultCode::NotSolvable, format_args!("{detail}"));
            }
            indenter
        });
        Some(Self {
            title: title?,
            analysis: analysis?,
            units: units?,
            upper: upper?,
            lower,
            load,
            find: find?,
            tolerances: tolerances?,
            mesh: mesh?,
            solver: solver?,
            output: output?,
            tags: tags?,
        })
    }
}

/// Whether the load is a hardness test, valid or not.
fn is_test(document: &Node) -> bool {
    let test = document.at("/load").and_then(|load| load.at(&format!("/{}", HardnessTest::KEY)));
    test.is_some_and(|test| *test != Node::Null)
}

/// Whether the job names the method of Jiang and Shang.
fn is_paper(document: &Node) -> bool {
    let method = document.at("/solver").and_then(|solver| solver.at("/method"));
    matches!(method, Some(Node::Text(word)) if Method::of_word(word) == Some(Method::JiangShang))
}

/// Refuses two rigid bodies. The check reads the document, so that other faults do not hide this
/// one.
fn both_rigid(document: &Node) -> Vec<FieldError> {
    let pointers = ["/upper/material", "/lower/material"];
    let rigid =
        |pointer: &&str| document.at(&format!("{pointer}/rigid")) == Some(&Node::Bool(true));
    if !pointers.iter().all(rigid) {
        return Vec::new();
    }
    pointers
        .map(|pointer| FieldError::new(pointer, "both bodies are rigid; one of them must deform"))
        .into()
}

/// Writes the wire format in the job's own units. [`Job::from_json`] reads it back as the same
/// job.
impl Serialize for Job {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let units = self.units;
        let mut map = serializer.serialize_map(None)?;
        if let Some(title) = &self.title {
            map.serialize_entry("title", title)?;
        }
        map.serialize_entry("analysis", &self.analysis)?;
        map.serialize_entry("units", &units)?;
        if self.load.hardness().is_none() {
            map.serialize_entry("upper", &InUnits(&self.upper, units).of(self.analysis))?;
        }
        map.serialize_entry("lower", &InUnits(&self.lower, units).of(self.analysis))?;
        map.serialize_entry(
            "load",
            &InUnits(&self.load, units).with_force(self.analysis.force()),
        )?;
        if let Some(find) = &self.find {
            map.serialize_entry("find", find)?;
        }
        if !self.tolerances.is_empty() {
            map.serialize_entry("tolerances", &Tolerance::write_all(&self.tolerances))?;
        }
        map.serialize_entry("mesh", &InUnits(&self.mesh, units))?;
        map.serialize_entry("solver", &InUnits(&self.solver, units))?;
        map.serialize_entry("output", &InUnits(&self.output, units))?;
        if !self.tags.is_empty() {
            map.serialize_entry("tags", &self.tags)?;
        }
        map.end()
    }
}
