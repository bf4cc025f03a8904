//! Lists of jobs.
//!
//! A page is read from one source in the order of the list: the jobs with a label, in a state, of a
//! key, or all. What else the filter asks is looked up job by job, for a bounded number of jobs. A
//! source with fewer jobs answers the page; otherwise the next source is tried, and the page ends
//! where the last one was left, with a cursor.

use std::fmt::Write as _;

use sqlx::types::Uuid;

use super::codec::{JobRow, job_columns, job_record};
use super::message::{Messages, Value};
use crate::jobs::{JobFilter, JobId, JobPage, JobRecord, KeyId, StoreError};
use brinell_solver::job::Named as _;

/// Most jobs of a source that are looked up for a page: each takes 2 to 4 µs of the database.
const LOOKED_UP: usize = 5000;

/// Jobs without their places in the queue: each place would cost a scan of the queue.
const PAGE: &str = concat!("SELECT ", job_columns!(), ", NULL FROM jobs j WHERE j.id IN (");

/// A statement and the values of its parameters.
#[derive(Default)]
struct Text<'a> {
    text: String,
    values: Vec<Value<'a>>,
}

impl<'a> Text<'a> {
    fn push(&mut self, text: &str, value: Value<'a>) {
        self.values.push(value);
        let _ = write!(self.text, "{text}${}", self.values.len());
    }
}

/// What a page is read from.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Source<'a> {
    Ids,
    Label(&'a (String, String)),
    Key,
    State,
    All,
}

impl Source<'_> {
    /// The sources of a filter, those first that are likely to have few jobs.
    fn all(filter: &JobFilter) -> Vec<Source<'_>> {
        if !filter.ids.is_empty() {
            return vec![Source::Ids];
        }
        let labels = filter.tags.iter().map(Source::Label);
        let key = filter.submitter.map(|_| Source::Key);
        let state = (filter.states.len() == 1).then_some(Source::State);
        let sources: Vec<_> = labels.chain(key).chain(state).collect();
        if sources.is_empty() { vec![Source::All] } else { sources }
    }

    /// Writes the query for the ids of the source, in the order of the list.
    fn write<'a>(self, filter: &'a JobFilter, text: &mut Text<'a>)
    where
        Self: 'a,
    {
        let mut id = "id";
        match self {
            Source::Ids => text.push("SELECT id FROM jobs WHERE id IN ", Value::Jobs(&filter.ids)),
            Source::Label((name, value)) => {
                id = "job";
                text.push("SELECT job AS id FROM job_tags WHERE name = ", Value::Text(Some(name)));
                text.push(" AND value = ", Value::Text(Some(value)));
            }
            Source::State => {
                let state = filter.states.first().map(|state| state.name());
                text.push("SELECT id FROM jobs WHERE state = ", Value::Text(state));
            }
            Source::Key => {
                let key = filter.submitter.map_or_else(Uuid::nil, KeyId::uuid);
                text.push("SELECT id FROM jobs WHERE submitter = ", Value::Id(key));
            }
            Source::All => text.text.push_str("SELECT id FROM jobs WHERE TRUE"),
        }
        if let Some(cursor) = filter.cursor {
            let after = if filter.oldest_first { ">" } else { "<" };
            text.push(&format!(" AND {id} {after} "), Value::Id(cursor.uuid()));
        }
        let _ = write!(text.text, " ORDER BY {id}{}", order(filter));
    }
}

const fn order(filter: &JobFilter) -> &'static str {
    if filter.oldest_first { "" } else { " DESC" }
}

/// Writes the conditions of a filter on a job `j`; returns whether there are any that the source
/// does not fulfil by itself.
fn write_conditions<'a>(filter: &'a JobFilter, source: Source<'a>, text: &mut Text<'a>) -> bool {
    let begin = text.values.len();
    if source != Source::State {
        for (place, state) in filter.states.iter().enumerate() {
            let before = if place == 0 { " AND j.state IN (" } else { ", " };
            text.push(before, Value::Text(Some(state.name())));
        }
        if !filter.states.is_empty() {
            text.text.push(')');
        }
    }
    if let Some(since) = filter.since {
        text.push(" AND j.created_at >= ", Value::Number(Some(since.as_microsecond())));
    }
    if let Some(until) = filter.until {
        text.push(" AND j.created_at < ", Value::Number(Some(until.as_microsecond())));
    }
    if let Some(key) = filter.submitter.filter(|_| source != Source::Key) {
        text.push(" AND j.submitter = ", Value::Id(key.uuid()));
    }
    for label in filter.tags.iter().filter(|label| source != Source::Label(label)) {
        let (name, value) = label;
        text.push(
            " AND EXISTS (SELECT 1 FROM job_tags t WHERE t.job = j.id AND t.name = ",
            Value::Text(Some(name)),
        );
        text.push(" AND t.value = ", Value::Text(Some(value)));
        text.text.push(')');
    }
    text.values.len() > begin
}

/// Reads a page from a source. The second value is where the source was left, unless the page is
/// all that the filter asks for.
async fn page_from<C: Messages>(
    line: &mut C,
    source: Source<'_>,
    filter: &JobFilter,
) -> Result<(JobPage, Option<JobId>), StoreError> {
    let one_more = filter.limit.saturating_add(1);
    let mut conditions = Text::default();
    let is_filtered = write_conditions(filter, source, &mut conditions) && source != Source::Ids;
    let looked_up = if is_filtered { LOOKED_UP.max(one_more) } else { one_more };
    let mut query = Text::default();
    query.text.push_str(PAGE);
    query.text.push_str("SELECT j.id FROM (");
    source.write(filter, &mut query);
    let _ = write!(query.text, " LIMIT {looked_up}) d CROSS JOIN jobs j WHERE j.id = d.id");
    write_conditions(filter, source, &mut query);
    let order = order(filter);
    let _ = write!(query.text, " ORDER BY j.id{order} LIMIT {one_more}) ORDER BY j.id{order}");
    let mut message = C::part();
    message.push(&query.text, &query.values);
    let answers = line.send(message).await?;
    let rows = answers.iter().flatten().map(C::columns).collect::<Result<Vec<JobRow>, _>>()?;
    let is_full = rows.len() > filter.limit;
    let last = rows.get(filter.limit.saturating_sub(1)).map(|row| JobId::from(row.0));
    let jobs = rows.into_iter().take(filter.limit).filter_map(readable).collect();
    let page = JobPage { jobs, next: last.filter(|_| is_full) };
    if is_full || !is_filtered {
        return Ok((page, None));
    }
    let mut left = Text::default();
    source.write(filter, &mut left);
    let _ = write!(left.text, " LIMIT 1 OFFSET {}", looked_up - 1);
    let mut message = C::part();
    message.push(&left.text, &left.values);
    let answers = line.send(message).await?;
    let left = answers.iter().flatten().next().map(C::columns::<(Uuid,)>).transpose()?;
    Ok((page, left.map(|(id,)| JobId::from(id))))
}

/// Returns a page of jobs.
pub(super) async fn list<C: Messages>(
    line: &mut C,
    filter: &JobFilter,
) -> Result<JobPage, StoreError> {
    let mut page = JobPage { jobs: Vec::new(), next: None };
    for source in Source::all(filter) {
        let left;
        (page, left) = page_from(line, source, filter).await?;
        if left.is_none() {
            break;
        }
        page.next = left;
    }
    Ok(page)
}

/// Converts a row to a job; `None` and a line in the log where the row is damaged, so that a list
/// still shows its other rows.
fn readable(row: JobRow) -> Option<JobRecord> {
    let id = JobId::from(row.0);
    let record = job_record(row);
    if let Err(error) = &record {
        tracing::error!(job = %id, error = error as &dyn std::error::Error, "left out of a list");
    }
    record.ok()
}
