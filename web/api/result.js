/**
 * Results, fetched and parsed in a worker: the result of a fine mesh is tens of megabytes of JSON.
 */

import { NOTHING, wordsOf } from './answers.js';
import { Problem, authorization, keyWanted, request } from './client.js';
import { reportLost } from './connection.js';

/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('../types.js').Mesh} Mesh */

/** @type {Worker | undefined} */
let worker;
/** Whether the worker has parsed megabytes. */
let filled = false;
let count = 0;
const waiting =
  /** @type {Map<number, {resolve: (value: any) => void, reject: (error: Error) => void, progress?: (received: number, total: number) => void}>} */ (
    new Map()
  );

/** Depths of a curve that a chart can show. */
const DEPTHS = 120;

/**
 * The figures of a job, without the fields on the mesh: those come by {@link fetchFields}, a step
 * at a time.
 * @param {string} id of a job
 * @param {(received: number, total: number) => void} [progress] in bytes; the total is 0 while it
 *   is not known
 * @returns {Promise<Report>}
 * @throws {Problem}
 */
export function fetchResult(id, progress) {
  const parts = 'contact,subsurface,plasticity,history';
  // Fields may be wanted next.
  return ask(
    `v1/jobs/${id}/result?fields=${parts}&subsurface_points=${DEPTHS}`,
    {},
    { progress },
  ).finally(prepare);
}

/**
 * @param {string} id of a job
 * @param {number} step counted from 0
 * @param {string[]} arrays by their names
 * @param {{signal?: AbortSignal, progress?: (received: number, total: number) => void}} about
 *   progress in bytes
 * @returns {Promise<{upper: Partial<Mesh> | null, lower: Partial<Mesh> | null}>}
 * @throws {Problem}
 */
export const fetchFields = (id, step, arrays, about) =>
  ask(
    `v1/jobs/${id}/fields/${step + 1}${arrays.length ? `?arrays=${arrays.join()}` : ''}`,
    {},
    about,
  );

/** Starts the worker, so that what is asked soon need not wait for it. */
export function prepare() {
  worker ??= start();
}

/**
 * Solves a job at once and keeps nothing of it.
 * @param {import('../types.js').Job} job
 * @param {AbortSignal} signal hangs up, which cancels the job
 * @returns {Promise<Report>}
 * @throws {Problem}
 */
export async function solveNow(job, signal) {
  // An aborted solve has no answer with an id: its tag finds the job.
  const slider = crypto.getRandomValues(new Uint32Array(2)).join('-');
  const body = JSON.stringify({ ...job, tags: { ...job.tags, slider } });
  signal.addEventListener('abort', () => takeAway(slider), { once: true });
  const { solved_as: id, ...report } = await ask('v1/solve', { method: 'POST', body }, { signal });
  // The list of jobs must not show the jobs of a slider.
  if (id) request(`v1/jobs/${id}`, { method: 'DELETE' }, () => {}).catch(() => {});
  return report;
}

/** Time [ms] between two queries of an abandoned job, and their largest number. */
const [LOOK, LOOKS] = [500, 20];

/** Removes the job of this tag as soon as it has ended. @param {string} slider */
async function takeAway(slider) {
  for (let k = 0; k < LOOKS; k++) {
    await new Promise((resolve) => setTimeout(resolve, LOOK));
    const found = await request(`v1/jobs?tag=slider:${slider}`, {}, (response) =>
      response.json(),
    ).catch(() => undefined);
    for (const { id, done } of found?.jobs ?? []) {
      const [path, method] = done ? [`v1/jobs/${id}`, 'DELETE'] : [`v1/jobs/${id}/cancel`, 'POST'];
      await request(path, { method }, () => {}).catch(() => {});
      if (done) return;
    }
  }
}

/**
 * @param {string} path
 * @param {{method?: string, body?: string}} options
 * @param {{signal?: AbortSignal, progress?: (received: number, total: number) => void}} about
 * @returns {Promise<any>}
 */
function ask(path, options, { signal, progress }) {
  worker ??= start();
  const number = ++count;
  signal?.addEventListener('abort', () => worker?.postMessage({ number, abort: true }), {
    once: true,
  });
  return new Promise((resolve, reject) => {
    waiting.set(number, { resolve, reject, progress });
    const headers = {
      ...authorization(),
      ...(options.body && { 'Content-Type': 'application/json' }),
    };
    worker?.postMessage({
      number,
      url: new URL(path, document.baseURI).href,
      options: { ...options, headers },
    });
  });
}

/**
 * Ends a worker that has nothing to do: what is left of megabytes goes with it, which it would
 * collect some day.
 */
function rest() {
  if (waiting.size || !filled) return;
  filled = false;
  worker?.terminate();
  worker = undefined;
}

function start() {
  const started = new Worker(new URL('result-worker.js', import.meta.url), { type: 'module' });
  started.addEventListener('message', ({ data }) => {
    const asker = waiting.get(data.number);
    if (data.received !== undefined) {
      filled = true;
      return asker?.progress?.(data.received, data.total);
    }
    waiting.delete(data.number);
    rest();
    if (data.answer) return asker?.resolve(data.answer);
    if ([NOTHING, 502, 504].includes(data.status) && !data.aborted) reportLost();
    if (data.status === 401) keyWanted();
    asker?.reject(
      new Problem(data.status, data.problem?.detail ?? wordsOf(data.status), data.problem ?? {}),
    );
  });
  // The worker's script did not load: the next request starts another worker.
  started.addEventListener('error', () => {
    if (worker !== started) return;
    worker = undefined;
    const askers = [...waiting.values()];
    waiting.clear();
    reportLost();
    for (const { reject } of askers) reject(new Problem(NOTHING, wordsOf(NOTHING)));
  });
  return started;
}
