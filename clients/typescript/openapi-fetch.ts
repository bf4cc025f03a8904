/** The service through openapi-typescript's types and openapi-fetch. */

import assert from 'node:assert/strict';
import createClient from 'openapi-fetch';

import type { components, paths } from '../generated/openapi-typescript.ts';
import { assertCsv, assertEvents, assertPeak, assertVtu, reference } from './uses.ts';

type ContactJob = components['schemas']['ContactJob'];

const client = createClient<paths>({ baseUrl: process.argv[2] ?? '' });

const job: ContactJob = reference;

// @ts-expect-error Exactly one kind of load.
const mixed: ContactJob = { ...job, load: { force: 612.6106, approach: 0.02 } };
// @ts-expect-error A body deforms or is rigid.
const both: ContactJob = { ...job, upper: { ...job.upper, material: { rigid: true, young_modulus: 1 } } };
assert.ok(mixed && both);

const validation = await client.POST('/v1/validate', { body: job });
assert.ok(validation.data && validation.data.estimate.equations > 1000);

const solved = await client.POST('/v1/solve', { body: job });
assert.equal(solved.data?.result?.status, 'converged');
assertPeak(solved.data.result.steps[0]?.answers);

const submitted = await client.POST('/v1/jobs', { body: { ...job, output: { fields: true } } });
assert.ok(submitted.data);
const path = { id: submitted.data.id };
const done = await client.GET('/v1/jobs/{id}', { params: { path, query: { wait: 60 } } });
assert.ok(done.data?.done && done.data.has_result);
const result = await client.GET('/v1/jobs/{id}/result', { params: { path, query: { fields: 'contact' } } });
assert.ok(result.data && typeof result.data === 'object');
assertPeak(result.data.steps[0]?.answers);

const list = await client.GET('/v1/jobs', { params: { query: { limit: 10 } } });
assert.ok(list.data?.jobs.some(({ id }) => id === path.id));

const cancelled = await client.POST('/v1/jobs/{id}/cancel', { params: { path } });
assert.equal(cancelled.data?.done, true);

const bad = await client.POST('/v1/solve', { body: { ...job, load: { force: -1 } } });
assert.equal(bad.error?.errors?.[0]?.pointer, '#/load/force');
assert.equal(bad.error.errors[0].code, 'out_of_range');

const events = await client.GET('/v1/jobs/{id}/events', { params: { path }, parseAs: 'text' });
assertEvents(events.data ?? '');
const csv = await client.GET('/v1/jobs/{id}/summary.csv', { params: { path }, parseAs: 'text' });
assertCsv(csv.data);
const vtu = await client.GET('/v1/jobs/{id}/field.vtu', { params: { path }, parseAs: 'text' });
await assertVtu(vtu.data);

console.log('openapi-typescript + openapi-fetch: nine uses');
