/** Requests to the service. URLs are relative, so the page works behind any path. */

import { tab } from '../lib/kept.js';
import { NOTHING, UNREADABLE, isPassing, wordsOf } from './answers.js';
import { awaited, reportLost } from './connection.js';

/** @typedef {{pointer: string, detail: string, code?: string}} FieldError */

/**
 * The faults that a problem names; a pointer comes as the fragment of a URI.
 * @param {{errors?: {pointer?: string, parameter?: string, detail: string, code?: string}[]}}
 *   problem
 * @returns {FieldError[]}
 */
export const faultsOf = ({ errors = [] }) =>
  errors.map(({ pointer, parameter = '', detail, code }) => ({
    pointer: pointer === undefined ? parameter : decodeURIComponent(pointer.replace(/^#/, '')),
    detail,
    code,
  }));

/** An RFC 9457 problem, or no answer (status 0), or one that cannot be read (−1). */
export class Problem extends Error {
  /** @param {number} status @param {string} detail @param {any} [body] */
  constructor(status, detail, body = {}) {
    super(detail);
    this.status = status;
    this.title = String(body.title ?? 'No answer');
    /** @type {FieldError[]} */
    this.errors = faultsOf(body);
    /** @type {{line?: number, column?: number, estimate?: {equations: number, bytes: number}}} */
    this.body = body;
  }

  /** Time [s] after which the service wants to be asked again. */
  retryAfter = 2;

  /** Whether the same question may soon have another answer. */
  get passing() {
    return isPassing(this.status);
  }
}

/** Time [ms] for an answer, and for each byte that is sent. */
const [LIMIT, FOR_BYTE] = [10_000, 0.02];

const KEY = 'api-key';
const asked = /** @type {Set<(refused: boolean) => void>} */ (new Set());

/**
 * @param {(refused: boolean) => void} listener called when the service wants an API key, or
 *   another one
 */
export const onKeyWanted = (listener) => asked.add(listener);

/** Reports that the service has refused a request without a key. */
export function keyWanted() {
  const refused = tab.get(KEY) !== null;
  for (const listener of asked) listener(refused);
}

/**
 * @param {string} key for this tab only
 * @returns {boolean} whether it is kept when the page is loaded anew
 */
export function useKey(key) {
  if (key) return tab.set(KEY, key);
  tab.remove(KEY);
  return true;
}

/** Whether this tab has a key. */
export const hasKey = () => tab.get(KEY) !== null;

/** @returns {Record<string, string>} */
export function authorization() {
  const key = tab.get(KEY);
  return key ? { Authorization: `Bearer ${key}` } : {};
}

/**
 * @template T
 * @param {string} path beginning with `v1/`
 * @param {RequestInit & {json?: unknown, limit?: number}} options `json` is sent as a body;
 *   `limit` [ms] until it is answered
 * @param {(response: Response) => T | Promise<T>} read what is wanted of an answer of a good
 *   status
 * @returns {Promise<T>}
 * @throws {Problem} and what `fetch` throws where the signal of the options says stop
 */
export async function request(path, { json, headers, signal, limit = LIMIT, ...options }, read) {
  const body =
    json === undefined ? undefined : typeof json === 'string' ? json : JSON.stringify(json);
  const type = json === undefined ? undefined : { 'Content-Type': 'application/json' };
  const controller = new AbortController();
  const stop = () => controller.abort();
  if (signal?.aborted) stop();
  signal?.addEventListener('abort', stop, { once: true });
  const timer = setTimeout(stop, limit + FOR_BYTE * (body?.length ?? 0));
  const answered = awaited();
  try {
    const response = await fetch(path.replace(/^\//, ''), {
      ...options,
      body,
      signal: controller.signal,
      headers: { ...authorization(), ...type, ...headers },
    });
    if (!response.ok) throw await refusalOf(response);
    return await read(response);
  } catch (error) {
    if (error instanceof Problem || signal?.aborted) throw error;
    reportLost();
    throw new Problem(NOTHING, wordsOf(NOTHING));
  } finally {
    clearTimeout(timer);
    answered();
  }
}

/** @param {Response} response @returns {Promise<Problem>} */
async function refusalOf(response) {
  const { status } = response;
  if (status === 401) keyWanted();
  // A proxy whose service does not answer.
  if (status === 502 || status === 504) reportLost();
  const body = await response.json().catch(() => ({}));
  // What is too long for the service is no “body” to who sets up two of them.
  const detail = status === 413 ? undefined : body?.detail;
  const problem = new Problem(status, String(detail ?? wordsOf(status)), body ?? {});
  const seconds = Number(response.headers.get('Retry-After'));
  if (seconds > 0) problem.retryAfter = Math.min(seconds, 60);
  return problem;
}

/** @param {Response} response */
async function decoded(response) {
  const text = await response.text();
  try {
    return JSON.parse(text);
  } catch {
    throw new Problem(UNREADABLE, wordsOf(UNREADABLE));
  }
}

/**
 * @param {string} path
 * @param {RequestInit & {json?: unknown}} [options]
 * @returns {Promise<any>}
 */
export const ask = (path, options = {}) => request(path, options, decoded);

/**
 * @param {string} path
 * @param {unknown} json
 * @param {RequestInit} [options]
 * @returns {Promise<any>}
 */
export const post = (path, json, options) => ask(path, { ...options, method: 'POST', json });
