//! Parser of query strings; it reports all faulty parameters at once. An unknown parameter is an
//! error.

use std::fmt;
use std::str::FromStr;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::{FromRequestParts, MatchedPath, Query, Request, State};
use axum::http::Method;
use axum::http::request::Parts;
use axum::middleware::Next;
use axum::response::Response;
use brinell_solver::job::{FaultCode, Named};
use brinell_solver::report::{FIELD_NAMES, LAYER_NAMES};
use jiff::Timestamp;
use strum::{IntoStaticStr, VariantArray};
use utoipa::openapi::path::{Parameter, ParameterIn};
use utoipa::openapi::{HttpMethod, Paths, RefOr};

use super::HttpState;
use super::openapi::named;
use super::parameters::{Parameters, parameters};
use super::preference::preferred_wait;
use super::problem::{Fault, Problem};
use super::problem_type::ProblemType;
use crate::jobs::{JobFilter, JobId, JobState, label_of, words};

/// Default and largest number of jobs on a page.
const PAGE: usize = 20;
const MAX_PAGE: usize = 100;

/// Most states and labels that a list is filtered by.
const MAX_STATES: usize = JobState::ALL.len();
const MAX_TAGS: usize = 8;

/// Longest text of a search \[bytes\].
const MAX_SEARCH: usize = 200;

/// Orders of a list.
const ORDERS: [&str; 2] = ["newest", "oldest"];

/// Description of the format of a time.
const MOMENT: &str = "a time such as 2027-01-31T12:00:00Z";

/// Bounds of `?priority=`.
pub(super) const MAX_PRIORITY: i16 = 100;

/// Fewest points that stresses over depth can be thinned to.
const MIN_DEPTHS: usize = 2;

/// Most faults reported for one query string.
const MAX_FAULTS: usize = 50;

/// Parses a whole number without a sign; a number beyond the type becomes its largest value.
struct Whole(usize);

impl FromStr for Whole {
    type Err = fmt::Error;

    fn from_str(text: &str) -> Result<Self, fmt::Error> {
        let is_number = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        is_number.then(|| Self(text.parse().unwrap_or(usize::MAX))).ok_or(fmt::Error)
    }
}

/// Shortens a client's text for an error message.
fn shown(text: &str) -> String {
    text.chars().take(40).collect()
}

/// The words of `?fields=`.
fn words_for_parts() -> Vec<(&'static str, Option<StepPart>)> {
    let named = StepPart::ALL.iter().map(|part| (part.name(), Some(*part)));
    std::iter::once(("summary", None)).chain(named).collect()
}

/// The pattern of a list that [`Reader::words`] reads.
fn list_of<T>(known: &[(&str, T)]) -> String {
    let word = known.iter().map(|(name, _)| *name).collect::<Vec<_>>().join("|");
    format!("^({word})(,({word}))*$")
}

/// The parameters of a query string and their faults.
struct Reader {
    pairs: Vec<(String, String)>,
    faults: Vec<Fault>,
}

impl Reader {
    /// Splits the query string and reports every unknown parameter.
    async fn new(parts: &mut Parts, state: &HttpState, known: &[&str]) -> Self {
        let pairs = Query::<Vec<(String, String)>>::from_request_parts(parts, state).await;
        let (pairs, mut faults) = if let Ok(Query(pairs)) = pairs {
            (pairs, Vec::new())
        } else {
            let detail = "the query string is not URL-encoded text";
            (Vec::new(), vec![Fault::parameter("", FaultCode::WrongType, detail)])
        };
        for (name, _) in &pairs {
            if !known.contains(&name.as_str()) {
                let shown = shown(name);
                let expected = match known {
                    [] => "expected none".to_owned(),
                    known => format!("expected one of: {}", known.join(", ")),
                };
                let detail = format!("unknown parameter {shown:?}; {expected}");
                faults.push(Fault::parameter(&shown, FaultCode::UnknownKey, detail));
            }
            // A short query is not answered by a long list.
            if faults.len() >= MAX_FAULTS {
                break;
            }
        }
        Self { pairs, faults }
    }

    /// Returns the text of a parameter, which may be given once.
    fn text(&mut self, name: &str) -> Option<String> {
        let mut given =
            self.pairs.iter().filter(|(key, _)| key == name).map(|(_, value)| value.clone());
        let text = given.next();
        if given.next().is_some() {
            self.fault(name, FaultCode::DuplicateKey, "must be given once");
        }
        text
    }

    /// Parses a parameter that satisfies `accept`; reports `expected` otherwise.
    fn value<T: FromStr>(
        &mut self,
        name: &str,
        expected: &str,
        accept: impl Fn(&T) -> bool,
    ) -> Option<T> {
        let text = self.text(name)?;
        self.read(name, &text, expected, &accept)
    }

    fn read<T: FromStr>(
        &mut self,
        name: &str,
        text: &str,
        expected: &str,
        accept: &impl Fn(&T) -> bool,
    ) -> Option<T> {
        let value = text.parse().ok().filter(accept);
        if value.is_none() {
            let detail = format!("must be {expected}, got {:?}", shown(text));
            self.fault(name, FaultCode::OutOfRange, detail);
        }
        value
    }

    /// The values of a parameter that may be given several times.
    fn values<T: FromStr>(
        &mut self,
        name: &str,
        most: usize,
        expected: &str,
        accept: impl Fn(&T) -> bool,
    ) -> Vec<T> {
        let given: Vec<String> = self
            .pairs
            .iter()
            .filter(|(key, _)| key == name)
            .map(|(_, value)| value.clone())
            .collect();
        if given.len() > most {
            self.fault(name, FaultCode::OutOfRange, format!("may be given {most} times"));
            return Vec::new();
        }
        given.iter().filter_map(|text| self.read(name, text, expected, &accept)).collect()
    }

    /// The words of a list, separated by commas, each the name of one that is known.
    fn words<T: Copy>(&mut self, name: &str, known: &[(&'static str, T)]) -> Option<Vec<T>> {
        let text = self.text(name)?;
        let mut found = Vec::new();
        for word in text.split(',') {
            if let Some((_, one)) = known.iter().find(|(name, _)| *name == word) {
                found.push(*one);
            } else {
                let known: Vec<_> = known.iter().map(|(name, _)| *name).collect();
                let detail = format!("must be among: {}; got {:?}", known.join(", "), shown(word));
                self.fault(name, FaultCode::UnknownWord, detail);
            }
        }
        Some(found)
    }

    fn fault(&mut self, name: &str, code: FaultCode, detail: impl Into<String>) {
        if self.faults.len() < MAX_FAULTS {
            self.faults.push(Fault::parameter(name, code, detail));
        }
    }

    /// Returns the parsed value unless there are faults.
    fn finish<T>(self, read: T) -> Result<T, Problem> {
        if self.faults.is_empty() {
            return Ok(read);
        }
        let count = self.faults.len();
        let least = if count == MAX_FAULTS { "at least " } else { "" };
        let detail =
            format!("{least}{count} parameter{} at fault", if count == 1 { "" } else { "s" });
        Err(Problem::new(ProblemType::InvalidQuery, detail).with_faults(self.faults))
    }

    /// `?wait=`, or the `Prefer` header without one.
    fn wait(&mut self, parts: &Parts, limit: Duration) -> Option<Granted> {
        let seconds = self.value("wait", "a number of seconds, 0 or greater", |seconds: &f64| {
            seconds.is_finite() && *seconds >= 0.0
        });
        let by_query = seconds.map(|seconds| Granted {
            timeout: Duration::from_secs_f64(seconds.min(limit.as_secs_f64())),
            preferred: false,
        });
        by_query.or_else(|| {
            let timeout = Duration::from_secs(preferred_wait(&parts.headers)?).min(limit);
            Some(Granted { timeout, preferred: true })
        })
    }
}

/// The layer that refuses every parameter of an operation under `/v1` that declares none. The
/// others read theirs themselves.
pub(super) async fn refuse_undeclared(
    State((state, declared)): State<(HttpState, Arc<Paths>)>,
    request: Request,
    next: Next,
) -> Result<Response, Problem> {
    let (mut parts, body) = request.into_parts();
    if takes_no_query(&parts, &declared) {
        Reader::new(&mut parts, &state, &[]).await.finish(())?;
    }
    Ok(next.run(Request::from_parts(parts, body)).await)
}

fn takes_no_query(parts: &Parts, declared: &Paths) -> bool {
    let method = match parts.method {
        Method::GET | Method::HEAD => HttpMethod::Get,
        Method::POST => HttpMethod::Post,
        Method::DELETE => HttpMethod::Delete,
        _ => return false,
    };
    let path = parts.extensions.get::<MatchedPath>().map(MatchedPath::as_str);
    let path = path.filter(|path| path.starts_with("/v1/"));
    let operation = path.and_then(|path| declared.get_path_operation(path, method));
    let is_in_query = |parameter: &RefOr<Parameter>| matches!(parameter, RefOr::T(parameter) if parameter.parameter_in == ParameterIn::Query);
    operation.is_some_and(|found| !found.parameters.iter().flatten().any(is_in_query))
}

/// A granted wait.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Granted {
    /// Its duration, at most the service's limit.
    pub(super) timeout: Duration,
    /// Whether `Prefer` asked for it; `Preference-Applied` then reports it.
    pub(super) preferred: bool,
}

parameters! { "query", Wait {
    /// Wait so many seconds for the job to finish, fractions allowed, cut at the service's limit.
    /// Goes before `Prefer: wait=N`.
    "wait": {"type": "number", "format": "double", "minimum": 0}, 30;
    /// The large parts of each step that are wanted of the result inside, as of `GET
    /// /v1/jobs/{id}/result`; `summary` is none of them.
    "fields": {"type": "string", "pattern": list_of(&words_for_parts())}, "summary";
}}

/// `?wait=` or `Prefer: wait=`, and `?fields=` of the result that the answer may hold.
#[derive(Debug, Clone)]
pub(super) struct Wait {
    pub(super) granted: Option<Granted>,
    pub(super) selection: Selection,
}

impl FromRequestParts<HttpState> for Wait {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let mut query = Reader::new(parts, state, Self::NAMES).await;
        let granted = query.wait(parts, state.settings.wait_limit);
        let selection = Selection { parts: query.parts(), ..Selection::default() };
        query.finish(Self { granted, selection })
    }
}

parameters! { "query", SubmitQuery {
    /// Larger goes first; 0 is ordinary.
    "priority": {
        "type": "integer", "format": "int32", "minimum": -MAX_PRIORITY, "maximum": MAX_PRIORITY
    };
    /// Where to POST an announcement when the job is done, signed; at hosts that the service may
    /// call (docs/webhooks.md). `callback` of the job tells how far that has come.
    "callback_url": {"type": "string", "maxLength": 2000}, "https://hooks.example/brinell";
}}

/// Parameters of a submission: priority, wait for the result, and URL of the announcement.
#[derive(Debug, Clone)]
pub(super) struct SubmitQuery {
    pub(super) priority: i16,
    pub(super) wait: Option<Granted>,
    pub(super) selection: Selection,
    pub(super) callback_url: Option<String>,
}

impl FromRequestParts<HttpState> for SubmitQuery {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        // In the order in which an error names them.
        let known = [&Self::NAMES[..1], Wait::NAMES, &Self::NAMES[1..]].concat();
        let mut query = Reader::new(parts, state, &known).await;
        let range = -MAX_PRIORITY..=MAX_PRIORITY;
        let expected = format!("a whole number between -{MAX_PRIORITY} and {MAX_PRIORITY}");
        let priority =
            query.value("priority", &expected, |priority| range.contains(priority)).unwrap_or(0);
        let wait = query.wait(parts, state.settings.wait_limit);
        let selection = Selection { parts: query.parts(), ..Selection::default() };
        let callback_url = query.text("callback_url");
        if let Some(Err(detail)) = callback_url.as_deref().map(|url| state.callbacks.check(url)) {
            query.fault("callback_url", FaultCode::OutOfRange, detail);
        }
        query.finish(Self { priority, wait, selection, callback_url })
    }
}

parameters! { "query", Step {
    /// Which step of a sweep, counted from 1; the last one unless it is given.
    "step": {"type": "integer", "minimum": 1};
}}

/// The `?step=` of an export: counted from 1 in the URL, from 0 here.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step(pub(super) Option<usize>);

impl Reader {
    fn step(&mut self) -> Option<usize> {
        let step = self.value("step", "a whole number, 1 or greater", |Whole(step)| *step >= 1);
        step.map(|Whole(step)| step - 1)
    }

    /// `?fields=`: the large parts that are named; `summary` names none.
    fn parts(&mut self) -> Option<Vec<StepPart>> {
        Some(self.words("fields", &words_for_parts())?.into_iter().flatten().collect())
    }
}

impl FromRequestParts<HttpState> for Step {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let mut query = Reader::new(parts, state, Self::NAMES).await;
        let step = query.step();
        query.finish(Self(step))
    }
}

/// The large parts of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "snake_case")]
pub(super) enum StepPart {
    /// Values at the pairs of nodes.
    Contact,
    /// Stresses over depth.
    Subsurface,
    /// Outlines of the plastic zones.
    Plasticity,
    /// Mesh and nodal fields, or the layers of half-spaces.
    Fields,
    /// Pressure and gap of all cells in three dimensions.
    Maps,
    /// Every iteration.
    History,
}

impl Named for StepPart {}

parameters! { "query", Selection {
    /// The large parts of a step that are wanted, separated by commas: `contact`
    /// (`contact.nodes`), `subsurface`, `plasticity` (`outline`), `fields` (with `layers`),
    /// `maps`, `history`; `summary` is none of them. The others are left out, or empty where the
    /// schema requires them; single figures always stay. Everything, unless it is given.
    "fields": {"type": "string", "pattern": list_of(&words_for_parts())}, "contact,subsurface";
    /// Only this step of a sweep, counted from 1.
    "step": {"type": "integer", "minimum": 1};
    /// Stresses over depth at so many depths at most, from the surface to the support, among them
    /// those of the largest shear and von Mises stress.
    "subsurface_points": {"type": "integer", "minimum": MIN_DEPTHS};
}}

/// The part of a result that is wanted; everything, unless something else is said.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Selection {
    /// `None` is every part.
    pub(super) parts: Option<Vec<StepPart>>,
    /// Counted from 0.
    pub(super) step: Option<usize>,
    /// Most depths below the surface.
    pub(super) depths: Option<usize>,
}

impl Selection {
    /// Whether mesh and nodal fields are wanted.
    pub(super) fn has_fields(&self) -> bool {
        self.wants(StepPart::Fields)
    }

    fn wants(&self, part: StepPart) -> bool {
        self.parts.as_ref().is_none_or(|parts| parts.contains(&part))
    }

    /// Returns whether a stored step must be rewritten for the answer.
    pub(super) fn edits_steps(&self) -> bool {
        self.depths.is_some() || !StepPart::ALL.iter().all(|part| self.wants(*part))
    }

    /// What it is called in the tag of an answer.
    pub(super) fn name(&self) -> String {
        let step = self.step.map_or_else(|| "all".to_owned(), |step| (step + 1).to_string());
        let parts = StepPart::ALL.iter().filter(|part| self.wants(**part)).map(|part| part.name());
        let depths = self.depths.map(|depths| format!("-{depths}")).unwrap_or_default();
        format!("{step}-{}{depths}", parts.collect::<Vec<_>>().join("+"))
    }
}

impl FromRequestParts<HttpState> for Selection {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let mut query = Reader::new(parts, state, Self::NAMES).await;
        let wanted = query.parts();
        let step = query.step();
        let expected = format!("a whole number, {MIN_DEPTHS} or greater");
        let depths =
            query.value("subsurface_points", &expected, |Whole(count)| *count >= MIN_DEPTHS);
        query.finish(Self { parts: wanted, step, depths: depths.map(|Whole(count)| count) })
    }
}

/// The words of `?arrays=`: arrays of meshes and of layers.
fn words_for_arrays() -> Vec<(&'static str, &'static str)> {
    let of_layers = LAYER_NAMES.into_iter().filter(|name| !FIELD_NAMES.contains(name));
    FIELD_NAMES.into_iter().chain(of_layers).map(|name| (name, name)).collect()
}

parameters! { "query", Arrays {
    /// The arrays that are wanted, by their names, separated by commas: those of a mesh, or of
    /// layers in three dimensions. What the result does not have is left out, if it has any of
    /// them. Everything, unless it is given.
    "arrays": {"type": "string", "pattern": list_of(&words_for_arrays())},
        "nodes,elements,displacement,von_mises";
}}

/// The `?arrays=` of the fields of a step; `None` is every array.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Arrays(pub(super) Option<Vec<&'static str>>);

impl Arrays {
    /// What it is called in the tag of an answer.
    pub(super) fn name(&self) -> String {
        let Some(names) = &self.0 else { return String::new() };
        let words = words_for_arrays().into_iter().map(|(name, _)| name);
        let wanted: Vec<_> = words.filter(|name| names.contains(name)).collect();
        format!("-{}", wanted.join("+"))
    }
}

impl FromRequestParts<HttpState> for Arrays {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let mut query = Reader::new(parts, state, Self::NAMES).await;
        let names = query.words("arrays", &words_for_arrays());
        query.finish(Self(names))
    }
}

parameters! { "query", ListFilter {
    /// Only jobs in this state; several times for one of several.
    "status": {"type": "array", "maxItems": MAX_STATES, "items": named("JobState")};
    /// Only jobs with this label, `name:value`; several times for all of several.
    "tag": {"type": "array", "maxItems": MAX_TAGS, "items": {"type": "string"}},
        ["bearing:NU-210"];
    /// Only jobs with all of these words in their title or the values of their labels, or in the
    /// kinds of their shapes and materials; in lower or upper case, whole words. Jobs taken in
    /// before version 0.3 are not found.
    "search": {"type": "string", "maxLength": MAX_SEARCH}, "hardened roller";
    /// Only the job of this id; several times for several, in the order of the list.
    "id": {"type": "array", "maxItems": MAX_PAGE, "items": named("JobId")};
    /// Only jobs accepted at this time or later, `2027-01-31T12:00:00Z`.
    "since": {"type": "string", "format": "date-time"};
    /// Only jobs accepted before this time.
    "until": {"type": "string", "format": "date-time"};
    /// Order of the list; the newest first unless it is given.
    "sort": {"type": "string", "enum": ORDERS, "description": "Order of a list."};
    /// Most jobs on the page; 20 unless it is given.
    "limit": {"type": "integer", "minimum": 1, "maximum": MAX_PAGE};
    /// The `next_cursor` of the page before.
    "cursor": {"type": "string", "format": "uuid"};
}}

/// The jobs of a list.
#[derive(Debug, Clone)]
pub(super) struct ListFilter(pub(super) JobFilter);

/// A state by its name.
struct NamedState(JobState);

impl FromStr for NamedState {
    type Err = fmt::Error;

    fn from_str(text: &str) -> Result<Self, fmt::Error> {
        JobState::of_word(text).map(Self).ok_or(fmt::Error)
    }
}

impl FromRequestParts<HttpState> for ListFilter {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let mut query = Reader::new(parts, state, Self::NAMES).await;
        let states =
            query.values("status", MAX_STATES, "the state of a job", |_: &NamedState| true);
        // PostgreSQL has no texts with a NUL, and no job has such a tag.
        let is_tag = |tag: &String| tag.contains(':') && !tag.contains('\0');
        let tags = query.values("tag", MAX_TAGS, "name:value", is_tag);
        let pair = |tag: &String| {
            tag.split_once(':').map(|(name, value)| (name.to_owned(), value.to_owned()))
        };
        let search = query.value("search", "up to 8 words", |text: &String| {
            text.len() <= MAX_SEARCH && words(text).count() <= MAX_TAGS
        });
        let words = search.iter().flat_map(|text| words(text)).map(|word| label_of(&word));
        let expected = format!("a whole number between 1 and {MAX_PAGE}");
        let ids = query.values("id", MAX_PAGE, "the id of a job", |_: &JobId| true);
        let since = query.value("since", MOMENT, |_: &Timestamp| true);
        let until = query.value("until", MOMENT, |_: &Timestamp| true);
        let order = query.value("sort", &ORDERS.join(" or "), |order: &String| {
            ORDERS.contains(&order.as_str())
        });
        let limit = query.value("limit", &expected, |limit| (1..=MAX_PAGE).contains(limit));
        let cursor = query.value("cursor", "the next_cursor of a page", |_: &JobId| true);
        // A list of ids is answered on one page.
        let page = if ids.is_empty() { PAGE } else { MAX_PAGE };
        query.finish(Self(JobFilter {
            states: states.into_iter().map(|NamedState(state)| state).collect(),
            tags: tags.iter().filter_map(pair).chain(words).collect(),
            ids,
            since,
            until,
            submitter: None,
            oldest_first: order.as_deref() == Some("oldest"),
            cursor,
            limit: limit.unwrap_or(page),
        }))
    }
}
