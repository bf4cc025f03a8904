-- The text of a job apart from its row: SQLite writes a whole row anew with every change of it.
CREATE TABLE requests (
    job  BLOB PRIMARY KEY NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    body BLOB NOT NULL                           -- JSON, compressed
);
INSERT INTO requests (job, body) SELECT id, request FROM jobs;
ALTER TABLE jobs DROP COLUMN request;

-- One row that is written to show that writing works.
CREATE TABLE health (written_at BIGINT NOT NULL);
INSERT INTO health VALUES (0);
