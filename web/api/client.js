/** Asking the service. Addresses are relative, so the page works behind any path. */

import { reportLost } from './connection.js';

/** @typedef {{pointer: string, detail: string}} FieldError */

/**
 * The faults that a problem names; a pointer comes as the fragment of a URI.
 * @param {{errors?: {pointer?: string, parameter?: string, detail: string}[]}} problem
 * @returns {FieldError[]}
 */
export const faultsOf = ({ errors = [] }) =>
  errors.map(({ pointer, parameter = '', detail }) => ({
    pointer: pointer === undefined ? parameter : decodeURIComponent(pointer.replace(/^#/, '')),
    detail,
  }));

/** An RFC 9457 problem, or a connection that failed (status 0). */
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
}

const KEY = 'api-key';
const asked = /** @type {Set<(refused: boolean) => void>} */ (new Set());

/** @param {(refused: boolean) => void} listener called when the service wants an API key, or another one */
export const onKeyWanted = (listener) => asked.add(listener);

/** Tells that the service has refused a question for want of a key. */
export function keyWanted() {
  const refused = sessionStorage.getItem(KEY) !== null;
  for (const listener of asked) listener(refused);
}

/** @param {string} key kept for this tab only */
export const useKey = (key) => (key ? sessionStorage.setItem(KEY, key) : sessionStorage.removeItem(KEY));

/** Whether this tab has a key. */
export const hasKey = () => sessionStorage.getItem(KEY) !== null;

/** @returns {Record<string, string>} */
export function authorization() {
  const key = sessionStorage.getItem(KEY);
  return key ? { Authorization: `Bearer ${key}` } : {};
}

/**
 * @param {string} path beginning with `v1/`
 * @param {RequestInit & {json?: unknown}} [options] `json` is sent as a body
 * @returns {Promise<Response>} of a good status
 * @throws {Problem}
 */
export async function request(path, { json, headers, ...options } = {}) {
  const body = json === undefined ? {} : { body: typeof json === 'string' ? json : JSON.stringify(json) };
  const type = json === undefined ? undefined : { 'Content-Type': 'application/json' };
  let response;
  try {
    response = await fetch(path.replace(/^\//, ''), {
      ...options,
      ...body,
      headers: { ...authorization(), ...type, ...headers },
    });
  } catch (error) {
    if (/** @type {Error} */ (error).name === 'AbortError') throw error;
    reportLost();
    throw new Problem(0, 'the service does not answer');
  }
  if (response.ok) return response;
  if (response.status === 401) keyWanted();
  // A proxy before a service that is not there.
  if (response.status === 502 || response.status === 504) reportLost();
  const problem = await response.json().catch(() => ({}));
  throw new Problem(response.status, String(problem.detail ?? response.statusText), problem);
}

/** @param {string} path @param {RequestInit & {json?: unknown}} [options] @returns {Promise<any>} */
export const ask = async (path, options) => (await request(path, options)).json();

/** @param {string} path @param {unknown} json @param {AbortSignal} [signal] @returns {Promise<any>} */
export const post = (path, json, signal) => ask(path, { method: 'POST', json, signal });
