/** Sends jobs: one press makes one job, however often it takes to get an answer. */

import { Problem, hasKey, post } from '../api/client.js';
import { reconnected } from '../api/connection.js';
import { same } from '../lib/pointer.js';
import { inWords } from './words.js';

/** The job that is being sent. Another one goes before the one that waits. */
export class Sending {
  /** @type {{job: import('../types.js').Job, controller: AbortController} | undefined} */
  #now;

  get isOn() {
    return this.#now !== undefined;
  }

  /** @param {import('../types.js').Job} job */
  isOf(job) {
    return this.#now !== undefined && same(this.#now.job, job);
  }

  /** @param {import('../types.js').Job} job @returns {AbortSignal} aborted when another one is sent */
  begin(job) {
    this.#now?.controller.abort();
    this.#now = { job, controller: new AbortController() };
    return this.#now.controller.signal;
  }

  /** @param {AbortSignal} signal of the job that is sent no more */
  end(signal) {
    if (this.#now?.controller.signal === signal) this.#now = undefined;
  }
}

/**
 * @param {import('../types.js').Job} job
 * @param {AbortSignal} signal
 * @param {(problem: Problem) => void} waiting called when it has to be sent again
 * @returns {Promise<{id: string}>}
 * @throws {Problem} of a job that is refused for good
 */
export async function send(job, signal, waiting) {
  // Whether a lost answer was of a job that was made is not known: the service makes one job of
  // one key.
  const headers = { 'Idempotency-Key': uniqueKey() };
  for (;;) {
    try {
      return await post('v1/jobs', job, { signal, headers });
    } catch (error) {
      if (!(error instanceof Problem && error.passing)) throw error;
      waiting(error);
      await Promise.all([reconnected(), error.status === 0 ? undefined : pause(error.retryAfter)]);
    }
  }
}

/** @param {number} seconds */
export const pause = (seconds) => new Promise((resolve) => setTimeout(resolve, 1000 * seconds));

/** Also where the page does not come by https, and browsers make no UUIDs. */
const uniqueKey = () =>
  Array.from(crypto.getRandomValues(new Uint8Array(16)), (byte) =>
    byte.toString(16).padStart(2, '0'),
  ).join('');

/** @param {Problem} problem @returns {string} what a wait means for who wants an answer */
export const waitingWords = ({ status, message }) =>
  status === 0 || status === 502 || status === 504
    ? 'The service does not answer. The job is sent again when it does, and is made once.'
    : `${sentence(message)} The job is sent again until it is taken.`;

/** @param {Problem} problem @param {number} faults fields that are wrong @returns {string} what a refusal means for who wants an answer */
export function refusalWords({ status, message, errors }, faults) {
  if (status === 401)
    return hasKey()
      ? 'The service does not know this API key, or no longer.'
      : 'The service asks for an API key.';
  if (status !== 422) return sentence(message);
  if (faults === 1) return 'One field is wrong: the cursor is in it.';
  return faults
    ? `${faults} fields are wrong: the cursor is in the first.`
    : sentence(errors[0]?.detail ?? message);
}

/** @param {string} message of the service @returns {string} without keys of the job */
export function sentence(message) {
  const words = inWords(message);
  return `${words.charAt(0).toUpperCase()}${words.slice(1).replace(/\.$/, '')}.`;
}
