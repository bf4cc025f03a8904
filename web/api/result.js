/** Results, fetched and parsed in a worker: that of a fine mesh is tens of megabytes of JSON. */

import { Problem, authorization, keyWanted } from './client.js';
import { reportLost } from './connection.js';

/** @type {Worker | undefined} */
let worker;
let count = 0;
const waiting = /** @type {Map<number, {resolve: (report: any) => void, reject: (error: Error) => void}>} */ (
  new Map()
);

/**
 * @param {string} id of a job
 * @returns {Promise<import('../types.js').Report>} with its fields as typed arrays
 * @throws {Problem}
 */
export function fetchResult(id) {
  worker ??= start();
  const number = ++count;
  return new Promise((resolve, reject) => {
    waiting.set(number, { resolve, reject });
    worker?.postMessage({
      number,
      url: new URL(`v1/jobs/${id}/result`, document.baseURI).href,
      headers: authorization(),
    });
  });
}

function start() {
  const started = new Worker(new URL('result-worker.js', import.meta.url), { type: 'module' });
  started.addEventListener('message', ({ data }) => {
    const asker = waiting.get(data.number);
    waiting.delete(data.number);
    if (data.status === 0) reportLost();
    if (data.status === 401) keyWanted();
    if (data.report) asker?.resolve(data.report);
    else asker?.reject(new Problem(data.status, data.problem.detail ?? 'the service does not answer', data.problem));
  });
  return started;
}
