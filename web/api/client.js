/** Asking the service. Addresses are relative, so the page works behind any path. */

/** @typedef {{pointer: string, detail: string}} FieldError */

/** An RFC 9457 problem, or a connection that failed (status 0). */
export class Problem extends Error {
  /** @param {number} status @param {string} detail @param {any} [body] */
  constructor(status, detail, body = {}) {
    super(detail);
    this.status = status;
    this.title = String(body.title ?? 'No answer');
    /** @type {FieldError[]} */
    this.errors = body.errors ?? [];
    /** @type {{line?: number, column?: number, estimate?: {equations: number, bytes: number}}} */
    this.body = body;
  }
}

const KEY = 'api-key';
const asked = /** @type {Set<() => void>} */ (new Set());

/** @param {() => void} listener called when the service wants an API key */
export const onKeyWanted = (listener) => asked.add(listener);

/** @param {string} key kept for this tab only */
export const useKey = (key) => (key ? sessionStorage.setItem(KEY, key) : sessionStorage.removeItem(KEY));

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
    throw new Problem(0, 'the service does not answer');
  }
  if (response.ok) return response;
  if (response.status === 401) for (const listener of asked) listener();
  const problem = await response.json().catch(() => ({}));
  throw new Problem(response.status, String(problem.detail ?? response.statusText), problem);
}

/** @param {string} path @param {RequestInit & {json?: unknown}} [options] @returns {Promise<any>} */
export const ask = async (path, options) => (await request(path, options)).json();

/** @param {string} path @param {unknown} json @param {AbortSignal} [signal] @returns {Promise<any>} */
export const post = (path, json, signal) => ask(path, { method: 'POST', json, signal });
