/** The service through @hey-api/openapi-ts. */

import assert from 'node:assert/strict';

import { client } from '../generated/hey-api/client.gen.ts';
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
} from '../generated/hey-api/sdk.gen.ts';
import type { ContactJob } from '../generated/hey-api/types.gen.ts';
import { assertCsv, assertPeak, assertVtu, reference } from './uses.ts';

client.setConfig({ baseUrl: process.argv[2] ?? '' });

const job: ContactJob = reference;

// @ts-expect-error Exactly one kind of load.
const mixed: ContactJob = { ...job, load: { force: 612.6106, approach: 0.02 } };
assert.ok(mixed);

const validation = await postValidate({ body: job });
assert.ok(validation.data && validation.data.estimate.equations > 1000);

const solved = await postSolve({ body: job });
assert.equal(solved.data?.result?.status, 'converged');
assertPeak(solved.data.result.steps[0]?.answers);

const submitted = await postJob({ body: { ...job, output: { fields: true } } });
assert.ok(submitted.data);
const path = { id: submitted.data.id };
const done = await getJob({ path, query: { wait: 60 } });
assert.ok(done.data?.done && done.data.has_result);
const result = await getResult({ path, query: { fields: 'contact' } });
assert.ok(result.data && typeof result.data === 'object');
assertPeak(result.data.steps[0]?.answers);

const list = await listJobs({ query: { limit: 10 } });
assert.ok(list.data?.jobs.some(({ id }) => id === path.id));

const cancelled = await cancelJob({ path });
assert.equal(cancelled.data?.done, true);

const bad = await postSolve({ body: { ...job, load: { force: -1 } } });
assert.equal(bad.error?.errors?.[0]?.pointer, '#/load/force');

const { stream } = await getEvents({ path });
const events: unknown[] = [];
for await (const event of stream) events.push(event);
const last = events.at(-1) as { done?: boolean } | undefined;
assert.equal(last?.done, true);

assertCsv((await getSummaryCsv({ path, parseAs: 'text' })).data);
await assertVtu((await getFieldVtu({ path, parseAs: 'text' })).data);

console.log('@hey-api/openapi-ts: nine uses');
