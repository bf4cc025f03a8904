//! Jobs behind their submission: identity, states, storage and the interface to the solver.
//!
//! ```text
//!             claim                    finish
//!   queued ─────────▶ running ─────────────────▶ succeeded | not_converged | failed
//!     │  ▲               │                        cancelled | timed_out
//!     │  └── lease lost ─┤
//!     │      or released ┘
//!     └── cancel ───────────────────────────────▶ cancelled
//! ```
//!
//! All code reaches the storage through [`JobStore`], which decides every transition. A worker
//! owns a running job by a [`Lease`]; the store rejects writes of a worker whose lease is lost.
//! [`JobNotifier`] notifies subscribers in this process that a job has changed. The HTTP layer
//! calls [`JobService`].

mod about;
mod attended;
mod callback;
mod clock;
mod closed_form;
mod deflate;
mod encode;
mod export;
mod failure;
mod fields;
mod id;
mod keys;
pub mod metrics;
mod notifier;
mod record;
mod result;
mod service;
mod solver;
mod state;
mod store;
mod trace;
mod turns;
mod words;

pub use about::About;
pub use attended::AttendedJob;
pub use callback::{Callback, CallbackState, Delivery, DeliveryEnd, DeliveryStore};
pub use clock::{Clock, SystemClock};
pub use closed_form::{ClosedForm, ClosedFormStep};
pub use deflate::{DeflateError, Deflated, GzipStream, UNPACKED_LIMIT};
pub use encode::{EncodeError, encode};
pub use export::{ExportFailure, Exported};
pub use failure::{FailureKind, JobFailure, Outcome};
pub use fields::FieldsReader;
pub use id::{JobId, KeyId, WorkerId};
pub use keys::{
    ApiKey, KeyLimits, KeyStore, OnceKey, PreviousSecret, Scope, new_secret, read_token,
};
pub use notifier::{JobNotifier, Signal, Subscription};
pub use record::{Idempotency, JobRecord, NewJob, NumberedIteration};
pub use result::{FIELDS_PART, FieldsPart, ResultHead, StepResult, take_fields};
pub use service::{
    JobService, POLL_INTERVAL, Rejection, Submission, SubmissionLimits, SubmitError,
};
pub use solver::{CoreSolver, JobSolver};
pub use state::JobState;
pub use store::{
    Claim, ClaimRequest, Claims, Counts, Enqueued, HISTORY_PAGE, JobFilter, JobPage, JobStore,
    Lease, LeaseStatus, Quota, Retention, SWEEP, StoreError,
};

pub use brinell_solver::job::{FieldError, JobError};
pub use brinell_solver::report::JobEstimate;
pub use brinell_solver::report::export::{Export, ExportError};
pub use brinell_solver::solver::IterationRecord;
pub use trace::{NotATrace, TraceParent};
pub use turns::{Threads, Turn, Turns};
pub use words::{label_of, words};
