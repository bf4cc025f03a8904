/** Several jobs at once: handed in together, and asked for until all of them have ended. */

import { Problem, post } from '../api/client.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {{id: string, job: Job, report?: Report, problem?: string, done: boolean}} Trial one job and what became of it */

/** Time [ms] between two looks. */
const PAUSE = 400;

/** @param {number} ms @param {AbortSignal} signal */
const pause = (ms, signal) =>
  new Promise((resolve) => {
    const timer = setTimeout(resolve, ms);
    signal.addEventListener('abort', () => (clearTimeout(timer), resolve(undefined)), {
      once: true,
    });
  });

/** A name that no other has. The list has jobs whose tag `run` it is in one row. */
export const newRun = () =>
  Array.from(crypto.getRandomValues(new Uint32Array(4)), (word) => word.toString(16)).join('-');

/**
 * @param {Job[]} jobs at most 100
 * @param {AbortSignal} signal
 * @param {(trials: Trial[]) => void} seen called whenever one more has ended
 * @param {string} [run] that they belong to
 * @returns {Promise<Trial[]>} in the order of the jobs
 * @throws {Problem} where none of them is taken
 */
export async function solveAll(jobs, signal, seen, run = newRun()) {
  const tagged = jobs.map((job) => ({ job: { ...job, tags: { ...job.tags, run } } }));
  const headers = { 'Idempotency-Key': newRun() };
  const made = await post('v1/batch/submit', { jobs: tagged }, { signal, headers });
  const trials = /** @type {Trial[]} */ (
    made.jobs.map((/** @type {any} */ { job, problem }, /** @type {number} */ k) => ({
      id: job?.id ?? '',
      job: jobs[k],
      problem: problem && (problem.errors?.[0]?.detail ?? problem.detail),
      done: !job,
    }))
  );
  seen(trials);
  while (!signal.aborted) {
    const ids = trials.filter(({ done }) => !done).map(({ id }) => id);
    if (ids.length === 0) break;
    await pause(PAUSE, signal);
    if (signal.aborted) break;
    const now = await post('v1/batch/fetch?fields=summary', { ids }, { signal }).catch((error) => {
      if (error instanceof Problem && error.passing) return { jobs: [] };
      throw error;
    });
    let more = false;
    for (const { id, job } of now.jobs) {
      const trial = trials.find((one) => one.id === id || one.id === job?.id);
      if (!trial || !job?.done) continue;
      trial.done = true;
      trial.report = job.result;
      if (!job.result) trial.problem = job.error?.detail ?? 'it was not solved';
      more = true;
    }
    if (more) seen(trials);
  }
  for (const { id, done } of trials)
    if (!done && id) post(`v1/jobs/${id}/cancel`, '').catch(() => {});
  return trials;
}

/** One of them, for who looks for a figure step by step. @param {Job} job @param {AbortSignal} signal @param {string} run @returns {Promise<Trial>} */
export const solveOne = async (job, signal, run) =>
  (await solveAll([job], signal, () => {}, run))[0];
