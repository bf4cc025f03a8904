/**
 * Fetches results and fields, packs mesh fields into typed arrays and hands them over without
 * copying.
 */

import { NOTHING, UNREADABLE } from './answers.js';
import { SCALARS, readFields } from './npz.js';

/** Bytes between two reports of progress. */
const REPORTED = 1 << 20;

/** Time [ms] without a byte after which an answer counts as lost. */
const SILENT = 60_000;

const running = /** @type {Map<number, AbortController>} */ (new Map());

self.addEventListener('message', async ({ data: { number, abort, ...question } }) => {
  if (abort) return running.get(number)?.abort();
  const controller = new AbortController();
  const silence = new Silence(controller);
  running.set(number, controller);
  try {
    const buffers = /** @type {ArrayBuffer[]} */ ([]);
    const answer = await answerOf(question, number, silence, buffers);
    /** @type {any} */ (self).postMessage({ number, ...answer }, buffers);
  } catch (error) {
    const aborted = controller.signal.aborted && !silence.broke;
    const status = error instanceof SyntaxError ? UNREADABLE : NOTHING;
    self.postMessage({ number, status, problem: {}, aborted, error: String(error) });
  } finally {
    silence.end();
    running.delete(number);
  }
});

/** Aborts a request that receives nothing for long. */
class Silence {
  broke = false;
  #timer = 0;

  /** @param {AbortController} controller */
  constructor(controller) {
    this.controller = controller;
    this.broken();
  }

  /** Reports a received piece. */
  broken() {
    this.end();
    this.#timer = Number(
      setTimeout(() => {
        this.broke = true;
        this.controller.abort();
      }, SILENT),
    );
  }

  end() {
    clearTimeout(this.#timer);
  }
}

/** @typedef {{url: string, options: RequestInit}} Question */
/** @typedef {{status?: number, problem?: any, answer?: any}} Answer */

/**
 * @param {Question} question
 * @param {number} number
 * @param {Silence} silence
 * @param {ArrayBuffer[]} buffers
 * @returns {Promise<Answer>}
 */
async function answerOf({ url, options }, number, silence, buffers) {
  // A solve waits as long as the service does.
  if (options.method === 'POST' || url.includes('?wait=')) silence.end();
  const response = await fetch(url, { ...options, signal: silence.controller.signal });
  const parts = /** @type {Uint8Array[]} */ ([]);
  await each(response, number, silence, (chunk) => parts.push(chunk.slice()));
  const body = new Blob(/** @type {BlobPart[]} */ (parts));
  const isArchive = /^application\/octet-stream/.test(response.headers.get('content-type') ?? '');
  if (response.ok && isArchive) return { answer: readFields(await body.arrayBuffer(), buffers) };
  const text = await body.text();
  if (!response.ok) return { status: response.status, problem: problemOf(text) };
  const answer = JSON.parse(text);
  // The time of a solve is over, and the job goes on: it is followed.
  if (answer.done === false) {
    const next = response.status === 202 ? new URL(`jobs/${answer.id}?wait=30`, url).href : url;
    return answerOf(
      { url: next, options: { headers: options.headers } },
      number,
      silence,
      buffers,
    );
  }
  if (answer.done && !answer.result) return { status: 409, problem: answer.error ?? {} };
  return { answer: report(answer, buffers) };
}

/**
 * @param {ReadableStream<Uint8Array<ArrayBuffer>>} body
 * @returns {() => Promise<Uint8Array | undefined>} its next piece, for as long as nobody asks
 *   again
 */
function reading(body) {
  let room = new ArrayBuffer(REPORTED);
  try {
    const reader = body.getReader({ mode: 'byob' });
    return async () => {
      const { value, done } = await reader.read(new Uint8Array(room));
      if (value) room = value.buffer;
      return done ? undefined : value;
    };
  } catch {
    // A browser without readers into a given buffer.
    const reader = body.getReader();
    return async () => (await reader.read()).value;
  }
}

/**
 * Reads an answer piece by piece into the same buffer, and reports progress.
 * @param {Response} response
 * @param {number} number
 * @param {Silence} silence
 * @param {(chunk: Uint8Array) => void} take
 */
async function each(response, number, silence, take) {
  const total = Number(response.headers.get('content-length') ?? 0);
  if (!response.body) return;
  const next = reading(response.body);
  let [length, told] = [0, 0];
  for (let value = await next(); value; value = await next()) {
    silence.broken();
    take(value);
    length += value.length;
    if (length - told > REPORTED) {
      told = length;
      self.postMessage({ number, received: length, total });
    }
  }
}

/** @param {string} text */
function problemOf(text) {
  try {
    return JSON.parse(text);
  } catch {
    return {};
  }
}

/** @param {any} answer @param {ArrayBuffer[]} buffers */
function report(answer, buffers) {
  // The answer of a solve is its job with the result inside.
  const parsed = answer.result ?? answer;
  if (answer.result) parsed.solved_as = answer.id;
  for (const step of parsed.steps ?? []) {
    for (const side of ['upper', 'lower']) {
      if (step.fields?.[side]) step.fields[side] = pack(step.fields[side], buffers);
    }
  }
  return parsed;
}

/** @param {any} field @param {ArrayBuffer[]} buffers */
function pack(field, buffers) {
  const packed = /** @type {Record<string, any>} */ ({
    nodes: pairs(field.nodes),
    displacement: pairs(field.displacement),
    elements: Uint32Array.from(field.elements.flat()),
  });
  for (const name of SCALARS) packed[name] = Float32Array.from(field[name]);
  for (const array of Object.values(packed)) buffers.push(array.buffer);
  return packed;
}

/** @param {[number, number][]} list */
function pairs(list) {
  const packed = new Float32Array(2 * list.length);
  for (let k = 0; k < list.length; k++) {
    packed[2 * k] = list[k][0];
    packed[2 * k + 1] = list[k][1];
  }
  return packed;
}
