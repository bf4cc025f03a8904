-- What an API key may take; nothing where the settings of the service decide.
ALTER TABLE api_keys ADD COLUMN max_queued BIGINT;
ALTER TABLE api_keys ADD COLUMN max_running BIGINT;
ALTER TABLE api_keys ADD COLUMN max_stored BIGINT;                     -- bytes
ALTER TABLE api_keys ADD COLUMN max_priority INTEGER;
ALTER TABLE api_keys ADD COLUMN expires_at BIGINT;
-- The secret before the last rotation, and until when it is good.
ALTER TABLE api_keys ADD COLUMN previous_digest BYTEA;
ALTER TABLE api_keys ADD COLUMN previous_until BIGINT;

ALTER TABLE jobs ADD COLUMN reserved_bytes BIGINT NOT NULL DEFAULT 0;  -- of the result, estimated; until the job has ended
CREATE INDEX jobs_stored_by_submitter ON jobs (submitter, finished_at, stored_bytes, reserved_bytes);

-- Short jobs are also handed out beside long ones that hold every solver.
ALTER TABLE jobs ADD COLUMN short BOOLEAN NOT NULL DEFAULT FALSE;
CREATE INDEX jobs_queued_short ON jobs (flow, priority DESC, id) WHERE state = 'queued' AND short;
