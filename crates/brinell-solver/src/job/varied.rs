//! A job with other numbers, as a search and tolerances solve it.

use serde::de::Deserialize;
use serde_json::{Value, json};

use super::reader::{Faults, Node, explain};
use super::{
    Domain, FaultCode, FieldError, Find, Job, JobError, Named as _, TargetFigure, Tolerance,
};

/// Parts of a job with numbers that can be varied. The others are settings of the solver.
const PARTS: [&str; 3] = ["/upper/", "/lower/", "/load/"];
/// Least and largest relative change by which the effect of a tolerance is told. Figures scatter
/// by up to 4e-3 from mesh to mesh, and bend beyond some per cent (`docs/notes/find.md`).
const CHANGES: (f64, f64) = (0.02, 0.05);

impl Tolerance {
    /// Returns the relative change to either side by which its effect is told.
    pub fn change(&self) -> f64 {
        self.relative.clamp(CHANGES.0, CHANGES.1)
    }
}

impl Job {
    /// Returns this job with a number in place of those at JSON pointers, in the units of the job,
    /// and without `find` and `tolerances`.
    ///
    /// # Errors
    /// [`JobError::Fields`], as in [`Job::from_json`].
    pub fn varied(&self, pointers: &[String], value: f64) -> Result<Self, JobError> {
        let mut wire = self.plain()?;
        for pointer in pointers {
            if let Some(number) = wire.pointer_mut(pointer) {
                *number = value.into();
            }
        }
        Self::from_value(&wire)
    }

    /// Returns this job with a target in place of its single force, where that is sought; `None`
    /// of another input, and of a figure that is no target.
    pub fn with_target(&self, find: &Find, value: f64) -> Option<Result<Self, JobError>> {
        let is_force = self.load.kind() == "force" && find.vary == ["/load/force"];
        let mut targets = TargetFigure::ALL.iter().filter(|target| !target.is_permanent());
        let target = targets.find(|target| {
            is_force && find.body.is_none() && target.name() == find.figure.name()
        })?;
        Some(self.plain().and_then(|mut wire| {
            wire["load"] = json!({"target": {target.name(): value}});
            Self::from_value(&wire)
        }))
    }

    /// Returns the number of the bodies or the load at a JSON pointer, in the units of the job.
    pub fn number_at(&self, pointer: &str) -> Option<f64> {
        let is_input = PARTS.iter().any(|part| pointer.starts_with(part));
        let wire = is_input.then(|| self.plain().ok()).flatten()?;
        wire.pointer(pointer).and_then(Value::as_f64)
    }

    /// Returns what a number at a JSON pointer measures; `None` of one without unit.
    pub fn domain_at(&self, pointer: &str) -> Option<Domain> {
        let wire = Node::deserialize(self.plain().ok()?).ok()?;
        let faults = Faults::watching(pointer);
        Self::read_with(&wire, &faults);
        faults.watched()
    }

    /// Returns the wire format without `find` and `tolerances`.
    fn plain(&self) -> Result<Value, JobError> {
        let mut wire = serde_json::to_value(self).map_err(|error| explain("", &error))?;
        if let Some(members) = wire.as_object_mut() {
            members.remove("find");
            members.remove("tolerances");
        }
        Ok(wire)
    }

    /// Returns the faults of numbers that are no numbers of the job, or at whose ends there is no
    /// job.
    pub(super) fn faults_of_find(&self) -> Vec<FieldError> {
        let of_find = self.find.iter().flat_map(|find| self.faults_of_ends(find));
        let tolerances = self.tolerances.iter();
        let varies = self.find.is_some() || !self.tolerances.is_empty();
        let on_many_meshes = self.mesh.accuracy.filter(|_| varies).map(|_| {
            let detail = "searches and tolerances compare answers of one number of elements";
            FieldError::new("/mesh/accuracy", detail)
        });
        let of_tolerances = tolerances.filter_map(|one| self.fault_of_tolerance(one));
        of_find.chain(of_tolerances).chain(on_many_meshes).collect()
    }

    fn faults_of_ends(&self, find: &Find) -> Vec<FieldError> {
        let several = find.vary.len() > 1;
        let place = |k| if several { format!("/find/vary/{k}") } else { "/find/vary".to_owned() };
        let named = find.vary.iter().enumerate();
        let missing: Vec<_> = named
            .filter(|(_, pointer)| self.number_at(pointer).is_none())
            .map(|(k, pointer)| no_number(place(k), pointer))
            .collect();
        if !missing.is_empty() {
            return missing;
        }
        let ends = find.between.iter().enumerate();
        ends.filter_map(|(k, end)| {
            let fault = self.first_fault(&find.vary, *end)?;
            Some(FieldError { pointer: format!("/find/between/{k}"), ..fault })
        })
        .collect()
    }

    fn fault_of_tolerance(&self, one: &Tolerance) -> Option<FieldError> {
        let escaped = one.pointer.replace('~', "~0").replace('/', "~1");
        let pointer = format!("/tolerances/{escaped}");
        match self.number_at(&one.pointer) {
            None => Some(no_number(pointer, &one.pointer)),
            Some(0.0) => {
                let detail = format!("{} is 0, of which a part is 0", one.pointer);
                Some(FieldError::new(pointer, detail))
            }
            Some(number) => {
                let numbers = [1.0 - one.change(), 1.0 + one.change()].map(|part| part * number);
                let fault = |number| self.first_fault(std::slice::from_ref(&one.pointer), number);
                let fault = numbers.into_iter().find_map(fault)?;
                Some(FieldError { pointer, ..fault })
            }
        }
    }

    /// Returns the first fault of the job with other numbers, in words that name its field.
    fn first_fault(&self, pointers: &[String], value: f64) -> Option<FieldError> {
        let Err(JobError::Fields(faults)) = self.varied(pointers, value) else { return None };
        let fault = faults.into_iter().next()?;
        Some(FieldError { detail: format!("with {value}, {fault}"), ..fault })
    }
}

fn no_number(place: String, pointer: &str) -> FieldError {
    let detail = format!(
        "{pointer:?} is no number of the bodies or the load; a JSON pointer names one, such as \
         \"/upper/shape/radius\""
    );
    FieldError { pointer: place, code: FaultCode::Inconsistent, detail }
}
