-- The text of a job apart from its row.
CREATE TABLE requests (
    job  UUID PRIMARY KEY NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    body BYTEA NOT NULL                           -- JSON, compressed
);
INSERT INTO requests (job, body) SELECT id, request FROM jobs;
ALTER TABLE jobs DROP COLUMN request;

-- One row that is written to show that writing works.
CREATE TABLE health (written_at BIGINT NOT NULL);
INSERT INTO health VALUES (0);
