-- Jobs of one API key, those that somebody waits for apart from the others. Each flow has a share of the solvers: its virtual
-- time grows with the work of its jobs, and the flow whose time is the least goes next.
CREATE TABLE flows (
    id           INTEGER PRIMARY KEY,
    submitter    BLOB NOT NULL,                  -- all zero without an API key
    interactive  BOOLEAN NOT NULL,
    virtual_time DOUBLE PRECISION NOT NULL DEFAULT 0,
    UNIQUE (submitter, interactive)
);
-- The virtual time of the job that was handed out last: where a flow that has had nothing to do begins.
CREATE TABLE scheduler (virtual_time DOUBLE PRECISION NOT NULL);
INSERT INTO scheduler VALUES (0);

ALTER TABLE jobs ADD COLUMN flow BIGINT;
ALTER TABLE jobs ADD COLUMN work BIGINT NOT NULL DEFAULT 1;            -- estimated, in units of its own
INSERT INTO flows (submitter, interactive)
    SELECT DISTINCT coalesce(submitter, x'00000000000000000000000000000000'), FALSE FROM jobs
    WHERE state IN ('queued', 'running');
UPDATE jobs SET flow = (SELECT f.id FROM flows f
        WHERE f.submitter = coalesce(jobs.submitter, x'00000000000000000000000000000000'))
    WHERE state IN ('queued', 'running');

DROP INDEX jobs_queued;
CREATE INDEX jobs_queued ON jobs (flow, priority DESC, id) WHERE state = 'queued';
