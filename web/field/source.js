/**
 * The fields of a job, fetched as they are looked at. Where those of all steps can be kept, every
 * step is fetched whole, once. Else one step is kept, of it the arrays that something on the page
 * is made of, and its room is given back before that of another is taken: a step on a fine mesh is
 * tens of megabytes.
 */

import { SCALARS } from '../api/npz.js';
import { fetchFields } from '../api/result.js';

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {import('../types.js').Scalar} Scalar */
/** @typedef {{upper: Mesh | null, lower: Mesh | null}} Fields */
/** @typedef {{fields?: Fields, last: Promise<unknown>, stop: AbortController}} Kept `last`: what was asked for last */

/** Most bytes of the fields of all steps that are kept. */
const KEPT = 24e6;
/** Arrays without which there is no picture. */
const SHAPE = ['nodes', 'elements', 'displacement'];
/** Bytes of a node: two pairs, a number of each scalar, and the four corners of an element. */
const PER_NODE = 4 * (4 + SCALARS.length + 4);

export class FieldSource {
  /** By step. @type {Map<number, Kept>} */
  #steps = new Map();

  /** @param {string} id of a job @param {import('../types.js').Report} report */
  constructor(id, { steps, mesh }) {
    this.id = id;
    /** Whether every step is kept. */
    this.whole = steps.length * mesh.nodes * PER_NODE < KEPT;
  }

  /** @param {number} step counted from 0 @param {Scalar[]} [names] @returns {Fields | undefined} if all of these are here */
  peek(step, names = []) {
    const fields = this.#steps.get(step)?.fields;
    return fields && missing(fields, names).length === 0 ? fields : undefined;
  }

  /**
   * @param {number} step counted from 0
   * @param {Scalar[]} names
   * @param {(received: number, total: number) => void} [progress] in bytes
   * @returns {Promise<Fields>} with these scalars at least
   */
  get(step, names, progress) {
    if (!this.whole) for (const other of this.#steps.keys()) if (other !== step) this.#drop(other);
    const kept = this.#steps.get(step) ?? { last: Promise.resolve(), stop: new AbortController() };
    this.#steps.set(step, kept);
    // One after the other: what comes for one may be what the next one wants.
    const next = kept.last
      .catch(() => {})
      .then(() => this.#fetch(step, kept, this.whole ? SCALARS : names, progress));
    kept.last = next;
    return next;
  }

  /** @param {number} step @param {Kept} kept @param {Scalar[]} names @param {(received: number, total: number) => void} [progress] */
  async #fetch(step, kept, names, progress) {
    const { signal } = kept.stop;
    signal.throwIfAborted();
    const wanted = kept.fields ? missing(kept.fields, names) : [...SHAPE, ...names];
    if (kept.fields && wanted.length === 0) return kept.fields;
    const came = /** @type {Fields} */ (
      await fetchFields(this.id, step, wanted, { signal, progress })
    );
    if (signal.aborted) free(came);
    signal.throwIfAborted();
    if (!kept.fields) kept.fields = came;
    else for (const body of BODIES) Object.assign(kept.fields[body] ?? {}, came[body]);
    return kept.fields;
  }

  /** @param {number} step */
  #drop(step) {
    const kept = this.#steps.get(step);
    kept?.stop.abort();
    if (kept?.fields) free(kept.fields);
    this.#steps.delete(step);
  }

  /** Gives everything back, when another job is looked at. */
  close() {
    for (const step of this.#steps.keys()) this.#drop(step);
  }
}

const BODIES = /** @type {const} */ (['upper', 'lower']);

/** @param {Fields} fields @param {Scalar[]} names @returns {Scalar[]} those of them that are not in every body */
const missing = (fields, names) =>
  names.filter((name) => BODIES.some((body) => fields[body] && !fields[body][name]));

/**
 * Gives back the room of arrays at once, where a collector lets hundreds of megabytes pass before
 * it looks for some: they are sent to where nobody takes them.
 * @param {Fields} fields
 */
function free(fields) {
  const arrays = BODIES.flatMap((body) => Object.values(fields[body] ?? {}));
  const { port1, port2 } = new MessageChannel();
  port2.close();
  port1.postMessage(
    null,
    arrays.map(({ buffer }) => /** @type {ArrayBuffer} */ (buffer)),
  );
  port1.close();
}
