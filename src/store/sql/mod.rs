//! Jobs in a database: [`SqlStore`] is the [`JobStore`] of every [`Backend`].
//!
//! Every change is one transaction. The change is announced after the commit: in this process, and
//! through the backend to other processes.

mod backend;
mod claiming;
mod codec;
mod deliveries;
mod delivery_store;
mod intake;
mod key_store;
mod keys;
mod leasing;
mod listing;
mod message;
mod reading;

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use async_trait::async_trait;
use bytes::Bytes;
use sqlx::types::Uuid;
use tokio::task::spawn_blocking;
use tokio::time::timeout;

use super::StoreLimits;
use crate::jobs::{
    ClaimRequest, Claims, Counts, Deflated, DeliveryStore, Enqueued, FIELDS_PART, FieldsPart,
    FieldsReader, IterationRecord, JobFilter, JobId, JobNotifier, JobPage, JobRecord, JobState,
    JobStore, KeyStore, Lease, LeaseStatus, NewJob, NumberedIteration, Outcome, ResultHead,
    Retention, StepResult, StoreError, Turn, WorkerId,
};
use backend::Durability::{self, Synced, Written};
pub(super) use backend::{Backend, Change, Reserved, WriteTransaction};
#[cfg(test)]
pub(super) use claiming::NEXT;
use claiming::Terms;
use codec::{count, unpack_records};
use deliveries::Deliveries;
use keys::Keys;
use leasing::ResultPart;
use message::Messages;
use reading::Reading;

/// SQLite's code for a full disk or a database at its largest size, and PostgreSQL's for a full
/// disk.
const DISK_FULL: [&str; 2] = ["13", "53100"];

/// SQLite's codes for a damaged file and for a file that is no database; PostgreSQL's codes for
/// damaged data and indices.
const DAMAGED: [&str; 7] = ["11", "26", "267", "523", "779", "XX001", "XX002"];

/// SQLite's code for a write that the operating system refused, also at the process's limit on the
/// size of a file.
const WRITE_REFUSED: &str = "778";

impl From<sqlx::Error> for StoreError {
    fn from(error: sqlx::Error) -> Self {
        let code = error.as_database_error().and_then(sqlx::error::DatabaseError::code);
        match code.as_deref() {
            Some(code) if DISK_FULL.contains(&code) || code == WRITE_REFUSED => Self::DiskFull,
            Some(code) if DAMAGED.contains(&code) => Self::damaged(error),
            _ => Self::unavailable(error),
        }
    }
}

/// Jobs that one transaction of a sweep removes, and bytes of their results: a result that is
/// larger is removed alone.
const SWEPT_AT_ONCE: usize = 20;
const SWEPT_BYTES: u64 = 8 << 20;

/// Jobs that one query of the damage check reads.
const CHECKED: i64 = 500;

/// A [`JobStore`] in a database.
pub(super) struct SqlStore<B> {
    pub(super) backend: B,
    pub(super) notifier: Arc<JobNotifier>,
    pub(super) limits: StoreLimits,
}

/// A backend whose connections execute all statements.
pub(super) trait SqlBackend: Backend<Connection: Statements> {}

impl<B: Backend<Connection: Statements>> SqlBackend for B {}

/// All statements that a connection executes, for either database.
pub(in crate::store) trait Statements:
    Messages + Reading + Keys + Deliveries
{
}

impl<T: Messages + Reading + Keys + Deliveries> Statements for T {}

impl<B: SqlBackend> SqlStore<B> {
    /// Reads all rows of a job.
    async fn check_job(&self, id: JobId) -> Result<(), StoreError> {
        self.get(id).await?;
        self.request(id).await?;
        let mut seen = 0;
        loop {
            match self.history(id, seen).await?.last() {
                None => break,
                Some(last) => seen = last.number + 1,
            }
        }
        self.callback(id).await?;
        let Some(head) = self.result(id).await? else { return Ok(()) };
        for step in 0..head.steps {
            self.step(id, step).await?.text().map_err(StoreError::damaged)?;
            if let Some(fields) = FieldsReader::open(self, id, step).await? {
                fields.check().await?;
            }
        }
        Ok(())
    }

    /// Commits a transaction and announces its changes. Every job that ends passes here; its
    /// webhook delivery becomes due in the same transaction.
    async fn commit(
        &self,
        mut transaction: B::Write,
        durability: Durability,
        changes: &[Change],
    ) -> Result<(), StoreError> {
        for change in changes {
            if let Change::Finished(id) = change {
                transaction.schedule_delivery(*id).await?;
            }
        }
        transaction.commit().await?;
        self.backend.announce(changes);
        if durability == Synced {
            self.backend.sync().await?;
        }
        for change in changes {
            change.announce(&self.notifier);
        }
        Ok(())
    }

    /// Announces changes that no transaction of this process has made.
    fn announce(&self, changes: &[Change]) {
        self.backend.announce(changes);
        for change in changes {
            change.announce(&self.notifier);
        }
    }

    /// Writes the results of steps, without counting them. Each part takes a connection of its own,
    /// so that a slow line holds none for longer than a part.
    async fn append_steps(&self, lease: &Lease, steps: &[StepResult]) -> Result<(), StoreError> {
        leasing::begin_steps(&mut *self.backend.statements().await?, lease, steps).await?;
        for step in steps {
            let fields = step.parts().map(|(first, part)| ResultPart::Fields(first, part));
            // Fields are found through the report, which is therefore the last part.
            for part in fields.chain([ResultPart::Report(step.report.packed())]) {
                let mut line = self.backend.statements().await?;
                leasing::append_part(&mut *line, lease, step.number, part).await?;
            }
        }
        Ok(())
    }

    /// Leases jobs as [`JobStore::claim`] describes.
    async fn claim_on(
        &self,
        line: &mut B::Connection,
        request: &ClaimRequest,
    ) -> Result<Claims, StoreError> {
        let now = self.backend.now();
        if request.expires {
            let ended = claiming::expire(line, request.max_attempts, now).await?;
            let changes: Vec<_> = ended.into_iter().map(Change::Finished).collect();
            self.announce(&changes);
        }
        let (mut claims, mut terms) = (Claims::default(), Terms::new(request, self.limits, now));
        loop {
            let places = request.places - claims.jobs.len();
            let leased = claiming::lease(line, places, &mut terms).await?;
            let is_stuck = leased.is_empty();
            claims.jobs.extend(leased);
            if claims.jobs.len() == request.places
                || (is_stuck && claims.large_pending)
                || !claiming::waits(line, &terms).await?
            {
                break;
            }
            if is_stuck {
                // A large job does not fit; small ones may pass it.
                claims.large_pending = true;
                terms.largest = request.memory_of_place;
            }
        }
        Ok(claims)
    }
}

#[async_trait]
impl<B: SqlBackend> JobStore for SqlStore<B> {
    async fn enqueue(&self, job: NewJob, turn: Turn) -> Result<Enqueued, StoreError> {
        let taken = self.enqueue_all(vec![job], turn).await?.pop();
        taken.unwrap_or_else(|| Err(StoreError::unavailable("nothing came of a submission")))
    }

    async fn enqueue_all(
        &self,
        jobs: Vec<NewJob>,
        turn: Turn,
    ) -> Result<Vec<Result<Enqueued, StoreError>>, StoreError> {
        self.backend.check_space().await?;
        let durability = if jobs.iter().all(|job| job.interactive) { Written } else { Synced };
        let (mut transaction, now) = self.backend.write().await?;
        let enqueued = intake::enqueue_all(&mut *transaction, jobs, self.limits, now).await?;
        // Submissions that arrive together share one sync.
        drop(turn);
        self.commit(transaction, durability, &[Change::Work]).await?;
        Ok(enqueued)
    }

    async fn get(&self, id: JobId) -> Result<JobRecord, StoreError> {
        self.backend.read().await?.find(id).await
    }

    async fn history(
        &self,
        id: JobId,
        after: usize,
    ) -> Result<Vec<NumberedIteration>, StoreError> {
        let page = Reading::history(&mut *self.backend.read().await?, id, after).await?;
        let unpacked = spawn_blocking(move || {
            let mut records = Vec::new();
            for (first, packed) in page {
                let numbered = (count(first)?..).zip(unpack_records(packed)?);
                records.extend(
                    numbered
                        .skip_while(|(number, _)| *number < after)
                        .map(|(number, record)| NumberedIteration { number, record }),
                );
            }
            Ok(records)
        });
        unpacked.await.map_err(StoreError::unavailable)?
    }

    async fn request(&self, id: JobId) -> Result<Bytes, StoreError> {
        Reading::request(&mut *self.backend.read().await?, id).await
    }

    async fn result(&self, id: JobId) -> Result<Option<ResultHead>, StoreError> {
        Reading::result(&mut *self.backend.read().await?, id).await
    }

    async fn step(&self, id: JobId, step: usize) -> Result<Deflated, StoreError> {
        Reading::step(&mut *self.backend.read().await?, id, step).await
    }

    async fn fields(
        &self,
        id: JobId,
        step: usize,
        at: usize,
    ) -> Result<Option<FieldsPart>, StoreError> {
        Reading::fields(&mut *self.backend.read().await?, id, step, at).await
    }

    async fn claim(&self, request: &ClaimRequest) -> Result<Claims, StoreError> {
        let mut line = self.backend.reserved(Reserved::Claims).await?;
        // A line that has died costs a worker the time of a lease without new jobs.
        let claims = timeout(request.lease, self.claim_on(&mut line, request));
        let claims = claims.await.map_err(StoreError::silent)??;
        self.backend.keep(line);
        for claim in &claims.jobs {
            self.announce(&[Change::Progress(claim.lease.job)]);
        }
        Ok(claims)
    }

    async fn give_back(&self, owner: WorkerId, known: &[JobId]) -> Result<(), StoreError> {
        let mut line = self.backend.reserved(Reserved::Claims).await?;
        leasing::give_back(&mut *line, owner, known).await?;
        self.backend.keep(line);
        Ok(())
    }

    async fn heartbeat(
        &self,
        leases: &[Lease],
        lease: Duration,
    ) -> Result<Vec<LeaseStatus>, StoreError> {
        let now = self.backend.now();
        let mut line = self.backend.reserved(Reserved::Heartbeats).await?;
        // A line that is silent for so long is given up while there is time for another.
        let beat = leasing::heartbeat(&mut *line, leases, lease, now);
        let statuses = timeout(lease / 3, beat).await.map_err(StoreError::silent)??;
        self.backend.keep(line);
        Ok(statuses)
    }

    async fn record_progress(
        &self,
        lease: &Lease,
        records: &[NumberedIteration],
        latest: &IterationRecord,
    ) -> Result<(), StoreError> {
        let mut line = self.backend.statements().await?;
        leasing::record_progress(&mut *line, lease, records, latest).await?;
        drop(line);
        self.announce(&[Change::Progress(lease.job)]);
        Ok(())
    }

    async fn record_steps(&self, lease: &Lease, steps: &[StepResult]) -> Result<(), StoreError> {
        self.append_steps(lease, steps).await?;
        leasing::count_steps(&mut *self.backend.statements().await?, lease, steps).await
    }

    async fn finish(
        &self,
        lease: &Lease,
        records: &[NumberedIteration],
        steps: &[StepResult],
        outcome: Outcome,
    ) -> Result<(), StoreError> {
        let bytes: usize = steps.iter().map(StepResult::bytes).sum();
        // What fits a part goes with the end of the job.
        let is_large = matches!(outcome, Outcome::Reported { .. }) && bytes > FIELDS_PART;
        if is_large {
            self.append_steps(lease, steps).await?;
        }
        let (mut line, now) = (self.backend.statements().await?, self.backend.now());
        leasing::finish(&mut *line, lease, records, steps, is_large, &outcome, now).await?;
        drop(line);
        self.backend.sync().await?;
        self.announce(&[Change::Finished(lease.job)]);
        Ok(())
    }

    async fn release(&self, leases: &[Lease]) -> Result<(), StoreError> {
        let (mut line, now) = (self.backend.statements().await?, self.backend.now());
        for lease in leases {
            let change = match leasing::release(&mut *line, lease, now).await? {
                Some(true) => Change::Finished(lease.job),
                Some(false) => Change::Progress(lease.job),
                None => continue,
            };
            self.announce(&[change, Change::Work]);
        }
        Ok(())
    }

    async fn cancel(&self, id: JobId) -> Result<JobRecord, StoreError> {
        let (mut transaction, now) = self.backend.write().await?;
        let record = intake::cancel(&mut *transaction, id, now).await?;
        let changes: &[Change] = match record.state {
            JobState::Running => &[Change::Cancel(id)],
            JobState::Cancelled => &[Change::Finished(id)],
            _ => &[],
        };
        self.commit(transaction, Synced, changes).await?;
        Ok(record)
    }

    async fn list(&self, filter: &JobFilter) -> Result<JobPage, StoreError> {
        listing::list(&mut *self.backend.read().await?, filter).await
    }

    async fn delete(&self, id: JobId) -> Result<(), StoreError> {
        let (mut transaction, _) = self.backend.write().await?;
        if intake::delete(&mut *transaction, &[id]).await? == 0 {
            let state = transaction.find(id).await?.state;
            // A job that has ended between the two statements may be removed by the next request.
            let is_running = state.is_finished();
            return Err(StoreError::Unfinished(if is_running {
                JobState::Running
            } else {
                state
            }));
        }
        self.commit(transaction, Synced, &[]).await
    }

    async fn counts(&self) -> Result<Counts, StoreError> {
        Reading::counts(&mut *self.backend.read().await?).await
    }

    async fn sweep(&self, retention: &Retention) -> Result<usize, StoreError> {
        let mut line = self.backend.read().await?;
        let mut jobs = intake::to_sweep(&mut *line, retention, self.backend.now()).await?;
        drop(line);
        // Submissions wait for one small transaction at most.
        let mut swept = 0;
        while let Some((first, mut bytes)) = jobs.pop() {
            let mut few = vec![first];
            while few.len() < SWEPT_AT_ONCE
                && let Some((job, more)) = jobs.pop_if(|(_, more)| bytes + *more <= SWEPT_BYTES)
            {
                bytes += more;
                few.push(job);
            }
            let (mut transaction, _) = self.backend.write().await?;
            swept += intake::delete(&mut *transaction, &few).await?;
            self.commit(transaction, Written, &[]).await?;
        }
        Ok(swept)
    }

    async fn check(&self, jobs: bool) -> Result<Vec<String>, StoreError> {
        let mut found = self.backend.check().await?;
        if !jobs {
            return Ok(found);
        }
        found.extend(self.backend.read().await?.check_tables().await?);
        match self.keys(None).await {
            Err(StoreError::Damaged(source)) => found.push(format!("API keys: {source}")),
            keys => drop(keys?),
        }
        let mut after = JobId::from(Uuid::nil());
        loop {
            let page = self.backend.read().await?.ids_after(after, CHECKED).await?;
            let Some(last) = page.last() else { return Ok(found) };
            after = *last;
            for id in page {
                match self.check_job(id).await {
                    Ok(()) => {}
                    Err(StoreError::NotFound) => match self.get(id).await {
                        // The job was removed meanwhile.
                        Err(StoreError::NotFound) => {}
                        _ => found.push(format!("job {id}: a part of it is missing")),
                    },
                    Err(StoreError::Damaged(source)) => found.push(format!("job {id}: {source}")),
                    Err(error) => return Err(error),
                }
            }
        }
    }

    async fn backup(&self, file: &Path) -> Result<bool, StoreError> {
        self.backend.backup(file).await
    }

    async fn ping(&self) -> Result<(), StoreError> {
        self.backend.check_space().await?;
        let (mut transaction, now) = self.backend.write().await?;
        intake::record_health(&mut *transaction, now).await?;
        self.commit(transaction, Synced, &[]).await
    }

    async fn sync(&self) -> Result<(), StoreError> {
        self.backend.sync().await
    }

    async fn close(&self) {
        self.backend.close().await;
    }
}
