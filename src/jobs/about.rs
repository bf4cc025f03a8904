//! What a list says of a job.

use std::collections::BTreeMap;

use brinell_solver::description::description;
use brinell_solver::job::{Job, Named as _, Units};

/// A job by its name, without its request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct About {
    /// What people call it: its title, or else its description.
    pub title: String,
    /// Bodies, load and materials in a line.
    pub description: String,
    /// Units of its figures.
    pub units: Units,
}

/// Labels under which the store keeps it beside those of clients, which are printable.
const TITLE: &str = "\u{2}title";
const DESCRIPTION: &str = "\u{2}description";
const UNITS: &str = "\u{2}units";

impl About {
    /// What a list says of this job.
    pub fn of(job: &Job) -> Self {
        let description = description(job);
        let title = job.title.clone().unwrap_or_else(|| description.clone());
        Self { title, description, units: job.units }
    }

    /// Returns the labels under which it is kept.
    pub fn labels(&self) -> [(String, String); 3] {
        [
            (TITLE, self.title.clone()),
            (DESCRIPTION, self.description.clone()),
            (UNITS, self.units.name().to_owned()),
        ]
        .map(|(name, value)| (name.to_owned(), value))
    }

    /// Takes it out of the labels of a job; `None` of jobs taken in before version 0.3.
    pub fn take(labels: &mut BTreeMap<String, String>) -> Option<Self> {
        let [title, description, units] =
            [TITLE, DESCRIPTION, UNITS].map(|name| labels.remove(name));
        let units = units?;
        let units = Units::ALL.iter().copied().find(|one| one.name() == units)?;
        Some(Self { title: title?, description: description?, units })
    }
}
