-- Fields in parts, so that neither writing nor reading them needs a step in memory as a whole, nor a value as long as one.
CREATE TABLE field_parts (
    job   BLOB NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    step  INTEGER NOT NULL,
    first BIGINT NOT NULL,                       -- where it begins in the bytes of the step (docs/results.md)
    body  BLOB NOT NULL,
    PRIMARY KEY (job, step, first)
);
INSERT INTO field_parts (job, step, first, body) SELECT job, step, 0, body FROM result_fields;
DROP TABLE result_fields;
