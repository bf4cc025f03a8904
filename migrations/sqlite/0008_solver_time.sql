-- The solver time that was spent for each API key, which decides whose job goes next; all zero
-- without a key.
CREATE TABLE accounts (
    id         BLOB PRIMARY KEY NOT NULL,
    spent      DOUBLE PRECISION NOT NULL DEFAULT 0,  -- microseconds, as they were when it was settled
    settled_at BIGINT NOT NULL DEFAULT 0
);
ALTER TABLE jobs ADD COLUMN account BLOB NOT NULL DEFAULT x'00000000000000000000000000000000';
UPDATE jobs SET account = submitter WHERE submitter IS NOT NULL;
INSERT INTO accounts (id) SELECT DISTINCT account FROM jobs WHERE state IN ('queued', 'running');

-- A job whose worker was lost goes first.
DROP INDEX jobs_queued;
DROP INDEX jobs_queued_short;
CREATE INDEX jobs_queued ON jobs (account, losses DESC, priority DESC, id) WHERE state = 'queued';
CREATE INDEX jobs_lost ON jobs (losses) WHERE state = 'queued' AND losses > 0;
-- Running jobs are few; an index on their leases changes with every heartbeat.
DROP INDEX jobs_running;

ALTER TABLE jobs DROP COLUMN flow;
ALTER TABLE jobs DROP COLUMN work;
ALTER TABLE jobs DROP COLUMN short;
DROP TABLE flows;
DROP TABLE scheduler;
