-- A result in parts: `reports` has everything but the steps (the whole, of jobs of the first version), and each step has a
-- row, written when the step is finished. Fields are apart, in their binary form.
CREATE TABLE result_steps (
    job  BLOB NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    step INTEGER NOT NULL,                       -- from 0
    body BLOB NOT NULL,                          -- JSON without fields, compressed
    PRIMARY KEY (job, step)
);
CREATE TABLE result_fields (
    job  BLOB NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    step INTEGER NOT NULL,
    body BLOB NOT NULL,                          -- docs/results.md
    PRIMARY KEY (job, step)
);
ALTER TABLE jobs ADD COLUMN steps INTEGER NOT NULL DEFAULT 0;          -- rows in result_steps
ALTER TABLE jobs ADD COLUMN stored_bytes BIGINT NOT NULL DEFAULT 0;    -- of the result
CREATE INDEX jobs_stored ON jobs (finished_at, stored_bytes) WHERE finished_at IS NOT NULL;
