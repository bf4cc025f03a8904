-- One row a job. Times are microseconds since 1970 (UTC), by the clock of the store.
CREATE TABLE jobs (
    id               UUID PRIMARY KEY NOT NULL,  -- version 7: sorted by id is sorted by submission
    state            TEXT NOT NULL,
    priority         INTEGER NOT NULL,
    memory           BIGINT NOT NULL,              -- bytes, estimated
    tags             TEXT NOT NULL,                -- JSON, for showing; job_tags is for searching
    request          BYTEA NOT NULL,              -- JSON, zstd
    submitter        UUID,                       -- API key
    created_at       BIGINT NOT NULL,
    started_at       BIGINT,
    finished_at      BIGINT,
    attempts         INTEGER NOT NULL DEFAULT 0,   -- with owner: the fence of the lease
    losses           INTEGER NOT NULL DEFAULT 0,   -- attempts that ended with the loss of the worker
    owner            UUID,
    leased_until     BIGINT,
    cancel_requested BOOLEAN NOT NULL DEFAULT FALSE,
    iterations       INTEGER NOT NULL DEFAULT 0,
    latest           TEXT,                         -- JSON of the latest iteration
    has_report       BOOLEAN NOT NULL DEFAULT FALSE,
    failure          TEXT                          -- JSON
);

CREATE INDEX jobs_queued ON jobs (priority DESC, id) WHERE state = 'queued';
CREATE INDEX jobs_running ON jobs (leased_until) WHERE state = 'running';
CREATE INDEX jobs_finished ON jobs (finished_at) WHERE finished_at IS NOT NULL;
CREATE INDEX jobs_by_state ON jobs (state, id);
CREATE INDEX jobs_by_submitter ON jobs (submitter, id);

CREATE TABLE job_tags (
    job   UUID NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    name  TEXT NOT NULL,
    value TEXT NOT NULL,
    PRIMARY KEY (job, name)
);
CREATE INDEX job_tags_by_value ON job_tags (name, value, job);

-- Iterations first .. last-1 of the latest attempt, in the bunches they came in.
CREATE TABLE iterations (
    job     UUID NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    first   INTEGER NOT NULL,
    last    INTEGER NOT NULL,
    records BYTEA NOT NULL,                       -- JSON, zstd
    PRIMARY KEY (job, first)
);

CREATE TABLE reports (
    job  UUID PRIMARY KEY NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    body BYTEA NOT NULL                           -- JSON, zstd
);

-- The row is written before its job, in the same transaction: whoever writes it first makes the job.
CREATE TABLE idempotency_keys (
    submitter UUID NOT NULL,                     -- all zero without an API key
    name      TEXT NOT NULL,
    digest    BYTEA NOT NULL,
    job       UUID NOT NULL REFERENCES jobs (id) ON DELETE CASCADE DEFERRABLE INITIALLY DEFERRED,
    PRIMARY KEY (submitter, name)
);
CREATE INDEX idempotency_keys_by_job ON idempotency_keys (job);

CREATE TABLE api_keys (
    id         UUID PRIMARY KEY NOT NULL,
    name       TEXT NOT NULL,
    scope      TEXT NOT NULL,
    digest     BYTEA NOT NULL,                    -- SHA-256 of the secret, which is random
    created_at BIGINT NOT NULL,
    revoked_at BIGINT
);
