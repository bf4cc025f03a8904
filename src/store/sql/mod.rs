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
mod reading;

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use async_trait::async_trait;
use bytes::Bytes;
use sqlx::types::Uuid;
use tokio::task::spawn_blocking;

use super::StoreLimits;
use crate::jobs::{
    Claim, ClaimRequest, Claims, Counts, Deflated, DeliveryStore, Enqueued, FieldsPart,
    FieldsReader, IterationRecord, JobFilter, JobId, JobNotifier, JobPage, JobRecord, JobState,
    JobStore, KeyStore, Lease, LeaseStatus, NewJob, Outcome, ResultHead, Retention, StepResult,
    StoreError, Turn, WorkerId,
};
use backend::Durability::{self, Synced, Written};
pub(super) use backend::{Backend, Change, WriteTransaction};
#[cfg(test)]
pub(super) use claiming::NEXT;
use claiming::{Claiming, LeasedRow, Terms, Which};
use codec::{count, unpack_records};
use deliveries::Deliveries;
use intake::{Intake, Savepoint};
use keys::Keys;
use leasing::Leasing;
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

/// Jobs that one query of the damage check reads.
const CHECKED: i64 = 500;

/// A [`JobStore`] in a database.
pub(super) struct SqlStore<B> {
    pub(super) backend: B,
    pub(super) notifier: Arc<JobNotifier>,
    pub(super) limits: StoreLimits,
}

/// Makes a claim of what the store has leased.
fn claim_of(
    (id, memory, attempt, trace): LeasedRow,
    owner: WorkerId,
    exclusive: bool,
    request: Bytes,
) -> Result<Claim, StoreError> {
    Ok(Claim {
        lease: Lease { job: JobId::from(id), owner, attempt: count(attempt)? },
        exclusive,
        memory: count(memory)?,
        request,
        trace: trace.and_then(|text| text.parse().ok()),
    })
}

/// Leases a job and reads its text.
async fn take(
    line: &mut impl Statements,
    which: Which,
    terms: &mut Terms,
    request: &ClaimRequest,
    now: Option<i64>,
) -> Result<Option<Claim>, StoreError> {
    let Some(leased) = line.lease(which, terms, now).await? else { return Ok(None) };
    let memory: u64 = count(leased.1)?;
    if memory > request.memory_of_place {
        terms.shared = terms.shared.saturating_sub(memory);
    }
    let text = line.begin(&leased).await?;
    claim_of(leased, request.owner, which == Which::LastChance, text).map(Some)
}

/// A backend whose connections execute all statements.
pub(super) trait SqlBackend: Backend<Connection: Statements> {}

impl<B: Backend<Connection: Statements>> SqlBackend for B {}

/// All statements that a connection executes, for either database.
pub(in crate::store) trait Statements:
    Reading + Intake + Claiming + Leasing + Keys + Deliveries
{
}

impl<T: Reading + Intake + Claiming + Leasing + Keys + Deliveries> Statements for T {}

impl<B: SqlBackend> SqlStore<B> {
    /// Reads all rows of a job.
    async fn check_job(&self, id: JobId) -> Result<(), StoreError> {
        self.get(id).await?;
        self.request(id).await?;
        let mut seen = 0;
        loop {
            match self.history(id, seen).await?.len() {
                0 => break,
                page => seen += page,
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

    /// Queues the jobs again whose worker is lost, or ends them.
    async fn expire(&self, max_attempts: u32) -> Result<(), StoreError> {
        let (mut transaction, now) = self.backend.write().await?;
        let ended = Claiming::expire(&mut *transaction, max_attempts, now).await?;
        for job in &ended {
            transaction.forget_steps(*job).await?;
        }
        let changes: Vec<Change> = ended.into_iter().map(Change::Finished).collect();
        self.commit(transaction, Written, &changes).await
    }
}

#[async_trait]
impl<B: SqlBackend> JobStore for SqlStore<B> {
    async fn enqueue(&self, job: NewJob, turn: Turn) -> Result<Enqueued, StoreError> {
        self.backend.check_space().await?;
        let durability = if job.interactive { Written } else { Synced };
        let (mut transaction, now) = self.backend.write().await?;
        let enqueued = Intake::enqueue(&mut *transaction, job, self.limits, now).await?;
        // Submissions that arrive together share one sync.
        drop(turn);
        self.commit(transaction, durability, &[Change::Work]).await?;
        Ok(enqueued)
    }

    async fn enqueue_all(
        &self,
        jobs: Vec<NewJob>,
        turn: Turn,
    ) -> Result<Vec<Result<Enqueued, StoreError>>, StoreError> {
        self.backend.check_space().await?;
        let durability = if jobs.iter().all(|job| job.interactive) { Written } else { Synced };
        let (mut transaction, now) = self.backend.write().await?;
        let mut enqueued = Vec::with_capacity(jobs.len());
        for job in jobs {
            transaction.savepoint(Savepoint::Set).await?;
            let taken = Intake::enqueue(&mut *transaction, job, self.limits, now).await;
            match &taken {
                Ok(_) => transaction.savepoint(Savepoint::Release).await?,
                Err(error) if error.is_of_storage() => return taken.map(|taken| vec![Ok(taken)]),
                Err(_) => transaction.savepoint(Savepoint::RollBack).await?,
            }
            enqueued.push(taken);
        }
        self.commit(transaction, durability, &[Change::Work]).await?;
        drop(turn);
        Ok(enqueued)
    }

    async fn get(&self, id: JobId) -> Result<JobRecord, StoreError> {
        self.backend.read().await?.find(id).await
    }

    async fn history(&self, id: JobId, after: usize) -> Result<Vec<IterationRecord>, StoreError> {
        let page = Reading::history(&mut *self.backend.read().await?, id, after).await?;
        let unpacked = spawn_blocking(move || {
            let mut records = Vec::new();
            for (first, packed) in page {
                let seen = after.saturating_sub(count(first)?);
                records.extend(unpack_records(packed)?.into_iter().skip(seen));
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
        let now = self.backend.now();
        let (expired, lost) = self.backend.read().await?.look(now).await?;
        if expired && request.expires {
            self.expire(request.max_attempts).await?;
        }
        let mut line = self.backend.statements().await?;
        let (mut claims, mut terms) = (Claims::default(), Terms::new(request, self.limits));
        if expired || lost {
            if request.exclusive {
                terms.shared = request.memory;
                claims
                    .jobs
                    .extend(take(&mut *line, Which::LastChance, &mut terms, request, now).await?);
            } else {
                claims.exclusive_pending = line.is_pending(Which::LastChance, &terms, now).await?;
            }
            terms.shared = request.free_memory;
        }
        let is_alone = claims.jobs.iter().any(|claim| claim.exclusive);
        while !is_alone && claims.jobs.len() < request.places {
            let taken = match take(&mut *line, Which::Next, &mut terms, request, now).await {
                Ok(None) if !claims.large_pending => {
                    let pending = line.is_pending(Which::Next, &terms, now).await;
                    claims.large_pending = matches!(pending, Ok(true));
                    if claims.large_pending {
                        terms.largest = request.memory_of_place;
                        continue;
                    }
                    pending.map(|_| None)
                }
                taken => taken,
            };
            match taken {
                Ok(Some(claim)) => claims.jobs.push(claim),
                Ok(None) => break,
                Err(error) if claims.jobs.is_empty() => return Err(error),
                // The jobs that are leased must run.
                Err(error) => {
                    let error = &error as &dyn std::error::Error;
                    tracing::warn!(error, "no further job can be claimed");
                    break;
                }
            }
        }
        drop(line);
        for claim in &claims.jobs {
            self.announce(&[Change::Progress(claim.lease.job)]);
        }
        Ok(claims)
    }

    async fn heartbeat(
        &self,
        leases: &[Lease],
        lease: Duration,
    ) -> Result<Vec<LeaseStatus>, StoreError> {
        let now = self.backend.now();
        Leasing::heartbeat(&mut *self.backend.statements().await?, leases, lease, now).await
    }

    async fn record_progress(
        &self,
        lease: &Lease,
        records: &[IterationRecord],
        latest: &IterationRecord,
    ) -> Result<(), StoreError> {
        let mut line = self.backend.statements().await?;
        Leasing::record_progress(&mut *line, lease, records, latest).await?;
        drop(line);
        self.announce(&[Change::Progress(lease.job)]);
        Ok(())
    }

    async fn record_steps(&self, lease: &Lease, steps: &[StepResult]) -> Result<(), StoreError> {
        let mut line = self.backend.statements().await?;
        line.append_steps(lease, steps).await?;
        line.count_steps(lease, steps).await
    }

    async fn finish(
        &self,
        lease: &Lease,
        records: &[IterationRecord],
        steps: &[StepResult],
        outcome: Outcome,
    ) -> Result<(), StoreError> {
        let mut line = self.backend.statements().await?;
        line.append_records(lease, records).await?;
        if matches!(outcome, Outcome::Reported { .. }) {
            line.append_steps(lease, steps).await?;
        }
        drop(line);
        let (mut transaction, now) = self.backend.write().await?;
        Leasing::finish(&mut *transaction, lease, records, steps, &outcome, now).await?;
        self.commit(transaction, Synced, &[Change::Finished(lease.job)]).await
    }

    async fn release(&self, leases: &[Lease]) -> Result<(), StoreError> {
        let (mut transaction, now) = self.backend.write().await?;
        let mut changes = vec![Change::Work];
        for lease in leases {
            match Leasing::release(&mut *transaction, lease, now).await? {
                Some(true) => changes.push(Change::Finished(lease.job)),
                Some(false) => changes.push(Change::Progress(lease.job)),
                None => {}
            }
        }
        self.commit(transaction, Written, &changes).await
    }

    async fn cancel(&self, id: JobId) -> Result<JobRecord, StoreError> {
        let (mut transaction, now) = self.backend.write().await?;
        let record = Intake::cancel(&mut *transaction, id, now).await?;
        let changes: &[Change] = match record.state {
            JobState::Running => &[Change::Cancel(id)],
            JobState::Cancelled => &[Change::Finished(id)],
            _ => &[],
        };
        self.commit(transaction, Synced, changes).await?;
        Ok(record)
    }

    async fn list(&self, filter: &JobFilter) -> Result<JobPage, StoreError> {
        Reading::list(&mut *self.backend.read().await?, filter).await
    }

    async fn delete(&self, id: JobId) -> Result<(), StoreError> {
        let (mut transaction, _) = self.backend.write().await?;
        Intake::delete(&mut *transaction, id).await?;
        self.commit(transaction, Synced, &[]).await
    }

    async fn counts(&self) -> Result<Counts, StoreError> {
        Reading::counts(&mut *self.backend.read().await?).await
    }

    async fn sweep(&self, retention: &Retention) -> Result<usize, StoreError> {
        // What a scan of all finished jobs finds is removed by id: submissions do not wait for it.
        let surplus = match retention.stored_bytes {
            Some(bytes) => self.backend.read().await?.surplus(bytes).await?,
            None => Vec::new(),
        };
        let (mut transaction, now) = self.backend.write().await?;
        let swept = Intake::sweep(&mut *transaction, retention, &surplus, now).await?;
        self.commit(transaction, Written, &[]).await?;
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
        Intake::record_health(&mut *transaction, now).await?;
        self.commit(transaction, Synced, &[]).await
    }

    async fn sync(&self) -> Result<(), StoreError> {
        self.backend.sync().await
    }

    async fn close(&self) {
        self.backend.close().await;
    }
}
