-- Where the end of a job is announced. A row is due from the end of its job on, until it is delivered or given up.
CREATE TABLE deliveries (
    job          BLOB PRIMARY KEY NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    id           BLOB NOT NULL,                  -- what a receiver knows a repetition by
    url          TEXT NOT NULL,
    state        TEXT NOT NULL DEFAULT 'waiting', -- waiting | pending | delivered | failed
    attempts     INTEGER NOT NULL DEFAULT 0,
    due_at       BIGINT,                         -- of a pending one; while it is being sent, when it is sent again if nothing is heard
    status       INTEGER,                        -- HTTP status of the last attempt
    error        TEXT,                           -- why the last attempt failed
    delivered_at BIGINT
);
CREATE INDEX deliveries_due ON deliveries (due_at) WHERE state = 'pending';

-- W3C trace context of the submission.
ALTER TABLE jobs ADD COLUMN traceparent TEXT;
