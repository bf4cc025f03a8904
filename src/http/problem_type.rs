//! The kinds of errors a client can meet. Their names are part of the API.

use axum::http::StatusCode;

macro_rules! problem_types {
    ($(
        $(#[$doc:meta])*
        $variant:ident, $name:literal, $status:ident, $title:literal, $explanation:literal;
    )*) => {
        /// A kind of error, told apart by its `type` URI `/problems/{name}`.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum ProblemType { $($(#[$doc])* $variant,)* }

        impl ProblemType {
            /// Every kind.
            pub const ALL: &'static [Self] = &[$(Self::$variant,)*];

            /// Stable name.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }

            /// HTTP status it is sent with.
            pub const fn status(self) -> StatusCode {
                match self { $(Self::$variant => StatusCode::$status,)* }
            }

            /// One line, the same for every occurrence.
            pub const fn title(self) -> &'static str {
                match self { $(Self::$variant => $title,)* }
            }

            /// What it means and what to do, for a person.
            pub const fn explanation(self) -> &'static str {
                match self { $(Self::$variant => $explanation,)* }
            }
        }
    };
}

problem_types! {
    /// The body is not JSON.
    InvalidJson, "invalid-json", BAD_REQUEST, "The body is not valid JSON",
        "The body could not be read as JSON. `line` and `column` say where. JSON knows no NaN, no \
         Infinity, no comments and no trailing commas.";
    /// The query string is wrong.
    InvalidQuery, "invalid-query", BAD_REQUEST, "The query string is not valid",
        "Query parameters are unknown or have values they cannot have. `errors` lists every one \
         by its name.";
    /// A header is wrong.
    InvalidHeader, "invalid-header", BAD_REQUEST, "A header is not valid",
        "A request header has a value it cannot have. `detail` names it.";
    /// The body is JSON but not a job.
    InvalidJob, "invalid-job", UNPROCESSABLE_ENTITY, "The job is not valid",
        "The body is JSON but not a job that can be solved. `errors` lists every field at fault \
         with its JSON pointer (RFC 6901) as a URI fragment.";
    /// A request for several jobs has a wrong form.
    InvalidBatch, "invalid-batch", UNPROCESSABLE_ENTITY,
        "The request for several jobs is not valid",
        "The body is JSON but not a list of jobs or of ids, so that nothing was done. `errors` \
         lists every member at fault with its JSON pointer. Jobs that are at fault themselves are \
         told apart, each in its place in the answer.";
    /// The job would need too much memory.
    JobTooLarge, "job-too-large", UNPROCESSABLE_ENTITY, "The job is too large",
        "The job is valid, but its estimated memory, or its estimated result, is above the limit \
         of this service. `estimate` has the number of equations, the bytes of memory and those \
         of the result, `limit_bytes` the limit. Ask for fewer elements_per_half_width, fewer \
         steps, or no fields.";
    /// No API key, or not a good one.
    Unauthorized, "unauthorized", UNAUTHORIZED, "An API key is required",
        "Send `Authorization: Bearer TOKEN` with the token that `brinell key create` printed.";
    /// The API key may not do this.
    Forbidden, "forbidden", FORBIDDEN, "The API key may not do this",
        "The scope of the API key does not allow this request.";
    /// A name that the service does not answer to.
    UnknownHost, "unknown-host", MISDIRECTED_REQUEST,
        "The service does not answer under this \
                                                       name",
        "The `Host` header names another service. One that listens on loopback answers to \
         localhost, 127.0.0.1 and [::1], and to the names given by `--allowed-host`.";
    /// No such address.
    NotFound, "not-found", NOT_FOUND, "There is nothing at this address",
        "No resource has this address.";
    /// No such job.
    JobNotFound, "job-not-found", NOT_FOUND, "There is no such job",
        "No job has this id, or it finished long ago and has been removed.";
    /// No such step.
    StepNotFound, "step-not-found", NOT_FOUND, "The result has no such step",
        "`?step=` counts the steps of a sweep from 1, and the result has fewer.";
    /// The address exists, the method does not.
    MethodNotAllowed, "method-not-allowed", METHOD_NOT_ALLOWED,
        "This address does not know this method",
        "The `Allow` header lists the methods this address knows.";
    /// The body did not arrive in time.
    BodyTimeout, "body-timeout", REQUEST_TIMEOUT, "The body did not arrive in time",
        "The request's body arrived too slowly.";
    /// The job has no result yet.
    JobUnfinished, "job-unfinished", CONFLICT, "The job has not finished",
        "The job is queued or running. Ask for /v1/jobs/{id}?wait=30 to wait for it.";
    /// The job will never have a result.
    NoResult, "no-result", CONFLICT, "The job has no result",
        "The job failed, or was stopped before there was anything to report. /v1/jobs/{id} tells \
         why.";
    /// The result lacks what this form shows.
    NotInResult, "not-in-result", CONFLICT, "The result does not have this",
        "The job was solved without this part of the output. Submit it again with `output.fields` \
         or `output.subsurface` set to true.";
    /// The head is too large.
    HeadTooLarge, "head-too-large", REQUEST_HEADER_FIELDS_TOO_LARGE,
        "The head of the request is too large",
        "The address and the headers of the request are above the limit of this service.";
    /// The body is too large.
    BodyTooLarge, "body-too-large", PAYLOAD_TOO_LARGE, "The body is too large",
        "The request's body is above the limit of this service and was not read.";
    /// The body is not declared as JSON.
    UnsupportedMediaType, "unsupported-media-type", UNSUPPORTED_MEDIA_TYPE,
        "The body must be JSON",
        "Send the job with the header `Content-Type: application/json`, compressed by gzip or not at \
         all.";
    /// The idempotency key came with another body.
    IdempotencyKeyReused, "idempotency-key-reused", UNPROCESSABLE_ENTITY,
        "The idempotency key was used before",
        "Another body was sent under this Idempotency-Key before. A key names one submission: use \
         a new one.";
    /// The queue is full.
    QueueFull, "queue-full", TOO_MANY_REQUESTS, "The queue is full",
        "As many jobs are waiting as may wait. Try again after the seconds in the `Retry-After` \
         header.";
    /// One key hands in too many jobs.
    TooManyJobs, "too-many-jobs", TOO_MANY_REQUESTS, "Too many jobs under one API key",
        "This API key hands in jobs faster than its share. Try again after the seconds in the \
         `Retry-After` header.";
    /// One key has as much as it may.
    QuotaExceeded, "quota-exceeded", TOO_MANY_REQUESTS, "The quota of the API key is used up",
        "This API key has as much of something as it may. `quota` names it: `queued_jobs`, \
         `stored_bytes` or `priority`. Try again after the seconds in the `Retry-After` header.";
    /// Too many event streams.
    TooManyStreams, "too-many-streams", SERVICE_UNAVAILABLE, "Too many event streams are open",
        "As many event streams are open as may be. Try again after the seconds in the \
         `Retry-After` header, or ask for /v1/jobs/{id}?wait=30.";
    /// Too many unfinished bodies.
    TooManyBodies, "too-many-bodies", SERVICE_UNAVAILABLE, "Too many bodies are arriving",
        "Bodies of other requests that have not arrived yet take all the room there is for them. \
         Try again after the seconds in the `Retry-After` header.";
    /// The solver gave up.
    SolveFailed, "solve-failed", INTERNAL_SERVER_ERROR, "The job could not be solved",
        "The job is valid, but the solver could not produce a result for it.";
    /// The program is at fault.
    Internal, "internal", INTERNAL_SERVER_ERROR, "The service is at fault",
        "A fault in the service. Its log has more, under the id in the `x-request-id` header or \
         the job's id.";
    /// The store does not answer.
    StoreUnavailable, "store-unavailable", SERVICE_UNAVAILABLE, "The job store does not answer",
        "The place where jobs are kept cannot be reached. Try again.";
    /// What is stored cannot be read.
    Damaged, "damaged-record", INTERNAL_SERVER_ERROR, "What is stored is damaged",
        "The row of the job, or the file of the store, cannot be read, and asking again does not \
         help. `brinell check` lists what is damaged; docs/operations.md tells how to restore a \
         backup.";
    /// The disk is full.
    InsufficientStorage, "insufficient-storage", INSUFFICIENT_STORAGE,
        "There is no room for another job",
        "The disk where jobs are kept is full, or has less room left than is reserved for the \
         jobs that are accepted already. Results can still be fetched. Try again after the \
         seconds in the `Retry-After` header, or remove jobs that are no longer needed.";
    /// The service is shutting down.
    ShuttingDown, "shutting-down", SERVICE_UNAVAILABLE, "The service is shutting down",
        "The service takes no new jobs because it is about to stop. Try again.";
}

impl ProblemType {
    /// The kind of that name.
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|kind| kind.name() == name)
    }

    /// The `type` member: a relative URI that this service answers.
    pub fn uri(self) -> String {
        format!("/problems/{}", self.name())
    }
}
