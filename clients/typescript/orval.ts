/** The service through orval's fetch client. */

import assert from 'node:assert/strict';

import {
  cancelJob,
  getEvents,
  getFieldVtu,
  getJob,
  getResult,
  getSummaryCsv,
  listJobs,
  postJob,
  postSolve,
  postValidate,
} from '../generated/orval.ts';
import type { ContactJob } from '../generated/orval.ts';
import { assertCsv, assertEvents, assertPeak, assertVtu, reference } from './uses.ts';

const job: ContactJob = reference;

const validation = await postValidate(job);
assert.ok(validation.status === 200 && validation.data.estimate.equations > 1000);

const solved = await postSolve(job);
assert.ok(solved.status === 200);
assert.equal(solved.data.result?.status, 'converged');
assertPeak(solved.data.result?.steps[0]?.answers);

const submitted = await postJob({ ...job, output: { fields: true } });
assert.ok(submitted.status === 202);
const { id } = submitted.data;
const done = await getJob(id, { wait: 60 });
assert.ok(done.status === 200 && done.data.done && done.data.has_result);
const result = await getResult(id, { fields: 'contact' });
assert.ok(result.status === 200 && typeof result.data === 'object');
assertPeak(result.data.steps[0]?.answers);

const list = await listJobs({ limit: 10 });
assert.ok(list.status === 200 && list.data.jobs.some((one) => one.id === id));

const cancelled = await cancelJob(id);
assert.ok(cancelled.status === 200 && cancelled.data.done);

const bad = await postSolve({ ...job, load: { force: -1 } });
assert.ok(bad.status === 422);
assert.equal(bad.data.errors?.[0]?.pointer, '#/load/force');

const events = await getEvents(id);
assert.ok(events.status === 200);
assertEvents(events.data);
const csv = await getSummaryCsv(id);
assert.ok(csv.status === 200);
assertCsv(csv.data);
const vtu = await getFieldVtu(id);
assert.ok(vtu.status === 200);
await assertVtu(vtu.data);

console.log('orval: nine uses');
